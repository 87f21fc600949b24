//! What is certain of one direction, whatever the points are (THEOREMS.md, 167).

use super::read::Given;
use crate::data::Rules;
use crate::numbers::{Meter, Q, capped, int};
use crate::text::{DepthChecked as Checked, DepthReason, Stop, require};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One as _, Signed, ToPrimitive as _, Zero};

/// The most points of a window.
const MAX_WINDOW: i64 = 64;

/// Coefficients over their common denominator, and that, are less than this.
const MAX_COEFFICIENT: i64 = 1 << 40;

/// The steps of one product of integers.
const PRODUCT: u64 = 64;

/// The most rows of a power of the operator of differences.
const MAX_ROWS: i64 = 4_096;

/// Coefficients, over a common denominator, with the places of their points.
type Rule = Vec<(i64, i128)>;

/// One direction: the scheme, and the points that are known.
pub struct Direction {
    pub arity: i64,
    /// s: point i of level k is at the parameter (i + s)/n^k.
    pub shift: Q,
    pub count: i64,
    pub range: Option<[Q; 2]>,
    /// For each rule the coefficients that are not 0 with the places of their points, over one denominator.
    pub rules: Vec<Rule>,
    pub over: i128,
    /// max_α Σ_j |r_{α,j}|.
    pub greatest: Q,
    /// The points x_{i + first}, …, x_{i + last} determine all on the parameters from i to i + 1.
    pub window: [i64; 2],
    /// FROM, and TO less COUNT.
    ends: [Q; 2],
    /// C: |P^k − P^0| and |P^∞ − P^0| are at most C·max|Δ_j − b| over the window.
    pub distance: Q,
    /// K: the coefficients of P^k and P^∞ at a parameter sum to at most K, in absolute values.
    pub sum: Q,
}

impl Direction {
    pub fn new(given: &Given, is_net: bool, meter: &Meter) -> Checked<Direction> {
        let n = i64::try_from(given.rules.len()).unwrap_or(i64::MAX);
        let (rules, over) = integers(given)?;
        let one = rules.iter().all(|rule| rule.iter().map(|(_, x)| x).sum::<i128>() == over);
        require(one, DepthReason::Rule)?;
        let own = Rules::of(meter, &given.rules, given.offset)?;
        let shift = own.natural_shift().ok_or(DepthReason::NoLines)?;
        // Before any functional of points: in a window, all of them are short.
        let ends = ends(&rules, &shift, n);
        let window = window(&ends)?;
        // P^1 − P^0 is linear between the points of both.
        let mut moved = Q::zero();
        let steps: Vec<Q> = (0..n).map(|i| (int(i) + &shift) / int(n)).collect();
        for t in steps.iter().chain([&shift]) {
            let [next, this] = [1, 0].map(|level| own.polygon(level, t, &shift));
            moved = moved.max(next?.minus(&this?).norm_on_differences());
        }
        let distance = moved * falls(&own, given.rules[0].len(), meter)?;
        let positive = given.rules.iter().flatten().all(|x| !x.is_negative());
        let sum = if positive { int(1) } else { int(1) + int(2) * &distance };
        let greatest = given.rules.iter().map(|rule| rule.iter().map(Q::abs).sum::<Q>());
        let greatest = greatest.max().unwrap_or_else(Q::one);
        let count = i64::try_from(given.count).unwrap_or(i64::MAX);
        let direction = Direction {
            arity: n,
            shift,
            count,
            range: given.range.clone(),
            rules,
            over,
            greatest,
            window,
            ends,
            distance,
            sum,
        };
        direction.check_range(is_net).map(|()| direction)
    }

    /// An open polygon is compared on all the parameters between which the given points determine the limit and the polygons
    /// of all levels; a net between whole ones.
    fn check_range(&self, is_net: bool) -> Checked<()> {
        let Some([from, to]) = &self.range else { return Ok(()) };
        let [start, short] = &self.ends;
        let end = int(self.count) + short;
        let own = if is_net { [start.ceil(), end.floor()] } else { [start.clone(), end] };
        require([from, to] == [&own[0], &own[1]], DepthReason::Range)
    }
}

/// The coefficients that are not 0 with the places of their points, and their common denominator.
fn integers(given: &Given) -> Checked<(Vec<Rule>, i128)> {
    let small = |x: i128| capped(x, MAX_COEFFICIENT - 1).map(i128::from);
    let of = |x: &BigInt| x.to_i128().and_then(small);
    let common = |over: i128, x: &Q| small(over.lcm(&of(x.denom())?));
    let over = given.rules.iter().flatten().try_fold(1, common);
    let rules = over.and_then(|over| {
        let term = |(j, x): (i64, &Q)| Some((j, small(of(x.numer())? * (over / of(x.denom())?))?));
        let rules = given.rules.iter().map(|rule| {
            (given.offset..).zip(rule).filter(|(_, x)| !x.is_zero()).map(term).collect()
        });
        Some((rules.collect::<Option<_>>()?, over))
    });
    Ok(rules.ok_or(Stop::Capped("the size of coefficients"))?)
}

/// An upper bound of Σ_m ‖D^m‖, D the operator of differences. Row i of D^m is the difference i of level m, as a
/// functional of the differences of level 0.
fn falls(rules: &Rules<'_>, width: usize, meter: &Meter) -> Checked<Q> {
    let (mut count, mut sum) = (1, Q::zero());
    for level in 0.. {
        let (mut norm, mut last) = (Q::zero(), rules.at(level, &int(0))?);
        for i in 1..=count {
            meter.spend(PRODUCT * width.pow(level.min(2)) as u64)?;
            let next = rules.at(level, &int(i))?;
            norm = norm.max(next.minus(&last).norm_on_differences());
            last = next;
        }
        if norm < int(1) {
            return Ok(sum / (int(1) - norm));
        }
        (sum, count) = (sum + norm, count * rules.arity());
        require(count <= MAX_ROWS, DepthReason::NotConvergent)?;
    }
    Ok(sum)
}

/// max(B − 1, s) and min(A, s − 1), where A and B are the least and the greatest (α − nj)/(n − 1).
fn ends(rules: &[Rule], shift: &Q, n: i64) -> [Q; 2] {
    let used = (0..).zip(rules).flat_map(|(alpha, rule)| {
        rule.iter().map(move |(j, _)| (int(alpha) - int(n) * int(*j)) / int(n - 1))
    });
    let start = [shift.clone(), shift - int(1)];
    used.fold(start, |[start, short], end| [start.max(&end - int(1)), short.min(end)])
}

/// The window of the cell from 0 to 1: it has the points of the polygon there, and all that those of the next level in
/// the windows of its parts are made of (THEOREMS.md, 98).
fn window([start, short]: &[Q; 2]) -> Checked<[i64; 2]> {
    let ends = [(-start).floor(), (-short).ceil()].map(|end| end.to_i64());
    match ends {
        [Some(first), Some(last)] if last.saturating_sub(first) < MAX_WINDOW => Ok([first, last]),
        _ => Err(Stop::Capped("the size of a window").into()),
    }
}
