//! Files of meshes and polygons as programs write them: what is read, what is noted, and what is joined.

use super::{TemporaryFile, assert_parts, refused, subcert, temporary, written};
use serde_json::Value;
use std::fmt::Write as _;

const TETRAHEDRON: &str =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

/// What `limit` says of a mesh in a file.
fn limits(scheme: &str, file: &TemporaryFile, more: &[&str]) -> Value {
    let asked = ["limit", scheme, "--format", "json", "--mesh", file.path()];
    serde_json::from_str(&written(asked.into_iter().chain(more.iter().copied()))).expect("JSON")
}

fn length(value: &Value) -> usize {
    value.as_array().map_or(0, Vec::len)
}

/// A double pyramid over n points, from `before` points on.
fn pyramid(n: usize, before: usize) -> String {
    let mut text = format!("v {n} 0 1\nv {n} 0 -1\n");
    let rim = |i: usize| before + 3 + i % n;
    for i in 0..n {
        let _ = writeln!(text, "v {} {} 0", n + i, i * (n - i));
    }
    for i in 0..n {
        let _ = writeln!(text, "f {} {} {}", before + 1, rim(i), rim(i + 1));
        let _ = writeln!(text, "f {} {} {}", before + 2, rim(i + 1), rim(i));
    }
    text
}

/// The field of all valences together is beyond the cap, and no point needs it.
#[test]
fn each_vertex_is_in_a_field_of_its_own() {
    let valences = [5, 7, 8, 9, 11];
    let (mut all, mut before) = (String::new(), 0);
    for n in valences {
        all += &pyramid(n, before);
        before += n + 2;
    }
    let all = TemporaryFile::new("various.obj", &all);
    for level in ["0", "2"] {
        let together = limits("loop", &all, &["--level", level]);
        let together = together["limits"].as_array().expect("limits");
        let mut at = 0;
        for n in valences {
            let alone = TemporaryFile::new(&format!("{n}.obj"), &pyramid(n, 0));
            let alone = limits("loop", &alone, &["--level", level]);
            // The vertices of the file keep their order; those of edges come after those of all.
            assert_eq!(
                together[at..at + n + 2],
                alone["limits"].as_array().expect("a list")[..n + 2]
            );
            at += n + 2;
        }
    }
    let refined = written(["refine", "loop", "--level", "2", "--mesh", all.path()]);
    assert_eq!(refined.lines().filter(|line| line.starts_with("f ")).count(), 16 * 2 * 40);
    let values = written(["oracle", "loop", "--level", "1", "--mesh", all.path()]);
    assert!(values.contains("cos(2*pi/11)") && values.contains("cos(2*pi/9)"));
}

/// A vertex at which faces of 5, 7, 8, 9 and 11 vertices meet needs the field of all.
#[test]
fn a_point_that_needs_too_large_a_field_is_named() {
    let sizes = [5, 7, 8, 9, 11];
    let (mut text, mut faces, mut count) = ("v 0 0 0\n".to_owned(), String::new(), 1);
    for i in 0..5 {
        let _ = writeln!(text, "v {i} {} 0", i * i);
        count += 1;
    }
    for (i, size) in sizes.into_iter().enumerate() {
        let _ = write!(faces, "f 1 {}", i + 2);
        for _ in 0..size - 3 {
            count += 1;
            let _ = writeln!(text, "v {count} {i} 1");
            let _ = write!(faces, " {count}");
        }
        let _ = writeln!(faces, " {}", (i + 1) % 5 + 2);
    }
    let file = TemporaryFile::new("meeting.obj", &(text + &faces));
    let asked = ["doo-sabin", "--mesh", file.path()];
    let message = refused(["limit"].into_iter().chain(asked));
    assert_parts(&message, &["meeting.obj:1:1", "vertex 1", "n = 27720", "at most n = 10000"]);
    let more = ["--level", "2"];
    let message = refused(["refine"].into_iter().chain(asked).chain(more));
    assert_parts(&message, &["level 2: the new point near (", "27720", "take a lower level"]);
    assert!(written(["refine"].into_iter().chain(asked)).contains("level 1"));
}

