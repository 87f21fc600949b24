//! Extremal hulls, verified.

use super::convert::{float, on_grid};
use super::entry::Entry;
use super::extremal::{Extremal, Rate, Vertex};
use super::hull::Hull;
use super::matrix_set::MatrixSet;
use crate::exact::{Enclosed, Enclosure, Integer, Rational};
use crate::float::extremal::Image;
use crate::float::nearest;

/// The grid of coefficients, and of the ends of enclosures.
const BITS: u32 = 96;

/// The grid of the coefficients that f64 finds.
const FOUND_BITS: u32 = 44;

impl Extremal<Rational> {
    /// A hull that proves that the radius is at most the rate itself; `None` where an image is not inside.
    ///
    /// The rate is that of single factors: `length` is 1.
    pub(super) fn hull(&self, set: &MatrixSet, unit: &Rational) -> Option<Hull> {
        let bound = &self.rate.root;
        let rows = self.vertices[set.size()..].iter().map(|vertex| vertex.row.clone()).collect();
        let images = vec![Vec::new(); self.vertices.len()];
        let mut hull = Hull { bound: bound.clone(), unit: unit.clone(), rows, images };
        let mut found = vec![Vec::new(); self.vertices.len()];
        for (i, by, image) in self.images() {
            let (row, matrix) = (&self.vertices[i].row, &set.matrices()[by]);
            let terms = match image {
                Image::Row(j) => {
                    let exact = self.rate.step(&self.vertices[i], matrix);
                    let same = exact.row == self.vertices[*j].row;
                    vec![(*j, if same { bound.clone() } else { -bound })]
                }
                Image::Combination(terms) => {
                    let near = terms
                        .iter()
                        .map(|(j, c)| Some((*j, on_grid(c * nearest(bound), FOUND_BITS)?)));
                    let near: Vec<(usize, Rational)> = near.collect::<Option<_>>()?;
                    let near = near.into_iter().filter(|(_, c)| !c.is_zero()).collect::<Vec<_>>();
                    if hull.cost(row, matrix, &near) <= *bound {
                        near
                    } else {
                        let exact = self.rate.step(&self.vertices[i], matrix);
                        let exact = self.exact_combination(&exact, terms)?.into_iter();
                        exact.map(|(j, c)| (j, c * bound)).collect()
                    }
                }
            };
            found[i].push(terms);
        }
        hull.images = found;
        hull.proves(set).then_some(hull)
    }
}

impl<F: Entry> Extremal<F> {
    /// Whether the hull is invariant under the matrices over the rate, which is that of a product of
    /// `length` factors: by enclosures of the rows θ^{−power}·row, and exactly where these do not decide.
    pub(super) fn is_invariant(&self, set: &MatrixSet<F>, unit: &Rational) -> bool {
        let theta = enclosed_root(&self.rate);
        // A root below the places of the enclosures.
        if theta.lower().sign() <= 0 {
            return false;
        }
        let inverse = reciprocal(&theta);
        let near: Vec<Vec<Enclosure>> =
            self.vertices.iter().map(|vertex| enclosed(vertex, &inverse)).collect();
        let row = |row: &Vec<F>| row.iter().map(|x| outward(&x.enclosure(1))).collect();
        let matrices = set.matrices().iter().map(|rows| rows.iter().map(row).collect());
        let matrices: Vec<Vec<Vec<Enclosure>>> = matrices.collect();
        self.images().all(|(i, by, image)| {
            // A row is the image of another, and a cycle of eigenvectors closes, by construction.
            let Image::Combination(terms) = image else { return true };
            let inside = cost(&near, (&near[i], &matrices[by], &inverse), terms, unit);
            if inside.is_some_and(|cost| cost <= Rational::one()) {
                return true;
            }
            let exact = self.rate.step(&self.vertices[i], &set.matrices()[by]);
            self.exact_combination(&exact, terms).is_some()
        })
    }
}

/// An upper bound of Σ|c_j| + Σ|r_k|/τ.
fn cost(
    near: &[Vec<Enclosure>],
    (row, matrix, inverse): (&[Enclosure], &[Vec<Enclosure>], &Enclosure),
    terms: &[(usize, f64)],
    unit: &Rational,
) -> Option<Rational> {
    let zero = Enclosure::exact(Rational::zero());
    let mut rest = vec![zero.clone(); row.len()];
    for (x, entries) in row.iter().zip(matrix) {
        for (sum, entry) in rest.iter_mut().zip(entries).filter(|(_, entry)| **entry != zero) {
            *sum = &*sum + &(x * &(entry * inverse));
        }
    }
    let mut total = Rational::zero();
    for (j, c) in terms {
        let c = on_grid(*c, FOUND_BITS)?;
        total += &c.abs();
        for (x, v) in rest.iter_mut().zip(&near[*j]) {
            *x = &*x - &(v * &Enclosure::exact(c.clone()));
        }
    }
    let size = |x: &Enclosure| x.lower().abs().max(x.upper().abs());
    let remainder: Rational = rest.iter().map(size).sum();
    Some(total + remainder / unit)
}

/// θ^{−power}·row.
fn enclosed<F: Enclosed>(vertex: &Vertex<F>, inverse: &Enclosure) -> Vec<Enclosure> {
    let one = Enclosure::exact(Rational::one());
    let scale = (0..vertex.power).fold(one, |scale, _| outward(&(&scale * inverse)));
    vertex.row.iter().map(|x| outward(&(&outward(&x.enclosure(1)) * &scale))).collect()
}

fn outward(x: &Enclosure) -> Enclosure {
    let unit = Rational::from(Integer::one().shifted_left(BITS));
    let low = Rational::from((x.lower() * &unit).floor()) / &unit;
    Enclosure::new(low, Rational::from((x.upper() * &unit).ceil()) / unit)
}

fn reciprocal(x: &Enclosure) -> Enclosure {
    outward(&Enclosure::new(x.upper().recip(), x.lower().recip()))
}

/// θ = α^{1/length}, by bisection around what f64 gives.
fn enclosed_root<F: Enclosed>(rate: &Rate<F>) -> Enclosure {
    let root = rate.root.enclosure(1);
    let length = i32::try_from(rate.length).expect("a short word");
    let near = nearest(&rate.root).powf(1.0 / float(rate.length));
    let near = crate::float::exact(near).expect("a finite number");
    let margin = Rational::new(1, 1_i64 << 30);
    let mut low = &near - &near * &margin;
    let mut high = &near + &near * margin;
    let unit = Rational::from(Integer::one().shifted_left(BITS));
    for _ in 0..BITS - 28 {
        let middle = Rational::from(((&low + &high) / Rational::from(2) * &unit).floor()) / &unit;
        let power = middle.pow(length);
        if power <= *root.lower() {
            low = middle;
        } else if power >= *root.upper() {
            high = middle;
        } else {
            break;
        }
    }
    Enclosure::new(low, high)
}
