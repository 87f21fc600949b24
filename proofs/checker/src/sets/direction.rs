//! What is certain of one direction, whatever the points are (THEOREMS.md, 167).

use super::read::Given;
use crate::decimal::{Q, int};
use crate::meter::Meter;
use crate::reject::{DepthReason, Stop};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One as _, Signed, ToPrimitive as _, Zero};

/// The most points of a window.
const MAX_WINDOW: i64 = 64;

/// Coefficients over their common denominator, and that, are less than this.
const MAX_COEFFICIENT: i128 = 1 << 40;

/// The steps of one product of rational numbers.
const PRODUCT: u64 = 64;

/// The most rows of a power of the operator of differences.
const MAX_ROWS: usize = 4_096;

/// Coefficients, over a common denominator, with the places of their points.
type Rule = Vec<(i64, i128)>;

/// A functional of x_i or of Δ_i: the first index, and coefficients.
#[derive(Clone)]
struct Row {
    first: i64,
    of: Vec<Q>,
}

impl Row {
    fn unit(at: i64) -> Row {
        Row { first: at, of: vec![int(1)] }
    }

    fn add(&mut self, factor: &Q, other: &Row) {
        for (i, x) in (other.first..).zip(&other.of) {
            while i < self.first {
                self.of.insert(0, Q::zero());
                self.first -= 1;
            }
            let at = usize::try_from(i - self.first).unwrap_or(0);
            if at >= self.of.len() {
                self.of.resize(at + 1, Q::zero());
            }
            self.of[at] += factor * x;
        }
    }

    fn norm(&self) -> Q {
        self.of.iter().map(Q::abs).sum()
    }

    /// The same functional, of differences Δ_i = x_{i+1} − x_i; its coefficients sum to 0.
    fn of_differences(&self) -> Row {
        // Σ w_p x_p = −Σ_m (Σ_{p ≤ m} w_p) Δ_m.
        let mut sum = Q::zero();
        let of = self.of.iter().map(|x| {
            sum += x;
            -sum.clone()
        });
        Row { first: self.first, of: of.collect() }
    }
}

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
    /// C: |P^k − P^0| and |P^∞ − P^0| are at most C·max|Δ_j − b| over the window.
    pub distance: Q,
    /// K: the coefficients of P^k and P^∞ at a parameter sum to at most K, in absolute values.
    pub sum: Q,
}

fn floor(x: &Q) -> i64 {
    x.floor().to_i64().unwrap_or(0)
}

impl Direction {
    pub fn new(given: &Given, meter: &Meter) -> Result<Direction, DepthReason> {
        let n = i64::try_from(given.rules.len()).unwrap_or(i64::MAX);
        let (rules, over) = integers(given)?;
        if rules.iter().any(|rule| rule.iter().map(|(_, x)| x).sum::<i128>() != over) {
            return Err(DepthReason::Rule);
        }
        let point = |i: i64| {
            let rule = &given.rules[usize::try_from(i.rem_euclid(n)).unwrap_or(0)];
            Row { first: i.div_euclid(n) + given.offset, of: rule.clone() }
        };
        let shift = shift(given, n)?;
        // Before any functional of points: in a window, all of them are short.
        let window = window(&rules, &shift, n)?;
        // P^1 − P^0 is linear between the points of both.
        let on = |row: &dyn Fn(i64) -> Row, u: &Q| {
            let (low, part) = (floor(u), u - u.floor());
            let mut value = Row { first: low, of: Vec::new() };
            value.add(&(int(1) - &part), &row(low));
            value.add(&part, &row(low + 1));
            value
        };
        let mut moved = Q::zero();
        let steps: Vec<Q> = (0..n).map(|i| (int(i) + &shift) / int(n)).collect();
        for t in steps.iter().chain([&shift]) {
            let mut off = on(&point, &(t * int(n) - &shift));
            off.add(&int(-1), &on(&Row::unit, &(t - &shift)));
            moved = moved.max(off.of_differences().norm());
        }
        let distance = moved * falls(&point, n, meter)?;
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
            distance,
            sum,
        };
        direction.check_range().map(|()| direction)
    }

    /// The given points have to determine the limit and all polygons in the range.
    fn check_range(&self) -> Result<(), DepthReason> {
        let Some([from, to]) = &self.range else { return Ok(()) };
        let n = int(self.arity);
        let places = self.rules.iter().zip(0_i64..);
        let moved = places.flat_map(|(rule, alpha)| rule.iter().map(move |(j, _)| (*j, alpha)));
        let moved: Vec<Q> = moved.map(|(j, alpha)| int(j) - int(alpha) / &n).collect();
        let whole = &n / (&n - int(1));
        let low = moved.iter().min().map_or_else(Q::zero, |x| x * &whole);
        let high = moved.iter().max().map_or_else(Q::zero, |x| x * &whole);
        // Of level k, q = n^-k, points j with |j − (tn^k − s)| < 1 are used, which depend on x_i with
        // t − (s + 1)q + (1 − q)low < i < t + (1 − s)q + (1 − q)high; these are linear in q. For q = 0 it is the limit: the
        // function of each point is continuous, and so 0 at the ends of its support.
        let (q, rest) = (int(1) / &n, int(1) - int(1) / &n);
        let later = from - (&self.shift + int(1)) * &q + &low * &rest;
        let first =
            [(from - &self.shift).floor(), (from + low).floor() + int(1), later.floor() + int(1)];
        let later = to + (int(1) - &self.shift) * q + &high * rest;
        let last = [(to - &self.shift).ceil(), (to + high).ceil() - int(1), later.ceil() - int(1)];
        let inside = |x: &Q| !x.is_negative() && *x < int(self.count);
        let fits = first.iter().chain(&last).all(inside);
        if fits { Ok(()) } else { Err(DepthReason::Range) }
    }
}

