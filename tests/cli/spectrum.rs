//! `spectrum` and `table`.

use super::{TemporaryFile, assert_parts, refused, written};
use serde_json::Value;

fn json(scheme: &str, valence: &str) -> Value {
    let text = written(["spectrum", scheme, "--valence", valence, "--format", "json"]);
    serde_json::from_str(&text).expect("JSON")
}

/// Rules of two steps say so wherever their numbers are printed; others say nothing.
#[test]
fn what_is_of_two_steps_says_so() {
    let note = |scheme: &str| format!("one level is 2 steps of {scheme}");
    for scheme in ["sqrt3", "mid-edge"] {
        let ring = &format!("{scheme}:{}=5", if scheme == "sqrt3" { "N" } else { "n" });
        for format in ["c", "cpp", "rust", "python", "glsl", "hlsl", "wgsl", "json"] {
            let text = written(["table", scheme, "--valences", "3..4", "--format", format]);
            assert!(text.contains(&note(scheme)), "{format}: {text}");
        }
        for command in [
            vec!["spectrum", scheme, "--valence", "5"],
            vec!["constants", ring],
            vec!["depth", ring, "--tolerance", "1/10"],
            vec!["certify", ring],
            vec!["scheme", ring],
            vec!["smoothness", ring],
        ] {
            for format in ["text", "markdown", "json"] {
                let text = written(command.iter().copied().chain(["--format", format]));
                let text = text.replace('\n', " ").replace("  ", " ");
                assert!(text.contains("one level is 2 steps of "), "{command:?} {format}: {text}");
            }
        }
        for format in ["json", "csv", "table", "matlab"] {
            let text = written(["oracle", ring, "--format", format, "-c", "1"]);
            let text = text.replace("\n%   ", " ").replace("  ", " ");
            let there = text.contains("one level is 2 steps of ");
            // The table is for programs, and has no comments.
            assert!(there || format == "table", "{format}: {text}");
        }
    }
    for command in [["spectrum", "loop", "--valence", "5"], ["oracle", "loop:N=5", "-c", "1"]] {
        assert!(!written(command).contains("steps"), "{command:?}");
    }
}

#[test]
fn spectra_as_json() {
    let found = json("catmull-clark", "4");
    let second = &found["eigenvalues"][1];
    assert_eq!((&second["exact"], &second["multiplicity"]), (&"1/2".into(), &2.into()));
    assert_eq!(second["block"], serde_json::json!([1, 3]));
    assert_eq!(found["conditions"]["curvature"], "bounded");
    assert_eq!(
        (&found["limit"][0]["point"], &found["limit"][0]["exact"]),
        (&"vertex".into(), &"4/9".into())
    );
    assert_eq!(found["tangents"][1][2]["decimal"], "1");
    assert_eq!(found["neighbourhood"].as_array().map(Vec::len), Some(7));
    let five = json("catmull-clark", "5");
    assert_eq!(five["eigenvalues"][1]["decimal"], "0.54998835451829718");
    assert_eq!(
        five["eigenvalues"][1]["exact"],
        "5/16 + 1/16*cos(2*pi/5) + 1/32*sqrt(37 + 38*cos(2*pi/5))"
    );
}

#[test]
fn spectra_as_text() {
    let text = written(["spectrum", "loop", "--valence", "3"]);
    assert_parts(
        &text,
        &[
            "3 corner",
            "1/16",
            "0 (2), 1, 2",
            "unbounded in general",
            "tangent 1, edge  1  -0.5  -0.5",
        ],
    );
    // A parameter of the scheme is as good as --valence.
    assert_eq!(
        written(["spectrum", "loop:N=3"]).lines().skip(2).collect::<Vec<_>>(),
        text.lines().skip(2).collect::<Vec<_>>()
    );
}

