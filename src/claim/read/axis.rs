//! Reading headers and indices.

use super::fields::NumberField;
use super::reader::Reader;
use crate::claim::{Axis, AxisEntry, Index};
use crate::diagnostic::Diagnostic;
use crate::exact::parse_rational;
use crate::scheme::{formula, identifier};
use serde::Deserialize;
use toml::Spanned;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct AxisTable {
    pub(super) name: Spanned<String>,
    label: Option<String>,
    values: Option<Spanned<Vec<Spanned<NumberField>>>>,
    from: Option<Spanned<String>>,
    to: Option<Spanned<String>>,
}

impl Reader<'_> {
    pub(super) fn axis(&self, table: &AxisTable) -> Result<Axis, Diagnostic> {
        let name = identifier(self.source, &table.name)?;
        let (Some(values), None, None) = (&table.values, &table.from, &table.to) else {
            return Err(self.error(table.name.span(), "headers are given by `values`"));
        };
        if values.get_ref().is_empty() {
            return Err(self.error(values.span(), "at least one header is needed"));
        }
        let entry = |field: &Spanned<NumberField>| {
            let NumberField { printed, read, note } = field.get_ref();
            let text = read.as_ref().unwrap_or(printed);
            let value = parse_rational(text).map_err(|error| self.damaged(field, &error))?;
            Ok(AxisEntry { printed: printed.clone(), value, note: note.clone() })
        };
        Ok(Axis {
            label: table.label.clone().unwrap_or_else(|| name.clone()),
            name,
            entries: values.get_ref().iter().map(entry).collect::<Result<_, Diagnostic>>()?,
        })
    }

    pub(super) fn index(&self, table: &AxisTable) -> Result<Index, Diagnostic> {
        let (Some(from), Some(to), None) = (&table.from, &table.to, &table.values) else {
            if table.from.is_some() || table.to.is_some() {
                return Err(self
                    .error(table.name.span(), "an index needs either `values`, or `from` and `to`")
                    .with_help("{ name = \"i\", from = '2', to = 'N - 1' }"));
            }
            return self.axis(table).map(Index::Listed);
        };
        let name = identifier(self.source, &table.name)?;
        Ok(Index::Range {
            label: table.label.clone().unwrap_or_else(|| name.clone()),
            name,
            from: Box::new(formula(self.source, from)?),
            to: Box::new(formula(self.source, to)?),
        })
    }
}
