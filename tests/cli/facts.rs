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

#[test]
fn bad_schemes() {
    assert_parts(&refused(["atlas", "chaikinn"]), &["chaikin"]);
    assert_parts(&refused(["scheme", "chaikin x chaikin"]), &["tensor product", "one by one"]);
    assert_parts(&refused(["scheme", "six-point"]), &["`w`"]);
    assert_parts(&refused(["scheme", "[1, 2]/0"]), &["error"]);
    assert_parts(&refused(["scheme", "loop:N=2"]), &["N"]);
}
