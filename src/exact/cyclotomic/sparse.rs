//! Numbers in few cosines, more than the m of the basis being allowed.

use super::field::{Field, Terms};
use crate::exact::Integer;

/// The numbers with so few terms that none are worth the search for fewer.
const FEW: usize = 2;

/// The greatest conductor at which fewer are looked for: m(n/2 − m) numbers are kept.
const MAX_SEARCHED: usize = 2_000;

impl Field {
    /// The (j, a_j) with a_j ≠ 0 in C_k = Σ_{j<m} a_j C_j, for k = m, …, ⌊n/2⌋ as long as
    /// these are words: C_{k+1} = C_1 C_k − C_{k−1}.
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

    /// The same number as Σ_k a_k C_k with k = 0, …, ⌊n/2⌋ and few terms, as far as they are
    /// easily found: while some multiple of a C_k, k ≥ m, that takes the last of its
    /// coefficients away leaves fewer terms, it is taken away. So α + βC_k, with up to m
    /// coefficients in the basis, has two terms again. Numbers beyond words stay as they are.
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

    /// The k and the factor of C_k that leave the fewest terms, counting their own, if these
    /// are fewer than there are.
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
