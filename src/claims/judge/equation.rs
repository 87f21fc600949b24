//! Judging an equation.

use crate::cap::Cap;
use crate::claim::{Equation, EquationBody, Identity, Index, Paper, Sign, is_rounded};
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::{Library, values};
use crate::evaluation::shape::Shapes;
use crate::exact::{Polynomial, Rational, Rounding, parse_decimal};
use crate::finding::{EquationFinding, EquationVerdict, Failure, SideValue};
use crate::formula::{LocatedFormula, Value as _};
use crate::judge::cases::{Case, MAX_CASES, Unbounded, beyond, cases};
use crate::judge::comparison::Sides;
use crate::judge::for_all::{ForAll, decide};
use crate::judge::kind::JudgeAlone;
use crate::judge::mend;
use crate::judge::reals;
use crate::judge::relation::decided;
use std::cell::Cell;
use std::collections::BTreeMap;

/// The most steps of formulas in all cases of an equation together.
const MAX_WORK: u64 = 20_000_000;

impl<'a> JudgeAlone<'a> for Equation {
    type Finding = EquationFinding<'a>;

    /// Judges an equation or another relation: the sides as polynomials in the symbols, in normal form.
    fn judge_alone(
        &'a self,
        paper: &'a Paper,
        library: &Library<'_>,
    ) -> Result<EquationFinding<'a>, Diagnostic> {
        let id = format!("{}:{}", paper.key, self.id);
        let shapes = Shapes::with_filters(library);
        let verdict = match &self.body {
            EquationBody::NotCheckable(_) => EquationVerdict::NotCheckable,
            EquationBody::Identity(identity) => {
                let found = Diagnostic::or_cap(compare(paper, identity, (&shapes, library)))?;
                found.unwrap_or_else(EquationVerdict::BeyondCap)
            }
        };
        Ok(EquationFinding { id, equation: self, verdict, limits: shapes.used.take() })
    }
}

fn compare(
    paper: &Paper,
    identity: &Identity,
    (shapes, library): (&Shapes<'_, Polynomial>, &Library<'_>),
) -> Result<EquationVerdict, Diagnostic> {
    let mut given = BTreeMap::new();
    if identity.states.is_some() {
        given = values(&paper.given)?;
        for name in identity.indices.iter().flat_map(Index::names).chain(&identity.symbols) {
            given.remove(name);
        }
    }
    if identity.only || identity.real_index().is_some() {
        return reals::judge(paper, identity, (library, &shapes.used), &given);
    }
    let in_fields = Shapes::with_filters(library);
    let in_fields = &in_fields;
    let sides = Sides { paper, identity, shapes, in_fields, given, spent: Cell::new(0) };
    if identity.is_for_all() {
        return for_all(&sides);
    }
    let cases = counted(&sides)?;
    let (mut failures, mut failing, mut open) = (Vec::new(), Vec::new(), Vec::new());
    for (i, case) in cases.iter().enumerate() {
        for part in 0..identity.comparisons.len() {
            match compared(&sides, part, i, case)? {
                Compared::Holds => {}
                Compared::Open(case) => open.push(case),
                Compared::Fails(failure) => {
                    failures.push(failure);
                    failing.push(i);
                }
            }
        }
    }
    let count = cases.len() * identity.comparisons.len();
    if failures.is_empty() && !open.is_empty() {
        return Ok(EquationVerdict::Undecided { cases: count, open });
    }
    if failures.is_empty() {
        return Ok(EquationVerdict::Holds { cases: count });
    }
    let mends = if failures.iter().all(|failure| failure.rounding.is_some()) {
        Vec::new()
    } else {
        mend::search(&sides, &cases, &failing)
    };
    Ok(EquationVerdict::Fails { cases: count, failures, mends })
}

/// The cases that are tried one by one; with the comparisons, there are not more than the cap.
fn counted(sides: &Sides<'_>) -> Result<Vec<Case>, Diagnostic> {
    let identity = sides.identity;
    let cases = cases(identity, Unbounded::Tried)?;
    if cases.len().saturating_mul(identity.comparisons.len()) > MAX_CASES {
        let cap = Cap::new("the number of cases, times that of comparisons", MAX_CASES as u64);
        return Err(beyond(identity.first().right(), cap));
    }
    Ok(cases)
}

/// What is known of a comparison in a case.
enum Compared {
    Holds,
    Fails(Failure),
    /// Bounds of the values do not decide it.
    Open(Failure),
}

