//! Indices of tables: `n = 3..9`.

use super::reader::Reader;
use crate::diagnostic::Diagnostic;
use crate::exact::within;
use crate::scheme::{Spanned, identifier};
use crate::shipped::claim::TableIndex;

/// The greatest absolute value of an index.
const MAX_INDEX: i64 = 1_000_000;

impl Reader<'_> {
    /// The indices of a table. Their names differ from each other.
    pub(super) fn indices(&self, texts: &[Spanned<String>]) -> Result<Vec<TableIndex>, Diagnostic> {
        let mut indices: Vec<TableIndex> = Vec::new();
        for text in texts {
            let index = self.index(text)?;
            if indices.iter().any(|earlier| earlier.name == index.name) {
                let message = format!("two indices are called `{}`", index.name);
                return Err(self.error(text.span(), message).with_help("give each its own name"));
            }
            indices.push(index);
        }
        Ok(indices)
    }

    fn index(&self, text: &Spanned<String>) -> Result<TableIndex, Diagnostic> {
        let refuse = || {
            let message = format!("`{}` is not an index with its range", text.get_ref());
            let help = format!(
                "write 'n = 3..9': n runs from 3 to 9, both included, and within ±{MAX_INDEX}"
            );
            self.error(text.span(), message).with_help(help)
        };
        let (name, range) = text.get_ref().split_once('=').ok_or_else(refuse)?;
        let (from, to) = range.split_once("..").ok_or_else(refuse)?;
        let end = |text: &str| {
            text.trim().parse().ok().and_then(|end| within(end, MAX_INDEX)).ok_or_else(refuse)
        };
        let (from, to) = (end(from)?, end(to)?);
        if to < from {
            return Err(refuse());
        }
        let name = identifier(self.source, &Spanned::new(text.span(), name.trim().to_owned()))?;
        Ok(TableIndex { name, from, to })
    }
}
