//! `depth`, `refine`, `limit` and `oracle` on tensor nets.

use super::{TemporaryFile, assert_parts, refused, subcert, written};

const ROOF: [&str; 2] = ["--mesh", "examples/roof.csv"];

fn of_roof<'a>(arguments: &[&'a str]) -> Vec<&'a str> {
    arguments.iter().copied().chain(ROOF).collect()
}

fn json(text: &str) -> serde_json::Value {
    serde_json::from_str(text).expect("JSON")
}

#[test]
fn the_depth_of_a_net() {
    let depth = ["depth", "bicubic", "--tolerance", "1/200"];
    let text = written(of_roof(&depth));
    assert_parts(
        &text,
        &["depth of the net", "2 levels; 1 is too few", "(cell ", "mustafa2020-nary"],
    );
    let sets = json(&written(of_roof(&[&depth[..], &["--format", "json"]].concat())));
    assert_eq!((&sets["level"], &sets["too_few"]), (&2.into(), &1.into()));
    let parametric = [&depth[..], &["--distance", "parametric", "--format", "json"]].concat();
    let form = json(&written(of_roof(&parametric)));
    assert_eq!((&form["level"], &form["too_few"]), (&2.into(), &1.into()));
    for place in [&form["worst_face"], &sets["too_far"]] {
        let face = place["face"].as_u64().expect("a face");
        assert_eq!(place["cell"], serde_json::json!([face / 6, face % 6]));
    }
    assert!(form["a_priori"]["level"].as_u64() >= Some(3), "{form}");
    // Second differences −0.2 and 0.05 across and along: (0.2 − 0.05)/6 at level 0.
    let found =
        json(&written(of_roof(&["depth", "bicubic", "--tolerance", "1/40", "--format", "json"])));
    assert!(found["level"].as_u64() <= Some(1), "{found}");
    let only = json(&written(of_roof(&[&depth[..], &["--format", "json", "--a-priori"]].concat())));
    assert_eq!((&only["level"], &only["a_priori"]), (&serde_json::Value::Null, &form["a_priori"]));
}

#[test]
fn a_depth_has_a_certificate() {
    let file = TemporaryFile::new("depth.cert", "");
    let depth = ["depth", "chaikin", "--tolerance", "1/100", "--certificate", file.path()];
    written(of_roof(&depth));
    let text = std::fs::read_to_string(file.path()).expect("the file");
    let checked = subcert_check::check_depth(&text).expect("a valid certificate");
    assert_eq!(
        checked.to_string(),
        "level 1 is enough, and level 0 is not enough: it is the least"
    );
    let json = |depth: &[&str]| {
        let text = written(of_roof(&[depth, &["--format", "json"]].concat()));
        serde_json::from_str::<serde_json::Value>(&text).expect("JSON")["certificate"].clone()
    };
    assert_eq!([json(&depth), json(&depth[..4])], [file.path().into(), serde_json::Value::Null]);
    let parametric = refused(of_roof(&[&depth[..], &["--distance", "parametric"]].concat()));
    assert_parts(&parametric, &["--certificate", "leave out --distance parametric"]);
    let alone = refused(["depth", "chaikin", "--tolerance", "1", "--certificate", "x"]);
    assert_parts(&alone, &["--polygon or --mesh"]);
    let cube = ["--mesh", "examples/cube.obj", "--certificate", "x"];
    let cube = ["depth", "catmull-clark", "--tolerance", "1"].into_iter().chain(cube);
    assert_parts(&refused(cube), &["polygon meshes and solids have none"]);
}

#[test]
fn nets_are_written_in_all_forms() {
    let text = written(of_roof(&["refine", "bicubic"]));
    assert!(
        text.starts_with("# examples/roof.csv, bicubic, level 1: refined\nv 0.25 0.25 "),
        "{text}"
    );
    assert_eq!(text.lines().filter(|line| line.starts_with("f ")).count(), 8 * 10);
    let file = TemporaryFile::new("refined.csv", "");
    assert!(written(of_roof(&["refine", "bicubic", "--level", "2", "-o", file.path()])).is_empty());
    let saved = std::fs::read_to_string(file.path()).expect("the file");
    assert_eq!(saved.lines().filter(|line| !line.starts_with('#')).count(), 15);
    // What is written reads back.
    let text = written(["limit", "chaikin", "--mesh", file.path(), "--format", "ply"]);
    assert!(text.starts_with("ply\n") && text.contains("element vertex "), "{text}");
    let vase = ["oracle", "bicubic", "--mesh", "examples/vase.json", "--level", "1"];
    let form = json(&written(vase));
    assert_eq!((&form["rows"], &form["columns"]), (&11.into(), &16.into()));
    assert_eq!(form["closed"], "v");
    assert_eq!(form["points"].as_array().expect("points").len(), 176);
    assert_eq!(form["faces"].as_array().expect("faces").len(), 160);
    assert_eq!(form["limits"][0], serde_json::Value::Null);
    assert!(form["limits"][16]["position"]["exact"][2].is_string());
    let open = json(&written(vase.into_iter().chain(["--closed", "none"])));
    assert_eq!((&open["columns"], &open["closed"]), (&13.into(), &"none".into()));
}

