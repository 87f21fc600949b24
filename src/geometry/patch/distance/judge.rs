//! Lengths against a tolerance: in f64 with a bound of all rounding errors, or exactly.

use crate::exact::{Enclosed, Rational, RealCyclotomic, Scalar};
use crate::float::{lower, upper};
use crate::mesh::Point;
use crate::patch::number::Vector;
use crate::patch::shapes::rules::Rules;
use crate::patch::shapes::shape::Shape;

/// Points of one kind, and the weights of shapes for them.
pub(crate) trait Points: Vector {
    fn rules(shape: &Shape) -> &Rules<Self::Weight>;
}

impl Points for Point<f64> {
    fn rules(shape: &Shape) -> &Rules<f64> {
        &shape.rules
    }
}

impl Points for Point<RealCyclotomic> {
    fn rules(shape: &Shape) -> &Rules<RealCyclotomic> {
        shape.exact()
    }
}

/// Lengths of vectors against a tolerance.
///
/// A vector is a sum of points of a level whose coefficients sum to 0, and their absolute values
/// to 8 at most.
pub(crate) trait Judge<V>: Sync {
    /// |v| is at most this.
    fn above(&self, vector: &V, level: u32) -> f64;
    /// All |v| are at most this.
    fn greatest(&self, vectors: impl Iterator<Item = V>, level: u32) -> f64 {
        vectors.map(|vector| self.above(&vector, level)).fold(0.0, f64::max)
    }
    /// |v| is at least this.
    fn below(&self, vector: &V, level: u32) -> f64;
    /// Whether |v| ≤ ε; `None` where that is too near to call.
    fn within(&self, vector: &V, level: u32) -> Option<bool>;
    /// An f64 that is at most ε.
    fn tolerance(&self) -> f64;
    /// A length that cannot be told from 0.
    fn floor(&self) -> f64;
}

/// In f64.
#[derive(Clone, Debug)]
pub(crate) struct Rounded {
    /// ε between two f64.
    tolerance: [f64; 2],
    /// What is added for each level.
    unit: f64,
}

impl Rounded {
    /// For points with coordinates up to `size`, refined by rows of up to `terms` weights: see
    /// `proofs/THEOREMS.md`, 95.
    pub(crate) fn new(tolerance: &Rational, size: f64, terms: usize) -> Rounded {
        let terms = f64::from(u32::try_from(terms + 8).unwrap_or(u32::MAX));
        let unit = 98.0 * terms * size * (f64::EPSILON / 2.0);
        Rounded::with_unit(tolerance, unit)
    }

    /// For lengths that are off by at most (k + 2)·`unit` where they are of points of level k.
    pub(crate) fn with_unit(tolerance: &Rational, unit: f64) -> Rounded {
        Rounded { tolerance: [lower(tolerance), upper(tolerance)], unit }
    }

    /// How far a length of points of this level may be off.
    pub(crate) fn slack(&self, level: u32) -> f64 {
        self.unit * f64::from(level + 2)
    }
}

fn squared([x, y, z]: &Point<f64>) -> f64 {
    x * x + y * y + z * z
}

impl Judge<Point<f64>> for Rounded {
    fn above(&self, vector: &Point<f64>, level: u32) -> f64 {
        squared(vector).sqrt() + self.slack(level)
    }
    fn greatest(&self, vectors: impl Iterator<Item = Point<f64>>, level: u32) -> f64 {
        // One root for all.
        let square = vectors.map(|vector| squared(&vector)).fold(0.0, f64::max);
        square.sqrt() + self.slack(level)
    }
    fn below(&self, vector: &Point<f64>, level: u32) -> f64 {
        (squared(vector).sqrt() - self.slack(level)).max(0.0)
    }
    fn within(&self, vector: &Point<f64>, level: u32) -> Option<bool> {
        if self.above(vector, level) <= self.tolerance[0] {
            Some(true)
        } else if self.below(vector, level) > self.tolerance[1] {
            Some(false)
        } else {
            None
        }
    }
    fn tolerance(&self) -> f64 {
        self.tolerance[0]
    }
    fn floor(&self) -> f64 {
        // That of a difference at the highest level of pieces, and a little more.
        self.slack(80)
    }
}

/// Exactly.
pub(crate) struct Exactly<S> {
    /// ε².
    square: S,
    /// An f64 that is at most ε.
    tolerance: f64,
}

impl<S: Scalar> Exactly<S> {
    pub(crate) fn new(tolerance: &Rational) -> Exactly<S> {
        let square = S::from_rational(&(tolerance * tolerance));
        Exactly { square, tolerance: lower(tolerance) }
    }
}

fn square<S: Scalar>(vector: &Point<S>) -> S {
    vector.iter().fold(S::zero(), |sum, x| sum.plus(&x.times(x)))
}

impl<S: Scalar + Enclosed + Ord + Sync> Judge<Point<S>> for Exactly<S> {
    fn above(&self, vector: &Point<S>, _: u32) -> f64 {
        f64::from_bits(square(vector).step(|x| upper(x).to_bits())).sqrt().next_up()
    }
    fn below(&self, vector: &Point<S>, _: u32) -> f64 {
        let square = f64::from_bits(square(vector).step(|x| lower(x).max(0.0).to_bits()));
        square.sqrt().next_down().max(0.0)
    }
    fn within(&self, vector: &Point<S>, _: u32) -> Option<bool> {
        Some(square(vector) <= self.square)
    }
    fn tolerance(&self) -> f64 {
        self.tolerance
    }
    fn floor(&self) -> f64 {
        0.0
    }
}
