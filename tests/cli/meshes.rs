//! `refine`, `limit` and `oracle --mesh`.

use super::{TemporaryFile, assert_parts, refused, written};

const CUBE: [&str; 2] = ["--mesh", "examples/cube.obj"];

fn of_cube<'a>(arguments: &[&'a str]) -> Vec<&'a str> {
    arguments.iter().copied().chain(CUBE).collect()
}

#[test]
fn a_mesh_is_refined_into_a_file_or_the_standard_output() {
    let text = written(of_cube(&["refine", "catmull-clark"]));
    assert!(
        text.starts_with("# examples/cube.obj, catmull-clark, level 1: refined\nv -0.555"),
        "{text}"
    );
    assert_eq!(text.lines().filter(|line| line.starts_with("f ")).count(), 24);
    let file = TemporaryFile::new("refined.ply", "");
    let said = written(of_cube(&["refine", "catmull-clark", "--level", "2", "-o", file.path()]));
    assert!(said.is_empty(), "{said}");
    let saved = std::fs::read_to_string(file.path()).expect("the file");
    assert!(saved.starts_with("ply\n") && saved.contains("element face 96\n"), "{saved}");
    let again = written(["refine", "doo-sabin", "--mesh", file.path(), "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&again).expect("JSON");
    assert_eq!(json["level"], 1);
    assert_eq!(json["points"].as_array().expect("points").len(), 384);
}

#[test]
fn limits_and_reference_values() {
    let text = written(of_cube(&["limit", "catmull-clark"]));
    assert!(text.contains("\nv -0.5 -0.5 -0.5\nv 0.5 -0.5 -0.5\n"), "{text}");
    let text = written(of_cube(&["oracle", "catmull-clark", "--level", "1"]));
    let json: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(json["schema"], 1);
    assert_eq!(json["scheme"], "catmull-clark");
    assert_eq!(json["points"][0]["exact"][0], "-5/9");
    assert_eq!(json["faces"].as_array().expect("faces").len(), 24);
    assert_eq!(json["limits"][0]["position"]["f64"][0], "-0.5");
    // √((1 + c)(9 + c)) for c = cos(2π/3).
    let normal = &json["limits"][0]["normal"];
    let exact = normal["exact"][0].as_str().expect("a text");
    assert!(exact.ends_with(")*sqrt(17/4)"), "{exact}");
    assert_eq!(normal["unit_f64"][0], "-0.5773502691896257");
}

#[test]
fn what_cannot_be_refined() {
    let cases: [(&[&str], &[&str]); 7] = [
        (&["refine", "catmul-clark"], &["no scheme for meshes", "did you mean `catmull-clark`?"]),
        (&["refine", "doo-sabin:n=4"], &["a mesh has its own valences: write `doo-sabin`"]),
        (&["refine", "loop"], &["examples/cube.obj:10:1", "a face of 4 vertices", "split"]),
        (&["refine", "catmull-clark", "--level", "25"], &["level 25 is too high; at most 24"]),
        (
            &["refine", "catmull-clark", "--level", "24"],
            &["at most 1000000 are worked on", "lower level"],
        ),
        (&["oracle", "catmull-clark", "--format", "csv"], &["--mesh writes JSON only"]),
        (&["oracle", "catmull-clark", "--points", "4"], &["cannot be used with"]),
    ];
    for (arguments, parts) in cases {
        assert_parts(&refused(of_cube(arguments)), parts);
    }
    assert_parts(
        &refused(["limit", "loop", "--mesh", "nowhere.obj"]),
        &["cannot read `nowhere.obj`"],
    );
    let square =
        TemporaryFile::new("square.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    let message = refused(["limit", "doo-sabin", "--mesh", square.path()]);
    assert_parts(&message, &["4 vertices at the boundary have no limit point", "--format json"]);
}

/// A file that is refused leaves what was there.
#[test]
fn nothing_is_half_written() {
    let output = TemporaryFile::new("kept.obj", "kept");
    let mesh = TemporaryFile::new("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 9\n");
    let message = refused(["refine", "loop", "--mesh", mesh.path(), "-o", output.path()]);
    assert_parts(&message, &["broken.obj:5:1", "point 9 does not exist"]);
    assert_eq!(std::fs::read_to_string(output.path()).expect("the file"), "kept");
}
