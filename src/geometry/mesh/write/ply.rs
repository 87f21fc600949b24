//! PLY.

use super::super::polygon::PolygonMesh;
use super::off::points_and_faces;
use super::{BeyondF64, one_line};
use crate::exact::RealCyclotomic;

/// A mesh as ascii PLY: the nearest f64 of each coordinate, as the shortest decimal that reads
/// back.
///
/// # Errors
/// When a coordinate is beyond the greatest f64.
///
/// ```
/// use subcert::exact::RealCyclotomic;
/// use subcert::mesh::{PolygonMesh, to_ply};
///
/// let points = [[0, 0, 0], [1, 0, 0], [0, 1, 0]].map(|point| point.map(RealCyclotomic::from));
/// let mesh = PolygonMesh::new(points.to_vec(), vec![vec![0, 1, 2]])?;
/// let text = to_ply(&mesh, "a triangle")?;
/// assert!(text.ends_with("end_header\n0.0 0.0 0.0\n1.0 0.0 0.0\n0.0 1.0 0.0\n3 0 1 2\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_ply(mesh: &PolygonMesh<RealCyclotomic>, title: &str) -> Result<String, BeyondF64> {
    // Faces of up to 255 vertices have their number in a byte, which every reader knows.
    let large = mesh.faces().iter().any(|face| face.len() > 255);
    let mut text = format!(
        "ply\nformat ascii 1.0\ncomment {}\nelement vertex {}\nproperty double x\nproperty double y\n\
         property double z\nelement face {}\nproperty list {} int vertex_indices\nend_header\n",
        one_line(title),
        mesh.points().len() + mesh.isolated().len(),
        mesh.faces().len(),
        if large { "int" } else { "uchar" },
    );
    points_and_faces(mesh, &mut text)?;
    Ok(text)
}
