//! Masks on Z^d.

use super::dilation::{Dilation, Point, difference, sum};
use crate::cap::Cap;
use crate::exact::{Rational, Scalar};
use crate::formula::Value;
use crate::scheme::mask::Mask;
use std::collections::BTreeMap;
use std::fmt::Display;

/// The most coefficients.
pub const MAX_COEFFICIENTS: usize = 4_096;

/// The largest |coordinate| of a place.
pub const MAX_PLACE: u64 = 1_024;

/// A mask a on Z^d with a dilation matrix M: (Sp)_α = Σ_β a(α − Mβ) p_β, with Σ_β a(α − Mβ) = 1 for every α.
///
/// Data are measured by their differences along the edges u: |p_{α+u} − p_α| for all α. The edges are the same at every level. They are declared,
/// since M does not determine them.
#[derive(Clone, Debug, PartialEq)]
pub struct LatticeMask<S = Rational> {
    dilation: Dilation,
    /// The coefficients that are not known to be 0, by places.
    coefficients: BTreeMap<Point, S>,
    edges: Vec<Point>,
}

/// Why coefficients are no mask.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LatticeError {
    /// Too many coefficients.
    #[error("{0} coefficients; there are at most {MAX_COEFFICIENTS}")]
    Count(usize),
    /// A place beyond the cap.
    #[error("a coefficient at the place {0:?}; coordinates are from -{MAX_PLACE} to {MAX_PLACE}")]
    Place(Vec<i64>),
    /// A class whose coefficients do not sum to 1.
    #[error(
        "the coefficients at the places of the class of {class:?} sum to {sum}, not to 1; a(α) over α = {class:?} + Mβ sums to 1 for each of \
         the {classes} classes, and all coefficients to {classes}"
    )]
    NotAffine {
        /// A place of the class.
        class: Vec<i64>,
        /// The sum.
        sum: String,
        /// The number of classes.
        classes: usize,
    },
    /// Edges that do not join all points.
    #[error(
        "the edges {0:?} do not join all points of the lattice: their integer combinations must be all of it"
    )]
    Edges(Vec<Vec<i64>>),
}

impl LatticeError {
    /// The cap that the mask is beyond, if this is what is wrong.
    #[must_use]
    pub fn cap(&self) -> Option<Cap> {
        match self {
            LatticeError::Count(_) => {
                Some(Cap::new("the number of coefficients", MAX_COEFFICIENTS as u64))
            }
            LatticeError::Place(_) => Some(Cap::new("a coordinate of a place", MAX_PLACE)),
            _ => None,
        }
    }
}

impl<S: Scalar + PartialEq + Display> LatticeMask<S> {
    /// The mask with these coefficients. `edges` are the axes where none are given.
    ///
    /// # Errors
    /// When a class does not sum to 1, the edges do not join all points, or there are too many coefficients.
    ///
    /// # Panics
    /// When a point has a coordinate beyond the dimension.
    pub fn new(
        dilation: Dilation,
        coefficients: impl IntoIterator<Item = (Point, S)>,
        edges: Vec<Point>,
    ) -> Result<LatticeMask<S>, LatticeError> {
        let d = dilation.dimension();
        let zero = S::zero();
        let coefficients: BTreeMap<Point, S> =
            coefficients.into_iter().filter(|(_, c)| *c != zero).collect();
        if coefficients.len() > MAX_COEFFICIENTS {
            return Err(LatticeError::Count(coefficients.len()));
        }
        let too_far = |place: &&Point| place.iter().any(|x| x.unsigned_abs() > MAX_PLACE);
        if let Some(place) = coefficients.keys().find(too_far) {
            return Err(LatticeError::Place(place[..d].to_vec()));
        }
        let inside = |place: &Point| place[d..].iter().all(|x| *x == 0);
        assert!(coefficients.keys().chain(&edges).all(inside), "points of the lattice");
        let edges = if edges.is_empty() { axes(d) } else { edges };
        if !generate(&edges, d) {
            return Err(LatticeError::Edges(edges.iter().map(|edge| edge[..d].to_vec()).collect()));
        }
        let mut sums = vec![S::zero(); dilation.class_count()];
        for (place, c) in &coefficients {
            sums[dilation.split(*place).0].accumulate(c);
        }
        let one = S::from_rational(&Rational::one());
        if let Some(class) = sums.iter().position(|sum| *sum != one) {
            return Err(LatticeError::NotAffine {
                class: dilation.digits()[class][..d].to_vec(),
                sum: sums[class].to_string(),
                classes: dilation.class_count(),
            });
        }
        Ok(LatticeMask { dilation, coefficients, edges })
    }

