//! The moments of the rows m levels below a node.

use super::estimate::Place;
use super::scaled::{PLACES, Scaled};
use crate::exact::{Integer, Rational};

/// An interval that contains the moments Σ_p λ_p p of the rows λ of E^m, for m = 0, 1, 2,
/// …: \[middle − radius, middle + 1 − n^{−m} + radius\].
///
/// Source: `proofs/THEOREMS.md`, 61.
#[derive(Clone, Debug)]
pub(super) struct Moments {
    middle: Rational,
    radius: Rational,
    /// n^{−m}.
    part: Rational,
}

impl Moments {
    /// The interval for E^0.
    pub(super) fn start() -> Moments {
        Moments { middle: Rational::zero(), radius: Rational::zero(), part: Rational::one() }
    }

    /// Advances from E^m to E^{m+1}, where τ ≥ ‖E^m‖.
    pub(super) fn advance(
        &mut self,
        arity: usize,
        [middle, radius]: &[Rational; 2],
        tau: &Rational,
    ) {
        let nth = Rational::new(1, arity);
        self.middle = &self.middle * &nth + middle;
        self.radius = rounded_up(&(&self.radius * &nth + radius * tau));
        self.part = &self.part * nth;
    }

    /// The interval, and the radius.
    pub(super) fn ends(&self) -> ([Rational; 2], &Rational) {
        let length = Rational::one() - &self.part;
        ([&self.middle - &self.radius, &self.middle + length + &self.radius], &self.radius)
    }

    /// An interval that contains the intervals for all m ≥ 1, if ‖E^m‖ ≤ τ for every m.
    pub(super) fn hull(
        arity: usize,
        [middle, radius]: &[Rational; 2],
        tau: &Rational,
    ) -> [Rational; 2] {
        let whole = Rational::new(arity, arity - 1);
        let (limit, radius) = (middle * &whole, radius * whole * tau);
        let low = middle.min(&limit) - &radius;
        // The upper end is affine in n^{−m}, which has the maximum 1/n and the infimum 0.
        let high = (middle - Rational::new(1, arity)).max(limit) + Rational::one() + radius;
        [low, high]
    }
}

/// x rounded up to PLACES binary digits after the point.
pub(super) fn rounded_up(x: &Rational) -> Rational {
    let unit = Integer::one().shifted_left(PLACES);
    Rational::new(scaled(x, &unit).ceil(), unit)
}

fn scaled(x: &Rational, unit: &Integer) -> Rational {
    x * Rational::from(unit.clone())
}

/// The data for bounds by a line, from the interval \[low, high\] of the moments and its
/// radius, `power` = q^m, and τ ≥ ‖E^m‖. `None` if the window has fewer than two rows, or
/// the interval is too far from it.
pub(super) fn place(
    operator: &Scaled,
    ([low, high], radius): (&[Rational; 2], &Rational),
    power: &Integer,
    tau: &Rational,
) -> Option<Place<Integer>> {
    let last = operator.first + i64::try_from(operator.size).ok()? - 2;
    if last < operator.first {
        return None;
    }
    let middle = ((low + high) / Rational::from(2)).floor().to_i64()?;
    let base = middle.clamp(operator.first, last);
    let [low, high] = [low, high].map(|end| end - Rational::from(base));
    let (coarse, unit) = (Integer::one().shifted_left(PLACES), power * &operator.fraction);
    let exact = [scaled(&low, &unit), scaled(&high, &unit)];
    let fine = [exact[0].floor(), exact[1].ceil()];
    let [below, above] = &exact;
    let rounded = below - Rational::from(fine[0].clone()) + Rational::from(fine[1].clone()) - above;
    Place::new(
        usize::try_from(base - operator.first).ok()?,
        [scaled(&low, &coarse).floor().to_i64()?, scaled(&high, &coarse).ceil().to_i64()?],
        fine,
        (scaled(&(radius * Rational::from(2)), &unit) + rounded).ceil(),
        scaled(tau, &unit).ceil(),
        unit,
    )
}
