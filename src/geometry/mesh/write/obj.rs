//! OBJ.

use super::super::crease::{Boundary, Creasing, Sharpness};
use super::super::limit::{LimitPoint, without_normals};
use super::super::polygon::PolygonMesh;
use super::{BeyondF64, decimals, one_line};
use crate::exact::RealCyclotomic;
use crate::float::{nearest, shortest};
use std::fmt::Write as _;

/// A mesh as OBJ: the nearest f64 of each coordinate, as the shortest decimal that reads back.
/// With `limits`, a unit normal for each vertex, if all have one; otherwise a comment says why there are none. Texture coordinates are written as `vt`,
/// and creases, corners and holes as tags `t`, whose sharpness is rounded to f64 too.
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
    for point in mesh.points().iter().chain(mesh.isolated()) {
        let [x, y, z] = decimals(point)?;
        writeln!(text, "v {x} {y} {z}").expect("memory");
    }
    let normals = limits.iter().map(|limit| limit.as_ref()?.normal.as_ref().ok());
    if let Some(told) = without_normals(limits) {
        writeln!(text, "# no vn: {told}").expect("memory");
    }
    let normals: Option<Vec<_>> = normals.collect();
    let normals = normals.filter(|normals| normals.len() == mesh.points().len());
    for normal in normals.iter().flatten() {
        let [x, y, z] = normal.unit().map(shortest);
        writeln!(text, "vn {x} {y} {z}").expect("memory");
    }
    for value in mesh.texture().iter().flat_map(|texture| &texture.values) {
        let numbers: Vec<String> = value.iter().map(|x| shortest(nearest(x))).collect();
        if numbers.iter().any(|number| number.contains("inf")) {
            return Err(BeyondF64);
        }
        writeln!(text, "vt {}", numbers.join(" ")).expect("memory");
    }
    for (index, face) in mesh.faces().iter().enumerate() {
        text.push('f');
        for (i, vertex) in face.iter().map(|vertex| vertex + 1).enumerate() {
            write!(text, " {vertex}").expect("memory");
            match (mesh.texture().map(|texture| texture.faces[index][i] + 1), normals.is_some()) {
                (Some(value), false) => write!(text, "/{value}"),
                (Some(value), true) => write!(text, "/{value}/{vertex}"),
                (None, true) => write!(text, "//{vertex}"),
                (None, false) => Ok(()),
            }
            .expect("memory");
        }
        text.push('\n');
    }
    write_tags(mesh, &mut text);
    Ok(text)
}

/// Tags as OpenSubdiv's shapes have them.
fn write_tags(mesh: &PolygonMesh<RealCyclotomic>, text: &mut String) {
    let tags = mesh.tags();
    let number = |sharp: &Sharpness| shortest(nearest(&sharp.number()));
    for (&edge, sharp) in tags.edges() {
        let [a, b] = mesh.connectivity().edges()[edge].ends;
        writeln!(text, "t crease 2/1/0 {a} {b} {}", number(sharp)).expect("memory");
    }
    for (vertex, sharp) in tags.vertices() {
        writeln!(text, "t corner 1/1/0 {vertex} {}", number(sharp)).expect("memory");
    }
    for hole in tags.holes(mesh.connectivity()) {
        writeln!(text, "t hole 1/0/0 {hole}").expect("memory");
    }
    if !tags.is_plain() {
        let boundary = match tags.boundary {
            Boundary::None => 0,
            Boundary::Corner => 1,
            Boundary::Edge => 2,
        };
        writeln!(text, "t interpolateboundary 1/0/0 {boundary}").expect("memory");
    }
    if tags.creasing == Creasing::Chaikin {
        text.push_str("t creasemethod 0/0/1 chaikin\n");
    }
}
