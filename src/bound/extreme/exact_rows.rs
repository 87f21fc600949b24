//! Rows of the powers, exactly.

use super::levels::Origin;
use crate::bound::walk::Transitions;
use crate::exact::{Integer, Rational};
use std::collections::BTreeMap;

/// Rows of R^m times q^m, which are computed when they are needed.
#[derive(Clone, Debug)]
pub(super) struct ExactRows {
    pub(super) matrices: Transitions<Integer>,
    denominator: Integer,
    offset: i64,
    /// Rows of one level, by their places, and images of them, of the next level.
    rows: BTreeMap<u32, Vec<Integer>>,
    images: BTreeMap<Origin, Vec<Integer>>,
}

impl ExactRows {
    /// For rules over this denominator q.
    pub(super) fn new(rules: &[Vec<Integer>], denominator: Integer, offset: i64) -> ExactRows {
        let matrices = Transitions::new(rules);
        ExactRows { matrices, denominator, offset, rows: BTreeMap::new(), images: BTreeMap::new() }
    }

    /// The row with these digits, the finest first.
    pub(super) fn row(&self, word: &[usize]) -> Vec<Integer> {
        let mut first = vec![Integer::zero(); self.matrices.length];
        first[0] = Integer::one();
        word.iter().fold(first, |row, &digit| self.image(&row, digit))
    }

    fn image(&self, row: &[Integer], digit: usize) -> Vec<Integer> {
        let mut image = vec![Integer::zero(); row.len()];
        self.matrices.advance(digit, row, &mut image);
        image
    }

    /// Σ|x|, for a row of level m.
    pub(super) fn norm(&self, row: &[Integer], level: u32) -> Rational {
        Rational::new(row.iter().map(Integer::abs).sum::<Integer>(), self.denominator.pow(level))
    }

    /// Whether two images are equal or opposite; `words` are the digits of the rows of their level.
    pub(super) fn same(&mut self, one: Origin, other: Origin, words: &[Vec<usize>]) -> bool {
        for origin in [one, other] {
            if !self.images.contains_key(&origin) {
                let at = origin.parent;
                if !self.rows.contains_key(&at) {
                    self.rows.insert(at, self.row(&words[at as usize]));
                }
                let image = self.image(&self.rows[&at], origin.digit as usize);
                self.images.insert(origin, image);
            }
        }
        let [one, other] = [&self.images[&one], &self.images[&other]];
        one == other || one.iter().zip(other).all(|(x, y)| (x + y).is_zero())
    }

    /// Goes on to the next level, which has the images of these origins.
    pub(super) fn advance(&mut self, kept: &[Origin]) {
        let mut images = std::mem::take(&mut self.images);
        let known = (0..).zip(kept).filter_map(|(at, origin)| Some((at, images.remove(origin)?)));
        self.rows = known.collect();
    }

    /// The residue class of the row with these digits d_1, …, d_c, the finest first: base_c = 0,
    /// base_{m−1} = n·(base_m − o) + d_m, and the class is base_0 mod n^c.
    pub(super) fn class(&self, word: &[usize]) -> Integer {
        let arity = Integer::from(self.matrices.edges.len());
        let offset = Integer::from(self.offset);
        let base = word.iter().rev().fold(Integer::zero(), |base, &digit| {
            (base - &offset) * &arity + Integer::from(digit)
        });
        let count = u32::try_from(word.len()).expect("at most 256 levels");
        base.div_rem_floor(&arity.pow(count)).1
    }
}
