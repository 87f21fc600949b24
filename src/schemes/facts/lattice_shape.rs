//! What is drawn of a mask on Z^d: values of its basic limit function.

use crate::exact::Rational;
use crate::lattice::limit_values;
use crate::scheme::{Dilation, LatticeMask, Point};
use std::collections::BTreeMap;

/// The least number of values that are drawn, where a cap does not stop it.
const MIN_VALUES: usize = 700;

/// The most levels.
const MAX_LEVEL: u32 = 8;

/// Values of the basic limit function on a plane lattice.
#[derive(Clone, Debug)]
pub struct LatticeShape {
    /// M.
    pub dilation: Dilation,
    /// k.
    pub level: u32,
    /// φ(M^{−k}α), where it is not 0, by α; of a mask of three variables for the α with one third coordinate.
    pub values: BTreeMap<Point, Rational>,
    /// This third coordinate; `None` in the plane.
    pub slice: Option<i64>,
}

impl LatticeShape {
    /// The values of a mask whose scheme converges, or why there are none.
    ///
    /// # Errors
    /// When a cap is met, or a plane through the middle is no sublattice.
    ///
    /// # Panics
    /// Never.
    pub fn of(mask: &LatticeMask) -> Result<LatticeShape, String> {
        let none = || "φ has no values at the integers".to_owned();
        let values = |level| limit_values(mask, level).map_err(|cap| cap.to_string());
        let dilation = mask.dilation().clone();
        if mask.dimension() == 3 && dilation.diagonal().is_none() {
            return Err("M is not diagonal, and planes are not kept".to_owned());
        }
        let mut found = values(0)?.ok_or_else(none)?;
        let (mut level, mut slice) = (0, middle(mask, &found));
        while cut(&found, slice).len() < MIN_VALUES && level < MAX_LEVEL {
            let Ok(next) = values(level + 1) else { break };
            level += 1;
            found = next.ok_or_else(none)?;
            slice = middle(mask, &found);
        }
        let values = cut(&found, slice);
        Ok(LatticeShape { dilation, level, values, slice })
    }
}

/// The third coordinate in the middle of the support, of a mask of three variables.
fn middle(mask: &LatticeMask, values: &BTreeMap<Point, Rational>) -> Option<i64> {
    let heights = || values.keys().map(|place| place[2]);
    let (low, high) = heights().min().zip(heights().max())?;
    (mask.dimension() == 3).then_some((low + high).div_euclid(2))
}

fn cut(values: &BTreeMap<Point, Rational>, slice: Option<i64>) -> BTreeMap<Point, Rational> {
    let kept = values.iter().filter(|(place, _)| slice.is_none_or(|z| place[2] == z));
    kept.map(|(place, value)| (*place, value.clone())).collect()
}
