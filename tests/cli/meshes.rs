//! `refine`, `limit` and `oracle --mesh`.

use super::{TemporaryFile, assert_parts, refused, subcert, written};
use std::fmt::Write as _;

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
fn a_search_may_have_an_end_of_its_time() {
    let depth = of_cube(&["depth", "catmull-clark", "--tolerance", "1/10"]);
    let timed = |seconds| depth.iter().copied().chain(["--seconds", seconds]);
    assert_eq!(written(timed("600")), written(depth.iter().copied()));
    assert_parts(&refused(timed("0")), &["--seconds"]);
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
    let cases: [(&[&str], &[&str]); 8] = [
        (&["refine", "catmul-clark"], &["no scheme for meshes", "did you mean `catmull-clark`?"]),
        (&["refine", "doo-sabin:n=4"], &["a mesh has its own valences: write `doo-sabin`"]),
        (&["refine", "loop"], &["examples/cube.obj:10:1", "a face of 4 vertices", "split"]),
        (&["refine", "catmull-clark", "--level", "25"], &["level 25 is too high; at most 24"]),
        (
            &["refine", "catmull-clark", "--level", "24"],
            &["at most 1000000 are worked on", "lower level"],
        ),
        (&["oracle", "catmull-clark", "--format", "matlab"], &["json, csv, table, c or rust"]),
        (
            &["oracle", "catmull-clark", "--boundary", "open"],
            &["--polygon", "none, edge and corner"],
        ),
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

/// Two creases end in the middle of a grid of nine squares. No normal is NaN, and none vanishes.
#[test]
fn what_has_no_normal_is_told() {
    let mut grid = String::new();
    for i in 0..16 {
        let _ = writeln!(grid, "v {} {} 0", i % 4, i / 4);
    }
    for i in [1, 2, 3, 5, 6, 7, 9, 10, 11] {
        let _ = writeln!(grid, "f {i} {} {} {}", i + 1, i + 5, i + 4);
    }
    let file = TemporaryFile::new("dart.obj", &(grid + "t crease 2/1/0 5 6 10\n"));
    let of = |arguments: &[&str]| {
        let asked = ["catmull-clark", "--level", "0", "--mesh", file.path()];
        subcert(arguments[..1].iter().chain(&asked).chain(&arguments[1..]).copied())
    };
    let told = "2 of 16 vertices have no normal: 2 where a crease ends";
    let output = |arguments: &[&str]| {
        let output = of(arguments).assert().success().get_output().clone();
        assert!(String::from_utf8_lossy(&output.stderr).contains(told), "{arguments:?}");
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(!text.to_lowercase().contains("nan"), "{text}");
        text
    };
    assert!(output(&["limit"]).contains(&format!("# no vn: {told}\n")));
    for command in ["limit", "oracle"] {
        let found = json(&output(&[command, "--format", "json"]));
        assert_eq!(found["notes"][0], told);
        assert_eq!(found["limits"][5]["normal"], serde_json::Value::Null);
        assert_eq!(found["limits"][5]["no_normal"], "crease end");
        assert_eq!(found["limits"][0]["normal"]["unit_f64"][2], "1.0");
        assert_eq!(found["boundary"], "edge");
    }
    let table = output(&["oracle", "--format", "csv"]);
    assert_parts(&table, &[&format!("# normals: {told}\n"), "# boundary: \"edge\"\n"]);
    let rows: Vec<&str> = table.lines().filter(|line| !line.starts_with('#')).collect();
    assert_eq!(rows.len(), 17);
    assert!(rows[1].starts_with("0,0.0,0.0,0.0,") && rows[1].ends_with(",0.0,0.0,1.0,"), "{table}");
    assert!(
        rows[6].starts_with("5,1.0,1.0,0.0,") && rows[6].ends_with(",,,,crease end"),
        "{table}"
    );
    assert_eq!(output(&["oracle", "--format", "table"]), rows.join("\n") + "\n");
    for (format, count) in [("c", "normals[14][3]"), ("rust", "NORMALS: [[f64; 3]; 14]")] {
        let source = output(&["oracle", "--format", format]);
        assert_parts(
            &source,
            &[&format!("// normals: {told}\n"), count, "// boundary: \"edge\"\n"],
        );
    }
    // The rule at the boundary decides where its vertices go.
    let corner = output(&["oracle", "--boundary", "corner", "--format", "csv"]);
    assert!(corner.contains("\n0,0.0,0.0,0.0,0.0,0.0,0.0,"), "{corner}");
    assert!(
        corner.contains("# boundary: \"corner\"\n") && !table.contains("\n0,0.0,0.0,0.0,0.0,0.0,")
    );
    let square =
        TemporaryFile::new("lone.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    let asked = ["oracle", "doo-sabin", "--level", "0", "--format", "table", "--mesh"];
    let none = written(asked.into_iter().chain([square.path()]));
    assert_eq!(none.lines().nth(1), Some("0,0.0,0.0,0.0,,,,,,,no limit"));
}

/// Each form is read again, and STL splits quadrilaterals.
#[test]
fn off_and_stl_are_written() {
    let refined = json(&written(of_cube(&["refine", "catmull-clark", "--format", "json"])));
    for (name, faces) in [("cube.off", 24), ("cube.stl", 48)] {
        let file = TemporaryFile::new(name, "");
        let output = subcert(of_cube(&["refine", "catmull-clark", "-o", file.path()]));
        let output = output.assert().success().get_output().clone();
        let noted = String::from_utf8_lossy(&output.stderr).contains("24 faces of more than 3");
        assert_eq!(noted, name == "cube.stl");
        let again = ["refine", "catmull-clark", "--level", "0", "--format", "json", "--mesh"];
        let again = json(&written(again.into_iter().chain([file.path()])));
        assert_eq!(again["faces"].as_array().map(Vec::len), Some(faces));
        let near = |mesh: &serde_json::Value| {
            let points = mesh["points"].as_array().expect("points").iter();
            let mut points: Vec<String> = points.map(|point| point["f64"].to_string()).collect();
            points.sort();
            points
        };
        assert_eq!(near(&again), near(&refined));
        let vase = ["limit", "bicubic", "--mesh", "examples/vase.json", "-o", file.path()];
        assert!(written(vase).is_empty());
    }
}

/// What is 0 and was computed in f64 is printed as 0.
#[test]
fn points_of_a_depth_have_no_rounding_errors() {
    let octahedron = "v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n\
                      f 2 1 6\nf 3 2 6\nf 4 3 6\nf 1 4 6\n";
    let file = TemporaryFile::new("octahedron.obj", octahedron);
    for distance in ["geometric", "parametric"] {
        for format in ["text", "json"] {
            let asked = ["depth", "catmull-clark", "--tolerance", "1/10", "--distance", distance];
            let text =
                written(asked.into_iter().chain(["--format", format, "--mesh", file.path()]));
            assert!(!text.contains("e-1") && !text.contains("-0.0\""), "{text}");
        }
    }
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

fn json(text: &str) -> serde_json::Value {
    serde_json::from_str(text).expect("JSON")
}

#[test]
fn the_depth_of_a_mesh() {
    let depth = ["depth", "catmull-clark", "--tolerance", "1/100", "--distance", "parametric"];
    let text = written(of_cube(&depth));
    assert_parts(
        &text,
        &["4 levels, at equal parameters; 3 are too few", "a priori", "too far at level 3"],
    );
    let form = json(&written(of_cube(&[&depth[..], &["--format", "json"]].concat())));
    assert_eq!((&form["level"], &form["too_few"]), (&4.into(), &3.into()));
    assert_eq!(form["formula"], serde_json::Value::Null);
    let number = |value: &serde_json::Value| -> f64 {
        value.as_str().expect("a text").parse().expect("a number")
    };
    let [lower, upper] = ["lower", "upper"].map(|end| number(&form["distance"][end]));
    assert!(0.0 < lower && lower <= upper && upper <= 0.01, "{form}");
    assert!(number(&form["a_priori"]["ratio"]) < 1.0);
    let form = json(&written(of_cube(&[
        "depth",
        "doo-sabin",
        "--tolerance",
        "1/100",
        "--format",
        "json",
        "--a-priori",
    ])));
    assert_eq!(form["level"], serde_json::Value::Null);
    assert_eq!(form["formula"]["paper"], "khan2022-doo-sabin");
    assert!(form["a_priori"]["level"].as_u64() > Some(4), "{form}");
}

#[test]
fn the_distance_of_every_face() {
    let depth =
        ["depth", "catmull-clark", "--tolerance", "1/10", "--distance", "parametric", "--per-face"];
    let table = TemporaryFile::new("faces.csv", "");
    written(of_cube(&[&depth[..], &[table.path()]].concat()));
    let text = std::fs::read_to_string(table.path()).expect("the file");
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!((lines.len(), lines[0]), (7, "face,vertices,level,lower,upper"));
    for (face, line) in lines[1..].iter().enumerate() {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!((cells[0], cells[1], cells[2]), (&face.to_string()[..], "4", "2"));
        let [lower, upper]: [f64; 2] = [3, 4].map(|i| cells[i].parse().expect("a number"));
        // All faces of the cube are alike.
        assert!(0.0476 < lower * 1.06 && lower <= upper && upper < 0.0505, "{line}");
    }
    let colours = TemporaryFile::new("faces.ply", "");
    written(of_cube(&[&depth[..], &[colours.path()]].concat()));
    let text = std::fs::read_to_string(colours.path()).expect("the file");
    assert_eq!(text.matches("property uchar red\n").count(), 2);
    assert_eq!(text.lines().filter(|line| line.contains(" 255 0 0 0.0")).count(), 14, "{text}");
    // What is written reads back.
    written(["depth", "catmull-clark", "--tolerance", "1", "--mesh", colours.path()]);
}

#[test]
fn the_depth_as_the_eye_sees_it() {
    let depth = ["depth", "doo-sabin", "--tolerance", "1/80"];
    let text = written(of_cube(&depth));
    assert_parts(&text, &["Hausdorff", "quadrilaterals bilinear", "too far at level"]);
    let form = json(&written(of_cube(&[&depth[..], &["--format", "json"]].concat())));
    let parametric = [&depth[..], &["--distance", "parametric", "--format", "json"]].concat();
    let parametric = json(&written(of_cube(&parametric)));
    assert_eq!(
        (&form["measure"], &parametric["measure"]),
        (&"hausdorff".into(), &"parametric".into())
    );
    let level = |form: &serde_json::Value| form["level"].as_u64().expect("a level");
    assert!(level(&form) < level(&parametric), "{form}");
    assert_eq!(form["too_few"].as_u64(), Some(level(&form) - 1));
    // The diagonal of the cube is 2√3.
    let relative = [&depth[..3], &["1/277", "--relative", "--format", "json"]].concat();
    assert_eq!(level(&json(&written(of_cube(&relative)))), level(&form));
    let tiny = [&depth[..3], &["1e-60", "--distance", "geometric", "--mesh", "examples/cube.obj"]]
        .concat();
    assert_parts(&refused(tiny), &["2^-20 of the diagonal", "compare at equal parameters"]);
    // Without a flag such a tolerance is answered by equal parameters.
    let small = [&depth[..3], &["1e-9", "--format", "json"]].concat();
    assert_eq!(json(&written(of_cube(&small)))["measure"], "parametric");
    let table = TemporaryFile::new("own.csv", "");
    let text = written(of_cube(&[&depth[..], &["--per-face", table.path()]].concat()));
    assert_parts(&text, &["adaptive refinement"]);
    let text = std::fs::read_to_string(table.path()).expect("the file");
    assert!(text.starts_with("face,vertices,level,lower,upper,own_level,is_least\n"), "{text}");
    assert_parts(&refused(["depth", "chaikin", "--tolerance", "1", "--relative"]), &["--relative"]);
}

/// Halves of a tolerance may be too small for sets of points when it is not.
#[test]
fn faces_at_a_tolerance_near_the_least_one() {
    let table = TemporaryFile::new("near.csv", "");
    let depth = ["depth", "catmull-clark", "--tolerance", "1/200000", "--per-face", table.path()];
    written(of_cube(&depth));
    let text = std::fs::read_to_string(table.path()).expect("the file");
    assert_eq!(text.lines().count(), 7);
}

#[test]
fn holes_and_boundaries_of_a_depth() {
    let grid = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 1\nv 2 1 0\nv 0 2 0\nv 1 2 0\nv 2 2 0\n\
                f 1 2 5 4\nf 2 3 6 5\nf 4 5 8 7\nf 5 6 9 8\n";
    let mesh = TemporaryFile::new("grid.obj", grid);
    let holed = TemporaryFile::new("hole.obj", &format!("{grid}t hole 1/0/0 2\n"));
    let table = TemporaryFile::new("grid.csv", "");
    let depth = |path: &str, more: &[&str]| {
        let form = ["--tolerance", "1/100", "--format", "json", "--mesh"];
        let form = [&["depth", "catmull-clark"], &form[..], &[path], more].concat();
        json(&written([&form[..], &["--per-face", table.path()]].concat()))
    };
    let rows = || std::fs::read_to_string(table.path()).expect("the file").lines().count() - 1;
    let whole = depth(mesh.path(), &[]);
    assert_eq!(rows(), 4);
    let with_hole = depth(holed.path(), &[]);
    assert_eq!(rows(), 3);
    let faces = |form: &serde_json::Value| {
        let text = form["adaptive"]["uniform"].as_str().expect("a number").to_owned();
        text.parse::<f64>().expect("a number")
    };
    assert!((faces(&with_hole) - 0.75 * faces(&whole)).abs() < 1e-9);
    // Without corners the boundary is round.
    let flat = TemporaryFile::new("flat.obj", &grid.replace("1 1 1", "1 1 0"));
    let level = |boundary: &[&str]| depth(flat.path(), boundary)["level"].as_u64();
    assert_eq!(level(&["--boundary", "corner"]), Some(0));
    assert!(level(&["--boundary", "edge"]) > Some(0));
    let refuses = |arguments: &[&str], parts: &[&str]| {
        let asked = ["depth", "catmull-clark", "--tolerance", "1", "--mesh", mesh.path()];
        assert_parts(&refused([&asked[..], arguments].concat()), parts);
    };
    refuses(&["--boundary", "none"], &["the surface is empty", "`edge` or `corner`"]);
    refuses(&["--boundary", "open"], &["--polygon", "--mesh"]);
}

#[test]
fn what_has_no_depth() {
    let square =
        TemporaryFile::new("flat.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    let cases: [(&[&str], &[&str]); 6] = [
        (&["doo-sabin", "--tolerance", "1", "--mesh", square.path()], &["the surface is empty"]),
        (&["loop", "--tolerance", "1", "--mesh", square.path()], &["refines triangles"]),
        (&["catmull-clark", "--tolerance", "0", "--mesh", square.path()], &["must be positive"]),
        (
            &["catmull-clark", "--tolerance", "1e-60", "--mesh", square.path()],
            &["take a greater one"],
        ),
        (
            &["catmull-clark", "--tolerance", "1", "--mesh", square.path(), "--per-face", "x.txt"],
            &[".csv, .json or .ply"],
        ),
        (&["chaikin", "--tolerance", "1", "--mesh", square.path()], &["no scheme for meshes"]),
    ];
    for (arguments, parts) in cases {
        assert_parts(&refused([&["depth"], arguments].concat()), parts);
    }
}
