//! Schemes of files that state no offset.

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