/// Rows on both sides of an empty line are one net, which is told.
#[test]
fn an_empty_line_in_a_net() {
    let text = std::fs::read_to_string("examples/roof.csv").expect("a net");
    let end = text.trim_end().rfind('\n').expect("lines");
    let apart =
        TemporaryFile::new("apart-net.csv", &format!("{}\n \n{}", &text[..end], &text[end..]));
    let note = "an empty line before line ";
    let oracle = json(&written(["oracle", "bicubic", "--mesh", apart.path()]));
    assert!(oracle["notes"][0].as_str().is_some_and(|told| told.contains(note)), "{oracle}");
    let depth = ["depth", "bicubic", "--tolerance", "1", "--mesh"].into_iter();
    assert!(written(depth.clone().chain([apart.path()])).contains(note));
    assert!(!written(depth.chain(["examples/roof.csv"])).contains(note));
    let refined = subcert(["refine", "bicubic", "--mesh", apart.path()]).assert().success();
    assert!(String::from_utf8_lossy(&refined.get_output().stderr).contains(note));
}

#[test]
fn the_distance_of_every_cell() {
    let table = TemporaryFile::new("cells.csv", "");
    let colours = TemporaryFile::new("cells.ply", "");
    for file in [&table, &colours] {
        let depth = ["depth", "chaikin", "--tolerance", "1/100", "--per-face", file.path()];
        written(of_roof(&depth));
    }
    let text = std::fs::read_to_string(table.path()).expect("the file");
    assert_eq!(text.lines().count(), 31);
    // All faces have a part of a biquadratic surface.
    let positive = |line: &&str| line.rsplit(',').next().is_some_and(|x| x != "0.0");
    assert_eq!(text.lines().skip(1).filter(positive).count(), 30, "{text}");
    let text = std::fs::read_to_string(colours.path()).expect("the file");
    assert!(text.contains("element face 30\n"), "{text}");
}

#[test]
fn what_is_no_net() {
    let cases: [(&str, &str, &[&str], &[&str]); 10] = [
        ("j.csv", "0 0 0,, 1 0 0\n", &[], &["j.csv:1:7", "no point between these commas"]),
        (
            "a.csv",
            "0 0 0, 1 0 0\n0 1 0\n",
            &[],
            &["a.csv:2:1", "1 points, and the first row has 2"],
        ),
        (
            "b.csv",
            "0,0,0\n1,0,0\n",
            &[],
            &["b.csv:1:1", "one point on a line", "separated by commas"],
        ),
        ("c.csv", "0 0 0, 1 0 0\n0 1 0, 1 1 0\n", &[], &["2 rows", "depends on 4", "--closed u"]),
        (
            "d.csv",
            "0 0 0, 1 0 0\n0 1 0, 1 1 0\n",
            &["--closed", "uv"],
            &["a closed direction needs 3"],
        ),
        ("e.json", "[[[0, 0, 0]", &[], &["e.json:1:", "EOF"]),
        ("f.json", "{\"closed\": \"w\", \"points\": []}", &[], &["f.json:1:12", "\"uv\""]),
        ("g.json", "{}", &[], &["no field `points`"]),
        ("h.csv", "", &[], &["no point in this file"]),
        ("i.csv", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", &[], &["i.csv:1:1"]),
    ];
    for (name, text, more, parts) in cases {
        let file = TemporaryFile::new(name, text);
        for command in ["refine", "limit", "oracle"] {
            let arguments = [command, "bicubic", "--mesh", file.path()];
            assert_parts(&refused(arguments.into_iter().chain(more.iter().copied())), parts);
        }
        let arguments = ["depth", "bicubic", "--tolerance", "1", "--mesh", file.path()];
        assert_parts(&refused(arguments.into_iter().chain(more.iter().copied())), parts);
    }
}

#[test]
fn what_does_not_fit() {
    let cases: [(&[&str], &[&str]); 8] = [
        (
            &["refine", "catmull-clark"],
            &["`catmull-clark` is for polygon meshes", "b-spline:degree=3"],
        ),
        (&["refine", "bicubc"], &["unknown scheme `bicubc`"]),
        (&["refine", "doo-sabin:n=5"], &["doo-sabin"]),
        (&["refine", "bicubic", "--level", "25"], &["level 25 is too high; at most 24 is"]),
        (&["refine", "bicubic", "--level", "9"], &["at most 1000000"]),
        (&["refine", "bicubic", "--closed", "w"], &["possible values: none, u, v, uv"]),
        (&["depth", "bicubic", "--tolerance", "0"], &["--tolerance must be positive"]),
        (&["depth", "b-spline:degree=8", "--tolerance", "1"], &["6 rows", "depends on 9"]),
    ];
    for (arguments, parts) in cases {
        assert_parts(&refused(of_roof(arguments)), parts);
    }
    let cube = ["refine", "bicubic", "--mesh", "examples/cube.obj"];
    assert_parts(&refused(cube), &["no scheme for meshes is called `bicubic`", "net"]);
    let closed = cube.into_iter().chain(["--closed", "u"]);
    assert_parts(&refused(closed), &["--closed is for nets", "polygon mesh"]);
    let csv = ["refine", "catmull-clark", "--mesh", "examples/cube.obj", "--format", "csv"];
    assert_parts(
        &refused(csv),
        &["polygon meshes are written as obj, off, ply, stl, usda or json"],
    );
    assert_parts(
        &refused(["limit", "bicubic", "--mesh", "nowhere.csv"]),
        &["cannot read `nowhere.csv`"],
    );
}
