//! What all parts of reading need: the file, and errors at places of it.

use super::nested::{Nested, flattened, uneven};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::scheme::Spanned;
use std::ops::Range;
use std::sync::Arc;

/// The most numbers of a table that are described.
pub const MAX_DESCRIBED: usize = 20_000;

/// Reads parts of a claim file.
pub(super) struct Reader<'a> {
    pub(super) source: &'a Arc<SourceText>,
}

impl Reader<'_> {
    /// The texts of nested lists, of which those beside each other have equally many.
    pub(super) fn texts<'t>(
        &self,
        list: &'t [Spanned<Nested>],
    ) -> Result<Vec<Spanned<&'t str>>, Diagnostic> {
        match uneven(list) {
            None => Ok(flattened(list)),
            Some(span) => Err(self
                .error(span, "this list and the one before it do not have equally many entries")
                .with_help("give one entry for each combination of the indices, in lists of equal lengths or in one list")),
        }
    }

    pub(super) fn error(&self, span: Range<usize>, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(self.source, span, message)
    }
}
