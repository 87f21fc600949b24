//! `scheme` and `atlas`.

use super::{assert_parts, refused, written};
use serde_json::Value;

fn json<'a>(arguments: impl IntoIterator<Item = &'a str>) -> Value {
    let text = written(arguments.into_iter().chain(["--format", "json"]));
    serde_json::from_str(&text).expect("JSON")
}

#[test]
fn facts_as_text() {
    let text = written(["scheme", "dubuc-deslauriers:m=3"]);
    let parts =
        ["interpolating", "from -5 to 5", "of order 6", "C², not C³", "6 - log_2(9)", "φ(0)"];
    for part in parts {
        assert!(text.contains(part), "no `{part}` in {text}");
    }
    let wild = written(["scheme", "four-point:w=1"]);
    assert!(wild.contains("diverges") && wild.contains("Open"), "{wild}");
}

#[test]
fn facts_as_json() {
    let chaikin = json(["scheme", "chaikin"]);
    let curve = &chaikin["curve"];
    assert_eq!((&curve["kind"], &curve["continuity"]), (&"dual".into(), &1.into()));
    assert_eq!(curve["contraction"].as_array().expect("a list").len(), 8);
    assert_eq!(curve["contraction"][7]["exact"], "1/256");
    assert_eq!(curve["open"], Value::Array(Vec::new()));
    assert_eq!(chaikin["ranges"], Value::Null);
    let corner = json(["scheme", "corner-cutting:w=1/5"]);
    assert_eq!(corner["ranges"]["parameter"], "w");
    // Convergence for 0 < w < 1, as far as it is found.
    let all = corner["ranges"]["orders"][0]["inside"].as_array().expect("a list");
    let high: Vec<f64> = all
        .iter()
        .map(|interval| {
            interval["high"]["decimal"].as_str().expect("a decimal").parse().expect("a number")
        })
        .collect();
    assert!(high.last().is_some_and(|high| (0.9..=1.0).contains(high)), "{high:?}");
    let loops = json(["scheme", "loop"]);
    assert_eq!(loops["valences"].as_array().expect("a list").len(), 10);
    assert_eq!(loops["valences"][3]["vertex"]["curvature"], "bounded");
}

/// The atlas says of a scheme what `scheme` says, whatever the order of the names.
#[test]
fn the_atlas_is_made_of_schemes() {
    let atlas = json(["atlas", "de-rham", "chaikin"]);
    let schemes = atlas["schemes"].as_array().expect("a list");
    let names: Vec<&Value> = schemes.iter().map(|scheme| &scheme["scheme"]).collect();
    assert_eq!(names, ["chaikin", "de-rham"]);
    assert_eq!(schemes[0]["curve"], json(["scheme", "chaikin"])["curve"]);
    assert_eq!(json(["atlas", "chaikin", "chaikin"])["schemes"].as_array().map(Vec::len), Some(1));
}

/// A scheme of one's own has the facts of the same scheme of the catalogue, wherever it stands: in `scheme`, in the atlas, beside it.
#[test]
fn schemes_of_ones_own() {
    const OWN: &str = "examples/my-scheme.toml";
    const MASK: &str = "[1, 3, 3, 1]/4";
    let atlas = json(["atlas", "[1, 3, 3, 1]/4", OWN, "four-point:w=1/16", "four-point:w=1/8"]);
    let schemes = atlas["schemes"].as_array().expect("a list");
    let names: Vec<&Value> = schemes.iter().map(|scheme| &scheme["scheme"]).collect();
    assert_eq!(names, ["four-point:w=1/16", "four-point:w=1/8", "[1, 3, 3, 1]/4", OWN]);
    assert_eq!(schemes[3]["curve"], schemes[0]["curve"]);
    assert_ne!(schemes[1]["curve"], schemes[0]["curve"]);
    let own = json(["scheme", OWN]);
    assert_eq!(own["curve"], schemes[0]["curve"]);
    assert_eq!(own["ranges"], json(["scheme", "four-point"])["ranges"]);

    let both = json(["scheme", OWN, "four-point:w=1/16"]);
    assert_eq!(both["masks"], "same");
    assert_eq!(both["schemes"][0]["curve"], both["schemes"][1]["curve"]);
    assert_eq!(json(["scheme", OWN, "four-point:w=1/8"])["masks"], "different");
    // Zeros at the ends are no part of a mask.
    assert_eq!(json(["scheme", "[0, 1, 3, 3, 1, 0]/4", MASK])["masks"], "same");
    assert_eq!(json(["scheme", "[0, 0, 1, 3, 3, 1]/4", MASK])["masks"], "shifted");
    assert_eq!(json(["scheme", "chaikin", MASK])["masks"], "shifted");
    assert_eq!(json(["scheme", "daubechies-4", "haar"])["masks"], Value::Null);
}

