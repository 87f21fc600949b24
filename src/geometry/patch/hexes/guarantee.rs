//! What the longest edge of a solid and the ways in which its cells meet guarantee
//! (`proofs/THEOREMS.md`, 102), and what a paper's formula promises.

use crate::exact::Rational;
use crate::mesh::MeshError;
use crate::patch::distance::surface::{TooMuch as _, positive};
use crate::patch::mesh::apriori::{APriori, UP, longest_edge, real};
use crate::patch::mesh::distances::MeshDistances;
use crate::patch::shapes::convergence::LAST;
use crate::patch::shapes::shape::Shape;
use crate::patch::shapes::surroundings::Surroundings;
use crate::solid::HexMesh;
use std::collections::BTreeSet;

/// The paper that has a formula for the depth of the boundary of Bajaj's solids.
pub const SOLID_FORMULA_PAPER: &str = "mustafa2007-bajaj";

/// The level that the longest edge of a solid guarantees, whatever its points are.
///
/// `distances` are those of the same mesh. The ratio is the factor by which the bound falls from one level to
/// the next in the mean of many.
///
/// # Errors
/// When the tolerance is not positive or less than 2^−900 of the size of the solid, or needs more levels than bounds are
/// computed for, or the coordinates are beyond 2^900, or all nearer to each other than 2^−900.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::patch::{MeshDistances, solid_a_priori};
/// use subcert::solid::HexMesh;
///
/// let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(Rational::from);
/// let cube = HexMesh::new((0..8).map(corner).collect(), &[[0, 1, 3, 2, 4, 5, 7, 6]])?;
/// let distances = MeshDistances::of_solid(cube.clone())?;
/// let tolerance = Rational::new(1, 100);
/// let guaranteed = solid_a_priori(&cube, &distances, &tolerance)?;
/// assert!(guaranteed.level >= distances.depth(&tolerance)?.level);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solid_a_priori(
    mesh: &HexMesh<Rational>,
    distances: &MeshDistances,
    tolerance: &Rational,
) -> Result<APriori, MeshError> {
    positive::<MeshError>(tolerance)?;
    let edges = mesh.edges().iter().copied();
    let (longest_edge, allowed) = longest_edge::<MeshError>(mesh.points(), edges, tolerance)?;
    let model = &distances.model;
    let shapes: BTreeSet<usize> = model.roots.all.iter().map(|root| root.shape).collect();
    let radii: Vec<(&Shape, f64)> = shapes
        .into_iter()
        .map(|shape| model.shapes.get(shape))
        .map(|shape| (shape, real(radius(shape))))
        .collect();
    // Edges of level 1 are at most 7/4 of those of level 0, and P^1 − P^0 at most 3/4.
    let later = |level: u32| {
        let bound = |(shape, radius): &(&Shape, f64)| {
            // Second differences across layers are at most 2.
            let bends = match shape.surroundings.layers() {
                Some(_) if !shape.is_regular() => 1.0 / (3.0 * shape.convergence.bound(0)),
                _ => 0.0,
            };
            let size = if shape.is_regular() { 1.0 } else { radius + bends };
            shape.bound(1.75 * size, level - 1)
        };
        radii.iter().map(bound).fold(0.0, f64::max)
    };
    let bound = |level: u32| if level == 0 { 0.75 + later(1) } else { later(level) };
    let last = u32::try_from(LAST).unwrap_or(u32::MAX);
    let level = (0..=last).find(|level| bound(*level) * UP <= allowed).ok_or_else(|| {
        MeshError::too_much(format!(
            "the longest edge guarantees nothing within {last} levels for this tolerance; take a \
             greater one"
        ))
    })?;
    let ratio = (bound(last) / bound(1)).powf(1.0 / f64::from(last - 1));
    Ok(APriori { level, longest_edge, ratio })
}

/// The most edges from the first point of a piece to another one.
fn radius(shape: &Shape) -> usize {
    let Surroundings::Solid(local) = &shape.surroundings else { return 0 };
    let mut distances = vec![usize::MAX; local.complex.points];
    distances[0] = 0;
    let mut changed = true;
    while changed {
        changed = false;
        for [left, right] in &local.complex.edges {
            let near = distances[*left].min(distances[*right]);
            for end in [*left, *right] {
                if near != usize::MAX && distances[end] > near + 1 {
                    distances[end] = near + 1;
                    changed = true;
                }
            }
        }
    }
    distances.into_iter().max().unwrap_or(0)
}

/// The depth of the boundary by Theorem 2 of that paper: the least k with 23/12·(3/4)^k β ≤ ε, β the longest
/// edge of the boundary.
///
/// That paper's proof has gaps; `proofs/THEOREMS.md`, 71, proves what it says. It says nothing of what is
/// inside the solid.
///
/// # Errors
/// As [`solid_a_priori`], for the coordinates and for a tolerance that is too small.
pub fn solid_formula_level(
    mesh: &HexMesh<Rational>,
    tolerance: &Rational,
) -> Result<u32, MeshError> {
    positive::<MeshError>(tolerance)?;
    let sides = |[a, b, c, d]: [usize; 4]| [[a, b], [b, c], [c, d], [d, a]];
    let edges = mesh.boundary_faces().into_iter().flat_map(sides);
    let (_, allowed) = longest_edge::<MeshError>(mesh.points(), edges, tolerance)?;
    let within = |level: &u32| {
        let power = 0.75_f64.powi(i32::try_from(*level).unwrap_or(i32::MAX));
        23.0 / 12.0 * power * UP <= allowed
    };
    Ok((0..1_000_000).find(within).unwrap_or(1_000_000))
}
