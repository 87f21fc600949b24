//! The characteristic polynomials of the blocks of a ring, and their roots.

#![warn(clippy::arithmetic_side_effects)]

use super::function::{Function, Functions};
use super::language::absolute;
use super::pair::Turns;
use super::polynomial::{COSINE, H, Polynomial};
use super::ring::{NEAR, Ring};
use crate::numbers::Q;
use crate::text::Stop;

const NOT_REAL: Stop = Stop::Integers("the characteristic polynomial of a block is not real");
const DEGREE: Stop = Stop::Integers("a block has more than two roots other than 0 and 1");
const LATER: Stop = Stop::Integers("the polynomials of later blocks are not linear in a cosine");
const ONE: Stop = Stop::Integers("1 is not shown to be a root of block 0");

/// The order of the first of the later blocks, of which the weights of places far away are no part.
const FIRST_LATER: u64 = 7;

/// A polynomial with the leading coefficient 1. The constant coefficient comes first.
pub type Monic = Vec<Function>;

/// A block of a ring.
#[derive(Clone, Copy)]
pub enum Block {
    /// M_0.
    Still,
    /// M_k, where this k is at most t/2 for all t.
    At(u64),
    /// All M_k with 6 < k ≤ t/2. A variable is the cosine of 2πk/t.
    Later,
}

/// cos(2πk/t).
pub fn cosine(functions: &Functions<'_>, k: u64) -> Result<Polynomial, Stop> {
    Polynomial::chebyshev(functions.meter(), k.saturating_mul(2), &Polynomial::variable(H))
}

/// The characteristic polynomial of a block, which must be real.
pub fn characteristic(functions: &Functions<'_>, ring: &Ring, block: Block) -> Result<Monic, Stop> {
    let coefficients = match block {
        Block::Still => {
            let turns = Turns::new(functions, &Polynomial::int(1));
            turns.characteristic(&ring.still(functions)?)?.0
        }
        Block::At(k) => {
            let turns = Turns::new(functions, &cosine(functions, k)?);
            let own =
                usize::try_from(k).ok().filter(|k| i64::try_from(*k).is_ok_and(|k| k <= NEAR));
            turns.characteristic(&ring.turning(&turns, own.unwrap_or(0))?)?.0
        }
        Block::Later => {
            let turns = Turns::new(functions, &Polynomial::variable(COSINE));
            turns.characteristic(&ring.turning(&turns, 0)?)?.0
        }
    };
    let mut polynomial = Monic::new();
    for c in coefficients {
        if !functions.is_zero(&c.turned)? {
            return Err(NOT_REAL);
        }
        polynomial.push(c.real);
    }
    Ok(polynomial)
}

/// p(x).
pub fn at(functions: &Functions<'_>, p: &[Function], x: &Function) -> Result<Function, Stop> {
    let sum = Function::default();
    p.iter().rev().try_fold(sum, |sum, c| functions.sum(&functions.product(&sum, x)?, 1, c))
}

/// The polynomials of later blocks with the least and the greatest cosine in place of the variable. What is of degree 1 in it and
/// has one sign at both has it between them.
pub fn ends(functions: &Functions<'_>, p: &[Function]) -> Result<[Monic; 2], Stop> {
    if p.iter().any(|c| c.degree(COSINE) > 1) {
        return Err(LATER);
    }
    let end = |cosine: &Polynomial| {
        p.iter().map(|c| functions.with(c, COSINE, cosine)).collect::<Result<Monic, Stop>>()
    };
    Ok([end(&Polynomial::int(-1))?, end(&cosine(functions, FIRST_LATER)?)?])
}

/// A polynomial without its roots 0, and the number of these.
pub struct Rest {
    /// The number of roots that are 0.
    pub zeros: usize,
    /// The polynomial of the others, of degree 2 at most.
    pub p: Monic,
}

