//! Reading the claims about a free parameter.

use super::fields::{NumberField, claim_table, one_or_each, spanned};
use super::kind::{ClaimTable, Named, Role, named};
use super::reader::{Head, Reader};
use crate::claim::{
    Domain, FunctionClaim, Limit, Paper, RangeClaim, RangeEnd, SmoothRangeStatement,
    SmoothRegionStatement, SmoothnessClaim, SmoothnessKind, SmoothnessStatement,
};
use crate::diagnostic::Diagnostic;
use crate::exact::{Decimal, RealAlgebraic, RealCyclotomic, parse_decimal};
use crate::formula::{LocatedFormula, Parameters, evaluate};
use crate::scheme::{Spanned, formula, identifier};
use serde::Deserialize;
use std::ops::Range;

claim_table!(FunctionTable {
    /// The free parameter.
    variable: Spanned<String>,
    /// The printed closed form.
    left: Spanned<String>,
    /// What it is said to equal.
    right: Spanned<String>,
    /// The printed lower end of the values for which it is said to.
    from: Option<Spanned<NumberField>>,
    /// The printed upper end.
    to: Option<Spanned<NumberField>>,
    /// Whether the ends belong to these values.
    closed: Option<Spanned<bool>>,
});

one_or_each!(
    /// An inequality, or a list of them.
    WhereField,
    "an inequality such as 'abs(a) + abs(b) < 1/2', or a list of them"
);

claim_table!(RangeTable {
    /// The free parameter.
    variable: Option<Spanned<String>>,
    /// In place of `variable`: the names of two parameters, with `where`.
    variables: Option<Spanned<Vec<Spanned<String>>>>,
    /// The values of two parameters: `'a + b < 1/2'`, or a list of such inequalities, which all hold.
    r#where: Option<Spanned<WhereField>>,
    /// The value that is limited.
    value: Option<Spanned<String>>,
    /// In place of `value`: m, where the limits are C^m.
    smoothness: Option<Spanned<String>>,
    /// The value is less than this.
    below: Option<Spanned<String>>,
    /// The value is this at most.
    at_most: Option<Spanned<String>>,
    /// The printed lower end.
    from: Option<Spanned<NumberField>>,
    /// The printed upper end.
    to: Option<Spanned<NumberField>>,
    /// Whether the ends belong to the range.
    closed: Option<Spanned<bool>>,
    /// Whether the paper says that the limits are C^m for no other values.
    only: Option<Spanned<bool>>,
    /// Of rules around a vertex or on a face: for which valences, `'5'`, `'3..50'` or `'all'`.
    valences: Option<Spanned<String>>,
});

/// How a region of two parameters is written.
const VARIABLES: &str = "write variable = \"w\" with from = '0', to = '1/8'; or variables = [\"a\", \"b\"] with smoothness = '1' and \
                         where = ['abs(a) + abs(b) < 1/2', 'a > 0']";

impl ClaimTable for FunctionTable {
    fn names(&self) -> Vec<(&str, Named)> {
        named([&self.variable], Role::Variable).collect()
    }

    fn read(&self, reader: &Reader<'_>, paper: &mut Paper) -> Result<(), Diagnostic> {
        paper.functions.push(reader.function(self)?);
        Ok(())
    }
}

impl ClaimTable for RangeTable {
    fn names(&self) -> Vec<(&str, Named)> {
        let both = self.variables.as_ref().map_or(&[][..], |both| both.get_ref());
        named(self.variable.iter().chain(both), Role::Variable).collect()
    }

    fn read(&self, reader: &Reader<'_>, paper: &mut Paper) -> Result<(), Diagnostic> {
        if let Some(variables) = &self.variables {
            paper.smoothness.push(reader.smooth_region(self, variables)?);
            return Ok(());
        }
        match (&self.value, &self.smoothness) {
            (Some(value), None) => paper.ranges.push(reader.value_range(self, value)?),
            (None, Some(m)) => paper.smoothness.push(reader.smooth_range(self, m)?),
            _ => {
                return Err(reader
                    .error(self.id.span(), "a range needs either `value` or `smoothness`")
                    .with_help(
                        "value = 'contraction(1)' with below = '1' is where a value is limited, \
                         smoothness = '2' is where the limits are C^2",
                    ));
            }
        }
        Ok(())
    }
}