#[test]
fn sectors() {
    let text = written(["spectrum", "catmull-clark", "--sector", "2"]);
    assert_parts(
        &text,
        &[
            "sector of 2 faces on a crease",
            "1 vertex, 3 edge, 2 face",
            "across, edge    -1  4  -1",
            "1/2 = 0.5, equal",
            "one figure in the plane of both tangents",
        ],
    );
    assert_parts(
        &written(["spectrum", "loop", "--sector", "1"]),
        &["1 face on", "0.25, below", "of the tangent along"],
    );
    let above = written(["spectrum", "loop", "--sector", "4", "--corner"]);
    assert_parts(
        &above,
        &["at a corner", "along 2, edge    0  0  0  0  1", "above", "no tangent plane"],
    );
    let jordan = written(["spectrum", "loop", "--sector", "3", "--corner", "--format", "markdown"]);
    assert_parts(&jordan, &["equal", "Jordan block", "sum of both tangents"]);

    let many = written(["spectrum", "catmull-clark", "--sector", "5"]);
    assert_parts(&many, &["normals", "for generic data they have no limit"]);

    let json = |arguments: &[&str]| -> Value {
        let all = ["spectrum", "catmull-clark", "--format", "json", "--sector"];
        serde_json::from_str(&written([&all[..], arguments].concat())).expect("JSON")
    };
    let found = json(&["3"]);
    assert_eq!((&found["faces"], &found["corner"]), (&3.into(), &false.into()));
    assert_eq!(found["across"]["comparison"], "above");
    assert_eq!(found["across"]["eigenvalue"]["exact"], "11/32 + 1/32*sqrt(57)");
    assert_eq!(found["across"]["weights"][7]["point"], "face[2]");
    assert_eq!(found["limit"][4]["exact"], "1/6");
    assert_eq!(found["eigenvalues"][4]["block"], serde_json::json!([0, 3]));
    assert_eq!(json(&["1", "--corner"])["across"], Value::Null);
    assert_eq!(json(&["2", "--corner"])["across"]["weights"], Value::Null);

    let table = written(["table", "loop", "--sectors", "2..3", "--format", "cpp"]);
    assert_parts(
        &table,
        &[
            "namespace loop_crease {",
            "constexpr double across[2] = {0.375, 0.5};",
            "subcert table loop --sectors 2..3 --format cpp --type f64",
            "subcert spectrum loop --sector n --format json",
        ],
    );
    let table = written(["table", "loop", "--sectors", "2", "--corner", "--format", "c"]);
    assert_parts(&table, &["loop_corner_first_faces = 2", "--sectors 2..2 --corner --format c"]);
}

#[test]
fn sectors_are_refused() {
    let spectrum = |rest: &[&str]| refused([&["spectrum"], rest].concat());
    for scheme in ["doo-sabin", "catmull-clark:N=5", "chaikin", "examples/loop.toml"] {
        let expected = [&format!("not for `{scheme}`")[..], "`catmull-clark`, `loop`"];
        assert_parts(&spectrum(&[scheme, "--sector", "3"]), &expected);
    }
    assert_parts(&spectrum(&["loop", "--sector", "0"]), &["0 faces", "from 1 to 64"]);
    assert_parts(&spectrum(&["loop", "--sector", "65"]), &["65 faces"]);
    assert_parts(&spectrum(&["loop", "--sector", "x"]), &["a whole number from 1 on"]);
    assert_parts(&spectrum(&["loop", "--corner"]), &["required", "--sector <FACES>"]);
    let both = spectrum(&["loop", "--corner", "--valence", "5"]);
    assert_parts(&both, &["'--corner' cannot be used with '--valence <N>'"]);
    assert_parts(&spectrum(&["loop", "--sector", "3", "--valence", "5"]), &["cannot be used with"]);
    let table = |rest: &[&str]| refused([&["table", "loop", "--format", "c"], rest].concat());
    assert_parts(&table(&["--sectors", "x"]), &["number of faces, such as 1..8"]);
    assert_parts(&table(&["--sectors", "8..1"]), &["the first number of faces, 8, is above"]);
    assert_parts(&table(&["--sectors", "1..99999999999"]), &["from 1 to 64"]);
    assert_parts(&table(&["--sectors", "0..3"]), &["0 faces"]);
    assert_parts(&table(&["--corner", "--valences", "3..4"]), &["'--corner' cannot be used with"]);
    assert_parts(&table(&["--sectors", "1..3", "--valences", "3..4"]), &["cannot be used with"]);
}

// The characteristic map of these rules folds over.
#[test]
fn eigenvalues_alone_do_not_make_a_surface_smooth() {
    let rules = TemporaryFile::new(
        "folded.toml",
        "name = 'folded'\norbits = { face = 'n' }\nparameters.n = { about = 'the valence' }\n\
         edges = [['face[i]', 'face[i + 1]']]\n[weights.face]\n\
         face = '(1 + 27*kronecker(i, j))/30'\n",
    );
    let text = written(["spectrum", rules.path(), "--valence", "3"]);
    assert_parts(
        &text,
        &[
            "yes: λ = 9/10",
            "These conditions on eigenvalues are necessary only",
            "regular and injective",
            "`subcert smoothness` decides",
        ],
    );
}

#[test]
fn files_are_rings_of_their_own() {
    let found = json("examples/loop.toml", "7");
    assert_eq!(found["orbits"], found["neighbourhood"]);
    assert_eq!(found["conditions"]["subdominant"]["exact"], "3/8 + 1/4*cos(2*pi/7)");
    let table = written(["table", "examples/loop.toml", "--valences", "3..4", "--format", "cpp"]);
    assert_parts(&table, &["namespace loop {", "constexpr double limit[2][2]", "--type f64"]);
}

