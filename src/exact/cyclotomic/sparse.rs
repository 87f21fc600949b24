//! Numbers in few cosines, more than the m of the basis being allowed.

use super::field::Field;
use crate::exact::Integer;

/// The numbers with so few terms that none are worth the search for fewer.
const FEW: usize = 2;

/// The greatest conductor at which fewer are looked for: m(n/2 − m) numbers are kept.
const MAX_SEARCHED: usize = 2_000;

impl Field {
    /// The (j, a_j) with a_j ≠ 0 in C_k = Σ_{j<m} a_j C_j, for k = m, …, ⌊n/2⌋ as long as
    /// these are words: C_{k+1} = C_1 C_k − C_{k−1}.
    fn reduced_cosines(&self) -> &[Vec<(usize, i64)>] {
        self.reduced.get_or_init(|| {
            let unit = |k: usize| {
                let mut sum = self.room();
                sum[k] = Integer::one();
                self.reduce(sum)
            };
            let (first, most) = (unit(1), self.conductor() / 2);
            let pairs = std::iter::successors(
                Some((unit(self.degree() - 1), unit(self.degree()))),
                |(before, this)| {
                    let product = self.multiply(&first, this);
                    let next = product.iter().zip(before).map(|(a, b)| a - b).collect();
                    Some((this.clone(), next))
                },
            );
            let words = |(_, cosine): (Vec<Integer>, Vec<Integer>)| {
                let terms = cosine.iter().enumerate().filter(|(_, a)| !a.is_zero());
                terms.map(|(j, a)| Some((j, a.to_i64()?))).collect()
            };
            pairs.take(most + 1 - self.degree()).map_while(words).collect()
        })
    }

    /// The same number as Σ_k a_k C_k with k = 0, …, ⌊n/2⌋ and few terms, as far as they are
    /// easily found: while some multiple of a C_k, k ≥ m, that takes the last of its
    /// coefficients away leaves fewer terms, it is taken away. So α + βC_k, with up to m
    /// coefficients in the basis, has two terms again.
    pub(super) fn sparse(&self, numerators: &[Integer]) -> Vec<(usize, Integer)> {
        let terms = |rest: &[Integer]| rest.iter().filter(|a| !a.is_zero()).count();
        let (mut rest, mut found) = (numerators.to_vec(), Vec::new());
        let mut count = terms(&rest);
        while count > FEW && self.conductor() <= MAX_SEARCHED {
            let less = |(k, cosine): &(usize, &Vec<(usize, i64)>)| {
                let factor = factor(&rest, cosine)?;
                let gone = cosine.iter().filter(|(i, a)| rest[*i] == &factor * Integer::from(*a));
                let new = cosine.iter().filter(|(i, _)| rest[*i].is_zero());
                let left = count + 1 + new.count() - gone.count();
                (left < count).then_some((left, *k, factor))
            };
            let cosines = (self.degree()..).zip(self.reduced_cosines());
            let Some((_, k, factor)) =
                cosines.filter_map(|it| less(&it)).min_by_key(|(left, k, _)| (*left, *k))
            else {
                break;
            };
            for (i, a) in &self.reduced_cosines()[k - self.degree()] {
                rest[*i] -= &(&factor * Integer::from(*a));
            }
            found.push((k, factor));
            count = terms(&rest);
        }
        let rest = rest.into_iter().enumerate().filter(|(_, a)| !a.is_zero());
        rest.chain(found).collect()
    }
}

/// What times this cosine has the same last coefficient as the number; unless that is 0.
fn factor(number: &[Integer], cosine: &[(usize, i64)]) -> Option<Integer> {
    let (last, a) = cosine.last()?;
    let (factor, remainder) = number[*last].div_rem_floor(&Integer::from(*a));
    (!factor.is_zero() && remainder.is_zero()).then_some(factor)
}