/// Every form here is the same tetrahedron, or a part of it, with four points.
#[test]
fn forms_that_programs_write() {
    let off = "OFF4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    let ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
               element tristrips 1\nproperty list int int vertex_indices\nend_header\n\
               0 0 0\n1 0 0\n0 1 0\n0 0 1\n11 0 2 1 3 0 2 -1 2 2 0 1\n";
    let vtk = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n\
               0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 4 16\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\nCELL_TYPES 4\n5 5 5 5\n";
    let medit = "MeshVersionFormatted 1\nDimension 3\nVertices 4\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\n\
                 Triangles 4\n1 3 2 1\n1 2 4 1\n2 3 4 1\n3 1 4 1\nEnd\n";
    let plain = TemporaryFile::new("plain.obj", TETRAHEDRON);
    let wanted = limits("loop", &plain, &[]);
    for (name, text) in
        [("a.off", off), ("a.vtk", vtk), ("a.mesh", medit), ("medit", medit), ("off", off)]
    {
        let file = TemporaryFile::new(name, text);
        assert_eq!(limits("loop", &file, &[])["limits"], wanted["limits"], "{name}");
    }
    let strip =
        TemporaryFile::new("strip.ply", &ply.replace("11 0 2 1 3 0 2 -1 2 2 0 1", "6 0 2 1 3 0 2"));
    assert_eq!(
        limits("loop", &strip, &[])["faces"],
        serde_json::json!([[0, 2, 1], [1, 2, 3], [1, 3, 0], [0, 3, 2]])
    );
    // A triangle that joins parts of a strip is dropped, and the last one, (2, 0, 1), is there already.
    let again = TemporaryFile::new("again.ply", ply);
    assert_parts(
        &refused(["refine", "loop", "--mesh", again.path()]),
        &["the same face", "remove one"],
    );
    let pixel = vtk.replace(
        "CELLS 4 16\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\nCELL_TYPES 4\n5 5 5 5",
        "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n8",
    );
    let pixel = TemporaryFile::new("pixel.vtk", &pixel);
    assert_eq!(limits("catmull-clark", &pixel, &[])["faces"], serde_json::json!([[0, 1, 3, 2]]));
}

#[test]
fn several_solids_and_latin_1() {
    let solid = |name: &str, x: i64| {
        let facet = |a: &str, b: &str, c: &str| {
            format!(
                "facet normal 0 0 0 outer loop vertex {x} {a} vertex {x} {b} vertex {x} {c} endloop endfacet\n"
            )
        };
        format!(
            "solid {name}\n{}{}endsolid {name}\n",
            facet("0 0", "0 1", "1 0"),
            facet("0 1", "1 1", "1 0")
        )
    };
    let both = TemporaryFile::new("two.stl", &(solid("a", 0) + &solid("b", 7)));
    let found = limits("loop", &both, &[]);
    assert_eq!((length(&found["points"]), length(&found["faces"])), (8, 4));
    assert!(found["notes"].to_string().contains("the 2 solids of the file are read as one mesh"));
    let rest = TemporaryFile::new("rest.stl", &(solid("a", 0) + "facet normal 0 0 0\n"));
    assert_parts(
        &refused(["refine", "loop", "--mesh", rest.path()]),
        &["more after the end of the solid"],
    );

    let latin = [b"# W\xfcrfel\no W\xfcrfel\n", TETRAHEDRON.as_bytes()].concat();
    let file = TemporaryFile::new("latin.obj", "");
    std::fs::write(file.path(), &latin).expect("the file");
    assert_eq!(length(&limits("loop", &file, &[])["faces"]), 4);
    // In a number such a byte is wrong, as it always was, and a control character is no text.
    std::fs::write(file.path(), [&latin[..], b"v 1 \xfc 2\n"].concat()).expect("the file");
    assert_parts(&refused(["refine", "loop", "--mesh", file.path()]), &["latin.obj:11:5"]);
    std::fs::write(file.path(), [&latin[..], b"# \x01\xfc\n"].concat()).expect("the file");
    assert_parts(
        &refused(["refine", "loop", "--mesh", file.path()]),
        &["neither UTF-8 nor Latin-1"],
    );
}

