//! How smooth the limits of a mask on Z^d are.

use super::constants::LatticeConstants;
use super::monomials::of_degree;
use super::polynomials::{natural_shift, sum_rules};
use super::shape::is_isotropic;
use super::tiling::Tiling;
use super::values::{ValueSpace, window};
use crate::cap::Cap;
use crate::exact::{
    Enclosed as _, IntegerPolynomial, Rational, RealAlgebraic, echelon, null_rows, row_times,
};
use crate::joint::{JointRadius, MatrixSet, radius_of_blocks};
use crate::scheme::{LatticeMask, Point, difference, sum};
use crate::smoothness::{ExponentFormula, Hoelder, log_of};
use crate::stop::Stop;
use std::cmp::Ordering;

/// The most functionals of a constant that is to show convergence.
const MAX_FUNCTIONALS: usize = 1 << 11;

/// How far beyond the sum rules the accuracy is looked for.
const BEYOND: u32 = 6;

/// What is proven of the limits of a mask on Z^d.
#[derive(Clone, Debug)]
pub struct LatticeSmoothness {
    /// The order K of the sum rules.
    pub sum_rules: u32,
    /// The order K' of the accuracy: the largest for which all polynomials of degree below are sums of shifts of φ. `None` where that is open.
    pub accuracy: Option<u32>,
    /// c and T_c < 1, if convergence is shown so.
    pub contraction: Option<(u32, Rational)>,
    /// Whether the scheme converges for all data; `None` where that is open.
    pub converges: Option<bool>,
    /// The radius that decides on the smoothness; of an isotropic M.
    pub radius: Option<LatticeRadius>,
    /// The largest m for which the limits are proven to be C^m.
    pub continuity: Option<u32>,
    /// The least m for which it is proven that not all limits are C^m.
    pub continuity_fails: Option<u32>,
    /// The Hölder exponent; of an isotropic M.
    pub hoelder: Option<Hoelder>,
    /// Why something is open.
    pub open: Option<String>,
}

/// A joint spectral radius of the steps on a space.
#[derive(Clone, Debug)]
pub struct LatticeRadius {
    /// The order of the differences in the space.
    pub order: u32,
    /// The number by which the matrices are multiplied.
    pub factor: Rational,
    /// The number of dimensions of the space before differences are taken.
    pub dimension: usize,
    /// One matrix for each digit.
    pub matrices: MatrixSet,
    /// Their radius.
    pub radius: JointRadius,
}

impl LatticeSmoothness {
    /// What can be proven of the limits, until the search is stopped.
    ///
    /// # Panics
    /// Never.
    #[must_use]
    pub fn until(mask: &LatticeMask, stop: &Stop) -> LatticeSmoothness {
        let sum_rules = sum_rules(mask);
        let mut found = LatticeSmoothness {
            sum_rules,
            accuracy: None,
            contraction: contraction(mask),
            converges: None,
            radius: None,
            continuity: None,
            continuity_fails: None,
            hoelder: None,
            open: None,
        };
        if found.contraction.is_some() {
            found.converges = Some(true);
        } else {
            match differences(mask, sum_rules, stop) {
                Ok(differences) => {
                    found.converges = differences.is_below(&Rational::one());
                    found.radius = Some(differences);
                }
                Err(cap) => found.open = Some(cap.to_string()),
            }
        }
        match found.converges {
            Some(true) => found.continuity = Some(0),
            Some(false) => {
                found.continuity_fails = Some(0);
                return found;
            }
            None => return found,
        }
        if !is_isotropic(mask.dilation()) {
            found.open = Some(
                "the eigenvalues of the dilation matrix have several moduli: only C^0 is decided"
                    .to_owned(),
            );
            return found;
        }
        match near_tile(mask, sum_rules, stop) {
            Ok(Some((accuracy, radius))) => found.decide(mask, accuracy, radius),
            Ok(None) => found.open = Some("φ has no values at the integers".to_owned()),
            Err(cap) => found.open = Some(cap.to_string()),
        }
        found
    }

