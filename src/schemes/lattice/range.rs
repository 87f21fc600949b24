//! For which values of a parameter the limits of masks on Z^d are C^m, from both sides.

use super::places::of_tiling;
use super::polynomials::{mean, natural_shift, sum_rules};
use super::radius::{moved, without_moments};
use super::shape::{is_interpolating, is_isotropic};
use super::tiling::Tiling;
use super::values::{MAX_DIMENSION, Transitions, ValueSpace};
use crate::cap::Cap;
use crate::exact::{Interval, IntervalSet, Rational, RationalPolynomial, Scalar as _};
use crate::joint::{MatrixSet, MatrixSetError, Reduction, radius_of_blocks};
use crate::scheme::{Dilation, LatticeMask};
use crate::smoothness::{Search, gap, multiplied, outer_ends};
use crate::stop::Stop;

/// Where in a parameter the limits of a mask on Z^d are C^m.
#[derive(Clone, Debug)]
pub struct LatticeRange {
    /// The order of the sum rules that hold for all values.
    pub sum_rules: u32,
    /// There all limits are C^m.
    pub inside: IntervalSet,
    /// There not all limits are C^m, or the scheme diverges.
    pub outside: IntervalSet,
    /// Whether finitely many values of `outside` may be exceptions.
    pub but_finitely_many: bool,
    /// The length of what is in neither, rounded upwards; `None` where that is unbounded.
    pub gap: Option<Rational>,
}

/// Why there is no range.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LatticeRangeError {
    /// C^m needs sum rules of a higher order than hold for all values.
    #[error(
        "C^{m} needs sum rules of an order above {m}, and those of order {found} hold for all values of the parameter, but no more: on no interval are the limits C^{m}"
    )]
    SumRules {
        /// m.
        m: u32,
        /// The order that holds.
        found: u32,
    },
    /// The dilation matrix is not isotropic.
    #[error(
        "the eigenvalues of the dilation matrix have several moduli, or it is not diagonalisable: ask for C^0"
    )]
    Anisotropic,
    /// Something is too large.
    #[error("{0}")]
    Cap(Cap),
    /// The blocks are too large.
    #[error(transparent)]
    Size(#[from] MatrixSetError),
}

impl From<Cap> for LatticeRangeError {
    fn from(cap: Cap) -> LatticeRangeError {
        LatticeRangeError::Cap(cap)
    }
}

/// Where the limits of a mask on Z^d, polynomial in one parameter, are C^m.
///
/// The steps on the v near a tile with Σ_β v_β β^μ = 0, |μ| < K, with the sum rules of order K > m that hold for all values, are split into blocks for
/// all values at once. Inside all blocks contract, times s^m, by hulls that are invariant on whole intervals; outside a product of one block has an
/// eigenvalue of s^{−m} or more. `proofs/THEOREMS.md`, 150.
///
/// # Errors
/// When C^m is no question for an interval of values, or a cap is met.
///
/// # Panics
/// Never.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::lattice::lattice_range;
/// use subcert::scheme::parse_lattice_in_parameter;
///
/// // A quincunx scheme that keeps the data, with one weight.
/// let mask = parse_lattice_in_parameter("1+(1/2-w)*(x+1/x)+w*(y+1/y):dilation=[[1,1],[1,-1]]", "w")?;
/// let range = lattice_range(&mask, 0)?;
/// assert!(range.inside.contains(&Rational::new(1, 4)) && range.outside.contains(&Rational::one()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn lattice_range(
    mask: &LatticeMask<RationalPolynomial>,
    m: u32,
) -> Result<LatticeRange, LatticeRangeError> {
    let order = sum_rules(mask);
    if order <= m {
        return Err(LatticeRangeError::SumRules { m, found: order });
    }
    if m > 0 && !is_isotropic(mask.dilation()) {
        return Err(LatticeRangeError::Anisotropic);
    }
    let steps = Steps::near_tile(mask, order)?;
    let (count, scale) = scale(mask.dilation(), m);
    let mut range = LatticeRange {
        sum_rules: order,
        inside: IntervalSet::everything(),
        outside: IntervalSet::default(),
        but_finitely_many: false,
        gap: None,
    };
    for block in &steps.blocks {
        let (inside, outside) = of_block(products(block, count, &scale), &range.outside)?;
        range.inside = range.inside.intersection(&inside);
        range.outside = range.outside.union(&outside);
    }
    // Where data are kept, steps are those of differences of φ itself; and divergence needs no more.
    if m > 0 && !is_interpolating(mask) {
        if steps.spans(order) {
            range.but_finitely_many = true;
        } else {
            range.outside = IntervalSet::default();
        }
    }
    range.gap = gap(&range.inside.union(&range.outside));
    Ok(range)
}

/// An interval shorter than this part of all is left out.
const SHORT: i64 = 4_096;

type PolynomialMatrix = Vec<Vec<RationalPolynomial>>;

/// The steps near a tile, in blocks.
struct Steps {
    tiling: Tiling,
    /// The mask, with the natural shift 0 where the tile is an alcove.
    mask: LatticeMask<RationalPolynomial>,
    /// The number of dimensions of the space.
    dimension: usize,
    /// For each block its matrices.
    blocks: Vec<Vec<PolynomialMatrix>>,
}

impl Steps {
    fn near_tile(
        mask: &LatticeMask<RationalPolynomial>,
        order: u32,
    ) -> Result<Steps, LatticeRangeError> {
        let constant = mean(mask).iter().all(|x| x.as_constant().is_some());
        let at_zero = at(mask, &Rational::zero()).filter(|_| constant);
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
        Ok(Steps { tiling, mask, dimension, blocks: blocks(&matrices) })
    }

