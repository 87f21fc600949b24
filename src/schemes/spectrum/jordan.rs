//! The sizes of Jordan blocks, exactly.

use super::blocks::{Blocks, part};
use super::eigenvalues::{Eigenvalue, at_block, known_roots, turning_characteristic};
use super::error::SpectrumError;
use super::polynomial::Polynomial;
use crate::exact::{Adjugate, RealCyclotomic, RealExpression, Scalar, echelon, row_times};
use std::iter::successors;

/// The Jordan blocks of the eigenvalues of one modulus in one Fourier block.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// The Fourier block k, 0 ≤ k ≤ n/2; block n − k has the same Jordan blocks.
    pub block: usize,
    /// The modulus.
    pub modulus: RealExpression,
    /// The size of the greatest Jordan block; `None` where it is not decided, of complex eigenvalues and of multiple
    /// ones that are not in Q(2cos(2π/n)).
    pub size: Option<usize>,
}

/// The Jordan blocks of all eigenvalues of a modulus.
pub(super) fn chains(
    blocks: &Blocks,
    eigenvalues: &[Eigenvalue],
    modulus: &RealExpression,
    cosines: &[RealCyclotomic],
) -> Result<Vec<Chain>, SpectrumError> {
    let own: Vec<&Eigenvalue> =
        eigenvalues.iter().filter(|found| found.modulus == *modulus).collect();
    let mut found = Vec::new();
    for block in 0..=blocks.order / 2 {
        let times = |one: &&Eigenvalue| one.blocks.iter().filter(|k| **k == block).count();
        let most = own.iter().map(times).max().unwrap_or(0);
        if most == 0 {
            continue;
        }
        let size = if most == 1 { Some(1) } else { greatest(blocks, block, modulus, cosines)? };
        found.push(Chain { block, modulus: modulus.clone(), size });
    }
    Ok(found)
}

/// The size of the greatest Jordan block of the eigenvalues of a modulus in block k, where they are real.
fn greatest(
    blocks: &Blocks,
    k: usize,
    modulus: &RealExpression,
    cosines: &[RealCyclotomic],
) -> Result<Option<usize>, SpectrumError> {
    let mut factors: Vec<Polynomial> = Vec::new();
    for polynomial in characteristics(blocks, k, cosines)? {
        // Others are known to have smaller moduli.
        for root in known_roots(k, polynomial)? {
            if root.modulus != *modulus {
                continue;
            }
            let Some(extension) = root.extension else { return Ok(None) };
            if !factors.contains(extension.polynomial()) {
                factors.push(extension.polynomial().clone());
            }
        }
    }
    let matrix = turned_matrix(blocks, k, cosines);
    let mut most = 1;
    for factor in factors {
        let size = nilpotency(&at_matrix(&factor, &matrix));
        // A factor of a higher degree has other roots, too, which may have the blocks.
        if size > 1 && factor.len() > 2 {
            return Ok(None);
        }
        most = most.max(size);
    }
    Ok(Some(most))
}

/// The characteristic polynomials of block k, one for each set of cycles that depend on each other.
fn characteristics(
    blocks: &Blocks,
    k: usize,
    cosines: &[RealCyclotomic],
) -> Result<Vec<Polynomial>, SpectrumError> {
    if k == 0 {
        let of =
            |component: &Vec<usize>| Adjugate::of(&part(&blocks.still, component)).characteristic;
        return Ok(blocks.still_components().iter().map(of).collect());
    }
    let of = |component: Vec<usize>| {
        let characteristic = turning_characteristic(blocks, &component)?;
        Ok(at_block(&characteristic, k, cosines))
    };
    blocks.turning_components().into_iter().map(of).collect()
}

type Matrix = Vec<Vec<RealCyclotomic>>;

/// M̂_k over the real numbers: z = e^{2πik/n} is the number ±1 or, as z² = 2cz − 1, the matrix of the multiplication by z
/// of x + yz.
fn turned_matrix(blocks: &Blocks, k: usize, cosines: &[RealCyclotomic]) -> Matrix {
    if k == 0 {
        return blocks.still.clone();
    }
    let (zero, one) = (RealCyclotomic::zero(), RealCyclotomic::from(1));
    let turn = if 2 * k == blocks.order {
        vec![vec![-&one]]
    } else {
        vec![vec![zero.clone(), one.clone()], vec![-&one, cosines[k].plus(&cosines[k])]]
    };
    let size = turn.len();
    let unit =
        |i: usize| (0..size).map(|j| if i == j { one.clone() } else { zero.clone() }).collect();
    let powers: Vec<Matrix> =
        successors(Some((0..size).map(unit).collect()), |power| Some(product(power, &turn)))
            .take(blocks.order)
            .collect();
    let entry = |i: usize, j: usize| {
        let terms = blocks.turning()[i / size][j / size].terms();
        terms.fold(zero.clone(), |sum, (d, weight)| {
            sum.plus(&powers[d][i % size][j % size].times(weight))
        })
    };
    let all = 0..blocks.full().len() * size;
    all.clone().map(|i| all.clone().map(|j| entry(i, j)).collect()).collect()
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    a.iter().map(|row| row_times(row, b)).collect()
}

/// f(M), by Horner's rule.
fn at_matrix(f: &Polynomial, matrix: &Matrix) -> Matrix {
    let size = matrix.len();
    let mut sum = vec![vec![RealCyclotomic::zero(); size]; size];
    for c in f.iter().rev() {
        sum = product(&sum, matrix);
        for (i, row) in sum.iter_mut().enumerate() {
            row[i].accumulate(c);
        }
    }
    sum
}

/// The least s ≥ 1 for which the powers s and s + 1 of a matrix have the same rank.
fn nilpotency(matrix: &Matrix) -> usize {
    let rank = |matrix: &Matrix| echelon(matrix.clone()).0.len();
    let (mut power, mut last) = (matrix.clone(), rank(matrix));
    for size in 1..=matrix.len() {
        power = product(&power, matrix);
        let next = rank(&power);
        if next == last {
            return size;
        }
        last = next;
    }
    matrix.len()
}