/// Counts that cannot be right, and files that end: a message, at once.
#[test]
fn huge_counts_are_refused() {
    let head =
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 1 float\n0 0 0\n";
    for count in
        ["2147483648", "9007199254740992", "9223372036854775808", "18446744073709551616", "-1"]
    {
        for (name, text) in [
            ("a.off", format!("OFF{count} 1 0\n0 0 0\n")),
            ("b.off", format!("OFF 1 {count} 0\n0 0 0\n")),
            ("c.off", format!("OFF 1 1 0\n0 0 0\n{count} 0 0 0\n")),
            ("a.mesh", format!("MeshVersionFormatted 1 Dimension 3 Vertices {count} 0 0 0 1\n")),
            (
                "b.mesh",
                format!(
                    "MeshVersionFormatted 1 Dimension 3 Vertices 1 0 0 0 1 Triangles {count} 1 1 1 0\n"
                ),
            ),
            (
                "c.mesh",
                format!(
                    "MeshVersionFormatted 1 Dimension 3 Vertices 1 0 0 0 1 Triangles 1 1 1 {count} 0\n"
                ),
            ),
            ("a.vtk", format!("{head}CELLS {count} 4 3 0 0 0 CELL_TYPES 1 5\n")),
            ("b.vtk", format!("{head}CELLS 1 4 {count} 0 0 0 CELL_TYPES 1 5\n")),
            ("c.vtk", format!("{head}CELLS 1 4 3 0 0 0 CELL_TYPES {count} 5\n")),
            ("d.vtk", format!("{head}CELLS 1 4 3 0 0 {count} CELL_TYPES 1 6\n")),
            (
                "a.ply",
                format!(
                    "ply\nformat ascii 1.0\nelement vertex 0\nelement tristrips {count}\nproperty list int int vertex_indices\nend_header\n3 0 0 0\n"
                ),
            ),
            (
                "b.ply",
                format!(
                    "ply\nformat ascii 1.0\nelement vertex 0\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n{count} 0 1 2\n"
                ),
            ),
            ("a.obj", format!("v 0 0 0\nf 1 1 {count}\n")),
        ] {
            let file = TemporaryFile::new(name, &text);
            assert_parts(&refused(["refine", "loop", "--mesh", file.path(), "--weld"]), &["error"]);
        }
    }
    for (name, text) in [
        ("a.off", ""),
        ("a.stl", "solid a\nendsolid a\nsolid b\n"),
        ("a.mesh", ""),
        ("a.vtk", "# vtk DataFile Version 3.0\n"),
    ] {
        let file = TemporaryFile::new(name, text);
        assert_parts(&refused(["refine", "loop", "--mesh", file.path()]), &["error"]);
    }
}

/// Two squares whose points stand twice, a short step apart.
const SQUARES: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1.001 0 0\nv 2 0 0\nv 2 1 0\nv 1.001 1 0\nf 1 2 3 4\nf 5 6 7 8\n";

