//! What shows that a bound is exceeded.

use crate::claim::Quantity;
use crate::exact::{Rational, RealCyclotomic};
use crate::limit::{ExtremalPolygon, Overshoot};

/// Control data of spread 1 and a place where a quantity is greater than claimed.
#[derive(Clone, Debug, PartialEq)]
pub struct Violation {
    /// What is bounded.
    pub quantity: Quantity,
    /// k.
    pub level: u32,
    /// The control data, and where they attain the value.
    pub attained: Attained,
    /// What the theorem says that the value is at most, for β = 1.
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
    /// What the theorem says that the quantity is at most, for β = 1.
    pub bound: RealCyclotomic,
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
    /// A piece of a control net, row by row; every other point is where the nearest one
    /// of the piece is.
    Net {
        /// The indices of the first point.
        first: [i64; 2],
        /// The rows.
        rows: Vec<Vec<i64>>,
    },
    /// Points by their names.
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
    /// The step to the point of a net of these indices, at level k + 1.
    Points([i64; 2]),
    /// The difference of a net at the point of these indices of level k, along the first
    /// or the second index (0 or 1).
    Along([i64; 2], usize),
    /// At a point of this name.
    Named(String),
    /// At the edge between the points of these names.
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
