//! Norms of powers of a mask's operator that have too many residue classes to sum each: a tree
//! of rows, and bounds of all rows below a node.

use crate::numbers::{Meter, Q, int, over_one_denominator, unit};
use crate::text::{Checked, Reason, Stop, require};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// A tree that bounds all powers has levels below this one only.
const MAX_LEVEL: u32 = 64;

/// The binary digits after the point to which the data of bounds are rounded upwards.
pub const PLACES: u32 = 32;

/// The rows of q^l·E^l at the positions of the window around an index, in its columns.
type Rows = Vec<Vec<BigInt>>;

/// The operator R = sE with `(Rx)_{ni+β} = Σ_j r_{β,j} x_{i+o+j}`. If all rules r_β have the same
/// sum and it is not 0, s is that sum. Otherwise s is 1.
pub struct Operator<'a> {
    meter: &'a Meter,
    n: i64,
    width: i64,
    offset: i64,
    /// The window is first, …, first + size − 1. It contains 0 and the positions of all rows of
    /// the level before that its rows depend on.
    first: i64,
    size: usize,
    /// The rows of q·E as integers, and q.
    rows: Vec<Vec<BigInt>>,
    over: BigInt,
    /// The factor s.
    pub factor: Q,
    /// The φ and ρ of THEOREMS.md, 61, if the rows of E sum to 1.
    shift: Option<[Q; 2]>,
}

/// Bounds that hold for the rows λ of E^m, for one m. The interval of Σ_p λ_p p is given by a base
/// a and 2^PLACES times its ends less a; the total is 2^PLACES·τ for τ ≥ Σ_p |λ_p|.
struct Reach {
    base: usize,
    ends: Option<[BigInt; 2]>,
    total: BigInt,
}

fn scale() -> BigInt {
    BigInt::one() << PLACES
}

