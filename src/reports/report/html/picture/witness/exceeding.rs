//! Control data of spread 1 and a place, where a quantity is greater than it is said to be.

use crate::audit::{Attained, Broken, Violation};
use crate::claim::Quantity;
use crate::exact::{RealCyclotomic, format::short};

/// From this distance on, it is seen beside control points that differ by 1.
pub(super) const SEEN: f64 = 0.03;

/// Data that exceed a bound.
pub(crate) struct Exceeding<'v> {
    pub(crate) quantity: Quantity,
    pub(crate) level: u32,
    pub(crate) attained: &'v Attained,
    /// What it is said to be at most.
    pub(crate) most: RealCyclotomic,
    /// By whom: `claimed` or `wanted`.
    pub(crate) said: &'static str,
    /// The points are compared with the limit at (i + s)/n^k, and of a net at (j + t)/m^k.
    pub(crate) shift: [f64; 2],
}

impl<'v> Exceeding<'v> {
    /// What refutes a theorem.
    pub(crate) fn of_theorem(violation: &'v Violation) -> Exceeding<'v> {
        let Violation { quantity, level, attained, bound } = violation;
        let (quantity, level, most) = (*quantity, *level, bound.clone());
        Exceeding { quantity, level, attained, most, said: "claimed", shift: [0.0; 2] }
    }

    /// What breaks a promise, divided by the spread.
    pub(crate) fn of_promise(broken: &'v Broken) -> Exceeding<'v> {
        let Broken { attained, spread, level, most, .. } = broken;
        let most = (most / spread).into();
        let quantity = Quantity::Distance;
        Exceeding { quantity, level: *level, attained, most, said: "claimed", shift: [0.0; 2] }
    }

    /// What a picture of them shows, in words; `data` is what they are, and `other` what level k is compared
    /// with.
    pub(super) fn says(&self, data: &str, other: &str) -> String {
        let (found, most) = (short(&self.attained.value, 6), short(&self.most, 6));
        let apart = if self.quantity == Quantity::Difference {
            format!("The two marked points of level {} differ by {found}", self.level)
        } else {
            format!("At the marked place they are {found} apart")
        };
        format!(
            "Control {data} of spread 1, level {} and {other}. {apart}, and at most {most} is {}.",
            self.level, self.said
        )
    }
}
