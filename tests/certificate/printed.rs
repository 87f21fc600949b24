//! Printed numbers: the program and the checker read the same ones, and nothing false is accepted of a fraction.

use crate::common::claims::{HEAD, judged};
use proptest::prelude::*;
use subcert::audit::audit;
use subcert::certificate::certificate;
use subcert::claim::read_paper;
use subcert::diagnostic::SourceText;
use subcert_check::{Outcome, check};

/// A table of one cell.
fn table(value: &str, header: &str, cell: &str) -> String {
    format!(
        "[[table]]\nid = 't'\nlocus = 'T'\nvalue = '{value}'\n\
         columns = {{ name = 'c', values = ['{header}'] }}\ncells = [['{cell}']]\n"
    )
}

fn checked(claims: &str, certificate: &str) -> Outcome {
    let report = check(&format!("{HEAD}{claims}"), &[certificate]).expect("a claim file");
    report.claims.into_iter().next().expect("a claim").2
}

/// Texts of which a good part are numbers.
fn near_number() -> impl Strategy<Value = String> {
    prop_oneof![
        "[-−–+]? ?[0-9]{0,3}(\\.[0-9]{0,3})?((e|E| ?[×x·*] ?10\\^)[-−+]?[0-9]{1,2})?",
        "[-−–+]? ?[0-9]{0,3}( ?[/⁄∕] ?[-+]?[0-9]{1,3}|[½⅔⅛⅒↉])?",
        "[-−–—]{0,4}",
        "[-−–+0-9./⁄eE×x*^½⅛ ]{0,8}",
    ]
}

proptest! {
    #![proptest_config(crate::common::cases(2_000))]

    /// What the program says of a cell under a header, the checker accepts.
    #[test]
    fn cells_and_headers(value in "(1/3|1/2|5|c|1/8)", header in near_number(), cell in near_number()) {
        let claims = table(&value, &header, &cell);
        if let Ok(paper) = read_paper(&SourceText::new("k.toml", format!("{HEAD}{claims}"))) {
            let text = certificate(&judged(&paper)).text;
            prop_assert_eq!(checked(&claims, &text), Outcome::Valid, "{}: {}", claims, text);
        }
    }

    /// Formulas have the same values in both.
    #[test]
    fn numbers_in_formulas(
        parts in prop::collection::vec(("[0-9]{0,2}(\\.[0-9]{0,2})?(e-?[0-9])?|[0-9]?[½⅔⅛]", "[-−–+*·×/⁄∕^]"), 1..4),
    ) {
        let text: Vec<String> = parts.iter().map(|(number, sign)| format!("{number} {sign}")).collect();
        let text = text.join(" ");
        let text = text.trim_end_matches(|c: char| "-−–+*·×/⁄∕^".contains(c));
        let claims = table(text, "1", "1");
        if let Ok(paper) = read_paper(&SourceText::new("k.toml", format!("{HEAD}{claims}"))) {
            // A name such as e1 has no value.
            let Ok(audit) = audit(&paper) else { return Ok(()) };
            if audit.tables[0].cells[0][0].exact.is_some() {
                let text = certificate(&audit).text;
                prop_assert_eq!(checked(&claims, &text), Outcome::Valid, "{}: {}", claims, text);
            }
        }
    }
}

/// Lines that say of a fraction what is true of a decimal alone, and of a blank cell what is said of numbers.
#[test]
fn what_is_false_is_not_accepted() {
    for (value, cell, line, valid) in [
        ("1/3", "1/3", "\"1/3\" 1/3 confirmed", true),
        ("1/3", "2/6", "\"2/6\" 1/3 confirmed", true),
        ("0.3333", "1/3", "\"1/3\" 0.3333 confirmed", false),
        ("0.3334", "1/3", "\"1/3\" 0.3334 rounding cut", false),
        ("0.3333", "1/3", "\"1/3\" 0.3333 rounding away", false),
        ("12.345678", "123456/1000", "\"123456/1000\" 12.345678 misprint exponent 1", false),
        ("1.23456", "123456/10000", "\"123456/10000\" 1.23456 misprint exponent 1", false),
        ("-12345/7", "12345/7", "\"12345/7\" -12345/7 misprint sign", true),
        ("12346/7", "12345/7", "\"12345/7\" 12346/7 misprint digit 4", false),
        ("1/3", "", "blank 1/3", true),
        ("1/3", "—", "blank 1/3", true),
        ("1/3", "—", "lost 1/3", false),
        ("1/3", "1/3", "blank 1/3", false),
        ("1/3", "", "\"\" 1/3 confirmed", false),
        ("1/3", "—", "\"—\" 1/3 refuted", false),
        ("1/3", "1/3", "lost 1/3", false),
    ] {
        let claims = table(value, "1", cell);
        let certificate = format!(
            "subcert-certificate 4\npaper k\ntable t\n  value {value}\n  cell 1 1 {line}\nend 1\n"
        );
        let found = checked(&claims, &certificate);
        assert_eq!(found == Outcome::Valid, valid, "{line}: {found:?}");
    }
}