#[test]
fn points_near_each_other_are_joined() {
    let file = TemporaryFile::new("squares.obj", SQUARES);
    let found = limits("catmull-clark", &file, &[]);
    assert_eq!(length(&found["points"]), 8);
    assert!(found["notes"].to_string().contains("no two faces have an edge in common"));
    assert!(
        limits("catmull-clark", &file, &["--weld"])["notes"].to_string().contains("none is joined")
    );
    let found = limits("catmull-clark", &file, &["--weld=1e-3"]);
    assert_eq!(length(&found["points"]), 6);
    assert_eq!(found["faces"], serde_json::json!([[0, 1, 2, 3], [1, 4, 5, 2]]));
    // The lesser x stays, whatever the order is.
    assert!(found["notes"].to_string().contains("2 points at most 1/1000 from another are joined"));
    assert!(!found.to_string().contains("1001/1000"));
    // Just below the distance nothing is joined.
    let below = limits("catmull-clark", &file, &["--weld=0.000999"]);
    assert_eq!(length(&below["points"]), 8);
    let depth =
        ["depth", "catmull-clark", "--tolerance", "1/10", "--mesh", file.path(), "--weld=1e-3"];
    assert!(written(depth).contains("Note: "));
    let oracle = ["oracle", "catmull-clark", "--mesh", file.path(), "--weld=1e-3", "--level", "0"];
    assert!(written(oracle).contains("are joined with it"));
    for (weld, part) in
        [("-1", "below 0"), ("x", "--weld"), ("1e-30", "too small for the coordinates")]
    {
        let weld = format!("--weld={weld}");
        let asked = ["refine", "catmull-clark", "--mesh", file.path(), &weld];
        assert_parts(&refused(asked), &[part]);
    }
    assert_parts(&refused(["depth", "chaikin", "--tolerance", "1", "--weld"]), &["--mesh"]);
    // What follows the option is no number of it.
    let before = written(["refine", "--weld", "catmull-clark", "--mesh", file.path()]);
    let after =
        written(["refine", "catmull-clark", "--mesh", file.path(), "--weld", "--level", "1"]);
    assert_eq!(before, after);
}

