//! What the longest edge and the valences of a mesh guarantee, wherever its points are
//! (`proofs/THEOREMS.md`, 96).

use super::model::moved;
use crate::bound::LocalConstants;
use crate::exact::{Enclosed, Rational, RealCyclotomic};
use crate::float::{exact, lower, nearest, upper};
use crate::mesh::{
    INFINITE_FROM, MeshError, MeshScheme, Point, PolygonMesh, Sharpness, Stencils, check_rules,
    check_tags, ring, weighted_valences,
};
use crate::patch::distance::surface::{TooMuch, positive};
use crate::patch::number::squared;
use crate::patch::range::scale;
use std::collections::BTreeSet;

/// What a mesh guarantees by its longest edge and its valences.
#[derive(Clone, Debug, PartialEq)]
pub struct APriori {
    /// The level from which on every mesh with these valences, and no longer edge, is within the
    /// tolerance.
    pub level: u32,
    /// An upper bound of the length of the longest edge, the least f64 or the next one.
    pub longest_edge: f64,
    /// The greatest factor by which edges of a level shrink, from some level on.
    pub ratio: f64,
}

/// The most levels.
const MAX_LEVEL: u32 = 100_000;

/// For the rounding of a few operations.
pub(crate) const UP: f64 = 1.0 + 1e-9;
const DOWN: f64 = 1.0 - 1e-9;

/// A tolerance is at least 2 to the power of minus this, in units of the scale.
const LEAST_BITS: i32 = 900;

/// The level that the longest edge and the valences of a mesh guarantee.
///
/// # Errors
/// When the scheme has no rules for a face or a vertex, the tolerance is not positive or less than 2^−900 of the size of
/// the mesh, or the coordinates are beyond 2^900, or all nearer to each other than 2^−900.
///
/// # Panics
/// Never: the catalogue has rules for all valences that are checked before.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::mesh::{MeshScheme, PolygonMesh};
/// use subcert::patch::a_priori;
///
/// let points = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]].map(|p| p.map(Rational::from));
/// let faces = vec![vec![0, 1, 2], vec![0, 3, 1], vec![0, 2, 3], vec![1, 3, 2]];
/// let mesh = PolygonMesh::new(points.to_vec(), faces)?;
/// let guaranteed = a_priori(&mesh, MeshScheme::Loop, &Rational::new(1, 100))?;
/// assert_eq!((guaranteed.level, guaranteed.ratio), (9, 0.5));
/// # Ok::<(), subcert::mesh::MeshError>(())
/// ```
pub fn a_priori(
    mesh: &PolygonMesh<Rational>,
    scheme: MeshScheme,
    tolerance: &Rational,
) -> Result<APriori, MeshError> {
    positive::<MeshError>(tolerance)?;
    check_tags(mesh, scheme)?;
    check_rules(mesh.connectivity(), scheme)?;
    let edges = mesh.connectivity().edges().iter().map(|edge| edge.ends);
    let (longest_edge, allowed) = longest_edge::<MeshError>(mesh.points(), edges, tolerance)?;
    let bound = match scheme {
        MeshScheme::CatmullClark | MeshScheme::Bajaj => bicubic(mesh, scheme),
        MeshScheme::DooSabin => doo_sabin(mesh),
        MeshScheme::Loop | MeshScheme::LoopWarren => triangles(mesh, scheme),
    };
    let level = (0..MAX_LEVEL).find(|level| bound.at(*level) <= allowed).ok_or_else(|| {
        MeshError::too_much(format!(
            "the tolerance needs more than {MAX_LEVEL} levels; take a greater one"
        ))
    })?;
    Ok(APriori { level, longest_edge, ratio: bound.ratio })
}

/// D_0 ≤ `first` and D_k ≤ `later`·`ratio`^{k−s} for k ≥ s, k ≥ 1, in units of the longest edge. For 1 ≤ k < s it is
/// that of level s and `step` for each level between.
struct Bound {
    first: f64,
    later: f64,
    ratio: f64,
    step: f64,
    settled: u32,
}

impl Bound {
    fn at(&self, level: u32) -> f64 {
        if level == 0 {
            return self.first * UP;
        }
        let after = i32::try_from(level.saturating_sub(self.settled)).unwrap_or(i32::MAX);
        let waiting = self.step * f64::from(self.settled.saturating_sub(level));
        (waiting + self.later * self.ratio.powi(after)) * UP
    }
}

/// What is said of the edges of a mesh, as far as the ratio depends on it.
struct Creases {
    /// The most faces between two sharp edges at a vertex.
    sector: usize,
    /// Whether a vertex that is smooth has a sharp edge, or a vertex stays where it is.
    ends: bool,
    /// How many levels long a sharpness falls.
    settled: u32,
}