/// The coefficients that are not 0 with the places of their points, and their common denominator.
fn integers(given: &Given) -> Result<(Vec<Rule>, i128), DepthReason> {
    let small = |x: i128| Some(x).filter(|x| x.abs() < MAX_COEFFICIENT);
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
    rules.ok_or(DepthReason::Stopped(Stop::Capped("the size of coefficients")))
}

/// s with s(1 − 1/n) = α/n − Σ_j j r_{α,j} for all α.
fn shift(given: &Given, n: i64) -> Result<Q, DepthReason> {
    let moved = given.rules.iter().zip(0_i64..).map(|(rule, alpha)| {
        let moment: Q = (given.offset..).zip(rule).map(|(j, x)| int(j) * x).sum();
        int(alpha) / int(n) - moment
    });
    let moved: Vec<Q> = moved.collect();
    if moved.iter().any(|x| *x != moved[0]) {
        return Err(DepthReason::NoLines);
    }
    Ok(&moved[0] * int(n) / int(n - 1))
}

/// An upper bound of Σ_m ‖D^m‖, D the operator of differences.
fn falls(point: &dyn Fn(i64) -> Row, n: i64, meter: &Meter) -> Result<Q, DepthReason> {
    let rules: Vec<Row> = (0..n)
        .map(|i| {
            let mut row = point(i + 1);
            row.add(&int(-1), &point(i));
            row.of_differences()
        })
        .collect();
    let stopped = DepthReason::Stopped;
    let mut rows = vec![Row::unit(0)];
    let mut sum = Q::zero();
    loop {
        let norm = rows.iter().map(Row::norm).max().unwrap_or_else(Q::zero);
        if norm < int(1) {
            return Ok(sum / (int(1) - norm));
        }
        sum += norm;
        let count = rows.len() * rules.len();
        if count > MAX_ROWS {
            return Err(DepthReason::NotConvergent);
        }
        let size = i64::try_from(rows.len()).unwrap_or(i64::MAX);
        let mut next = Vec::with_capacity(count);
        for i in 0..size {
            for rule in &rules {
                let mut row = Row { first: rule.first, of: Vec::new() };
                for (m, x) in (i + rule.first..).zip(&rule.of) {
                    // Row m is row m mod size, moved.
                    let known = &rows[usize::try_from(m.rem_euclid(size)).unwrap_or(0)];
                    meter.spend(PRODUCT * known.of.len() as u64).map_err(stopped)?;
                    let first = known.first + m.div_euclid(size);
                    if row.of.is_empty() {
                        row.first = first;
                    }
                    row.add(x, &Row { first, of: known.of.clone() });
                }
                next.push(row);
            }
        }
        rows = next;
    }
}

/// The window of the cell from 0 to 1: it has the points of the polygon there, and all that those of the next level in
/// the windows of its parts are made of.
fn window(rules: &[Rule], shift: &Q, n: i64) -> Result<[i64; 2], DepthReason> {
    let mut window = [floor(&-shift), -floor(&(shift - int(1)))];
    loop {
        if window[1] - window[0] >= MAX_WINDOW {
            return Err(DepthReason::Stopped(Stop::Capped("the size of a window")));
        }
        let mut wider = window;
        for row in window[0]..window[1] + n {
            let rule = &rules[usize::try_from(row.rem_euclid(n)).unwrap_or(0)];
            for (j, _) in rule {
                let at = row.div_euclid(n) + j;
                wider = [wider[0].min(at), wider[1].max(at)];
            }
        }
        if wider == window {
            return Ok(window);
        }
        window = wider;
    }
}
