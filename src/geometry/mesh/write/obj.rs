//! OBJ.

use super::super::limit::LimitPoint;
use super::super::polygon::PolygonMesh;
use super::{BeyondF64, decimals, one_line};
use crate::exact::RealCyclotomic;
use crate::float::shortest;
use std::fmt::Write as _;

/// A mesh as OBJ: the nearest f64 of each coordinate, as the shortest decimal that reads back.
/// With `limits`, a unit normal for each vertex, if all have one.
///
/// # Errors
/// When a coordinate is beyond the greatest f64.
///
/// # Panics
/// Never: writing to memory does not fail.
///
/// ```
/// use subcert::exact::{Rational, RealCyclotomic};
/// use subcert::mesh::{PolygonMesh, to_obj};
///
/// let x = RealCyclotomic::from(Rational::new(1, 3));
/// let zero = RealCyclotomic::from(0);
/// let point = |a: &RealCyclotomic, b: &RealCyclotomic| [a.clone(), b.clone(), zero.clone()];
/// let points = vec![point(&zero, &zero), point(&x, &zero), point(&zero, &x)];
/// let mesh = PolygonMesh::new(points, vec![vec![0, 1, 2]])?;
/// let text = to_obj(&mesh, "a triangle", &[])?;
/// assert!(text.ends_with("v 0.3333333333333333 0.0 0.0\nv 0.0 0.3333333333333333 0.0\nf 1 2 3\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_obj(
    mesh: &PolygonMesh<RealCyclotomic>,
    title: &str,
    limits: &[Option<LimitPoint>],
) -> Result<String, BeyondF64> {
    let mut text = format!("# {}\n", one_line(title));
    for point in mesh.points() {
        let [x, y, z] = decimals(point)?;
        writeln!(text, "v {x} {y} {z}").expect("memory");
    }
    let normals = limits.iter().map(|limit| limit.as_ref()?.normal.as_ref());
    let normals: Option<Vec<_>> = normals.collect();
    let normals = normals.filter(|normals| normals.len() == mesh.points().len());
    for normal in normals.iter().flatten() {
        let [x, y, z] = normal.unit().map(shortest);
        writeln!(text, "vn {x} {y} {z}").expect("memory");
    }
    for face in mesh.faces() {
        text.push('f');
        for vertex in face.iter().map(|vertex| vertex + 1) {
            write!(text, " {vertex}").expect("memory");
            if normals.is_some() {
                write!(text, "//{vertex}").expect("memory");
            }
        }
        text.push('\n');
    }
    Ok(text)
}
