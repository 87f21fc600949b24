//! The search for places that are far from the limit: squares are divided until bounds decide.

use super::corners::corners;
use super::levels::{Affine, Levels, Place};
use super::points::{Index, Points, root, square};
use super::square::{Square, Squares};
use super::tail::Tail;
use crate::exact::Rational;
use crate::float::{exact, lower, upper};
use crate::lattice::Between;
use crate::mesh::Point;
use crate::patch::progress::MeshWork;
use std::collections::{BTreeSet, BinaryHeap, HashSet};

/// How many levels after that of the net squares are divided.
const EXTRA_LEVELS: u32 = 16;

/// A distance is looked for until its bounds differ by less than this factor.
const CLOSE: f64 = 1.0 + 1.0 / 1024.0;

/// The limit at a place is taken to be the net of so many levels later.
const LATER: u32 = 8;

/// Points, and how squares of the levels follow each other.
pub(super) struct Search<'n> {
    points: Points<'n>,
    levels: &'n Levels,
    squares: Squares<'n>,
    tail: &'n Tail,
    between: Between,
    /// The faces whose piece of the limit is determined.
    faces: &'n BTreeSet<Index>,
    work: &'n MeshWork,
    /// The natural shift, and φ at integers; none where it has no values.
    shift: &'n Place,
    values: &'n [(Index, Rational)],
    /// From a level back to the one j before.
    back: Vec<Affine>,
    /// The weights of the bound of what is j levels later.
    after: Vec<Vec<f64>>,
}

/// What is known of |P^∞ − P^k| on a square of level n.
struct Known {
    /// The greatest |P^n − P^k|², 0 for n ≤ k.
    apart: Rational,
    /// The same on the faces, and where.
    certain: Rational,
    spot: Option<Spot>,
    /// A bound of |P^∞ − P^n|, or of |P^∞ − P^k| for n < k.
    tail: f64,
    /// |P^∞ − P^k|² at a place where the limit is known exactly, and that.
    exact: Option<(Rational, Spot)>,
}

/// A place on a face, and the net of a level there.
#[derive(Clone)]
pub(super) struct Spot {
    pub(super) face: Index,
    /// In the coordinates of level 0.
    pub(super) place: Place,
    pub(super) on_net: Point<Rational>,
    /// The limit there, or the net of a level that stands for it, with the place in the coordinates of this level.
    pub(super) on_limit: Point<Rational>,
    at: Option<(u32, Place)>,
}

/// Whether all squares are within the tolerance.
pub(super) enum Answer {
    Within,
    Beyond(Box<Spot>),
    Open,
}

impl Known {
    fn most(&self) -> f64 {
        let most = root(upper(&self.apart)) + self.tail;
        if most == 0.0 { most } else { most.next_up() }
    }

    /// A lower bound, and where.
    fn least(&self) -> (f64, Option<&Spot>) {
        let below = |square: &Rational| lower(square).sqrt().next_down();
        let nearly = (below(&self.certain) - self.tail).next_down().max(0.0);
        match &self.exact {
            Some((square, spot)) if below(square) > nearly => (below(square), Some(spot)),
            _ => (nearly, self.spot.as_ref()),
        }
    }

    /// Whether it is certainly at most a tolerance, or certainly greater somewhere.
    fn compared(&self, tolerance: &Rational) -> Option<bool> {
        let tail = exact(self.tail)?;
        let (rest, more) = (tolerance - &tail, tolerance + &tail);
        if rest.sign() >= 0 && self.apart <= &rest * &rest {
            return Some(true);
        }
        let exactly =
            self.exact.as_ref().is_some_and(|(square, _)| *square > tolerance * tolerance);
        (exactly || self.certain > &more * &more).then_some(false)
    }
}

