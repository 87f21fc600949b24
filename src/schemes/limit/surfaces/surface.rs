//! Tensor product surfaces: the greatest distance of nets from their limits at one
//! parameter.

use super::axis::{Axis, CELLS};
use crate::bound::{Budget, transport_at_costs};
use crate::exact::{Integer, Rational, format};
use crate::limit::distances::distance::Distances;
use crate::limit::error::LimitError;
use crate::limit::functional::Functional;
use crate::limit::natural::Parametrisation;
use crate::limit::value::Limit;

/// The greatest number of points of a net for which the exact norm at a parameter is
/// computed.
pub const MAX_NET_POINTS: usize = 400;

/// Why the distance of a surface is not computed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceError {
    /// An error of one of the two curve schemes.
    #[error(transparent)]
    Limit(#[from] LimitError),
    /// Spreads that are not positive, or whose ratio has too large numbers.
    #[error(
        "the spreads {first} and {second} must be positive, and p and q below 2^32 in their ratio \
         p : q"
    )]
    Spreads {
        /// The spread along the first index.
        first: String,
        /// The spread along the second index.
        second: String,
    },
    /// A net beyond [`MAX_NET_POINTS`].
    #[error(
        "the limit there depends on {0} control points; at most {MAX_NET_POINTS} are worked on"
    )]
    Net(usize),
}

/// β_1 and β_2: the largest differences of a control net, |x_{i+1,j} − x_{i,j}| and
/// |x_{i,j+1} − x_{i,j}|.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spreads {
    /// β_1/unit and β_2/unit, without a common factor.
    pub(super) costs: [u32; 2],
    pub(super) unit: Rational,
}

impl Spreads {
    /// The spreads β_1 = `first` and β_2 = `second`.
    ///
    /// # Errors
    /// When one is not positive, or their ratio p : q has a p or q of 2^32 or more.
    pub fn new(first: &Rational, second: &Rational) -> Result<Spreads, SurfaceError> {
        let refused = || SurfaceError::Spreads {
            first: format::short(first, 6),
            second: format::short(second, 6),
        };
        if first.sign() <= 0 || second.sign() <= 0 {
            return Err(refused());
        }
        let ratio = first / second;
        let cost = |value: Integer| {
            value.to_i64().and_then(|value| u32::try_from(value).ok()).ok_or_else(refused)
        };
        let costs = [cost(ratio.numerator())?, cost(ratio.denominator())?];
        Ok(Spreads { costs, unit: second / Rational::from(costs[1]) })
    }

    /// β_1 = β_2 = 1.
    #[must_use]
    pub fn one() -> Spreads {
        Spreads { costs: [1, 1], unit: Rational::one() }
    }

    /// β_1 for axis 0, β_2 for axis 1.
    #[must_use]
    pub fn along(&self, axis: usize) -> Rational {
        Rational::from(self.costs[axis]) * &self.unit
    }
}

/// A piece of a control net of integers times a unit, and parameters at which the net is far
/// from its limit. Every other point of the net has the value of the nearest point of the
/// piece; this does not increase the spreads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SurfaceWitness {
    /// The indices i, j of the first point.
    pub first: [i64; 2],
    /// The rows i of the piece.
    pub net: Vec<Vec<i64>>,
    /// The unit, by which the integers are multiplied.
    pub unit: Rational,
    /// k.
    pub level: u32,
    /// s and t.
    pub parameters: [Rational; 2],
    /// |P^∞(s, t) − P^k(s, t)|.
    pub distance: Rational,
}

/// The true distances of control nets from the limit surface of a tensor product.
///
/// `x^{k+1}_{ni+α,mj+β} = Σ_r Σ_s a_{α,r} b_{β,s} x^k_{i+o+r,j+p+s}`. P^k is the piecewise
/// bilinear interpolant of the points of level k at (i/n^k, j/m^k), and C_k = sup
/// `‖P^∞ − P^k‖_∞` over the nets of spreads at most β_1, β_2.
///
/// As functionals of the net, P^∞(s, t) and P^k(s, t) are products of two functionals of
/// curves. The greatest value of their difference is a transport problem on a grid whose
/// edges have the costs β_1 and β_2. C_k is at least β_1 C¹_k + β_2 C²_k, where C¹_k and C²_k
/// are the constants of the two curve schemes. It is equal to this if no mask coefficient is
/// negative.
///
/// Source: `proofs/THEOREMS.md`, 30–34.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::limit::{Comparison, Limit, Spreads, SurfaceDistances};
/// use subcert::scheme::parse_scheme;
///
/// let cubic = Limit::new(parse_scheme("b-spline:degree=3")?.masks()[0])?;
/// let distances = SurfaceDistances::new(&cubic, &cubic)?;
/// // 1/3 along each index.
/// let ones = Spreads::one();
/// assert_eq!(distances.compare(0, &Rational::new(2, 3), &ones)?, Comparison::Within);
/// let Comparison::Exceeds(witness) = distances.compare(0, &Rational::new(3, 5), &ones)? else {
///     return Err("a peak is 2/3 from its limit".into());
/// };
/// assert_eq!(witness.net, [[0, -1, 0], [-1, -2, -1], [0, -1, 0]]);
/// assert_eq!(witness.distance, Rational::new(2, 3));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct SurfaceDistances {
    pub(super) axes: [Axis; 2],
    pub(super) budget: Budget,
}

impl SurfaceDistances {
    /// The distances from the tensor product of these limits.
    ///
    /// # Errors
    /// As [`Distances::new`](crate::limit::Distances::new).
    pub fn new(first: &Limit, second: &Limit) -> Result<SurfaceDistances, SurfaceError> {
        SurfaceDistances::within(first, second, &Budget::unlimited())
    }

