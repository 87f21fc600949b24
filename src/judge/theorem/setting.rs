//! Where a theorem is tried: a scheme with the exact suprema of what theorems bound.

use crate::claim::Quantity;
use crate::exact::{RealCyclotomic, comparable};
use crate::finding::{Attained, LevelEvidence, Supremum};
use crate::limit::{Comparison, Later, Overshoot};

/// The suprema of a scheme, over all control data of spread 1, at level k.
///
/// Errors are texts that say why the program gives no answer.
pub(crate) trait Setting {
    /// Compares a supremum with a bound; what exceeds it is a value that is attained.
    fn compare(
        &self,
        quantity: Quantity,
        level: u32,
        bound: &RealCyclotomic,
    ) -> Result<Comparison<Attained>, String>;

    /// A supremum, enclosed up to one of so many parts of it.
    fn supremum(&self, quantity: Quantity, level: u32, parts: u32) -> Result<Supremum, String>;

    /// An f such that no supremum of level k + c is more than f times that of level k,
    /// for every k: T_c.
    fn factor(&self, c: u32) -> Result<RealCyclotomic, String>;

    /// What shows that the suprema of these levels are at most these numbers, or why there is nothing
    /// that certificates have words for.
    fn evidence(
        &self,
        quantity: Quantity,
        bounds: &[(u32, RealCyclotomic)],
    ) -> Result<LevelEvidence, String>;

    /// The sound block bound of the distance.
    fn sound(&self, level: u32) -> Option<RealCyclotomic>;

    /// Whether that shows that the distance is within a bound.
    fn soundly_within(&self, level: u32, bound: &RealCyclotomic) -> bool {
        self.sound(level).is_some_and(|sound| comparable(&sound, bound) && sound <= *bound)
    }

    /// How many levels are compared.
    fn levels(&self) -> u32 {
        6
    }

    /// The same scheme, compared with its limit at the offset that serves it best; `None`
    /// where it is already so, or there are no offsets.
    fn centred(&self) -> Option<&dyn Setting>;

    /// The same scheme with the points at their natural parameters; `None` where they are there
    /// already, and for a ring.
    fn natural(&self) -> Option<&dyn Setting>;

    /// The data that are found to exceed most in every shift of the parameter, for a step or a
    /// distance; `None` where there are none, and for a ring.
    fn overshoot(&self, _: Quantity, _: u32) -> Option<Overshoot> {
        None
    }

    /// Of a ring, the weights of its limit.
    fn limit(&self) -> Option<&[RealCyclotomic]> {
        None
    }
}

/// What a level is compared with, in a step or a distance.
pub(crate) fn later(quantity: Quantity) -> Option<Later> {
    match quantity {
        Quantity::Difference => None,
        Quantity::Step => Some(Later::Points),
        Quantity::Distance => Some(Later::Limit),
    }
}
