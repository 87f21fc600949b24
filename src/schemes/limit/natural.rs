//! The parameters at which the points of a polygon are compared with the limit.

use crate::exact::{Enclosed, Rational, Real, Scalar};
use crate::scheme::Mask;

/// How parameters are assigned to the points of a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Parametrisation {
    /// x^k_i at i/n^k, as in most papers.
    Indexed,
    /// x^k_i at its natural parameter (i + s)/n^k.
    Natural,
}

impl Parametrisation {
    /// s for this mask.
    #[must_use]
    pub fn shift(self, mask: &Mask) -> Rational {
        match self {
            Parametrisation::Indexed => Rational::zero(),
            Parametrisation::Natural => natural_shift(mask).shift,
        }
    }

    /// Whether this parametrisation has a shift other than 0 for any of these schemes.
    #[must_use]
    pub fn moves<'m>(self, masks: impl IntoIterator<Item = &'m Mask>) -> bool {
        masks.into_iter().any(|mask| !self.shift(mask).is_zero())
    }
}

/// The natural parameters of the points of a polygon: x^k_i is at (i + s)/n^k.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NaturalShift<F = Rational> {
    /// s.
    pub shift: F,
    /// Whether the scheme takes lines to lines. If so, s is the only shift with which it
    /// reproduces lines. Otherwise s is the centre of mass of the basic limit function, or near it.
    pub keeps_lines: bool,
    /// Whether s is only near the centre of mass.
    pub rounded: bool,
    /// s_α, the shift with which rule α alone takes lines to lines.
    pub of_rules: Vec<F>,
}

impl<F: Real + PartialEq + Enclosed> NaturalShift<F> {
    /// The rows of the mask that stand in wrong places, if this is all that is wrong: each with the number of places by which it
    /// belongs further, so that the mask takes lines to lines, and the order of the sum rules is 2 at least.
    ///
    /// Moving a row by k places takes kn/(n − 1) from its s_α. The rows that most others agree with stay where they are.
    ///
    /// # Panics
    /// Never: a mask has rules.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::limit::natural_shift;
    /// use subcert::scheme::Mask;
    ///
    /// let eighths = |row: [i64; 3]| row.map(|p| Rational::new(p, 8)).to_vec();
    /// let moved = Mask::new(vec![eighths([1, 6, 1]), eighths([4, 4, 0])], 0)?;
    /// assert_eq!(natural_shift(&moved).misplaced(), [(1, 1)]);
    /// let right = Mask::new(vec![eighths([1, 6, 1]), eighths([0, 4, 4])], 0)?;
    /// assert!(natural_shift(&right).misplaced().is_empty());
    /// # Ok::<(), subcert::scheme::MaskError>(())
    /// ```
    #[must_use]
    pub fn misplaced(&self) -> Vec<(usize, i64)> {
        let n = Rational::from(self.of_rules.len());
        let alike = |shift: &F| self.of_rules.iter().filter(|other| *other == shift).count();
        let most = self.of_rules.iter().rev().max_by_key(|shift| alike(shift));
        let own = most.expect("a mask has rules");
        let scale = F::from_rational(&((&n - Rational::one()) / n));
        let places = |shift: &F| {
            let places = shift.minus(own).times(&scale).enclosure(0);
            let whole = places.lower() == places.upper() && places.lower().is_integer();
            places.lower().numerator().to_i64().filter(|_| whole)
        };
        let places: Option<Vec<i64>> = self.of_rules.iter().map(places).collect();
        let moved = places.unwrap_or_default().into_iter().enumerate();
        moved.filter(|(_, places)| *places != 0).collect()
    }
}

/// Where s is rounded, it is a multiple of 1/((n − 1)n^m) for the least n^m above this number. Then
/// its n-adic digits repeat soon.
const PARTS: usize = 1 << 10;

/// The most n-adic digits, up to the end of the first period, of a mean that is not rounded.
const MAX_DIGITS: usize = 16;

/// The natural shift s of a scheme.
///
/// With m_α = Σ_j j a_{α,j} and s_α = (α − n(m_α + o))/(n − 1), the scheme takes lines to lines if
/// and only if all s_α are one number, which is s. Otherwise s is their mean; where this is
/// irrational, or its n-adic digits do not repeat within the first 16, it is rounded, with an error
/// below 1/2000.
///
/// Source: `proofs/THEOREMS.md`, 80 and 87.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::limit::natural_shift;
/// use subcert::scheme::parse_scheme;
///
/// let chaikin = natural_shift(parse_scheme("chaikin")?.masks()[0]);
/// assert_eq!((chaikin.shift, chaikin.keeps_lines), (Rational::new(-1, 2), true));
/// let cubic = natural_shift(parse_scheme("b-spline:degree=3")?.masks()[0]);
/// assert!(cubic.shift.is_zero());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn natural_shift<F: Real + PartialEq + Enclosed>(mask: &Mask<F>) -> NaturalShift<F> {
    let number = |x: Rational| F::from_rational(&x);
    let n = Rational::from(mask.arity());
    let shifts = rule_shifts(mask);
    let keeps_lines = shifts.iter().all(|shift| *shift == shifts[0]);
    let mean = F::total(&shifts).times(&number(n.recip()));
    let enclosure = mean.enclosure(0);
    let is_rational = enclosure.lower() == enclosure.upper();
    if keeps_lines || is_rational && repeats_soon(enclosure.lower(), &n) {
        return NaturalShift { shift: mean, keeps_lines, rounded: false, of_rules: shifts };
    }
    let power = mask.arity().pow(PARTS.ilog(mask.arity()) + 1);
    let parts = Rational::from(power) * (&n - Rational::one());
    let scaled = mean.times(&number(parts.clone())).plus(&number(Rational::new(1, 2)));
    let nearest = scaled.step(Rational::floor);
    let shift = number(Rational::from(nearest) / parts);
    NaturalShift { shift, keeps_lines, rounded: true, of_rules: shifts }
}

/// s_α = (α − n(m_α + o))/(n − 1) with m_α = Σ_j j a_{α,j}, for each rule α.
pub(crate) fn rule_shifts<F: Scalar>(mask: &Mask<F>) -> Vec<F> {
    let number = |x: Rational| F::from_rational(&x);
    let n = Rational::from(mask.arity());
    let shift = |(alpha, row): (usize, &Vec<F>)| {
        let weighted = row.iter().enumerate().map(|(j, entry)| entry.times(&number(j.into())));
        let offset = number(Rational::from(mask.offset()));
        let mean = weighted.fold(offset, |sum, term| sum.plus(&term));
        let rest = number(Rational::from(alpha)).minus(&number(n.clone()).times(&mean));
        rest.times(&number((&n - Rational::one()).recip()))
    };
    mask.rules().rows().iter().enumerate().map(shift).collect()
}

/// Whether the n-adic digits of a number repeat within [`MAX_DIGITS`].
fn repeats_soon(x: &Rational, n: &Rational) -> bool {
    let mut met = Vec::new();
    let mut rest = x - Rational::from(x.floor());
    while met.len() <= MAX_DIGITS {
        if met.contains(&rest) {
            return true;
        }
        let next = &rest * n;
        met.push(rest);
        rest = &next - Rational::from(next.floor());
    }
    false
}