#[test]
fn schemes_side_by_side() {
    let text = written(["scheme", "chaikin", "examples/my-scheme.toml", "--format", "markdown"]);
    for part in [
        "|  | chaikin | examples/my-scheme.toml |",
        "| interpolating | no | yes |",
        "| support | from -2 to 1 | from -3 to 3 |",
        "| T₈ | 0.00390625 |",
        "| φ(-1) | 1/2 | 0 |",
        "The masks are different.",
    ] {
        assert!(text.contains(part), "no `{part}` in {text}");
    }
    let rings = written(["scheme", "loop:N=7", "examples/loop.toml:N=7", "--format", "csv"]);
    assert!(rings.contains("schemes[1].valences[0].vertex.verdict,proved"), "{rings}");
    let rings = written(["scheme", "loop:N=7", "loop:N=5", "--format", "markdown"]);
    let rows: Vec<&str> = rings.lines().filter(|line| line.contains("loop:N=")).collect();
    assert!(rows.iter().any(|row| row.starts_with("| 5 | loop:N=5 | proved |")), "{rows:?}");
    let page = written(["scheme", "chaikin", "examples/my-scheme.toml", "--format", "html"]);
    for part in
        ["<!DOCTYPE html>", "chaikin: <var>C</var><sup>1</sup>", "my-scheme.toml: <var>", "φ′"]
    {
        assert!(page.contains(part), "no `{part}`");
    }
    let message = refused(["scheme", "chaikin", "examples/loop.toml"]);
    assert_parts(&message, &["`chaikin` is a mask", "`examples/loop.toml` are rules", "one kind"]);
    assert_parts(
        &refused(["scheme", "chaikin", "haar x haar"]),
        &["`haar x haar` is a mask on Z^d"],
    );
}

/// Rules of one's own may begin at a greater valence than 3.
#[test]
fn rules_with_a_least_valence() {
    const OWN: &str = "examples/loop-own-edges.toml";
    let found = json(["scheme", OWN]);
    let valences: Vec<u64> = { found["valences"].as_array().expect("a list").iter() }
        .map(|one| one["valence"].as_u64().expect("a number"))
        .collect();
    assert_eq!(valences, (5..=12).collect::<Vec<u64>>());
    assert!(written(["plot", OWN]).contains("The characteristic ring at valence 5"));
    for command in ["scheme", "plot"] {
        assert_parts(
            &refused([command, "examples/loop-beta.toml"]),
            &["needs its parameter `beta`"],
        );
        assert_parts(&refused([command, "loop-weight"]), &["needs its parameter `beta`"]);
    }
}

#[test]
fn bad_schemes() {
    assert_parts(&refused(["atlas", "chaikinn"]), &["chaikin"]);
    assert_parts(&refused(["atlas", "no.toml"]), &["cannot read `no.toml`"]);
    assert_parts(&refused(["atlas", "haar x haar"]), &["tensor product"]);
    assert_parts(&refused(["atlas", "examples/primal.toml"]), &["needs its parameter `a`"]);
    let product = written(["scheme", "chaikin x chaikin"]);
    assert_parts(&product, &["C¹, not C²", "[-2, 1] × [-2, 1]"]);
    assert_parts(&refused(["scheme", "six-point"]), &["`w`"]);
    assert_parts(&refused(["scheme", "[1, 2]/0"]), &["error"]);
    assert_parts(&refused(["scheme", "loop:N=2"]), &["N"]);
}
