//! Reading headers and indices.

use super::fields::{NumberField, SchemeField};
use super::reader::Reader;
use crate::claim::{Axis, AxisEntry, Headers, Index, LocatedReference};
use crate::diagnostic::Diagnostic;
use crate::exact::{Rational, parse_rational};
use crate::scheme::{Spanned, formula, identifier};
use serde::Deserialize;
use std::collections::BTreeSet;

#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(
    deny_unknown_fields,
    expecting = "headers such as { name = \"c\", values = ['1', '2'] } or { schemes = [\"chaikin\"] }"
)]
pub(super) struct AxisTable {
    /// The name that has these values in formulas.
    pub(super) name: Option<Spanned<String>>,
    /// What reports call these headers.
    label: Option<String>,
    /// The values, as printed.
    pub(super) values: Option<Spanned<Vec<Spanned<NumberField>>>>,
    /// Schemes in place of values.
    pub(super) schemes: Option<Spanned<Vec<Spanned<SchemeField>>>>,
    /// The first value of an index, a formula.
    from: Option<Spanned<String>>,
    /// The last value of an index, a formula.
    to: Option<Spanned<String>>,
}

/// A listed value with its header.
type Number = (AxisEntry, Rational);

/// The label of headers that are schemes, where the claim file gives none.
const SCHEMES: &str = "scheme";

/// How headers are written.
const HELP: &str = "{ name = \"c\", values = ['1', '2'] }, where c has these values in formulas, or \
                    { schemes = [\"chaikin\", \"four-point:w=1/16\"] }";

impl Reader<'_> {
    pub(super) fn axis(&self, table: &Spanned<AxisTable>) -> Result<Axis, Diagnostic> {
        let axis = table.get_ref();
        match axis {
            AxisTable { values: Some(_), schemes: None, from: None, to: None, .. } => {
                let (name, label, values) = self.values(table)?;
                let (entries, values) = values.into_iter().unzip();
                Ok(Axis { label, entries, headers: Headers::Values { name, values } })
            }
            AxisTable { values: None, schemes: Some(schemes), from: None, to: None, .. } => {
                if let Some(name) = &axis.name {
                    return Err(self
                        .error(name.span(), "headers that are schemes have no name in formulas")
                        .with_help(
                            "leave `name` out: the functions of a cell are about its scheme; \
                             `label` is what reports call these headers",
                        ));
                }
                let label = axis.label.clone().unwrap_or_else(|| SCHEMES.to_owned());
                let (entries, schemes) = self.scheme_headers(schemes)?.into_iter().unzip();
                Ok(Axis { label, entries, headers: Headers::Schemes(schemes) })
            }
            _ => Err(self
                .error(table.span(), "headers are given either by `values` or by `schemes`")
                .with_help(HELP)),
        }
    }

    /// The name, the label, and the listed values of a parameter.
    fn values(
        &self,
        table: &Spanned<AxisTable>,
    ) -> Result<(String, String, Vec<Number>), Diagnostic> {
        let AxisTable { label, values, .. } = table.get_ref();
        let name = self.name(table)?;
        let fields = values.as_ref().filter(|fields| !fields.get_ref().is_empty());
        let Some(fields) = fields else {
            let span = values.as_ref().map_or(table.span(), Spanned::span);
            return Err(self.error(span, "at least one header is needed"));
        };
        let entry = |field: &Spanned<NumberField>| {
            let NumberField { printed, read, note } = field.get_ref();
            let text = read.as_ref().unwrap_or(printed);
            let value = parse_rational(text).map_err(|error| self.damaged(field, &error))?;
            let entry =
                AxisEntry { printed: printed.clone(), read: read.clone(), note: note.clone() };
            Ok((entry, value))
        };
        let values = fields.get_ref().iter().map(entry).collect::<Result<_, Diagnostic>>()?;
        Ok((name.clone(), label.clone().unwrap_or(name), values))
    }

    fn scheme_headers(
        &self,
        fields: &Spanned<Vec<Spanned<SchemeField>>>,
    ) -> Result<Vec<(AxisEntry, LocatedReference)>, Diagnostic> {
        if fields.get_ref().is_empty() {
            return Err(self.error(fields.span(), "at least one header is needed"));
        }
        let entry = |field: &Spanned<SchemeField>| {
            let SchemeField { printed, scheme, note } = field.get_ref();
            let scheme = match scheme {
                Some(text) => self.located(text)?,
                None => self.located(&Spanned::new(field.span(), printed.clone()))?,
            };
            Ok((AxisEntry { printed: printed.clone(), read: None, note: note.clone() }, scheme))
        };
        fields.get_ref().iter().map(entry).collect()
    }

    fn name(&self, table: &Spanned<AxisTable>) -> Result<String, Diagnostic> {
        let Some(name) = &table.get_ref().name else {
            return Err(self
                .error(table.span(), "numbers need the `name` that has these values in formulas")
                .with_help("{ name = \"c\", values = ['1', '2'] }"));
        };
        identifier(self.source, name)
    }

    pub(super) fn index(&self, table: &Spanned<AxisTable>) -> Result<Index, Diagnostic> {
        let AxisTable { label, values, schemes, from, to, .. } = table.get_ref();
        match (values, schemes, from, to) {
            (Some(values), None, None, None) => {
                let (name, label, found) = self.values(table)?;
                let mut seen = BTreeSet::new();
                for ((entry, value), field) in found.iter().zip(values.get_ref()) {
                    if !seen.insert(value) {
                        let message = format!("the value {} stands here twice", entry.printed);
                        return Err(self
                            .error(field.span(), message)
                            .with_help("an index has each of its values once"));
                    }
                }
                let values = found.into_iter().map(|(entry, value)| (value, entry.printed));
                Ok(Index::Listed { name, label, values: values.collect() })
            }
            (None, None, Some(from), Some(to)) => {
                let name = self.name(table)?;
                Ok(Index::Range {
                    label: label.clone().unwrap_or_else(|| name.clone()),
                    name,
                    from: Box::new(formula(self.source, from)?),
                    to: Box::new(formula(self.source, to)?),
                })
            }
            _ => Err(self
                .error(table.span(), "an index needs either `values`, or `from` and `to`")
                .with_help("{ name = \"i\", from = '2', to = 'N - 1' }")),
        }
    }
}
