//! What is certain in whole boxes of two parameters.

use crate::exact::{BivariatePolynomial, Rational, characteristic_coefficients};
use crate::joint::{
    Closing, MatrixSet, MatrixSetError, contracts, expanding_product, hull_when_balanced,
};
use crate::smoothness::excluded::excluding;
use crate::smoothness::parametric::multiplied;

/// A box of parameters: \[low, high\] of the first and of the second.
pub type Sides = [[Rational; 2]; 2];

/// What is certain in a whole box.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Certain {
    /// All limits are C^m.
    Inside,
    /// Not all limits are C^m, or the scheme diverges: the product of these matrices has an eigenvalue of 1 or more in
    /// absolute value.
    Outside(Vec<usize>),
    /// Neither is shown for the whole box.
    Open,
}

/// A square matrix of polynomials in two parameters.
type Matrix = Vec<Vec<BivariatePolynomial>>;

/// The most factors of a product, times the size: the degree of its determinants, for masks that are linear in the
/// parameters.
const MAX_DEGREE: usize = 16;

/// The largest matrices whose determinants are taken as functions of the parameters.
const MAX_SIZE: usize = 12;

/// The most products.
const MAX_WORDS: usize = 24;

/// Polynomials of which one is at most 0 only where a product has an eigenvalue of 1 or more in absolute value.
struct Excluding {
    word: Vec<usize>,
    polynomials: Vec<BivariatePolynomial>,
}

/// What is known of a plane of parameters.
pub(crate) struct Search {
    matrices: Vec<Matrix>,
    /// The greatest degrees of an entry in both parameters.
    degrees: [usize; 2],
    excluding: Vec<Excluding>,
    /// Whether each hull is looked for in a basis of its own.
    balanced: bool,
}

impl Search {
    /// The same as [`new`](Self::new), where each hull is looked for in a basis of its own: for matrices that are no windows of a mask.
    pub(crate) fn balanced(
        matrices: Vec<Matrix>,
        region: &Sides,
    ) -> Result<Search, MatrixSetError> {
        Ok(Search { balanced: true, ..Search::new(matrices, region)? })
    }

    pub(super) fn new(matrices: Vec<Matrix>, region: &Sides) -> Result<Search, MatrixSetError> {
        let entries = || matrices.iter().flatten().flatten();
        let degree = |which: usize| entries().map(|p| p.degrees()[which]).max().unwrap_or(0);
        let degrees = [degree(0), degree(1)];
        let search = Search { matrices, degrees, excluding: Vec::new(), balanced: false };
        // The caps hold for all boxes if they hold for one.
        search.corners(region)?;
        Ok(search)
    }

    fn set_at(&self, point: [&Rational; 2]) -> Result<MatrixSet, MatrixSetError> {
        let row = |row: &Vec<BivariatePolynomial>| row.iter().map(|p| p.value_at(point)).collect();
        let matrix = |matrix: &Matrix| matrix.iter().map(row).collect();
        MatrixSet::new(self.matrices.iter().map(matrix).collect())
    }

    /// The matrices of which those at the points of the box are the means.
    fn corners(&self, sides: &Sides) -> Result<MatrixSet, MatrixSetError> {
        let [d, e] = self.degrees;
        let spread = |matrix: &Matrix| {
            let entry = |p: &BivariatePolynomial| p.bernstein([&sides[0], &sides[1]], [d, e]);
            let all: Vec<Vec<Vec<Vec<Rational>>>> =
                matrix.iter().map(|row| row.iter().map(entry).collect()).collect();
            let places = (0..=d).flat_map(|k| (0..=e).map(move |l| (k, l)));
            let pick = |(k, l): (usize, usize)| -> Vec<Vec<Rational>> {
                all.iter().map(|row| row.iter().map(|c| c[k][l].clone()).collect()).collect()
            };
            places.map(pick).collect::<Vec<_>>()
        };
        let mut parts: Vec<Vec<Vec<Rational>>> = Vec::new();
        for part in self.matrices.iter().flat_map(spread) {
            // A matrix that depends on one parameter or none gives the same part more than once.
            if !parts.contains(&part) {
                parts.push(part);
            }
        }
        MatrixSet::new(parts)
    }

    /// What is certain in the whole box.
    pub(super) fn look_at(&mut self, sides: &Sides) -> Result<Certain, MatrixSetError> {
        let [x, y] = centre(sides);
        let middle = [&x, &y];
        if let Some(word) = self.excluded(sides, middle) {
            return Ok(Certain::Outside(word));
        }
        let at_middle = self.set_at(middle)?;
        if let Some(word) = expanding_product(&at_middle) {
            if !self.add(&word) {
                return Ok(Certain::Open);
            }
            return Ok(self.excluded(sides, middle).map_or(Certain::Open, Certain::Outside));
        }
        let [[a, b], [c, d]] = sides;
        let ends = [[a, c], [a, d], [b, c], [b, d]].map(|corner| self.set_at(corner));
        let ends = ends.into_iter().collect::<Result<Vec<MatrixSet>, _>>()?;
        let set = self.corners(sides)?;
        let inside = if self.balanced {
            hull_when_balanced(&set, &at_middle, &ends, Closing::All).is_some()
        } else {
            contracts(&set, &at_middle, &ends, Closing::All)
        };
        Ok(if inside { Certain::Inside } else { Certain::Open })
    }

    /// A product that shows that the whole box is outside.
    fn excluded(&self, sides: &Sides, middle: [&Rational; 2]) -> Option<Vec<usize>> {
        let shows = |p: &BivariatePolynomial| {
            let covers = || {
                let bernstein = p.bernstein([&sides[0], &sides[1]], p.degrees());
                bernstein.iter().flatten().all(|c| c.sign() <= 0)
            };
            p.value_at(middle).sign() <= 0 && covers()
        };
        let found = self.excluding.iter().find(|excluding| excluding.polynomials.iter().any(shows));
        found.map(|excluding| excluding.word.clone())
    }

    /// Takes a product into account; `false` where it is known, or beyond the caps.
    fn add(&mut self, word: &[usize]) -> bool {
        let size = self.matrices.first().map_or(0, Vec::len);
        let large = self.balanced && size > MAX_SIZE || size * word.len() > MAX_DEGREE.max(size);
        let known = self.excluding.iter().any(|excluding| excluding.word == word);
        if large || known || self.excluding.len() == MAX_WORDS {
            return false;
        }
        let factors = word.iter().map(|&i| self.matrices[i].clone());
        let product = factors.reduce(|product, matrix| multiplied(&product, &matrix));
        let Some(product) = product else { return false };
        let polynomials = excluding(&characteristic_coefficients(&product));
        self.excluding.push(Excluding { word: word.to_vec(), polynomials });
        true
    }
}

pub(super) fn centre(sides: &Sides) -> [Rational; 2] {
    let half = Rational::new(1, 2);
    sides.each_ref().map(|[low, high]| (low + high) * &half)
}

/// The halves of a box along each side that has a length, the first side fastest.
pub(super) fn parts(sides: &Sides) -> Vec<Sides> {
    let middle = centre(sides);
    let halves = |which: usize| {
        let [low, high] = &sides[which];
        if low == high {
            return vec![sides[which].clone()];
        }
        vec![[low.clone(), middle[which].clone()], [middle[which].clone(), high.clone()]]
    };
    let first = halves(0);
    halves(1).into_iter().flat_map(|y| first.iter().map(move |x| [x.clone(), y.clone()])).collect()
}
