//! Whether the net of a level is within a tolerance of the limit on a piece, and how far it is.

use super::super::place::{Place, Verdict};
use super::cell::{Cell, Estimate, bound};
use super::direction::{Direction, Weights};
use crate::mesh::Point;
use crate::patch::distance::judge::Judge;
use crate::patch::distance::surface::PieceSearch;
use crate::stop::check;

/// Node of a cell.
#[derive(Clone, Debug)]
pub(crate) struct Node {
    pub(super) levels: [u32; 2],
    pub(super) index: [i128; 2],
    pub(super) phases: [usize; 2],
    /// Which node of the phase it is in each direction.
    pub(super) number: [usize; 2],
}

/// A cell with a bound of the distance on it, and what is known if the net to compare with is there.
struct Bounded<S> {
    bound: f64,
    cell: Cell<S>,
    known: Option<Estimate<S>>,
}

impl<S: Weights> Bounded<S> {
    fn parts(&self, directions: &[Direction; 2]) -> impl Iterator<Item = Cell<S>> {
        let divided = self.known.as_ref().map_or([true; 2], Estimate::divided);
        self.cell.parts(directions, divided).into_iter()
    }

    /// The place with the greatest lower bound.
    fn place(&self) -> Option<Place<Node, Point<S>>> {
        let (known, base) = (self.known.as_ref()?, self.cell.base.as_ref()?);
        let Cell { levels, index, .. } = self.cell;
        let at = Node { levels, index, phases: base.phases, number: known.nodes };
        let (limit, polygon) = (known.limit.clone(), known.polygon.clone());
        Some(Place { level: self.cell.level(), at, limit, polygon })
    }
}

/// The search in one piece after another, for the net of one level.
pub(super) struct Search<'a, J> {
    pub(super) directions: &'a [Direction; 2],
    pub(super) judge: &'a J,
    /// The level of the net.
    pub(super) level: u32,
    /// The highest level of pieces.
    pub(super) deepest: u32,
    /// How many pieces may still be looked at.
    pub(super) steps: u64,
}

impl<J> Search<'_, J> {
    /// A cell with its bound, which is also one of the whole that it is a part of.
    fn bounded<S: Weights>(&mut self, cell: Cell<S>, whole: f64) -> Bounded<S>
    where
        J: Judge<Point<S>>,
    {
        self.steps = self.steps.saturating_sub(cell.work());
        let (directions, judge) = (self.directions, self.judge);
        let (mut least, mut cell) = (whole, cell);
        if cell.base.is_none() {
            let sizes = cell.sizes(directions, judge);
            least = least.min(bound(directions, sizes, self.level - cell.level()));
            if cell.level() == self.level {
                cell = cell.begun(directions);
            }
        }
        let known = cell.known(directions, judge);
        let bound = known.as_ref().map_or(least, |known| least.min(known.upper));
        Bounded { bound, cell, known }
    }
}

impl<S: Weights, J: Judge<Point<S>>> PieceSearch<Cell<S>, Place<Node, Point<S>>> for Search<'_, J> {
    fn left(&self) -> u64 {
        self.steps
    }

    fn examine(&mut self, piece: Cell<S>) -> Verdict<Place<Node, Point<S>>> {
        let tolerance = self.judge.tolerance();
        if tolerance < self.judge.floor() {
            return Verdict::Open;
        }
        let mut open = false;
        let mut stack = vec![(piece, f64::INFINITY)];
        while let Some((cell, whole)) = stack.pop() {
            check();
            if self.steps == 0 {
                return Verdict::Open;
            }
            let found = self.bounded(cell, whole);
            if let (Some(true), Some(place)) =
                (found.known.as_ref().map(|known| known.beyond), found.place())
            {
                return Verdict::Beyond(place);
            }
            let within = found.known.as_ref().is_some_and(|known| known.within);
            if within || found.bound <= tolerance {
                continue;
            }
            if found.cell.level() >= self.deepest {
                open = true;
                continue;
            }
            stack.extend(found.parts(self.directions).map(|part| (part, found.bound)));
        }
        if open { Verdict::Open } else { Verdict::Within }
    }

    fn measure(
        &mut self,
        piece: Cell<S>,
        width: f64,
        best: &mut f64,
        place: &mut Option<Place<Node, Point<S>>>,
    ) -> f64 {
        let mut upper = 0.0_f64;
        let mut stack = Vec::new();
        let mut next = vec![(piece, f64::INFINITY)];
        loop {
            let mut parts: Vec<Bounded<S>> = Vec::with_capacity(next.len());
            for (cell, whole) in next.drain(..) {
                let part = self.bounded(cell, whole);
                if let Some(known) = part.known.as_ref().filter(|known| known.lower > *best) {
                    *best = known.lower;
                    *place = part.place();
                }
                parts.push(part);
            }
            parts.sort_by(|left, right| left.bound.total_cmp(&right.bound));
            stack.append(&mut parts);
            let Some(found) = stack.pop() else { return upper };
            let bound = found.bound;
            let enough = (*best * (1.0 + width)).max(self.judge.floor());
            if bound <= enough || self.steps == 0 || found.cell.level() >= self.deepest {
                upper = upper.max(bound);
            } else {
                next.extend(found.parts(self.directions).map(|part| (part, bound)));
            }
        }
    }
}
