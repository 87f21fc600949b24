//! Numbers whose last digits were cut.

use crate::common::claims::{HEAD, judged, paper};
use subcert::audit::{Direction, Verdict};
use subcert::certificate::certificate;
use subcert_check::{Outcome, check};

/// Of a number that is cut some digit is left: `0` is no 5/8, and `0.0` no 0.0625 that is cut; 0.06 is.
#[test]
fn a_zero_is_no_number_that_is_cut() {
    let table = |printed: &str, value: &str| {
        format!(
            "[[table]]\nid = 't'\nlocus = 'T'\nvalue = '{value}'\ncolumns = {{ name = 'c', values = ['1'] }}\ncells = [['{printed}']]\n"
        )
    };
    for (printed, value, verdict) in [
        ("0", "5/8", Verdict::Refuted),
        ("0", "-5/8", Verdict::Refuted),
        ("0", "1/2", Verdict::Confirmed),
        ("0.0", "1/16", Verdict::Refuted),
        ("0.06", "67/1000", Verdict::Rounding(Direction::Cut)),
    ] {
        let claims = table(printed, value);
        let paper = paper(&claims);
        let audit = judged(&paper);
        assert_eq!(audit.tables[0].cells[0][0].verdict, verdict, "{printed} for {value}");
        let text = certificate(&audit).text;
        let check = |text: &str| {
            let report = check(&format!("{HEAD}{claims}"), &[text]).expect("a claim file");
            report.claims.into_iter().next().expect("a claim").2
        };
        assert_eq!(check(&text), Outcome::Valid, "{text}");
        let cut = text.replacen("refuted", "rounding cut", 1);
        assert!(cut == text || check(&cut) != Outcome::Valid, "{cut}");
    }
}