    fn decide(&mut self, mask: &LatticeMask, accuracy: u32, found: LatticeRadius) {
        let m = mask.dilation().class_count();
        let d = mask.dimension();
        self.accuracy = Some(accuracy);
        let exponent = exponent(&found, m, d);
        // s^{−k} for M with |det M| = m = s^d is a d-th root.
        let below = |k: u32| found.is_below_root(k, m, d);
        self.continuity = (0..accuracy).take_while(|k| below(*k) == Some(true)).last().or(Some(0));
        // Below the accuracy C^k would take ϱ below s^{−k}; an exponent below it is not that of C^{K'}.
        let least = exponent.as_ref().is_some_and(|e| e.upper < Rational::from(accuracy));
        let fails = (1..accuracy).find(|k| below(*k) == Some(false));
        self.continuity_fails = fails.or(least.then_some(accuracy));
        self.hoelder = exponent;
        if self.hoelder.as_ref().is_some_and(|hoelder| hoelder.formula.is_none()) {
            self.open = Some("the bounds of the radius do not meet".to_owned());
        }
        self.radius = Some(found);
    }
}

impl LatticeRadius {
    fn of(
        matrices: Vec<Vec<Vec<Rational>>>,
        order: u32,
        factor: Rational,
        dimension: usize,
        stop: &Stop,
    ) -> LatticeRadius {
        let scaled = |matrix: Vec<Vec<Rational>>| {
            let row = |row: Vec<Rational>| row.iter().map(|x| x * &factor).collect();
            matrix.into_iter().map(row).collect()
        };
        let matrices = MatrixSet::of_any_size(matrices.into_iter().map(scaled).collect());
        let radius = radius_of_blocks(&matrices, stop);
        LatticeRadius { order, factor, dimension, matrices, radius }
    }

    /// Whether the radius of the steps is below a limit; `None` where its bounds do not tell.
    fn is_below(&self, limit: &Rational) -> Option<bool> {
        self.power_is_below(&(limit * &self.factor), 1)
    }

    /// Whether ϱ < m^{−k/d}, that is ϱ^d < m^{−k}.
    fn is_below_root(&self, k: u32, m: usize, d: usize) -> Option<bool> {
        let power = Rational::from(m).pow(-small(k)) * self.factor.pow(small(d));
        self.power_is_below(&power, small(d))
    }

    /// Whether (factor·ϱ)^power is below a limit.
    fn power_is_below(&self, limit: &Rational, power: i32) -> Option<bool> {
        let JointRadius { root, degree, exact, .. } = &self.radius;
        if self.radius.upper().pow(power) < *limit {
            return Some(true);
        }
        // root^{power/degree} against the limit.
        let degree = small(*degree);
        let at_least = compared(root, power, &limit.pow(degree)) != Ordering::Less;
        if at_least {
            return Some(false);
        }
        exact.then_some(true)
    }
}

/// root^power against a positive number.
fn compared(root: &RealAlgebraic, power: i32, limit: &Rational) -> Ordering {
    if power == 1 {
        return root.cmp_rational(limit);
    }
    // The positive root of q·x^power − p.
    let mut coefficients = vec![crate::exact::Integer::zero(); usize::try_from(power).expect("it is positive") + 1];
    coefficients[0] = -limit.numerator();
    *coefficients.last_mut().expect("two at least") = limit.denominator();
    let roots = RealAlgebraic::roots_of(&IntegerPolynomial::new(coefficients));
    roots.last().map_or(Ordering::Greater, |limit| root.cmp(limit))
}

fn small<T: TryInto<i32>>(x: T) -> i32 {
    x.try_into().ok().expect("a small number")
}

/// c and T_c, for the first c with T_c < 1.
fn contraction(mask: &LatticeMask) -> Option<(u32, Rational)> {
    let mut constants = LatticeConstants::new(mask);
    loop {
        constants.advance().ok()?;
        let functionals = mask.dilation().class_count().pow(constants.steps().count());
        if functionals * mask.edges().len() > MAX_FUNCTIONALS {
            return None;
        }
        let found = constants.contraction().ok()?;
        if found.value < Rational::one() {
            return Some((found.count, found.value));
        }
    }
}

