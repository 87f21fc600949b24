//! Polygons whose levels and limit have different greatest values.

use super::error::LimitError;
use super::functional::{ExtremalPolygon, Functional};
use super::natural::natural_shift;
use super::summit::{Peaked, Summits};
use super::value::Limit;
use crate::exact::Rational;

/// The most nodes of a level whose errors make polygons to be tried.
const MAX_NODES: usize = 32;

/// The highest level of such nodes.
const MAX_NODE_LEVEL: u32 = 2;

/// The longest polygon of the differences −1, 1, −1, … that is tried.
const MAX_ZIGZAG: usize = 8;

/// How many polygons are looked at closely.
const CLOSELY: usize = 4;

/// By how many levels the limit is looked at later than the polygon.
const MAX_LATER: u32 = 3;

/// Polygons of spread 1 for which a level has another greatest value than the next one, or
/// than the limit. No shift of the parameter brings the two nearer than the difference of these
/// values.
///
/// Source: `proofs/THEOREMS.md`, 89.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Overshoot {
    /// The polygon x, which stays where its ends are; or two polygons a and b of the net
    /// a_i + b_j.
    pub polygons: Vec<ExtremalPolygon>,
    /// The greatest point of level k.
    pub greatest: Rational,
    /// The greatest point of level k + 1, or a bound of the supremum of the limit.
    pub later: Rational,
    /// How the latter is known.
    pub shown: Shown,
}

/// What shows a greatest value; of a net, along each index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shown {
    /// It is that of the points of the next level.
    Points,
    /// The limit is at most this by the points of these levels.
    AtMost(Vec<u32>),
    /// The limit is this at these parameters.
    AtLeast(Vec<Rational>),
}

impl Overshoot {
    /// The difference of the two values.
    #[must_use]
    pub fn gap(&self) -> Rational {
        (&self.greatest - &self.later).abs()
    }

    /// The net of two polygons.
    #[must_use]
    pub(crate) fn and(mut self, other: Overshoot) -> Overshoot {
        self.polygons.extend(other.polygons);
        self.greatest += &other.greatest;
        self.later += &other.later;
        match (&mut self.shown, other.shown) {
            (Shown::AtMost(levels), Shown::AtMost(more)) => levels.extend(more),
            (Shown::AtLeast(places), Shown::AtLeast(more)) => places.extend(more),
            _ => {}
        }
        self
    }
}

/// What is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Later {
    /// The points of the next level.
    Points,
    /// The limit.
    Limit,
}

/// The polygons of one scheme that are tried.
pub(crate) struct Overshoots {
    scheme: Peaked,
    tried: Vec<Summits>,
}

impl Overshoots {
    /// Polygons that are far from their limit where their points are at their natural parameters, and
    /// zigzags.
    pub(crate) fn new(limit: &Limit) -> Result<Overshoots, LimitError> {
        let shift = natural_shift(limit.mask()).shift;
        let arity = limit.mask().arity();
        let mut polygons: Vec<ExtremalPolygon> = Vec::new();
        for level in 0..=MAX_NODE_LEVEL {
            let nodes = arity.pow(level);
            if nodes > MAX_NODES {
                break;
            }
            // The places of the nodes, and between them.
            for half in 0..2 * nodes {
                let place = (Rational::new(half, 2) + &shift) / Rational::from(nodes);
                polygons.extend(resting(&limit.error_from(level, &place, &shift)?));
            }
        }
        polygons.extend((2..=MAX_ZIGZAG).map(|last| ExtremalPolygon {
            first: 0,
            points: (0..=last).map(|i| if i % 2 == 0 { 0 } else { -1 }).collect(),
        }));
        let mut tried: Vec<ExtremalPolygon> = Vec::new();
        for polygon in polygons {
            let turned = ExtremalPolygon {
                first: polygon.first,
                points: polygon.points.iter().map(|x| -x).collect(),
            };
            for polygon in [polygon, turned] {
                if tried.iter().all(|other| other.points != polygon.points) {
                    tried.push(polygon);
                }
            }
        }
        let tried = tried.into_iter().map(Summits::new).collect();
        Ok(Overshoots { scheme: Peaked::new(limit, shift), tried })
    }