impl<'n> Search<'n> {
    pub(super) fn new(
        points: Points<'n>,
        (levels, tail): (&'n Levels, &'n Tail),
        (shift, values): (&'n Place, &'n [(Index, Rational)]),
        between: Between,
        faces: &'n BTreeSet<Index>,
        work: &'n MeshWork,
    ) -> Search<'n> {
        let (squares, back, after) = (Squares::new(levels), Vec::new(), Vec::new());
        Search { points, levels, squares, tail, between, faces, work, shift, values, back, after }
    }

    /// A bound of |P^∞ − P^j| on a face, for all j from a level on; infinite where it is not in f64.
    pub(super) fn bound(&mut self, face: Index, level: u32) -> f64 {
        self.later(&Squares::root(face), level).unwrap_or(f64::INFINITY)
    }

    fn later(&mut self, square: &Square, after: u32) -> Option<f64> {
        let low = self.squares.low(square);
        let around = [0, 1].map(|i| {
            let [before, behind] = &self.levels.reach[i];
            [&low[i] + before, &low[i] + &Rational::one() + behind]
        });
        let differences = self.points.differences(square.level, &around)?;
        for next in (0..=after).skip(self.after.len()) {
            self.after.push(self.tail.after(next));
        }
        let terms = self.after[after as usize].iter().zip(differences);
        let nonzero = terms.filter(|(_, length)| *length > 0.0);
        Some(
            nonzero.fold(0.0, |sum: f64, (weight, length)| {
                (sum + (weight * length).next_up()).next_up()
            }),
        )
    }

    fn back(&mut self, count: u32) -> Affine {
        for next in (0..=count).skip(self.back.len()) {
            self.back.push(self.levels.back(next));
        }
        self.back[count as usize].clone()
    }

    /// `None` where points are not determined.
    fn known(&mut self, at: &Square, level: u32) -> Option<Known> {
        let tail = self.later(at, level.saturating_sub(at.level))?;
        let (apart, certain) = (Rational::zero(), Rational::zero());
        let exact = self.exactly(at, level);
        let mut known = Known { apart, certain, spot: None, tail, exact };
        let later = at.level.saturating_sub(level);
        if later == 0 {
            return Some(known);
        }
        let (back, first) = (self.back(later), self.back(at.level));
        let all = corners(&self.squares.low(at), &[&Affine::identity(), &back], self.between);
        for corner in all {
            let on_limit = self.points.at(at.level, &corner)?;
            let on_net = self.points.at(level, &back.at(&corner))?;
            let apart = square(&[0, 1, 2].map(|c| &on_limit[c] - &on_net[c]));
            if apart > known.certain
                && let place = first.at(&corner)
                && let Some(face) = self.face(&place, at.root)
            {
                known.certain = apart.clone();
                let at = Some((at.level, corner));
                known.spot = Some(Spot { face, place, on_net, on_limit, at });
            }
            if apart > known.apart {
                known.apart = apart;
            }
        }
        Some(known)
    }

    /// The greater |P^∞ − P^k|² at two places y = α − τ near the middle of a square, α a point of level k or a later one, and one that is new after level k.
    /// There P^∞ = Σ_β φ(β) p_{α−β}.
    fn exactly(&mut self, at: &Square, level: u32) -> Option<(Rational, Spot)> {
        let (old, new) = (at.level.max(level), at.level.max(level + 1));
        let found = [self.near(at, old), self.near(at, new - 1).map(|at| self.points.new_near(at))];
        let spots = [(old, found[0]), (new, found[1])];
        let spots = spots.map(|(later, index)| self.spot(at, level, (later, index?)));
        spots.into_iter().flatten().max_by(|(a, _), (b, _)| a.cmp(b))
    }

    /// The point of a level that is near the middle of a square.
    fn near(&mut self, at: &Square, level: u32) -> Option<Index> {
        let half = Rational::new(1, 2);
        let middle = self.squares.low(at).map(|x| x + &half);
        let middle = match level.checked_sub(at.level) {
            Some(count) => self.levels.forth(count).at(&middle),
            None => self.back(at.level - level).at(&middle),
        };
        let near = [0, 1].map(|i| (&middle[i] + &self.shift[i]).floor());
        Some([near[0].to_i64()?, near[1].to_i64()?])
    }

    /// |P^∞ − P^k|² at the place of a point of a later level, if that is on a face.
    fn spot(
        &mut self,
        at: &Square,
        level: u32,
        (later, index): (u32, Index),
    ) -> Option<(Rational, Spot)> {
        let place = [0, 1].map(|i| Rational::from(index[i]) - &self.shift[i]);
        let on_limit = self.points.limit(later, index, self.values)?;
        let there = self.back(later - level).at(&place);
        let on_net = self.points.at(level, &there)?;
        let place = self.back(later).at(&place);
        let face = self.face(&place, at.root)?;
        let apart = square(&[0, 1, 2].map(|c| &on_limit[c] - &on_net[c]));
        Some((apart, Spot { face, place, on_net, on_limit, at: None }))
    }

    /// A face that has this place of level 0; `root` is tried first.
    fn face(&self, place: &Place, root: Index) -> Option<Index> {
        let has = |face: &Index| {
            (0..2).all(|i| {
                let t = &place[i] - &Rational::from(face[i]);
                t.sign() >= 0 && t <= Rational::one()
            })
        };
        let own = Some(root).filter(has);
        own.or_else(|| self.faces.iter().copied().find(has))
    }

    /// The limit at a place, nearly.
    pub(super) fn limit(&mut self, spot: &Spot) -> Point<Rational> {
        let later = spot.at.as_ref().and_then(|(level, place)| {
            self.points.at(level + LATER, &self.levels.forth(LATER).at(place))
        });
        later.unwrap_or_else(|| spot.on_limit.clone())
    }

    /// Whether |P^∞ − P^k| is within a tolerance on all faces. `left` counts the squares that may be looked at.
    pub(super) fn examine(&mut self, level: u32, tolerance: &Rational, left: &mut usize) -> Answer {
        let mut todo: Vec<Square> =
            self.faces.iter().rev().map(|face| Squares::root(*face)).collect();
        self.work.begin(level, todo.len());
        let (mut open, mut seen) = (false, HashSet::new());
        while let Some(square) = todo.pop() {
            if square.level == 0 {
                self.work.step();
            }
            if !seen.insert(square.clone()) {
                continue;
            }
            if *left == 0 || self.work.is_stopped() {
                return Answer::Open;
            }
            *left -= 1;
            let Some(known) = self.known(&square, level) else {
                open = true;
                continue;
            };
            match known.compared(tolerance) {
                Some(true) => {}
                Some(false) => {
                    if let (_, Some(spot)) = known.least() {
                        return Answer::Beyond(Box::new(spot.clone()));
                    }
                }
                None if square.level >= level + EXTRA_LEVELS => open = true,
                None => todo.extend(self.squares.parts(&square)),
            }
        }
        if open { Answer::Open } else { Answer::Within }
    }

    /// A lower and an upper bound of sup |P^∞ − P^k| on some faces, and where the first is attained nearly.
    pub(super) fn greatest(
        &mut self,
        level: u32,
        faces: &mut dyn Iterator<Item = Index>,
        most: usize,
    ) -> ([f64; 2], Option<Spot>) {
        let (mut known, mut heap) = (Vec::new(), BinaryHeap::new());
        let (mut least, mut worst) = (0.0_f64, None);
        let mut todo: Vec<Square> = faces.map(Squares::root).collect();
        let mut seen = HashSet::new();
        loop {
            for square in todo.drain(..) {
                if !seen.insert(square.clone()) {
                    continue;
                }
                let Some(found) = self.known(&square, level) else {
                    return ([least, f64::INFINITY], worst);
                };
                let (below, spot) = found.least();
                if below > least {
                    (least, worst) = (below, spot.cloned());
                }
                // Of numbers that are not negative the bits are in the order of these.
                heap.push((found.most().to_bits(), known.len()));
                known.push(square);
            }
            let Some((bits, number)) = heap.pop() else { return ([least, least], worst) };
            let upper = f64::from_bits(bits);
            let square = &known[number];
            let enough = upper <= least * CLOSE || square.level >= level + EXTRA_LEVELS;
            if enough || known.len() >= most || self.work.is_stopped() {
                return ([least, upper], worst);
            }
            todo = self.squares.parts(square);
        }
    }
}
