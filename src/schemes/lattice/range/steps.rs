//! The steps of a mask in one or two parameters near a tile.

use super::error::LatticeRangeError;
use crate::cap::Cap;
use crate::exact::{BivariatePolynomial, Rational, Scalar};
use crate::joint::{MatrixSet, Reduction};
use crate::lattice::places::of_tiling;
use crate::lattice::polynomials::{mean, natural_shift};
use crate::lattice::radius::{moved, without_moments};
use crate::lattice::tiling::Tiling;
use crate::lattice::values::{MAX_DIMENSION, Transitions, ValueSpace};
use crate::scheme::{Dilation, LatticeMask};
use crate::smoothness::multiplied;

/// A square matrix of polynomials in the parameters, of which there is one or two.
pub(super) type PlaneMatrix = Vec<Vec<BivariatePolynomial>>;

/// The steps near a tile, in blocks.
#[derive(Clone, Debug)]
pub(super) struct Steps {
    pub(super) tiling: Tiling,
    /// The mask, with the natural shift 0 where the tile is an alcove.
    mask: LatticeMask<BivariatePolynomial>,
    /// The number of dimensions of the space.
    size: usize,
    /// The basis in which they are block triangular, if there are several blocks.
    pub(super) reduction: Option<Reduction>,
    /// For each block its matrices.
    pub(super) blocks: Vec<Vec<PlaneMatrix>>,
}

impl Steps {
    /// Those on the differences of this order.
    pub(super) fn near_tile(
        mask: &LatticeMask<BivariatePolynomial>,
        order: u32,
    ) -> Result<Steps, LatticeRangeError> {
        let constant = mean(mask).iter().all(|x| x.degrees() == [0, 0]);
        let zero = Rational::zero();
        let at_zero = at(mask, [&zero, &zero]).filter(|_| constant);
        let centred = at_zero.and_then(|at| moved(mask, &natural_shift(&at)));
        let alcove = centred.and_then(|mask| Some((Tiling::of_alcove(&mask)?, mask)));
        let (tiling, mask) = match alcove {
            Some(found) => found,
            None => (Tiling::of_digits(mask.dilation())?, mask.clone()),
        };
        let places = of_tiling(&mask, &tiling)?;
        let rows = without_moments(&places, order, mask.dimension());
        let dimension = rows.len();
        if dimension > MAX_DIMENSION {
            let what = "the number of dimensions of the space of differences";
            return Err(Cap::new(what, MAX_DIMENSION as u64).into());
        }
        let matrices = Transitions::new(&mask, &tiling.parts, &places).on(rows);
        let (reduction, blocks) = blocks(&matrices);
        Ok(Steps { tiling, mask, size: dimension, reduction, blocks })
    }

    /// d.
    pub(super) fn dimension(&self) -> usize {
        self.mask.dimension()
    }

    /// Whether the differences of order K of values of φ near the tile are all of the space, at one value of the parameter, and so at all but finitely many.
    pub(super) fn spans(&self, order: u32) -> bool {
        let dimension = |[x, y]: &[Rational; 2]| {
            let space = ValueSpace::of(&at(&self.mask, [x, y])?, &self.tiling, order).ok()??;
            (space.accuracy == order).then(|| space.matrices.first().map_or(0, Vec::len))
        };
        // Special values are simple ones.
        let places = [[(1, 97), (1, 83)], [(-1, 89), (-1, 79)]];
        let places = places.map(|place| place.map(|(p, q)| Rational::new(p, q)));
        places.iter().any(|place| dimension(place) == Some(self.size))
    }
}

/// The mask at values of the parameters.
pub(super) fn at(
    mask: &LatticeMask<BivariatePolynomial>,
    values: [&Rational; 2],
) -> Option<LatticeMask> {
    let coefficients = mask.coefficients().iter().map(|(place, c)| (*place, c.value_at(values)));
    LatticeMask::new(mask.dilation().clone(), coefficients, mask.edges().to_vec()).ok()
}

/// The number of steps, and the number by which their products are multiplied: s^{m·steps}, which is rational.
pub(super) fn scale(dilation: &Dilation, m: u32) -> (usize, Rational) {
    let (classes, d) = (dilation.class_count(), dilation.dimension());
    let power = |x: usize, k: u32| Rational::from(x).pow(i32::try_from(k).unwrap_or(i32::MAX));
    let small = u32::try_from(d).expect("2 or 3");
    if let Some(n) = dilation.root() {
        return (1, power(n, m));
    }
    if m.is_multiple_of(small) { (1, power(classes, m / small)) } else { (d, power(classes, m)) }
}

/// The matrices in blocks for all values of the parameters: the matrices of the coefficients of all powers are reduced together.
fn blocks(matrices: &[PlaneMatrix]) -> (Option<Reduction>, Vec<Vec<PlaneMatrix>>) {
    let entries = || matrices.iter().flatten().flatten();
    let [d, e] = [0, 1].map(|i| entries().map(|p| p.degrees()[i]).max().unwrap_or(0));
    let parts = |matrix: &PlaneMatrix| -> Vec<Vec<Vec<Rational>>> {
        let part = |(k, l): (usize, usize)| {
            let entry = |p: &BivariatePolynomial| {
                p.coefficients()
                    .get(k)
                    .and_then(|row| row.get(l))
                    .cloned()
                    .unwrap_or_else(Rational::zero)
            };
            matrix.iter().map(|row| row.iter().map(entry).collect()).collect()
        };
        (0..=d).flat_map(|k| (0..=e).map(move |l| (k, l))).map(part).collect()
    };
    let set = MatrixSet::of_any_size(matrices.iter().flat_map(parts).collect());
    let Some(reduction) = Reduction::fine(&set).map(Reduction::balanced) else {
        return (None, vec![matrices.to_vec()]);
    };
    let together = |parts: &[Vec<Vec<Rational>>]| -> PlaneMatrix {
        let size = parts[0].len();
        let entry = |i: usize, j: usize| {
            let row =
                |row: &[Vec<Vec<Rational>>]| row.iter().map(|part| part[i][j].clone()).collect();
            BivariatePolynomial::new(parts.chunks(e + 1).map(row).collect())
        };
        (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect()
    };
    let block =
        |block: &MatrixSet| block.matrices().chunks((d + 1) * (e + 1)).map(together).collect();
    let blocks = reduction.blocks.iter().map(block).collect();
    (Some(reduction), blocks)
}

/// The products of so many matrices, times a number.
pub(super) fn products<P: Scalar + PartialEq>(
    block: &[Vec<Vec<P>>],
    count: usize,
    scale: &Rational,
) -> Vec<Vec<Vec<P>>> {
    let mut all = block.to_vec();
    for _ in 1..count {
        all = all.iter().flat_map(|a| block.iter().map(move |b| multiplied(a, b))).collect();
    }
    let scale = P::from_rational(scale);
    for x in all.iter_mut().flatten().flatten() {
        *x = x.times(&scale);
    }
    all
}
