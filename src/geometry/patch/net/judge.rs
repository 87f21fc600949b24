//! Exact lengths against a tolerance.

use super::super::judge::Judge;
use crate::exact::Rational;
use crate::float::{lower, upper};
use crate::mesh::Point;

/// Exactly.
pub(super) struct Exactly {
    /// ε².
    square: Rational,
    /// An f64 that is at most ε.
    tolerance: f64,
}

impl Exactly {
    pub(super) fn new(tolerance: &Rational) -> Exactly {
        Exactly { square: tolerance * tolerance, tolerance: lower(tolerance) }
    }
}

fn square(vector: &Point<Rational>) -> Rational {
    vector.iter().map(|x| x * x).sum()
}

impl Judge<Point<Rational>> for Exactly {
    fn above(&self, vector: &Point<Rational>, _: u32) -> f64 {
        upper(&square(vector)).sqrt().next_up()
    }
    fn below(&self, vector: &Point<Rational>, _: u32) -> f64 {
        lower(&square(vector)).max(0.0).sqrt().next_down().max(0.0)
    }
    fn within(&self, vector: &Point<Rational>, _: u32) -> Option<bool> {
        Some(square(vector) <= self.square)
    }
    fn tolerance(&self) -> f64 {
        self.tolerance
    }
    fn floor(&self) -> f64 {
        0.0
    }
}
