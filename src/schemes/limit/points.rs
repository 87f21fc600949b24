//! Refined points, computed one by one as by hand.

use super::functional::{ExtremalPolygon, Functional, rule_at};
use super::value::Limit;
use crate::exact::Rational;
use crate::scheme::{Mask, Rules};
use std::collections::BTreeMap;

/// The last level that is tried for a limit value.
const MAX_LEVEL: u32 = 16;

/// Σ c_i x^k_i, term by term.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Combination {
    /// k.
    pub level: u32,
    /// The terms, as i, c_i and x^k_i.
    pub terms: Vec<(i64, Rational, Rational)>,
    /// The sum.
    pub value: Rational,
}

/// The weights w_p with Σ w_p = 1 and Σ w_p x'_p = Σ w_p x_p for all points x and their refined
/// points x'. Σ w_p x_p is the value of the limit at 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LimitWeights {
    /// The pairs (p, w_p).
    pub weights: Vec<(i64, Rational)>,
    /// For each p, the rule of the refined point x'_p: the pairs of q and the coefficient
    /// of x_q.
    pub rules: Vec<Vec<(i64, Rational)>>,
}

impl LimitWeights {
    /// The weights of a scheme.
    #[must_use]
    pub fn of(limit: &Limit) -> Option<LimitWeights> {
        let at_zero = limit.at(&Rational::zero()).ok()?;
        let weights: Vec<(i64, Rational)> = at_zero.terms().map(|(p, w)| (p, w.clone())).collect();
        let rule = |(p, _): &(i64, Rational)| {
            let terms = rule_at(limit.mask().rules(), *p).filter(|(_, a)| !a.is_zero());
            terms.map(|(q, a)| (q, a.clone())).collect()
        };
        let rules = weights.iter().map(rule).collect();
        Some(LimitWeights { weights, rules })
    }
}

/// Points of the refinements of a control polygon. Each computed point is kept, with the points
/// on which it depends.
pub struct Points<'a> {
    rules: &'a Rules,
    control: &'a ExtremalPolygon,
    known: BTreeMap<(u32, i64), Rational>,
}

impl<'a> Points<'a> {
    /// The points for a mask and a control polygon that is continued as a constant beyond
    /// both ends.
    #[must_use]
    pub fn new(mask: &'a Mask, control: &'a ExtremalPolygon) -> Points<'a> {
        Points { rules: mask.rules(), control, known: BTreeMap::new() }
    }

    /// x^k_i.
    pub(crate) fn point(&mut self, level: u32, i: i64) -> Rational {
        if level == 0 {
            let ExtremalPolygon { first, points } = self.control;
            let last = points.len().saturating_sub(1);
            let place = usize::try_from(i - first).unwrap_or(0).min(last);
            return points.get(place).map_or_else(Rational::zero, |point| Rational::from(*point));
        }
        if let Some(known) = self.known.get(&(level, i)) {
            return known.clone();
        }
        let rules = self.rules;
        let terms = rule_at(rules, i).filter(|(_, a)| !a.is_zero());
        let point: Rational = terms.map(|(q, a)| a * &self.point(level - 1, q)).sum();
        self.known.insert((level, i), point.clone());
        point
    }

    /// Σ c_i x^k_i.
    pub fn combination(&mut self, level: u32, weights: &Functional) -> Combination {
        let terms = weights.terms().map(|(i, c)| (i, c.clone(), self.point(level, i)));
        let terms: Vec<(i64, Rational, Rational)> = terms.collect();
        let value = terms.iter().map(|(_, c, x)| c * x).sum();
        Combination { level, terms, value }
    }

    /// P^k(t), with x^k_i at i/n^k.
    pub fn polygon(&mut self, level: u32, t: &Rational) -> Combination {
        let arity = Rational::from(self.rules.arity());
        let place = (0..level).fold(t.clone(), |place, _| place * &arity);
        self.at(level, &place)
    }

    /// P^k at u/n^k.
    pub fn at(&mut self, level: u32, place: &Rational) -> Combination {
        self.combination(level, &Functional::on_line(place))
    }

    /// P^∞(t), from the points around t of the first level that has a point at t; `None` if no
    /// level up to 16 has one.
    pub fn limit(&mut self, weights: &LimitWeights, t: &Rational) -> Option<Combination> {
        let arity = Rational::from(self.rules.arity());
        let mut place = t.clone();
        for level in 0..=MAX_LEVEL {
            if place.is_integer() {
                let i = place.numerator().to_i64()?;
                let around = weights.weights.iter().map(|(p, w)| (i + p, w.clone()));
                return Some(self.combination(level, &around.collect::<Functional>()));
            }
            place *= &arity;
        }
        None
    }

    /// The computed points of all levels above 0, level by level.
    #[must_use]
    pub fn refined(&self) -> Vec<(u32, Vec<(i64, Rational)>)> {
        let mut levels: Vec<(u32, Vec<(i64, Rational)>)> = Vec::new();
        for ((level, i), point) in &self.known {
            match levels.last_mut().filter(|(last, _)| last == level) {
                Some((_, points)) => points.push((*i, point.clone())),
                None => levels.push((*level, vec![(*i, point.clone())])),
            }
        }
        levels
    }
}
