//! The greatest values of the images of data under powers of a scheme.

#![warn(clippy::arithmetic_side_effects)]

use super::distances::Distances;
use super::flow::{Functional, cost};
use crate::numbers::{Meter, Q, common_multiple};
use crate::schemes::{Lattice, Vector, plus};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One as _, Signed as _, Zero as _};
use std::collections::{BTreeMap, BTreeSet};

/// The most rows of a power, of all edges together.
const MAX_ROWS: u64 = 16_384;

/// Λ_c or T_c of a mask.
///
/// With (S^T g)_β = Σ_α a(α − Mβ)g_α, a functional g of S^c p is the functional (S^T)^c g of p. S^T takes g(· − Mτ) to (S^T g)(· − τ). So from
/// all translates of g, S^T makes those of its images of the translates by one vector of each class of Z^d/MZ^d, whatever g is. Hence
/// the functionals of every step count up to translations, and here also up to their signs.
pub fn constant(meter: &Meter, lattice: &Lattice, norm: bool, c: usize) -> Result<Q, Stop> {
    let level = u32::try_from(c).unwrap_or(u32::MAX);
    let rows = lattice.dilation.arity().checked_pow(level);
    let rows = rows.and_then(|rows| rows.checked_mul(lattice.edges.len() as u64));
    if rows.is_none_or(|rows| rows > MAX_ROWS) {
        return Err(Stop::Capped("the rows of a power of a mask on Z^d"));
    }
    if let Some(known) = lattice.known.borrow().get(&(norm, level)) {
        return Ok(known.clone());
    }
    let operator = Operator::new(meter, lattice)?;
    let one = |at: Vector, weight: i64| (at, BigInt::from(weight));
    let mut functionals: BTreeSet<Functional> = if norm {
        BTreeSet::from([vec![one([0; 3], 1)]])
    } else {
        // The edges are behind 0 in the order of places.
        lattice.edges.iter().map(|edge| vec![one([0; 3], 1), one(*edge, -1)]).collect()
    };
    for _ in 0..level {
        functionals = operator.images(&functionals)?;
    }
    let (mut greatest, mut distances) = (BigInt::zero(), Distances::new(meter, &lattice.edges)?);
    for functional in &functionals {
        let size = if norm {
            functional.iter().map(|(_, weight)| weight.abs()).sum()
        } else {
            cost(meter, &mut distances, functional)?
        };
        greatest = greatest.max(size);
    }
    let value = Q::new(greatest, operator.over.pow(level));
    lattice.known.borrow_mut().insert((norm, level), value.clone());
    Ok(value)
}

/// S^T, with the coefficients of a mask as integers over one denominator.
struct Operator<'l> {
    meter: &'l Meter,
    lattice: &'l Lattice,
    /// A vector of each class.
    representatives: Vec<Vector>,
    /// The places and coefficients of each class.
    classes: BTreeMap<Vector, Functional>,
    /// The denominator.
    over: BigInt,
}

impl Operator<'_> {
    fn new<'l>(meter: &'l Meter, lattice: &'l Lattice) -> Result<Operator<'l>, Stop> {
        let rational = lattice.rational()?;
        let over = common_multiple(rational.iter().map(|(_, a)| a.denom()))?;
        let mut classes: BTreeMap<Vector, Functional> = BTreeMap::new();
        for (place, a) in &rational {
            let class = classes.entry(lattice.dilation.class(*place)?).or_default();
            class.push((*place, a.numer() * (&over / a.denom())));
        }
        let representatives = lattice.dilation.representatives()?;
        Ok(Operator { meter, lattice, representatives, classes, over })
    }

    /// The images of the translates of functionals, each one up to a translation and its sign.
    fn images(&self, functionals: &BTreeSet<Functional>) -> Result<BTreeSet<Functional>, Stop> {
        let mut images = BTreeSet::new();
        for functional in functionals {
            for by in &self.representatives {
                let image = self.image(functional, *by)?;
                self.meter.spend((image.len() as u64).saturating_mul(4).saturating_add(1))?;
                images.insert(image);
            }
        }
        Ok(images)
    }

    fn image(&self, functional: &Functional, by: Vector) -> Result<Functional, Stop> {
        let dilation = &self.lattice.dilation;
        let mut sums: BTreeMap<Vector, BigInt> = BTreeMap::new();
        for (place, weight) in functional {
            let place = plus(*place, 1, by)?;
            for (at, a) in self.classes.get(&dilation.class(place)?).into_iter().flatten() {
                let limbs = (weight.bits() / 64).saturating_mul(a.bits() / 64);
                self.meter.spend((limbs / 16).saturating_add(1))?;
                // Both are of one class, so that there is such a β.
                if let Some(beta) = dilation.divided(plus(place, -1, *at)?)? {
                    *sums.entry(beta).or_insert_with(BigInt::zero) += weight * a;
                }
            }
        }
        sums.retain(|_, weight| !weight.is_zero());
        let first = sums.first_key_value().map(|(at, weight)| (*at, weight.is_negative()));
        let Some((first, negative)) = first else { return Ok(Vec::new()) };
        let sign = if negative { -BigInt::one() } else { BigInt::one() };
        let moved = |(at, weight): (Vector, BigInt)| Ok((plus(at, -1, first)?, weight * &sign));
        sums.into_iter().map(moved).collect()
    }
}
