//! Masks on Z^d that are products of masks of curves.

#![warn(clippy::arithmetic_side_effects)]

use crate::claims::Paper;
use crate::functions::exponent::LogSum;
use crate::lines::curve::CurveProof;
use crate::numbers::{Q, int};
use crate::schemes::{Lattice, Vector};
use crate::text::{Block, Checked, Reason, Stop, require};
use num_traits::{One as _, Zero as _};
use std::collections::BTreeMap;

/// The most rules and columns of a factor.
const MAX_LENGTH: i64 = 4_096;

/// What is shown of the factors of a mask.
pub struct Factors(Vec<CurveProof>);

impl Factors {
    /// Reads the lines about each factor, and checks them.
    pub fn read<'a>(
        paper: &'a Paper<'a>,
        lattice: &Lattice,
        block: &mut Block<'_>,
    ) -> Checked<Factors> {
        let masks = masks(paper, lattice)?;
        let read = |mask| CurveProof::read(paper, mask, block);
        masks.into_iter().map(read).collect::<Checked<Vec<CurveProof>>>().map(Factors)
    }

    /// Whether all limits are C^m.
    pub fn continuous(&self, m: usize) -> bool {
        self.0.iter().all(|factor| factor.continuous(m))
    }

    /// Whether not all limits are C^m.
    pub fn not_continuous(&self, m: usize) -> bool {
        self.0.iter().any(|factor| factor.not_continuous(m))
    }

    /// Whether the exponent is at least this number; with `strictly`, greater.
    pub fn at_least(&self, value: &LogSum, strictly: bool) -> Checked<bool> {
        self.0.iter().try_fold(true, |all, factor| Ok(all && factor.at_least(value, strictly)?))
    }

    /// Whether the exponent is at most this number; with `strictly`, less. Of a scheme that diverges it is no number.
    pub fn at_most(&self, value: &LogSum, strictly: bool) -> Checked<bool> {
        if !self.0.iter().all(CurveProof::converges) {
            return Ok(false);
        }
        let shown: Vec<Checked<bool>> =
            self.0.iter().map(|factor| factor.at_most(value, strictly)).collect();
        // One factor is enough, whatever is open of the others.
        if shown.iter().any(|shown| matches!(shown, Ok(true))) {
            return Ok(true);
        }
        shown.into_iter().try_fold(false, |any, shown| Ok(any || shown?))
    }
}

/// The masks of curves a_i(j) = n_i/m · Σ a(α) over the α with α_i = j, as rules, if a is their product.
fn masks<'a>(paper: &'a Paper<'a>, lattice: &Lattice) -> Checked<Vec<Vec<Vec<Q>>>> {
    let (mask, rows, d) = (lattice.rational()?, lattice.dilation.rows(), lattice.dilation.d);
    let meter = paper.library.meter;
    meter.spend((mask.len() as u64).saturating_mul(16))?;
    let is_diagonal =
        (0..d).all(|i| (0..d).all(|j| if i == j { rows[i][i] > 1 } else { rows[i][j] == 0 }));
    require(is_diagonal, Reason::Lattice("the dilation is diagonal, with entries above 1"))?;
    let m = Q::from_integer(lattice.dilation.arity().into());
    let sums: Vec<BTreeMap<i64, Q>> = (0..d)
        .map(|i| {
            let mut sums = BTreeMap::new();
            for (place, a) in &mask {
                *sums.entry(place[i]).or_insert_with(Q::zero) += a * int(rows[i][i]) / &m;
            }
            sums.retain(|_, sum| !sum.is_zero());
            sums
        })
        .collect();
    let places = sums.iter().fold(1_usize, |count, sums| count.saturating_mul(sums.len()));
    let product = |place: &Vector| {
        sums.iter().zip(place).try_fold(Q::one(), |product, (sums, j)| Some(product * sums.get(j)?))
    };
    let is_product =
        places == mask.len() && mask.iter().all(|(place, a)| product(place).as_ref() == Some(a));
    require(is_product, Reason::Lattice("the mask is a product"))?;
    let rules = sums.iter().zip(0..).map(|(sums, i)| rules(sums, rows[i][i]));
    Ok(rules.collect::<Result<Vec<Vec<Vec<Q>>>, Stop>>()?)
}

/// n rules with these coefficients of the symbol, up to a power of z. The last column has the first ones.
fn rules(sums: &BTreeMap<i64, Q>, n: i64) -> Result<Vec<Vec<Q>>, Stop> {
    let ends = sums.first_key_value().zip(sums.last_key_value());
    let (first, last) = ends.map_or((0, 0), |((first, _), (last, _))| (*first, *last));
    // Places are at most 1,024 in absolute value, and n is at most 64.
    let columns = last.saturating_sub(first).checked_div(n).unwrap_or(0).saturating_add(1);
    if columns.saturating_mul(n) > MAX_LENGTH {
        return Err(Stop::Capped("the length of a factor"));
    }
    let at = |rule: i64, column: i64| {
        let power = columns.saturating_sub(1).saturating_sub(column).saturating_mul(n);
        let place = first.saturating_add(power).saturating_add(rule);
        sums.get(&place).cloned().unwrap_or_else(Q::zero)
    };
    Ok((0..n).map(|rule| (0..columns).map(|column| at(rule, column)).collect()).collect())
}
