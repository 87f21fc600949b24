//! Proofs for all integers from one on.
//!
//! The scheme must not depend on them: a mask with a symbol in it may be another one at some integers.

use super::cases::Case;
use super::comparison::Sides;
use super::relation::holds;
use crate::claim::{Comparison, Sign};
use crate::diagnostic::Diagnostic;
use crate::exact::{Integer, Polynomial, Rational};
use crate::formula::{LocatedFormula, Value as _};

/// The most integers that are tried one by one.
const MAX_TRIED: i64 = 10_000;

/// The greatest degree of a polynomial in an index.
const MAX_DEGREE: usize = 256;

/// What is known of a comparison for all values of the indices that are symbols.
pub(super) enum ForAll {
    /// It is true for all of them.
    Proved,
    /// It is false for this value of the only one.
    FalseAt(i64),
}

/// Decides a comparison as one of polynomials in the indices without values; `None` if it is none, or is not decided.
///
/// For `=`, the difference is the polynomial 0. Otherwise let d(t) = Σ_{i≤g} c_i t^i be the difference of the sides, t the only index
/// and no symbol in it. From b = ⌈1 + max_{i<g} |c_i/c_g|⌉ + 1 on, Cauchy's bound for roots, d has the sign of c_g and is not 0;
/// the integers up to b are tried.
pub(super) fn decide(sides: &Sides<'_>, comparison: &Comparison, case: &Case) -> Option<ForAll> {
    // Hypotheses may hold at some integers only.
    if !sides.identity.hypotheses.is_empty() || !sides.has_scheme_of_numbers(case).unwrap_or(false)
    {
        return None;
    }
    let printed = comparison.left.formula(0);
    let value = |formula: &LocatedFormula| sides.value(formula, &formula.expr, case);
    let left = value(printed).ok()?;
    let rights: Result<Vec<Polynomial>, Diagnostic> = comparison.rights.iter().map(value).collect();
    let rights = rights.ok()?;
    let differences: Vec<Polynomial> = rights.iter().map(|right| &left - right).collect();
    // Symbols are compared with `=` only.
    if comparison.sign != Sign::Equal && !sides.identity.symbols.is_empty() {
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
    let polynomials = differences.iter().map(|difference| coefficients(difference, name));
    let polynomials = polynomials.collect::<Option<Vec<Vec<Rational>>>>()?;
    let bounds = polynomials.iter().map(|polynomial| bound(polynomial));
    let last = bounds.collect::<Option<Vec<i64>>>()?.into_iter().fold(*first, i64::max);
    if last - first > MAX_TRIED {
        return None;
    }
    for t in *first..=last {
        let values: Vec<Polynomial> = polynomials.iter().map(|one| at(one, t)).collect();
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

/// The coefficients of a polynomial in `name` alone, which are rational and not too many.
fn coefficients(polynomial: &Polynomial, name: &str) -> Option<Vec<Rational>> {
    let all = polynomial.coefficients_in(name).filter(|all| all.len() <= MAX_DEGREE + 1)?;
    all.iter().map(|c| c.as_rational().cloned()).collect()
}

/// An integer from which on the polynomial with these coefficients has the sign of the highest.
fn bound(coefficients: &[Rational]) -> Option<i64> {
    let (highest, others) = coefficients.split_last()?;
    let ratios = others.iter().map(|c| (c / highest).abs());
    let most = ratios.fold(Rational::zero(), Rational::max);
    let bound = (most + Rational::from(1)).ceil() + Integer::one();
    bound.within(1 << 32)
}

/// The value of the polynomial with these coefficients at an integer.
fn at(coefficients: &[Rational], t: i64) -> Polynomial {
    let t = Rational::from(t);
    let value = coefficients.iter().rev().fold(Rational::zero(), |value, c| value * &t + c);
    Polynomial::constant(value)
}
