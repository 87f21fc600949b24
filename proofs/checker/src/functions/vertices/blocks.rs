//! The Fourier blocks of a ring, and characteristic polynomials.

#![warn(clippy::arithmetic_side_effects)]

use crate::numbers::{Meter, Number, Q, Value};
use crate::schemes::LocalRules;
use crate::text::Stop;

/// The most orbits.
const MAX_ORBITS: usize = 12;

/// The points of a ring by orbits, and the weights of the new points.
pub struct Blocks<'r> {
    pub meter: &'r Meter,
    /// N.
    pub order: usize,
    /// The names of the orbits, with the places of their points.
    pub orbits: Vec<(String, Vec<usize>)>,
    weights: Vec<Vec<Number>>,
}

/// The coefficients of a polynomial, the constant one first.
pub type Polynomial = Vec<Number>;

/// Σ_d c_d T^d for the turn T by one sector.
type Circulant = Vec<Number>;

fn wrong(what: &str) -> Stop {
    Stop::Wrong(format!("a ring: {what}"))
}

/// What matrices have for entries.
trait Ring: Clone {
    fn plus(&self, other: &Self) -> Result<Self, Stop>;
    fn times(&self, other: &Self, meter: &Meter) -> Result<Self, Stop>;
    fn share(&self, divisor: i64) -> Result<Self, Stop>;
}

impl Ring for Number {
    fn plus(&self, other: &Number) -> Result<Number, Stop> {
        Number::plus(self, 1, other)
    }
    fn times(&self, other: &Number, meter: &Meter) -> Result<Number, Stop> {
        meter.spend(self.cost_in_field(other).saturating_add(1))?;
        Number::times(self, other)
    }
    fn share(&self, divisor: i64) -> Result<Number, Stop> {
        Number::times(self, &Q::new(1.into(), divisor.into()).into())
    }
}

impl Ring for Circulant {
    fn plus(&self, other: &Circulant) -> Result<Circulant, Stop> {
        self.iter().zip(other).map(|(a, b)| a.plus(1, b)).collect()
    }
    fn times(&self, other: &Circulant, meter: &Meter) -> Result<Circulant, Stop> {
        let n = self.len();
        let mut product = vec![Number::Small(0, 1); n];
        for (d, a) in self.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
            for (e, b) in other.iter().enumerate().filter(|(_, b)| !b.is_zero()) {
                let place = d.saturating_add(e).checked_rem(n).unwrap_or(0);
                product[place] = product[place].plus(1, &Ring::times(a, b, meter)?)?;
            }
        }
        Ok(product)
    }
    fn share(&self, divisor: i64) -> Result<Circulant, Stop> {
        self.iter().map(|c| c.share(divisor)).collect()
    }
}

/// det(x − M) by Faddeev's and Leverrier's method: N_k = M·N_{k−1} + c_{d−k+1}, c_{d−k} = −tr(M·N_k)/k.
fn characteristic<R: Ring>(
    matrix: &[Vec<R>],
    [zero, one]: [&R; 2],
    meter: &Meter,
) -> Result<Vec<R>, Stop> {
    let d = matrix.len();
    let mut coefficients = vec![one.clone()];
    let mut power = vec![vec![zero.clone(); d]; d];
    for k in 1..=d {
        for (i, row) in power.iter_mut().enumerate() {
            row[i] = row[i].plus(&coefficients[0])?;
        }
        let mut next = vec![vec![zero.clone(); d]; d];
        for (i, row) in matrix.iter().enumerate() {
            for (entry, other) in row.iter().zip(&power) {
                for (sum, x) in next[i].iter_mut().zip(other) {
                    *sum = sum.plus(&entry.times(x, meter)?)?;
                }
            }
        }
        let mut trace = zero.clone();
        for (i, row) in next.iter().enumerate() {
            trace = trace.plus(&row[i])?;
        }
        let k = i64::try_from(k).map_err(|_| Stop::Capped("the orbits of a ring"))?;
        coefficients.insert(0, trace.share(k.saturating_neg())?);
        power = next;
    }
    Ok(coefficients)
}

/// det(x − M) of a matrix of numbers.
pub fn polynomial(matrix: &[Vec<Number>], meter: &Meter) -> Result<Polynomial, Stop> {
    characteristic(matrix, [&Number::Small(0, 1), &Number::Small(1, 1)], meter)
}

