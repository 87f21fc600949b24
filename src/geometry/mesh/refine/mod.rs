//! Refinement of whole meshes.

mod catmull_clark;
mod doo_sabin;
mod tagged;
mod triangles;

use super::MAX_POINTS;
use super::connectivity::Connectivity;
use super::error::MeshError;
use super::field::{
    Conductor, check_common_field, check_fields, check_rules, check_tags, inner_valences,
};
use super::polygon::PolygonMesh;
use super::scheme::MeshScheme;
use super::stencil::Stencils;
use crate::exact::{RealCyclotomic, Scalar, format::short};
use std::borrow::Cow;
use std::collections::BTreeSet;

/// The most levels of refinement.
pub const MAX_MESH_LEVEL: u32 = 24;

/// The most binary digits of all new coordinates together, if each has as many as the longest old
/// one.
const MAX_BITS: u64 = 1 << 32;

/// The mesh refined `level` times.
///
/// | scheme | inside | boundary |
/// |---|---|---|
/// | Catmull–Clark | face points are means; an edge point is the mean of two vertices and two face points; vertices by the rules of the catalogue | the cubic B-spline of the boundary polygon: (1, 1)/2 and (1, 6, 1)/8, also at corners |
/// | Doo–Sabin | every face by the rules of the catalogue; a new face for each face, each inner edge and each inner vertex | none: the mesh shrinks, as an open net of biquadratic B-splines does |
/// | Loop | an edge point is (3, 3, 1, 1)/8; vertices by the rules of the catalogue | as of Catmull–Clark |
///
/// Isolated points stay as they are. Points of Catmull–Clark are numbered vertices first, then edges, then faces; of Loop, vertices,
/// then edges; of Doo–Sabin, the vertices of the first face, of the second face, and so on.
///
/// # Errors
/// When the scheme has no rules for a face or a vertex, the level is beyond [`MAX_MESH_LEVEL`], or
/// the mesh would have more than [`MAX_POINTS`] points or too large numbers.
///
/// # Panics
/// Never.
///
/// ```
/// use subcert::exact::{Rational, RealCyclotomic};
/// use subcert::mesh::{MeshScheme, PolygonMesh, refine_mesh};
///
/// let points = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]];
/// let points = points.map(|point| point.map(RealCyclotomic::from));
/// let square = PolygonMesh::new(points.to_vec(), vec![vec![0, 1, 2, 3]])?;
/// let refined = refine_mesh(&square, MeshScheme::CatmullClark, 1)?;
/// assert_eq!((refined.points().len(), refined.faces().len()), (9, 4));
/// let half = RealCyclotomic::from(Rational::new(1, 2));
/// assert_eq!(refined.points()[0], [half.clone(), half, RealCyclotomic::from(0)]);
/// # Ok::<(), subcert::mesh::MeshError>(())
/// ```
pub fn refine_mesh(
    mesh: &PolygonMesh<RealCyclotomic>,
    scheme: MeshScheme,
    level: u32,
) -> Result<PolygonMesh<RealCyclotomic>, MeshError> {
    if level > MAX_MESH_LEVEL {
        let reason = format!("level {level} is too high; at most {MAX_MESH_LEVEL} is");
        return Err(MeshError::TooMuch { reason });
    }
    check_rules(mesh.connectivity(), scheme)?;
    check_tags(mesh, scheme)?;
    let points = counts(mesh.connectivity(), scheme, level);
    if points > MAX_POINTS {
        return Err(MeshError::TooManyPoints { points });
    }
    let mut refined = Cow::Borrowed(mesh);
    for level in 1..=level {
        refined = Cow::Owned(step(&refined, scheme, level)?);
    }
    Ok(refined.into_owned().with_isolated(mesh.isolated().to_vec()))
}

