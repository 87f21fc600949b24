//! Joint spectral radii of the steps of a mask on Z^d.

use super::exponent::{compared, small};
use super::monomials::{of_degree, power};
use super::polynomials::{natural_shift, sum_rules};
use super::tiling::{Figure, Motion, Tiling};
use super::values::{Transitions, ValueSpace, window};
use crate::cap::Cap;
use crate::exact::{Rational, RealAlgebraic, null_rows};
use crate::joint::{JointRadius, MatrixSet, enclosed_root, radius_of_blocks};
use crate::scheme::{LatticeMask, Point, difference};
use crate::stop::Stop;
use std::cmp::Ordering;

/// The power of M whose norm says how derivatives grow.
const DERIVATIVES: i32 = 6;

/// How far beyond the sum rules the accuracy is looked for.
const BEYOND: u32 = 5;

/// A joint spectral radius of the steps on a space.
#[derive(Clone, Debug)]
pub struct LatticeRadius {
    /// The parts of the tile, one for each matrix.
    pub parts: Vec<Motion>,
    /// The figure of whose alcoves the tile is one; none of digits.
    pub figure: Option<Figure>,
    /// The order of the differences in the space.
    pub order: u32,
    /// The number by which the matrices are multiplied.
    pub factor: Rational,
    /// The number of dimensions of the space before differences are taken.
    pub dimension: usize,
    /// One matrix for each digit.
    pub matrices: MatrixSet,
    /// Their radius.
    pub radius: JointRadius,
}

impl LatticeRadius {
    /// The accuracy K', and the steps on the combinations Σ_i c_i Φ(x_i), x_i near a tile, with Σ_i c_i x_i^μ = 0 for |μ| < K', multiplied by a number so that
    /// the radius is at least 1: s^{K'}, or the next power of m. `None` where the scheme does not converge.
    ///
    /// # Errors
    /// When a cap is met.
    ///
    /// # Panics
    /// Never: there are two or three dimensions.
    pub fn near_tile(
        mask: &LatticeMask,
        tiling: &Tiling,
        stop: &Stop,
    ) -> Result<Option<(u32, LatticeRadius)>, Cap> {
        let Some(space) = ValueSpace::of(mask, tiling, sum_rules(mask) + BEYOND)? else {
            return Ok(None);
        };
        let ValueSpace { dimension, accuracy, matrices } = space;
        if accuracy == sum_rules(mask) + BEYOND {
            let what = "how far the accuracy is beyond the order of the sum rules";
            return Err(Cap::new(what, (BEYOND - 1).into()));
        }
        let factor = if let Some(n) = mask.dilation().factor() {
            Rational::from(n.abs()).pow(small(accuracy))
        } else {
            let d = u32::try_from(mask.dimension()).expect("2 or 3");
            Rational::from(mask.dilation().class_count()).pow(small(accuracy.div_ceil(d)))
        };
        let radius = LatticeRadius::of(matrices, accuracy, factor, dimension, stop);
        Ok(Some((
            accuracy,
            LatticeRadius { parts: tiling.parts.clone(), figure: tiling.figure, ..radius },
        )))
    }

    fn of(
        matrices: Vec<Vec<Vec<Rational>>>,
        order: u32,
        factor: Rational,
        dimension: usize,
        stop: &Stop,
    ) -> LatticeRadius {
        let scaled = |matrix: Vec<Vec<Rational>>| {
            let row = |row: Vec<Rational>| row.iter().map(|x| x * &factor).collect();
            matrix.into_iter().map(row).collect()
        };
        let matrices = MatrixSet::of_any_size(matrices.into_iter().map(scaled).collect());
        let radius = radius_of_blocks(&matrices, stop);
        let (parts, figure) = (Vec::new(), None);
        LatticeRadius { parts, figure, order, factor, dimension, matrices, radius }
    }

    /// Whether the radius of the steps is below a limit; `None` where its bounds do not tell.
    pub(super) fn is_below(&self, limit: &Rational) -> Option<bool> {
        self.power_is_below(&(limit * &self.factor), 1)
    }

    /// Whether ϱ < m^{−k/d}, that is ϱ^d < m^{−k}.
    pub(super) fn is_below_root(&self, k: u32, m: usize, d: usize) -> Option<bool> {
        let power = Rational::from(m).pow(-small(k)) * self.factor.pow(small(d));
        self.power_is_below(&power, small(d))
    }

    /// The same for all orders k below one. Where the bounds do not tell, a hull is looked for that shows it.
    pub(super) fn seek_roots(&mut self, orders: u32, m: usize, d: usize, stop: &Stop) {
        let open = (0..orders).rev().filter(|k| self.is_below_root(*k, m, d).is_none());
        let goal = |k| {
            let power = Rational::from(m).pow(-small(k)) * self.factor.pow(small(d));
            enclosed_root(&RealAlgebraic::from(power), d).lower().clone()
        };
        let goals: Vec<Rational> = open.map(goal).collect();
        self.seek(&goals, stop);
    }

