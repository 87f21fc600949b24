//! The sizes of Jordan blocks, exactly.

use super::blocks::Blocks;
use super::eigenvalues::{Eigenvalue, at_block, block_roots, turning_characteristic};
use super::error::SpectrumError;
use super::polynomial::Polynomial;
use crate::exact::{Adjugate, RealCyclotomic, RealExpression, Scalar};

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
        for root in block_roots(k, polynomial)? {
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
    let cosine = &cosines[k % cosines.len()];
    let mut most = 1;
    for factor in factors {
        let size = nilpotency(&at_matrix(&factor, &matrix, cosine), cosine);
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
        let of = |component: Vec<usize>| {
            let row = |a: &usize| component.iter().map(|b| blocks.still[*a][*b].clone()).collect();
            let matrix: Vec<Vec<RealCyclotomic>> = component.iter().map(row).collect();
            Adjugate::of(&matrix).characteristic
        };
        return Ok(blocks.still_components().into_iter().map(of).collect());
    }
    let of = |component: Vec<usize>| {
        let characteristic = turning_characteristic(blocks, &component)?;
        Ok(at_block(&characteristic, k, cosines))
    };
    blocks.turning_components().into_iter().map(of).collect()
}

/// x + yz, z = e^{2πik/n}, z² = 2cz − 1; y = 0 where z is real.
type Turned = [RealCyclotomic; 2];

type Matrix = Vec<Vec<Turned>>;

fn times([a, b]: &Turned, [x, y]: &Turned, cosine: &RealCyclotomic) -> Turned {
    let both = b.times(y);
    let twice = cosine.plus(cosine);
    [a.times(x).minus(&both), a.times(y).plus(&b.times(x)).plus(&twice.times(&both))]
}

/// The quotient by a number other than 0: times its conjugate x + 2cy − yz, over x² + 2cxy + y².
fn over(number: &Turned, by: &Turned, cosine: &RealCyclotomic) -> Turned {
    let [x, y] = by;
    let twice = cosine.plus(cosine);
    let conjugate = [x.plus(&twice.times(y)), RealCyclotomic::zero().minus(y)];
    let norm = times(by, &conjugate, cosine)[0].recip();
    times(number, &conjugate, cosine).map(|part| part.times(&norm))
}

fn vanishes([x, y]: &Turned) -> bool {
    x.sign() == 0 && y.sign() == 0
}

/// M̂_k.
fn turned_matrix(blocks: &Blocks, k: usize, cosines: &[RealCyclotomic]) -> Matrix {
    let zero = RealCyclotomic::zero;
    if k == 0 {
        let row = |row: &Vec<RealCyclotomic>| row.iter().map(|x| [x.clone(), zero()]).collect();
        return blocks.still.iter().map(row).collect();
    }
    let n = blocks.order;
    let cosine = &cosines[k];
    let one = RealCyclotomic::from(1);
    let turn = if 2 * k == n { [RealCyclotomic::from(-1), zero()] } else { [zero(), one.clone()] };
    let mut powers = vec![[one, zero()]];
    for d in 1..n {
        powers.push(times(&powers[d - 1], &turn, cosine));
    }
    let entry = |a: usize, b: usize| {
        let mut sum = [zero(), zero()];
        for (d, weight) in blocks.turning()[a][b].terms() {
            for (sum, part) in sum.iter_mut().zip(&powers[d]) {
                sum.accumulate(&part.times(weight));
            }
        }
        sum
    };
    let all = 0..blocks.full().len();
    all.clone().map(|a| all.clone().map(|b| entry(a, b)).collect()).collect()
}

fn product(a: &Matrix, b: &Matrix, cosine: &RealCyclotomic) -> Matrix {
    let entry = |row: &Vec<Turned>, j: usize| {
        row.iter().zip(b).fold([RealCyclotomic::zero(), RealCyclotomic::zero()], |sum, (x, row)| {
            let [p, q] = times(x, &row[j], cosine);
            [sum[0].plus(&p), sum[1].plus(&q)]
        })
    };
    a.iter().map(|row| (0..b.len()).map(|j| entry(row, j)).collect()).collect()
}

/// f(M), by Horner's rule.
fn at_matrix(f: &Polynomial, matrix: &Matrix, cosine: &RealCyclotomic) -> Matrix {
    let size = matrix.len();
    let mut sum: Matrix = vec![vec![[RealCyclotomic::zero(), RealCyclotomic::zero()]; size]; size];
    for c in f.iter().rev() {
        sum = product(&sum, matrix, cosine);
        for (i, row) in sum.iter_mut().enumerate() {
            row[i][0].accumulate(c);
        }
    }
    sum
}

/// The least s ≥ 1 for which the powers s and s + 1 of a matrix have the same rank.
fn nilpotency(matrix: &Matrix, cosine: &RealCyclotomic) -> usize {
    let (mut power, mut last) = (matrix.clone(), rank(matrix, cosine));
    for size in 1..=matrix.len() {
        power = product(&power, matrix, cosine);
        let next = rank(&power, cosine);
        if next == last {
            return size;
        }
        last = next;
    }
    matrix.len()
}

/// The rank, by elimination.
fn rank(matrix: &Matrix, cosine: &RealCyclotomic) -> usize {
    let mut rows = matrix.clone();
    let mut found = 0;
    for column in 0..matrix.len() {
        let Some(pivot) = (found..rows.len()).find(|row| !vanishes(&rows[*row][column])) else {
            continue;
        };
        rows.swap(found, pivot);
        let (above, below) = rows.split_at_mut(found + 1);
        let top = &above[found];
        for row in below.iter_mut().filter(|row| !vanishes(&row[column])) {
            let factor = over(&row[column], &top[column], cosine);
            for (x, y) in row.iter_mut().zip(top) {
                let less = times(&factor, y, cosine);
                x.iter_mut().zip(&less).for_each(|(x, less)| x.lessen(less));
            }
        }
        found += 1;
    }
    found
}
