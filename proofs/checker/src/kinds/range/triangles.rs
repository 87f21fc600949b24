//! Sums of absolute values of polynomials in two variables, which are shown to be below 1 on triangles by their Bernstein forms.

#![warn(clippy::arithmetic_side_effects)]

use super::polygon::{Point, Region, middle};
use crate::numbers::{Meter, Q, Value, bits, common_multiple, int};
use crate::text::Stop;
use crate::vertex::halved;
use num_bigint::BigInt;
use num_traits::Signed;

/// The most triangles that are looked at.
const MAX_TRIANGLES: usize = 20_000;

/// The most cuts on the way to one.
const MAX_CUTS: u32 = 24;

/// The most coefficients of all forms on a triangle.
const MAX_COEFFICIENTS: usize = 1 << 17;

const SIZE: Stop = Stop::Capped("the coefficients of polynomials on a triangle");

/// The coefficients x_{i,j} on u^i v^j, with the weights of Bernstein, as integers.
type Form = Vec<Vec<BigInt>>;

/// Polynomials in two variables in classes. In each class, their absolute values are summed up.
pub struct Sums<'s> {
    /// The polynomials, in units of the second value. The class of each is its place mod the number of classes.
    pub polynomials: (&'s [Value], &'s Value),
    pub classes: usize,
    pub names: [&'s str; 2],
    pub meter: &'s Meter,
}

/// The forms of the polynomials on a triangle.
struct Triangle {
    corners: [Point; 3],
    /// The coefficients, in units of 1 over this.
    unit: BigInt,
    forms: Vec<Form>,
    /// How many cuts lead to it.
    cuts: u32,
}

/// What is known of a triangle.
enum Known {
    /// All sums are below 1 at its points in the region.
    Shown,
    /// Perhaps those of its parts are.
    Open,
    /// They are not: some sum at a corner is too large.
    Not,
}

