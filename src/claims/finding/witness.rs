//! Control data that exceed a bound.

use crate::claim::Quantity;
use crate::exact::{Rational, RealCyclotomic};
use crate::limit::{ExtremalPolygon, Overshoot};
use crate::scheme::{LocalRules, Mask};

/// Control data of spread 1 and a place where a quantity is greater than claimed.
#[derive(Clone, Debug, PartialEq)]
pub struct Violation {
    /// What is bounded.
    pub quantity: Quantity,
    /// k.
    pub level: u32,
    /// The control data, and where they attain the value.
    pub attained: Attained,
    /// The theorem's bound of this value, for β = 1.
    pub bound: RealCyclotomic,
}

/// Control data of spread 1 that exceed a bound in every shift of the parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Unshiftable {
    /// What is bounded.
    pub quantity: Quantity,
    /// k.
    pub level: u32,
    /// The data, and the two greatest values whose difference is above the bound.
    pub overshoot: Overshoot,
    /// The theorem's bound of the quantity, for β = 1.
    pub bound: RealCyclotomic,
}

/// What refines control data.
#[derive(Clone, Debug, PartialEq)]
pub enum Refiner {
    /// The mask of a curve, or the masks of both factors of a tensor product, at the offsets at which
    /// they are compared with their limit.
    Masks(Vec<Mask>),
    /// The rules around a vertex or on a face.
    Ring(LocalRules),
}

impl Refiner {
    /// The masks; none of a ring.
    #[must_use]
    pub fn masks(&self) -> &[Mask] {
        match self {
            Refiner::Masks(masks) => masks,
            Refiner::Ring(_) => &[],
        }
    }
}

/// Control data of spread 1, and a value that they attain.
#[derive(Clone, Debug, PartialEq)]
pub struct Attained {
    /// The data.
    pub control: Control,
    /// Where the quantity has the value.
    pub place: Place,
    /// The value.
    pub value: RealCyclotomic,
}

/// Control data of integers, neighbours of which differ by at most 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Control {
    /// A piece of a control polygon.
    Polygon(ExtremalPolygon),
    /// A piece of a control net, row by row; every other point has the value of the nearest point
    /// of the piece.
    Net {
        /// The indices of the first point.
        first: [i64; 2],
        /// The rows.
        rows: Vec<Vec<i64>>,
    },
    /// The points of a ring, each with its name.
    Points(Vec<(String, i64)>),
}

/// Where a quantity has a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// |P^∞(t) − P^k(t)| at this t.
    Parameter(Rational),
    /// |P^∞(s, t) − P^k(s, t)| at these s, t.
    Parameters([Rational; 2]),
    /// |x^{k+1}_i − P^k(i/n^{k+1})| at this i.
    Point(i64),
    /// |x^k_{i+1} − x^k_i| at this i.
    Difference(i64),
    /// |x^{k+1}_{i,j} − P^k(i/n^{k+1}, j/n^{k+1})| at these i, j.
    Points([i64; 2]),
    /// |x^k_{i+1,j} − x^k_{i,j}| at these i, j for the axis 0, and |x^k_{i,j+1} − x^k_{i,j}| for
    /// the axis 1.
    Along([i64; 2], usize),
    /// At the point of a ring with this name.
    Named(String),
    /// At the edge of a ring between the points with these names.
    Edge([String; 2]),
}

/// Bounds of a supremum; the lower one is attained.
#[derive(Clone, Debug, PartialEq)]
pub struct Supremum {
    /// At least this.
    pub lower: RealCyclotomic,
    /// At most this, where anything is known.
    pub upper: Option<RealCyclotomic>,
}