/// Chains are joined, in any order, and faces lose the corners that become one.
#[test]
fn chains_and_corners() {
    let points = ["v 0 0 0", "v 3 0 0", "v 1 0 0", "v 2 0 0", "v 0 9 0", "v 9 9 0", "v 9 0 0"];
    let faces = |number: &dyn Fn(usize) -> usize| {
        let face = |vertices: &[usize]| {
            let numbers: Vec<String> = vertices.iter().map(|v| number(*v).to_string()).collect();
            format!("f {}\n", numbers.join(" "))
        };
        face(&[1, 3, 4, 2, 7, 6, 5]) + &face(&[5, 6, 1]).replace("f ", "# ")
    };
    let plain = points.join("\n") + "\n" + &faces(&|v| v) + "v 5 5 5\nf 3 8 4\n";
    let reversed: Vec<&str> = points.iter().rev().copied().collect();
    let reversed = reversed.join("\n") + "\n" + &faces(&|v| 8 - v) + "v 5 5 5\nf 5 8 4\n";
    for text in [plain, reversed] {
        let file = TemporaryFile::new("chain.obj", &text);
        let found = limits("catmull-clark", &file, &["--weld=1"]);
        let mut points: Vec<String> = found["points"]
            .as_array()
            .expect("points")
            .iter()
            .map(|point| point["exact"].to_string())
            .collect();
        points.sort();
        assert_eq!(
            points,
            [r#"["0","0","0"]"#, r#"["0","9","0"]"#, r#"["9","0","0"]"#, r#"["9","9","0"]"#]
        );
        assert_eq!(length(&found["faces"]), 1);
        let notes = found["notes"].to_string();
        assert_parts(
            &notes,
            &[
                "3 points at most 1",
                "4 corners that are the same",
                "1 faces of fewer than 3 corners",
            ],
        );
    }
    // Corners that become one without being neighbours.
    let pinched =
        TemporaryFile::new("pinched.obj", "v 0 0 0\nv 1 1 0\nv 0 0 0\nv -1 1 0\nf 1 2 3 4\n");
    assert_parts(
        &refused(["refine", "catmull-clark", "--mesh", pinched.path(), "--weld"]),
        &["twice"],
    );
}

#[test]
fn what_is_told_of_files() {
    let twice = TemporaryFile::new("twice.obj", &(TETRAHEDRON.to_owned() + "f 4 3 1\n"));
    let message = refused(["refine", "loop", "--mesh", twice.path()]);
    assert_parts(
        &message,
        &["twice.obj:9:1", "the same face for the second time", "remove one of the two"],
    );
    let plain = TemporaryFile::new("told.obj", TETRAHEDRON);
    let usda = written(["refine", "loop", "--mesh", plain.path(), "--format", "usda"]);
    let file = TemporaryFile::new("named.usda", &usda);
    assert_eq!(limits("loop", &file, &[])["notes"], Value::Null);
    let other = limits("catmull-clark", &file, &[])["notes"].to_string();
    assert_parts(&other, &["subdivisionScheme `loop`", "refined by catmull-clark"]);

    let closed = TemporaryFile::new("closed.csv", "0,0\n4,0\n4,3\n0,3\n0,0\n");
    let parts = TemporaryFile::new("parts.csv", "0,0\n4,0\n# one\n4,3\n \n0,3\n1,1\n");
    let asked = |file: &TemporaryFile, more: &[&str]| {
        let depth = ["depth", "chaikin", "--tolerance", "1/10", "--polygon", file.path()];
        let text = written(depth.into_iter().chain(more.iter().copied()));
        let oracle = ["oracle", "chaikin", "--polygon", file.path()];
        let json = written(oracle.into_iter().chain(more.iter().copied()));
        let notes: Value = serde_json::from_str(&json).expect("JSON");
        (text, notes["header"]["notes"].to_string())
    };
    let (text, notes) = asked(&closed, &[]);
    assert!(
        text.contains("the last point is the first")
            && notes.contains("the last point is the first")
    );
    let (text, notes) = asked(&closed, &["--boundary", "open"]);
    assert!(!text.contains("Note:") && notes == "null");
    let (text, notes) = asked(&parts, &[]);
    assert!(
        text.contains("an empty line before line 6") && notes.contains("line before line 6"),
        "{text} {notes}"
    );
    let json = written([
        "depth",
        "chaikin",
        "--tolerance",
        "1/10",
        "--format",
        "json",
        "--polygon",
        parts.path(),
    ]);
    assert!(json.contains("\"notes\": ["));
}

/// A lower bound that is called too great is above the tolerance as it is printed.
#[test]
fn what_is_too_far_is_printed_as_farther_than_the_tolerance() {
    let points = "0,0\n4,0\n4,3\n0,3\n";
    let file = TemporaryFile::new("points.csv", points);
    for tolerance in ["0.1", "0.25", "0.7", "0.374999999999"] {
        let text =
            written(["depth", "chaikin", "--tolerance", tolerance, "--polygon", file.path()]);
        let words: Vec<&str> = text.split_whitespace().collect();
        let shown = words.windows(4).filter(|four| four[..3] == ["is", "at", "least"]);
        for four in shown {
            let far: f64 = four[3].parse().expect("a number");
            assert!(
                far > tolerance.parse::<f64>().expect("a number"),
                "{far} for {tolerance}: {text}"
            );
        }
    }
}

/// The ending says the form, or the message says which endings there are; nothing is made by the way.
#[test]
fn endings_decide() {
    let folder = temporary("endings");
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = |name: &str| folder.join(name).to_str().expect("a path").to_owned();
    let schemes: [(&[&str], &str, &str); 12] = [
        (&["schemes"], "a.json", "{"),
        (&["schemes"], "a.md", "- "),
        (&["constants", "chaikin"], "a.csv", "direction,"),
        (&["scheme", "chaikin"], "A.TEX", "%"),
        (&["depth", "chaikin", "--tolerance", "1/10"], "a.html", "<!DOCTYPE html>"),
        (&["oracle", "chaikin"], "b.csv", "# "),
        (&["oracle", "chaikin"], "b.m", "function"),
        (&["oracle", "chaikin"], "b.h", "// Reference values"),
        (
            &["oracle", "catmull-clark", "--mesh", "examples/cube.obj"],
            "b.RS",
            "// Reference values",
        ),
        (&["scheme", "chaikin", "haar"], "b.html", "<!DOCTYPE html>"),
        (&["limit", "catmull-clark", "--mesh", "examples/cube.obj"], "b.usda", "#usda"),
        (&["schemes", "--format", "json"], "b.txt", "{"),
    ];
    for (arguments, name, start) in schemes {
        let file = path(name);
        subcert(arguments.iter().copied().chain(["-o", &file])).assert().success();
        let text = std::fs::read_to_string(&file).expect("the file");
        assert!(text.starts_with(start), "{name}: {text}");
    }
    let refused_files: [(&[&str], &str, &[&str]); 12] = [
        (&["schemes"], "x.stl", &[".txt, .json, .md, .csv or .tex", "--format"]),
        (
            &["refine", "catmull-clark", "--mesh", "examples/cube.obj"],
            "x.txt",
            &[".json, .obj, .off, .ply, .stl or .usda"],
        ),
        (&["limit", "catmull-clark", "--mesh", "examples/cube.obj"], "x.gltf", &[".json", ".obj"]),
        (&["refine", "bajaj", "--mesh", "examples/star.vtk"], "x.obj", &[".vtk", ".mesh"]),
        (&["oracle", "chaikin"], "x.txt", &[".json, .csv, .m, .c, .h or .rs"]),
        (&["plot", "chaikin"], "x.png", &[".svg"]),
        (&["new", "k"], "x.json", &[".toml"]),
        (&["audit", "examples/my-paper.toml"], "x.html", &[".csv or .tex, or add", "-o DIR"]),
        (&["atlas", "chaikin"], "x.htm", &[".csv or .tex, or add --format html", "-o DIR"]),
        (&["audit", "--format", "text"], "x.html", &["is for pages"]),
        (&["plot", "chaikin"], "none/x.svg", &["there is no folder", "-o FILE"]),
        (&["schemes"], "none/x.txt", &["there is no folder"]),
    ];
    for (arguments, name, parts) in refused_files {
        let file = path(name);
        assert_parts(&refused(arguments.iter().copied().chain(["-o", &file])), parts);
        assert!(!std::path::Path::new(&file).exists() && !folder.join("none").exists());
    }
    std::fs::remove_dir_all(&folder).expect("the folder is there");
}

/// Tags count from 0.
#[test]
fn a_crease_at_no_vertex_says_how_tags_count() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\nt crease 2/1/0 4 1 3\n";
    let file = TemporaryFile::new("crease.obj", text);
    let parts = ["vertex 4 does not exist: there are 4", "from 0"];
    assert_parts(&refused(["refine", "loop", "--mesh", file.path()]), &parts);
}

