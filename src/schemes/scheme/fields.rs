//! Reading TOML, with formulas, their names and their places.

use super::spanned::Spanned;
use crate::diagnostic::{Diagnostic, SourceText};
use crate::formula::{LocatedFormula, PI, is_identifier};
use serde::Deserialize;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{SeqAccess, Visitor};
use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// A mask: lists of formulas, one for each rule, or one text. The mask, each rule and each formula has its place.
#[derive(Debug)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(untagged))]
pub(super) enum MaskTable {
    Rules(Vec<Spanned<Vec<Spanned<String>>>>),
    Text(String),
}

impl<'de> Deserialize<'de> for MaskTable {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<MaskTable, D::Error> {
        struct Either;
        impl<'de> Visitor<'de> for Either {
            type Value = MaskTable;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list of rules, or a mask in quotes such as '[1, 3, 3, 1]/4'")
            }
            fn visit_str<E>(self, text: &str) -> Result<MaskTable, E> {
                Ok(MaskTable::Text(text.to_owned()))
            }
            fn visit_seq<S: SeqAccess<'de>>(self, rules: S) -> Result<MaskTable, S::Error> {
                Vec::deserialize(SeqAccessDeserializer::new(rules)).map(MaskTable::Rules)
            }
        }
        deserializer.deserialize_any(Either)
    }
}

/// Parses a TOML string as a formula.
///
/// # Errors
/// When it is none, with its place in the file.
pub fn formula(
    source: &Arc<SourceText>,
    text: &Spanned<String>,
) -> Result<LocatedFormula, Diagnostic> {
    LocatedFormula::read(source, text.span(), text.get_ref())
}

/// Parses a table of named formulas. Every name must be an identifier.
///
/// # Errors
/// When a name is no identifier, or a text is no formula.
pub fn definitions(
    source: &Arc<SourceText>,
    table: &BTreeMap<Spanned<String>, Spanned<String>>,
) -> Result<BTreeMap<String, LocatedFormula>, Diagnostic> {
    let read = |(name, text): (&Spanned<String>, &Spanned<String>)| {
        Ok((identifier(source, name)?, formula(source, text)?))
    };
    table.iter().map(read).collect()
}

/// Checks that `name` can be used in formulas, and returns it.
///
/// # Errors
/// When it is no identifier, or `pi`.
pub fn identifier(source: &Arc<SourceText>, name: &Spanned<String>) -> Result<String, Diagnostic> {
    if name.get_ref() == PI {
        let message = "`pi` is reserved for the angles inside `cos`";
        return Err(Diagnostic::new(source, name.span(), message));
    }
    if is_identifier(name.get_ref()) {
        return Ok(name.get_ref().clone());
    }
    let message = format!("`{}` cannot be a name in a formula", name.get_ref());
    Err(Diagnostic::new(source, name.span(), message)
        .with_help("use a letter or `_`, then letters, digits and `_`"))
}

/// The formulas of the rules of a mask, as lists of texts.
///
/// # Errors
/// When there is none, or a text is no formula.
pub(super) fn rules(
    source: &Arc<SourceText>,
    whole: Range<usize>,
    rules: &[Spanned<Vec<Spanned<String>>>],
) -> Result<Vec<Vec<LocatedFormula>>, Diagnostic> {
    let empty = |span: Range<usize>| {
        Diagnostic::new(source, span, "a mask needs at least one coefficient in each rule")
            .with_help("write a rule as ['3/4', '1/4']")
    };
    if rules.is_empty() {
        return Err(empty(whole));
    }
    let rule = |row: &Spanned<Vec<Spanned<String>>>| {
        if row.get_ref().is_empty() {
            return Err(empty(row.span()));
        }
        row.get_ref().iter().map(|text| formula(source, text)).collect()
    };
    rules.iter().map(rule).collect()
}
