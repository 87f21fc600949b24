//! Proofs for all integers from one on.
//!
//! A mask with a symbol in it may be another one at some integers. So only functions of [families](crate::smoothness::SymbolFamily) may
//! be about schemes that depend on them.

use super::cases::Case;
use super::comparison::Sides;
use super::relation::holds;
use crate::claim::{Comparison, Sign};
use crate::diagnostic::Diagnostic;
use crate::exact::{
    IntegerFunction, MAX_TRIED_INTEGERS, Polynomial, Rational, RationalPolynomial, Scalar as _,
};
use crate::formula::{LocatedFormula, Value as _};
use std::cmp::Ordering;

/// The greatest degree of a polynomial in an index.
const MAX_DEGREE: usize = 256;

/// The least integer from which on functions have signs; those before it are tried.
const LEAST: i64 = 16;

/// What is known of a comparison for all values of the indices that are symbols.
pub(super) enum ForAll {
    /// It is true for all of them.
    Proved,
    /// It is false for this value of the only one.
    FalseAt(i64),
    /// It is true for all values of the only one from this one on.
    TrueFrom(i64),
    /// It is false for all these.
    FalseFrom(i64),
}

/// Decides a comparison for all values of the indices without one; `None` where nothing is known.
pub(super) fn decide(sides: &Sides<'_>, comparison: &Comparison, case: &Case) -> Option<ForAll> {
    // Hypotheses may hold at some integers only.
    if !sides.identity.hypotheses.is_empty() {
        return None;
    }
    as_polynomials(sides, comparison, case).or_else(|| as_functions(sides, comparison, case))
}

/// Decides a comparison from 16 on, as one of [functions of an integer](IntegerFunction).
fn as_functions(sides: &Sides<'_>, comparison: &Comparison, case: &Case) -> Option<ForAll> {
    let [(_, first)] = &case.symbolic[..] else { return None };
    let first = (*first).max(LEAST);
    if !sides.identity.symbols.is_empty() {
        return None;
    }
    let formulas = std::iter::once(comparison.left.formula(0)).chain(&comparison.rights);
    let values = sides.for_integers(formulas, case, first)?;
    let (left, rights) = values.split_first()?;
    let sign = |right: &IntegerFunction| left.minus(right).sign();
    let holds = match comparison.sign {
        Sign::OneOf => {
            let signs: Vec<Option<Ordering>> = rights.iter().map(sign).collect();
            let found = signs.contains(&Some(Ordering::Equal));
            if !found && signs.contains(&None) {
                return None;
            }
            found
        }
        Sign::Near => return None,
        other => other.fits(sign(rights.first()?)?),
    };
    Some(if holds { ForAll::TrueFrom(first) } else { ForAll::FalseFrom(first) })
}

/// Decides a comparison as one of polynomials in the indices without values; `None` if it is none, or is not decided.
///
/// For `=`, the difference is the polynomial 0. Otherwise let d(t) = Σ_{i≤g} c_i t^i be the difference of the sides, t the only index
/// and no symbol in it. From b = ⌈1 + max_{i<g} |c_i/c_g|⌉ + 1 on, Cauchy's bound for roots, d has the sign of c_g and is not 0;
/// the integers up to b are tried.
fn as_polynomials(sides: &Sides<'_>, comparison: &Comparison, case: &Case) -> Option<ForAll> {
    let printed = comparison.left.formula(0);
    let symbols = !sides.identity.symbols.is_empty();
    let near = sides.identity.comparisons.iter().any(|one| one.sign == Sign::Near);
    let functions = match &case.symbolic[..] {
        [(name, first)] if !symbols && !near => Some(sides.in_family(case, (name, *first)).ok()?),
        _ if sides.has_scheme_of_numbers(case).unwrap_or(false) => None,
        _ => return None,
    };
    let value = |formula: &LocatedFormula| match &functions {
        Some(functions) => sides.value_with(functions, formula, case),
        None => sides.value(formula, &formula.expr, case),
    };
    let left = value(printed).ok()?;
    let rights: Result<Vec<Polynomial>, Diagnostic> = comparison.rights.iter().map(value).collect();
    let rights = rights.ok()?;
    let differences: Vec<Polynomial> = rights.iter().map(|right| &left - right).collect();
    // Symbols are compared with `=` only.
    if comparison.sign != Sign::Equal && symbols {
        return None;
    }
    if matches!(comparison.sign, Sign::Equal | Sign::OneOf)
        && differences.iter().any(Polynomial::is_zero)
    {
        return Some(ForAll::Proved);
    }
    let [(name, first)] = &case.symbolic[..] else { return None };
    let alone = differences.iter().all(|difference| difference.number().is_some());
    if alone && comparison.sign != Sign::OneOf {
        let found = match comparison.sign {
            Sign::Near | Sign::True | Sign::False => {
                holds(comparison, (printed, &[]), &left, &rights)
            }
            // The difference is compared with 0.
            _ => holds(comparison, (printed, &[]), &differences[0], &[Polynomial::default()]),
        };
        return Some(if found.ok()? { ForAll::Proved } else { ForAll::FalseAt(*first) });
    }
    if matches!(comparison.sign, Sign::Near | Sign::True | Sign::False) {
        return None;
    }
    let polynomials = differences.iter().map(|difference| {
        let found = difference.in_variable(name)?;
        found.degree().is_none_or(|degree| degree <= MAX_DEGREE).then_some(found)
    });
    let polynomials = polynomials.collect::<Option<Vec<RationalPolynomial>>>()?;
    let bounds = polynomials.iter().map(RationalPolynomial::settled_from);
    let last = bounds.collect::<Option<Vec<i64>>>()?.into_iter().fold(*first, i64::max);
    if last - first >= MAX_TRIED_INTEGERS {
        return None;
    }
    for t in *first..=last {
        let at = |one: &RationalPolynomial| Polynomial::constant(one.value_at(&Rational::from(t)));
        let values: Vec<Polynomial> = polynomials.iter().map(at).collect();
        // Differences are compared with 0, which is a member of the set if one of them is 0.
        let found = match (comparison.sign, &values[..]) {
            (Sign::OneOf, _) => holds(comparison, (printed, &[]), &Polynomial::default(), &values),
            (_, [difference, ..]) => {
                holds(comparison, (printed, &[]), difference, &[Polynomial::default()])
            }
            (_, []) => return None,
        };
        if !found.ok()? {
            return Some(ForAll::FalseAt(t));
        }
    }
    // Behind the bound no difference is 0, and each has the sign that it has at the bound.
    Some(if comparison.sign == Sign::OneOf || comparison.sign == Sign::Equal {
        ForAll::FalseAt(last + 1)
    } else {
        ForAll::Proved
    })
}