/// How a comparison of this number fails in the `i`-th case, if it does.
fn compared(sides: &Sides<'_>, part: usize, i: usize, case: &Case) -> Result<Compared, Diagnostic> {
    let identity = sides.identity;
    let comparison = &identity.comparisons[part];
    let printed = comparison.left.formula(i);
    let value = |formula: &LocatedFormula| sides.side(formula, case);
    let rights = || comparison.rights.iter().map(value).collect::<Result<Vec<_>, _>>();
    let (left, rights) = Diagnostic::both(value(printed), rights())?;
    if sides.spent.get() > MAX_WORK {
        return Err(beyond(comparison.right(), Cap::new("the work of all cases", MAX_WORK)));
    }
    let decided = decided(comparison, (printed, &case.printed), &left, &rights)?;
    if decided == Some(true) {
        return Ok(Compared::Holds);
    }
    let mut indices: Vec<Rational> = case.values.iter().map(|(_, value)| value.clone()).collect();
    let mut at = case.text.clone();
    if identity.comparisons.len() > 1 {
        indices.push(Rational::from(part + 1));
        let mark = comparison.sign.mark();
        let comma = if at.is_empty() { "" } else { ", " };
        at = format!("{at}{comma}{} {mark} {}", printed.text, comparison.right().text);
    }
    let right = rights.into_iter().next();
    let right = right.unwrap_or_else(|| SideValue::Polynomial(Polynomial::default()));
    let rounding = (comparison.sign == Sign::Equal)
        .then(|| rounding(printed, &right).or_else(|| rounding(comparison.right(), &left)));
    let case = Failure { at, indices, left, right, rounding: rounding.flatten() };
    Ok(if decided.is_none() { Compared::Open(case) } else { Compared::Fails(case) })
}

/// Judges a claim about all integers from one on.
fn for_all(sides: &Sides<'_>) -> Result<EquationVerdict, Diagnostic> {
    let identity = sides.identity;
    let fails =
        |failure| EquationVerdict::Fails { cases: 1, failures: vec![failure], mends: Vec::new() };
    // Where the values of another index depend on such an index, it is no symbol.
    let symbolic = cases(identity, Unbounded::Symbol).unwrap_or_default();
    let mut proved = !symbolic.is_empty();
    let at = |part: usize, case: &Case, t: i64| compared(sides, part, 0, &case.at(identity, t));
    let (mut singles, mut later, mut open) = (Vec::new(), Vec::new(), Vec::new());
    for case in &symbolic {
        for (part, comparison) in identity.comparisons.iter().enumerate() {
            match decide(sides, comparison, case) {
                Some(ForAll::Proved) => {}
                Some(ForAll::TrueFrom(first)) => singles.push((part, case, first)),
                Some(ForAll::FalseFrom(t)) => later.push((part, case, t)),
                Some(ForAll::FalseAt(t)) => {
                    if let Compared::Fails(failure) = at(part, case, t)? {
                        return Ok(fails(failure));
                    }
                    proved = false;
                }
                None => proved = false,
            }
        }
    }
    for (part, case, first) in singles {
        for t in case.symbolic.iter().flat_map(|(_, least)| *least..first) {
            match at(part, case, t)? {
                Compared::Holds => {}
                Compared::Open(_) => proved = false,
                Compared::Fails(failure) => return Ok(fails(failure)),
            }
        }
    }
    if proved && later.is_empty() {
        return Ok(EquationVerdict::Proved);
    }
    let tried = counted(sides)?;
    for case in &tried {
        for part in 0..identity.comparisons.len() {
            match compared(sides, part, 0, case)? {
                Compared::Holds => {}
                Compared::Open(failure) => open.push(failure),
                Compared::Fails(failure) => return Ok(fails(failure)),
            }
        }
    }
    for (part, case, t) in later {
        if let Compared::Fails(failure) = at(part, case, t)? {
            return Ok(fails(failure));
        }
    }
    let cases = tried.len() * identity.comparisons.len();
    Ok(if open.is_empty() {
        EquationVerdict::Tried { cases }
    } else {
        EquationVerdict::Undecided { cases, open }
    })
}

/// How a side that is one decimal came from the number on the other side: rounded to the nearest, or, if it has digits enough, cut or
/// rounded away from zero.
fn rounding(printed: &LocatedFormula, other: &SideValue) -> Option<Rounding> {
    let SideValue::Polynomial(other) = other else { return None };
    let decimal = parse_decimal(&printed.text).ok().filter(|decimal| decimal.exponent() < 0)?;
    let rounding = decimal.rounding_of(&other.as_rational()?);
    match rounding {
        Rounding::Nearest => Some(rounding),
        Rounding::Cut | Rounding::Up => is_rounded(&decimal).then_some(rounding),
        Rounding::Exact | Rounding::Neither => None,
    }
}
