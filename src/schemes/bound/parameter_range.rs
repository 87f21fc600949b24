//! The parameters at which a contraction constant is below 1.

use super::parametric_rows::{RangeError, check, distinct_rows};
use super::power::Order;
use crate::exact::{
    Integer, IntegerPolynomial, IntervalSet, PiecewisePolynomial, Rational, RationalPolynomial,
    RealAlgebraic,
};
use crate::scheme::Rules;
use std::collections::{BTreeSet, HashSet};

/// T_c < 1 as a condition on a parameter, for c = 1, 2, ….
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterRange {
    /// The sets of the parameters with T_c < 1, from c = 1.
    pub levels: Vec<IntervalSet>,
    /// Their union: there the scheme converges.
    pub union: IntervalSet,
}

impl ParameterRange {
    /// The sets for c = 1, …, `levels` of these difference rules.
    ///
    /// Since T_{cd} ≤ T_c^d, the set for c is contained in the set for cd. Other sets
    /// need not contain each other.
    ///
    /// # Errors
    /// When the work is beyond [`MAX_RANGE_WORK`](super::MAX_RANGE_WORK).
    ///
    /// ```
    /// use subcert::bound::{ParameterRange, polynomial_rules};
    /// use subcert::scheme::parse_parametric;
    ///
    /// let mask = parse_parametric("four-point", "w")?;
    /// let range = ParameterRange::new(&polynomial_rules(&mask.difference(), "w")?, 2)?;
    /// assert_eq!(range.levels[0].describe("w"), "-1/4 < w < 1/4");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        difference: &Rules<RationalPolynomial>,
        levels: u32,
    ) -> Result<ParameterRange, RangeError> {
        check(difference, levels)?;
        let one = Rational::one();
        let set = |c| norm_below(difference, c, Order::Adjoint, &one);
        let levels = (1..=levels).map(set).collect::<Result<Vec<IntervalSet>, RangeError>>()?;
        let union = levels.iter().fold(IntervalSet::default(), |union, set| union.union(set));
        Ok(ParameterRange { levels, union })
    }
}

/// The set of the parameters at which ‖Rᶜ‖_∞ < `limit`, the norm of
/// [`power_norm`](super::power_norm).
///
/// The norm is the greatest of the sums Σ_s ε_s (Rᶜ)_{r,s} over all rows r and signs ε_s.
/// Only those signs are needed that the entries of a row have at some parameter of the
/// set. Each such sum is a polynomial in the parameter. The set is intersected with the
/// parameters at which the sum is below the limit, for one sum after the other, so no
/// maximum of functions is formed. `proofs/THEOREMS.md`, 50.
///
/// # Errors
/// When the work is beyond [`MAX_RANGE_WORK`](super::MAX_RANGE_WORK).
pub fn norm_below(
    rules: &Rules<RationalPolynomial>,
    levels: u32,
    order: Order,
    limit: &Rational,
) -> Result<IntervalSet, RangeError> {
    let mut set = IntervalSet::everything();
    // sum/q < limit as sum·b − a·q < 0, for the limit a/b.
    let factor = IntegerPolynomial::new(vec![limit.denominator()]);
    let mut seen = HashSet::new();
    for [row] in distinct_rows([rules], levels, order)? {
        let most = IntegerPolynomial::new(vec![limit.numerator() * &row.denominator]);
        for sum in signed_sums(&row.terms, &set) {
            let excess = &(&sum * &factor) - &most;
            if !set.is_empty() && seen.insert(excess.clone()) {
                set = cut(set, &excess);
            }
        }
    }
    Ok(set)
}

/// The part of a set where the polynomial `excess` is negative.
fn cut(set: IntervalSet, excess: &IntegerPolynomial) -> IntervalSet {
    let settled = set.hull().is_some_and(|(low, high)| {
        excess.sign_at(&low) < 0 && !excess.may_vanish_between(&low, &high)
    });
    if settled {
        return set;
    }
    let negative = RationalPolynomial::over(excess, &Integer::one());
    let negative = PiecewisePolynomial::from(negative).below(&Rational::zero());
    set.intersection(&negative)
}

/// The sums Σ_j ε_j p_j, for all signs ε_j that the p_j have between the ends of a set.
fn signed_sums(row: &[IntegerPolynomial], set: &IntervalSet) -> Vec<IntegerPolynomial> {
    let (low, high) = set.hull().unzip();
    let roots = row.iter().filter(|p| p.degree().unwrap_or(0) > 0).flat_map(|p| {
        let away = match (&low, &high) {
            (Some(low), Some(high)) => !p.may_vanish_between(low, high),
            _ => false,
        };
        if away {
            return Vec::new();
        }
        RealAlgebraic::roots_between(p, low.clone(), high.clone())
    });
    let ends = low.iter().chain(&high).cloned().map(RealAlgebraic::from);
    let points: BTreeSet<RealAlgebraic> = roots.chain(ends).collect();
    let points: Vec<RealAlgebraic> = points.into_iter().collect();
    let sum = |x: &Rational| {
        row.iter().fold(IntegerPolynomial::default(), |sum, p| {
            if p.sign_at(x) < 0 { &sum - p } else { &sum + p }
        })
    };
    // Signs outside a bounded set are not needed.
    match (&low, &points[..]) {
        (Some(only), [_]) => vec![sum(only)],
        (Some(_), points) => {
            points.windows(2).map(|pair| sum(&pair[0].rational_below(&pair[1]))).collect()
        }
        (None, points) => RealAlgebraic::rationals_between(points).iter().map(sum).collect(),
    }
}
