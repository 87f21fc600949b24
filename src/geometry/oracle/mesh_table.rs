//! Reference values of a mesh as a table.

use super::source::OracleMesh;
use crate::float::{nearest, shortest};
use crate::mesh::{BeyondF64, LimitPoint, Normal, one_line, without_normals};
use std::fmt::Write as _;

/// A row for each point of a refined mesh: its number, counted from 0, its coordinates, those of its limit and of the unit normal
/// there, and why there is no normal. Each number is the nearest f64, as the shortest decimal that reads back, and a cell is
/// empty where there is no limit or no normal. With a `head`, lines that begin with `#` stand before the table.
///
/// # Errors
/// When a coordinate is beyond the greatest f64.
///
/// # Panics
/// Never: writing to memory does not fail.
///
/// ```
/// use subcert::exact::RealCyclotomic;
/// use subcert::mesh::{MeshScheme, PolygonMesh, limit_points};
/// use subcert::oracle::mesh_to_csv;
///
/// let points = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]];
/// let points = points.map(|point| point.map(RealCyclotomic::from)).to_vec();
/// let faces = vec![vec![0, 1, 2], vec![0, 3, 1], vec![0, 2, 3], vec![1, 3, 2]];
/// let mesh = PolygonMesh::new(points, faces)?;
/// let limits = limit_points(&mesh, MeshScheme::Loop)?;
/// let text = mesh_to_csv(&(&mesh).into(), &limits, None)?;
/// assert!(text.lines().nth(1).unwrap().starts_with("0,1.0,1.0,1.0,0.2,0.2,0.2,0.577"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn mesh_to_csv(
    mesh: &OracleMesh,
    limits: &[Option<LimitPoint>],
    head: Option<&[(&'static str, String)]>,
) -> Result<String, BeyondF64> {
    let mut text = String::new();
    if let Some(head) = head {
        for (key, value) in head {
            writeln!(text, "# {}", one_line(&format!("{key}: {value}"))).expect("memory");
        }
        if let Some(told) = without_normals(limits) {
            writeln!(text, "# normals: {told}").expect("memory");
        }
        text.push_str(
            "# columns: vertex: counted from 0; x, y, z: the point; limit: where it goes; normal: of length 1 there; \
             no_normal: why there is none; each number is the nearest f64; faces and exact numbers are in json\n",
        );
    }
    text.push_str("vertex,x,y,z,limit_x,limit_y,limit_z,normal_x,normal_y,normal_z,no_normal\n");
    for (vertex, (point, limit)) in mesh.points.iter().zip(limits).enumerate() {
        let position = limit.as_ref().map(|limit| limit.position.each_ref().map(nearest));
        let normal = limit.as_ref().map(|limit| limit.normal.as_ref());
        let unit = normal.and_then(Result::ok).map(Normal::unit);
        let reason = match normal {
            Some(normal) => normal.err().map_or("", |reason| reason.name()),
            None => "no limit",
        };
        let cells = |numbers: Option<[f64; 3]>| match numbers {
            Some(numbers) => numbers.map(shortest).join(","),
            None => ",,".to_owned(),
        };
        let point = point.each_ref().map(nearest);
        if point.iter().chain(position.iter().flatten()).any(|x| !x.is_finite()) {
            return Err(BeyondF64);
        }
        let [point, position, unit] = [Some(point), position, unit].map(cells);
        writeln!(text, "{vertex},{point},{position},{unit},{reason}").expect("memory");
    }
    Ok(text)
}
