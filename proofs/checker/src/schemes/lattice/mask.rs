//! A mask on Z^d: its coefficients, its dilation, and the edges of its data.

#![warn(clippy::arithmetic_side_effects)]

use super::dilation::{Dilation, units};
use super::vectors::{Vector, determinant, plus, within};
use crate::numbers::{Q, Value};
use crate::schemes::laurent::Laurent;
use crate::text::Stop;
use num_integer::Integer as _;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// The most coefficients that are not 0.
pub(super) const MAX_COEFFICIENTS: usize = 4_096;

/// The most edges.
const MAX_EDGES: usize = 64;

/// The greatest coordinate of the places of coefficients, and of edges.
const MAX_PLACE: u64 = 1_024;

/// A mask on Z^d.
pub struct Lattice {
    /// M.
    pub dilation: Dilation,
    /// The edges up to their signs.
    pub edges: Vec<Vector>,
    /// The coefficients by their places; none is 0.
    pub mask: Laurent<Vector>,
    /// The constants that are known: whether it is a norm, and c.
    pub known: RefCell<BTreeMap<(bool, u32), Q>>,
}

fn wrong<T>(what: &str) -> Result<T, Stop> {
    Err(Stop::Wrong(what.to_owned()))
}

impl Lattice {
    /// The mask with these coefficients and edges; without edges, the unit vectors.
    pub(super) fn new(
        dilation: Dilation,
        edges: Option<Vec<Vector>>,
        mask: Laurent<Vector>,
    ) -> Result<Lattice, Stop> {
        let edges =
            edges.map_or_else(|| Ok(units(dilation.d)), |edges| checked(edges, dilation.d))?;
        if mask.len() > MAX_COEFFICIENTS {
            return Err(Stop::Capped("the number of the coefficients of a mask"));
        }
        let mut sums = BTreeMap::new();
        for (place, a) in &mask {
            if !within(&[*place], MAX_PLACE) {
                return Err(Stop::Capped("the places of the coefficients of a mask"));
            }
            let sum: &mut Value =
                sums.entry(dilation.class(*place)?).or_insert_with(|| Value::int(0));
            sum.add(1, a)?;
        }
        if sums.len() as u64 != dilation.arity() || sums.values().any(|sum| *sum != Value::int(1)) {
            return wrong("`mask`: the coefficients of a class do not sum to 1");
        }
        Ok(Lattice { dilation, edges, mask, known: RefCell::default() })
    }

    /// The coefficients as rational numbers.
    pub fn rational(&self) -> Result<Vec<(Vector, Q)>, Stop> {
        let rational = |(place, a): (&Vector, &Value)| Some((*place, a.rational()?));
        let found: Option<Vec<(Vector, Q)>> = self.mask.iter().map(rational).collect();
        let what = "the coefficients of a mask on Z^d are rational numbers here";
        found.map_or_else(|| wrong(what), Ok)
    }
}

/// Checks that the integer combinations of edges are all of Z^d, which is so if the determinants of d of them have no common
/// divisor. Of edges that differ in their signs, one is left.
fn checked(mut edges: Vec<Vector>, d: usize) -> Result<Vec<Vector>, Stop> {
    if !(1..=MAX_EDGES).contains(&edges.len()) || edges.contains(&[0; 3]) {
        return wrong("`edges`: from 1 to 64 vectors are needed, none of them 0");
    }
    if !within(&edges, MAX_PLACE) {
        return wrong("`edges`: the entries are integers from -1024 to 1024");
    }
    for edge in &mut edges {
        if *edge < [0; 3] {
            *edge = plus([0; 3], -1, *edge)?;
        }
    }
    edges.sort_unstable();
    edges.dedup();
    let third = if d == 2 { &[[0, 0, 1]] } else { &edges[..] };
    let mut common = 0_i128;
    for (i, a) in edges.iter().enumerate() {
        for b in edges.iter().skip(i) {
            for c in third {
                common = common.gcd(&determinant([*a, *b, *c]));
            }
        }
    }
    if common != 1 {
        return wrong("`edges`: their integer combinations are not all of Z^d");
    }
    Ok(edges)
}