#[test]
fn bad_input() {
    let spectrum =
        |scheme: &str, valence: &str| refused(["spectrum", scheme, "--valence", valence]);
    assert_parts(&spectrum("loop", "2"), &["needs N >= 3", "N is 2"]);
    assert_parts(&spectrum("loop", "x"), &["a valence is a whole number"]);
    assert_parts(&spectrum("loop", "600"), &["601 points", "from 2 to 600"]);
    assert_parts(&spectrum("loop:N=5", "5"), &["leaves no parameter `N` or `n` open"]);
    assert_parts(&spectrum("chaikin", "5"), &["is not a ring of points"]);
    assert_parts(&spectrum("lop", "5"), &["did you mean `loop`?"]);
    assert_parts(&refused(["spectrum", "loop"]), &["needs its parameter `N`", "`--valence 5`"]);
    assert_parts(&refused(["smoothness", "loop"]), &["parameter `N`", "`--valences 5`"]);
    let turned = TemporaryFile::new(
        "turned.toml",
        "name = 'turned'\ntitle = 't'\nsource = 's 2000'\nparameters.n = { about = 'the valence' }\n\
         orbits = { a = 'n' }\nedges = [['a[i]', 'a[i + 1]']]\n[weights.a]\n\
         a = '(kronecker(j, i) + kronecker(mod(j - i, n), 1))/2'\n",
    );
    assert_parts(&spectrum(turned.path(), "5"), &["mirror image", "two steps"]);
    let table =
        |valences: &str| refused(["table", "loop", "--valences", valences, "--format", "c"]);
    assert_parts(&table("x"), &["such as 3..12"]);
    assert_parts(&table("9..3"), &["is above the last"]);
    assert_parts(&table("3..999999999999"), &["at most 256"]);
    assert_parts(&table("0..4"), &["needs N >= 3"]);
    assert_parts(
        &refused(["table", "loop", "--valences", "3..4", "--format", "c", "-o", "/proc/none/x.c"]),
        &["cannot write `/proc/none/x.c`", "there is no folder"],
    );
}

/// Kobbelt's rules have complex eigenvalues that are not computed; λ, which is above them, and the stencils are.
#[test]
fn small_complex_eigenvalues_are_bounded() {
    let text = written(["spectrum", "kobbelt", "--valence", "5", "--format", "json"]);
    let json: Value = serde_json::from_str(&text).expect("JSON");
    let number = |value: &Value| -> f64 {
        value["decimal"].as_str().expect("a text").parse().expect("a number")
    };
    let second = number(&json["conditions"]["subdominant"]);
    let complex = json["complex"].as_array().expect("a list");
    assert!(!complex.is_empty());
    let mut count = json["eigenvalues"].as_array().expect("a list").iter().fold(0, |sum, one| {
        let each = if one["imaginary"].is_null() { 1 } else { 2 };
        sum + each * one["multiplicity"].as_u64().expect("a number")
    });
    for one in complex {
        let [lower, upper] = [&one["lower"], &one["upper"]].map(number);
        assert!(0.0 < lower && lower < upper && upper < second, "{one}");
        assert!(upper < lower * 1.01, "{one}");
        count += one["count"].as_u64().expect("a number");
    }
    // One vertex, and six orbits of five points.
    assert_eq!(count, 31);
    assert!(!json["tangents"].is_null() && !json["limit"].is_null());
    let text = written(["spectrum", "kobbelt", "--valence", "5"]);
    assert!(text.contains("complex ones, blocks") && text.contains("not computed"), "{text}");
    let table = written(["table", "kobbelt", "--valences", "4..6", "--format", "c"]);
    assert!(table.contains("first_valence = 4") && table.contains("last_valence = 6"), "{table}");
}

/// A valence without a table is left out, with the reason, and the others are there.
#[test]
fn a_table_without_one_valence() {
    // At valence 5, an eigenvalue of block 0 is above λ.
    let rules = r#"
title = "Loop's rules with other weights"
source = "this test"
parameters.N = { least = '3', about = "valence" }
orbits = { vertex = '1', edge = 'N' }
edges = [['vertex', 'edge[i]'], ['edge[i]', 'edge[i + 1]']]
[weights.vertex]
vertex = '1 - N*beta'
edge = 'beta'
[weights.edge]
vertex = '3/8'
edge = '(3*kronecker(turn, 0) + kronecker(turn, 1) + kronecker(turn, N - 1))/8'
[let]
turn = 'mod(j - i, N)'
beta = '3/(8*N) - kronecker(N, 5)*13/200'
"#;
    let file = TemporaryFile::new("rules.toml", &format!("name = \"rules\"\n{rules}"));
    let alone = refused(["table", file.path(), "--valences", "5..5", "--format", "json"]);
    assert_parts(&alone, &["valence 5", "no subdominant eigenvalue"]);
    let text = written(["table", file.path(), "--valences", "4..7", "--format", "python"]);
    assert!(text.contains("Without valence 5: "), "{text}");
    assert!(text.contains("valence = [4, 6, 7]") && text.contains("from offset[i] on"), "{text}");
    assert!(text.contains("Row i of a table is that of valence[i]."));
}