    /// The distances with a budget, which other computations may share.
    ///
    /// # Errors
    /// As [`SurfaceDistances::new`].
    pub fn within(
        first: &Limit,
        second: &Limit,
        budget: &Budget,
    ) -> Result<SurfaceDistances, SurfaceError> {
        SurfaceDistances::placed(first, second, Parametrisation::Indexed, budget)
    }

    /// The distances in the given parametrisation along both directions, with a budget.
    ///
    /// # Errors
    /// As [`Distances::placed`].
    pub fn placed(
        first: &Limit,
        second: &Limit,
        parametrisation: Parametrisation,
        budget: &Budget,
    ) -> Result<SurfaceDistances, SurfaceError> {
        let axis = |limit: &Limit| Axis::new(Distances::placed(limit, parametrisation)?, budget);
        let own = axis(first)?;
        let other = if first.mask() == second.mask() { own.clone() } else { axis(second)? };
        Ok(SurfaceDistances { axes: [own, other], budget: budget.clone() })
    }

    /// The shifts along both directions.
    #[must_use]
    pub fn shifts(&self) -> [&Rational; 2] {
        self.axes.each_ref().map(|axis| axis.distances().shift())
    }

    /// A text that states the caps of a search.
    #[must_use]
    pub fn caps(&self) -> String {
        self.budget.caps(CELLS, "a level and a direction")
    }

    /// The greatest |P^∞(s, t) − P^k(s, t)| of all nets of these spreads, exactly, and a net
    /// that attains it.
    ///
    /// # Errors
    /// As [`Limit::error`] for s or t, and when the functional depends on more than
    /// [`MAX_NET_POINTS`] points.
    ///
    /// # Panics
    /// Never: both are affine combinations, and the grid is connected.
    pub fn at(
        &self,
        level: u32,
        parameters: &[Rational; 2],
        spreads: &Spreads,
    ) -> Result<SurfaceWitness, SurfaceError> {
        let mut pairs = Vec::with_capacity(2);
        for (axis, t) in self.axes.iter().zip(parameters) {
            let (limit, shift) = (axis.limit(), axis.distances().shift());
            pairs.push([limit.at(t)?, limit.polygon_from(level, t, shift)?]);
        }
        let ranges = [span(&pairs[0]), span(&pairs[1])];
        let [rows, columns] = ranges.map(|(from, to)| usize::try_from(to - from + 1).unwrap_or(0));
        let points = rows.saturating_mul(columns);
        if points > MAX_NET_POINTS {
            return Err(SurfaceError::Net(points));
        }
        let [(top, bottom), (left, right)] = ranges;
        let coefficient = |(i, j): (i64, i64)| {
            let product = |of: usize| pairs[0][of].coefficient(i) * pairs[1][of].coefficient(j);
            product(0) - product(1)
        };
        let indices = (top..=bottom).flat_map(|i| (left..=right).map(move |j| (i, j)));
        let w: Vec<Rational> = indices.map(coefficient).collect();
        let (edges, costs) = grid(rows, columns, spreads.costs);
        let found = transport_at_costs(&w, &edges, &costs).expect("a balance on a grid");
        Ok(SurfaceWitness {
            first: [top, left],
            net: found.heights.chunks(columns).map(<[i64]>::to_vec).collect(),
            unit: spreads.unit.clone(),
            level,
            parameters: parameters.clone(),
            distance: found.value * &spreads.unit,
        })
    }

    /// The net a_i + b_j of the two polygons that are extremal at s and at t. Its
    /// distance at (s, t) is the sum of their distances.
    pub(super) fn separable(
        &self,
        level: u32,
        parameters: [Rational; 2],
        spreads: &Spreads,
    ) -> Result<SurfaceWitness, SurfaceError> {
        let mut polygons = Vec::with_capacity(2);
        let mut distance = Rational::zero();
        for (axis, t) in parameters.iter().enumerate() {
            let error = self.axes[axis].distances().error(level, t)?;
            distance += &(error.norm() * spreads.along(axis));
            let polygon = error.extremal_polygon();
            let cost = i64::from(spreads.costs[axis]);
            let points: Vec<i64> = polygon.points.iter().map(|point| point * cost).collect();
            polygons.push((polygon.first, points));
        }
        let row = |x: &i64| polygons[1].1.iter().map(|y| x + y).collect();
        Ok(SurfaceWitness {
            first: [polygons[0].0, polygons[1].0],
            net: polygons[0].1.iter().map(row).collect(),
            unit: spreads.unit.clone(),
            level,
            parameters,
            distance,
        })
    }
}

/// The least interval that contains the supports of both functionals.
fn span(pair: &[Functional; 2]) -> (i64, i64) {
    let supports = pair.iter().filter_map(Functional::support);
    let both = supports.reduce(|(from, to), (least, most)| (from.min(least), to.max(most)));
    both.expect("the coefficients sum to 1")
}

/// The edges of a grid, row by row, and for each edge the cost of its direction.
fn grid(rows: usize, columns: usize, costs: [u32; 2]) -> (Vec<(usize, usize)>, Vec<u32>) {
    let points = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
    let from = |(i, j): (usize, usize)| {
        let at = i * columns + j;
        let down = (i + 1 < rows).then_some(((at, at + columns), costs[0]));
        let along = (j + 1 < columns).then_some(((at, at + 1), costs[1]));
        down.into_iter().chain(along)
    };
    points.flat_map(from).unzip()
}
