//! The symbols of box splines.

#![warn(clippy::arithmetic_side_effects)]

use super::dilation::Dilation;
use super::mask::MAX_COEFFICIENTS;
use super::vectors::{Vector, plus, within};
use crate::numbers::{Meter, Q, Value, int};
use crate::schemes::laurent::{Laurent, add};
use crate::text::Stop;

/// The most directions.
const MAX_DIRECTIONS: usize = 64;

/// The greatest entry of a direction.
const MAX_ENTRY: u64 = 1_000_000;

fn wrong<T>(what: &str) -> Result<T, Stop> {
    Err(Stop::Wrong(format!("`box`: {what}")))
}

/// A = m Π (1 − z^{cη})/(c(1 − z^η)), Mξ = cη. The product does not depend on the bijection ξ ↦ η: one that there is leads from the directions
/// of each line to those of its image, and the product of the c is that of the ratios of their lengths.
pub(super) fn symbol(
    meter: &Meter,
    dilation: &Dilation,
    directions: &[Vector],
) -> Result<Laurent<Vector>, Stop> {
    if !(1..=MAX_DIRECTIONS).contains(&directions.len()) || directions.contains(&[0; 3]) {
        return wrong("from 1 to 64 directions are needed, none of them 0");
    }
    if !within(directions, MAX_ENTRY) {
        return Err(Stop::Capped("the size of a direction"));
    }
    let images = directions.iter().map(|direction| dilation.times(*direction));
    let images = images.collect::<Result<Vec<Vector>, Stop>>()?;
    let factors: Vec<Vec<Option<i64>>> = images
        .iter()
        .map(|image| directions.iter().map(|direction| multiple(image, direction)).collect())
        .collect();
    // The image that each direction has been given to.
    let mut taken = vec![None; directions.len()];
    for image in 0..images.len() {
        if !give(image, &factors, &mut taken, &mut vec![false; directions.len()]) {
            return wrong("M leads no direction to a multiple of each one");
        }
    }
    let mut symbol = Laurent::from([([0; 3], Value::int(1))]);
    let mut scale = Q::from_integer(dilation.arity().into());
    for (direction, image) in directions.iter().zip(&taken) {
        let factor = image.and_then(|image| factors[image][place(directions, direction)]);
        let Some(c) = factor else { return wrong("a direction is left") };
        // (1 − z^{cη})/(1 − z^η) is the sum of the z^{jη} from 0 to c − 1, or less that from c to −1.
        let powers = if c > 0 { 0..c } else { c..0 };
        scale /= int(c.saturating_abs());
        let mut product = Laurent::new();
        for j in powers {
            for (at, a) in &symbol {
                meter.spend(1)?;
                add(&mut product, plus(*at, j, *direction)?, a)?;
            }
            // No coefficient is negative, and so none vanishes later.
            if product.len() > MAX_COEFFICIENTS {
                return Err(Stop::Capped("the number of the coefficients of a mask"));
            }
        }
        symbol = product;
    }
    let scale = Value::from(scale);
    symbol.into_iter().map(|(at, a)| Ok((at, a.times(&scale)?))).collect()
}

/// The place of a direction; equal ones have equal multiples.
fn place(directions: &[Vector], direction: &Vector) -> usize {
    directions.iter().position(|known| known == direction).unwrap_or(0)
}

/// The integer c with image = c·direction.
fn multiple(image: &Vector, direction: &Vector) -> Option<i64> {
    let (x, y) = image.iter().zip(direction).find(|(_, y)| **y != 0)?;
    let c = x.checked_div(*y).filter(|c| *c != 0)?;
    (plus([0; 3], c, *direction) == Ok(*image)).then_some(c)
}

/// Gives a direction to an image; others may be given other directions for it.
fn give(
    image: usize,
    factors: &[Vec<Option<i64>>],
    taken: &mut [Option<usize>],
    seen: &mut [bool],
) -> bool {
    for (direction, factor) in factors[image].iter().enumerate() {
        if factor.is_none() || std::mem::replace(&mut seen[direction], true) {
            continue;
        }
        if taken[direction].is_none_or(|other| give(other, factors, taken, seen)) {
            taken[direction] = Some(image);
            return true;
        }
    }
    false
}