impl Sums<'_> {
    /// Whether all sums are shown to be below 1 at the points of a region, by the corners of convex polygons that it consists of.
    pub fn are_below_one(&self, region: &Region<'_>, cells: &[Vec<Point>]) -> Result<bool, Stop> {
        let mut looked = 0_usize;
        let triangles = cells.iter().flat_map(|corners| {
            corners.windows(2).skip(1).map(|pair| [&corners[0], &pair[0], &pair[1]])
        });
        for triangle in triangles {
            let mut waiting = vec![self.on(triangle)?];
            while let Some(triangle) = waiting.pop() {
                looked = looked.saturating_add(1);
                match self.known(&triangle, region)? {
                    Known::Shown => {}
                    Known::Open if looked < MAX_TRIANGLES && triangle.cuts < MAX_CUTS => {
                        for second in [false, true] {
                            waiting.push(triangle.half(second, self.meter)?);
                        }
                    }
                    Known::Open | Known::Not => return Ok(false),
                }
            }
        }
        Ok(true)
    }

    /// The greatest degree of the polynomials.
    fn degree(&self) -> Result<usize, Stop> {
        let monomials = self.polynomials.0.iter().flat_map(Value::all);
        let degrees = monomials.map(|(monomial, _)| {
            monomial.iter().fold(0_u32, |sum, (_, power)| sum.saturating_add(*power))
        });
        let degree = usize::try_from(degrees.max().unwrap_or(0)).map_err(|_| SIZE)?;
        // A form has about the square of it.
        let each = degree.saturating_add(1).saturating_mul(degree.saturating_add(1));
        let all = each.saturating_mul(self.polynomials.0.len().max(each));
        if all / 2 > MAX_COEFFICIENTS { Err(SIZE) } else { Ok(degree) }
    }

    /// The forms on a triangle.
    fn on(&self, corners: [&Point; 3]) -> Result<Triangle, Stop> {
        let degree = self.degree()?;
        let powers = Powers::new(corners, degree, self.meter)?;
        let (polynomials, scale) = self.polynomials;
        let mut forms = Vec::new();
        for polynomial in polynomials {
            let mut sum = zeros(degree);
            for (monomial, coefficient) in polynomial.all() {
                let c = coefficient.rational().zip(scale.rational());
                let irrational = || Stop::Undefined("a coefficient of the mask is irrational");
                let (c, scale) = c.ok_or_else(irrational)?;
                let mut exponents = [0_usize; 2];
                for (name, power) in monomial {
                    let place = self.names.iter().position(|known| **known == **name);
                    let unknown = || Stop::Wrong(format!("`{name}` is no variable"));
                    let power = usize::try_from(*power).map_err(|_| SIZE)?;
                    exponents[place.ok_or_else(unknown)?] = power;
                }
                powers.add(exponents, &(c * scale), &mut sum, self.meter)?;
            }
            forms.push(sum);
        }
        let all = || forms.iter().flatten().flatten();
        let unit = common_multiple(all().map(Q::denom))?;
        let longest = all().map(bits).max().unwrap_or(0).saturating_add(unit.bits());
        self.meter.spend(count(all().count()).saturating_mul(super::convex::steps(longest)))?;
        let whole = |c: &Q| c.numer() * (&unit / c.denom());
        let row = |row: &Vec<Q>| row.iter().map(whole).collect();
        let forms = forms.iter().map(|form| form.iter().map(row).collect()).collect();
        Ok(Triangle { corners: corners.map(Point::clone), unit, forms, cuts: 0 })
    }

    /// What the forms show.
    fn known(&self, triangle: &Triangle, region: &Region<'_>) -> Result<Known, Stop> {
        let sums = self.class_sums(triangle)?;
        let (unit, degree) = (&triangle.unit, triangle.degree());
        // The powers at the three corners of a coefficient, and whether the places of others are 0.
        let within = |(i, j): (usize, usize), face: [bool; 3]| {
            let powers = [degree.saturating_sub(i).saturating_sub(j), i, j];
            powers.iter().zip(face).all(|(power, of_face)| of_face || *power == 0)
        };
        let places =
            || (0..=degree).flat_map(|i| (0..=degree.saturating_sub(i)).map(move |j| (i, j)));
        // At a corner the coefficients are the values.
        let corner =
            |place: (usize, usize)| (0..3).any(|k| within(place, [0, 1, 2].map(|l| l == k)));
        let mut open = false;
        for sums in &sums {
            for (place, _) in places().zip(sums).filter(|(_, sum)| *sum > unit) {
                if corner(place) {
                    return Ok(Known::Not);
                }
                open = true;
            }
        }
        for face in 1..8_u8 {
            let face = [1, 2, 4].map(|bit| face & bit != 0);
            let corners: Vec<&Point> =
                triangle.corners.iter().zip(face).filter(|(_, of)| *of).map(|(at, _)| at).collect();
            if !region.has(&middle(&corners))? {
                continue;
            }
            for sums in &sums {
                let below =
                    places().zip(sums).any(|(place, sum)| within(place, face) && sum < unit);
                if !below && corners.len() == 1 {
                    return Ok(Known::Not);
                }
                open |= !below;
            }
        }
        Ok(if open { Known::Open } else { Known::Shown })
    }

    /// The sums of the absolute values of the coefficients at one place, for each class that has some.
    fn class_sums(&self, triangle: &Triangle) -> Result<Vec<Vec<BigInt>>, Stop> {
        let longest = triangle.unit.bits() / 64;
        let entries = triangle.forms.len().saturating_mul(zeros(triangle.degree()).concat().len());
        self.meter.spend(count(entries).saturating_mul(longest.saturating_add(2)) / 2)?;
        let mut all: Vec<Vec<BigInt>> = Vec::new();
        for (place, form) in triangle.forms.iter().enumerate() {
            let absolute = form.iter().flatten().map(Signed::abs);
            let class = place.checked_rem(self.classes).unwrap_or(0);
            match all.get_mut(class) {
                Some(sums) => sums.iter_mut().zip(absolute).for_each(|(sum, c)| *sum += c),
                None => all.push(absolute.collect()),
            }
        }
        Ok(all)
    }
}

impl Triangle {
    fn degree(&self) -> usize {
        self.forms.first().map_or(0, |form| form.len().saturating_sub(1))
    }

