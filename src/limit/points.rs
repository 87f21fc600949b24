//! Refined points one by one, as one computes them by hand.

use super::functional::{ExtremalPolygon, Functional, rule_at};
use super::value::Limit;
use crate::exact::Rational;
use crate::scheme::{Mask, Rules};
use std::collections::BTreeMap;

/// The last level at which a limit value is looked for.
const MAX_LEVEL: u32 = 16;

/// Σ c_i x^k_i, term by term.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Combination {
    /// k.
    pub level: u32,
    /// i, c_i and x^k_i.
    pub terms: Vec<(i64, Rational, Rational)>,
    /// The sum.
    pub value: Rational,
}

/// Weights with Σ w_p x'_p = Σ w_p x_p for the refined points x' of any points x, and Σ w_p = 1: the
/// value of the limit at 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LimitWeights {
    /// p and w_p.
    pub weights: Vec<(i64, Rational)>,
    /// For each p the refined point x'_p: the q with their coefficients.
    pub rules: Vec<Vec<(i64, Rational)>>,
}

impl LimitWeights {
    /// Those of a scheme.
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

/// The points of a refined control polygon that were asked for, and those that they are made of.
pub(crate) struct Points<'a> {
    rules: &'a Rules,
    control: &'a ExtremalPolygon,
    known: BTreeMap<(u32, i64), Rational>,
}

impl<'a> Points<'a> {
    /// Of a mask and a polygon that is constant beyond both ends.
    pub(crate) fn new(mask: &'a Mask, control: &'a ExtremalPolygon) -> Points<'a> {
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
    pub(crate) fn combination(&mut self, level: u32, weights: &Functional) -> Combination {
        let terms = weights.terms().map(|(i, c)| (i, c.clone(), self.point(level, i)));
        let terms: Vec<(i64, Rational, Rational)> = terms.collect();
        let value = terms.iter().map(|(_, c, x)| c * x).sum();
        Combination { level, terms, value }
    }

    /// P^k(t), with x^k_i at i/n^k.
    pub(crate) fn polygon(&mut self, level: u32, t: &Rational) -> Combination {
        let arity = Rational::from(self.rules.arity());
        let place = (0..level).fold(t.clone(), |place, _| place * &arity);
        self.at(level, &place)
    }

    /// P^k at u/n^k.
    pub(crate) fn at(&mut self, level: u32, place: &Rational) -> Combination {
        self.combination(level, &Functional::on_line(place))
    }

    /// P^∞(t), by the points around t of the first level that has a point there; `None` where no
    /// level up to 16 has one.
    pub(crate) fn limit(&mut self, weights: &LimitWeights, t: &Rational) -> Option<Combination> {
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

    /// The points of levels above 0, level by level.
    pub(crate) fn refined(&self) -> Vec<(u32, Vec<(i64, Rational)>)> {
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
