//! Claims about smoothness in words, and as JSON.

use crate::common::claims::{judged, paper};
use subcert::report::html::audit_page;
use subcert::report::json::AuditReport;
use subcert::report::{Background, audit_sheet, errata_sheet, explain_sheet};

const CLAIMS: &str = "[[smoothness]]\nid = 's'\nlocus = 'Theorem 1'\ntitle = 'Too smooth'\nscheme = 'chaikin'\n\
                      continuous = '2'\n\
                      [[smoothness]]\nid = 'a'\nlocus = 'Theorem 2'\nabsent = 'the mask'\n\
                      [[exponent]]\nid = 'e'\nlocus = 'Theorem 3'\nscheme = 'six-point:w=3/256'\nprinted = '2.830'\n\
                      [[range]]\nid = 'r'\nlocus = 'Theorem 4'\nscheme = 'four-point:w=w'\nvariable = 'w'\n\
                      smoothness = '1'\nfrom = '0'\nto = '1/5'\n";

#[test]
fn reports_say_what_is_stated_and_what_is_known() {
    let paper = paper(CLAIMS);
    let audits = [judged(&paper)];
    let words = |text: String| text.split_whitespace().collect::<Vec<&str>>().join(" ");
    let report = words(audit_sheet(&audits, false).to_text(None));
    for part in [
        "Theorem 1 and Theorem 4 are refuted: 2 of 4 statements about smoothness.",
        "✗ Theorem 1 Too smooth · s states: the limits are C² the limits are C¹, and not all limits are C²; \
         Hölder exponent 2, attained",
        "? Theorem 2 a not checkable without the mask",
        "✗ Theorem 4 r states: the limits are C¹ for 0 < w < 1/5",
    ] {
        assert!(report.contains(part), "{part} is not in {report}");
    }
    // What is confirmed is shown with `--all`.
    assert!(!report.contains("Theorem 3"));
    let whole = words(audit_sheet(&audits, true).to_text(None));
    assert!(whole.contains("✓ Theorem 3 e states: the Hölder exponent is 2.830"), "{whole}");
    let explained = explain_sheet(&audits, "k:e", Background::default(), false).expect("a claim");
    let explained = words(explained.to_text(None));
    assert!(explained.contains("✓ confirmed the limits are C², and not all limits are C³"));
    assert!(explained.contains("matrices 2, "), "{explained}");
    let errata = words(errata_sheet(&audits).to_text(None));
    assert!(errata.contains("1. Theorem 1 · ✗ refuted") && errata.contains("2. Theorem 4 · ✗"));
}

#[test]
fn json_has_the_bounds() {
    let paper = paper(CLAIMS);
    let audits = [judged(&paper)];
    let report = serde_json::to_value(AuditReport::of(&audits)).expect("JSON");
    let claims = &report["papers"][0]["claims"];
    assert_eq!(claims[0]["kind"], "smoothness");
    assert_eq!(claims[0]["printed"], "the limits are C^2");
    assert_eq!(claims[0]["limits"]["continuity"], 1);
    assert_eq!(claims[0]["limits"]["continuity_fails"], 2);
    assert_eq!(claims[1]["verdict"], "not-checkable");
    assert_eq!(claims[1]["printed"], serde_json::Value::Null);
    assert_eq!(claims[2]["limits"]["hoelder"]["exact"], "6 - log_2(9)");
    assert_eq!(claims[2]["limits"]["hoelder"]["lower"], "2.830074998557");
    assert_eq!(claims[3]["kind"], "range");
    let at = claims[3]["parameter"]["refuted_at_decimal"].as_str().expect("a value");
    assert!(at.starts_with("0.19"), "{at}");
    assert_eq!(report["papers"][0]["summary"]["refuted"], 2);
}

const TABLES: &str = "[[regularity]]\nid = 't'\nlocus = 'Table 1'\ntitle = 'Three schemes'\nnote = 'Of the authors.'\n\
                      rows = { schemes = ['chaikin', { printed = 'DD4', scheme = 'four-point:w=1/16' }] }\n\
                      columns = ['order', 'exponent']\ncells = [[1, '2.000'], [{ printed = 'C²', read = '2', note = 'n' }, '-']]\n\
                      [[regularity]]\nid = 'u'\nlocus = 'Table 2'\nscheme = 'four-point:w=w'\n\
                      rows = { name = 'w', values = ['3/64'] }\ncolumns = ['exponent']\ncells = [['1.415']]\n";

#[test]
fn a_table_of_orders_and_exponents_has_its_shape_and_a_verdict_in_each_cell() {
    let paper = paper(TABLES);
    let audits = [judged(&paper)];
    let report = audit_sheet(&audits, false).to_markdown();
    assert!(
        report.contains("| scheme | order | exponent |\n| --- | --: | --: |\n| chaikin | 1 ✓ | 2.000 ✓ |\n| DD4 | C² ✗ | · |"),
        "{report}"
    );
    assert!(report.contains(
        "- ✗ Table 1 (DD4, order): Three schemes · t.2.order<br>states: the limits are C²"
    ));
    // What is confirmed throughout is shown with `--all`.
    assert!(!report.contains("Table 2"), "{report}");
    assert!(
        audit_sheet(&audits, true)
            .to_markdown()
            .contains("| w | exponent |\n| --- | --: |\n| 3/64 | 1.415 ✓ |")
    );
    let explained = explain_sheet(&audits, "k:u.1.exponent", Background::default(), false);
    let explained = explained.expect("a claim").to_markdown();
    assert!(explained.contains("- scheme: four-point:w=w, w = 3/64"), "{explained}");
    let errata = errata_sheet(&audits).to_markdown();
    assert!(errata.contains("## 1. Table 1 (DD4, order) · ✗ refuted"), "{errata}");
    let page = audit_page(&audits[0], None, None).expect("a page");
    assert!(
        page.contains("<td class=\"cell wrong\"><a class=\"leads\" href=\"#t.2.order\">C² "),
        "{page}"
    );
}

/// Where a paper does not say whether the ends belong to a range, none of them is printed as if it did.
#[test]
fn ends_that_are_neither_open_nor_closed() {
    let range = |fields: &str| {
        let claims = format!(
            "[[range]]\nid = 'r'\nlocus = 'R'\nvariable = 'w'\nvalue = 'w^2'\nbelow = '1/4'\n{fields}\n"
        );
        let paper = paper(&claims);
        audit_sheet(&[judged(&paper)], true).to_text(None)
    };
    for (fields, said) in [
        ("from = '0'\nto = '0.3'", "printed w from 0 to 0.3;"),
        ("from = '0'", "printed w from 0 on;"),
        ("to = '0.3'", "printed w up to 0.3;"),
        ("from = '0'\nto = '0.3'\nclosed = true", "printed 0 ≤ w ≤ 0.3;"),
        ("from = '0'\nto = '0.3'\nclosed = false", "printed 0 < w < 0.3;"),
    ] {
        let text = range(fields);
        assert!(text.contains(said), "{text}");
    }
}