impl<'a> Operator<'a> {
    /// The operator of rules of rational numbers, at the offset of the least window.
    pub fn new(meter: &'a Meter, rules: &[Vec<Q>]) -> Checked<Operator<'a>> {
        let size = |length: usize| i64::try_from(length).unwrap_or(i64::MAX);
        let (n, width) = (size(rules.len()), size(rules[0].len()));
        let windows = (-width..=0).map(|offset| (offset, window(n, width, offset)));
        let least = windows.min_by_key(|(_, (first, last))| last - first);
        let (offset, (first, last)) = least.ok_or(Reason::Malformed("rules"))?;
        let sums: Vec<Q> = rules.iter().map(|rule| rule.iter().sum()).collect();
        let affine = !sums[0].is_zero() && sums.iter().all(|sum| *sum == sums[0]);
        let factor = if affine { sums[0].clone() } else { int(1) };
        let scaled = |rule: &Vec<Q>| rule.iter().map(|x| x / &factor).collect::<Vec<Q>>();
        let scaled: Vec<Vec<Q>> = rules.iter().map(scaled).collect();
        // f_β = Σ_j (o + j)E_{β,j} − β/n
        let moment = |(rule, beta): (&Vec<Q>, i64)| {
            let moment: Q = (offset..).zip(rule).map(|(p, x)| x * int(p)).sum();
            moment - int(beta) / int(n)
        };
        let moments: Vec<Q> = scaled.iter().zip(0..).map(moment).collect();
        let ends = moments.iter().min().zip(moments.iter().max());
        let middle = |(low, high): (&Q, &Q)| [(low + high) / int(2), (high - low) / int(2)];
        let (rows, over) = over_one_denominator(&scaled)?;
        let size = usize::try_from(last - first + 1).unwrap_or(0);
        let shift = ends.filter(|_| affine).map(middle);
        Ok(Operator { meter, n, width, offset, first, size, rows, over, factor, shift })
    }

    /// The rows of E^0.
    fn root(&self) -> Rows {
        unit(self.size, [BigInt::zero(), BigInt::one()])
    }

    /// The rows around n·i + β from the rows around i. Row n·i + β + p of E^(l+1) is Σ_j E_{ρ,j}
    /// times row i + ⌊(β+p)/n⌋ + o + j of E^l, ρ = (β + p) mod n (THEOREMS.md, 60).
    fn part(&self, rows: &Rows, digit: i64) -> Result<Rows, Stop> {
        let bits = rows.iter().flatten().map(BigInt::bits).max().unwrap_or(0);
        let products = (self.size * self.size) as u64 * self.width.unsigned_abs();
        self.meter.spend(products.saturating_mul(1 + bits / 512))?;
        let mut part = vec![vec![BigInt::zero(); self.size]; self.size];
        for (fine, row) in (digit + self.first..).zip(&mut part) {
            let rule = &self.rows[usize::try_from(fine.rem_euclid(self.n)).unwrap_or(0)];
            let base = fine.div_euclid(self.n) + self.offset - self.first;
            for (at, x) in (base..).zip(rule).filter(|(_, x)| !x.is_zero()) {
                let coarse = &rows[usize::try_from(at).unwrap_or(usize::MAX)];
                row.iter_mut().zip(coarse).for_each(|(sum, y)| *sum += x * y);
            }
        }
        Ok(part)
    }

    /// The norm of the row of the index itself.
    fn norm(&self, rows: &Rows) -> BigInt {
        norm(&rows[usize::try_from(-self.first).unwrap_or(0)])
    }

    /// The norm of the rows of R^c whose coefficients are those of the class f mod n^c of the
    /// product of FORMAT.md, with t_{nu+β} = r_{β,N−1−u}.
    pub fn of_class(&self, levels: u32, f: &BigInt) -> Checked<Q> {
        // At offset 0, row m has the class m + (N−1)(n + … + n^c); at offset o, row m − o(n + … +
        // n^c) has it.
        let n = BigInt::from(self.n);
        let powers: BigInt = (1..levels).map(|k| n.pow(k)).sum();
        let mut rest = (f - powers * (self.width - 1 + self.offset)).mod_floor(&n.pow(levels));
        let mut digits = Vec::new();
        for _ in 0..levels {
            digits.push((&rest % &n).to_i64().unwrap_or(0));
            rest /= &n;
        }
        let rows =
            digits.iter().rev().try_fold(self.root(), |rows, &digit| self.part(&rows, digit))?;
        let value = Q::new(self.norm(&rows), self.over.pow(levels));
        Ok(value * self.factor.abs().pow(levels.cast_signed()))
    }

    /// Checks that ‖E^m‖ ≤ τ for all m ≥ 1 (THEOREMS.md, 63).
    pub fn all_at_most(&self, tau: &Q) -> Checked<()> {
        let Some([middle, radius]) = &self.shift else { return Err(Reason::Powers.into()) };
        let nth = Q::new(BigInt::one(), self.n.into());
        let whole = (int(1) - &nth).recip();
        let (limit, radius) = (middle * &whole, radius * tau * &whole);
        let low = middle.min(&limit) - &radius;
        let high = (middle - &nth).max(limit) + int(1) + radius;
        let reach = self.reach([low, high], tau);
        self.descend(|level, rows| {
            let limit = tau * Q::from_integer(self.over.pow(level));
            let fits = level < MAX_LEVEL && Q::from_integer(self.norm(rows)) <= limit;
            require(fits, Reason::Powers)?;
            Ok(level > 0 && bound(rows, &reach) <= limit)
        })
    }

    /// Checks that ‖E^c‖ is at most `limit`, where c = `levels` and ‖E^m‖ ≤ τ_m for m < c. A node
    /// is split unless all rows below it are bounded (THEOREMS.md, 60 to 62).
    pub fn at_most(&self, levels: u32, limit: &Q, tau: impl Fn(u32) -> Q) -> Checked<()> {
        let (nth, mut reaches) = (Q::new(BigInt::one(), self.n.into()), Vec::new());
        let (mut middle, mut radius, mut part) = (int(0), int(0), int(1));
        let [phi, rho] = self.shift.clone().unwrap_or_default();
        for tau in (0..levels).map(tau) {
            let ends = [&middle - &radius, &middle + int(1) - &part + &radius];
            reaches.push(self.reach(ends, &tau));
            (middle, radius, part) =
                (middle * &nth + &phi, radius * &nth + &rho * tau, part * &nth);
        }
        self.descend(|level, rows| {
            let limit = limit * Q::from_integer(self.over.pow(level));
            if level == levels {
                require(Q::from_integer(self.norm(rows)) <= limit, Reason::NotLargest)?;
                return Ok(true);
            }
            Ok(level > 0 && bound(rows, &reaches[(levels - level) as usize]) <= limit)
        })
    }

    /// Visits the nodes from the root on, and splits those that are not closed.
    fn descend(&self, closed: impl Fn(u32, &Rows) -> Checked<bool>) -> Checked<()> {
        let mut stack = vec![(0, self.root())];
        while let Some((level, rows)) = stack.pop() {
            if !closed(level, &rows)? {
                for digit in 0..self.n {
                    stack.push((level + 1, self.part(&rows, digit)?));
                }
            }
        }
        Ok(())
    }

    fn reach(&self, [low, high]: [Q; 2], tau: &Q) -> Reach {
        let last = self.first + i64::try_from(self.size).unwrap_or(0) - 2;
        let middle = ((&low + &high) / int(2)).floor().to_integer().to_i64().unwrap_or(0);
        let base = middle.clamp(self.first, last.max(self.first));
        let unit = Q::from_integer(scale());
        let low = ((low - int(base)) * &unit).floor().to_integer();
        let high = ((high - int(base)) * &unit).ceil().to_integer();
        let lines = self.shift.is_some() && self.size > 1;
        let total = (tau * unit).ceil().to_integer();
        let base = usize::try_from(base - self.first).unwrap_or(0);
        Reach { base, ends: lines.then_some([low, high]), total }
    }
}

/// A bound of Σ_k |Σ_p λ_p R_{p,k}| for all λ that keep the bounds of `reach` and sum to 1.
fn bound(rows: &Rows, reach: &Reach) -> Q {
    let largest = rows.iter().map(|row| norm(row)).max().unwrap_or_default();
    let bound = &reach.total * largest;
    let line = reach.ends.as_ref().map(|ends| by_line(rows, reach, ends));
    Q::new(line.filter(|line| *line < bound).unwrap_or(bound), scale())
}

/// 2^PLACES times the bound by the line through two rows (THEOREMS.md, 62).
fn by_line(rows: &Rows, reach: &Reach, ends: &[BigInt; 2]) -> BigInt {
    let mut sums = [BigInt::zero(), BigInt::zero()];
    let mut off = vec![[BigInt::zero(), BigInt::zero()]; rows.len()];
    for k in 0..rows.len() {
        let start = &rows[reach.base][k];
        let step = &rows[reach.base + 1][k] - start;
        // A_k at both ends, and V_{p,k}.
        let values = ends.each_ref().map(|end| (start << PLACES) + &step * end);
        let from = -i64::try_from(reach.base).unwrap_or(0);
        let line = |p: i64| start + &step * p;
        let deviations: Vec<BigInt> =
            (from..).zip(rows).map(|(p, row)| &row[k] - line(p)).collect();
        let radius = deviations.iter().map(Signed::abs).max().unwrap_or_default() * &reach.total;
        let certain = [1, -1].into_iter().find(|sign| values.iter().all(|x| x * sign >= radius));
        for ([signed, rest], deviation) in off.iter_mut().zip(deviations) {
            match certain {
                Some(sign) => *signed += deviation * sign,
                None => *rest += deviation.abs(),
            }
        }
        sums.iter_mut().zip(&values).for_each(|(sum, value)| *sum += value.abs());
    }
    let off = off.into_iter().map(|[signed, rest]| signed.abs() + rest).max();
    let [low, high] = sums;
    low.max(high) + off.unwrap_or_default() * &reach.total
}

fn norm(row: &[BigInt]) -> BigInt {
    row.iter().map(Signed::abs).sum()
}

/// The least window that contains 0 and the positions ⌊(β+p)/n⌋ + o + j of every p in it.
fn window(n: i64, width: i64, offset: i64) -> (i64, i64) {
    let (mut first, mut last) = (0_i64, 0_i64);
    loop {
        let from = first.min(first.div_euclid(n) + offset);
        let to = last.max((n - 1 + last).div_euclid(n) + offset + width - 1);
        if (from, to) == (first, last) {
            return (first, last);
        }
        (first, last) = (from, to);
    }
}
