//! Polygons that are far from their limit at a high level, found level by level.

use crate::exact::{Integer, Rational};
use crate::limit::error::{LimitError, MAX_LEVEL};
use crate::limit::functional::ExtremalPolygon;
use crate::limit::row::{Refinement, Row};
use crate::limit::value::Limit;

/// A polygon, and a parameter at which it is far from its limit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FarPolygon {
    /// The polygon, of integers whose neighbours differ by 1.
    pub polygon: ExtremalPolygon,
    /// t.
    pub parameter: Rational,
    /// |P^∞(t) − P^k(t)|.
    pub distance: Rational,
}

/// A parameter t, with P^∞(t) − P^k(t) as a functional of Δ, times a denominator.
struct Place {
    parameter: Rational,
    row: Row,
    denominator: Integer,
    norm: Rational,
}

impl Place {
    fn new(parameter: Rational, row: Row, denominator: Integer) -> Place {
        let norm = Rational::new(row.norm(), denominator.clone());
        Place { parameter, row, denominator, norm }
    }
}

impl Limit {
    /// A polygon with max|Δ| = 1 that is far from its limit at a level. It need not be
    /// the farthest one: its parameter is sought only near the parameter of the preceding
    /// level.
    ///
    /// From t at level k the places (t + d)/n, d = 0, …, n − 1, and t itself are tried at
    /// level k + 1. P^∞ − P^{k+1} at (t + d)/n is P^∞ − P^k at t + d for the refined
    /// polygon (`proofs/THEOREMS.md`, 4), so each of these values takes one refinement
    /// step.
    ///
    /// # Errors
    /// When the level is above 128.
    ///
    /// # Panics
    /// Never: at least one parameter is tried.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::limit::Limit;
    /// use subcert::scheme::parse_scheme;
    ///
    /// let scheme = parse_scheme("b-spline:degree=3")?;
    /// let far = Limit::new(scheme.masks()[0])?.far_polygon(2)?;
    /// assert_eq!(far.distance, Rational::new(1, 48));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn far_polygon(&self, level: u32) -> Result<FarPolygon, LimitError> {
        self.far_polygon_from(level, &Rational::zero())
    }

    /// As [`Limit::far_polygon`], for the polygons with x^k_i at (i + shift)/n^k.
    ///
    /// # Errors
    /// As [`Limit::far_polygon`], and when the digits of the shift do not repeat soon enough for
    /// [`Limit::at`].
    ///
    /// # Panics
    /// Never: at least one parameter is tried.
    pub fn far_polygon_from(&self, level: u32, shift: &Rational) -> Result<FarPolygon, LimitError> {
        if level > MAX_LEVEL {
            return Err(LimitError::Level(level));
        }
        let refinement = Refinement::of(self.difference());
        let arity = self.mask().arity();
        let at = |level: u32, parameter: Rational| -> Result<Place, LimitError> {
            let (row, denominator) = Row::of(&self.error_from(level, &parameter, shift)?);
            Ok(Place::new(parameter, row, denominator))
        };
        let node = shift.fract();
        let mut best = at(0, node.clone())?;
        for digit in 0..arity {
            best = farther(at(0, &node + Rational::new(digit, arity))?, best);
        }
        for k in 1..=level {
            let mut next = at(k, best.parameter.clone())?;
            let denominator = &best.denominator * refinement.denominator();
            for digit in 0..refinement.arity() {
                let parameter = (&best.parameter + Rational::from(digit)) / Rational::from(arity);
                let row = refinement.pull_back(&best.row, digit);
                next = farther(Place::new(parameter, row, denominator.clone()), next);
            }
            best = next;
        }
        let Place { parameter, row, norm: distance, .. } = best;
        let polygon = row.functional(&Integer::one()).extremal_polygon();
        Ok(FarPolygon { polygon, parameter, distance })
    }
}

/// The place with the greater norm; of equal norms, with the greater parameter.
fn farther(one: Place, other: Place) -> Place {
    if (&one.norm, &one.parameter) > (&other.norm, &other.parameter) { one } else { other }
}