/// The numbers of points are those of the file, and a mesh of which no face is left is refused.
#[test]
fn joining_points_keeps_the_numbers_of_errors() {
    let far = SQUARES.replace("f 5 6 7 8", "f 5 6 7 22");
    let file = TemporaryFile::new("far.obj", &far);
    let parts = ["point 22 does not exist: there are 8 points"];
    assert_parts(
        &refused(["limit", "catmull-clark", "--mesh", file.path(), "--weld=1e-3"]),
        &parts,
    );
    let file = TemporaryFile::new("squares.obj", SQUARES);
    let parts = ["no face is left", "lesser distance"];
    assert_parts(&refused(["limit", "catmull-clark", "--mesh", file.path(), "--weld=10"]), &parts);
}

/// Points with long decimals are compared as integers, and within the cap.
#[test]
fn points_of_many_digits_are_joined() {
    let zeros = "0".repeat(900);
    let mut text = String::new();
    for i in 0..300 {
        let _ = writeln!(text, "v {i}.{zeros}1 0 0\nv {i} 1 0");
    }
    for i in 0..299 {
        let first = 2 * i + 1;
        let _ = writeln!(text, "f {first} {} {} {}", first + 2, first + 3, first + 1);
    }
    let file = TemporaryFile::new("long.obj", &text);
    let asked = ["limit", "catmull-clark", "--mesh", file.path(), "--weld=0.9", "--format", "json"];
    assert!(written(asked).contains("none is joined"));
}
