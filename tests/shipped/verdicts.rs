//! Verdicts that follow by hand.

use super::{found, project, table};
use subcert::shipped::{Misprint, Outcome, Verdict};

fn verdict(kind: &str, equals: &str, cell: &str) -> Verdict {
    let project = project(&table(kind, "", equals, &[cell]));
    found(&project).cells[0].verdict
}

#[test]
fn of_numbers_that_are_right_to_their_digits() {
    for (kind, equals, cell, expected) in [
        ("f32", "1/3", "0.33333334f", Verdict::Nearest),
        ("f64", "1/3", "1.0/3.0", Verdict::Nearest),
        ("f64", "1/3", "1.0f/3.0f", Verdict::Refuted(7)),
        ("f64", "-1/3", "-0.3333333333333333", Verdict::Nearest),
        ("f32", "0", "0.0f", Verdict::Nearest),
        ("f32", "2/3", "0.667f", Verdict::Rounded(3)),
        ("f32", "2/3", "0.666f", Verdict::Cut(3)),
        ("f32", "-2/3", "-0.666f", Verdict::Cut(3)),
        ("f32", "2/3", "6.667e-1f", Verdict::Rounded(4)),
        // The digits begin with the first one that is not 0.
        ("f32", "2/300", "0.0067f", Verdict::Rounded(2)),
        ("decimal:4", "1/3", "0.3333", Verdict::Nearest),
        ("decimal:4", "1/3", "0.33", Verdict::Rounded(2)),
        ("decimal:4", "1/3", "0.3334", Verdict::Ulps(1)),
        // A tie of two decimals: either will do.
        ("decimal:1", "1/4", "0.2", Verdict::Nearest),
        ("decimal:1", "1/4", "0.3", Verdict::Nearest),
        // 1/3 lies between the doubles 0.33333333333333331483 and 0.33333333333333337034.
        ("f64", "1/3", "0.33333333333333337", Verdict::Ulps(1)),
        ("f64", "1/3", "0.33333333333333343", Verdict::Ulps(2)),
        ("f64", "1/3", "0x1.5555555555557p-2", Verdict::Ulps(2)),
    ] {
        assert_eq!(verdict(kind, equals, cell), expected, "{equals} as {cell}");
    }
}

/// The square root of 2 is 1.41421356…
#[test]
fn of_slips() {
    for (cell, expected) in [
        ("-1.41421f", Verdict::Misprint(Misprint::Sign)),
        ("14.1421f", Verdict::Misprint(Misprint::Point)),
        ("0.0141421f", Verdict::Misprint(Misprint::Point)),
        ("1.41521f", Verdict::Misprint(Misprint::Digit)),
        ("1.14421f", Verdict::Misprint(Misprint::Exchanged)),
        ("1.4421f", Verdict::Misprint(Misprint::Dropped)),
        // Two wrong digits, and one of the last two.
        ("1.51521f", Verdict::Refuted(0)),
        ("1.41431f", Verdict::Refuted(3)),
        // Too few digits for more than chance.
        ("-1.4f", Verdict::Refuted(0)),
    ] {
        assert_eq!(verdict("f32", "sqrt(2)", cell), expected, "{cell}");
    }
}

#[test]
fn of_wrong_numbers() {
    // 0.149 − 1/7 = 0.00614…, within 5 % of 1/7, and not within 0.5 %.
    assert_eq!(verdict("f32", "1/7", "0.1490f"), Verdict::Refuted(1));
    assert_eq!(verdict("f32", "1/7", "0.9f"), Verdict::Refuted(0));
    assert_eq!(verdict("f32", "0", "1e-9f"), Verdict::Refuted(0));
    assert_eq!(verdict("f64", "1", "0.99"), Verdict::Refuted(1));
}