    /// The greatest differences that are found, of polygons above what is later and of
    /// polygons below it.
    pub(crate) fn greatest(&mut self, level: u32, later: Later) -> [Option<Overshoot>; 2] {
        let rules = &self.scheme.rules;
        let mut found: Vec<(Rational, usize)> = Vec::new();
        for (place, polygon) in self.tried.iter_mut().enumerate() {
            let now = polygon.greatest(rules, level);
            let next = polygon.greatest(rules, level + 1);
            let (Some(now), Some(next)) = (now, next) else { continue };
            found.push((now - next, place));
        }
        // Of equal differences the first polygon counts.
        found.sort_by(|one, other| one.0.cmp(&other.0).then(other.1.cmp(&one.1)));
        let above = found.iter().rev().filter(|(gap, _)| gap.sign() > 0);
        let below = found.iter().filter(|(gap, _)| gap.sign() < 0);
        let [above, below] = [
            above.take(CLOSELY).map(|(_, place)| *place).collect::<Vec<usize>>(),
            below.take(CLOSELY).map(|(_, place)| *place).collect(),
        ];
        match later {
            Later::Points => {
                [above.first(), below.first()].map(|place| self.points(*place?, level))
            }
            Later::Limit => [
                best(above.iter().filter_map(|place| self.above(*place, level))),
                best(below.iter().filter_map(|place| self.below(*place, level))),
            ],
        }
    }

    fn points(&mut self, place: usize, level: u32) -> Option<Overshoot> {
        let (polygon, rules) = (&mut self.tried[place], &self.scheme.rules);
        let greatest = polygon.greatest(rules, level)?;
        let later = polygon.greatest(rules, level + 1)?;
        let polygons = vec![polygon.polygon().clone()];
        Some(Overshoot { polygons, greatest, later, shown: Shown::Points })
    }

    /// A polygon above its limit.
    fn above(&mut self, place: usize, level: u32) -> Option<Overshoot> {
        let polygon = &mut self.tried[place];
        let greatest = polygon.greatest(&self.scheme.rules, level)?;
        let bounds: Vec<(u32, Rational)> = (level + 1..=level + MAX_LATER)
            .map_while(|later| Some((later, polygon.at_most(&self.scheme, later)?)))
            .collect();
        let best = &greatest - bounds.iter().map(|(_, bound)| bound).min()?;
        let enough = &best * nearly();
        // The first level that is nearly as good as any.
        let (later, bound) = bounds.into_iter().find(|(_, bound)| &greatest - bound >= enough)?;
        let polygons = vec![polygon.polygon().clone()];
        let shown = Shown::AtMost(vec![later]);
        (best.sign() > 0).then_some(Overshoot { polygons, greatest, later: bound, shown })
    }

    /// A polygon below its limit.
    fn below(&mut self, place: usize, level: u32) -> Option<Overshoot> {
        let polygon = &mut self.tried[place];
        let greatest = polygon.greatest(&self.scheme.rules, level)?;
        let values: Vec<(Rational, Rational)> = (level..=level + MAX_LATER)
            .map_while(|later| polygon.at_least(&self.scheme, later))
            .collect();
        let best = values.iter().map(|(value, _)| value).max()? - &greatest;
        let enough = &best * nearly();
        let (later, at) = values.into_iter().find(|(value, _)| value - &greatest >= enough)?;
        let polygons = vec![polygon.polygon().clone()];
        let shown = Shown::AtLeast(vec![at]);
        (later > greatest).then_some(Overshoot { polygons, greatest, later, shown })
    }
}

/// What part of the best is good enough where it takes fewer digits.
fn nearly() -> Rational {
    Rational::new(15, 16)
}

/// The first of those with the greatest difference.
fn best(found: impl Iterator<Item = Overshoot>) -> Option<Overshoot> {
    found.fold(None, |best: Option<Overshoot>, next| match best {
        Some(best) if best.gap() >= next.gap() => Some(best),
        _ => Some(next),
    })
}

/// The polygon with the signs of a functional of the differences, which rests where a coefficient is
/// 0; `None` if all are.
fn resting(functional: &Functional) -> Option<ExtremalPolygon> {
    let (first, last) = functional.support()?;
    let mut points = vec![0];
    for i in first..=last {
        points.push(points[points.len() - 1] + i64::from(functional.coefficient(i).sign()));
    }
    Some(ExtremalPolygon { first, points })
}
