//! Norms of functionals on data whose differences along edges are at most 1.

use super::powers::Functional;
use crate::bound::transport_at_costs;
use crate::exact::{Rational, Real};
use crate::scheme::{Point, difference, sum};
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};

/// The most points between which a functional is transported.
const MAX_POINTS: usize = 20_000;

/// The edges along which data of a lattice differ by at most 1.
#[derive(Clone, Debug)]
pub struct Edges {
    all: Vec<Point>,
    dimension: usize,
    /// Whether the shortest paths between points of a box stay in it.
    in_boxes: bool,
}

/// The greatest value of a functional, with what proves it.
///
/// The heights p differ by at most 1 along all edges, and Σ_β f_β p_β is the value; so it is not less. The flow carries f_β out of each place β along
/// edges, and Σ|flow| is the value; so it is not more.
#[derive(Clone, Debug, PartialEq)]
pub struct Norm<S> {
    /// max { Σ_β f_β p_β }.
    pub value: S,
    /// Integer data that attain it.
    pub heights: BTreeMap<Point, i64>,
    /// From one place to another, so much; a step may be several edges, whose number counts.
    pub flow: Vec<(Point, Point, u32, S)>,
}

/// A functional for which there is no norm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NormError {
    /// The coefficients do not sum to 0.
    #[error("the coefficients of the functional do not sum to 0, so that its values are unbounded")]
    Unbounded,
    /// Too many places.
    #[error("a functional over more than {MAX_POINTS} places")]
    Places,
}

impl Edges {
    /// These edges, both ways.
    #[must_use]
    pub fn new(edges: &[Point], dimension: usize) -> Edges {
        let both: BTreeSet<Point> =
            edges.iter().flat_map(|edge| [*edge, difference([0; 3], *edge)]).collect();
        let zero = [0; 3];
        // A box is kept by cutting off coordinates. This takes edges to edges, or to single points, if their entries are −1, 0 and 1, and each part of an edge
        // is one. So a shortest path can be taken in the box.
        let parts = |edge: &Point| {
            let part = |set: usize, edge: &Point| -> Point {
                std::array::from_fn(|i| if set >> i & 1 == 1 { edge[i] } else { 0 })
            };
            (0..8).map(|set| part(set, edge)).collect::<Vec<Point>>()
        };
        let in_boxes = both.iter().all(|edge| {
            edge.iter().all(|x| x.abs() <= 1)
                && parts(edge).iter().all(|part| *part == zero || both.contains(part))
        });
        let forward = both.iter().filter(|edge| **edge > zero).copied().collect();
        Edges { all: forward, dimension, in_boxes }
    }

    /// max { Σ_β f_β p_β : |p_{β+u} − p_β| ≤ 1 for all β and edges u }, which is the least Σ|flow| of flows along edges that carry f_β out of each β.
    /// By duality of linear programs some integer data attain it.
    ///
    /// # Errors
    /// When the coefficients do not sum to 0, or there are too many places.
    ///
    /// # Panics
    /// Never: the edges join all points.
    pub fn norm<S: Real + Ord>(&self, functional: &Functional<S>) -> Result<Norm<S>, NormError> {
        if S::total(functional.values()) != S::zero() {
            return Err(NormError::Unbounded);
        }
        if functional.is_empty() {
            return Ok(Norm { value: S::zero(), heights: BTreeMap::new(), flow: Vec::new() });
        }
        let (points, edges, costs) =
            if self.in_boxes { self.in_box(functional)? } else { self.complete(functional)? };
        let weights: Vec<S> = points
            .iter()
            .map(|point| functional.get(point).cloned().unwrap_or_else(S::zero))
            .collect();
        let found =
            transport_at_costs(&weights, &edges, &costs).expect("the edges join all points");
        let zero = S::zero();
        let moved = edges.iter().zip(&costs).zip(found.flow).filter(|(_, flow)| *flow != zero);
        let flow = moved.map(|((&(a, b), cost), flow)| (points[a], points[b], *cost, flow));
        Ok(Norm {
            value: found.value,
            flow: flow.collect(),
            heights: points.iter().copied().zip(found.heights).collect(),
        })
    }

