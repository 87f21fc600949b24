//! How far nets of a mask on Z^d are from their limits: bounds from both sides, level by level.

use super::constants::{LatticeConstants, normalised};
use super::displacement::{Between, displacements, less, weights};
use super::norm::{Edges, NormError};
use super::powers::{Functional, Steps};
use super::values::values_at_integers;
use crate::bound::SoundBound;
use crate::exact::Rational;
use crate::scheme::{LatticeMask, Point, difference};
use std::collections::{BTreeMap, BTreeSet};

/// The most functionals of one level.
const MAX_FUNCTIONALS: usize = 1 << 12;

/// The places of a cell at which limits are compared with nets are about so many, of the first two levels and of the others.
const PLACES: [usize; 2] = [64, 16];

/// The most levels.
const MAX_LEVELS: u32 = 6;

/// C_k, the greatest |P^∞(x) − P^k(x)| of all data that differ by at most 1 along edges, from both sides. P^k is between the points of level k, which
/// stand at M^{−k}(α + τ), as in [`displacement`](super::displacement).
#[derive(Clone, Debug)]
pub struct LatticeDistance {
    /// E_i, the greatest |P^{i+1}(x) − P^i(x)|, i = 0, 1, …; E_0 is σ.
    pub displacements: Vec<Rational>,
    /// Numbers that are not above C_0, C_1, …
    pub lower: Vec<Rational>,
    /// T_0 = 1, T_1, …
    tail: SoundBound,
}

impl LatticeDistance {
    /// The bounds of the first levels. `constants` are T_0 = 1, T_1, … `None` in three dimensions with an M that is not diagonal, and where no T_c
    /// is below 1, so that convergence is not shown.
    ///
    /// E_i and the lower ends are norms of functionals on the data, which are all known exactly: P^{i+1} − P^i at the corners of the common refinement
    /// of two levels, and P^∞ − P^k at the points M^{−k−j}α, where P^∞ is Σ_β φ(β)p^{k+j}_{α−β}. `proofs/THEOREMS.md`, 151.
    ///
    /// # Errors
    /// When a functional has too many places.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::lattice::{LatticeConstants, LatticeDistance, natural_shift};
    /// use subcert::scheme::parse_lattice;
    ///
    /// // Loop's scheme on the regular net: a quarter of the distance is left after one level.
    /// let mask = parse_lattice("(1+x)^2*(1+y)^2*(1+x*y)^2/16:edges=[[1,0],[0,1],[1,1]]")?;
    /// let constants = [1, 2, 4].map(|n| Rational::new(1, n)).to_vec();
    /// let found = LatticeDistance::of(&mask, &natural_shift(&mask), constants)?.expect("in the plane");
    /// assert_eq!(found.lower[..2], [Rational::new(1, 2), Rational::new(1, 8)]);
    /// assert!(found.upper(1).is_some_and(|bound| bound < Rational::new(1, 7)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(
        mask: &LatticeMask,
        shift: &[Rational],
        constants: Vec<Rational>,
    ) -> Result<Option<LatticeDistance>, NormError> {
        if constants.iter().all(|bound| *bound >= Rational::one()) {
            return Ok(None);
        }
        let Some((between, moves)) = displacements(mask, shift) else { return Ok(None) };
        let Ok(Some(values)) = values_at_integers(mask) else { return Ok(None) };
        let apart = PLACES.map(|count| to_limit(mask, shift, between, &values, count));
        let edges = Edges::new(mask.edges(), mask.dimension());
        let mut all = LatticeConstants::new(mask);
        let (mut moved, mut lower) = (Vec::new(), Vec::new());
        for level in 0..=MAX_LEVELS {
            let apart = &apart[usize::from(level > 1)];
            let classes = mask.dilation().class_count().saturating_pow(level);
            let count = classes.saturating_mul(moves.len().max(apart.len()));
            if level > 0 && (count > MAX_FUNCTIONALS || all.advance().is_err()) {
                break;
            }
            moved.push(greatest(&edges, all.steps(), &moves)?);
            lower.push(greatest(&edges, all.steps(), apart)?);
        }
        let tail = SoundBound::of(Rational::one(), constants);
        Ok(Some(LatticeDistance { displacements: moved, lower, tail }))
    }

    /// A number that is not below C_k: E_k + … + E_{n−1} + E_n(T_0 + T_1 + …), or, beyond the last level n, E_n(T_{k−n} + …).
    #[must_use]
    pub fn upper(&self, k: u32) -> Option<Rational> {
        let (last, known) = self.displacements.split_last()?;
        let n = u32::try_from(known.len()).ok()?;
        let (rest, _) = self.tail.level(k.saturating_sub(n))?;
        let sum: Rational = known.iter().skip(usize::try_from(k).ok()?).cloned().sum();
        Some(sum + rest * last)
    }

    /// The least level that is not too few, as far as that is shown, and a level that is enough, for a spread and a tolerance.
    #[must_use]
    pub fn depth(&self, spread: &Rational, tolerance: &Rational, most: u32) -> (u32, Option<u32>) {
        let short = self.lower.iter().take_while(|bound| *bound * spread > *tolerance).count();
        let enough = |k: &u32| self.upper(*k).is_some_and(|bound| bound * spread <= *tolerance);
        (u32::try_from(short).unwrap_or(u32::MAX), (0..=most).find(enough))
    }
}

/// The greatest norm of functionals of the data of level k, at all their places.
fn greatest(
    edges: &Edges,
    steps: &Steps<'_, Rational>,
    functionals: &[Functional<Rational>],
) -> Result<Rational, NormError> {
    let (rows, mut seen, mut most) = (steps.rows(), BTreeSet::new(), Rational::zero());
    for (digit, _) in &rows {
        for functional in functionals {
            let pulled = steps.pulled(&rows, functional, *digit);
            if seen.insert(normalised(&pulled)) {
                most = most.max(edges.norm(&pulled)?.value);
            }
        }
    }
    Ok(most)
}

/// P^∞ − P^0 at the points M^{−j}α of one cell, as functionals of the data.
fn to_limit(
    mask: &LatticeMask,
    shift: &[Rational],
    between: Between,
    values: &BTreeMap<Point, Rational>,
    count: usize,
) -> Vec<Functional<Rational>> {
    let mut steps = Steps::none(mask);
    while steps.rows().len() < count {
        steps = steps.next();
    }
    let rows = steps.rows();
    let limit: Functional<Rational> =
        values.iter().map(|(beta, value)| (difference([0; 3], *beta), value.clone())).collect();
    let at = |(alpha, _): &(Point, Functional<Rational>)| {
        let mut functional = steps.pulled(&rows, &limit, *alpha);
        let whole = alpha[..mask.dimension()].iter().map(|x| Rational::from(*x)).collect();
        let place: Vec<Rational> =
            (0..steps.count()).fold(whole, |x, _| mask.dilation().inverse_times(&x));
        for (point, weight) in weights(&less(&place, shift), between) {
            *functional.entry(point).or_insert_with(Rational::zero) -= &weight;
        }
        functional.retain(|_, c| !c.is_zero());
        functional
    };
    rows.iter().map(at).collect()
}
