//! Powers of points under motions.

#![warn(clippy::arithmetic_side_effects)]

use super::motion::{Motion, Point};
use crate::functions::lattice::exponents;
use crate::numbers::{Meter, Q, bits, int, product_steps};
use crate::schemes::{Dilation, Vector};
use crate::text::Stop;
use num_traits::{One as _, Zero as _};
use std::collections::BTreeMap;

/// The multi-indices μ with |μ| below an order, those with a smaller sum first.
pub fn powers(d: usize, order: usize) -> Vec<[u32; 3]> {
    (0..u32::try_from(order).unwrap_or(u32::MAX)).flat_map(|degree| exponents(d, degree)).collect()
}

/// x^μ.
pub fn power(meter: &Meter, point: &Point, exponents: [u32; 3]) -> Result<Q, Stop> {
    let mut product = Q::one();
    for (x, exponent) in point.iter().zip(exponents) {
        for _ in 0..exponent {
            meter.spend(product_steps(bits(&product).saturating_add(bits(x))))?;
            product *= x;
        }
    }
    Ok(product)
}

/// A place as a point.
pub fn point(place: Vector) -> Point {
    place.map(|x| Q::from_integer(x.into()))
}

/// A polynomial by multi-indices.
type Polynomial = BTreeMap<[u32; 3], Q>;

/// The y^μ of an affine image y of x, as polynomials in x.
pub struct Affine(Vec<Vec<(usize, Q)>>);

impl Affine {
    /// Those of y = h(x).
    pub fn of(meter: &Meter, motion: &Motion, powers: &[[u32; 3]]) -> Result<Affine, Stop> {
        let rows = motion.turn.map(|row| row.map(int));
        Affine::new(meter, (&rows, &motion.by.map(int)), powers)
    }

    /// Those of y = M^{−1}g(x).
    pub fn shrunk(
        meter: &Meter,
        dilation: &Dilation,
        part: &Motion,
        powers: &[[u32; 3]],
    ) -> Result<Affine, Stop> {
        let (adjugate, determinant) = dilation.adjugate();
        let divided = |vector: Vector| -> Point {
            let product =
                |row: &Vector| row.iter().zip(vector).map(|(c, x)| int(*c) * int(x)).sum::<Q>();
            adjugate.each_ref().map(|row| product(row) / int(determinant))
        };
        let columns = [0, 1, 2].map(|j: usize| divided(part.turn.map(|row| row[j])));
        let rows = [0, 1, 2].map(|i: usize| columns.each_ref().map(|column| column[i].clone()));
        Affine::new(meter, (&rows, &divided(part.by)), powers)
    }

    /// y = Ax + b. Each y^μ is a coordinate of y times a power that stands before it.
    fn new(
        meter: &Meter,
        (rows, shift): (&[Point; 3], &Point),
        powers: &[[u32; 3]],
    ) -> Result<Affine, Stop> {
        let places: BTreeMap<&[u32; 3], usize> = powers.iter().zip(0..).collect();
        let mut known: BTreeMap<[u32; 3], Polynomial> = BTreeMap::new();
        for powers in powers {
            let Some(i) = powers.iter().position(|exponent| *exponent > 0) else {
                known.insert(*powers, Polynomial::from([(*powers, Q::one())]));
                continue;
            };
            let mut before = *powers;
            before[i] = before[i].saturating_sub(1);
            let mut product = Polynomial::new();
            for (index, c) in known.get(&before).into_iter().flatten() {
                meter.spend(4)?;
                for (j, factor) in rows[i].iter().enumerate().chain([(3, &shift[i])]) {
                    let mut index = *index;
                    if let Some(exponent) = index.get_mut(j) {
                        *exponent = exponent.saturating_add(1);
                    }
                    if !factor.is_zero() {
                        *product.entry(index).or_insert_with(Q::zero) += c * factor;
                    }
                }
            }
            known.insert(*powers, product);
        }
        let term = |(index, c): (&[u32; 3], &Q)| Some((*places.get(index)?, c.clone()));
        let polynomial =
            |powers| known.get(powers).into_iter().flatten().filter_map(term).collect();
        Ok(Affine(powers.iter().map(polynomial).collect()))
    }

    /// The sums Σ c_iy_i^μ, by those of the x_i^μ.
    pub fn moved(&self, meter: &Meter, moments: &BTreeMap<usize, Q>) -> Result<Vec<Q>, Stop> {
        let mut sums = Vec::with_capacity(self.0.len());
        for polynomial in &self.0 {
            let mut sum = Q::zero();
            for (i, c) in polynomial {
                if let Some(moment) = moments.get(i) {
                    let numbers = [&sum, c, moment].map(bits);
                    let length = numbers.into_iter().fold(0, u64::saturating_add);
                    meter.spend(product_steps(length))?;
                    sum += c * moment;
                }
            }
            sums.push(sum);
        }
        Ok(sums)
    }
}
