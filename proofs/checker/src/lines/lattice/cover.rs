//! What shows that all limits of a mask on Z^d are C^k for all values of a parameter from one number to another. THEOREMS.md, 150 (e).

#![warn(clippy::arithmetic_side_effects)]

use super::bounds::{bounds, in_blocks};
use super::differences::without_moments;
use super::motion::{Motion, parts};
use super::operator::Operator;
use super::tile::{Coefficients, Tile};
use super::{attractor, polynomials, similar};
use crate::functions::lattice::equal_moments;
use crate::numbers::{Meter, Q, int, read_rational};
use crate::radius::Rational;
use crate::schemes::{Dilation, Lattice, Vector};
use crate::text::{Block, Checked, Reason, Stop, require, words};
use num_bigint::BigInt;
use num_traits::Pow as _;
use std::collections::BTreeSet;

/// The most products of matrices.
const MAX_PRODUCTS: usize = 4_096;

/// An interval of values, with both ends.
pub type Interval = [Q; 2];

/// Reads the lines from `tile` to the last `image`, and checks that they show that all limits are C^k in the pieces of each block: for each block the interval that
/// its pieces cover.
pub fn read(
    meter: &Meter,
    (lattice, variable): (&Lattice, &str),
    k: usize,
    block: &mut Block<'_>,
) -> Checked<Vec<Interval>> {
    let dilation = &lattice.dilation;
    let masks = powers(lattice, variable)?;
    let orders = masks.iter().map(|mask| equal_moments(meter, dilation, mask));
    let orders = orders.collect::<Result<Vec<usize>, Stop>>()?;
    let order = orders.into_iter().min().unwrap_or(0);
    require(k < order, Reason::NotShown)?;
    require(
        k == 0 || similar::is_similar(dilation),
        Reason::Lattice("the dilation shrinks all directions alike"),
    )?;
    let name: Vec<&str> = block.after("tile")?.split_whitespace().collect();
    let parts = parts(block, dilation.d)?;
    let tile = Tile::of(dilation, masks, &name.join(" "), &parts)?;
    let matrices = matrices(meter, dilation, (&tile, &parts), order)?;
    let of_blocks = in_blocks(meter, &matrices, block)?;
    let (count, factor) = scale(dilation, k);
    let mut covered = Vec::new();
    for of_powers in of_blocks {
        let own: Vec<Vec<Rational>> = of_powers.chunks(parts.len()).map(<[_]>::to_vec).collect();
        let products = polynomials::products(meter, &own, (count, MAX_PRODUCTS), &factor)?;
        block.word("block")?;
        covered.push(pieces(meter, &products, block)?);
    }
    Ok(covered)
}

/// The coefficients on the powers of the variable, from the constant one upwards. Those of one power are not 0 at the places that are there.
fn powers(lattice: &Lattice, variable: &str) -> Checked<Vec<Coefficients>> {
    let mut masks: Vec<Coefficients> = Vec::new();
    for (place, a) in &lattice.mask {
        let polynomial = a.univariate(variable);
        let what = Stop::Undefined("the coefficients are no polynomials in the variable");
        for (power, c) in polynomial.ok_or(what)?.into_iter().enumerate() {
            masks.resize(masks.len().max(power.saturating_add(1)), Vec::new());
            if let Some(mask) = masks.get_mut(power).filter(|_| c != int(0)) {
                mask.push((*place, c));
            }
        }
    }
    Ok(masks)
}

/// For each power, the matrices of the T_g of the parts on the differences of order K of functions on P.
fn matrices(
    meter: &Meter,
    dilation: &Dilation,
    (Tile { group, masks, .. }, parts): (&Tile, &[Motion]),
    order: usize,
) -> Checked<Vec<Rational>> {
    let support: BTreeSet<Vector> = masks.iter().flatten().map(|(place, _)| *place).collect();
    let support: Vec<Vector> = support.into_iter().collect();
    let places = attractor::places(meter, dilation, (&support, parts, group))?;
    let space = without_moments((meter, dilation.d), &places, order)?;
    let mut all = Vec::new();
    for mask in masks {
        let operator = Operator::new(meter, dilation, mask)?;
        all.extend(operator.matrices(parts, &space, &int(1))?);
    }
    Ok(all)
}

/// c and f = s^{kc}.
fn scale(dilation: &Dilation, k: usize) -> (usize, Q) {
    // k is at most 64, and m too.
    let power = |base: u64, exponent: usize| Q::from_integer(BigInt::from(base).pow(exponent));
    if let Some(n) = similar::root(dilation) {
        return (1, power(n, k));
    }
    match (k.checked_div(dilation.d), k.checked_rem(dilation.d)) {
        (Some(whole), Some(0)) => (1, power(dilation.arity(), whole)),
        _ => (dilation.d, power(dilation.arity(), k)),
    }
}

/// The pieces of a block with what shows that its products contract there.
fn pieces(meter: &Meter, products: &[Vec<Rational>], block: &mut Block<'_>) -> Checked<Interval> {
    let mut covered: Option<Interval> = None;
    while let Some(said) = block.maybe("piece") {
        let number = |word| read_rational(word).ok_or(Reason::Malformed("the ends of a piece"));
        let [low, high] = words(said, "the ends of a piece")?.map(number);
        let (low, high) = (low?, high?);
        require(low < high, Reason::Malformed("the ends of a piece, of which the first is less"))?;
        let meets = covered.as_ref().is_none_or(|[_, to]| low <= *to);
        require(meets, Reason::Uncovered)?;
        let parts = polynomials::bernstein(meter, products, (&low, &high))?;
        let contracts = bounds(meter, &parts, block)?.at_most < int(1);
        require(contracts, Reason::NoContraction)?;
        let from = covered.map_or(low, |[from, _]| from);
        covered = Some([from, high]);
    }
    Ok(covered.ok_or(Reason::Malformed("a piece"))?)
}