/// Catmull–Clark's λ_5 is 0.54998835451…, a root of a polynomial in the field of cos(2π/5); the golden ratio and the
/// real root of x³ − x − 1, 1.3247179572….
#[test]
fn of_algebraic_numbers() {
    let lambda = "(cos(2*pi/5) + 5 + sqrt((cos(2*pi/5) + 9)*(cos(2*pi/5) + 1)))/16";
    assert_eq!(verdict("f32", lambda, "0.549988f"), Verdict::Rounded(6));
    assert_eq!(verdict("f64", lambda, "0.5499883545182972"), Verdict::Nearest);
    assert_eq!(verdict("f64", "root([-1, -1, 0, 1], 1)", "1.3247179572"), Verdict::Rounded(11));
    assert_eq!(verdict("f64", "2*cos(pi/5)", "(1.0 + 2.236067977499790) / 2.0"), Verdict::Nearest);
    // A number that is rational in disguise, at the very end of an interval.
    assert_eq!(
        verdict("decimal:2", "(sqrt(2) + sqrt(3))^2 - sqrt(24) - 4.995", "0.00"),
        Verdict::Nearest
    );
}

#[test]
fn of_tables() {
    let outcome = |cells: &[&str]| {
        let project = project(&table("f32", "\"k = 1..3\"", "k/3", cells));
        found(&project).outcome
    };
    assert_eq!(outcome(&["1.f/3.f", "0.6666667f", "1"]), Outcome::Nearest);
    assert_eq!(outcome(&["1.f/3.f", "0.667f", "1"]), Outcome::Cut);
    assert_eq!(outcome(&["0.33333337f", "0.667f", "1"]), Outcome::Ulps);
    assert_eq!(outcome(&["0.33333337f", "6.66667f", "1"]), Outcome::Misprint);
    assert_eq!(outcome(&["0.33333337f", "6.66667f", "2"]), Outcome::Refuted);
}

/// A value beyond a cap leaves its number open, and the others are judged.
#[test]
fn a_value_beyond_a_cap_is_open() {
    let fields = "'k = 1..2'";
    let project = project(&table("f64", fields, "2^(10^(9*k - 9)) - 1", &["1", "5"]));
    let finding = found(&project);
    let verdicts: Vec<Verdict> = finding.cells.iter().map(|cell| cell.verdict).collect();
    assert_eq!(
        (&verdicts[..], finding.outcome),
        (&[Verdict::Nearest, Verdict::Open][..], Outcome::Open)
    );
    let cap = finding.cells[1].exact.as_ref().err().map(ToString::to_string);
    assert!(cap.is_some_and(|cap| cap.starts_with("the power is too large; at most")));
    assert_eq!((&finding.cells[1].error, &finding.sums), (&None, &None));
}

/// Errors against tolerances that agree with them in more digits than are printed, and against 0 that is written in roots.
#[test]
fn errors_are_compared_exactly() {
    let zero = "sqrt(5 + 2*sqrt(6)) - sqrt(2) - sqrt(3)";
    for (equals, cell, tolerance, kept) in [
        (
            "sqrt(2)",
            "1.4142135623730951",
            "0.000000000000000096672933134529130371871688598255864426823320",
            false,
        ),
        (
            "sqrt(2)",
            "1.4142135623730951",
            "0.000000000000000096672933134529130371871688598255864426823329",
            true,
        ),
        (zero, "0.0", "1e-200", true),
        (zero, "1e-300", "1e-200", true),
        (zero, "1e-100", "1e-200", false),
    ] {
        let text = format!("{}tolerance = '{tolerance}'\n", table("f64", "", equals, &[cell]));
        let project = project(&text);
        let found = found(&project);
        let tolerance = &project.shipped[0].tolerance.as_ref().expect("a tolerance").1;
        assert_eq!(found.is_within(0, tolerance), Some(kept), "{equals}: {cell}");
        let error = found.cells[0].error.as_ref().expect("an error");
        assert_eq!(error.is_zero(), cell == "0.0", "{equals}: {cell}");
        assert_eq!(error <= tolerance || equals != zero, kept || equals != zero, "{cell}");
    }
}
