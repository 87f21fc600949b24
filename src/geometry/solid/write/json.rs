//! JSON.

use super::super::hexes::HexMesh;
use crate::exact::Rational;
use crate::mesh::{Point, list, numbers};
use std::fmt::Write as _;

/// A solid as JSON, with a line for each point and each cell.
///
/// `head` is the fields that come first, each as its name and its value in JSON. Then come
/// `points`, each of `exact` (p/q) and `f64` (the nearest one, as the shortest decimal that reads
/// back); `cells`, with corners counted from 0, in the order of VTK; and with `limits` the limit
/// point of each point. Numbers are texts, but for corners.
///
/// # Panics
/// Never: writing to memory does not fail.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::solid::{HexMesh, solid_to_json};
///
/// let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(Rational::from);
/// let mesh = HexMesh::new((0..8).map(corner).collect(), &[[0, 1, 3, 2, 4, 5, 7, 6]])?;
/// let text = solid_to_json(&mesh, &[("level", "0".to_owned())], None);
/// assert!(text.ends_with("  \"cells\": [\n    [0, 1, 3, 2, 4, 5, 7, 6]\n  ]\n}\n"));
/// # Ok::<(), subcert::solid::SolidError>(())
/// ```
#[must_use]
pub fn solid_to_json(
    mesh: &HexMesh<Rational>,
    head: &[(&str, String)],
    limits: Option<&[Point<Rational>]>,
) -> String {
    let mut text = "{\n".to_owned();
    for (name, value) in head {
        writeln!(text, "  \"{name}\": {value},").expect("memory");
    }
    list(&mut text, "points", mesh.points().iter().map(numbers), false);
    let cells = mesh.cells().into_iter().map(|cell| format!("{cell:?}"));
    list(&mut text, "cells", cells, limits.is_none());
    if let Some(limits) = limits {
        list(&mut text, "limits", limits.iter().map(numbers), true);
    }
    text.push_str("}\n");
    text
}