    /// The tensor product of masks of curves, two or three.
    ///
    /// # Errors
    /// As [`LatticeMask::new`].
    ///
    /// # Panics
    /// When there are fewer masks than two, or more than three, or the product of their arities is beyond the cap on a determinant.
    pub fn product(masks: &[&Mask<S>]) -> Result<LatticeMask<S>, LatticeError> {
        let arity = |mask: &&Mask<S>| i64::try_from(mask.arity()).expect("a small arity");
        let arities: Vec<i64> = masks.iter().map(arity).collect();
        let row =
            |i: usize| (0..masks.len()).map(|j| if i == j { arities[i] } else { 0 }).collect();
        let rows: Vec<Vec<i64>> = (0..masks.len()).map(row).collect();
        let dilation = Dilation::new(&rows).expect("arities of two or three masks within the cap");
        let one = ([0; 3], S::from_rational(&Rational::one()));
        let terms = masks.iter().enumerate().fold(vec![one], |terms, (axis, mask)| {
            let own: Vec<(i64, &S)> = places(mask, arities[axis]).collect();
            let next = |(place, c): &(Point, S)| {
                let (place, c) = (*place, c.clone());
                own.iter()
                    .map(move |(k, a)| {
                        let mut place = place;
                        place[axis] = *k;
                        (place, c.times(a))
                    })
                    .collect::<Vec<_>>()
            };
            terms.iter().flat_map(next).collect()
        });
        LatticeMask::new(dilation, terms, Vec::new())
    }
}

/// The places k of the coefficients a_k of a mask of arity n, x'_m = Σ_j a_{m − nj} x_j.
fn places<S>(mask: &Mask<S>, n: i64) -> impl Iterator<Item = (i64, &S)>
where
    S: Scalar,
{
    let offset = mask.offset();
    let rows = (0_i64..).zip(mask.rules().rows());
    rows.flat_map(move |(alpha, row)| {
        (offset..).zip(row).map(move |(place, a)| (alpha - n * place, a))
    })
}

/// The unit vectors.
pub(super) fn axes(dimension: usize) -> Vec<Point> {
    (0..dimension).map(|i| std::array::from_fn(|j| i64::from(i == j))).collect()
}

/// Whether the integer combinations of these vectors are all of Z^d: elimination by Euclid's algorithm leaves a triangle with units on the diagonal.
fn generate(edges: &[Point], dimension: usize) -> bool {
    let mut rows: Vec<[i128; 3]> = edges.iter().map(|edge| edge.map(i128::from)).collect();
    for axis in 0..dimension {
        loop {
            let nonzero = |row: &&[i128; 3]| row[axis] != 0;
            let Some(least) =
                rows.iter().filter(nonzero).min_by_key(|row| row[axis].abs()).copied()
            else {
                return false;
            };
            let mut reduced = false;
            for row in rows.iter_mut().filter(|row| **row != least && row[axis] != 0) {
                let factor = row[axis].div_euclid(least[axis]);
                *row = std::array::from_fn(|i| row[i] - factor * least[i]);
                reduced = true;
            }
            if !reduced {
                if least[axis].abs() != 1 {
                    return false;
                }
                rows.retain(|row| row[axis] == 0);
                break;
            }
        }
    }
    true
}

impl<S> LatticeMask<S> {
    /// M.
    #[must_use]
    pub fn dilation(&self) -> &Dilation {
        &self.dilation
    }

    /// d.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dilation.dimension()
    }

    /// The coefficients that are not 0, by places.
    #[must_use]
    pub fn coefficients(&self) -> &BTreeMap<Point, S> {
        &self.coefficients
    }

    /// The edges along which data are compared.
    #[must_use]
    pub fn edges(&self) -> &[Point] {
        &self.edges
    }

    /// The rule of the new point α: β with a(α − Mβ).
    pub fn rule(&self, place: Point) -> impl Iterator<Item = (Point, &S)> {
        self.coefficients
            .iter()
            .filter_map(move |(at, c)| Some((self.dilation.divided(difference(place, *at))?, c)))
    }

    /// The least and the greatest coordinates of the places.
    ///
    /// # Panics
    /// Never: a mask has coefficients.
    #[must_use]
    pub fn ranges(&self) -> [Point; 2] {
        let mut places = self.coefficients.keys();
        let first = *places.next().expect("a mask has coefficients");
        places.fold([first, first], |[low, high], place| {
            [
                std::array::from_fn(|i| low[i].min(place[i])),
                std::array::from_fn(|i| high[i].max(place[i])),
            ]
        })
    }

    /// The mask with all coefficients at places that are moved by a vector.
    #[must_use]
    pub fn moved(&self, by: Point) -> LatticeMask<S>
    where
        S: Clone,
    {
        let moved = |(place, c): (&Point, &S)| (sum(*place, by), c.clone());
        LatticeMask {
            dilation: self.dilation.clone(),
            coefficients: self.coefficients.iter().map(moved).collect(),
            edges: self.edges.clone(),
        }
    }

    /// The mask with every coefficient mapped. The map takes no coefficient to 0.
    #[must_use]
    pub fn map<T>(&self, mut map: impl FnMut(&S) -> T) -> LatticeMask<T> {
        LatticeMask {
            dilation: self.dilation.clone(),
            coefficients: self.coefficients.iter().map(|(place, c)| (*place, map(c))).collect(),
            edges: self.edges.clone(),
        }
    }
}

impl<V: Value> LatticeMask<V> {
    /// The same mask, if all its coefficients are rational.
    #[must_use]
    pub fn rational(&self) -> Option<LatticeMask> {
        let rational = |(place, c): (&Point, &V)| Some((*place, c.as_rational()?));
        let coefficients = self.coefficients.iter().map(rational).collect::<Option<_>>()?;
        let (dilation, edges) = (self.dilation.clone(), self.edges.clone());
        Some(LatticeMask { dilation, coefficients, edges })
    }
}
