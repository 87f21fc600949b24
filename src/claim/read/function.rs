//! Reading the claims about a free parameter.

use super::fields::{NumberField, claim_table};
use super::reader::{Head, Reader};
use crate::claim::{FunctionClaim, Limit, RangeClaim};
use crate::diagnostic::Diagnostic;
use crate::scheme::{formula, identifier};
use toml::Spanned;

claim_table!(FunctionTable {
    pub(super) variable: Spanned<String>,
    left: Spanned<String>,
    right: Spanned<String>,
});

claim_table!(RangeTable {
    pub(super) variable: Spanned<String>,
    value: Spanned<String>,
    below: Option<Spanned<String>>,
    at_most: Option<Spanned<String>>,
    from: Option<Spanned<NumberField>>,
    to: Option<Spanned<NumberField>>,
    closed: Option<bool>,
});

impl Reader<'_> {
    pub(super) fn function(&self, table: &FunctionTable) -> Result<FunctionClaim, Diagnostic> {
        let Head { id, locus, title, scheme, note } = self.head(table.common())?;
        let variable = identifier(self.source, &table.variable)?;
        let left = formula(self.source, &table.left)?;
        let right = formula(self.source, &table.right)?;
        Ok(FunctionClaim { id, locus, title, variable, scheme, left, right, note })
    }

    pub(super) fn range(&self, table: &RangeTable) -> Result<RangeClaim, Diagnostic> {
        let limit = match (&table.below, &table.at_most) {
            (Some(limit), None) => Limit::Below(formula(self.source, limit)?),
            (None, Some(limit)) => Limit::AtMost(formula(self.source, limit)?),
            _ => {
                return Err(self
                    .error(table.id.span(), "a range needs either `below` or `at_most`")
                    .with_help(
                        "below = '1' is the range where value < 1, at_most = '1' the one where \
                         value <= 1",
                    ));
            }
        };
        let end = |field: &Option<Spanned<NumberField>>| {
            field.as_ref().map(|field| self.printed(field)).transpose()
        };
        let (from, to) = (end(&table.from)?, end(&table.to)?);
        match (&from, &to) {
            (None, None) => {
                return Err(self
                    .error(table.id.span(), "a range needs its printed ends")
                    .with_help("from = '0.1679', to = '0.6666'; one of them for a half line"));
            }
            (Some(from), Some(to)) if from.decimal.value() >= to.decimal.value() => {
                let message = format!("the upper end {} is not above the lower one", to.text);
                return Err(self
                    .error(to.span.clone(), message)
                    .with_help("`from` is the lower end, `to` the upper one"));
            }
            _ => {}
        }
        let Head { id, locus, title, scheme, note } = self.head(table.common())?;
        let variable = identifier(self.source, &table.variable)?;
        let (value, closed) = (formula(self.source, &table.value)?, table.closed);
        Ok(RangeClaim { id, locus, title, variable, scheme, value, limit, from, to, closed, note })
    }
}
