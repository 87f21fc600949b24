//! Reading relations.

mod statement;

use super::fields::{claim_table, one_or_each};
use super::kind::{ClaimTable, Named, Role, named};
use super::reader::{Head, Reader};
use crate::claim::{
    Comparison, Equation, EquationBody, Identity, Index, Left, LocatedReference, Paper, Sign,
};
use crate::diagnostic::Diagnostic;
use crate::exact::{Rational, parse_rational, within};
use crate::formula::LocatedFormula;
use crate::scheme::{Spanned, identifier};
use serde::Deserialize;
use statement::{NoStatement, Statement, Values, index, statement};
use std::collections::BTreeSet;

claim_table!(RelationTable {
    /// Names that stay symbolic; `q` may be a family such as `q[2*i-1]`.
    #[serde(default)]
    symbols: Vec<Spanned<String>>,
    /// What the paper presupposes, as linear equations.
    #[serde(default)]
    hypotheses: Vec<Spanned<String>>,
    /// What is claimed: `'0 < contraction(2) <= 1/2'`, `'symmetric()'`, `'sum_rules() in {3, 4}'`.
    states: Option<Spanned<String>>,
    /// The indices: `'n = 2..8'`, `'n = 2, 4, 8'` or `'all n >= 2'`, or a list of these.
    r#for: Option<Spanned<ForField>>,
    /// In place of `states`: what the paper lacks that the relation would need.
    absent: Option<String>,
});

one_or_each!(
    /// One index, or a list of them.
    ForField,
    "an index such as 'n = 2..8' or 'all n >= 2', or a list of them"
);

/// How indices are written.
const FOR: &str = "write for = 'n = 2..8', 'n = 2, 4, 8' or 'all n >= 2', or a list of these";

/// The greatest absolute value of the first of all values of an index.
const MAX_FIRST: i64 = 1_000_000;

impl RelationTable {
    /// The texts of the indices, with their places.
    fn indices(&self) -> Vec<(&str, std::ops::Range<usize>)> {
        match self.r#for.as_ref().map(|field| (field.get_ref(), field.span())) {
            None => Vec::new(),
            Some((ForField::One(text), span)) => vec![(text.as_str(), span)],
            Some((ForField::Each(texts), _)) => {
                texts.iter().map(|text| (text.get_ref().as_str(), text.span())).collect()
            }
        }
    }
}

impl ClaimTable for RelationTable {
    fn names(&self) -> Vec<(&str, Named)> {
        let indices = self.indices().into_iter();
        let indices = indices.filter_map(|(text, span)| Some((index(text)?.0, span)));
        let indices = indices.map(|(name, span)| (name, Named { role: Role::Index, span }));
        named(&self.symbols, Role::Symbol).chain(indices).collect()
    }

    fn read(&self, reader: &Reader<'_>, paper: &mut Paper) -> Result<(), Diagnostic> {
        paper.equations.push(reader.relation(self)?);
        Ok(())
    }
}

