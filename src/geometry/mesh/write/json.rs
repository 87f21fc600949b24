//! JSON.

use super::super::limit::LimitPoint;
use super::super::point::Point;
use super::super::polygon::PolygonMesh;
use crate::exact::{Enclosed, RealCyclotomic};
use crate::float::{nearest, shortest};
use std::fmt::Write as _;

/// A mesh as JSON, with a line for each point and each face.
///
/// The fields of `head` come first, each with its name and its value in JSON. The field `points`
/// has for each point `exact` (p/q, or a sum of cosines) and `f64` (the nearest f64, as the
/// shortest decimal that reads back). The field `faces` has the vertices of each face by number,
/// from 0 on. With `limits`, the field `limits` has for each point its `position` and its `normal`, or
/// `null` where there is none. A normal is exact, of any length, with the nearest f64 of the unit
/// vector. Numbers are texts, but for vertices.
///
/// # Panics
/// Never: writing to memory does not fail.
///
/// ```
/// use subcert::exact::RealCyclotomic;
/// use subcert::mesh::{PolygonMesh, to_json};
///
/// let points = [[0, 0, 0], [1, 0, 0], [0, 1, 0]].map(|point| point.map(RealCyclotomic::from));
/// let mesh = PolygonMesh::new(points.to_vec(), vec![vec![0, 1, 2]])?;
/// let text = to_json(&mesh, &[("level", "0".to_owned())], None);
/// assert!(text.starts_with("{\n  \"level\": 0,\n  \"points\": [\n    {\"exact\": [\"0\", "));
/// # Ok::<(), subcert::mesh::MeshError>(())
/// ```
#[must_use]
pub fn to_json(
    mesh: &PolygonMesh<RealCyclotomic>,
    head: &[(&str, String)],
    limits: Option<&[Option<LimitPoint>]>,
) -> String {
    let mut text = "{\n".to_owned();
    for (name, value) in head {
        writeln!(text, "  \"{name}\": {value},").expect("memory");
    }
    list(&mut text, "points", mesh.points().iter().map(numbers), false);
    let faces = mesh.faces().iter().map(|face| format!("{face:?}"));
    list(&mut text, "faces", faces, limits.is_none());
    if let Some(limits) = limits {
        list(&mut text, "limits", limits.iter().map(|one| limit(one.as_ref())), true);
    }
    text.push_str("}\n");
    text
}

/// A list of a form in JSON, with a line for each item.
pub(crate) fn list(text: &mut String, name: &str, items: impl Iterator<Item = String>, last: bool) {
    write!(text, "  \"{name}\": [").expect("memory");
    let mut separator = "\n";
    for item in items {
        write!(text, "{separator}    {item}").expect("memory");
        separator = ",\n";
    }
    text.push_str(if last { "\n  ]\n" } else { "\n  ],\n" });
}

/// Numbers as JSON texts. They have no character that needs an escape.
fn texts(numbers: &[String; 3]) -> String {
    let [x, y, z] = numbers;
    format!("[\"{x}\", \"{y}\", \"{z}\"]")
}

/// A point, exactly and to f64.
pub(crate) fn numbers<S: Enclosed + ToString>(point: &Point<S>) -> String {
    let exact = texts(&point.each_ref().map(S::to_string));
    let near = texts(&point.each_ref().map(|x| shortest(nearest(x))));
    format!("{{\"exact\": {exact}, \"f64\": {near}}}")
}

fn limit(limit: Option<&LimitPoint>) -> String {
    let Some(limit) = limit else { return "null".to_owned() };
    let normal = limit.normal.as_ref().map_or_else(
        || "null".to_owned(),
        |normal| {
            let unit = texts(&normal.unit().map(shortest));
            format!("{{\"exact\": {}, \"unit_f64\": {unit}}}", texts(&normal.exact()))
        },
    );
    format!("{{\"position\": {}, \"normal\": {normal}}}", numbers(&limit.position))
}
