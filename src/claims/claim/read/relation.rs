//! Reading relations.

mod statement;

use super::fields::{claim_table, one_or_each, spanned};
use super::kind::{ClaimTable, Named, Role, named};
use super::reader::{Head, Reader};
use crate::claim::{
    Comparison, Equation, EquationBody, Identity, Index, Left, LocatedReference, Paper, Sign,
};
use crate::diagnostic::Diagnostic;
use crate::exact::{Interval, IntervalSet, Rational, parse_rational, within};
use crate::formula::LocatedFormula;
use crate::scheme::{Spanned, identifier};
use serde::Deserialize;
use statement::{NoStatement, Statement, Values, index, statement};
use std::collections::BTreeSet;
use std::ops::Bound;

claim_table!(RelationTable {
    /// Names that stay symbolic; `q` may be a family such as `q[2*i-1]`.
    #[serde(default)]
    symbols: Vec<Spanned<String>>,
    /// What the paper presupposes, as linear equations.
    #[serde(default)]
    hypotheses: Vec<Spanned<String>>,
    /// What is claimed: `'0 < contraction(2) <= 1/2'`, `'symmetric()'`, `'sum_rules() in {3, 4}'`; or a list of such
    /// texts, which are all claimed.
    states: Option<Spanned<StatesField>>,
    /// The indices: `'n = 2..8'`, `'n = 2, 4, 8'`, `'(n, v) = (3, 0.41), (4, 0.5)'`, `'all n >= 2'`, `'real v'` or
    /// `'0 < v < 1/4'`, or a list of these.
    r#for: Option<Spanned<ForField>>,
    /// Whether the relation is claimed for no other real number than the values of its only index.
    #[serde(default)]
    only: Option<Spanned<bool>>,
    /// In place of `states`: what the paper lacks that the relation would need.
    absent: Option<String>,
});

one_or_each!(
    /// A statement, or a list of them.
    StatesField,
    "a statement such as 'sum_rules() = 2', or a list of statements that are all claimed"
);

one_or_each!(
    /// One index, or a list of them.
    ForField,
    "an index such as 'n = 2..8', 'all n >= 2' or '0 < v < 1', or a list of them"
);

/// How indices are written.
const FOR: &str = "write for = 'n = 2..8', 'n = 2, 4, 8', '(n, v) = (3, 0.41), (4, 0.5)' or 'all n >= 2', or 'real v', \
                   '0 < v <= 1/4', 'v > 0' or 'v != 1/16' for real numbers, or a list of these";

/// The greatest absolute value of the first of all values of an index.
const MAX_FIRST: i64 = 1_000_000;

impl RelationTable {
    /// The texts of the indices, with their places.
    fn indices(&self) -> Vec<(&str, std::ops::Range<usize>)> {
        let field = self.r#for.as_ref();
        field.map_or_else(Vec::new, |field| field.get_ref().texts(field.span()))
    }
}

impl ClaimTable for RelationTable {
    fn names(&self) -> Vec<(&str, Named)> {
        let indices = self.indices().into_iter();
        let indices = indices.filter_map(|(text, span)| Some((index(text)?.0, span)));
        let indices = indices.flat_map(|(names, span)| {
            names
                .into_iter()
                .map(move |name| (name, Named { role: Role::Index, span: span.clone() }))
        });
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
        states: &Spanned<StatesField>,
    ) -> Result<Identity, Diagnostic> {
        let indices = table.indices().into_iter().map(|(text, span)| self.index_of(text, span));
        let indices = indices.collect::<Result<Vec<Index>, Diagnostic>>()?;
        let (symbols, hypotheses) = self.presupposed(&table.symbols, &table.hypotheses)?;
        let texts = spanned(states.get_ref().texts(states.span()));
        if texts.is_empty() {
            return Err(self.error(states.span(), "nothing is claimed").with_help(
                "states = 'sum_rules() = 2', or a list of such texts, which are all claimed",
            ));
        }
        let comparisons = texts.iter().map(|text| self.comparisons(text));
        let comparisons = comparisons.collect::<Result<Vec<_>, Diagnostic>>()?.concat();
        let only = table.only.as_ref().is_some_and(|only| *only.get_ref());
        let stated = Some(texts.into_iter().map(Spanned::into_inner).collect());
        let identity =
            Identity { scheme, symbols, hypotheses, indices, comparisons, states: stated, only };
        self.check_reals(table, &identity, states.span())?;
        Ok(identity)
    }

