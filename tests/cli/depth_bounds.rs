//! Depths of meshes: what f64 cannot hold, bounds in words, and searches that are stopped.

use super::{TemporaryFile, assert_parts, refused, written};

/// A cube with corners at ±`unit`.
fn cube(unit: &str) -> String {
    let sign = |bit: usize| if bit == 0 { "-" } else { "" };
    let point =
        |k: usize| format!("v {}{unit} {}{unit} {}{unit}\n", sign(k & 1), sign(k & 2), sign(k & 4));
    let points: String = (0..8).map(point).collect();
    points + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
}

/// What f64 cannot hold is refused: nothing false is said of it.
#[test]
fn coordinates_and_tolerances_beyond_f64_are_refused() {
    for (unit, tolerance) in [("1e400", "1e399"), ("1e-320", "1e-322"), ("1e-990", "1e-991")] {
        let file = TemporaryFile::new("cube.obj", &cube(unit));
        for distance in ["parametric", "geometric"] {
            let asked = ["depth", "catmull-clark", "--mesh", file.path(), "--tolerance", tolerance];
            let asked = asked.into_iter().chain(["--distance", distance]).collect::<Vec<_>>();
            assert_parts(&refused(asked), &["another unit"]);
        }
    }
    let file = TemporaryFile::new("cube.obj", &cube("1"));
    let asked = ["depth", "catmull-clark", "--mesh", file.path(), "--tolerance", "1e-1000"];
    assert_parts(&refused(asked), &["2^-900"]);
}

/// |(121801/53747712)^(1/2)| = 0.04760421810071… is between the bounds that are printed, the longest edge is 2, and the
/// line of the depth says how it is measured.
#[test]
fn bounds_are_printed_outwards() {
    let file = TemporaryFile::new("cube.obj", &cube("1"));
    let asked = ["depth", "catmull-clark", "--mesh", file.path(), "--tolerance", "1/7"];
    let text = written(asked.into_iter().chain(["--distance", "parametric"]).collect::<Vec<_>>());
    let line = text.lines().find(|line| line.contains("distance at level 2")).expect("a distance");
    let bounds: Vec<f64> = line.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    // "2" of the level, the lower bound and the upper one.
    let exact = (121_801.0_f64 / 53_747_712.0).sqrt();
    assert!(bounds[1] < exact && exact < bounds[2] && bounds[2] < exact * 1.000_001, "{line}");
    assert!(
        text.contains("length at most 2\n")
            && text.contains("2 levels, at equal parameters; 1 is too few")
    );
    // Too small for sets of points: a note says so.
    let tiny = ["depth", "catmull-clark", "--mesh", file.path(), "--tolerance", "1e-6"];
    let text = written(tiny);
    assert!(text.contains("Note: the tolerance is less than"), "{text}");
    assert!(text.contains("levels, at equal parameters"), "{text}");
}

/// A search that is stopped says no more levels than are known before it.
#[test]
fn a_stopped_search_is_no_worse_than_the_guarantee() {
    let file = TemporaryFile::new("cube.obj", &cube("1"));
    for distance in ["parametric", "geometric"] {
        let asked = ["depth", "catmull-clark", "--mesh", file.path(), "--tolerance", "1e-5"];
        // The guarantee needs a part of a second, and more on a machine with much to do.
        let more = ["--distance", distance, "--seconds", "5", "--format", "json"];
        let text = written(asked.into_iter().chain(more).collect::<Vec<_>>());
        let found: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        let [level, known] =
            [&found["level"], &found["a_priori"]["level"]].map(serde_json::Value::as_u64);
        assert!(level.is_none_or(|level| Some(level) <= known), "{text}");
    }
}
