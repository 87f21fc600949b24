//! Numbers as sums of few cosines C_k, where k may go beyond the basis C_0, …, C_{m−1}.

use super::field::{Field, Terms};
use crate::exact::Integer;

/// Up to this many terms, no search for a sum of fewer terms is made.
const FEW: usize = 2;

/// The greatest conductor n with a search for fewer terms: the search stores up to m(n/2
/// − m) numbers.
const MAX_SEARCHED: usize = 2_000;

impl Field {
    /// For k = m, …, ⌊n/2⌋, the pairs (j, a_j) with a_j ≠ 0 in C_k = Σ_{j<m} a_j C_j, by
    /// the recurrence C_{k+1} = C_1 C_k − C_{k−1}. The list ends before the first k with
    /// a coefficient beyond `i64`.
    pub(super) fn find_reduced(&self) -> Vec<Terms> {
        let unit = |k: usize| {
            let mut sum = self.room();
            sum[k] = Integer::one();
            self.reduce(sum)
        };
        let (first, most) = (unit(1), self.conductor() / 2);
        let start = (unit(self.degree() - 1), unit(self.degree()));
        let pairs = std::iter::successors(Some(start), |(before, this)| {
            let product = self.multiply(&first, this);
            let next = product.iter().zip(before).map(|(a, b)| a - b).collect();
            Some((this.clone(), next))
        });
        let words = |(_, cosine): (Vec<Integer>, Vec<Integer>)| {
            let terms = cosine.iter().enumerate().filter(|(_, a)| !a.is_zero());
            terms.map(|(j, a)| Some((j, a.to_i64()?))).collect()
        };
        pairs.take(most + 1 - self.degree()).map_while(words).collect()
    }

    /// The element with these `numerators` as Σ_k a_k C_k, k = 0, …, ⌊n/2⌋, with few terms.
    /// The search is greedy. For each C_k with k ≥ m it considers the multiple that cancels
    /// the coefficient at the last basis element of C_k, and subtracts the multiple that
    /// leaves the fewest terms, as long as the number of terms decreases. So α + βC_k, which
    /// may have m coefficients in the basis, has two terms again. Elements with a coefficient
    /// beyond `i64` are returned as they are.
    pub(super) fn sparse(&self, numerators: &[Integer]) -> Vec<(usize, Integer)> {
        let terms = || numerators.iter().enumerate().filter(|(_, a)| !a.is_zero());
        let words: Option<Vec<i64>> = numerators.iter().map(Integer::to_i64).collect();
        let (Some(mut rest), true) = (words, terms().count() > FEW) else {
            return terms().map(|(k, a)| (k, a.clone())).collect();
        };
        let mut found = Vec::new();
        if self.conductor() <= MAX_SEARCHED {
            let cosines = self.reduced();
            while let Some((k, factor)) = self.fewer(&rest, &cosines) {
                for (i, a) in &cosines[k - self.degree()] {
                    rest[*i] -= factor * a;
                }
                found.push((k, factor));
            }
        }
        let rest = rest.into_iter().enumerate().filter(|(_, a)| *a != 0);
        rest.chain(found).map(|(k, a)| (k, Integer::from(a))).collect()
    }

    /// The k and the factor for which subtracting factor·C_k leaves the fewest terms, the
    /// new term of C_k included. `None` when no choice decreases the number of terms.
    fn fewer(&self, number: &[i64], cosines: &[Terms]) -> Option<(usize, i64)> {
        let now = number.iter().filter(|a| **a != 0).count();
        let after = |(k, cosine): (usize, &Terms)| {
            let (last, a) = cosine.last()?;
            let factor = number[*last].checked_div(*a)?;
            if factor == 0 || factor.checked_mul(*a)? != number[*last] {
                return None;
            }
            let (mut after, mut exact) = (now + 1, true);
            for (i, a) in cosine {
                let (before, product) = (number[*i], factor.checked_mul(*a)?);
                exact &= before.checked_sub(product).is_some();
                after += usize::from(before == 0);
                after -= usize::from(before == product);
            }
            (exact && after < now).then_some((after, k, factor))
        };
        let cosines = (self.degree()..).zip(cosines);
        let best = cosines.filter_map(after).min_by_key(|(after, ..)| *after);
        best.map(|(_, k, factor)| (k, factor))
    }
}
