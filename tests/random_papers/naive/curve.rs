//! Curves: points as functionals of the control polygon.

use super::{Q, int};
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::cell::RefCell;
use std::collections::BTreeMap;

/// A functional of a polygon: index, coefficient.
pub type Row = BTreeMap<i64, Q>;

/// A scheme with a mask. Rows are kept by level and residue class.
#[derive(Clone, Debug)]
pub struct Curve {
    pub rules: Vec<Vec<Q>>,
    pub offset: i64,
    known: RefCell<BTreeMap<(u32, i64), Row>>,
    norms: RefCell<BTreeMap<(char, u32), Q>>,
}

/// x·left + y·right.
pub fn combine(left: &Row, x: &Q, right: &Row, y: &Q) -> Row {
    let mut sum = Row::new();
    for (row, factor) in [(left, x), (right, y)] {
        for (index, value) in row {
            *sum.entry(*index).or_insert_with(Q::zero) += value * factor;
        }
    }
    sum.retain(|_, value| !value.is_zero());
    sum
}

/// The coefficients of Δ_i = x_{i+1} − x_i in a functional whose coefficients sum to 0.
pub fn differences(row: &Row) -> Row {
    let (mut sum, mut found) = (Q::zero(), Row::new());
    let Some((&first, _)) = row.first_key_value() else { return found };
    let last = *row.last_key_value().expect("an entry").0;
    for i in first..last {
        sum += row.get(&i).cloned().unwrap_or_default();
        found.insert(i, -sum.clone());
    }
    found
}

fn total(row: &Row) -> Q {
    row.values().map(Signed::abs).sum()
}

/// x_i of a polygon that stays where its ends are.
pub fn at_clamped(first: i64, count: usize, i: i64) -> usize {
    usize::try_from(i - first).unwrap_or(0).min(count - 1)
}

impl Curve {
    pub fn new(rules: Vec<Vec<Q>>, offset: i64) -> Curve {
        let (known, norms) = Default::default();
        Curve { rules, offset, known, norms }
    }

    pub fn arity(&self) -> i64 {
        i64::try_from(self.rules.len()).expect("few rules")
    }

    pub fn with_offset(&self, offset: Option<i64>) -> Curve {
        Curve::new(self.rules.clone(), offset.unwrap_or(self.offset))
    }

    /// x^level_i as a functional of x^0.
    pub fn row(&self, level: u32, i: i64) -> Row {
        if level == 0 {
            return Row::from([(i, Q::one())]);
        }
        let classes = self.arity().pow(level);
        let (shift, class) = (i.div_euclid(classes), i.rem_euclid(classes));
        let known = self.known.borrow().get(&(level, class)).cloned();
        let row = known.unwrap_or_else(|| {
            let rule = &self.rules[usize::try_from(class % self.arity()).expect("a rule")];
            let first = class / self.arity() + self.offset;
            let row = rule.iter().zip(first..).fold(Row::new(), |sum, (weight, j)| {
                combine(&sum, &Q::one(), &self.row(level - 1, j), weight)
            });
            self.known.borrow_mut().insert((level, class), row.clone());
            row
        });
        row.into_iter().map(|(j, value)| (j + shift, value)).collect()
    }

    /// P^level(t), t = i/n^finer.
    pub fn at(&self, level: u32, i: i64, finer: u32) -> Row {
        let parts = self.arity().pow(finer.saturating_sub(level));
        let (whole, part) = if finer < level {
            (i * self.arity().pow(level - finer), 0)
        } else {
            (i.div_euclid(parts), i.rem_euclid(parts))
        };
        let right = Q::new(part.into(), parts.into());
        combine(&self.row(level, whole), &(Q::one() - &right), &self.row(level, whole + 1), &right)
    }

    /// The s with which x^k_i at (i + s)/n^k stays on every line; `None` if there is none.
    pub fn natural_shift(&self) -> Option<Q> {
        let n = int(self.arity());
        let shifts: Vec<Q> = (0..self.arity())
            .map(|alpha| {
                // Of x_i = i, x^1_α is to be (α + s)/n − s.
                let line: Q = self.row(1, alpha).iter().map(|(i, weight)| weight * int(*i)).sum();
                (int(alpha) - &n * line) / (&n - Q::one())
            })
            .collect();
        shifts.iter().all(|shift| *shift == shifts[0]).then(|| shifts[0].clone())
    }

