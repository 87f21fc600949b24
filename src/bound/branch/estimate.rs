//! Upper bounds over all rows below a node.

use super::number::Number;
use super::scaled::PLACES;
use super::tree::Tree;
use crate::exact::Integer;

/// Factors that stay below this in absolute value.
const LARGEST_FACTOR: i64 = 1 << 40;

/// What is known of Σ_p λ_p R_p, the rows m levels below a node with the rows R_p, beyond
/// Σ_p λ_p = 1: an interval of Σ_p λ_p p, and a bound of Σ_p |λ_p|.
#[derive(Clone, Debug)]
pub(super) struct Place<N> {
    /// The position a from which the line through the rows a and a + 1 starts, counted from
    /// the first of the window.
    base: usize,
    /// 2^PLACES times bounds of Σ_p λ_p p − a, below and above.
    coarse: [i64; 2],
    /// `unit` times the same, nearer.
    fine: [N; 2],
    /// `unit` times the bound of Σ_p |λ_p|; 2^PLACES times it, if that is small.
    total: N,
    factor: Option<i64>,
    /// `unit` times what the moment of row t of E^m, 0 ≤ t < n^m, may be away from the point that
    /// divides the interval as t divides 0, …, n^m − 1.
    stray: N,
    /// fraction·q^m.
    unit: N,
}

/// `unit` times an upper bound of each row below a node: of row t of them, the value at t of the
/// line from the first number, at 0, to the second, at n^m − 1.
pub(super) struct Line<T> {
    bounds: [T; 2],
    /// `unit` times the norms of the combinations of two rows at the ends alone.
    norms: [T; 2],
}

impl<T: Number> Line<T> {
    /// The bound of all of them.
    pub(super) fn greatest(&self) -> T {
        let [low, high] = &self.bounds;
        low.max(high).clone()
    }

    /// The greatest product of the norms of several lines at one end.
    pub(super) fn promise(lines: &[Line<T>]) -> T {
        let at = |end: usize| {
            let norms = lines.iter().map(|line| line.norms[end].clone());
            norms.reduce(|x, y| x.product(&y)).unwrap_or_else(T::zero)
        };
        at(0).max(at(1))
    }

    /// A bound of the products of the values of two lines.
    ///
    /// Source: `proofs/THEOREMS.md`, 65.
    pub(super) fn product(&self, other: &Line<T>) -> T {
        let ([a, b], [c, d]) = (&self.bounds, &other.bounds);
        let ends = a.product(c).max(b.product(d));
        let bend = b.clone().minus(a).product(&c.clone().minus(d));
        if bend.is_negative() { ends } else { ends.plus(&bend.quarter()) }
    }
}

impl Place<Integer> {
    /// `None` if a bound of the moments is too large.
    pub(super) fn new(
        base: usize,
        coarse: [i64; 2],
        fine: [Integer; 2],
        stray: Integer,
        total: Integer,
        unit: Integer,
    ) -> Option<Place<Integer>> {
        let fits = |factor: &i64| factor.abs() < LARGEST_FACTOR;
        let factor = -(-total.shifted_left(PLACES)).div_floor(&unit);
        let factor = factor.to_i64().filter(fits);
        coarse.iter().all(fits).then_some(Place { base, coarse, fine, total, factor, stray, unit })
    }

    /// The same in other integers.
    pub(super) fn fixed<T: Number>(&self) -> Place<T> {
        Place {
            base: self.base,
            coarse: self.coarse,
            fine: self.fine.each_ref().map(T::from_integer),
            total: T::from_integer(&self.total),
            factor: self.factor,
            stray: T::from_integer(&self.stray),
            unit: T::from_integer(&self.unit),
        }
    }
}

/// The binary digits that an estimate may need beyond those of X·`total`, X the largest entry.
///
/// With L the size of the window, `total` ≥ `unit` ≥ 2^24. All numbers are sums of at most
/// L(2L + 2) terms of at most 2^17·X·`total`, and two such sums.
pub(super) fn margin(size: usize) -> u64 {
    let length = u64::from((2 * size + 2).ilog2()) + 1;
    u64::from(LARGEST_FACTOR.ilog2() - PLACES) + 2 * length + 4
}

/// The space that estimates are computed in.
pub(super) struct Estimator<T> {
    deviations: Vec<T>,
    spreads: Vec<T>,
    signed: Vec<T>,
    rest: Vec<T>,
}

impl<T: Number> Estimator<T> {
    pub(super) fn new(size: usize) -> Estimator<T> {
        let zeros = |count| vec![T::zero(); count];
        let (deviations, spreads) = (zeros(size * size), zeros(size));
        Estimator { deviations, spreads, signed: zeros(size), rest: zeros(size) }
    }

    /// `unit` times an upper bound of all Σ_k |Σ_p λ_p R_{p,k}|.
    ///
    /// Source: `proofs/THEOREMS.md`, 62.
    pub(super) fn bound(&mut self, tree: &Tree<T>, rows: &[T], place: &Place<T>) -> T {
        self.line(tree, rows, place).greatest()
    }

