//! Bajaj's scheme: every hexahedron is divided into eight, then every point is moved to the mean of
//! the centroids around it.

use super::complex::{Complex, Face};
use super::cube::{Middle, middle};
use super::error::SolidError;
use super::hexes::HexMesh;
use super::{MAX_POINTS, MAX_SOLID_LEVEL};
use crate::exact::{Rational, Scalar};
use crate::mesh::Point;
use std::borrow::Cow;

/// The most binary digits of all coordinates of a refined mesh together.
const MAX_BITS: u64 = 4_000_000_000;

/// The mesh after `level` levels of Bajaj's scheme (Bajaj, Schaefer, Warren and Xu 2002).
///
/// Each hexahedron is divided at the middles of its edges, the centroids of its faces and its own. Each of
/// these points, and each vertex, moves to the mean of the centroids of the new hexahedra that have
/// it; at the boundary, of the new quadrilaterals of the boundary that have it. The points of the next
/// level are the vertices, the edges, the faces and the cells, in this order. Cell 8c + i is the part
/// of cell c at its corner i; corner i is at (i & 1, i >> 1 & 1, i >> 2) of the cell.
///
/// # Errors
/// When the level is above [`MAX_SOLID_LEVEL`], or there would be too many points, or too long numbers.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::solid::{HexMesh, refine_solid};
///
/// let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(Rational::from);
/// let mesh = HexMesh::new((0..8).map(corner).collect(), &[[0, 1, 3, 2, 4, 5, 7, 6]])?;
/// let refined = refine_solid(&mesh, 1)?;
/// // Three quadrilaterals of the boundary have their centroids a quarter away in two directions.
/// assert_eq!((refined.points().len(), refined.cells().len()), (27, 8));
/// assert_eq!(refined.points()[0], [1, 1, 1].map(|p| Rational::new(p, 6)));
/// # Ok::<(), subcert::solid::SolidError>(())
/// ```
pub fn refine_solid(mesh: &HexMesh<Rational>, level: u32) -> Result<HexMesh<Rational>, SolidError> {
    if level > MAX_SOLID_LEVEL {
        let reason = format!("level {level} is too high; at most {MAX_SOLID_LEVEL} is");
        return Err(SolidError::TooMuch { reason });
    }
    let points = count(mesh.complex(), level);
    if points > MAX_POINTS {
        return Err(SolidError::TooManyPoints { points });
    }
    let mut refined = Cow::Borrowed(mesh);
    for _ in 0..level {
        check_bits(&refined)?;
        let points = refined_points(refined.complex(), refined.points());
        let cells = refined_cells(refined.complex());
        let complex = Complex::new(points.len(), cells)?;
        refined = Cow::Owned(HexMesh::refined(points, complex));
    }
    Ok(refined.into_owned())
}

/// The number of points after `level` levels.
fn count(complex: &Complex, level: u32) -> usize {
    let (mut points, mut edges) = (complex.points, complex.edges.len());
    let (mut faces, mut cells) = (complex.faces.len(), complex.cells.len());
    // Each number grows at most by a factor of 8, so that 12 levels of 2^24 do not overflow.
    for _ in 0..level {
        points += edges + faces + cells;
        edges = 2 * edges + 4 * faces + 6 * cells;
        faces = 4 * faces + 12 * cells;
        cells *= 8;
    }
    points
}

fn check_bits(mesh: &HexMesh<Rational>) -> Result<(), SolidError> {
    let bits = |x: &Rational| x.numerator().bits().max(x.denominator().bits());
    let longest = mesh.points().iter().flatten().map(bits).max().unwrap_or(0);
    let count = u64::try_from(count(mesh.complex(), 1)).unwrap_or(u64::MAX);
    if longest.saturating_mul(3 * count) > MAX_BITS {
        let reason = format!(
            "{count} points with coordinates of up to {longest} binary digits are too many; take a \
             lower level, or round the coordinates"
        );
        return Err(SolidError::TooMuch { reason });
    }
    Ok(())
}

/// The number of a point of the next level.
fn number(complex: &Complex, cell: usize, middle: Middle) -> usize {
    let (vertices, edges, faces) = (complex.points, complex.edges.len(), complex.faces.len());
    match middle {
        Middle::Corner(corner) => complex.cells[cell][corner],
        Middle::Edge(edge) => vertices + complex.cell_edges[cell][edge],
        Middle::Face(face) => vertices + edges + complex.cell_faces[cell][face],
        Middle::Cell => vertices + edges + faces + cell,
    }
}

/// The corners of part `part` of a cell, in the next level.
pub(crate) fn part_corners(complex: &Complex, cell: usize, part: usize) -> [usize; 8] {
    [0, 1, 2, 3, 4, 5, 6, 7].map(|corner| number(complex, cell, middle(part, corner)))
}

/// The cells of the next level.
pub(super) fn refined_cells(complex: &Complex) -> Vec<[usize; 8]> {
    let parts = (0..complex.cells.len()).flat_map(|cell| (0..8).map(move |part| (cell, part)));
    parts.map(|(cell, part)| part_corners(complex, cell, part)).collect()
}

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
