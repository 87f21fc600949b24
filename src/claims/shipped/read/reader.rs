//! What all parts of reading need: the file, and errors at places of it.

use crate::diagnostic::{Diagnostic, SourceText};
use std::ops::Range;
use std::sync::Arc;

/// The most numbers of a table that are described.
pub const MAX_DESCRIBED: usize = 20_000;

/// Reads parts of a claim file.
pub(super) struct Reader<'a> {
    pub(super) source: &'a Arc<SourceText>,
}

impl Reader<'_> {
    pub(super) fn error(&self, span: Range<usize>, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(self.source, span, message)
    }
}
