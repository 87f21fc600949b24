//! STL.

use super::super::polygon::PolygonMesh;
use super::{BeyondF64, decimals, one_line};
use crate::exact::RealCyclotomic;
use std::fmt::Write as _;

/// A mesh as ascii STL: the nearest f64 of each coordinate, as the shortest decimal that reads back.
///
/// A face of n vertices is n − 2 triangles with its first vertex. The normal of each triangle is `0 0 0`, for which programs
/// compute their own. Points of no face are left out.
///
/// # Errors
/// When a coordinate is beyond the greatest f64.
///
/// # Panics
/// Never: writing to memory does not fail.
///
/// ```
/// use subcert::exact::RealCyclotomic;
/// use subcert::mesh::{PolygonMesh, to_stl};
///
/// let points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]].map(|point| point.map(RealCyclotomic::from));
/// let mesh = PolygonMesh::new(points.to_vec(), vec![vec![0, 1, 2, 3]])?;
/// let text = to_stl(&mesh, "a square")?;
/// assert_eq!(text.matches("endfacet").count(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_stl(mesh: &PolygonMesh<RealCyclotomic>, title: &str) -> Result<String, BeyondF64> {
    let points = mesh.points().iter().map(|point| Ok(decimals(point)?.join(" ")));
    let points = points.collect::<Result<Vec<String>, BeyondF64>>()?;
    let mut text = format!("solid {}\n", one_line(title));
    for face in mesh.faces() {
        for pair in face[1..].windows(2) {
            text.push_str("facet normal 0 0 0\n  outer loop\n");
            for vertex in [face[0], pair[0], pair[1]] {
                writeln!(text, "    vertex {}", points[vertex]).expect("memory");
            }
            text.push_str("  endloop\nendfacet\n");
        }
    }
    text.push_str("endsolid\n");
    Ok(text)
}
