//! Exponents from radii of matrices.

use crate::exact::{Enclosed as _, Integer, IntegerPolynomial, Rational, RealAlgebraic};
use crate::joint::JointRadius;
use crate::smoothness::{ExponentFormula, Hoelder, log_of};
use std::cmp::Ordering;

/// −log_s ϱ for the radius ϱ of the steps, s = m^{1/d}.
///
/// The radius is that of the steps times a factor, on differences of an order; m = |det M| in d dimensions.
pub(super) fn exponent(
    radius: &JointRadius,
    (order, factor): (u32, &Rational),
    (m, d): (usize, usize),
) -> Option<Hoelder> {
    // The factor is f = n^K with s = n, or m^j; so −log_s ϱ = log_s f − log_s(fϱ).
    let (whole, base, power) = match root_of(m, d) {
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

/// n with n^d = m.
fn root_of(m: usize, d: usize) -> Option<usize> {
    (2..=m).find(|n| n.checked_pow(u32::try_from(d).unwrap_or(1)) == Some(m))
}

/// root^power, of irrational numbers up to the square.
fn raised(root: &RealAlgebraic, power: usize) -> Option<RealAlgebraic> {
    if let Some(value) = root.as_rational() {
        return Some(RealAlgebraic::from(value.pow(small(power))));
    }
    match power {
        1 => Some(root.clone()),
        2 => {
            // p(x) = e(x²) + x·o(x²): x² is a root of e(y)² − y·o(y)².
            let p = root.polynomial();
            let all = p.coefficients();
            let part = |first: usize| {
                all.iter().skip(first).step_by(2).map(|c| Rational::from(c.clone())).collect()
            };
            let (even, odd): (Vec<Rational>, Vec<Rational>) = (part(0), part(1));
            let mut square = vec![Rational::zero(); all.len() + 1];
            for (i, a) in even.iter().enumerate() {
                even.iter().enumerate().for_each(|(j, b)| square[i + j] += &(a * b));
            }
            for (i, a) in odd.iter().enumerate() {
                odd.iter().enumerate().for_each(|(j, b)| square[i + j + 1] -= &(a * b));
            }
            let square = IntegerPolynomial::over_common_denominator(&square);
            let (low, high) = root.bounds();
            RealAlgebraic::roots_of(&square).into_iter().find(|y| {
                let above = |x: &Rational| compared(root, 2, x);
                // Of the roots, the one that is neither above nor below the square.
                let (a, b) = y.bounds();
                above(&a).is_ge() && above(&b).is_le() && a <= &high * &high && b >= &low * &low
            })
        }
        _ => None,
    }
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