impl Rest {
    /// The roots of a block, without 1 for block 0.
    pub fn new(functions: &Functions<'_>, ring: &Ring, block: Block) -> Result<Rest, Stop> {
        let mut p = characteristic(functions, ring, block)?;
        if matches!(block, Block::Still) {
            p = without_one(functions, &p)?;
        }
        let mut zeros = 0_usize;
        while p.len() > 1 && functions.is_zero(&p[0])? {
            p.remove(0);
            zeros = zeros.saturating_add(1);
        }
        if p.len() > 3 { Err(DEGREE) } else { Ok(Rest { zeros, p }) }
    }

    /// The real roots other than 0.
    pub fn real(&self, functions: &Functions<'_>) -> Result<Vec<Function>, Stop> {
        let half = Q::new(1.into(), 2.into());
        Ok(match &self.p[..] {
            [b, a, _] => {
                let discriminant = discriminant(functions, a, b)?;
                if functions.sign(&discriminant)? < 0 {
                    return Ok(Vec::new());
                }
                let root = functions.square_root(&discriminant)?;
                let mut both = Vec::new();
                for sign in [1, -1] {
                    let twice = functions.sum(&functions.negated(a)?, sign, &root)?;
                    both.push(functions.scaled(&twice, &half)?);
                }
                both
            }
            [a, _] => vec![functions.negated(a)?],
            _ => Vec::new(),
        })
    }

    /// The greatest absolute value of its roots other than 0, if they are real.
    pub fn greatest(&self, functions: &Functions<'_>) -> Result<Option<Function>, Stop> {
        Ok(match &self.p[..] {
            [b, a, _] => {
                let discriminant = discriminant(functions, a, b)?;
                if functions.sign(&discriminant)? < 0 {
                    return Ok(None);
                }
                let (root, size) = (functions.square_root(&discriminant)?, absolute(functions, a)?);
                let twice = functions.sum(&size, 1, &root)?;
                Some(functions.scaled(&twice, &Q::new(1.into(), 2.into()))?)
            }
            [a, _] => Some(absolute(functions, a)?),
            _ => None,
        })
    }
}

/// a² − 4b.
fn discriminant(functions: &Functions<'_>, a: &Function, b: &Function) -> Result<Function, Stop> {
    functions.sum(&functions.product(a, a)?, -4, b)
}

/// The quotient of a polynomial by x − 1.
fn without_one(functions: &Functions<'_>, p: &[Function]) -> Result<Monic, Stop> {
    let mut sums = Monic::new();
    for c in p.iter().rev() {
        let next = match sums.last() {
            Some(last) => functions.sum(c, 1, last)?,
            None => c.clone(),
        };
        sums.push(next);
    }
    let rest = sums.pop().ok_or(ONE)?;
    if sums.is_empty() || !functions.is_zero(&rest)? {
        return Err(ONE);
    }
    sums.reverse();
    Ok(sums)
}

/// Whether all complex roots of x² + ax + b, x + a or 1 are less than λ > 0 in absolute value, or with `or_equal` not greater
/// (Schur and Cohn).
pub fn are_below(
    functions: &Functions<'_>,
    p: &[Function],
    limit: &Function,
    or_equal: bool,
) -> Result<bool, Stop> {
    let conditions = match p {
        [b, a, _] => {
            let square = functions.product(limit, limit)?;
            let (sum, turn) = (functions.sum(&square, 1, b)?, functions.product(a, limit)?);
            let [more, less] = [1, -1].map(|sign| functions.sum(&sum, sign, &turn));
            vec![functions.sum(&square, -1, b)?, more?, less?, sum]
        }
        [a, _] => vec![functions.sum(limit, 1, a)?, functions.sum(limit, -1, a)?],
        _ => Vec::new(),
    };
    for condition in &conditions {
        let sign = functions.sign(condition)?;
        if sign < 0 || sign == 0 && !or_equal {
            return Ok(false);
        }
    }
    Ok(true)
}