impl Creases {
    fn of(mesh: &PolygonMesh<Rational>) -> Creases {
        let (connectivity, tags) = (mesh.connectivity(), mesh.tags());
        let mut found = Creases { sector: 0, ends: false, settled: 0 };
        let finite = tags.edges().values().chain(tags.vertices().values());
        for value in finite.filter_map(Sharpness::finite) {
            // At most 9.
            let levels = (1..=INFINITE_FROM).find(|levels| *value <= Rational::from(*levels));
            let levels = u32::try_from(levels.unwrap_or(INFINITE_FROM)).unwrap_or(0);
            found.settled = found.settled.max(levels);
        }
        for vertex in 0..connectivity.point_count() {
            let star = connectivity.star(vertex);
            let n = star.faces.len();
            let is_sharp = |&place: &usize| tags.edge(connectivity, star.edges[place]).is_some();
            let sharp: Vec<usize> = (0..star.edges.len()).filter(is_sharp).collect();
            let own = tags.vertex(vertex, &star).is_some();
            found.ends |= own || ![0, 2].contains(&sharp.len());
            if let [first, .., last] = sharp[..] {
                let between = sharp.windows(2).map(|pair| pair[1] - pair[0]);
                let around = (!star.boundary).then(|| first + n - last);
                found.sector = between.chain(around).fold(found.sector, usize::max);
            }
        }
        found
    }

    /// By how much longer edges may become on the way, and the least ratio. An edge inside that ends at a crease with
    /// three faces or more beside it shrinks with the bend of the crease: 96.
    fn at_quadrilaterals(&self) -> [f64; 2] {
        let (more, ratio) = if self.sector > 2 { (1.5, 0.75) } else { (1.0, 0.5) };
        [more, if self.ends { 5.0 / 6.0 } else { ratio }]
    }
}

/// An upper bound of the length of the longest of these edges, the least f64 or the next one; and at most the tolerance
/// divided by it.
pub(crate) fn longest_edge<E: TooMuch>(
    points: &[Point<Rational>],
    edges: impl IntoIterator<Item = [usize; 2]>,
    tolerance: &Rational,
) -> Result<(f64, f64), E> {
    let scale = scale::<E>(points)?;
    let longest = longest(points, &scale, edges);
    Ok((longest * nearest(&scale), share::<E>(tolerance, &scale)? / longest * DOWN))
}

/// The first of these in units of a scale, which is above all differences of coordinates from those of the first point.
pub(crate) fn longest(
    points: &[Point<Rational>],
    scale: &Rational,
    edges: impl IntoIterator<Item = [usize; 2]>,
) -> f64 {
    let rounded = moved(points, scale);
    let roughly = |[p, q]: &[usize; 2]| squared(&rounded[*p], &rounded[*q]);
    let edges: Vec<[usize; 2]> = edges.into_iter().collect();
    let greatest = edges.iter().map(roughly).fold(0.0_f64, f64::max);
    // Coordinates are at most 1, and off by half a unit: squares are off by half of this.
    let near = greatest - 32.0 * f64::EPSILON * (greatest.sqrt() + f64::EPSILON);
    let square = |&[p, q]: &[usize; 2]| {
        let own = |i: usize| (&points[p][i] - &points[q][i]) / scale;
        (0..3).map(own).fold(Rational::zero(), |sum, x| sum + &x * &x)
    };
    let longest = edges.iter().filter(|ends| roughly(ends) >= near).map(square).max();
    longest.map_or(0.0, |square| root_above(&square))
}

/// An f64 that is at most the tolerance in units of a scale.
fn share<E: TooMuch>(tolerance: &Rational, scale: &Rational) -> Result<f64, E> {
    let share = tolerance / scale;
    if share >= Rational::from(2).pow(-LEAST_BITS) {
        return Ok(lower(&share));
    }
    Err(E::too_much(format!(
        "the tolerance is less than 2^-{LEAST_BITS} of the greatest difference of coordinates; take a greater one"
    )))
}

/// The least f64 whose square is at least this number, at most 12; or the next one.
fn root_above(square: &Rational) -> f64 {
    let root = upper(square).sqrt();
    let is_above = exact(root).is_some_and(|root| &root * &root >= *square);
    if is_above { root } else { root.next_up() }
}

/// An f64 that is at least this.
pub(super) fn above(value: &RealCyclotomic) -> f64 {
    f64::from_bits(value.step(|x| upper(x).to_bits()))
}

/// The greatest T_1 of these valences.
fn contraction(scheme: MeshScheme, valences: impl IntoIterator<Item = usize>) -> f64 {
    let of = |n: usize| {
        let constants = LocalConstants::new(&ring(scheme, n), 1).ok();
        let found = constants.as_ref().and_then(|constants| constants.contraction(1));
        found.map_or(1.0, |(_, transport)| above(&transport.value))
    };
    valences.into_iter().map(of).fold(0.5, f64::max)
}

