//! JSON.

use super::super::limit::{LimitPoint, NoNormal, Normal, Sector};
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
/// `null` where there is none, as of isolated points, which come last; `no_normal` says why ([`NoNormal::name`](crate::mesh::NoNormal::name)); at a crease, a corner or the boundary also its `sectors`, with the two
/// tangents of each. A mesh with texture coordinates, creases, corners or holes has fields of these. A normal is exact, of any length, with the nearest f64 of the unit
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
    let points = mesh.points().iter().chain(mesh.isolated());
    list(&mut text, "points", points.map(numbers), false);
    let faces = mesh.faces().iter().map(|face| format!("{face:?}"));
    list(&mut text, "faces", faces, limits.is_none() && plain(mesh));
    tags(mesh, &mut text, limits.is_none());
    if let Some(limits) = limits {
        let isolated = mesh.isolated().iter().map(|_| limit(None));
        let limits = limits.iter().map(|one| limit(one.as_ref()));
        list(&mut text, "limits", limits.chain(isolated), true);
    }
    text.push_str("}\n");
    text
}

/// Whether there are no tags and no texture coordinates.
fn plain(mesh: &PolygonMesh<RealCyclotomic>) -> bool {
    mesh.tags().is_plain() && mesh.texture().is_none()
}

/// Texture coordinates, creases, corners, holes and the rules, if there are any.
fn tags(mesh: &PolygonMesh<RealCyclotomic>, text: &mut String, last: bool) {
    if let Some(texture) = mesh.texture() {
        let values = texture.values.iter().map(|value| {
            let numbers: Vec<String> = value.iter().map(|x| format!("\"{x}\"")).collect();
            format!("[{}]", numbers.join(", "))
        });
        list(text, "texture", values, false);
        let faces = texture.faces.iter().map(|face| format!("{face:?}"));
        list(text, "texture_faces", faces, last && mesh.tags().is_plain());
    }
    let tags = mesh.tags();
    if tags.is_plain() {
        return;
    }
    writeln!(text, "  \"boundary\": \"{}\",", tags.boundary.name()).expect("memory");
    writeln!(text, "  \"creasing\": \"{}\",", tags.creasing.name()).expect("memory");
    let edges = tags.edges().iter().map(|(&edge, sharp)| {
        let [a, b] = mesh.connectivity().edges()[edge].ends;
        format!("{{\"vertices\": [{a}, {b}], \"sharpness\": \"{sharp}\"}}")
    });
    list(text, "creases", edges, false);
    let corners = tags.vertices().iter();
    let corners = corners
        .map(|(vertex, sharp)| format!("{{\"vertex\": {vertex}, \"sharpness\": \"{sharp}\"}}"));
    list(text, "corners", corners, false);
    let holes = tags.holes(mesh.connectivity()).into_iter().map(|hole| hole.to_string());
    list(text, "holes", holes, last);
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
    let sectors: Vec<String> = limit.sectors.iter().map(sector).collect();
    let sectors = match sectors.len() {
        0 => String::new(),
        _ => format!(", \"sectors\": [{}]", sectors.join(", ")),
    };
    let (position, normal) = (numbers(&limit.position), normal(limit.normal.as_ref()));
    format!("{{\"position\": {position}, {normal}{sectors}}}")
}

fn normal(normal: Result<&Normal, &NoNormal>) -> String {
    match normal {
        Ok(normal) => {
            let unit = texts(&normal.unit().map(shortest));
            let exact = texts(&normal.exact());
            format!("\"normal\": {{\"exact\": {exact}, \"unit_f64\": {unit}}}")
        }
        Err(reason) => format!("\"normal\": null, \"no_normal\": \"{}\"", reason.name()),
    }
}

fn sector(sector: &Sector) -> String {
    let tangents = sector.tangents.as_ref().map_or("null".to_owned(), |tangents| {
        let [first, second] = tangents.exact().map(|one| texts(&one));
        format!("[{first}, {second}]")
    });
    let normal = normal(sector.normal().as_ref());
    format!("{{\"faces\": {:?}, \"tangents\": {tangents}, {normal}}}", sector.faces)
}
