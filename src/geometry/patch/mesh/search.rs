//! Whether the polygons of a level are within a tolerance of the limit, and how far they are.

use super::piece::{Estimate, LevelPiece};
use crate::exact::{Rational, Scalar as _};
use crate::patch::distance::judge::{Judge, Points};
use crate::patch::distance::surface::PieceSearch;
use crate::patch::place::{Place, Verdict};
use crate::patch::shapes::library::Shapes;
use crate::stop::check;

/// The highest level of pieces.
pub(super) const MAX_PIECE_LEVEL: u32 = 64;

/// The search in one piece of level 1 after another, for the polygons of one level.
pub(crate) struct Search<'a, V: Points, J> {
    shapes: &'a Shapes,
    judge: &'a J,
    /// The level of the polygons.
    level: u32,
    /// How many pieces may still be looked at.
    steps: u64,
    factors: [V::Weight; 2],
}

impl<'a, V: Points, J: Judge<V>> Search<'a, V, J> {
    pub(crate) fn new(shapes: &'a Shapes, judge: &'a J, level: u32, steps: u64) -> Self {
        // (1 − u)³ + u³ is from 1/4 to 1, and (1/2 − u)²·4 from 0 to 1.
        let least = Rational::new(i64::from(shapes.scheme.is_cubic()), 4);
        let factors = [Rational::one(), least].map(|x| V::Weight::from_rational(&x));
        Search { shapes, judge, level, steps, factors }
    }

    /// An upper bound of the distance on a piece of this level or an earlier one, a sharper one where the
    /// first is above the threshold.
    fn bound(&self, cell: &LevelPiece<V>, size: f64, threshold: f64) -> f64 {
        let later = self.level - cell.level;
        let bound = self.shapes.get(cell.shape).bound(size, later);
        if bound <= threshold {
            return bound;
        }
        let sharp = cell.sharp_bound(self.shapes, self.judge, later, &self.factors);
        sharp.map_or(bound, |sharp| bound.min(sharp))
    }

    /// A piece with its size, if the polygons of the level are not yet linear or bilinear on it.
    fn sized(&self, cell: LevelPiece<V>) -> (f64, LevelPiece<V>) {
        let size = if cell.base.is_none() { cell.size(self.shapes, self.judge) } else { 0.0 };
        (size, cell)
    }

    /// Puts the parts of a piece with their sizes on a stack, the greatest last. Where all but one are
    /// within the threshold, only that one: the result is a bound for those that are left out.
    fn divide(
        &self,
        cell: &LevelPiece<V>,
        size: f64,
        threshold: f64,
        stack: &mut Vec<(f64, LevelPiece<V>)>,
    ) -> f64 {
        if cell.base.is_none() {
            let shape = self.shapes.get(cell.shape);
            let others = shape.others(size, self.level - cell.level);
            if let Some((part, bound)) = others.filter(|(_, bound)| *bound <= threshold) {
                stack.push(self.sized(cell.part(self.shapes, part)));
                return bound;
            }
        }
        let across = cell.parts_across(self.shapes, self.judge);
        let parts =
            across.unwrap_or_else(|| cell.parts(self.shapes, cell.level == self.level)).into_iter();
        let mut parts: Vec<(f64, LevelPiece<V>)> = parts.map(|part| self.sized(part)).collect();
        parts.sort_by(|left, right| left.0.total_cmp(&right.0));
        stack.extend(parts);
        0.0
    }
}

fn place<V>(cell: &LevelPiece<V>, known: Estimate<V>) -> Place<u128, V> {
    let Estimate { limit, polygon, .. } = known;
    Place { level: cell.level, at: cell.path, limit, polygon }
}

/// Where a place is is the path to its piece.
impl<V: Points, J: Judge<V>> PieceSearch<LevelPiece<V>, Place<u128, V>> for Search<'_, V, J> {
    fn left(&self) -> u64 {
        self.steps
    }

    fn examine(&mut self, piece: LevelPiece<V>) -> Verdict<Place<u128, V>> {
        let mut open = false;
        let tolerance = self.judge.tolerance();
        if tolerance < self.judge.floor() {
            return Verdict::Open;
        }
        let mut stack = vec![self.sized(piece)];
        while let Some((size, mut cell)) = stack.pop() {
            check();
            if self.steps == 0 {
                return Verdict::Open;
            }
            self.steps = self.steps.saturating_sub(cell.work());
            if cell.base.is_none() {
                if self.bound(&cell, size, tolerance) <= tolerance {
                    continue;
                }
                let begun = (cell.level == self.level).then(|| cell.begun(self.shapes)).flatten();
                let Some(begun) = begun else {
                    self.divide(&cell, size, tolerance, &mut stack);
                    continue;
                };
                cell = begun;
            }
            match cell.known(self.shapes, self.judge) {
                Some(known) if known.beyond => return Verdict::Beyond(place(&cell, known)),
                Some(known) if known.within => {}
                _ if cell.level >= MAX_PIECE_LEVEL.min(self.level + EXTRA_LEVELS) => open = true,
                _ => {
                    self.divide(&cell, size, tolerance, &mut stack);
                }
            }
        }
        if open { Verdict::Open } else { Verdict::Within }
    }

    fn measure(
        &mut self,
        piece: LevelPiece<V>,
        width: f64,
        best: &mut f64,
        at: &mut Option<Place<u128, V>>,
    ) -> f64 {
        let mut upper = 0.0_f64;
        let mut stack = vec![self.sized(piece)];
        while let Some((size, mut cell)) = stack.pop() {
            check();
            let enough = (*best * (1.0 + width)).max(self.judge.floor());
            let stop = self.steps == 0 || cell.level >= MAX_PIECE_LEVEL;
            self.steps = self.steps.saturating_sub(cell.work());
            if cell.base.is_none() {
                let bound = self.bound(&cell, size, enough);
                if bound <= enough || stop {
                    upper = upper.max(bound);
                    continue;
                }
                let begun = (cell.level == self.level).then(|| cell.begun(self.shapes)).flatten();
                let Some(begun) = begun else {
                    upper = upper.max(self.divide(&cell, size, enough, &mut stack));
                    continue;
                };
                cell = begun;
            }
            let Some(known) = cell.known(self.shapes, self.judge) else { continue };
            let bound = known.upper;
            if known.lower > *best {
                *best = known.lower;
                *at = Some(place(&cell, known));
            }
            if bound <= enough.max(*best * (1.0 + width)) || stop {
                upper = upper.max(bound);
            } else {
                self.divide(&cell, size, enough, &mut stack);
            }
        }
        upper
    }
}

/// How many levels after that of the polygons pieces are divided.
const EXTRA_LEVELS: u32 = 30;
