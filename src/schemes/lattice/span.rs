//! Spaces that are spanned one vector at a time.

use crate::exact::Rational;

/// The span of some vectors in triangular form.
#[derive(Clone, Debug, Default)]
pub(super) struct Span {
    /// For each dimension: a column, and a vector of the span with 1 there and 0 at the columns before.
    rows: Vec<(usize, Vec<Rational>)>,
}

impl Span {
    /// Adds a vector. Whether it was not in the span before.
    pub(super) fn insert(&mut self, vector: &[Rational]) -> bool {
        let mut rest = self.reduced(vector);
        let Some(column) = rest.iter().position(|x| !x.is_zero()) else { return false };
        let scale = rest[column].recip();
        for x in &mut rest {
            *x *= &scale;
        }
        self.rows.push((column, rest));
        true
    }

    /// What is left of a vector: 0 if it is in the span.
    fn reduced(&self, vector: &[Rational]) -> Vec<Rational> {
        let mut rest = vector.to_vec();
        for (column, row) in &self.rows {
            let factor = rest[*column].clone();
            if !factor.is_zero() {
                let entries = rest.iter_mut().zip(row).filter(|(_, v)| !v.is_zero());
                entries.for_each(|(x, v)| *x -= &(&factor * v));
            }
        }
        rest
    }
}
