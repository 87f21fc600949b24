//! The longest rows, exactly.

use super::levels::{Level, Origin};
use crate::bound::power::PowerNorm;
use crate::bound::walk::Transitions;
use crate::exact::{Integer, Rational};
use std::collections::{BTreeMap, BTreeSet};

/// The most rows of one level that are compared exactly.
const MOST: usize = 4096;

/// Rows of R^m times q^m.
#[derive(Clone, Debug)]
pub(super) struct ExactRows {
    pub(super) matrices: Transitions<Integer>,
    denominator: Integer,
    offset: i64,
}

/// Rows of one level and one group: their entries, and the digits of one row with these entries, the finest
/// first.
type Rows = BTreeMap<Vec<Integer>, Vec<usize>>;

impl ExactRows {
    /// For rules over this denominator q.
    pub(super) fn new(rules: &[Vec<Integer>], denominator: Integer, offset: i64) -> ExactRows {
        ExactRows { matrices: Transitions::new(rules), denominator, offset }
    }

    /// The longest row of these groups of the last level. `None` if more than [`MOST`] rows of a level have to
    /// be compared.
    pub(super) fn longest(&self, levels: &[Level], groups: &[usize]) -> Option<PowerNorm> {
        let needed = needed(levels, groups);
        let mut first = vec![Integer::zero(); self.matrices.length];
        first[0] = Integer::one();
        let mut rows = BTreeMap::from([(0_usize, Rows::from([(first, Vec::new())]))]);
        for (level, needed) in levels.iter().zip(&needed) {
            rows = self.next(&rows, level, needed)?;
        }
        let found = rows
            .into_values()
            .flatten()
            .map(|(row, word)| (row.iter().map(Integer::abs).sum::<Integer>(), word));
        let found: Vec<(Integer, Vec<usize>)> = found.collect();
        let value = found.iter().map(|(value, _)| value).max()?.clone();
        let equal = found.iter().filter(|one| one.0 == value);
        let class = equal.map(|(_, word)| self.class(word)).min()?;
        let scale = self.denominator.pow(u32::try_from(levels.len()).ok()?);
        Some(PowerNorm { value: Rational::new(value, scale), class })
    }

    /// The rows of these groups of the next level.
    fn next(
        &self,
        rows: &BTreeMap<usize, Rows>,
        level: &Level,
        needed: &BTreeSet<usize>,
    ) -> Option<BTreeMap<usize, Rows>> {
        let mut count = 0;
        let group = |&at: &usize| {
            let mut images = Rows::new();
            for &Origin { parent, digit } in &level.groups[at] {
                for (row, word) in &rows[&(parent as usize)] {
                    let mut image = vec![Integer::zero(); row.len()];
                    self.matrices.advance(digit as usize, row, &mut image);
                    // Opposite rows are as long as each other for ever.
                    if image.iter().find(|x| !x.is_zero()).is_some_and(|x| x.sign() < 0) {
                        for x in &mut image {
                            *x = -&*x;
                        }
                    }
                    let word = [&word[..], &[digit as usize]].concat();
                    images.entry(image).or_insert(word);
                    if images.len() > MOST {
                        return None;
                    }
                }
            }
            count += images.len();
            (count <= MOST).then_some((at, images))
        };
        needed.iter().map(group).collect()
    }

    /// The residue class of the row with these digits d_1, …, d_c, the finest first: base_c = 0,
    /// base_{m−1} = n·(base_m − o) + d_m, and the class is base_0 mod n^c.
    fn class(&self, word: &[usize]) -> Integer {
        let arity = Integer::from(self.matrices.edges.len());
        let offset = Integer::from(self.offset);
        let base = word
            .iter()
            .rev()
            .fold(Integer::zero(), |base, &digit| (base - &offset) * &arity + Integer::from(digit));
        let count = u32::try_from(word.len()).expect("at most 256 levels");
        base.div_rem_floor(&arity.pow(count)).1
    }
}

/// For each level the groups from which these groups of the last level come.
fn needed(levels: &[Level], groups: &[usize]) -> Vec<BTreeSet<usize>> {
    let mut needed: Vec<BTreeSet<usize>> = vec![groups.iter().copied().collect()];
    for level in levels.iter().skip(1).rev() {
        let origins = needed[needed.len() - 1].iter().flat_map(|&at| &level.groups[at]);
        let parents = origins.map(|origin| origin.parent as usize).collect();
        needed.push(parents);
    }
    needed.reverse();
    needed
}