    /// Between the points of a level: u is an index, and between two of them.
    pub fn between(&self, level: u32, u: &Q) -> Row {
        let whole = u.floor().to_integer().to_i64().expect("near");
        let right = u - u.floor();
        combine(&self.row(level, whole), &(Q::one() - &right), &self.row(level, whole + 1), &right)
    }

    fn kept(&self, what: char, level: u32, find: impl Fn() -> Q) -> Q {
        if let Some(known) = self.norms.borrow().get(&(what, level)) {
            return known.clone();
        }
        let found = find();
        self.norms.borrow_mut().insert((what, level), found.clone());
        found
    }

    fn greatest(&self, finer: u32, of: impl Fn(i64) -> Q) -> Q {
        (0..self.arity().pow(finer)).map(of).max().unwrap_or_default()
    }

    /// The supremum of |Δ^level_i| over all polygons of spread 1.
    pub fn difference(&self, level: u32, i: i64) -> Q {
        total(&differences(&combine(
            &self.row(level, i + 1),
            &Q::one(),
            &self.row(level, i),
            &-Q::one(),
        )))
    }

    /// The same of |P^later(t) − P^level(t)|, t = i/n^later.
    pub fn apart(&self, level: u32, later: u32, i: i64) -> Q {
        let old = self.at(level, i, later);
        total(&differences(&combine(&self.row(later, i), &Q::one(), &old, &-Q::one())))
    }

    /// The supremum of |Δ^level| over all polygons of spread 1: the sum of the absolute values of the
    /// coefficients, which Δ_i = ±1 attains.
    pub fn greatest_difference(&self, level: u32) -> Q {
        self.kept('d', level, || self.greatest(level, |i| self.difference(level, i)))
    }

    /// The same of ‖P^{level+1} − P^level‖.
    pub fn greatest_step(&self, level: u32) -> Q {
        self.kept('s', level, || self.farthest(level, level + 1))
    }

    /// The same of |P^later − P^level| at the points of the level `later`.
    pub fn farthest(&self, level: u32, later: u32) -> Q {
        self.greatest(later, |i| self.apart(level, later, i))
    }

    /// The greatest Σ|coefficients| of a point of this level.
    pub fn norm(&self, level: u32) -> Q {
        let of = |i| total(&self.row(level, i));
        self.kept('n', level, || (0..self.arity().pow(level)).map(of).max().unwrap_or_default())
    }

    /// At most n^c residue classes are looked at for a constant.
    pub fn levels_within(&self, classes: i64) -> u32 {
        (1..=20).take_while(|c| self.arity().pow(*c) <= classes).last().unwrap_or(1)
    }

    /// A bound of ‖P^∞ − P^level‖ for the spread 1, where some T_c < 1.
    ///
    /// P^∞ − P^k is the sum of the steps P^{i+1} − P^i, i ≥ k, and each is at most σT_i. With T_c < 1
    /// and T_{i+c} ≤ T_cT_i, the sum is at most σ(U_k + … + U_{k+c−1})/(1 − T_c), where U_i ≥ T_i is
    /// T_i itself or, where that is over too many classes, T_cU_{i−c}.
    pub fn remainder(&self, level: u32) -> Option<Q> {
        let contracts = |most| (1..=most).find(|c| self.greatest_difference(*c) < Q::one());
        let within = [250, 20_000].map(|classes| self.levels_within(classes));
        let (most, c) = within.into_iter().find_map(|most| Some((most, contracts(most)?)))?;
        let factor = self.greatest_difference(c);
        let upper = |level: u32| {
            let blocks = if level > most { (level - most).div_ceil(c) } else { 0 };
            let factor = num_traits::pow(factor.clone(), blocks as usize);
            self.greatest_difference(level - blocks * c) * factor
        };
        let sum: Q = (level..level + c).map(upper).sum();
        Some(self.greatest_step(0) * sum / (Q::one() - factor))
    }

    /// The value of a functional for a polygon that stays where its ends are.
    pub fn of(row: &Row, first: i64, points: &[i64]) -> Q {
        row.iter().map(|(i, value)| value * int(points[at_clamped(first, points.len(), *i)])).sum()
    }
}