    /// All points of the box of the places, and the edges between them.
    fn in_box<S>(&self, functional: &Functional<S>) -> Result<Graph, NormError> {
        let mut ranges = [[i64::MAX, i64::MIN]; 3];
        for place in functional.keys() {
            for (range, x) in ranges.iter_mut().zip(place) {
                *range = [range[0].min(*x), range[1].max(*x)];
            }
        }
        let sizes = ranges.map(|[low, high]| usize::try_from(high - low + 1).unwrap_or(usize::MAX));
        let count = sizes.into_iter().fold(1_usize, usize::saturating_mul);
        if count > MAX_POINTS {
            return Err(NormError::Places);
        }
        let [x, y, z] = ranges.map(|[low, high]| low..=high);
        let plane = |x: i64| {
            let z = z.clone();
            y.clone().flat_map(move |y| z.clone().map(move |z| [x, y, z]))
        };
        let points: Vec<Point> = x.flat_map(plane).collect();
        let number = |point: Point| -> Option<usize> {
            let mut number = 0;
            for (axis, size) in sizes.into_iter().enumerate() {
                let offset = usize::try_from(point[axis] - ranges[axis][0]).ok()?;
                if offset >= size {
                    return None;
                }
                number = number * size + offset;
            }
            Some(number)
        };
        let of = |(a, point): (usize, &Point)| {
            let ends = self.all.iter().filter_map(|edge| number(sum(*point, *edge)));
            ends.map(move |b| (a, b)).collect::<Vec<_>>()
        };
        let edges: Vec<(usize, usize)> = points.iter().enumerate().flat_map(of).collect();
        let costs = vec![1; edges.len()];
        Ok((points, edges, costs))
    }

    /// The places alone, each joined to each at the cost of a shortest path.
    fn complete<S>(&self, functional: &Functional<S>) -> Result<Graph, NormError> {
        let points: Vec<Point> = functional.keys().copied().collect();
        let pairs = || (0..points.len()).flat_map(|b| (0..b).map(move |a| (a, b)));
        let wanted: BTreeSet<Point> =
            pairs().map(|(a, b)| difference(points[b], points[a])).collect();
        let distances = self.distances(wanted)?;
        let edges: Vec<(usize, usize)> = pairs().collect();
        let costs = edges.iter().map(|(a, b)| distances[&difference(points[*b], points[*a])]);
        let costs = costs.collect();
        Ok((points, edges, costs))
    }

    /// How many edges lead from 0 to each of these points.
    fn distances(&self, mut wanted: BTreeSet<Point>) -> Result<BTreeMap<Point, u32>, NormError> {
        let mut known = BTreeMap::from([([0; 3], 0)]);
        let mut front = vec![[0; 3]];
        let mut length = 0;
        wanted.remove(&[0; 3]);
        while !wanted.is_empty() {
            length += 1;
            let mut next = Vec::new();
            for point in &front {
                for edge in &self.all {
                    for end in [sum(*point, *edge), difference(*point, *edge)] {
                        if let Entry::Vacant(entry) = known.entry(end) {
                            entry.insert(length);
                            wanted.remove(&end);
                            next.push(end);
                        }
                    }
                }
            }
            if known.len() > MAX_POINTS {
                return Err(NormError::Places);
            }
            front = next;
        }
        Ok(known)
    }

    /// The edges, one way.
    #[must_use]
    pub fn all(&self) -> &[Point] {
        &self.all
    }

    /// d.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }
}

/// Points, edges between their numbers, and the costs of these.
type Graph = (Vec<Point>, Vec<(usize, usize)>, Vec<u32>);

/// Whether heights and a flow prove that the norm of a functional is this value.
#[must_use]
pub fn proves(functional: &Functional<Rational>, edges: &Edges, norm: &Norm<Rational>) -> bool {
    let attained: Rational = functional
        .iter()
        .map(|(place, c)| c * &Rational::from(norm.heights.get(place).copied().unwrap_or(0)))
        .sum();
    let height = |place: &Point| norm.heights.get(place).copied();
    let steep = norm.heights.keys().any(|place| {
        edges.all.iter().any(|edge| {
            let ends = height(place).zip(height(&sum(*place, *edge)));
            ends.is_some_and(|(a, b)| a.abs_diff(b) > 1)
        })
    });
    let mut rest = functional.clone();
    let mut cost = Rational::zero();
    for (from, to, count, flow) in &norm.flow {
        cost += &(flow.abs() * Rational::from(*count));
        *rest.entry(*from).or_insert_with(Rational::zero) -= flow;
        *rest.entry(*to).or_insert_with(Rational::zero) += flow;
    }
    !steep && attained == norm.value && cost == norm.value && rest.values().all(Rational::is_zero)
}
