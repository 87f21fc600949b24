//! Reading claims about smoothness.

use super::exponent::exponent;
use super::fields::{CommonFields, Formulas, NumberField, claim_table};
use super::kind::{ClaimTable, Named, Role, named};
use super::reader::{Head, Reader};
use crate::claim::{
    ExponentStatement, Paper, PrintedValences, RegularityCell, SmoothnessBody, SmoothnessClaim,
    SmoothnessKind, SmoothnessStatement,
};
use crate::diagnostic::Diagnostic;
use crate::scheme::{Spanned, definitions};
use std::collections::BTreeMap;

/// The greatest m of a C^m.
const MAX_ORDER: usize = 64;

/// The greatest valence that is judged by itself.
const MAX_VALENCE: usize = 100;

claim_table!(SmoothnessTable {
    /// The limits are C^m for this m.
    pub(super) continuous: Option<Spanned<String>>,
    /// Not all limits are C^m for this m.
    pub(super) not_continuous: Option<Spanned<String>>,
    /// Of rules around a vertex or on a face: for which valences, `'5'`, `'3..50'` or `'all'`.
    pub(super) valences: Option<Spanned<String>>,
    /// In place of all but the common fields: what the paper lacks.
    pub(super) absent: Option<String>,
    /// Values of parameters for this claim alone.
    #[serde(default)]
    pub(super) given: Formulas,
    /// The cell of a table that it is.
    #[serde(skip)]
    pub(super) cell: Option<RegularityCell>,
});

claim_table!(ExponentTable {
    /// The exponent: `'6 - log_2(9)'`.
    pub(super) value: Option<Spanned<String>>,
    /// The exponent as a decimal.
    pub(super) printed: Option<Spanned<NumberField>>,
    /// A lower bound, as a formula.
    pub(super) at_least: Option<Spanned<String>>,
    /// An upper bound, as a formula.
    pub(super) at_most: Option<Spanned<String>>,
    /// Whether the paper says that the exponent is attained.
    pub(super) attained: Option<bool>,
    /// In place of all but the common fields: what the paper lacks.
    pub(super) absent: Option<String>,
    /// Values of parameters for this claim alone.
    #[serde(default)]
    pub(super) given: Formulas,
    /// The cell of a table that it is.
    #[serde(skip)]
    pub(super) cell: Option<RegularityCell>,
});

impl ClaimTable for SmoothnessTable {
    fn names(&self) -> Vec<(&str, Named)> {
        named(self.given.keys(), Role::Given).collect()
    }

    fn read(&self, reader: &Reader<'_>, paper: &mut Paper) -> Result<(), Diagnostic> {
        paper.smoothness.push(reader.smoothness(self)?);
        Ok(())
    }
}

impl ClaimTable for ExponentTable {
    fn names(&self) -> Vec<(&str, Named)> {
        named(self.given.keys(), Role::Given).collect()
    }

    fn read(&self, reader: &Reader<'_>, paper: &mut Paper) -> Result<(), Diagnostic> {
        paper.smoothness.push(reader.exponent(self)?);
        Ok(())
    }
}

