//! Doo–Sabin.

use super::super::error::MeshError;
use super::super::point::sum;
use super::super::polygon::PolygonMesh;
use super::super::refine::refine_mesh;
use super::super::scheme::MeshScheme;
use super::circle::circular;
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
    let mut faces = refined.faces()[connectivity.faces().len() + inner_edges..].iter();
    let limit = |vertex| {
        if connectivity.star(vertex).boundary {
            return None;
        }
        let face = faces.next()?;
        let corners: Vec<_> = face.iter().map(|&v| &refined.points()[v]).collect();
        let share = RealCyclotomic::from(Rational::new(1, corners.len()));
        let position = sum(corners.iter().copied()).map(|x| x.times(&share));
        Some(LimitPoint { position, normal: Normal::of(&circular(&corners)), sectors: Vec::new() })
    };
    Ok((0..mesh.points().len()).map(limit).collect())
}
