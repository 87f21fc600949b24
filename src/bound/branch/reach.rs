//! What is known of the rows m levels below a node.

use super::estimate::{PLACES, Place, Rounded};
use super::scaled::Scaled;
use crate::exact::{Integer, Rational};

/// Where the moments Σ_p λ_p p of the rows λ of E^m lie, m = 0, 1, 2, …: from the middle of
/// their interval less the radius to the middle plus 1 − n^{−m} plus the radius.
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
    /// Of E^0.
    pub(super) fn start() -> Moments {
        Moments { middle: Rational::zero(), radius: Rational::zero(), part: Rational::one() }
    }

    /// From E^m to E^{m+1}; τ ≥ ‖E^m‖.
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

    /// The interval.
    pub(super) fn ends(&self) -> [Rational; 2] {
        let length = Rational::one() - &self.part;
        [&self.middle - &self.radius, &self.middle + length + &self.radius]
    }

    /// An interval that holds those of all m ≥ 1, if every ‖E^m‖ ≤ τ.
    pub(super) fn hull(
        arity: usize,
        [middle, radius]: &[Rational; 2],
        tau: &Rational,
    ) -> [Rational; 2] {
        let whole = Rational::new(arity, arity - 1);
        let (limit, radius) = (middle * &whole, radius * whole * tau);
        let low = middle.min(&limit) - &radius;
        // The upper end is affine in n^{−m}, of which the greatest is 1/n and the infimum 0.
        let high = (middle - Rational::new(1, arity)).max(limit) + Rational::one() + radius;
        [low, high]
    }
}

/// The least number with PLACES binary digits behind the point that is not below this.
pub(super) fn rounded_up(x: &Rational) -> Rational {
    Rational::new(scaled(x, PLACES).ceil(), Integer::one().shifted_left(PLACES))
}

fn scaled(x: &Rational, places: u32) -> Rational {
    x * Rational::from(Integer::one().shifted_left(places))
}

/// The line and the bounds for moments in this interval, in so many binary digits, and
/// ‖E^m‖ ≤ τ; `None` if the window has no two rows, or the interval is too far away.
pub(super) fn place(
    operator: &Scaled,
    [low, high]: &[Rational; 2],
    places: u32,
    tau: &Rational,
) -> Option<Place> {
    let last = operator.first + i64::try_from(operator.size).ok()? - 2;
    if last < operator.first {
        return None;
    }
    let middle = ((low + high) / Rational::from(2)).floor().to_i64()?;
    let base = middle.clamp(operator.first, last);
    let from_base = |end: &Rational, places| scaled(&(end - Rational::from(base)), places);
    let low = Rounded {
        coarse: from_base(low, PLACES).floor().to_i64()?,
        fine: from_base(low, places).floor(),
        places,
    };
    let high = Rounded {
        coarse: from_base(high, PLACES).ceil().to_i64()?,
        fine: from_base(high, places).ceil(),
        places,
    };
    let base = usize::try_from(base - operator.first).ok()?;
    Place::new(base, [low, high], scaled(tau, PLACES).ceil())
}