impl<'r> Blocks<'r> {
    /// The blocks of a ring at valence `order`, whose orbits have one point or as many.
    pub fn of(meter: &'r Meter, ring: &LocalRules<'_>, order: usize) -> Result<Blocks<'r>, Stop> {
        let mut orbits: Vec<(String, Vec<usize>)> = Vec::new();
        for (place, name) in ring.names.iter().enumerate() {
            let orbit = name.split('[').next().unwrap_or_default();
            match orbits.last_mut().filter(|(known, _)| known == orbit) {
                Some((_, points)) => points.push(place),
                None => orbits.push((orbit.to_owned(), vec![place])),
            }
        }
        if orbits.len() > MAX_ORBITS {
            return Err(Stop::Capped("the orbits of a ring"));
        }
        if orbits.iter().any(|(_, points)| points.len() != 1 && points.len() != order) {
            return Err(wrong("an orbit has neither one point nor as many as the valence"));
        }
        let number = |value: &Value| value.number().cloned();
        let weights = ring.weights.iter().map(|row| row.iter().map(number).collect());
        let weights = weights.collect::<Result<Vec<Vec<Number>>, Stop>>()?;
        let blocks = Blocks { meter, order, orbits, weights };
        blocks.check()?;
        Ok(blocks)
    }

    /// The point of an orbit, whose index counts mod N.
    fn point(points: &[usize], index: usize) -> usize {
        points[index.checked_rem(points.len()).unwrap_or(0)]
    }

    /// Checks that the weights are the same in all sectors.
    fn check(&self) -> Result<(), Stop> {
        for (_, new) in &self.orbits {
            for (_, old) in &self.orbits {
                for i in 0..new.len() {
                    self.meter.spend(old.len() as u64)?;
                    for j in 0..old.len() {
                        let one = &self.weights[new[i]][old[j]];
                        let next =
                            |points, index: usize| Self::point(points, index.saturating_add(1));
                        if *one != self.weights[next(new, i)][next(old, j)] {
                            return Err(wrong("its weights are not the same in all sectors"));
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// The sums Σ_d m_{a[0],b[d]} over all orbits.
    pub fn still(&self) -> Result<Vec<Vec<Number>>, Stop> {
        let sum = |new: usize, old: &[usize]| {
            let zero = Number::Small(0, 1);
            old.iter().try_fold(zero, |sum, place| sum.plus(1, &self.weights[new][*place]))
        };
        let row = |(_, new): &(String, Vec<usize>)| {
            self.orbits.iter().map(|(_, old)| sum(new[0], old)).collect()
        };
        self.orbits.iter().map(row).collect()
    }

    /// The characteristic polynomials of the blocks 0, …, ⌊N/2⌋.
    pub fn polynomials(&self) -> Result<Vec<Polynomial>, Stop> {
        let mut all = vec![polynomial(&self.still()?, self.meter)?];
        let turning: Vec<&Vec<usize>> = self
            .orbits
            .iter()
            .map(|(_, points)| points)
            .filter(|points| points.len() > 1)
            .collect();
        let entry = |new: &[usize], old: &[usize]| -> Circulant {
            old.iter().map(|place| self.weights[new[0]][*place].clone()).collect()
        };
        let matrix: Vec<Vec<Circulant>> =
            turning.iter().map(|new| turning.iter().map(|old| entry(new, old)).collect()).collect();
        let zero = vec![Number::Small(0, 1); self.order];
        let mut one = zero.clone();
        if let Some(first) = one.first_mut() {
            *first = Number::Small(1, 1);
        }
        let coefficients = characteristic(&matrix, [&zero, &one], self.meter)?;
        for k in 1..=self.order / 2 {
            let at = |c: &Circulant| self.at(c, k);
            all.push(coefficients.iter().map(at).collect::<Result<Polynomial, Stop>>()?);
        }
        Ok(all)
    }

    /// Σ_d c_d cos(2πkd/N), for c_d = c_{N−d}.
    fn at(&self, c: &Circulant, k: usize) -> Result<Number, Stop> {
        let n = self.order;
        let mut sum = Number::Small(0, 1);
        for (d, coefficient) in c.iter().enumerate() {
            let mirrored = n.saturating_sub(d).checked_rem(n).unwrap_or(0);
            if *coefficient != c[mirrored] {
                return Err(wrong("its weights differ from their mirror image"));
            }
            if !coefficient.is_zero() {
                let turn = Q::new(k.saturating_mul(d).into(), n.into());
                sum =
                    sum.plus(1, &Ring::times(coefficient, &Number::cosine(&turn)?, self.meter)?)?;
            }
        }
        Ok(sum)
    }
}
