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
        "C²",
        "C³",
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
    for (goal, holds) in [("4", true), ("47/12", false), ("1e9", true)] {
        let said = json(["jsr", "examples/pair.txt", "--below", goal]);
        assert_eq!(said["below"]["holds"], Value::from(holds), "{said}");
    }
    // A line of a comment is not empty.
    let commented = "3 3 # a row\n# between the rows of one matrix\n-2 1\n\n-1 -1\n-4 0\n";
    let commented = TemporaryFile::new("commented.txt", commented);
    assert_eq!(json(["jsr", commented.path()])["upper"], pair["upper"]);
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
    let goal = refused(["jsr", "examples/pair.txt", "--below", "0"]);
    assert_parts(&goal, &["--below"]);
    assert_parts(&written(["smoothness", "chaikin x chaikin"]), &["C¹, not C²"]);
    assert_parts(&refused(["smoothness", "loop", "--valences", "3..100000"]), &["up to 100"]);
    assert_parts(&refused(["smoothness", "loop:N=2"]), &["needs N >= 3"]);
    assert_parts(
        &refused(["smoothness", "doo-sabin:n=5", "--certificate", "-"]),
        &["is for masks"],
    );
    let rule = vec!["'1/60'"; 60].join(", ");
    let long =
        TemporaryFile::new("long.toml", &format!("name = \"long\"\nmask = [[{rule}], [{rule}]]\n"));
    assert_parts(&refused(["smoothness", long.path()]), &["too long", "from 1 to 64"]);
    // The one parameter of a scheme needs no name, and a name no flag.
    let named = written(["range", "four-point", "--param", "w", "-c", "1"]);
    assert_eq!(written(["range", "four-point", "-c", "1"]), named);
    assert_eq!(written(["range", "four-point", "w", "-c", "1"]), named);
    let range = |m| refused(["range", "four-point", "--param", "w", "--smoothness", m]);
    assert_parts(&range("2"), &["sum rules of order 3", "order 2", "w = 1/16 (order 4)"]);
    let special = written(["range", "four-point", "--param", "w", "--smoothness", "1"]);
    let rows = ["Special values", "1/16   4", "-3 to 3   C¹, not C²"];
    assert!(rows.iter().all(|row| special.contains(row)), "{special}");
    assert_parts(&range("-1"), &["not a whole number"]);
}

#[test]
fn irrational_coefficients() {
    let text = written(["smoothness", "examples/daubechies-4.toml"]);
    for part in [
        "polynomials in t, t = 1.73205080757 a root of -3 + t²",
        "2 - log_2(x), x = 2.73205080757 the root of x² - 2x - 2 from 2 to 3",
    ] {
        assert!(text.contains(part), "no `{part}` in {text}");
    }
    let four = json(["smoothness", "examples/daubechies-4.toml"]);
    assert_eq!(four["field"]["minimal_polynomial"], "-3 + t^2");
    assert_eq!(four["radius"]["matrices"][0][0][0], "1 + t");
    assert!(json(["smoothness", "four-point:w=1/16"]).get("field").is_none());
    // The value of a parameter may be irrational as well.
    let w = json(["smoothness", "four-point:w=(sqrt(5) - 1)/8"]);
    assert_eq!((&w["continuity"], &w["sum_rules"]), (&1.into(), &2.into()));
    // Where a root is rational, so is the mask.
    let rational = json(["smoothness", "four-point:w=sqrt(1/256)"]);
    assert_eq!(rational["hoelder"]["exact"], "2");
}

#[test]
fn other_commands_take_rational_masks_only() {
    let mine = "examples/daubechies-4.toml";
    for command in [
        &["constants", mine][..],
        &["depth", mine, "--tolerance", "1/100"],
        &["certify", mine],
        &["oracle", mine],
        &["constants", "four-point:w=sqrt(2)/32"],
        &["constants", "chaikin x four-point:w=sqrt(2)/32"],
    ] {
        let error = refused(command.iter().copied());
        assert_parts(
            &error,
            &["is not rational", "`subcert scheme`, `smoothness`, `plot` and `table` take"],
        );
    }
    let range = ["range", "four-point:w=sqrt(2)*v", "--param", "v"];
    assert_parts(&refused(range), &["is not a polynomial in `v` with rational coefficients"]);
}

#[test]
fn bad_roots() {
    let file = |text: &str| {
        let mask =
            format!("name = \"mine\"\nmask = [[\"{text}\", \"1 - ({text})\"], [\"1\", \"0\"]]\n");
        TemporaryFile::new("irrational-mask.toml", &mask)
    };
    for (text, part) in [
        ("sqrt(-3)", "the square root of the negative number -3"),
        ("root([1, 0, 1], 1)", "the polynomial has 0 real roots"),
        ("root(3, 1)", "expected a list of coefficients"),
        (
            "root([-2, 0, 0, 0, 0, 1], 1) + root([-3, 0, 0, 0, 0, 1], 1)",
            "a field of degree above 24",
        ),
    ] {
        let file = file(text);
        assert_parts(&refused(["smoothness", file.path()]), &[part, "irrational-mask.toml:2"]);
    }
    let wrong = file("sqrt(3)");
    let text = std::fs::read_to_string(wrong.path()).expect("a file").replace("1 - (sqrt(3))", "1");
    let wrong = TemporaryFile::new("irrational-sum.toml", &text);
    assert_parts(
        &refused(["smoothness", wrong.path()]),
        &["rule 0 sums to 1 + t", "irrational-sum.toml:2"],
    );
}

