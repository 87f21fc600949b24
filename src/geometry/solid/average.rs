//! The points of the next level: means of centroids.

use super::complex::{Complex, Face};
use crate::exact::{Rational, Scalar};
use crate::mesh::Point;

fn add<S: Scalar>(sum: &mut Point<S>, point: &Point<S>) {
    for (total, x) in sum.iter_mut().zip(point) {
        total.accumulate(x);
    }
}

fn scaled<S: Scalar>(point: &Point<S>, factor: &S) -> Point<S> {
    point.each_ref().map(|x| x.times(factor))
}

/// 1/n, or n.
fn share<S: Scalar>(n: usize) -> S {
    S::from_rational(&Rational::new(1, n))
}

fn whole<S: Scalar>(n: usize) -> S {
    S::from_rational(&Rational::from(n))
}

fn mean<S: Scalar>(points: &[Point<S>], numbers: &[usize], share: &S) -> Point<S> {
    let mut sum = points[numbers[0]].clone();
    numbers[1..].iter().for_each(|&number| add(&mut sum, &points[number]));
    scaled(&sum, share)
}

/// Points around which sums are taken, and how many terms they have.
struct Sums<S> {
    sums: Vec<Point<S>>,
    counts: Vec<usize>,
}

impl<S: Scalar> Sums<S> {
    fn new(count: usize) -> Sums<S> {
        let zero: Point<S> = std::array::from_fn(|_| S::zero());
        Sums { sums: vec![zero; count], counts: vec![0; count] }
    }

    fn add(&mut self, at: usize, point: &Point<S>) {
        add(&mut self.sums[at], point);
    }

    /// (own + sum/count)·factor; `shares` has 1/n at n.
    fn mean(&self, at: usize, own: &Point<S>, factor: &S, shares: &[S]) -> Point<S> {
        let mut total = scaled(&self.sums[at], &shares[self.counts[at].max(1)]);
        add(&mut total, own);
        scaled(&total, factor)
    }

    fn greatest_count(&self) -> usize {
        self.counts.iter().copied().max().unwrap_or(0)
    }
}

/// The middles of the edges, and the centroids of the faces and of the cells.
pub(crate) fn split_points<S: Scalar>(
    complex: &Complex,
    points: &[Point<S>],
) -> [Vec<Point<S>>; 3] {
    let [half, quarter, eighth] = [2, 4, 8].map(share);
    let edges = complex.edges.iter().map(|ends| mean(points, ends, &half)).collect();
    let faces = complex.faces.iter().map(|face| mean(points, &face.corners, &quarter)).collect();
    let cells = complex.cells.iter().map(|corners| mean(points, corners, &eighth)).collect();
    [edges, faces, cells]
}

/// The points of the next level, also of a part of a solid: those that all cells around them are
/// there for are right.
///
/// With the middles E of edges and the centroids F of faces and C of cells, the mean of the centroids is
///
/// | point | inside | at the boundary |
/// |---|---|---|
/// | vertex v | (v + Σ(ΣE + ΣF + C)/m)/8, over its m cells | (v + Σ(ΣE + F)/q)/4, over its q faces there |
/// | edge | (E + Σ(ΣF + C)/n)/4, over its n cells | (E + ΣF/2)/2, over its 2 faces there |
/// | face | (2F + C + C')/4 | F |
/// | cell | C | |
pub(crate) fn refined_points<S: Scalar>(complex: &Complex, points: &[Point<S>]) -> Vec<Point<S>> {
    let [middles, faces, cells] = split_points(complex, points);
    let (at_boundary, edge_at_boundary) = complex.boundary();
    let mut vertices: Sums<S> = Sums::new(complex.points);
    let mut edges: Sums<S> = Sums::new(complex.edges.len());
    let two: S = whole(2);
    // How many cells an edge has; at the boundary, how many faces of the boundary.
    for (cell, centroid) in cells.iter().enumerate() {
        for &vertex in complex.cells[cell].iter().filter(|vertex| !at_boundary[**vertex]) {
            vertices.add(vertex, centroid);
            vertices.counts[vertex] += 1;
        }
        for &edge in complex.cell_edges[cell].iter().filter(|edge| !edge_at_boundary[**edge]) {
            edges.add(edge, centroid);
            edges.counts[edge] += 1;
        }
    }
    for (face, centroid) in complex.faces.iter().zip(&faces) {
        // A face inside belongs to two cells.
        let outer = face.other.is_none();
        let twice = scaled(centroid, &two);
        for &vertex in &face.corners {
            match (at_boundary[vertex], outer) {
                (true, true) => {
                    vertices.add(vertex, centroid);
                    vertices.counts[vertex] += 1;
                }
                (false, false) => vertices.add(vertex, &twice),
                _ => {}
            }
        }
        for &edge in &face.edges {
            match (edge_at_boundary[edge], outer) {
                (true, true) => {
                    edges.add(edge, centroid);
                    edges.counts[edge] += 1;
                }
                (false, false) => edges.add(edge, &twice),
                _ => {}
            }
        }
    }
    let times: Vec<S> = (0..=edges.greatest_count()).map(whole).collect();
    for (edge, ends) in complex.edges.iter().enumerate() {
        let outer = edge_at_boundary[edge];
        let times = scaled(&middles[edge], &times[edges.counts[edge]]);
        for &vertex in ends.iter().filter(|vertex| at_boundary[**vertex] == outer) {
            vertices.add(vertex, &times);
        }
    }
    let most = vertices.greatest_count().max(edges.greatest_count()).max(8);
    let shares: Vec<S> = (0..=most).map(|n| share(n.max(1))).collect();
    let [half, quarter, eighth] = [2, 4, 8].map(|n| &shares[n]);
    let vertex = |v: usize| {
        let factor = if at_boundary[v] { quarter } else { eighth };
        vertices.mean(v, &points[v], factor, &shares)
    };
    let edge = |e: usize| {
        let factor = if edge_at_boundary[e] { half } else { quarter };
        edges.mean(e, &middles[e], factor, &shares)
    };
    let face = |(face, centroid): (&Face, &Point<S>)| match face.other {
        None => centroid.clone(),
        Some((other, _)) => {
            let mut sum = scaled(centroid, &two);
            add(&mut sum, &cells[face.cell.0]);
            add(&mut sum, &cells[other]);
            scaled(&sum, quarter)
        }
    };
    let mut refined: Vec<Point<S>> = (0..complex.points).map(vertex).collect();
    refined.extend((0..complex.edges.len()).map(edge));
    refined.extend(complex.faces.iter().zip(&faces).map(face));
    refined.extend(cells.iter().cloned());
    refined
}
