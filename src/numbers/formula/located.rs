//! Formulas in files.

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
    /// Its range of bytes in the file, quotes included.
    pub span: Range<usize>,
}

impl LocatedFormula {
    /// Parses the TOML string `text`, which occupies the bytes `span` of `source`.
    ///
    /// # Errors
    /// When `text` is not a formula. The error points at the place in the file.
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

/// `error` as an error in the file. In a string without escapes the error's own bytes are
/// underlined, otherwise the whole string.
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
    Diagnostic::new(source, place, error.kind.to_string()).with_cap(error.kind.cap())
}