#[test]
fn maps_of_two_parameters() {
    let map = |extra: &[&'static str]| {
        let base = ["range", "examples/primal.toml", "--param", "a", "--param", "b"];
        base.into_iter().chain(extra.iter().copied()).collect::<Vec<&str>>()
    };
    let wanted = ["--smoothness", "1", "--boxes", "21", "--bounds", "a=-1/4..1/4,b=-1/4..1/2"];
    let found = json(map(&wanted));
    assert_eq!(found["parameters"], serde_json::json!(["a", "b"]));
    assert_eq!(found["bounds"], serde_json::json!([["-1/4", "1/4"], ["-1/4", "1/2"]]));
    let boxes = found["boxes"].as_array().expect("boxes");
    let states: std::collections::BTreeSet<&str> =
        boxes.iter().map(|found| found["state"].as_str().expect("a word")).collect();
    assert!(states.contains("outside") && states.contains("open"), "{states:?}");
    let text = written(map(&wanted));
    assert!(text.contains("% of the area") && text.contains("from -1/4 to 1/2"), "{text}");
    for (extra, part) in [
        (&[][..], "add `--smoothness M`"),
        (&["--smoothness", "2"], "sum rules of order 3"),
        (&["--smoothness", "1", "--boxes", "0"], "from 1 to 20000 boxes"),
        (&["--smoothness", "1", "--bounds", "c=0..1"], "none of the parameters"),
        (&["--smoothness", "1", "--bounds", "a=1..0"], "is not below"),
        (&["--smoothness", "1", "--bounds", "a=0..1,a=0..1"], "has bounds already"),
        (&["--smoothness", "1", "--bounds", "a=0-1"], "there is no `..`"),
        (&["--smoothness", "1", "--bounds", "a=x..1"], "in `--bounds`"),
        (&["--smoothness", "1", "--param", "c"], "3 parameters; there are maps of up to two"),
    ] {
        assert_parts(&refused(map(extra)), &[part]);
    }
    let twice = ["range", "four-point", "--param", "w", "--param", "w", "--smoothness", "1"];
    assert_parts(&refused(twice), &["`--param w` is given twice"]);
    let one = ["range", "four-point", "--param", "w", "--smoothness", "1", "--boxes", "9"];
    assert_parts(&refused(one), &["give `--param` twice"]);
    let unused = ["range", "four-point", "--param", "w", "--param", "v", "--smoothness", "1"];
    assert_parts(&refused(unused), &["`v`"]);
}

#[test]
fn rules_at_a_vertex() {
    let page = written(["smoothness", "loop:N=5", "--format", "html"]);
    for part in
        ["<polyline", "least J", "<var>C</var><sup>1</sup> at valence 5: proved", "Reproduce"]
    {
        assert!(page.contains(part), "no `{part}`");
    }
    let range = ["range", "examples/loop-beta.toml", "--param", "beta", "--smoothness", "1"];
    let found = json(range.into_iter().chain(["--valences", "3..4"]));
    let first = &found["valences"][0];
    // |5/8 − 3β| < 1/4.
    assert_eq!(first["inside"][0]["low"]["exact"], "1/8");
    assert_parts(&refused(range.into_iter().chain(["--valences", "all"])), &["single valences"]);
    let other = ["range", "examples/loop-beta.toml:N=5", "--param", "beta"];
    assert_parts(&refused(other), &["--smoothness 1"]);
    assert_parts(
        &refused([
            "range",
            "four-point",
            "--param",
            "w",
            "--smoothness",
            "1",
            "--valences",
            "3..4",
        ]),
        &["not a ring of points"],
    );
}

#[test]
fn a_single_valence_is_a_range() {
    let of = |valences| written(["smoothness", "loop", "--valences", valences]);
    assert_eq!(of("5"), of("5..5"));
}

/// An end that is known has its name, with the distance that the proof leaves; JSON has the end of the proof.
#[test]
fn ends_of_ranges_have_their_names() {
    let range = ["range", "four-point", "--smoothness", "0"];
    let text = written(range);
    assert_parts(
        &text,
        &["|w| < 1/2, proved up to 2.5·10⁻⁵ of the ends", "w ≥ 1/2", "(-1 + √13)/8"],
    );
    assert!(!text.contains("/524288"), "{text}");
    let inside = &json(range)["inside"][0];
    let exact = ["low", "high"].map(|end| inside[end]["exact"].as_str().expect("an end"));
    assert_eq!(exact, ["-262133/524288", "262131/524288"]);
    let cubic = written(["audit", "proofs/claims/smoothness/hechler2009.toml", "--all"]);
    assert_parts(&cubic, &["0.192729249264… is a root of -1 + 4w + 32w³."]);
    let paper = ["audit", "proofs/claims/smoothness/rossignac2008.toml", "--all"];
    let audit = written(paper);
    assert_parts(&audit, &["the limits are C¹ for -2 < s < 6, proved up to 6.2·10⁻⁵ of the ends"]);
    assert!(!audit.contains("/16384") && !audit.contains("/32768"), "{audit}");
}