/// The number of points after `level` levels. For Doo–Sabin on a mesh with boundary, which shrinks,
/// it is not known before, and this is 0.
fn counts(connectivity: &Connectivity, scheme: MeshScheme, level: u32) -> usize {
    let (mut points, mut edges) = (connectivity.point_count(), connectivity.edges().len());
    let (mut faces, mut corners) = (connectivity.faces().len(), connectivity.corner_count());
    if scheme == MeshScheme::DooSabin && connectivity.edges().iter().any(|e| e.other.is_none()) {
        return 0;
    }
    // Each number grows at most by a factor of 4, so that 24 levels of 2^23 do not overflow.
    for _ in 0..level {
        (points, edges, faces) = match scheme {
            MeshScheme::CatmullClark | MeshScheme::Bajaj => {
                (points + edges + faces, 2 * edges + corners, corners)
            }
            MeshScheme::DooSabin => (corners, 2 * corners, points + edges + faces),
            MeshScheme::Loop | MeshScheme::LoopWarren => {
                (points + edges, 2 * edges + 3 * faces, 4 * faces)
            }
        };
        corners *= 4;
    }
    points
}

/// The refinement to this level from the one before it.
fn step(
    mesh: &PolygonMesh<RealCyclotomic>,
    scheme: MeshScheme,
    level: u32,
) -> Result<PolygonMesh<RealCyclotomic>, MeshError> {
    let connectivity = mesh.connectivity();
    let (vertices, edges) = (connectivity.point_count(), connectivity.edges().len());
    let (faces, corners) = (connectivity.faces().len(), connectivity.corner_count());
    let count = match scheme {
        MeshScheme::CatmullClark | MeshScheme::Bajaj => vertices + edges + faces,
        MeshScheme::DooSabin => corners,
        MeshScheme::Loop | MeshScheme::LoopWarren => vertices + edges,
    };
    let stencils = Stencils::new(scheme, weighted_valences(connectivity, scheme));
    if count > MAX_POINTS {
        return Err(MeshError::TooManyPoints { points: count });
    }
    if check_common_field(connectivity, mesh.points(), scheme, count).is_err() {
        let fields = step_with(&mesh.map(Conductor::of), scheme, &stencils.map(Conductor::of))?;
        check_fields(fields.points(), |new| {
            let old = match (scheme, new.checked_sub(vertices)) {
                (MeshScheme::DooSabin, _) => {
                    connectivity.faces().iter().flatten().nth(new).copied()
                }
                (_, None) => Some(new),
                (_, Some(edge)) => connectivity.edges().get(edge).map(|edge| edge.ends[0]),
            };
            let near = mesh.points()[old.unwrap_or(0)].each_ref().map(|x| short(x, 6)).join(", ");
            format!("level {level}: the new point near ({near})")
        })?;
    }
    check_bits(mesh, count)?;
    step_with(mesh, scheme, &stencils)
}

/// The valences whose weights one level needs: of the faces for Doo–Sabin, else of the inner
/// vertices.
pub(crate) fn weighted_valences(
    connectivity: &Connectivity,
    scheme: MeshScheme,
) -> BTreeSet<usize> {
    match scheme {
        MeshScheme::DooSabin => connectivity.faces().iter().map(Vec::len).collect(),
        _ => inner_valences(connectivity).map(|(_, valence)| valence).collect(),
    }
}

/// One level of refinement by the given weights. Nothing is checked but the number of points;
/// `stencils` has the weights of all [`weighted_valences`].
///
/// # Errors
/// When the next mesh has too many points.
pub(crate) fn step_with<S: Scalar>(
    mesh: &PolygonMesh<S>,
    scheme: MeshScheme,
    stencils: &Stencils<S>,
) -> Result<PolygonMesh<S>, MeshError> {
    match scheme {
        MeshScheme::CatmullClark | MeshScheme::Bajaj => catmull_clark::step(mesh, stencils),
        MeshScheme::DooSabin => doo_sabin::step(mesh, stencils),
        MeshScheme::Loop | MeshScheme::LoopWarren => triangles::step(mesh, stencils),
    }
}

/// Refuses a level of `count` new points if they have too many digits, each coordinate having as
/// many as the longest one now.
fn check_bits(mesh: &PolygonMesh<RealCyclotomic>, count: usize) -> Result<(), MeshError> {
    let longest = mesh.points().iter().flatten().map(RealCyclotomic::bits).max().unwrap_or(0);
    let count = u64::try_from(count.min(MAX_POINTS)).unwrap_or(u64::MAX);
    if longest.saturating_mul(3 * count) > MAX_BITS {
        let reason = format!(
            "{count} points with coordinates of up to {longest} binary digits are too many; take a \
             lower level, or round the coordinates"
        );
        return Err(MeshError::TooMuch { reason });
    }
    Ok(())
}
