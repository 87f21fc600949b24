//! Reading the instances that a theorem is tried on.

use super::reader::Reader;
use crate::claim::{Rewriting, Trial};
use crate::diagnostic::Diagnostic;
use crate::exact::{Rational, parse_rational, within};
use crate::scheme::{Spanned, formula, identifier};
use serde::Deserialize;
use std::collections::BTreeMap;

/// The most instances, combinations of a scheme and values, that a theorem is tried on.
const MAX_TRIALS: usize = 256;

/// The greatest offset, in absolute value.
const MAX_OFFSET: i64 = 10_000;

/// `supposes = { value = 'T', below = '1' }`.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct SupposesTable {
    /// A formula.
    value: Spanned<String>,
    /// What it is less than.
    below: Spanned<String>,
}

/// `corrections = [{ of = "GH", says = "…", value = '…' }]`.
#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct RewritingTable {
    /// The name that gets another formula.
    of: Spanned<String>,
    /// The correction in words.
    says: String,
    /// The other formula.
    value: Spanned<String>,
}

/// The fields of a theorem's TOML table that say what it is tried on.
#[derive(Clone, Copy)]
pub(super) struct TrialFields<'t> {
    /// The scheme that the theorem is about, when it is about one.
    pub(super) scheme: Option<&'t Spanned<String>>,
    pub(super) schemes: &'t [Spanned<String>],
    pub(super) values: &'t BTreeMap<Spanned<String>, Vec<Spanned<String>>>,
    pub(super) offset: Option<&'t Spanned<String>>,
    pub(super) parameters: Option<&'t Spanned<String>>,
    pub(super) interpolant: Option<&'t Spanned<String>>,
    pub(super) block: Option<&'t Spanned<String>>,
    pub(super) supposes: Option<&'t SupposesTable>,
    pub(super) corrections: &'t [RewritingTable],
}

impl Reader<'_> {
    pub(super) fn trial(&self, table: TrialFields<'_>) -> Result<Trial, Diagnostic> {
        if let (Some(_), Some(second)) = (table.scheme, table.schemes.first()) {
            return Err(self
                .error(second.span(), "this theorem is about the scheme that `scheme` names")
                .with_help("`schemes` is for a theorem about every scheme; take one of the two"));
        }
        let schemes: Vec<_> =
            table.schemes.iter().map(|text| self.located(text)).collect::<Result<_, _>>()?;
        let mut values = Vec::new();
        let mut trials = schemes.len().max(1);
        for (name, texts) in table.values {
            let value = |text: &Spanned<String>| {
                parse_rational(text.get_ref())
                    .map_err(|error| self.error(text.span(), error.to_string()))
            };
            let of_name: Vec<Rational> = texts.iter().map(value).collect::<Result<_, _>>()?;
            trials = trials.saturating_mul(of_name.len());
            if of_name.is_empty() || trials > MAX_TRIALS {
                let message =
                    format!("a theorem is tried on 1 to {MAX_TRIALS} combinations of values");
                return Err(self.error(name.span(), message));
            }
            values.push((identifier(self.source, name)?, of_name));
        }
        let rewriting = |table: &RewritingTable| {
            Ok(Rewriting {
                of: identifier(self.source, &table.of)?,
                says: table.says.clone(),
                value: formula(self.source, &table.value)?,
            })
        };
        let supposes = match table.supposes {
            None => None,
            Some(SupposesTable { value, below }) => {
                Some((formula(self.source, value)?, formula(self.source, below)?))
            }
        };
        let natural = match table.parameters {
            None => false,
            Some(text) => self.is_natural(text)?,
        };
        if let (true, Some(other)) = (natural, table.offset.or(table.interpolant)) {
            return Err(self
                .error(other.span(), "this says where points are, and so does `parameters`")
                .with_help(
                    "at natural parameters every point of a line stays on it; take one of the two",
                ));
        }
        Ok(Trial {
            schemes,
            values,
            natural,
            offset: table.offset.map(|text| self.offset(text)).transpose()?,
            interpolant: table.interpolant.map(|text| self.located(text)).transpose()?,
            block: self.optional(table.block)?,
            rewritings: table
                .corrections
                .iter()
                .map(rewriting)
                .collect::<Result<_, Diagnostic>>()?,
            supposes,
        })
    }

    fn is_natural(&self, text: &Spanned<String>) -> Result<bool, Diagnostic> {
        match text.get_ref().as_str() {
            "natural" => Ok(true),
            "indexed" => Ok(false),
            other => Err(self
                .error(text.span(), format!("`{other}` names no parameters"))
                .with_help("write 'natural', or 'indexed' for the points of level k at i/n^k")),
        }
    }

    fn offset(&self, text: &Spanned<String>) -> Result<i64, Diagnostic> {
        let offset = text.get_ref().parse().ok().and_then(|offset| within(offset, MAX_OFFSET));
        offset.ok_or_else(|| {
            self.error(text.span(), format!("`{}` is not an offset", text.get_ref())).with_help(
                "the index offset o of x_{ni+α} = Σ a x_{i+o+j} is an integer, 0 where a paper \
                 writes its masks from index i",
            )
        })
    }
}
