//! OFF.

use super::super::polygon::PolygonMesh;
use super::{BeyondF64, decimals, one_line};
use crate::exact::RealCyclotomic;
use std::fmt::Write as _;

/// A mesh as ascii OFF: the nearest f64 of each coordinate, as the shortest decimal that reads back.
///
/// # Errors
/// When a coordinate is beyond the greatest f64.
///
/// # Panics
/// Never: writing to memory does not fail.
///
/// ```
/// use subcert::exact::RealCyclotomic;
/// use subcert::mesh::{PolygonMesh, to_off};
///
/// let points = [[0, 0, 0], [1, 0, 0], [0, 1, 0]].map(|point| point.map(RealCyclotomic::from));
/// let mesh = PolygonMesh::new(points.to_vec(), vec![vec![0, 1, 2]])?;
/// let text = to_off(&mesh, "a triangle")?;
/// assert_eq!(text, "OFF\n# a triangle\n3 1 3\n0.0 0.0 0.0\n1.0 0.0 0.0\n0.0 1.0 0.0\n3 0 1 2\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_off(mesh: &PolygonMesh<RealCyclotomic>, title: &str) -> Result<String, BeyondF64> {
    let points = mesh.points().len() + mesh.isolated().len();
    let (faces, edges) = (mesh.faces().len(), mesh.connectivity().edges().len());
    let mut text = format!("OFF\n# {}\n{points} {faces} {edges}\n", one_line(title));
    points_and_faces(mesh, &mut text)?;
    Ok(text)
}

/// A line for each point, and for each face a line with the number of its vertices and these, from 0 on.
pub(super) fn points_and_faces(
    mesh: &PolygonMesh<RealCyclotomic>,
    text: &mut String,
) -> Result<(), BeyondF64> {
    for point in mesh.points().iter().chain(mesh.isolated()) {
        writeln!(text, "{}", decimals(point)?.join(" ")).expect("memory");
    }
    for face in mesh.faces() {
        write!(text, "{}", face.len()).expect("memory");
        for vertex in face {
            write!(text, " {vertex}").expect("memory");
        }
        text.push('\n');
    }
    Ok(())
}