impl Reader<'_> {
    fn function(&self, table: &FunctionTable) -> Result<FunctionClaim, Diagnostic> {
        let Head { id, locus, title, scheme, note } = self.head(table.common())?;
        let variable = identifier(self.source, &table.variable)?;
        let left = formula(self.source, &table.left)?;
        let right = formula(self.source, &table.right)?;
        let domain = self.domain([&table.from, &table.to], table.closed.as_ref())?;
        if domain.from.is_none()
            && domain.to.is_none()
            && let Some(closed) = &table.closed
        {
            return Err(self
                .error(
                    closed.span(),
                    "`closed` is about the ends of an interval, and there are none",
                )
                .with_help(format!(
                    "add `from`, `to` or both: the printed ends of the values of `{variable}`; \
                     or remove `closed`"
                )));
        }
        Ok(FunctionClaim { id, locus, title, variable, scheme, left, right, domain, note })
    }

    /// The range of a parameter for which the limits are C^m.
    fn smooth_range(
        &self,
        table: &RangeTable,
        m: &Spanned<String>,
    ) -> Result<SmoothnessClaim, Diagnostic> {
        if let Some(limit) = table.below.as_ref().or(table.at_most.as_ref()) {
            return Err(self
                .error(limit.span(), "the limits of a `value` have no place beside `smoothness`")
                .with_help(
                    "remove `below` and `at_most`, or say `value` in place of `smoothness`",
                ));
        }
        if table.from.is_none() && table.to.is_none() {
            return Err(self.no_ends(table));
        }
        let statement = SmoothRangeStatement {
            variable: self.variable(table)?,
            m: self.order(m)?,
            domain: self.domain([&table.from, &table.to], table.closed.as_ref())?,
            only: table.only.as_ref().is_some_and(|only| *only.get_ref()),
            valences: table.valences.as_ref().map(|text| self.valences(text)).transpose()?,
        };
        let statement = Ok(SmoothnessStatement::Range(Box::new(statement)));
        self.about_limits(table.common(), SmoothnessKind::Range, statement)
    }

    /// The one parameter of a range.
    fn variable(&self, table: &RangeTable) -> Result<String, Diagnostic> {
        let needs =
            |span: Range<usize>, message: &str| self.error(span, message).with_help(VARIABLES);
        if let Some(inequalities) = &table.r#where {
            return Err(needs(inequalities.span(), "`where` is about two parameters"));
        }
        let variable = table.variable.as_ref();
        let variable =
            variable.ok_or_else(|| needs(table.id.span(), "a range needs its `variable`"))?;
        identifier(self.source, variable)
    }

    /// The region of two parameters for which the limits are C^m.
    fn smooth_region(
        &self,
        table: &RangeTable,
        variables: &Spanned<Vec<Spanned<String>>>,
    ) -> Result<SmoothnessClaim, Diagnostic> {
        let refused =
            |span: Range<usize>, message: &str| Err(self.error(span, message).with_help(VARIABLES));
        let [first, second] = &variables.get_ref()[..] else {
            return refused(variables.span(), "a region has two parameters");
        };
        if first.get_ref() == second.get_ref() {
            return refused(second.span(), "the two parameters have one name");
        }
        let others = [&table.value, &table.below, &table.at_most, &table.valences, &table.variable];
        let others = others.into_iter().flatten().map(Spanned::span);
        let ends = [&table.from, &table.to].into_iter().flatten().map(Spanned::span);
        if let Some(span) =
            others.chain(ends).chain(table.closed.as_ref().map(Spanned::span)).next()
        {
            return refused(span, "this field has no place beside `variables`");
        }
        let (Some(m), Some(inequalities)) = (&table.smoothness, &table.r#where) else {
            return refused(table.id.span(), "a region needs `smoothness` and `where`");
        };
        let texts = spanned(inequalities.get_ref().texts(inequalities.span()));
        let mut comparisons = Vec::new();
        for text in &texts {
            comparisons.extend(self.inequalities(text)?);
        }
        if comparisons.is_empty() {
            return refused(inequalities.span(), "no inequality bounds the region");
        }
        let statement = SmoothRegionStatement {
            variables: [identifier(self.source, first)?, identifier(self.source, second)?],
            m: self.order(m)?,
            texts: texts.into_iter().map(Spanned::into_inner).collect(),
            inequalities: comparisons,
            only: table.only.as_ref().is_some_and(|only| *only.get_ref()),
        };
        let statement = Ok(SmoothnessStatement::Region(Box::new(statement)));
        self.about_limits(table.common(), SmoothnessKind::Range, statement)
    }

    /// An interval of a free parameter, from its ends.
    fn domain(
        &self,
        ends: [&Option<Spanned<NumberField>>; 2],
        closed: Option<&Spanned<bool>>,
    ) -> Result<Domain, Diagnostic> {
        let [from, to] =
            ends.map(|end| end.as_ref().map(|field| self.range_end(field)).transpose());
        let (from, to) = (from?, to?);
        if let (Some(from), Some(to)) = (&from, &to)
            && from.value >= to.value
        {
            return Err(self.ends_exchanged(&to.text, to.span.clone()));
        }
        Ok(Domain { from, to, closed: closed.is_some_and(|closed| *closed.get_ref()) })
    }

    /// An end that is printed as a decimal or as a closed formula.
    fn range_end(&self, field: &Spanned<NumberField>) -> Result<RangeEnd, Diagnostic> {
        let NumberField { printed, read, .. } = field.get_ref();
        let text = read.as_ref().unwrap_or(printed);
        let (decimal, value) = self.place_of(text, field.span())?;
        Ok(RangeEnd { text: printed.clone(), decimal, value, span: field.span() })
    }

    /// The value of a decimal, or of a closed formula.
    pub(super) fn place_of(
        &self,
        text: &str,
        span: Range<usize>,
    ) -> Result<(Option<Decimal>, RealAlgebraic), Diagnostic> {
        Ok(if let Ok(decimal) = parse_decimal(text) {
            let value = RealAlgebraic::from(decimal.value());
            (Some(decimal), value)
        } else {
            let formula = LocatedFormula::read(self.source, span.clone(), text)?;
            let value = evaluate(&formula.expr, &Parameters::<RealCyclotomic>::default())
                .map_err(|error| formula.diagnostic(&error))?;
            let value = RealAlgebraic::of_cyclotomic(&value).ok_or_else(|| {
                let message = "cosines of these angles are too complicated for an end of a range";
                let most = RealAlgebraic::MAX_CONDUCTOR;
                self.error(span.clone(), message).with_help(format!(
                    "cosines of multiples of 2*pi/n may stand here for n up to {most}; other ends are \
                     decimals"
                ))
            })?;
            (None, value)
        })
    }

    fn no_ends(&self, table: &RangeTable) -> Diagnostic {
        self.error(table.id.span(), "a range needs its printed ends")
            .with_help("from = '0.1679', to = '0.6666'; one of them for a half line")
    }

    fn ends_exchanged(&self, to: &str, span: Range<usize>) -> Diagnostic {
        self.error(span, format!("the upper end {to} is not above the lower one"))
            .with_help("`from` is the lower end, `to` the upper one")
    }

    /// The range of a parameter in which a value is limited.
    fn value_range(
        &self,
        table: &RangeTable,
        value: &Spanned<String>,
    ) -> Result<RangeClaim, Diagnostic> {
        if let Some(only) = &table.only {
            return Err(self
                .error(only.span(), "`only` has a meaning beside `smoothness` alone")
                .with_help("a range of a `value` is always the exact one: remove `only`"));
        }
        if let Some(valences) = &table.valences {
            return Err(self
                .error(valences.span(), "`valences` have a meaning beside `smoothness` alone")
                .with_help("the value of a formula is that of a mask: remove `valences`"));
        }
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
            (None, None) => return Err(self.no_ends(table)),
            (Some(from), Some(to)) if from.decimal.value() >= to.decimal.value() => {
                return Err(self.ends_exchanged(&to.text, to.span.clone()));
            }
            _ => {}
        }
        let Head { id, locus, title, scheme, note } = self.head(table.common())?;
        let variable = self.variable(table)?;
        let value = formula(self.source, value)?;
        let closed = table.closed.as_ref().map(|closed| *closed.get_ref());
        Ok(RangeClaim { id, locus, title, variable, scheme, value, limit, from, to, closed, note })
    }
}