    /// The same as a line, if no moment strays.
    pub(super) fn line(&mut self, tree: &Tree<T>, rows: &[T], place: &Place<T>) -> Line<T> {
        let size = tree.size;
        self.deviate(rows, size, place.base);
        for sums in [&mut self.signed, &mut self.rest] {
            sums.fill(T::zero());
        }
        // The sum of the columns whose sign is the same at both ends, and of the others there.
        let mut line = [T::zero(), T::zero()];
        let mut ends = [T::zero(), T::zero()];
        for column in 0..size {
            let [first, second] = [0, 1].map(|next| &rows[(place.base + next) * size + column]);
            let values = place.coarse.map(|end| {
                let mut value = T::times(first, (1 << PLACES) - end);
                value.add_times(second, end);
                value
            });
            let sign = sign(&values);
            if sign == 0 {
                let at_ends = place.at_ends(first, second);
                ends.iter_mut().zip(&at_ends).for_each(|(sum, value)| sum.add_magnitude(value));
            } else {
                line[0].add_times(first, sign);
                line[1].add_times(second, sign);
            }
            let certain = sign != 0 && self.within(column, &values, place.factor);
            self.gather(column, size, if certain { sign } else { 0 });
        }
        let at_ends = place.at_ends(&line[0], &line[1]);
        ends.iter_mut().zip(&at_ends).for_each(|(sum, value)| sum.add_times(value, 1));
        let mut deviation = T::zero();
        for (signed, rest) in self.signed.iter().zip(&mut self.rest) {
            rest.add_magnitude(signed);
            if *rest > deviation {
                deviation.clone_from(rest);
            }
        }
        let deviation = deviation.product(&place.total);
        Line { bounds: ends.clone().map(|end| end.plus(&deviation)), norms: ends }
    }

    /// The line with what moments may stray.
    pub(super) fn strayed(line: Line<T>, tree: &Tree<T>, rows: &[T], place: &Place<T>) -> Line<T> {
        let (first, second) = rows[place.base * tree.size..].split_at(tree.size);
        let step = first.iter().zip(second).fold(T::zero(), |mut sum, (x, y)| {
            sum.add_magnitude(&y.clone().minus(x));
            sum
        });
        let stray = step.product(&place.stray);
        Line { bounds: line.bounds.map(|end| end.plus(&stray)), ..line }
    }

    /// Whether the largest deviation of a column, times the bound of Σ_p |λ_p|, is at most
    /// its value at both ends.
    fn within(&self, column: usize, values: &[T; 2], factor: Option<i64>) -> bool {
        let spread = &self.spreads[column];
        let radius = match factor {
            Some(factor) => T::times(spread, factor),
            None if *spread == T::zero() => return true,
            None => return false,
        };
        values.iter().all(|value| value.magnitude() >= radius)
    }

    /// The rows less the line through two of them, and the largest of each column.
    fn deviate(&mut self, rows: &[T], size: usize, base: usize) {
        self.spreads.fill(T::zero());
        let (first, second) = rows[base * size..].split_at(size);
        let lines = self.deviations.chunks_exact_mut(size).zip(rows.chunks_exact(size));
        for (steps, (deviations, row)) in (-small(base)..).zip(lines) {
            for (column, (deviation, x)) in deviations.iter_mut().zip(row).enumerate() {
                deviation.clone_from(x);
                deviation.add_times(&first[column], steps - 1);
                deviation.add_times(&second[column], -steps);
                let size = deviation.magnitude();
                if size > self.spreads[column] {
                    self.spreads[column] = size;
                }
            }
        }
    }

    /// Adds a column whose sign is known to the signed sum of all such, and another one to
    /// the sum of magnitudes.
    fn gather(&mut self, column: usize, size: usize, sign: i64) {
        let deviations = self.deviations.iter().skip(column).step_by(size);
        for (deviation, (signed, rest)) in
            deviations.zip(self.signed.iter_mut().zip(&mut self.rest))
        {
            if sign == 0 {
                rest.add_magnitude(deviation);
            } else {
                signed.add_times(deviation, sign);
            }
        }
    }
}

impl<T: Number> Place<T> {
    /// `unit` times the line through two numbers, at both ends.
    fn at_ends(&self, first: &T, second: &T) -> [T; 2] {
        let (start, step) = (first.product(&self.unit), second.clone().minus(first));
        self.fine.each_ref().map(|end| step.product(end).plus(&start))
    }
}

/// The sign of all numbers between the two; 0 if there are several.
fn sign<T: Number>(values: &[T; 2]) -> i64 {
    match values.each_ref().map(Number::is_negative) {
        [true, true] => -1,
        [false, false] => 1,
        _ => 0,
    }
}

fn small(position: usize) -> i64 {
    i64::try_from(position).expect("the window is small")
}
