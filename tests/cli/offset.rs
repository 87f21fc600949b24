//! Schemes of files that state no offset, or have a wrong coefficient.

use super::{TemporaryFile, written};

/// Chaikin's mask with each rule moved one coefficient: σ = 5/4 at offset 0, 1/4 at offset -1.
const MOVED: &str = "name = 'moved'\nmask = [['0', '3/4', '1/4'], ['0', '1/4', '3/4']]\n";

fn answers(file: &TemporaryFile) -> [String; 2] {
    let path = file.path();
    [written(["constants", path]), written(["depth", path, "--tolerance", "1/100"])]
}

#[test]
fn a_better_offset_is_named_and_then_taken() {
    let file = TemporaryFile::new("moved.toml", MOVED);
    for text in answers(&file) {
        let flat = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(flat.contains("states no offset, so it is 0, with σ = 1.25."), "{flat}");
        assert!(flat.contains("At offset -1 σ is 0.25"), "{flat}");
        assert!(flat.contains("beside the mask: offset = '-1'"), "{flat}");
    }
    let json = written(["depth", file.path(), "--tolerance", "1/100", "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(json["better_offsets"][0]["offset"], -1);
    let better = TemporaryFile::new("better.toml", &format!("offset = '-1'\n{MOVED}"));
    let stated = TemporaryFile::new("stated.toml", &format!("offset = '0'\n{MOVED}"));
    for file in [&better, &stated] {
        for text in answers(file) {
            assert!(!text.contains("states no offset"), "{text}");
        }
    }
    let better = written(["depth", better.path(), "--tolerance", "1/100", "--format", "json"]);
    let better: serde_json::Value = serde_json::from_str(&better).expect("JSON");
    let sound = |json: &serde_json::Value| json["sound"]["depth"].as_u64().expect("a depth");
    assert!(sound(&better) < sound(&json));
}

#[test]
fn the_best_offset_needs_no_words() {
    let best = "name = 'chaikin'\nmask = [['3/4', '1/4'], ['1/4', '3/4']]\n";
    let file = TemporaryFile::new("best.toml", best);
    for text in answers(&file) {
        assert!(!text.contains("states no offset"), "{text}");
    }
}

/// The cubic B-spline, one coefficient moved: both rules sum to 1, but they differ by 1/4 in how they move lines.
#[test]
fn a_mask_that_does_not_keep_lines_is_named() {
    let rules = |first: &str| format!("name = 'm'\nmask = [{first}, ['0', '1/2', '1/2']]\n");
    for (first, warns) in [("['1/8', '3/4', '1/8']", false), ("['2/8', '5/8', '1/8']", true)] {
        let file = TemporaryFile::new("lines.toml", &rules(first));
        for scheme in [file.path().to_owned(), format!("b-spline:degree=1 x {}", file.path())] {
            let text = written(["constants", &scheme]);
            let flat = text.split_whitespace().collect::<Vec<_>>().join(" ");
            let named =
                flat.contains("Lines are not kept") && flat.contains("rule to rule: -1.75, -2.");
            assert_eq!(named, warns, "{flat}");
            let json = written(["constants", &scheme, "--format", "json"]);
            let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
            let directions = json["directions"].as_array().expect("directions");
            assert_eq!(directions.last().expect("one")["keeps_lines"], !warns);
        }
    }
}
