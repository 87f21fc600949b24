//! Exact values of a table: one formula, or one for each number.

use super::nested::Nested;
use super::reader::Reader;
use crate::diagnostic::Diagnostic;
use crate::formula::LocatedFormula;
use crate::scheme::{Spanned, formula};
use crate::shipped::claim::{Convention, ExactValues};
use std::ops::Range;

/// The fields `equals` and `equals_cells`, of a table at a place of the file.
pub(super) struct ExactFields<'a> {
    pub(super) equals: Option<&'a Spanned<String>>,
    pub(super) each: Option<&'a Spanned<Vec<Spanned<Nested>>>>,
    pub(super) place: Range<usize>,
}

impl Reader<'_> {
    /// The exact values of `count` numbers.
    pub(super) fn exact(
        &self,
        fields: &ExactFields<'_>,
        count: usize,
    ) -> Result<ExactValues, Diagnostic> {
        match (fields.equals, fields.each) {
            (Some(text), None) => formula(self.source, text).map(ExactValues::Formula),
            (None, Some(list)) => {
                let texts = self.texts(list.get_ref())?;
                if texts.len() != count {
                    let found = texts.len();
                    let message = format!("{found} exact values, and {count} numbers");
                    return Err(self
                        .error(list.span(), message)
                        .with_help("give one formula for each number, the last index fastest"));
                }
                let read = |text: &Spanned<&str>| {
                    LocatedFormula::read(self.source, text.span(), text.get_ref())
                };
                texts.iter().map(read).collect::<Result<_, _>>().map(ExactValues::Each)
            }
            _ => Err(self
                .error(fields.place.clone(), "needed is one of `equals` and `equals_cells`")
                .with_help(
                    "equals = '1/n' is one formula in the indices, equals_cells = [\"1/2\", \
                     \"1/3\"] has one for each number",
                )),
        }
    }

    pub(super) fn conventions(
        &self,
        tables: &[super::file::ConventionTable],
        count: usize,
    ) -> Result<Vec<Convention>, Diagnostic> {
        let read = |table: &super::file::ConventionTable| {
            let fields = ExactFields {
                equals: table.equals.as_ref(),
                each: table.equals_cells.as_ref(),
                place: table.label.span(),
            };
            let label = table.label.get_ref().clone();
            Ok(Convention { label, exact: self.exact(&fields, count)? })
        };
        tables.iter().map(read).collect()
    }
}
