//! Upper bounds of the norms of all rows below a node.

use super::number::Number;
use super::scaled::PLACES;
use super::tree::Tree;
use crate::exact::{Integer, within};

/// The bound on the absolute values of the factors in `coarse` and `factor`.
const LARGEST_FACTOR: i64 = 1 << 40;

/// Facts about the rows Σ_p λ_p R_p that are m levels below a node with the rows R_p,
/// besides Σ_p λ_p = 1: an interval of the moment Σ_p λ_p p, and a bound of Σ_p |λ_p|.
#[derive(Clone, Debug)]
pub(super) struct Place<N> {
    /// The position a of the line through the rows a and a + 1, counted from the start of
    /// the window.
    base: usize,
    /// 2^PLACES times a lower and an upper bound of Σ_p λ_p p − a.
    coarse: [i64; 2],
    /// `unit` times closer bounds of Σ_p λ_p p − a.
    fine: [N; 2],
    /// `unit` times the bound of Σ_p |λ_p|.
    total: N,
    factor: Option<i64>,
    /// `unit` times a bound of the distance between the moment of row t of E^m, 0 ≤ t < n^m, and
    /// the point at the fraction t/(n^m − 1) of the interval.
    stray: N,
    /// fraction·q^m.
    unit: N,
    /// Bounds of the single |λ_p|, times 2^PLACES and times `unit`; empty if none are known.
    entries: Vec<(i64, N)>,
}

/// Upper bounds of the norms of the rows t = 0, …, n^m − 1 below a node, as a function that is
/// affine in t. The two numbers in `bounds` are `unit` times its values at t = 0 and t = n^m
/// − 1.
pub(super) struct Line<T> {
    bounds: [T; 2],
    /// `unit` times the norms at both ends of the line through two rows, without the
    /// deviations of the other rows.
    norms: [T; 2],
}

impl<T: Number> Line<T> {
    /// `unit` times a bound for all t.
    pub(super) fn greatest(&self) -> T {
        let [low, high] = &self.bounds;
        low.max(high).clone()
    }

    /// The product of the norms of several lines at the end where it is greater.
    pub(super) fn promise(lines: &[Line<T>]) -> T {
        let at = |end: usize| {
            let norms = lines.iter().map(|line| line.norms[end].clone());
            norms.reduce(|x, y| x.product(&y)).unwrap_or_else(T::zero)
        };
        at(0).max(at(1))
    }

    /// A bound of the product of two lines over all t.
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
        let fits = |factor: i64| within(factor, LARGEST_FACTOR - 1);
        let factor = -(-total.shifted_left(PLACES)).div_floor(&unit);
        let factor = factor.to_i64().and_then(fits);
        let entries = Vec::new();
        coarse.iter().all(|factor| fits(*factor).is_some()).then_some(Place {
            base,
            coarse,
            fine,
            total,
            factor,
            stray,
            unit,
            entries,
        })
    }

    /// This place with these bounds of the single |λ_p|, times 2^PLACES.
    pub(super) fn with_entries(self, entries: &[i64]) -> Place<Integer> {
        let scaled = |x: &i64| (&self.unit * Integer::from(*x)).shifted_right(PLACES);
        // `unit` is a multiple of 2^PLACES.
        let entries = entries.iter().map(|x| (*x, scaled(x))).collect();
        Place { entries, ..self }
    }

    /// This place without bounds of the single |λ_p|.
    pub(super) fn without_entries(&self) -> Place<Integer> {
        Place { entries: Vec::new(), ..self.clone() }
    }

    /// This place with its numbers in another type of integers.
    pub(super) fn fixed<T: Number>(&self) -> Place<T> {
        Place {
            base: self.base,
            coarse: self.coarse,
            fine: self.fine.each_ref().map(T::from_integer),
            total: T::from_integer(&self.total),
            factor: self.factor,
            stray: T::from_integer(&self.stray),
            unit: T::from_integer(&self.unit),
            entries: self.entries.iter().map(|(x, y)| (*x, T::from_integer(y))).collect(),
        }
    }
}