impl Reader<'_> {
    /// Reads a claim that the limits are C^m, or not.
    pub(super) fn smoothness(
        &self,
        table: &SmoothnessTable,
    ) -> Result<SmoothnessClaim, Diagnostic> {
        let statement = match (&table.continuous, &table.not_continuous, &table.absent) {
            (None, None, Some(absent)) => Err(absent),
            (None, None, None) | (_, _, Some(_)) => {
                return Err(self
                    .error(
                        table.id.span(),
                        "a claim about smoothness needs `continuous` or `not_continuous`, or `absent`",
                    )
                    .with_help(
                        "continuous = '2' says that the limits are C^2, not_continuous = '3' that \
                         not all of them are C^3; absent = \"…\" says what the paper lacks",
                    ));
            }
            (continuous, not_continuous, None) => {
                let order = |text: &Option<Spanned<String>>| {
                    text.as_ref().map(|text| self.order(text)).transpose()
                };
                let (continuous, not_continuous) = (order(continuous)?, order(not_continuous)?);
                if let (Some(m), Some(fails)) = (continuous, not_continuous)
                    && fails <= m
                {
                    let message = format!("limits that are C^{m} are C^{fails} too");
                    return Err(self.error(table.id.span(), message).with_help(
                        "`not_continuous` is greater than `continuous`; a paper that contradicts \
                         itself has two claims",
                    ));
                }
                let valences =
                    table.valences.as_ref().map(|text| self.valences(text)).transpose()?;
                Ok(SmoothnessStatement::Continuity { continuous, not_continuous, valences })
            }
        };
        let claim = self.about_limits(table.common(), SmoothnessKind::Continuity, statement)?;
        self.with_given(claim, &table.given, table.cell.as_ref())
    }

    /// Reads a claim about the Hölder exponent.
    pub(super) fn exponent(&self, table: &ExponentTable) -> Result<SmoothnessClaim, Diagnostic> {
        let ExponentTable { value, printed, at_least, at_most, attained, absent, .. } = table;
        let printed_exponent =
            |text: &Spanned<String>| exponent(self.source, text.span(), text.get_ref());
        let bound =
            |text: &Option<Spanned<String>>| text.as_ref().map(printed_exponent).transpose();
        let exponent = match (value, printed, at_least.as_ref().or(at_most.as_ref()), absent) {
            (Some(value), None, None, None) => {
                Ok(ExponentStatement::Value(printed_exponent(value)?))
            }
            (None, Some(field), None, None) => {
                let printed = self.printed(field)?;
                if printed.decimal.is_fraction() {
                    let message = "a fraction is no rounded decimal";
                    let help = format!("it is an exact value: value = '{}'", printed.text);
                    return Err(self.error(field.span(), message).with_help(help));
                }
                Ok(ExponentStatement::Decimal { text: printed.text, decimal: printed.decimal })
            }
            (None, None, Some(_), None) => Ok(ExponentStatement::Bounds {
                at_least: bound(at_least)?,
                at_most: bound(at_most)?,
            }),
            (None, None, None, Some(absent)) if attained.is_none() => Err(absent),
            _ => {
                return Err(self
                    .error(
                        table.id.span(),
                        "an exponent needs one of `value`, `printed`, bounds and `absent`",
                    )
                    .with_help(
                        "value = '6 - log_2(9)' is a formula, printed = '2.830' a rounded decimal; \
                         at_least = '2' and at_most = '3' are bounds, of which one will do; absent \
                         = \"…\" says what the paper lacks",
                    ));
            }
        };
        let attained = *attained;
        let statement =
            exponent.map(|exponent| SmoothnessStatement::Exponent { exponent, attained });
        let claim = self.about_limits(table.common(), SmoothnessKind::Exponent, statement)?;
        self.with_given(claim, &table.given, table.cell.as_ref())
    }

    /// A claim about the limits of a scheme, or what the paper lacks.
    pub(super) fn about_limits(
        &self,
        common: CommonFields<'_>,
        kind: SmoothnessKind,
        statement: Result<SmoothnessStatement, &String>,
    ) -> Result<SmoothnessClaim, Diagnostic> {
        let Head { id, locus, title, scheme, note } = self.head(common)?;
        let body = match (statement, scheme) {
            (Err(absent), _) => SmoothnessBody::NotCheckable(absent.clone()),
            (Ok(statement), Some(scheme)) => SmoothnessBody::Statement(scheme, Box::new(statement)),
            (Ok(_), None) => {
                return Err(self
                    .error(
                        common.id.span(),
                        "smoothness is that of a scheme, and `scheme` is missing",
                    )
                    .with_help("scheme = \"four-point:w=1/16\""));
            }
        };
        let (given, cell) = (BTreeMap::new(), None);
        Ok(SmoothnessClaim { id, locus, title, kind, body, given, cell, note })
    }

    /// The claim with its own values, and the cell of a table that it is.
    fn with_given(
        &self,
        claim: SmoothnessClaim,
        given: &Formulas,
        cell: Option<&RegularityCell>,
    ) -> Result<SmoothnessClaim, Diagnostic> {
        let locus = cell.map_or(claim.locus, RegularityCell::locus);
        let given = definitions(self.source, given)?;
        Ok(SmoothnessClaim { locus, given, cell: cell.cloned(), ..claim })
    }

    /// The valences of a claim.
    pub(super) fn valences(&self, text: &Spanned<String>) -> Result<PrintedValences, Diagnostic> {
        let printed = text.get_ref();
        let number = |text: &str| {
            let number = text.parse().ok();
            number.filter(|n: &usize| (3..=MAX_VALENCE).contains(n) && n.to_string() == text)
        };
        let ends = match (printed.as_str(), printed.split_once("..")) {
            ("all", _) => Some((3, None)),
            (one, None) => number(one).map(|n| (n, Some(n))),
            (_, Some((first, last))) => number(first)
                .zip(number(last))
                .filter(|(first, last)| first <= last)
                .map(|(first, last)| (first, Some(last))),
        };
        let (first, last) = ends.ok_or_else(|| {
            self.error(text.span(), format!("`{printed}` does not name valences")).with_help(format!(
                "write '5', '3..50', or 'all' for all from 3 on; others are at most {MAX_VALENCE}"
            ))
        })?;
        Ok(PrintedValences { text: printed.clone(), first, last })
    }

    /// m of C^m.
    pub(super) fn order(&self, text: &Spanned<String>) -> Result<usize, Diagnostic> {
        let order = text.get_ref().parse().ok();
        let order = order.filter(|m: &usize| *m <= MAX_ORDER && m.to_string() == *text.get_ref());
        order.ok_or_else(|| {
            let message = format!("`{}` is not an order of smoothness", text.get_ref());
            self.error(text.span(), message)
                .with_help(format!("write '2' for C^2; m is at most {MAX_ORDER}"))
        })
    }
}
