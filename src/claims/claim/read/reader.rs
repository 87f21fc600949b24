//! What the readers of all kinds of claims share.

use super::fields::{CommonFields, NumberField};
use crate::claim::{LocatedReference, Printed};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::{NumberError, is_blank, parse_printed};
use crate::formula::LocatedFormula;
use crate::scheme::{Reference, Spanned, formula};
use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Arc;

/// Reads the parts of a claim file: from TOML tables to claims.
pub(super) struct Reader<'a> {
    pub(super) source: &'a Arc<SourceText>,
    /// The ids of the claims of the file, and those of its theorems.
    pub(super) ids: [BTreeSet<&'a str>; 2],
}

/// What every claim begins with.
pub(super) struct Head {
    pub(super) id: String,
    pub(super) locus: String,
    pub(super) title: String,
    pub(super) scheme: Option<LocatedReference>,
    pub(super) note: Option<String>,
}

/// Whether a text can be the key of a paper or the id of a claim.
#[must_use]
pub fn is_id(text: &str) -> bool {
    let fits = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
    !text.is_empty() && text.chars().all(fits)
}

impl Reader<'_> {
    pub(super) fn error(&self, span: Range<usize>, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(self.source, span, message)
    }

    pub(super) fn id(&self, id: &Spanned<String>) -> Result<(), Diagnostic> {
        if is_id(id.get_ref()) {
            return Ok(());
        }
        Err(self
            .error(id.span(), format!("`{}` cannot be an id", id.get_ref()))
            .with_help("use letters, digits, `-`, `_` and `.`"))
    }

    pub(super) fn head(&self, fields: CommonFields<'_>) -> Result<Head, Diagnostic> {
        Ok(Head {
            id: fields.id.get_ref().clone(),
            locus: fields.locus.get_ref().clone(),
            title: fields.title.to_owned(),
            scheme: fields.scheme.map(|text| self.located(text)).transpose()?,
            note: fields.note.map(str::to_owned),
        })
    }

    pub(super) fn reference(&self, text: &Spanned<String>) -> Result<Reference, Diagnostic> {
        Reference::parse(text.get_ref()).map_err(|error| self.error(text.span(), error.to_string()))
    }

    pub(super) fn located(&self, text: &Spanned<String>) -> Result<LocatedReference, Diagnostic> {
        let (source, span) = (Arc::clone(self.source), text.span());
        Ok(LocatedReference { reference: self.reference(text)?, source, span })
    }

    pub(super) fn optional(
        &self,
        text: Option<&Spanned<String>>,
    ) -> Result<Option<LocatedFormula>, Diagnostic> {
        text.map(|text| formula(self.source, text)).transpose()
    }

    pub(super) fn damaged(&self, field: &Spanned<NumberField>, error: &NumberError) -> Diagnostic {
        self.error(field.span(), error.to_string()).with_help(
            "if the paper's text is damaged here, keep it and say what it means: \
             { printed = \"6.02 - 7\", read = \"6.02e-7\", note = \"why\" }",
        )
    }

    /// Whether nothing is printed in a cell: what it stands for is empty, or dashes.
    pub(super) fn is_blank(&self, field: &Spanned<NumberField>) -> Result<bool, Diagnostic> {
        let NumberField { printed, read, .. } = field.get_ref();
        let blank = is_blank(read.as_ref().unwrap_or(printed));
        if !blank && is_blank(printed) {
            let message = "nothing is printed in this cell, and yet something is read";
            return Err(self
                .error(field.span(), message)
                .with_help("leave `read` out, or write what is printed"));
        }
        Ok(blank)
    }

    /// A printed number: a decimal or a fraction.
    pub(super) fn printed(&self, field: &Spanned<NumberField>) -> Result<Printed, Diagnostic> {
        let NumberField { printed, read, note } = field.get_ref();
        let text = read.as_ref().unwrap_or(printed);
        let decimal = parse_printed(text).map_err(|error| self.damaged(field, &error))?;
        let (text, note) = (printed.clone(), note.clone());
        Ok(Printed { text, decimal, note, span: field.span() })
    }
}
