//! The lines that bound the radius of matrices which are known.

#![warn(clippy::arithmetic_side_effects)]

use crate::lines::curve::rejected;
use crate::numbers::Meter;
use crate::radius::{Radius, Rational, blocks, check_matrices, is_basis, is_bound};
use crate::text::{Block, Checked, Line};

/// The lines that bound the radius of matrices.
pub fn bounds(meter: &Meter, matrices: &[Rational], block: &mut Block<'_>) -> Checked<Radius> {
    let lines = taken(block, is_bound)?;
    check_matrices(matrices, &lines, block.at, meter).map_err(rejected)
}

/// The blocks of matrices, in the basis of the lines that say one.
pub fn in_blocks(
    meter: &Meter,
    matrices: &[Rational],
    block: &mut Block<'_>,
) -> Checked<Vec<Vec<Rational>>> {
    let lines = taken(block, is_basis)?;
    blocks(matrices, &lines, block.at, meter).map_err(rejected)
}

/// Takes the next lines that begin with such words.
fn taken<'a>(block: &mut Block<'a>, is_own: fn(&str) -> bool) -> Checked<Vec<Line<'a>>> {
    let mut lines = Vec::new();
    block.look();
    while let Some(line) = block.peek().filter(|line| is_own(line.word().0)) {
        block.any()?;
        lines.push(line);
    }
    Ok(lines)
}
