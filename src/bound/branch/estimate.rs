//! Upper bounds over all rows below a node.

use super::number::Number;
use super::tree::Tree;
use crate::exact::Integer;

/// The binary digits behind the point of what bounds are rounded to.
pub(super) const PLACES: u32 = 24;

/// Factors that stay below this in absolute value.
const LARGEST_FACTOR: i64 = 1 << 40;

/// What is known of Σ_p λ_p R_p, the rows m levels below a node with the rows R_p, beyond
/// Σ_p λ_p = 1: an interval of Σ_p λ_p p, and a bound of Σ_p |λ_p|.
#[derive(Clone, Debug)]
pub(super) struct Place {
    /// The position a from which the line through the rows a and a + 1 starts, counted from
    /// the first of the window.
    pub(super) base: usize,
    /// Bounds of Σ_p λ_p p − a, below and above.
    pub(super) ends: [Rounded; 2],
    /// 2^PLACES times the bound of Σ_p |λ_p|; also as a machine number, if it is small.
    pub(super) total: Integer,
    pub(super) factor: Option<i64>,
}

/// A number rounded to PLACES and to more binary digits behind the point.
#[derive(Clone, Debug)]
pub(super) struct Rounded {
    pub(super) coarse: i64,
    pub(super) fine: Integer,
    pub(super) places: u32,
}

impl Place {
    /// `None` if a machine number is too large.
    pub(super) fn new(base: usize, ends: [Rounded; 2], total: Integer) -> Option<Place> {
        let fits = |factor: &i64| factor.abs() < LARGEST_FACTOR;
        let factor = total.to_i64().filter(fits);
        ends.iter().all(|end| fits(&end.coarse)).then_some(Place { base, ends, total, factor })
    }
}

/// The binary digits that an estimate may need beyond those of the entries.
///
/// With X the largest entry and L the size of the window, all numbers are sums of at most
/// L(2L + 2) terms of at most 2^40·X, and two such sums.
pub(super) fn margin(size: usize) -> u64 {
    let length = u64::from((2 * size + 2).ilog2()) + 1;
    u64::from(LARGEST_FACTOR.ilog2()) + 2 * length + 4
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

    /// An upper bound of all Σ_k |Σ_p λ_p R_{p,k}|.
    ///
    /// Source: `proofs/THEOREMS.md`, 62.
    pub(super) fn bound(&mut self, tree: &Tree<T>, rows: &[T], place: &Place) -> Bound {
        let size = tree.size;
        self.deviate(rows, size, place.base);
        for sums in [&mut self.signed, &mut self.rest] {
            sums.fill(T::zero());
        }
        // The sum of the columns whose sign is the same at both ends, and the others.
        let mut line = [T::zero(), T::zero()];
        let mut others = Vec::new();
        for column in 0..size {
            let [first, second] = [0, 1].map(|next| &rows[(place.base + next) * size + column]);
            let at = |end: &Rounded| {
                let mut value = T::times(first, (1 << PLACES) - end.coarse);
                value.add_times(second, end.coarse);
                value
            };
            let values = place.ends.each_ref().map(at);
            let sign = sign(&values);
            if sign == 0 {
                others.push([first.to_integer(), second.to_integer()]);
            } else {
                line[0].add_times(first, sign);
                line[1].add_times(second, sign);
            }
            let certain = sign != 0 && self.within(column, &values, place.factor);
            self.gather(column, size, if certain { sign } else { 0 });
        }
        let mut deviation = T::zero();
        for (signed, rest) in self.signed.iter().zip(&mut self.rest) {
            rest.add_magnitude(signed);
            if *rest > deviation {
                deviation.clone_from(rest);
            }
        }
        Bound { line: line.map(|x| x.to_integer()), others, deviation: deviation.to_integer() }
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

/// The sign of all numbers between the two; 0 if there are several.
fn sign<T: Number>(values: &[T; 2]) -> i64 {
    match values.each_ref().map(Number::is_negative) {
        [true, true] => -1,
        [false, false] => 1,
        _ => 0,
    }
}

/// An upper bound, in parts.
pub(super) struct Bound {
    /// The sum of the columns of one sign, at a and at a + 1.
    line: [Integer; 2],
    /// Each of the other columns.
    others: Vec<[Integer; 2]>,
    /// What Σ_p |λ_p| is multiplied by.
    deviation: Integer,
}

impl Bound {
    /// 2^PLACES·scale times the bound, rounded up.
    pub(super) fn scaled(&self, place: &Place, scale: &Integer) -> Integer {
        let ends = place.ends.each_ref().map(|end| {
            let at = |[first, second]: &[Integer; 2]| {
                first.shifted_left(end.places) + &end.fine * (second - first)
            };
            let others = self.others.iter().map(|column| at(column).abs());
            let sum = at(&self.line) + others.sum::<Integer>();
            // Rounded up.
            -(-(sum * scale)).shifted_right(end.places - PLACES)
        });
        let end = ends.into_iter().max().expect("two ends");
        end + &self.deviation * &place.total * scale
    }
}

fn small(position: usize) -> i64 {
    i64::try_from(position).expect("the window is small")
}
