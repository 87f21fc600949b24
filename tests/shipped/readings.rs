//! How tables came about that are not what they are said to be.

use super::{found, project, table};
use subcert::shipped::{Early, Outcome, Reading};

#[test]
fn a_definition_that_was_rounded_before_it_was_used() {
    // 1.414·k, 1.732·k, and f32(√2)·k.
    for (define, cells, expected) in [
        ("sqrt(2)", ["1.41400", "2.82800", "4.24200", "5.65600"], Early::Places(3)),
        // 1.73205…: three digits are 1.732 rounded or cut; two are 1.73.
        ("sqrt(3)", ["1.73000", "3.46000", "5.19000", "6.92000"], Early::Places(2)),
        // 2.23606…: cut after two digits 2.23, rounded 2.24.
        ("sqrt(5)", ["2.23000", "4.46000", "6.69000", "8.92000"], Early::Cut(2)),
        (
            "sqrt(2)",
            ["1.4142135381698608", "2.8284270763397217", "4.242640614509583", "5.656854152679443"],
            Early::Single,
        ),
    ] {
        let text =
            format!("[define]\ng = '{define}'\n{}", table("f64", "'k = 1..4'", "k*g", &cells));
        let project = project(&text);
        let finding = found(&project);
        let reading = Some(Reading::Early("g".to_owned(), expected));
        assert_eq!(finding.reading, reading, "{cells:?}");
        assert_eq!(finding.outcome, Outcome::Otherwise);
        assert!(finding.has(Outcome::Otherwise) && !finding.has(Outcome::Refuted));
    }
}

/// Four numbers of which one fits no reading, and a table of one number, which a rounding explains too easily.
#[test]
fn what_is_not_explained_is_refuted() {
    let define = "[define]\ng = 'sqrt(2)'\n";
    let cells = ["1.41400", "2.82800", "4.34200", "5.65600"];
    let several = project(&format!("{define}{}", table("f64", "'k = 1..4'", "k*g", &cells)));
    assert_eq!((found(&several).reading, found(&several).outcome), (None, Outcome::Refuted));
    let one = project(&format!("{define}{}", table("f32", "", "7*g", &["9.80f"])));
    assert_eq!((found(&one).reading, found(&one).outcome), (None, Outcome::Refuted));
}

/// The weights of Warren, 3/(8n), where Loop's are said.
#[test]
fn another_convention() {
    let loops = "(5/8 - (3/8 + 1/4*cos(2*pi/n))^2)/n";
    let text = table("f32", "'n = 4..6'", loops, &["0.09375f", "0.075f", "0.0625f"]);
    let convention = "[[shipped.convention]]\nlabel = 'Warren'\nequals = '3/(8*n)'\n";
    let with = project(&format!("{text}{convention}"));
    assert_eq!(found(&with).reading, Some(Reading::Convention(0)));
    assert_eq!(found(&with).outcome, Outcome::Otherwise);
    let without = project(&text);
    assert_eq!(found(&without).outcome, Outcome::Refuted);
}
