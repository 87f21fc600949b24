//! Products of large spectral radius.

use super::{Rows, norm, product, spectral_radius};
use crate::stop::check;

/// Products that have the largest ϱ(M_{w_1}⋯M_{w_l})^{1/l} of all that were looked at.
#[derive(Clone, Debug)]
pub struct Candidates {
    /// This number.
    pub rate: f64,
    /// The words w that reach it up to `NEAR`, each the first of its rotations, and no power of
    /// another; the shorter ones first.
    pub words: Vec<Vec<usize>>,
}

/// Rates that differ by less than this factor are taken for one.
pub const NEAR: f64 = 1e-10;

/// Looks at products of up to `longest` factors. Of each length those `beam` are continued that have the
/// largest norm; none is if its norm is below the best rate, to the power of its length, since then no
/// rotation of a better product begins with it in the norm's own reckoning.
#[must_use]
pub fn candidates(matrices: &[Rows], longest: u32, beam: usize) -> Candidates {
    let size = matrices.first().map_or(0, Vec::len);
    let unit = |i: usize| (0..size).map(|j| if i == j { 1.0 } else { 0.0 }).collect();
    let mut level: Vec<(Vec<usize>, Rows)> = vec![(Vec::new(), (0..size).map(unit).collect())];
    let mut best = Candidates { rate: 0.0, words: Vec::new() };
    for length in 1..=longest {
        let root = 1.0 / f64::from(length);
        let mut longer = Vec::new();
        for (word, done) in &level {
            for (i, matrix) in matrices.iter().enumerate() {
                check();
                let product = product(done, matrix);
                let norm = norm(&product);
                if norm.powf(root) < best.rate * (1.0 - NEAR) {
                    continue;
                }
                let word = [&word[..], &[i]].concat();
                best.look_at(&word, &product);
                longer.push((norm, word, product));
            }
        }
        longer.retain(|(norm, ..)| norm.powf(root) >= best.rate * (1.0 - NEAR));
        longer.sort_by(|a, b| b.0.total_cmp(&a.0));
        longer.truncate(beam);
        level = longer.into_iter().map(|(_, word, product)| (word, product)).collect();
    }
    best
}

impl Candidates {
    fn look_at(&mut self, word: &[usize], product: &Rows) {
        let length = u32::try_from(word.len()).expect("a short word");
        let least = (self.rate * (1.0 - NEAR)).powf(f64::from(length));
        let rate = spectral_radius(product, least).powf(1.0 / f64::from(length));
        if rate == 0.0 || rate < self.rate * (1.0 - NEAR) {
            return;
        }
        if rate > self.rate * (1.0 + NEAR) {
            self.words.clear();
            self.rate = rate;
        }
        let word = first_rotation(root_of(word));
        if !self.words.contains(&word) {
            self.words.push(word);
        }
    }
}

/// The shortest word of which this is a power.
fn root_of(word: &[usize]) -> &[usize] {
    let length = word.len();
    let period = |p: &usize| length.is_multiple_of(*p) && word[*p..] == word[..length - p];
    let period = (1..length).find(period).unwrap_or(length);
    &word[..period]
}

fn first_rotation(word: &[usize]) -> Vec<usize> {
    let rotations = (0..word.len()).map(|i| [&word[i..], &word[..i]].concat());
    rotations.min().unwrap_or_default()
}
