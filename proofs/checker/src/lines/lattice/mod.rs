//! What the lines of a block show of the limits of a mask on Z^d (proofs/format/lattice.md).

#![warn(clippy::arithmetic_side_effects)]

mod attractor;
mod bounds;
mod cover;
mod differences;
mod factors;
mod moments;
mod motion;
mod operator;
mod polynomials;
mod shown;
mod similar;
mod space;
mod tile;
mod values;

use crate::claims::Paper;
use crate::functions::exponent::LogSum;
use crate::functions::lattice::{constant, sum_rules};
use crate::numbers::{Meter, Q, int};
use crate::radius::Radius;
use crate::schemes::{Lattice, Vector};
use crate::text::{Block, Checked, Reason, Stop, compare, require};
use bounds::bounds;
use differences::{MAX_DIMENSIONS, digits, space};
use factors::Factors;
use motion::parts;
use num_bigint::BigInt;
use num_traits::Pow as _;
use operator::Operator;
use shown::Shown;
use tile::Tile;

pub use cover::read as covered;

/// What is shown of the limits of a mask on Z^d.
pub enum LatticeProof {
    /// The scheme diverges.
    Diverges,
    /// It converges, and what a radius shows.
    Converges(Option<Shown>),
    /// What is shown of the factors.
    Factors(Factors),
}

impl LatticeProof {
    /// Reads the lines up to `end`, and checks them.
    pub fn read<'a>(
        paper: &'a Paper<'a>,
        lattice: &Lattice,
        block: &mut Block<'_>,
    ) -> Checked<LatticeProof> {
        let meter = paper.library.meter;
        lattice.rational()?;
        block.look();
        let converges = match block.next_word() {
            "factors" => {
                block.word("factors")?;
                return Factors::read(paper, lattice, block).map(LatticeProof::Factors);
            }
            "contraction" => contracts(meter, lattice, block)?,
            _ => decided(meter, lattice, block)?,
        };
        let shown = match block.next_word() {
            "tile" if converges => Some(shown(meter, lattice, block)?),
            _ => None,
        };
        block.word("end")?;
        Ok(if converges { LatticeProof::Converges(shown) } else { LatticeProof::Diverges })
    }

    /// Whether all limits are C^m.
    pub fn continuous(&self, m: usize) -> bool {
        match self {
            LatticeProof::Diverges => false,
            LatticeProof::Converges(shown) => {
                m == 0 || shown.as_ref().is_some_and(|shown| shown.continuous(m))
            }
            LatticeProof::Factors(factors) => factors.continuous(m),
        }
    }

    /// Whether not all limits are C^m.
    pub fn not_continuous(&self, m: usize) -> bool {
        match self {
            LatticeProof::Diverges => true,
            LatticeProof::Converges(shown) => {
                m > 0 && shown.as_ref().is_some_and(|shown| shown.not_continuous(m))
            }
            LatticeProof::Factors(factors) => factors.not_continuous(m),
        }
    }

    /// Whether the exponent is at least this number; with `strictly`, greater.
    pub fn at_least(&self, value: &LogSum, strictly: bool) -> Checked<bool> {
        match self {
            LatticeProof::Converges(Some(shown)) => shown.at_least(value, strictly),
            LatticeProof::Factors(factors) => factors.at_least(value, strictly),
            _ => Ok(false),
        }
    }

    /// Whether the exponent is at most this number; with `strictly`, less.
    pub fn at_most(&self, value: &LogSum, strictly: bool) -> Checked<bool> {
        match self {
            LatticeProof::Converges(Some(shown)) => shown.at_most(value, strictly),
            LatticeProof::Factors(factors) => factors.at_most(value, strictly),
            _ => Ok(false),
        }
    }
}

/// A count in decimal digits.
fn count(said: &str) -> Checked<usize> {
    let proper = !said.is_empty() && said.bytes().all(|b| b.is_ascii_digit());
    require(proper, Reason::Malformed("a count"))?;
    Ok(said.parse().map_err(|_| Stop::Capped("the size of a count"))?)
}

/// Checks that T_C is below 1.
fn contracts(meter: &Meter, lattice: &Lattice, block: &mut Block<'_>) -> Checked<bool> {
    let level = count(block.after("contraction")?)?;
    // T_0 is 1.
    let contracts = constant(meter, lattice, false, level)? < int(1);
    require(contracts, Reason::NoContraction)?;
    Ok(true)
}

/// Whether a scheme converges or diverges, by matrices on differences.
fn decided(meter: &Meter, lattice: &Lattice, block: &mut Block<'_>) -> Checked<bool> {
    block.word("differences")?;
    let parts = parts(block, lattice.dilation.d)?;
    let digits = digits(&lattice.dilation, &parts)?;
    let mask = lattice.rational()?;
    let operator = Operator::new(meter, &lattice.dilation, &mask)?;
    let space = space(&operator, (&support(&mask), &digits), sum_rules(meter, lattice)?)?;
    let matrices = operator.matrices(&parts, &space, &int(1))?;
    let Radius { at_most, at_least, .. } = bounds(meter, &matrices, block)?;
    let diverges = at_least.is_some_and(|(bound, _)| bound >= int(1));
    require(diverges || at_most < int(1), Reason::NotShown)?;
    Ok(!diverges)
}

/// The places of coefficients.
fn support(mask: &[(Vector, Q)]) -> Vec<Vector> {
    mask.iter().map(|(place, _)| *place).collect()
}

/// What a tile shows of a scheme that converges.
fn shown(meter: &Meter, lattice: &Lattice, block: &mut Block<'_>) -> Checked<Shown> {
    let dilation = &lattice.dilation;
    let name: Vec<&str> = block.after("tile")?.split_whitespace().collect();
    let alike = similar::is_similar(dilation);
    require(alike, Reason::Lattice("the dilation shrinks all directions alike"))?;
    let parts = parts(block, dilation.d)?;
    let tile = Tile::of(dilation, vec![lattice.rational()?], &name.join(" "), &parts)?;
    let neighbours = tile.neighbours(meter, dilation, &parts)?;
    let mask = tile.masks.into_iter().next().unwrap_or_default();
    let said = count(block.after("accuracy")?)?;
    let operator = Operator::new(meter, dilation, &mask)?;
    let values = values::values(&operator, &support(&mask))?;
    let order = sum_rules(meter, lattice)?;
    let (accuracy, space) = space::space(&operator, (&parts, &neighbours), &values, order)?;
    compare(said == accuracy, &said, &accuracy, Reason::Said)?;
    if space.len() > MAX_DIMENSIONS {
        return Err(Stop::Capped("the dimensions of a space").into());
    }
    let factor = match similar::scalar(dilation) {
        Some(n) => BigInt::from(n.unsigned_abs()).pow(accuracy),
        None => BigInt::from(dilation.arity()).pow(accuracy.div_ceil(dilation.d)),
    };
    let matrices = operator.matrices(&parts, &space, &Q::from_integer(factor.clone()))?;
    let radius = bounds(meter, &matrices, block)?;
    Ok(Shown::new(dilation, accuracy, radius, &factor)?)
}
