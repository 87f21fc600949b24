//! `smoothness`, `jsr` and `range --smoothness`.

use super::{TemporaryFile, assert_parts, refused, written};
use serde_json::Value;

fn json<'a>(arguments: impl IntoIterator<Item = &'a str>) -> Value {
    let text = written(arguments.into_iter().chain(["--format", "json"]));
    serde_json::from_str(&text).expect("JSON")
}

#[test]
fn smoothness_as_text() {
    let text = written(["smoothness", "six-point:w=3/256"]);
    for part in [
        "sum rules",
        "of order 6",
        "up to degree 5, at the natural shift 0",
        "C^2",
        "C^3",
        "refuted",
        "6 - log_2(9)",
        "attained",
        "at least",
    ] {
        assert!(text.contains(part), "no `{part}` in {text}");
    }
    assert!(
        written(["smoothness", "four-point:w=1/2"])
            .contains("refuted: the differences do not tend to 0")
    );
}

#[test]
fn smoothness_as_json() {
    let four = json(["smoothness", "four-point:w=1/16"]);
    assert_eq!(
        (&four["sum_rules"], &four["generation"], &four["reproduction"]),
        (&4.into(), &3.into(), &3.into())
    );
    assert_eq!((&four["continuity"], &four["continuity_fails"]), (&1.into(), &2.into()));
    assert_eq!(four["natural_shift"]["exact"], "0");
    assert_eq!(
        (&four["support"][0]["exact"], &four["support"][1]["exact"]),
        (&"-3".into(), &"3".into())
    );
    let hoelder = &four["hoelder"];
    assert_eq!(
        (&hoelder["lower"], &hoelder["upper"]),
        (&"2.000000000000".into(), &"2.000000000000".into())
    );
    assert_eq!((&hoelder["exact"], &hoelder["attained"]), (&"2".into(), &false.into()));
    let divergent = json(["smoothness", "four-point:w=1/2"]);
    assert_eq!(
        (&divergent["continuity"], &divergent["continuity_fails"]),
        (&Value::Null, &0.into())
    );
    assert_eq!(divergent["hoelder"], Value::Null);
}

#[test]
fn ranges_of_smoothness() {
    let range =
        json(["range", "ternary-four-point", "--param", "mu", "--smoothness", "2", "-c", "1"]);
    assert_eq!(range["outside"][0]["high"]["exact"], "1/15");
    assert_eq!(range["outside"][1]["low"]["exact"], "1/9");
    let gap: f64 = range["gap"].as_str().expect("a decimal").parse().expect("a number");
    assert!(gap <= 1e-3);
}

#[test]
fn radii_of_files() {
    let pair = json(["jsr", "examples/pair.txt"]);
    assert_eq!(
        (&pair["lower"], &pair["upper"]),
        (&"3.917384715148".into(), &"3.917384715149".into())
    );
    assert_eq!((&pair["exact"], &pair["product"]), (&true.into(), &Value::from(vec![0, 1])));
}

#[test]
fn bad_input_of_these() {
    let jsr = |name: &str, text: &str| {
        let file = TemporaryFile::new(name, text);
        refused(["jsr", file.path()])
    };
    assert_parts(&jsr("words.txt", "1 2\n3 four\n"), &["line 2", "`four`"]);
    assert_parts(&jsr("ragged.txt", "1 2\n3\n"), &["row 2 of matrix 1 has 1 entries, not 2"]);
    assert_parts(&jsr("sizes.txt", "1\n\n1 2\n3 4\n"), &["matrix 2 has 2 rows"]);
    assert_parts(&jsr("empty.txt", "# nothing\n"), &["0 matrices", "empty line between"]);
    assert_parts(&refused(["jsr", "nowhere.txt"]), &["nowhere.txt"]);
    assert_parts(&refused(["smoothness", "chaikin x chaikin"]), &["tensor product"]);
    assert_parts(&refused(["smoothness", "doo-sabin:n=5"]), &["needs a mask"]);
    let rule = vec!["'1/60'"; 60].join(", ");
    let long =
        TemporaryFile::new("long.toml", &format!("name = \"long\"\nmask = [[{rule}], [{rule}]]\n"));
    assert_parts(&refused(["smoothness", long.path()]), &["too long", "from 1 to 24"]);
    let range = |m| refused(["range", "four-point", "--param", "w", "--smoothness", m]);
    assert_parts(&range("2"), &["sum rules of order 3", "order 2"]);
    assert_parts(&range("-1"), &["no whole number"]);
}
