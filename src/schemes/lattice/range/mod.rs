//! For which values of one or two parameters the limits of masks on Z^d are C^m, from both sides.

mod cover;
mod error;
mod map;
mod steps;

use super::polynomials::sum_rules;
use super::shape::{is_interpolating, is_isotropic};
use crate::exact::{
    BivariatePolynomial, Interval, IntervalSet, Rational, RationalPolynomial, Scalar,
};
use crate::joint::{MatrixSet, MatrixSetError, radius_of_blocks};
use crate::scheme::LatticeMask;
use crate::smoothness::{PolynomialMatrix, Search, gap, outer_ends};
use crate::stop::Stop;
use cover::cover;
pub use cover::{RangePiece, RangeProof};
pub use error::LatticeRangeError;
pub use map::{MAP_BOXES, lattice_map};
use steps::{PlaneMatrix, Steps, products, scale};

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
    /// The steps, of which so many at a time, times a number, contract inside.
    steps: Box<(Steps, usize, Rational)>,
}

impl LatticeRange {
    /// d.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.steps.0.dimension()
    }

    /// What shows that all limits are C^m in a whole interval; `None` where it is not bounded, or no proof by hulls on pieces is found.
    #[must_use]
    pub fn proof(&self, interval: &IntervalSet) -> Option<RangeProof> {
        let [interval] = interval.intervals() else { return None };
        let (from, to) = outer_ends(interval)?;
        let (steps, count, scale) = &*self.steps;
        let of_block = |block: &Vec<PlaneMatrix>| {
            cover(&products(&on_line(block), *count, scale), (&from, &to))
        };
        Some(RangeProof {
            parts: steps.tiling.parts.clone(),
            figure: steps.tiling.figure,
            reduction: steps.reduction.clone(),
            blocks: steps.blocks.iter().map(of_block).collect::<Option<_>>()?,
        })
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
    let order = order_above(mask, m)?;
    let steps = Steps::near_tile(&mask.map(|c| BivariatePolynomial::from(c)), order)?;
    let (count, scale) = scale(mask.dilation(), m);
    let (mut inside, mut outside) = (IntervalSet::everything(), IntervalSet::default());
    for block in &steps.blocks {
        let found = of_block(products(&on_line(block), count, &scale), &outside)?;
        inside = inside.intersection(&found.0);
        outside = outside.union(&found.1);
    }
    let mut but_finitely_many = false;
    // Where data are kept, steps are those of differences of φ itself; and divergence needs no more.
    if m > 0 && !is_interpolating(mask) {
        but_finitely_many = steps.spans(order);
        if !but_finitely_many {
            outside = IntervalSet::default();
        }
    }
    let gap = gap(&inside.union(&outside));
    let steps = Box::new((steps, count, scale));
    Ok(LatticeRange { sum_rules: order, inside, outside, but_finitely_many, gap, steps })
}

/// The order of the sum rules that hold for all values, if C^m is a question with it.
fn order_above<P: Scalar + PartialEq>(
    mask: &LatticeMask<P>,
    m: u32,
) -> Result<u32, LatticeRangeError> {
    let order = sum_rules(mask);
    if order <= m {
        return Err(LatticeRangeError::SumRules { m, found: order });
    }
    if m > 0 && !is_isotropic(mask.dilation()) {
        return Err(LatticeRangeError::Anisotropic);
    }
    Ok(order)
}

/// Matrices of polynomials in one parameter as such.
fn on_line(block: &[PlaneMatrix]) -> Vec<PolynomialMatrix> {
    let entry = |p: &BivariatePolynomial| p.in_first().expect("one parameter");
    let matrix =
        |matrix: &PlaneMatrix| matrix.iter().map(|row| row.iter().map(entry).collect()).collect();
    block.iter().map(matrix).collect()
}

/// An interval shorter than this part of all is left out.
const SHORT: i64 = 4_096;

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
