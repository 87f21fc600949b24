//! Polygons for which a level and the next level, or a level and the limit, have
//! different greatest values.

use super::summit::{Peaked, Summits};
use crate::exact::Rational;
use crate::limit::error::LimitError;
use crate::limit::functional::{ExtremalPolygon, Functional};
use crate::limit::natural::natural_shift;
use crate::limit::value::Limit;

/// Levels with more points per unit than this are not used to make trial polygons.
const MAX_NODES: usize = 32;

/// The highest level that is used to make trial polygons.
const MAX_NODE_LEVEL: u32 = 2;

/// The greatest number of differences −1, 1, −1, … in a zigzag that is tried.
const MAX_ZIGZAG: usize = 8;

/// The number of polygons whose limits are examined.
const CLOSELY: usize = 4;

/// The limit is bounded at up to this number of levels after the level of the polygon.
const MAX_LATER: u32 = 3;

/// A polygon with max|Δ| = 1, or a net of two such polygons, whose greatest value at a level
/// differs from the greatest value at the next level, or from the supremum of the limit. Under
/// every shift of the parameter, the distance between the two is at least the difference of
/// these values.
///
/// Source: `proofs/THEOREMS.md`, 89.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Overshoot {
    /// The polygon x, constant beyond its ends; or two such polygons a and b, which give
    /// the net a_i + b_j.
    pub polygons: Vec<ExtremalPolygon>,
    /// The greatest point of level k.
    pub greatest: Rational,
    /// The greatest point of level k + 1, or a bound of the supremum of the limit as
    /// `shown` says.
    pub later: Rational,
    /// How `later` is proved.
    pub shown: ProofOfGreatest,
}

/// How a greatest value is proved; for a net, along each index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ProofOfGreatest {
    /// It is the greatest point of the next level.
    Points,
    /// It is an upper bound of the limit, from the points of these levels.
    AtMost(Vec<u32>),
    /// It is the value of the limit at these parameters.
    AtLeast(Vec<Rational>),
}

impl Overshoot {
    /// The difference of the two values.
    #[must_use]
    pub fn gap(&self) -> Rational {
        (&self.greatest - &self.later).abs()
    }

    /// The overshoot of the net of two polygons, from the overshoots of both.
    #[must_use]
    pub fn and(mut self, other: Overshoot) -> Overshoot {
        self.polygons.extend(other.polygons);
        self.greatest += &other.greatest;
        self.later += &other.later;
        match (&mut self.shown, other.shown) {
            (ProofOfGreatest::AtMost(levels), ProofOfGreatest::AtMost(more)) => levels.extend(more),
            (ProofOfGreatest::AtLeast(places), ProofOfGreatest::AtLeast(more)) => {
                places.extend(more);
            }
            _ => {}
        }
        self
    }
}

/// What a level is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Later {
    /// The points of the next level.
    Points,
    /// The limit.
    Limit,
}

/// The polygons of one scheme that are tried.
pub struct Overshoots {
    scheme: Peaked,
    tried: Vec<Summits>,
}

impl Overshoots {
    /// The trial polygons: polygons that are far from their limit in the natural parametrisation,
    /// zigzags, and the negatives of both.
    ///
    /// # Errors
    /// When the limit has too many pieces for the search.
    pub fn new(limit: &Limit) -> Result<Overshoots, LimitError> {
        let shift = natural_shift(limit.mask()).shift;
        let arity = limit.mask().arity();
        let mut polygons: Vec<ExtremalPolygon> = Vec::new();
        for level in 0..=MAX_NODE_LEVEL {
            let nodes = arity.pow(level);
            if nodes > MAX_NODES {
                break;
            }
            // The parameters of the points, and the midpoints between them.
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

    /// The overshoots with the greatest difference that is found: one where level k is
    /// above the next level, or above the limit, and one where it is below.
    pub fn greatest(&mut self, level: u32, later: Later) -> [Option<Overshoot>; 2] {
        let rules = &self.scheme.rules;
        let mut found: Vec<(Rational, usize)> = Vec::new();
        for (place, polygon) in self.tried.iter_mut().enumerate() {
            let now = polygon.greatest(rules, level);
            let next = polygon.greatest(rules, level + 1);
            let (Some(now), Some(next)) = (now, next) else { continue };
            found.push((now - next, place));
        }
        // Of polygons with equal differences, the first one is used.
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
        Some(Overshoot { polygons, greatest, later, shown: ProofOfGreatest::Points })
    }

    /// The overshoot of a polygon whose level k is above its limit.
    fn above(&mut self, place: usize, level: u32) -> Option<Overshoot> {
        let polygon = &mut self.tried[place];
        let greatest = polygon.greatest(&self.scheme.rules, level)?;
        let bounds: Vec<(u32, Rational)> = (level + 1..=level + MAX_LATER)
            .map_while(|later| Some((later, polygon.at_most(&self.scheme, later)?)))
            .collect();
        let best = &greatest - bounds.iter().map(|(_, bound)| bound).min()?;
        let enough = &best * nearly();
        // The first level whose bound is nearly as good as the best one.
        let (later, bound) = bounds.into_iter().find(|(_, bound)| &greatest - bound >= enough)?;
        let polygons = vec![polygon.polygon().clone()];
        let shown = ProofOfGreatest::AtMost(vec![later]);
        (best.sign() > 0).then_some(Overshoot { polygons, greatest, later: bound, shown })
    }

    /// The overshoot of a polygon whose level k is below its limit.
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
        let shown = ProofOfGreatest::AtLeast(vec![at]);
        (later > greatest).then_some(Overshoot { polygons, greatest, later, shown })
    }
}

/// The fraction of the best difference that is accepted, as earlier levels give numbers
/// with fewer digits.
fn nearly() -> Rational {
    Rational::new(15, 16)
}

/// The first overshoot with the greatest difference.
fn best(found: impl Iterator<Item = Overshoot>) -> Option<Overshoot> {
    found.fold(None, |best: Option<Overshoot>, next| match best {
        Some(best) if best.gap() >= next.gap() => Some(best),
        _ => Some(next),
    })
}

/// The polygon whose differences are the signs of the coefficients of a functional of the
/// differences, 0 where a coefficient is 0; `None` if all coefficients are 0.
fn resting(functional: &Functional) -> Option<ExtremalPolygon> {
    let (first, last) = functional.support()?;
    let mut points = vec![0];
    for i in first..=last {
        points.push(points[points.len() - 1] + i64::from(functional.coefficient(i).sign()));
    }
    Some(ExtremalPolygon { first, points })
}
