//! USD, ascii.

use super::super::crease::{Boundary, Sharpness};
use super::super::polygon::PolygonMesh;
use super::super::scheme::MeshScheme;
use super::{BeyondF64, decimals, one_line};
use crate::exact::RealCyclotomic;
use crate::float::{nearest, shortest};
use std::fmt::Write as _;

/// A mesh as `.usda`, with its creases, corners, holes and texture coordinates: the nearest f64 of each
/// number, as the shortest decimal that reads back.
///
/// # Errors
/// When a coordinate is beyond the greatest f64.
///
/// # Panics
/// Never: writing to memory does not fail.
///
/// ```
/// use subcert::exact::RealCyclotomic;
/// use subcert::mesh::{MeshScheme, PolygonMesh, to_usda};
///
/// let points = [[0, 0, 0], [1, 0, 0], [0, 1, 0]].map(|point| point.map(RealCyclotomic::from));
/// let mesh = PolygonMesh::new(points.to_vec(), vec![vec![0, 1, 2]])?;
/// let text = to_usda(&mesh, MeshScheme::Loop, "a triangle")?;
/// assert!(text.contains("int[] faceVertexIndices = [0, 1, 2]\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_usda(
    mesh: &PolygonMesh<RealCyclotomic>,
    scheme: MeshScheme,
    title: &str,
) -> Result<String, BeyondF64> {
    let mut text = format!("#usda 1.0\n# {}\n(\n    defaultPrim = \"mesh\"\n)\n", one_line(title));
    text.push_str("\ndef Mesh \"mesh\"\n{\n");
    let mut put = |kind: &str, name: &str, value: &str| {
        writeln!(text, "    {kind} {name} = {value}").expect("memory");
    };
    let list = |all: Vec<String>| format!("[{}]", all.join(", "));
    let points: Result<Vec<String>, _> = mesh
        .points()
        .iter()
        .chain(mesh.isolated())
        .map(|point| decimals(point).map(|point| format!("({})", point.join(", "))))
        .collect();
    let faces = mesh.faces().iter();
    put("point3f[]", "points", &list(points?));
    put(
        "int[]",
        "faceVertexCounts",
        &list(faces.clone().map(|face| face.len().to_string()).collect()),
    );
    put("int[]", "faceVertexIndices", &list(faces.flatten().map(usize::to_string).collect()));
    let tags = mesh.tags();
    let number = |sharp: &Sharpness| shortest(nearest(&sharp.number()));
    if !tags.edges().is_empty() {
        let ends = tags.edges().keys().flat_map(|edge| mesh.connectivity().edges()[*edge].ends);
        put("int[]", "creaseIndices", &list(ends.map(|end| end.to_string()).collect()));
        put("int[]", "creaseLengths", &list(vec!["2".to_owned(); tags.edges().len()]));
        put("float[]", "creaseSharpnesses", &list(tags.edges().values().map(number).collect()));
    }
    if !tags.vertices().is_empty() {
        let corners = tags.vertices().keys().map(usize::to_string).collect();
        put("int[]", "cornerIndices", &list(corners));
        put("float[]", "cornerSharpnesses", &list(tags.vertices().values().map(number).collect()));
    }
    let holes = tags.holes(mesh.connectivity());
    if !holes.is_empty() {
        put("int[]", "holeIndices", &list(holes.iter().map(usize::to_string).collect()));
    }
    let boundary = match tags.boundary {
        Boundary::None => "\"none\"",
        Boundary::Edge => "\"edgeOnly\"",
        Boundary::Corner => "\"edgeAndCorner\"",
    };
    put("uniform token", "interpolateBoundary", boundary);
    let scheme = match scheme {
        MeshScheme::CatmullClark => "\"catmullClark\"",
        MeshScheme::Loop | MeshScheme::LoopWarren => "\"loop\"",
        MeshScheme::DooSabin | MeshScheme::Bajaj => "\"none\"",
    };
    put("uniform token", "subdivisionScheme", scheme);
    if let Some(texture) = mesh.texture() {
        let value = |value: &Vec<crate::exact::Rational>| {
            let two: Vec<String> = value[..2].iter().map(|x| shortest(nearest(x))).collect();
            format!("({})", two.join(", "))
        };
        let values = list(texture.values.iter().map(value).collect());
        if values.contains("inf") {
            return Err(BeyondF64);
        }
        let about = format!("{values} (\n        interpolation = \"faceVarying\"\n    )");
        put("texCoord2f[]", "primvars:st", &about);
        let indices = texture.faces.iter().flatten().map(usize::to_string).collect();
        put("int[]", "primvars:st:indices", &list(indices));
    }
    text.push_str("}\n");
    Ok(text)
}
