//! A setting: a scheme with the exact suprema of the quantities that theorems bound.

use crate::claim::Quantity;
use crate::exact::{RealCyclotomic, comparable};
use crate::finding::{Attained, LevelEvidence, Reason, Supremum};
use crate::limit::{Comparison, Later, Overshoot};
use crate::scheme::LocalRules;

/// The suprema of a scheme, over all control data of spread 1, at level k.
///
/// Errors are texts that say why the program gives no answer.
pub(crate) trait Setting {
    /// The rules, if it is a ring.
    fn ring(&self) -> Option<&LocalRules> {
        None
    }

    /// The rules that put the points with which a step of a ring is compared, if not itself.
    fn interpolant(&self) -> Option<&LocalRules> {
        None
    }

    /// Compares a supremum with a bound. If it exceeds the bound, the result has data that attain a
    /// greater value.
    fn compare(
        &self,
        quantity: Quantity,
        level: u32,
        bound: &RealCyclotomic,
    ) -> Result<Comparison<Attained>, Reason>;

    /// An enclosure of a supremum; its width is about 1/`parts` of it.
    fn supremum(&self, quantity: Quantity, level: u32, parts: u32) -> Result<Supremum, Reason>;

    /// An f such that no supremum of level k + c is more than f times that of level k,
    /// for every k: T_c.
    fn factor(&self, c: u32) -> Result<RealCyclotomic, Reason>;

    /// What shows that the suprema of these levels are at most these numbers; the error says why
    /// certificates cannot express it.
    fn evidence(
        &self,
        quantity: Quantity,
        bounds: &[(u32, RealCyclotomic)],
    ) -> Result<LevelEvidence, Reason>;

    /// The sound block bound of the distance.
    fn sound(&self, level: u32) -> Option<RealCyclotomic>;

    /// Whether the sound bound shows that the distance is within a bound.
    fn soundly_within(&self, level: u32, bound: &RealCyclotomic) -> bool {
        self.sound(level).is_some_and(|sound| comparable(&sound, bound) && sound <= *bound)
    }

    /// The number of levels that are compared.
    fn levels(&self) -> u32 {
        6
    }

    /// The scheme compared with its limit at its best offset; `None` if it is at that offset, or if
    /// it has no offsets.
    fn centred(&self) -> Option<&dyn Setting>;

    /// The scheme with the points at their natural parameters; `None` if they are there already,
    /// and for a ring.
    fn natural(&self) -> Option<&dyn Setting>;

    /// The data that exceed most in every shift of the parameter, among those that are tried, for a
    /// step or a distance; `None` if there are none, and for a ring.
    fn overshoot(&self, _: Quantity, _: u32) -> Option<Overshoot> {
        None
    }

    /// The weights of the limit, for a ring.
    fn limit(&self) -> Option<&[RealCyclotomic]> {
        None
    }
}

/// The object with which a level is compared: in a step the next level, in a distance the limit;
/// `None` for a difference.
pub fn later(quantity: Quantity) -> Option<Later> {
    match quantity {
        Quantity::Difference => None,
        Quantity::Step => Some(Later::Points),
        Quantity::Distance => Some(Later::Limit),
    }
}