    /// Whether the differences of order K of values of φ near the tile are all of the space, at one value of the parameter, and so at all but finitely many.
    fn spans(&self, order: u32) -> bool {
        let dimension = |value: &Rational| {
            let space = ValueSpace::of(&at(&self.mask, value)?, &self.tiling, order).ok()??;
            (space.accuracy == order).then(|| space.matrices.first().map_or(0, Vec::len))
        };
        // Special values are simple ones.
        [Rational::new(1, 97), Rational::new(-1, 89)]
            .iter()
            .any(|value| dimension(value) == Some(self.dimension))
    }
}

/// The mask at a value of the parameter.
fn at(mask: &LatticeMask<RationalPolynomial>, value: &Rational) -> Option<LatticeMask> {
    let coefficients = mask.coefficients().iter().map(|(place, c)| (*place, c.value_at(value)));
    LatticeMask::new(mask.dilation().clone(), coefficients, mask.edges().to_vec()).ok()
}

/// The number of steps, and the number by which their products are multiplied: s^{m·steps}, which is rational.
fn scale(dilation: &Dilation, m: u32) -> (usize, Rational) {
    let (classes, d) = (dilation.class_count(), dilation.dimension());
    let power = |x: usize, k: u32| Rational::from(x).pow(i32::try_from(k).unwrap_or(i32::MAX));
    let small = u32::try_from(d).expect("2 or 3");
    if let Some(n) = dilation.root() {
        return (1, power(n, m));
    }
    if m.is_multiple_of(small) { (1, power(classes, m / small)) } else { (d, power(classes, m)) }
}

/// The matrices in blocks for all values of the parameter: the matrices of the coefficients of all powers are reduced together.
fn blocks(matrices: &[PolynomialMatrix]) -> Vec<Vec<PolynomialMatrix>> {
    let entries = || matrices.iter().flatten().flatten();
    let degree = entries().filter_map(RationalPolynomial::degree).max().unwrap_or(0);
    let parts = |matrix: &PolynomialMatrix| -> Vec<Vec<Vec<Rational>>> {
        let part = |k: usize| {
            let entry = |p: &RationalPolynomial| {
                p.coefficients().get(k).cloned().unwrap_or_else(Rational::zero)
            };
            matrix.iter().map(|row| row.iter().map(entry).collect()).collect()
        };
        (0..=degree).map(part).collect()
    };
    let set = MatrixSet::of_any_size(matrices.iter().flat_map(parts).collect());
    let Some(reduction) = Reduction::fine(&set).map(Reduction::balanced) else {
        return vec![matrices.to_vec()];
    };
    let together = |parts: &[Vec<Vec<Rational>>]| -> PolynomialMatrix {
        let size = parts[0].len();
        let entry = |i: usize, j: usize| {
            let all: Vec<Rational> = parts.iter().map(|part| part[i][j].clone()).collect();
            RationalPolynomial::new(&all)
        };
        (0..size).map(|i| (0..size).map(|j| entry(i, j)).collect()).collect()
    };
    let block = |block: &MatrixSet| block.matrices().chunks(degree + 1).map(together).collect();
    reduction.blocks.iter().map(block).collect()
}

/// The products of so many matrices, times a number.
fn products(block: &[PolynomialMatrix], count: usize, scale: &Rational) -> Vec<PolynomialMatrix> {
    let mut all = block.to_vec();
    for _ in 1..count {
        all = all.iter().flat_map(|a| block.iter().map(move |b| multiplied(a, b))).collect();
    }
    let scale = RationalPolynomial::from_rational(scale);
    for x in all.iter_mut().flatten().flatten() {
        *x = x.times(&scale);
    }
    all
}

/// Where the radius of a block is below 1, and where it is not; `known` is not looked at.
fn of_block(
    matrices: Vec<PolynomialMatrix>,
    known: &IntervalSet,
) -> Result<(IntervalSet, IntervalSet), MatrixSetError> {
    let constant = |matrix: &PolynomialMatrix| -> Option<Vec<Vec<Rational>>> {
        let row = |row: &Vec<RationalPolynomial>| {
            row.iter().map(RationalPolynomial::as_constant).collect()
        };
        matrix.iter().map(row).collect()
    };
    if let Some(all) = matrices.iter().map(constant).collect::<Option<Vec<_>>>() {
        let radius = radius_of_blocks(&MatrixSet::of_any_size(all), &Stop::default());
        let everything = IntervalSet::everything();
        if radius.upper() < Rational::one() {
            return Ok((everything, IntervalSet::default()));
        }
        let reached = radius.root.cmp_rational(&Rational::one()).is_ge();
        let outside = if reached { everything } else { IntervalSet::default() };
        return Ok((IntervalSet::default(), outside));
    }
    let mut search = Search::balanced(matrices)?;
    search.run(known)?;
    Ok((without_crumbs(&search.inside), search.outside))
}

/// The intervals of a set that are not very short beside the others. Near an end the search leaves many of these.
fn without_crumbs(set: &IntervalSet) -> IntervalSet {
    let length = |interval: &Interval| {
        let (low, high) = outer_ends(interval)?;
        Some(high - low)
    };
    let total: Rational = set.intervals().iter().filter_map(length).sum();
    let crumb = total * Rational::new(1, SHORT);
    let long = |interval: &&Interval| length(interval).is_none_or(|length| length >= crumb);
    let kept = set.intervals().iter().filter(long).cloned().map(IntervalSet::from);
    kept.fold(IntervalSet::default(), |union, interval| union.union(&interval))
}