/// The steps on the v on the window with Σ_β v_β β^μ = 0 for |μ| < k: their radius ϱ_k decides on convergence for all data, which is ϱ_1 < 1; and ϱ_1 is
/// the greater of ϱ_K and of the radii of Sym^j(M^{−1}), 1 ≤ j < K, which are below 1.
fn differences(mask: &LatticeMask, k: u32, stop: &Stop) -> Result<LatticeRadius, Cap> {
    let window = window(mask)?;
    let degrees = (0..k).flat_map(|k| of_degree(k, mask.dimension()));
    let exponents: Vec<[u32; 3]> = degrees.collect();
    let moments = window.iter().map(|place| {
        exponents.iter().map(|e| super::monomials::power(*place, *e)).collect::<Vec<Rational>>()
    });
    let rows = null_rows(&moments.collect::<Vec<_>>());
    let entry = |digit: &Point, alpha: &Point, beta: &Point| {
        let place = difference(sum(*digit, mask.dilation().times(*alpha)), *beta);
        mask.coefficients().get(&place).cloned().unwrap_or_else(Rational::zero)
    };
    let matrix = |digit: &Point| {
        let row = |beta: &Point| window.iter().map(|alpha| entry(digit, alpha, beta)).collect();
        window.iter().map(row).collect::<Vec<Vec<Rational>>>()
    };
    let matrices: Vec<Vec<Vec<Rational>>> = mask.dilation().digits().iter().map(matrix).collect();
    let (rows, pivots) = echelon(rows);
    let on = |matrix: &Vec<Vec<Rational>>| {
        let row = |row: &Vec<Rational>| {
            let image = row_times(row, matrix);
            pivots.iter().map(|k| image[*k].clone()).collect()
        };
        rows.iter().map(row).collect::<Vec<Vec<Rational>>>()
    };
    let matrices = matrices.iter().map(on).collect();
    Ok(LatticeRadius::of(matrices, k, Rational::one(), window.len(), stop))
}

/// The accuracy K', and the steps on the combinations Σ_i c_i Φ(x_i) with Σ_i c_i x_i^μ = 0 for |μ| < K', multiplied by a number so that the radius is at
/// least 1: s^{K'}, or the next power of m.
fn near_tile(
    mask: &LatticeMask,
    sum_rules: u32,
    stop: &Stop,
) -> Result<Option<(u32, LatticeRadius)>, Cap> {
    let centred = centred(mask);
    let alcove = centred.as_ref().and_then(Tiling::of_alcove);
    let (mask, tiling) = match (&centred, alcove) {
        (Some(centred), Some(alcove)) => (centred, alcove),
        _ => (mask, Tiling::of_digits(mask.dilation())?),
    };
    let Some(space) = ValueSpace::of(mask, &tiling, sum_rules + BEYOND)? else { return Ok(None) };
    let accuracy = space.accuracy;
    let factor = match mask.dilation().factor() {
        Some(n) => Rational::from(n.abs()).pow(small(accuracy)),
        None => {
            let d = u32::try_from(mask.dimension()).expect("2 or 3");
            Rational::from(mask.dilation().class_count()).pow(small(accuracy.div_ceil(d)))
        }
    };
    let ValueSpace { dimension, matrices, .. } = space;
    Ok(Some((accuracy, LatticeRadius::of(matrices, accuracy, factor, dimension, stop))))
}

/// The mask of the same scheme with the basic limit function moved by −τ, if the natural shift τ is integer: a(γ + (M − I)τ).
fn centred(mask: &LatticeMask) -> Option<LatticeMask> {
    let mut shift = [0; 3];
    for (at, x) in shift.iter_mut().zip(natural_shift(mask)) {
        *at = x.numerator().to_i64().filter(|_| x.is_integer())?;
    }
    let by = difference(mask.dilation().times(shift), shift);
    let moved = mask.coefficients().iter().map(|(place, c)| (difference(*place, by), c.clone()));
    LatticeMask::new(mask.dilation().clone(), moved, mask.edges().to_vec()).ok()
}

/// −log_s ϱ for the radius ϱ of the steps, s = m^{1/d}.
fn exponent(found: &LatticeRadius, m: usize, d: usize) -> Option<Hoelder> {
    let LatticeRadius { order, factor, radius, .. } = found;
    // The factor is f = n^K with s = n, or m^j; so −log_s ϱ = log_s f − log_s(fϱ).
    let (whole, base, power) = match root_of(m, d) {
        Some(n) if *factor == Rational::from(n).pow(small(*order)) => (*order as usize, n, 1),
        _ => {
            let j = (0..).find(|j| Rational::from(m).pow(*j) >= *factor)?;
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