    /// With the corners A, B, C: the half C, A, M, or C, B, M, M the middle of AB.
    fn half(&self, second: bool, meter: &Meter) -> Result<Triangle, Stop> {
        let degree = self.degree();
        let words = self.unit.bits() / 64;
        let sums = (0..=degree).map(|k| k.saturating_mul(k.saturating_add(3)) / 2);
        let sums = sums.fold(1_usize, usize::saturating_add).saturating_mul(self.forms.len());
        meter.spend(count(sums).saturating_mul(words.saturating_add(2)) / 2)?;
        let half = |form: &Form| {
            // Sums in place of means: each one doubles the unit, and in the end all units are equal.
            let mut rows = halved(form, true, second, |a, b| a + b);
            for row in &mut rows {
                for (means, c) in row.iter_mut().enumerate() {
                    *c <<= degree.saturating_sub(means);
                }
            }
            rows
        };
        let [a, b, c] = &self.corners;
        let end = if second { b } else { a };
        Ok(Triangle {
            corners: [c.clone(), end.clone(), middle(&[a, b])],
            unit: &self.unit << degree,
            forms: self.forms.iter().map(half).collect(),
            cuts: self.cuts.saturating_add(1),
        })
    }
}

fn count(of: usize) -> u64 {
    u64::try_from(of).unwrap_or(u64::MAX)
}

/// A form of coefficients 0.
fn zeros(degree: usize) -> Vec<Vec<Q>> {
    (0..=degree).map(|i| vec![int(0); degree.saturating_add(1).saturating_sub(i)]).collect()
}

/// The forms of x^p y^q, p + q ≤ d, on a triangle, all of degree d.
struct Powers {
    /// Those of x^p y^q in row p.
    forms: Vec<Vec<Vec<Vec<Q>>>>,
}

impl Powers {
    /// Homogeneous polynomials in the barycentric coordinates w, u, v, which have the sum 1: x^p y^q(w + u + v)^{d−p−q}, where x and y are
    /// linear. The coefficient on w^h u^i v^j, over d!/(h!i!j!), is that of the form.
    fn new([a, b, c]: [&Point; 3], degree: usize, meter: &Meter) -> Result<Powers, Stop> {
        let along = |axis: usize| [&a[axis], &b[axis], &c[axis]].map(Q::clone);
        let (x, y, one) = (along(0), along(1), [int(1), int(1), int(1)]);
        let mut weights = vec![vec![int(1)]];
        for _ in 0..degree {
            weights = product(&weights, &one, meter)?;
        }
        let mut forms = Vec::new();
        let mut of_x = vec![vec![int(1)]];
        for p in 0..=degree {
            let (mut row, mut of_y) = (Vec::new(), of_x.clone());
            for q in 0..=degree.saturating_sub(p) {
                let mut form = of_y.clone();
                for _ in p.saturating_add(q)..degree {
                    form = product(&form, &one, meter)?;
                }
                for (c, weight) in form.iter_mut().flatten().zip(weights.iter().flatten()) {
                    *c /= weight;
                }
                row.push(form);
                of_y = product(&of_y, &y, meter)?;
            }
            forms.push(row);
            of_x = product(&of_x, &x, meter)?;
        }
        Ok(Powers { forms })
    }

    /// Adds c x^p y^q.
    fn add(
        &self,
        [p, q]: [usize; 2],
        c: &Q,
        sum: &mut [Vec<Q>],
        meter: &Meter,
    ) -> Result<(), Stop> {
        let form = self.forms.get(p).and_then(|row| row.get(q)).ok_or(SIZE)?;
        for (sum, x) in sum.iter_mut().flatten().zip(form.iter().flatten()) {
            meter.spend(super::convex::steps(bits(x).max(bits(c)).max(bits(sum))))?;
            *sum += x * c;
        }
        Ok(())
    }
}

/// The product of a polynomial in w, u, v by a linear one.
fn product(p: &[Vec<Q>], [a, b, c]: &[Q; 3], meter: &Meter) -> Result<Vec<Vec<Q>>, Stop> {
    let mut sum = zeros(p.len());
    for (i, row) in p.iter().enumerate() {
        for (j, x) in row.iter().enumerate() {
            let longest = [a, b, c].into_iter().map(bits).max().unwrap_or(0);
            meter.spend(super::convex::steps(longest.saturating_add(bits(x))))?;
            let (next, above) = (j.saturating_add(1), i.saturating_add(1));
            for (factor, i, j) in [(a, i, j), (b, above, j), (c, i, next)] {
                if let Some(sum) = sum.get_mut(i).and_then(|row| row.get_mut(j)) {
                    *sum += x * factor;
                }
            }
        }
    }
    Ok(sum)
}