impl Reader<'_> {
    fn relation(&self, table: &RelationTable) -> Result<Equation, Diagnostic> {
        let Head { id, locus, title, scheme, note } = self.head(table.common())?;
        let body = match (&table.states, &table.absent) {
            (Some(states), None) => {
                EquationBody::Identity(Box::new(self.stated(table, scheme, states)?))
            }
            (None, Some(absent)) => EquationBody::NotCheckable(absent.clone()),
            _ => {
                return Err(self
                    .error(table.id.span(), "a relation needs either `states` or `absent`")
                    .with_help(
                        "states = 'contraction(2) < 1/2'; absent = \"…\" says what the paper lacks",
                    ));
            }
        };
        Ok(Equation { is_relation: true, id, locus, title, body, note })
    }

    fn stated(
        &self,
        table: &RelationTable,
        scheme: Option<LocatedReference>,
        states: &Spanned<String>,
    ) -> Result<Identity, Diagnostic> {
        let indices = table.indices().into_iter().map(|(text, span)| self.index_of(text, span));
        let indices = indices.collect::<Result<Vec<Index>, Diagnostic>>()?;
        let (symbols, hypotheses) = self.presupposed(&table.symbols, &table.hypotheses)?;
        let comparisons = self.comparisons(states)?;
        let states = Some(states.get_ref().clone());
        Ok(Identity { scheme, symbols, hypotheses, indices, comparisons, states })
    }

    /// The comparisons of a text.
    fn comparisons(&self, states: &Spanned<String>) -> Result<Vec<Comparison>, Diagnostic> {
        let read = |text: &str| LocatedFormula::read(self.source, states.span(), text);
        let compared = |left: &str, sign: Sign, rights: &[&str]| {
            let rights = rights.iter().map(|right| read(right)).collect::<Result<_, _>>()?;
            Ok(Comparison { left: Left::One(read(left)?), sign, rights })
        };
        let found =
            statement(states.get_ref()).map_err(|error| self.no_statement(states, error))?;
        match found {
            Statement::Alone(formula, true) => Ok(vec![compared(formula, Sign::True, &["1"])?]),
            Statement::Alone(formula, false) => Ok(vec![compared(formula, Sign::False, &["0"])?]),
            Statement::OneOf(left, members) => Ok(vec![compared(left, Sign::OneOf, &members)?]),
            Statement::Between(middle, [(above, low), (below, high)]) => {
                Ok(vec![compared(low, above, &[middle])?, compared(middle, below, &[high])?])
            }
            Statement::Chain(first, parts) => {
                let mut left = first;
                let mut all = Vec::with_capacity(parts.len());
                for (sign, right) in parts {
                    all.push(compared(left, sign, &[right])?);
                    left = right;
                }
                Ok(all)
            }
        }
    }

    fn no_statement(&self, states: &Spanned<String>, error: NoStatement) -> Diagnostic {
        let (message, help) = match error {
            NoStatement::NoSide => (
                "a formula is missing beside a sign",
                "write formulas with one of =, !=, <, <=, >, >= and ~ between them",
            ),
            NoStatement::NoSet => {
                ("no set stands behind `in`", "write `x in {1, 2}`, `x in [0, 1]` or `x in (0, 1]`")
            }
            NoStatement::SignAndSet => (
                "there is a sign beside `in`",
                "`x in [a, b)` states a <= x < b; state other things in a relation of their own",
            ),
            NoStatement::Bracket => ("a bracket has no partner", "close each bracket"),
        };
        self.error(states.span(), message).with_help(help)
    }

    /// One of the indices of a relation.
    fn index_of(&self, text: &str, span: std::ops::Range<usize>) -> Result<Index, Diagnostic> {
        let refused = |message: &str| self.error(span.clone(), message).with_help(FOR);
        let (name, values) = index(text).ok_or_else(|| refused("this is no index with values"))?;
        let name = identifier(self.source, &Spanned::new(span.clone(), name.to_owned()))?;
        let formula =
            |text: &str| LocatedFormula::read(self.source, span.clone(), text).map(Box::new);
        match values {
            Values::Range(from, to) => {
                let (from, to) = (formula(from)?, formula(to)?);
                Ok(Index::Range { label: name.clone(), name, from, to })
            }
            Values::All(from) => {
                let from = match from {
                    None => Some(1),
                    Some(from) => from.parse().ok().and_then(|from| within(from, MAX_FIRST)),
                };
                let from = from.ok_or_else(|| {
                    refused("the first value of `all` is no integer up to a million")
                })?;
                Ok(Index::All { name, from })
            }
            Values::Listed(values) => {
                let number = |text: &str| {
                    let value = parse_rational(text);
                    value.map_err(|error| refused(&error.to_string()))
                };
                let mut seen = BTreeSet::new();
                let mut listed: Vec<(Rational, String)> = Vec::with_capacity(values.len());
                for text in values {
                    let value = number(text)?;
                    if !seen.insert(value.clone()) {
                        let message = format!("the value {text} stands here twice");
                        return Err(refused(&message));
                    }
                    listed.push((value, text.to_owned()));
                }
                Ok(Index::Listed { label: name.clone(), name, values: listed })
            }
        }
    }
}
