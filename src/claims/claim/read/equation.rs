//! Reading equations.

use super::axis::AxisTable;
use super::fields::{claim_table, one_or_each, spanned};
use super::kind::{ClaimTable, Named, Role, named};
use super::reader::{Head, Reader};
use crate::claim::{
    Comparison, Equation, EquationBody, Hypothesis, Identity, Index, Left, LocatedReference, Paper,
};
use crate::diagnostic::Diagnostic;
use crate::formula::{LocatedFormula, Node};
use crate::scheme::{Spanned, formula, identifier};
use serde::Deserialize;

claim_table!(EquationTable {
    /// Names that stay symbolic; `q` may be a family such as `q[2*i-1]`.
    #[serde(default)]
    pub(super) symbols: Vec<Spanned<String>>,
    /// What the paper presupposes, as linear equations.
    #[serde(default)]
    hypotheses: Vec<Spanned<String>>,
    /// The indices of the cases.
    #[serde(default)]
    pub(super) indices: Vec<Spanned<AxisTable>>,
    /// The left side: one formula for all cases, or one for each.
    left: Option<Spanned<LeftField>>,
    /// The right side.
    right: Option<Spanned<String>>,
    /// In place of both sides: what the paper lacks that the equation would need.
    absent: Option<String>,
});

impl ClaimTable for EquationTable {
    fn names(&self) -> Vec<(&str, Named)> {
        let indices = self.indices.iter().filter_map(|axis| axis.get_ref().name.as_ref());
        named(&self.symbols, Role::Symbol).chain(named(indices, Role::Index)).collect()
    }

    fn takes_given(&self) -> bool {
        false
    }

    fn read(&self, reader: &Reader<'_>, paper: &mut Paper) -> Result<(), Diagnostic> {
        paper.equations.push(reader.equation(self)?);
        Ok(())
    }
}

one_or_each!(
    /// One formula for all combinations of the indices, or one for each.
    LeftField,
    "a formula in quotes, or a list of them"
);

impl Reader<'_> {
    pub(super) fn equation(&self, table: &EquationTable) -> Result<Equation, Diagnostic> {
        let Head { id, locus, title, scheme, note } = self.head(table.common())?;
        let body = match (&table.left, &table.right, &table.absent) {
            (Some(left), Some(right), None) => {
                EquationBody::Identity(Box::new(self.identity(table, scheme, left, right)?))
            }
            (None, None, Some(absent)) => EquationBody::NotCheckable(absent.clone()),
            _ => {
                return Err(self
                    .error(table.id.span(), "an equation needs `left` and `right`, or `absent`")
                    .with_help(
                        "left = ['3/4', '1/4'] lists the left sides, right = 'mask(0, r)' is one \
                         formula in the indices; absent = \"…\" says what the paper lacks",
                    ));
            }
        };
        Ok(Equation { is_relation: false, id, locus, title, body, note })
    }

    fn identity(
        &self,
        table: &EquationTable,
        scheme: Option<LocatedReference>,
        left: &Spanned<LeftField>,
        right: &Spanned<String>,
    ) -> Result<Identity, Diagnostic> {
        let indices = table.indices.iter().map(|axis| self.index(axis));
        let indices = indices.collect::<Result<Vec<Index>, Diagnostic>>()?;
        let left = self.left(left, &indices)?;
        let comparisons = vec![Comparison::equal(left, formula(self.source, right)?)];
        let (symbols, hypotheses) = self.presupposed(&table.symbols, &table.hypotheses)?;
        Ok(Identity {
            scheme,
            symbols,
            hypotheses,
            indices,
            comparisons,
            states: None,
            only: false,
        })
    }

    /// The symbols and the hypotheses of a claim.
    pub(super) fn presupposed(
        &self,
        symbols: &[Spanned<String>],
        hypotheses: &[Spanned<String>],
    ) -> Result<(Vec<String>, Vec<Hypothesis>), Diagnostic> {
        let symbols = symbols.iter().map(|symbol| identifier(self.source, symbol));
        let hypotheses = hypotheses.iter().map(|text| self.hypothesis(text));
        Ok((symbols.collect::<Result<_, _>>()?, hypotheses.collect::<Result<_, _>>()?))
    }

    fn left(&self, left: &Spanned<LeftField>, indices: &[Index]) -> Result<Left, Diagnostic> {
        let formulas = match left.get_ref() {
            LeftField::One(text) => {
                return LocatedFormula::read(self.source, left.span(), text).map(Left::One);
            }
            each @ LeftField::Each(_) => spanned(each.texts(left.span())),
        };
        let mut count = 1_usize;
        for index in indices {
            let Index::Listed { values, .. } = index else {
                return Err(self
                    .error(left.span(), "a list of left sides needs indices with `values`")
                    .with_help("write one formula for all combinations"));
            };
            count = count.saturating_mul(values.len());
        }
        if formulas.len() != count {
            let found = formulas.len();
            let message = format!("{found} left sides, and {count} combinations of the indices");
            return Err(self
                .error(left.span(), message)
                .with_help("give one left side for each combination, the first index slowest"));
        }
        let formulas = formulas.iter().map(|text| formula(self.source, text));
        formulas.collect::<Result<_, _>>().map(Left::Each)
    }

    fn hypothesis(&self, text: &Spanned<String>) -> Result<Hypothesis, Diagnostic> {
        let help = "write a member of a family and its value: 'a[0, m] = 1 - a[0, 0]'";
        let refuse = || self.error(text.span(), "this is not a hypothesis").with_help(help);
        let (member, value) = text.get_ref().split_once('=').ok_or_else(refuse)?;
        let read = |part: &str| LocatedFormula::read(self.source, text.span(), part.trim());
        let (member, value) = (read(member)?, read(value)?);
        if matches!(member.expr.node, Node::Indexed { .. }) {
            Ok(Hypothesis { member, value })
        } else {
            Err(refuse())
        }
    }
}