/// The binary digits that an estimate may need beyond those of X·`total`, where X is the
/// largest entry.
///
/// With L the size of the window, `total` ≥ `unit` ≥ 2^24. All numbers are sums of at most
/// L(2L + 2) terms of at most 2^17·X·`total`, and two such sums.
pub(super) fn margin(size: usize) -> u64 {
    let length = u64::from((2 * size + 2).ilog2()) + 1;
    u64::from(LARGEST_FACTOR.ilog2() - PLACES) + 2 * length + 4
}

/// Working memory for estimates.
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

    /// `unit` times an upper bound of Σ_k |Σ_p λ_p R_{p,k}| for all λ that `place`
    /// admits.
    ///
    /// Source: `proofs/THEOREMS.md`, 62.
    pub(super) fn bound(&mut self, tree: &Tree<T>, rows: &[T], place: &Place<T>) -> T {
        self.line(tree, rows, place).greatest()
    }

    /// The same bound as a line. It is valid for each t if `stray` is 0; otherwise
    /// [`strayed`](Self::strayed) must be applied.
    pub(super) fn line(&mut self, tree: &Tree<T>, rows: &[T], place: &Place<T>) -> Line<T> {
        let size = tree.size;
        self.deviate(rows, size, place.base);
        for sums in [&mut self.signed, &mut self.rest] {
            sums.fill(T::zero());
        }
        // `line` sums the columns whose sign is the same at both ends. `ends` sums the
        // magnitudes of the other columns at the ends.
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
            let certain = sign != 0 && self.within(column, &values, place);
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
        let mut deviation = deviation.product(&place.total);
        if !place.entries.is_empty() {
            let terms = self.rest.iter().zip(&place.entries);
            let single =
                terms.fold(T::zero(), |sum, (rest, (_, bound))| sum.plus(&rest.product(bound)));
            deviation = deviation.min(single);
        }
        Line { bounds: ends.clone().map(|end| end.plus(&deviation)), norms: ends }
    }

    /// The line with its bounds raised for moments that are up to `stray` away.
    pub(super) fn strayed(line: Line<T>, tree: &Tree<T>, rows: &[T], place: &Place<T>) -> Line<T> {
        let (first, second) = rows[place.base * tree.size..].split_at(tree.size);
        let step = first.iter().zip(second).fold(T::zero(), |mut sum, (x, y)| {
            sum.add_magnitude(&y.clone().minus(x));
            sum
        });
        let stray = step.product(&place.stray);
        Line { bounds: line.bounds.map(|end| end.plus(&stray)), ..line }
    }

    /// Whether the largest deviation in a column, times the bound of Σ_p |λ_p|, is at most
    /// the column's absolute value at both ends.
    fn within(&self, column: usize, values: &[T; 2], place: &Place<T>) -> bool {
        let spread = &self.spreads[column];
        if !place.entries.is_empty() {
            let deviations = self.deviations.iter().skip(column).step_by(place.entries.len());
            let mut radius = T::zero();
            for (deviation, (bound, _)) in deviations.zip(&place.entries) {
                radius.add_times(&deviation.magnitude(), *bound);
            }
            if values.iter().all(|value| value.magnitude() >= radius) {
                return true;
            }
        }
        let radius = match place.factor {
            Some(factor) => T::times(spread, factor),
            None if *spread == T::zero() => return true,
            None => return false,
        };
        values.iter().all(|value| value.magnitude() >= radius)
    }

    /// Computes the deviations of the rows from the line through two of them, and the
    /// largest deviation in each column.
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

    /// Adds the deviations of a column to the signed sums if its sign is known, and
    /// otherwise their magnitudes to the other sums.
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
    /// `unit` times the values at both ends of the line through the numbers `first` and
    /// `second`.
    fn at_ends(&self, first: &T, second: &T) -> [T; 2] {
        let (start, step) = (first.product(&self.unit), second.clone().minus(first));
        self.fine.each_ref().map(|end| step.product(end).plus(&start))
    }
}

/// The common sign of two values; 0 if the signs differ.
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
