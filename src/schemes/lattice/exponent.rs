//! Exponents from radii of matrices.

use crate::exact::{
    Enclosed as _, Integer, IntegerPolynomial, Rational, RealAlgebraic, characteristic_polynomial,
};
use crate::joint::{JointRadius, MatrixSet};
use crate::scheme::Dilation;
use crate::smoothness::{ExponentFormula, Hoelder, log_of};
use std::cmp::Ordering;

/// −log_s ϱ for the radius ϱ of the steps, s = m^{1/d}.
///
/// The radius is that of the steps times a factor, on differences of an order; m = |det M| in d dimensions.
pub(super) fn exponent(
    radius: &JointRadius,
    (order, factor): (u32, &Rational),
    dilation: &Dilation,
) -> Option<Hoelder> {
    let (m, d) = (dilation.class_count(), dilation.dimension());
    // The factor is f = n^K with s = n, or m^j; so −log_s ϱ = log_s f − log_s(fϱ).
    let (whole, base, power) = match dilation.root() {
        Some(n) if *factor == Rational::from(n).pow(small(order)) => {
            (usize::try_from(order).ok()?, n, 1)
        }
        _ => {
            let j = (0..=small(order)).find(|j| Rational::from(m).pow(*j) >= *factor)?;
            (usize::try_from(j).ok()? * d, m, d)
        }
    };
    let root = raised(&radius.root, power)?;
    let formula = ExponentFormula::new(whole, base, &root, radius.degree);
    let upper = formula.enclosure(1).upper().clone();
    if radius.exact {
        let lower = formula.enclosure(1).lower().clone();
        return Some(Hoelder { lower, upper, formula: Some(formula), attained: None });
    }
    let bound = radius.upper().pow(small(power));
    let lower = Rational::from(whole) - log_of(&bound, base, 1).upper();
    Some(Hoelder { lower, upper, formula: None, attained: None })
}

/// root^power: an eigenvalue of that power of the companion matrix of a polynomial of the root.
fn raised(root: &RealAlgebraic, power: usize) -> Option<RealAlgebraic> {
    if let Some(value) = root.as_rational() {
        return Some(RealAlgebraic::from(value.pow(small(power))));
    }
    if power == 1 {
        return Some(root.clone());
    }
    let polynomial = root.polynomial();
    let all = polynomial.coefficients();
    let (lead, rest) = all.split_last()?;
    let degree = rest.len();
    let entry = |i: usize, j: usize| {
        if i + 1 < degree {
            return Rational::from(i64::from(j == i + 1));
        }
        -Rational::new(rest[j].clone(), lead.clone())
    };
    let companion: Vec<Vec<Rational>> =
        (0..degree).map(|i| (0..degree).map(|j| entry(i, j)).collect()).collect();
    let matrix = MatrixSet::of_any_size(vec![companion]).product(&vec![0; power]);
    let roots = RealAlgebraic::roots_of(&characteristic_polynomial(&matrix));
    roots.into_iter().find(|y| is_power(root, power, y))
}

/// Whether a number is root^power, if it is known to be one of finitely many that are no nearer to each other than their bounds say.
fn is_power(root: &RealAlgebraic, power: usize, value: &RealAlgebraic) -> bool {
    let (low, high) = value.bounds();
    low.sign() >= 0
        && compared(root, small(power), &low).is_ge()
        && compared(root, small(power), &high).is_le()
}

/// root^power against a positive number.
pub(super) fn compared(root: &RealAlgebraic, power: i32, limit: &Rational) -> Ordering {
    if power == 1 {
        return root.cmp_rational(limit);
    }
    // The positive root of q·x^power − p.
    let mut coefficients =
        vec![Integer::zero(); usize::try_from(power).expect("it is positive") + 1];
    coefficients[0] = -limit.numerator();
    *coefficients.last_mut().expect("two at least") = limit.denominator();
    let roots = RealAlgebraic::roots_of(&IntegerPolynomial::new(coefficients));
    roots.last().map_or(Ordering::Greater, |limit| root.cmp(limit))
}

pub(super) fn small<T: TryInto<i32>>(x: T) -> i32 {
    x.try_into().ok().expect("a small number")
}