    /// A hull is looked for that shows that the radius of the scaled steps is below each of these numbers, where the bounds do not tell.
    pub(super) fn seek(&mut self, goals: &[Rational], stop: &Stop) {
        self.radius = self.radius.clone().toward(&self.matrices, goals, stop);
    }

    /// Whether ‖M^n‖^mϱ^n < 1, with the greatest row sum of |M^n| for a power n: derivatives of order m, which grow as ‖M^n‖^m, of terms that fall
    /// as ϱ^n.
    pub(super) fn outweighs(&self, mask: &LatticeMask, m: u32) -> bool {
        let d = mask.dimension();
        let unit = |j: usize| -> Point { std::array::from_fn(|i| i64::from(i == j)) };
        let columns: Vec<Vec<Rational>> = (0..d)
            .map(|j| {
                let column = (0..DERIVATIVES).fold(unit(j), |x, _| mask.dilation().times(x));
                column.iter().map(|x| Rational::from(x.abs())).collect()
            })
            .collect();
        let norm = (0..d).map(|i| columns.iter().map(|column| &column[i]).cloned().sum()).max();
        let norm: Rational = norm.unwrap_or_else(Rational::one);
        let limit = norm.pow(-small(m)) * self.factor.pow(DERIVATIVES);
        self.power_is_below(&limit, DERIVATIVES) == Some(true)
    }

    /// Whether (factor·ϱ)^power is below a limit.
    fn power_is_below(&self, limit: &Rational, power: i32) -> Option<bool> {
        let JointRadius { root, degree, exact, .. } = &self.radius;
        if self.radius.upper().pow(power) < *limit {
            return Some(true);
        }
        // root^{power/degree} against the limit.
        let degree = small(*degree);
        let at_least = compared(root, power, &limit.pow(degree)) != Ordering::Less;
        if at_least {
            return Some(false);
        }
        exact.then_some(true)
    }
}

/// The steps on the v on the window with Σ_β v_β β^μ = 0 for |μ| < k: their radius ϱ_k decides on convergence for all data, which is ϱ_1 < 1; and ϱ_1 is
/// the greater of ϱ_K and of the radii of Sym^j(M^{−1}), 1 ≤ j < K, which are below 1.
pub(super) fn differences(mask: &LatticeMask, k: u32, stop: &Stop) -> Result<LatticeRadius, Cap> {
    let window = window(mask)?;
    let rows = without_moments(&window, k, mask.dimension());
    let digits: Vec<Motion> = mask.dilation().digits().iter().copied().map(Motion::by).collect();
    let matrices = Transitions::new(mask, &digits, &window).on(rows);
    let radius = LatticeRadius::of(matrices, k, Rational::one(), window.len(), stop);
    Ok(LatticeRadius { parts: digits, ..radius })
}

/// A basis of the v on some places with Σ_β v_β β^μ = 0 for |μ| < k.
pub(super) fn without_moments(places: &[Point], k: u32, dimension: usize) -> Vec<Vec<Rational>> {
    let degrees = (0..k).flat_map(|k| of_degree(k, dimension));
    let exponents: Vec<[u32; 3]> = degrees.collect();
    let moments =
        |place: &Point| exponents.iter().map(|e| power(*place, *e)).collect::<Vec<Rational>>();
    null_rows(&places.iter().map(moments).collect::<Vec<_>>())
}

/// The radius near a tile that has the nearest bounds: the alcove has the smaller matrices, and the tile of the digits at times an extremal hull.
pub(super) fn nearest(
    mask: &LatticeMask,
    stop: &Stop,
) -> Result<Option<(u32, LatticeRadius)>, Cap> {
    let centred = centred(mask);
    let alcove = centred.as_ref().and_then(|mask| Some((mask, Tiling::of_alcove(mask)?)));
    let of_alcove = match &alcove {
        Some((mask, tiling)) => LatticeRadius::near_tile(mask, tiling, stop)?,
        None => None,
    };
    if of_alcove.as_ref().is_some_and(|(_, found)| found.radius.exact) {
        return Ok(of_alcove);
    }
    let of_digits = Tiling::of_digits(mask.dilation())
        .and_then(|tiling| LatticeRadius::near_tile(mask, &tiling, stop));
    match (of_alcove, of_digits) {
        (Some(first), Ok(Some(second))) => {
            let nearer = second.1.radius.exact || second.1.radius.upper() < first.1.radius.upper();
            Ok(Some(if nearer { second } else { first }))
        }
        (Some(first), _) => Ok(Some(first)),
        (None, found) => found,
    }
}

/// The mask of the same scheme with the basic limit function moved by −τ, if the natural shift τ is integer: a(γ + (M − I)τ).
fn centred(mask: &LatticeMask) -> Option<LatticeMask> {
    moved(mask, &natural_shift(mask))
}

/// The mask a(γ + (M − I)τ), if τ is integer.
pub(super) fn moved<S: Clone>(mask: &LatticeMask<S>, by: &[Rational]) -> Option<LatticeMask<S>> {
    let mut shift = [0; 3];
    for (at, x) in shift.iter_mut().zip(by) {
        *at = x.numerator().to_i64().filter(|_| x.is_integer())?;
    }
    Some(mask.moved(difference(shift, mask.dilation().times(shift))))
}
