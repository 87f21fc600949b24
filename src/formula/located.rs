//! A formula that stands in a file.

use super::ast::Expr;
use super::error::FormulaError;
use super::parse::parse;
use crate::diagnostic::{Diagnostic, SourceText};
use std::ops::Range;
use std::sync::Arc;

/// A formula and its place in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LocatedFormula {
    /// The formula.
    pub expr: Expr,
    /// Its text.
    pub text: String,
    /// The file.
    pub source: Arc<SourceText>,
    /// The bytes of the file that it takes, quotes included.
    pub span: Range<usize>,
}

impl LocatedFormula {
    /// Reads the TOML string `text`, which takes the bytes `span` of `source`.
    ///
    /// # Errors
    /// When `text` is not a formula; the error underlines the place in the file.
    pub fn read(
        source: &Arc<SourceText>,
        span: Range<usize>,
        text: &str,
    ) -> Result<LocatedFormula, Diagnostic> {
        let at = |error: &FormulaError| locate(source, &span, text, error);
        let expr = parse(text).map_err(|error| at(&error))?;
        Ok(LocatedFormula { expr, text: text.to_owned(), source: Arc::clone(source), span })
    }

    /// An error in this formula, or in a definition that it names, as an error in
    /// the file.
    #[must_use]
    pub fn diagnostic(&self, error: &FormulaError) -> Diagnostic {
        match &error.definition {
            None => locate(&self.source, &self.span, &self.text, error),
            Some(place) => {
                let message = format!("this definition is needed for `{}`", self.text);
                Diagnostic::clone(place).with_help(message)
            }
        }
    }
}

/// Inside a string without escapes, a byte of the formula is a byte of the file;
/// elsewhere the whole string is underlined.
fn locate(
    source: &Arc<SourceText>,
    span: &Range<usize>,
    text: &str,
    error: &FormulaError,
) -> Diagnostic {
    let raw = source.text.get(span.clone()).unwrap_or_default();
    let escapes = raw.starts_with('"') && raw.contains('\\');
    let place = match raw.find(text).filter(|_| !text.is_empty() && !escapes) {
        Some(quote) => {
            let start = span.start + quote;
            start + error.span.start..start + error.span.end
        }
        None => span.clone(),
    };
    Diagnostic::new(source, place, error.kind.to_string())
}