    /// Checks what a relation may have beside an index of real numbers.
    fn check_reals(
        &self,
        table: &RelationTable,
        identity: &Identity,
        states: std::ops::Range<usize>,
    ) -> Result<(), Diagnostic> {
        let place = |span: Option<std::ops::Range<usize>>| span.unwrap_or_else(|| states.clone());
        let reals = identity.indices.iter().filter(|index| matches!(index, Index::Real { .. }));
        let reals = reals.count();
        if identity.only
            && (reals == 0 && !matches!(identity.indices[..], [Index::Listed { .. }])
                || identity.indices.len() != 1)
        {
            let span = place(table.only.as_ref().map(Spanned::span));
            let message =
                "`only` is about the one index of a relation, which has real or listed values";
            return Err(self.error(span, message).with_help(
                "for = 'v = 1/16' with only = true states it for 1/16 and for no other real v",
            ));
        }
        if reals == 0 && !identity.only {
            return Ok(());
        }
        let span = place(table.r#for.as_ref().map(Spanned::span));
        if reals > 1 {
            return Err(self.error(span, "two indices of real numbers cannot be judged together"));
        }
        if identity.is_for_all() || !identity.symbols.is_empty() || !identity.hypotheses.is_empty()
        {
            let message = "beside an index of real numbers there are no symbols, no hypotheses and no index that is `all`";
            return Err(self.error(span, message));
        }
        if identity.comparisons.iter().any(|comparison| comparison.sign == Sign::Near) {
            let message = "`~` compares a printed number with one value, and there are many here";
            return Err(self.error(states, message).with_help("write an interval: `x in [a, b]`"));
        }
        Ok(())
    }

    /// The real numbers that signs and formulas describe.
    fn reals(
        &self,
        signs: &[(Sign, &str)],
        span: std::ops::Range<usize>,
    ) -> Result<IntervalSet, Diagnostic> {
        let mut set = IntervalSet::everything();
        for (sign, text) in signs {
            let (_, end) = self.place_of(text, span.clone())?;
            let (low, high) = match sign {
                Sign::Less => (Bound::Unbounded, Bound::Excluded(end)),
                Sign::AtMost => (Bound::Unbounded, Bound::Included(end)),
                Sign::Greater => (Bound::Excluded(end), Bound::Unbounded),
                Sign::AtLeast => (Bound::Included(end), Bound::Unbounded),
                _ => (Bound::Included(end.clone()), Bound::Included(end)),
            };
            let described = IntervalSet::from(Interval { low, high });
            set = match sign {
                Sign::Unequal => set.without(&described),
                _ => set.intersection(&described),
            };
        }
        let is_below = |(sign, _): &(Sign, &str)| matches!(sign, Sign::Less | Sign::AtMost);
        if let [first, second] = signs
            && is_below(first) == is_below(second)
        {
            let message = "both signs have one direction: `0 < v < 1`";
            return Err(self.error(span, message).with_help(FOR));
        }
        if set.is_empty() {
            return Err(self.error(span, "no number is between these ends").with_help(FOR));
        }
        Ok(set)
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

    /// The comparisons of an inequality `a < b <= c`.
    pub(super) fn inequalities(
        &self,
        text: &Spanned<String>,
    ) -> Result<Vec<Comparison>, Diagnostic> {
        let is_chain = matches!(statement(text.get_ref()), Ok(Statement::Chain(..)));
        let comparisons = self.comparisons(text)?;
        if is_chain && comparisons.iter().all(|comparison| comparison.sign.is_order()) {
            return Ok(comparisons);
        }
        Err(self
            .error(text.span(), "this is no inequality")
            .with_help("write '0 < a + b <= 1', with the signs <, <=, > and >="))
    }

    fn no_statement(&self, states: &Spanned<String>, error: NoStatement) -> Diagnostic {
        let (message, help) = match error {
            NoStatement::NoSide => (
                "a formula is missing beside a sign",
                "write formulas with one of =, !=, <, <=, >, >= and ~ between them",
            ),
            NoStatement::Doubled => {
                ("`==`, `=>` and `=<` are no signs here", "write `=`, `>=` or `<=`")
            }
            NoStatement::PlusMinus => (
                "`±` states two things, and `+-` is often meant so",
                "write `x in [a - b, a + b]` for an error, `x in {a - b, a + b}` for two values, and `+ (-b)` for a sum",
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
        let (names, values) = index(text).ok_or_else(|| refused("this is no index with values"))?;
        let name =
            |name: &&str| identifier(self.source, &Spanned::new(span.clone(), (*name).to_owned()));
        let mut names = names.iter().map(name).collect::<Result<Vec<String>, Diagnostic>>()?;
        let number = |text: &str| parse_rational(text).map_err(|error| refused(&error.to_string()));
        if let Values::Rows(rows) = values {
            let row = |row: Vec<&str>| {
                if row.len() != names.len() {
                    return Err(refused("each row has a value for each name"));
                }
                row.into_iter().map(|text| Ok((number(text)?, text.to_owned()))).collect()
            };
            let rows = rows.into_iter().map(row).collect::<Result<Vec<Vec<_>>, Diagnostic>>()?;
            for (i, row) in rows.iter().enumerate() {
                let alike = |other: &Vec<(Rational, String)>| {
                    row.iter().zip(other).all(|((a, _), (b, _))| a == b)
                };
                if rows[..i].iter().any(alike) {
                    return Err(refused("a row of values stands here twice"));
                }
            }
            return Ok(Index::Together { names, rows });
        }
        let name = names.pop().unwrap_or_default();
        let formula =
            |text: &str| LocatedFormula::read(self.source, span.clone(), text).map(Box::new);
        match values {
            Values::Rows(_) => Err(refused("this is no index with values")),
            Values::Real(signs) => {
                let values = self.reals(&signs, span.clone())?;
                Ok(Index::Real { name, values, text: text.trim().to_owned() })
            }
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
