//! Doo–Sabin.

use super::super::error::MeshError;
use super::super::field::{Conductor, check_limits};
use super::super::point::{Point, sum};
use super::super::polygon::PolygonMesh;
use super::super::refine::refine_mesh;
use super::super::scheme::MeshScheme;
use super::circle::circular;
use super::missing::NoNormal;
use super::normal::Normal;
use super::vertex::LimitPoint;
use crate::exact::{Rational, RealCyclotomic, Scalar};

/// After one refinement an inner vertex is a face. The centre of a face stays where it is, and
/// the sums Σ cos(2πi/n) x_i over its vertices are halved by each refinement.
pub(super) fn limits(
    mesh: &PolygonMesh<RealCyclotomic>,
) -> Result<Vec<Option<LimitPoint>>, MeshError> {
    let connectivity = mesh.connectivity();
    let refined = refine_mesh(mesh, MeshScheme::DooSabin, 1)?;
    let inner_edges = connectivity.edges().iter().filter(|edge| edge.other.is_some()).count();
    // The faces of vertices come after those of faces and inner edges.
    let faces = &refined.faces()[connectivity.faces().len() + inner_edges..];
    let corners = |face: &[usize]| -> Vec<&Point<RealCyclotomic>> {
        face.iter().map(|&v| &refined.points()[v]).collect()
    };
    let inner = (0..mesh.points().len()).filter(|vertex| !connectivity.star(*vertex).boundary);
    check_limits(
        inner
            .zip(faces)
            .map(|(vertex, face)| (vertex, Conductor::around(Some(face.len()), corners(face)))),
    )?;
    let mut faces = faces.iter();
    let limit = |vertex| {
        if connectivity.star(vertex).boundary {
            return None;
        }
        let corners = corners(faces.next()?);
        let share = RealCyclotomic::from(Rational::new(1, corners.len()));
        let position = sum(corners.iter().copied()).map(|x| x.times(&share));
        let normal = Normal::of(&circular(&corners)).ok_or(NoNormal::Parallel);
        Some(LimitPoint { position, normal, sectors: Vec::new() })
    };
    Ok((0..mesh.points().len()).map(limit).collect())
}
