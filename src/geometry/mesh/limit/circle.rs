//! Sums with cosines over the points around a vertex or a face.

use super::super::point::{Point, combination};
use crate::exact::{Rational, RealCyclotomic};

/// Σ cos(2πi/n) x_i and Σ cos(2π(i − 1)/n) x_i over n points around a vertex or a face.
///
/// Their cross product is sin(2π/n) times that of the sums with cosines and with sines.
pub(super) fn circular(points: &[&Point<RealCyclotomic>]) -> [Point<RealCyclotomic>; 2] {
    let cosines: Vec<RealCyclotomic> = (0..points.len()).map(|i| cosine(i, points.len())).collect();
    [0, 1].map(|start| {
        let turned = (0..points.len()).map(|i| &cosines[(i + points.len() - start) % points.len()]);
        combination(turned.zip(points.iter().copied()))
    })
}

/// cos(2πi/n), for an n whose field has been checked.
pub(super) fn cosine(i: usize, n: usize) -> RealCyclotomic {
    RealCyclotomic::cosine(&Rational::new(i, n)).expect("a valence within the cap")
}
