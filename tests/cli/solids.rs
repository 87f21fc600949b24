//! `refine`, `limit`, `oracle` and `depth` of hexahedral solids.

use super::{TemporaryFile, assert_parts, refused, written};

const STAR: [&str; 2] = ["--mesh", "examples/star.vtk"];
const BRACKET: [&str; 2] = ["--mesh", "examples/bracket.mesh"];

fn with<'a>(arguments: &[&'a str], mesh: [&'a str; 2]) -> Vec<&'a str> {
    arguments.iter().copied().chain(mesh).collect()
}

#[test]
fn solids_are_refined_from_form_to_form() {
    let file = TemporaryFile::new("refined.mesh", "");
    let said = written(with(&["refine", "bajaj", "-o", file.path()], STAR));
    assert!(said.is_empty(), "{said}");
    let again = written(["refine", "bajaj", "--level", "0", "--mesh", file.path()]);
    assert_parts(&again, &["# vtk DataFile Version 3.0\n", "CELLS 48 432\n", "CELL_TYPES 48\n"]);
    let text = written(with(&["refine", "bajaj", "--format", "json"], BRACKET));
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!((json["scheme"].as_str(), json["level"].as_u64()), (Some("bajaj"), Some(1)));
    assert_eq!(json["cells"].as_array().expect("cells").len(), 80);
    // The corner at the origin, with neighbours at 0.3, 0.5 and 0.25: a sixth of each.
    assert_eq!(json["points"][0]["exact"], serde_json::json!(["1/20", "1/12", "1/24"]));
    let text = written(with(&["oracle", "bajaj", "--level", "0"], BRACKET));
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(json["limits"][0]["exact"], serde_json::json!(["1/15", "1/9", "1/18"]));
    let text = written(with(&["limit", "bajaj", "--format", "medit"], BRACKET));
    assert_parts(
        &text,
        &["\nVertices\n36\n0.06666666666666667 0.1111111111111111 0.05555555555555555 0\n"],
    );
}

#[test]
fn the_depth_of_a_solid() {
    let by_parameter = ["depth", "bajaj", "--distance", "parametric", "--tolerance", "1/20"];
    let asked = |more: [&str; 2]| written(with(&[&by_parameter[..], &more].concat(), STAR));
    let text = asked(["--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!((json["level"].as_u64(), json["too_few"].as_u64()), (Some(2), Some(1)), "{json}");
    assert_eq!(json["formula"]["paper"], "mustafa2007-bajaj");
    assert_eq!(json["formula"]["verdict"], "more than needed");
    assert!(json["hausdorff"].is_null() && json["worst_face"]["level_face"].is_null());
    assert!(json["worst_face"]["face"].as_u64().expect("a cell") < 6);
    let bound = |name: &str| -> f64 {
        json["distance"][name].as_str().expect("a text").parse().expect("a number")
    };
    assert!(bound("lower") > 0.02 && bound("upper") <= 0.05 && bound("lower") <= bound("upper"));
    let csv = TemporaryFile::new("cells.csv", "");
    let vtk = TemporaryFile::new("cells.vtk", "");
    for path in [csv.path(), vtk.path()] {
        asked(["--per-face", path]);
    }
    let rows = std::fs::read_to_string(csv.path()).expect("a file");
    assert!(
        rows.starts_with("cell,level,lower,upper\n0,2,") && rows.lines().count() == 7,
        "{rows}"
    );
    let cells = std::fs::read_to_string(vtk.path()).expect("a file");
    assert_parts(&cells, &["\nCELL_DATA 6\nSCALARS distance double 1\nLOOKUP_TABLE default\n"]);
    // It is a solid still.
    written(["refine", "bajaj", "--level", "0", "--mesh", vtk.path()]);
}

/// Without a flag the boundary is measured, as a set of points; faces are those of the cells of the file.
#[test]
fn the_depth_of_the_boundary_of_a_solid() {
    let text = written(with(&["depth", "bajaj", "--tolerance", "1/20", "--format", "json"], STAR));
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!((json["level"].as_u64(), json["too_few"].as_u64()), (Some(2), Some(1)), "{json}");
    assert_eq!(
        (json["measure"].as_str(), json["scheme"].as_str()),
        (Some("hausdorff"), Some("bajaj"))
    );
    let number = |name: &str| json["too_far"][name].as_u64().expect("a number");
    assert!(number("solid_cell") < 6 && number("vertex") < 21 && number("face") < 20, "{json}");
    let rows = TemporaryFile::new("faces.csv", "");
    let asked = ["depth", "bajaj", "--tolerance", "1/20", "--per-face", rows.path()];
    assert_parts(&written(with(&asked, STAR)), &["depth of the boundary", "(of cell "]);
    let rows = std::fs::read_to_string(rows.path()).expect("a file");
    assert!(rows.starts_with("face,vertices,level,lower,upper,own_level,is_least\n0,4,2,"));
}

#[test]
fn what_is_no_solid_is_refused() {
    let cases: [(Vec<&str>, &[&str]); 9] = [
        (
            with(&["refine", "bajaj"], ["--mesh", "examples/cube.obj"]),
            &["is not a solid", "catmull-clark"],
        ),
        (
            with(&["refine", "catmull-clark"], STAR),
            &["a cell of type 12, a hexahedron", "by the scheme bajaj"],
        ),
        (with(&["depth", "loop", "--tolerance", "1"], STAR), &["a hexahedron"]),
        (
            with(&["refine", "bajaj", "--format", "obj"], STAR),
            &["solids are written as vtk, medit or json"],
        ),
        (
            with(&["refine", "bajaj", "-o", "solid.ply"], STAR),
            &["name a file that ends in .json, .vtk or .mesh"],
        ),
        (
            with(&["refine", "catmull-clark", "--format", "vtk"], ["--mesh", "examples/cube.obj"]),
            &["polygon meshes are written as obj, off, ply, stl, usda or json"],
        ),
        (with(&["refine", "bajaj", "--level", "13"], STAR), &["level 13 is too high; at most 12"]),
        (with(&["refine", "bajaj", "--level", "9"], STAR), &["at most 1000000", "a lower level"]),
        (
            with(&["depth", "bajaj", "--tolerance", "1", "--per-face", "x.vtk"], STAR),
            &["writes .csv, .json or .ply", ".vtk with --distance parametric"],
        ),
    ];
    for (arguments, parts) in cases {
        assert_parts(&refused(arguments), parts);
    }
    assert_parts(&refused(with(&["refine", "bajaj:N=4"], STAR)), &["write `bajaj`"]);
    assert_parts(&refused(with(&["depth", "bajaj", "--tolerance", "0"], STAR)), &["--tolerance"]);
    let text = std::fs::read_to_string("examples/star.vtk").expect("the example");
    let file = TemporaryFile::new("broken.vtk", &text.replacen("8 0 1 2 3 7", "8 0 1 2 2 7", 1));
    assert_parts(
        &refused(["depth", "bajaj", "--tolerance", "1", "--mesh", file.path()]),
        &["broken.vtk:28:1", "a degenerate cell: it has the corner 2 twice", "eight different"],
    );
}
