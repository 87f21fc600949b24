//! What shows that limits are C^m for all values of an interval.

use crate::exact::{Rational, RationalPolynomial};
use crate::joint::{BalancedHull, Closing, MatrixSet, Reduction, hull_when_balanced};
use crate::lattice::tiling::{Figure, Motion};
use crate::smoothness::{PolynomialMatrix, bernstein};

/// The most pieces of an interval, for one block.
const MAX_PIECES: usize = 200;

/// What shows that all limits are C^m for all values of an interval. `proofs/THEOREMS.md`, 150 (e).
#[derive(Clone, Debug)]
pub struct RangeProof {
    /// The parts of the tile, one for each matrix.
    pub parts: Vec<Motion>,
    /// The figure of whose alcoves the tile is one; none of digits.
    pub figure: Option<Figure>,
    /// The basis in which the steps are block triangular, if there are several blocks.
    pub reduction: Option<Reduction>,
    /// For each block pieces that cover the interval, from below.
    pub blocks: Vec<Vec<RangePiece>>,
}

/// A piece of an interval of values.
#[derive(Clone, Debug)]
pub struct RangePiece {
    /// The ends.
    pub ends: [Rational; 2],
    /// What shows that the products on a block contract: a hull of the matrices of their coefficients in Bernstein form.
    pub hull: BalancedHull,
}

/// Pieces of an interval on each of which the radius of these matrices is below 1; `None` where none are found.
pub(super) fn cover(
    matrices: &[PolynomialMatrix],
    (from, to): (&Rational, &Rational),
) -> Option<Vec<RangePiece>> {
    let entries = matrices.iter().flatten().flatten();
    let degree = entries.filter_map(RationalPolynomial::degree).max().unwrap_or(0);
    let at = |value: &Rational| {
        let row = |row: &Vec<RationalPolynomial>| row.iter().map(|p| p.value_at(value)).collect();
        let matrix = |matrix: &PolynomialMatrix| matrix.iter().map(row).collect();
        MatrixSet::of_any_size(matrices.iter().map(matrix).collect())
    };
    let (mut waiting, mut found) = (vec![(from.clone(), to.clone())], Vec::new());
    while let Some((a, b)) = waiting.pop() {
        let middle = (&a + &b) / Rational::from(2);
        let parts = matrices.iter().flat_map(|matrix| bernstein(matrix, degree, (&a, &b)));
        let set = MatrixSet::of_any_size(parts.collect());
        let ends = [at(&a), at(&b)];
        if let Some(mut hull) = hull_when_balanced(&set, &at(&middle), &ends, Closing::All) {
            // Of matrices that are 0 it would be 0, and certificates have a positive one.
            hull.hull.bound = hull.hull.bound.max(Rational::new(1, 2));
            found.push(RangePiece { ends: [a, b], hull });
            continue;
        }
        if found.len() + waiting.len() + 2 > MAX_PIECES {
            return None;
        }
        waiting.extend([(middle.clone(), b), (a, middle)]);
    }
    Some(found)
}