#[allow(clippy::cast_precision_loss)] // Valences are small.
pub(crate) fn real(n: usize) -> f64 {
    n as f64
}

/// The greatest distance of a vertex from the mean of a face of n vertices, in edges: ⌊n²/4⌋/n.
fn radius(n: usize) -> f64 {
    real(n * n / 4) / real(n)
}

/// By Bajaj's rules a vertex of any valence moves as far as one of valence 4 by Catmull and Clark's.
fn bicubic(mesh: &PolygonMesh<Rational>, scheme: MeshScheme) -> Bound {
    let faces: BTreeSet<usize> = mesh.faces().iter().map(Vec::len).collect();
    let valences = weighted_valences(mesh.connectivity(), scheme);
    let creases = Creases::of(mesh);
    let [more, slowest] = creases.at_quadrilaterals();
    let least = real(valences.first().copied().unwrap_or(4).min(4));
    if faces.iter().all(|&n| n == 4) {
        let ratio = contraction(scheme, valences.iter().copied()).max(slowest);
        let step = 2.0 / least;
        let later = more * step / (1.0 - ratio);
        let settled = creases.settled;
        let first = f64::from(settled) * step + later;
        return Bound { first, later, ratio, step, settled };
    }
    let r = faces.iter().map(|&n| radius(n)).fold(1.0_f64, f64::max);
    let all = valences.iter().chain(&faces).copied();
    let least = least.min(real(faces.first().copied().unwrap_or(4)));
    let ratio = contraction(scheme, all).max(slowest);
    let edge = r.max((1.0 + r) / 3.0 + (1.0 + 2.0 * r) / 4.0);
    let step = 2.0 / least * edge;
    let next = more * step / (1.0 - ratio);
    let settled = creases.settled.max(1);
    // What holds at level 1 holds of the mesh before, with the way from one to the other.
    let displaced = ((1.0 + r) / 3.0).max((1.0 + 2.0 * r) / 4.0);
    let first = displaced + f64::from(settled - 1) * step + next;
    Bound { first, later: next, ratio, step, settled }
}

fn triangles(mesh: &PolygonMesh<Rational>, scheme: MeshScheme) -> Bound {
    let valences = weighted_valences(mesh.connectivity(), scheme);
    let boundary = mesh.connectivity().edges().iter().any(|edge| edge.other.is_none());
    let ratio = contraction(scheme, valences.iter().copied());
    let ratio = if boundary || mesh.tags().has_sharp() { ratio.max(0.875) } else { ratio };
    let stencils = Stencils::new(scheme, valences.iter().copied());
    let moved = valences.iter().map(|&n| real(n) * above(&stencils.of(n)[1]));
    let step = moved.fold(0.25, f64::max);
    let later = step / (1.0 - ratio);
    Bound { first: later, later, ratio, step, settled: 0 }
}

/// The numbers of vertices of the faces of all levels of Doo and Sabin's scheme.
pub(super) fn face_sizes(mesh: &PolygonMesh<Rational>) -> BTreeSet<usize> {
    let star = |v: usize| mesh.connectivity().star(v);
    let inner = (0..mesh.points().len()).map(star).filter(|star| !star.boundary);
    let faces = mesh.faces().iter().map(Vec::len);
    inner.map(|star| star.faces.len()).chain(faces).chain([4]).collect()
}

/// Edges across those between two faces shrink differently from those of faces: with κ = c/(q − T), the
/// sum of the longest edge of all and κ times the longest edge of a face that comes from one of level
/// 0 falls by q = 3/4.
fn doo_sabin(mesh: &PolygonMesh<Rational>) -> Bound {
    const Q: f64 = 0.75;
    let sizes = face_sizes(mesh);
    let scheme = MeshScheme::DooSabin;
    let ratio = contraction(scheme, sizes.iter().copied());
    if ratio >= Q {
        let infinite = f64::INFINITY;
        return Bound { first: infinite, later: infinite, ratio: Q, step: 0.0, settled: 0 };
    }
    let stencils = Stencils::new(scheme, sizes.iter().copied());
    let (mut across, mut step) = (0.0_f64, 0.0_f64);
    for &n in &sizes {
        let weights: Vec<f64> = stencils.of(n).iter().map(above).collect();
        let way = |j: usize| weights[j] * real(j.min(n - j));
        let far: f64 = (2..n).map(way).sum();
        across = across.max(far + (weights[1] - 0.1875).abs() + 1e-15);
        step = step.max(far + weights[1] + radius(n));
    }
    // Of the first level two faces of any number of vertices meet.
    let first = (2.0 * across).max(1.0);
    let sum = first + across / (Q - ratio) * ratio;
    let next = step / (1.0 - Q) * sum;
    Bound { first: step + next, later: next / Q, ratio: Q, step: 0.0, settled: 0 }
}
