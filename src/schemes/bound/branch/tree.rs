//! The tree of the rows of the powers of an operator.

use super::number::Number;
use super::scaled::Scaled;

/// The numbers of rows, and the coefficients of these rows.
type Terms<T> = Vec<(usize, <T as Number>::Coefficient)>;

/// The step from the rows of q^l·E^l around an index i to the rows of q^{l+1}·E^{l+1}
/// around the indices ni + β of its n parts.
///
/// Row n·i + β + p of E^{l+1} is Σ_j E_{ρ,j} times row i + ⌊(β+p)/n⌋ + o + j of E^l, with
/// ρ = (β + p) mod n. A node stores its rows one after the other, in the order of the
/// window.
pub(super) struct Tree<T: Number> {
    pub(super) size: usize,
    /// The number of the row with p = 0.
    pub(super) own: usize,
    /// The terms for each digit β and position p.
    steps: Vec<Vec<Terms<T>>>,
}

impl<T: Number> Tree<T> {
    /// `None` if a coefficient does not fit.
    pub(super) fn new(scaled: &Scaled) -> Option<Tree<T>> {
        let arity = i64::try_from(scaled.arity).ok()?;
        let row = |digit: i64, position: usize| -> Option<Terms<T>> {
            let fine = digit + scaled.first + i64::try_from(position).ok()?;
            let base = fine.div_euclid(arity) + scaled.offset - scaled.first;
            let rule = &scaled.rows[usize::try_from(fine.rem_euclid(arity)).ok()?];
            let terms = (base..).zip(rule).filter(|(_, x)| !x.is_zero());
            terms.map(|(at, x)| Some((usize::try_from(at).ok()?, T::coefficient(x)?))).collect()
        };
        let step = |digit| (0..scaled.size).map(|position| row(digit, position)).collect();
        Some(Tree {
            size: scaled.size,
            own: usize::try_from(-scaled.first).ok()?,
            steps: (0..arity).map(step).collect::<Option<_>>()?,
        })
    }

    /// The rows of E^0.
    pub(super) fn root(&self) -> Vec<T> {
        let entry = |at: usize| {
            if at.is_multiple_of(self.size + 1) { T::one() } else { T::zero() }
        };
        (0..self.size * self.size).map(entry).collect()
    }

    /// Writes the rows of the part with this digit into `part`.
    pub(super) fn part(&self, digit: usize, rows: &[T], part: &mut [T]) {
        part.fill(T::zero());
        for (fine, terms) in part.chunks_exact_mut(self.size).zip(&self.steps[digit]) {
            for (at, coefficient) in terms {
                let coarse = &rows[at * self.size..(at + 1) * self.size];
                for (sum, x) in fine.iter_mut().zip(coarse) {
                    sum.add_product(x, coefficient);
                }
            }
        }
    }

    /// The average number of products for a part.
    pub(super) fn cost(&self) -> u64 {
        let terms: usize = self.steps.iter().flatten().map(Vec::len).sum();
        (terms / self.steps.len() * self.size) as u64
    }

    /// Σ|x| over the row with p = 0.
    pub(super) fn norm(&self, rows: &[T]) -> T {
        sum_of_magnitudes(&rows[self.own * self.size..(self.own + 1) * self.size])
    }

    /// The greatest Σ|x| over the rows.
    pub(super) fn largest(&self, rows: &[T]) -> T {
        rows.chunks_exact(self.size).map(sum_of_magnitudes).max().unwrap_or_else(T::zero)
    }
}

fn sum_of_magnitudes<T: Number>(row: &[T]) -> T {
    row.iter().fold(T::zero(), |mut sum, x| {
        sum.add_magnitude(x);
        sum
    })
}
