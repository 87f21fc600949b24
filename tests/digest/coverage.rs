//! What papers number, and what of it is claimed.

use proptest::prelude::*;
use subcert::audit::{CoverageState, audit};
use subcert::claim::{Label, Paper, embedded, read_paper};
use subcert::diagnostic::{Diagnostic, SourceText};

fn texts(labels: Result<Vec<Label>, String>) -> Vec<String> {
    labels.unwrap_or_else(|error| panic!("{error}")).iter().map(Label::to_string).collect()
}

#[test]
fn lists_and_ranges() {
    let cases: [(&str, &[&str]); 7] = [
        ("(3)", &["(3)"]),
        ("(9)-(11)", &["(9)", "(10)", "(11)"]),
        ("(2.9) – (2.11)", &["(2.9)", "(2.10)", "(2.11)"]),
        ("(3.4a)-(3.4c), (3.6)", &["(3.4a)", "(3.4b)", "(3.4c)", "(3.6)"]),
        ("Theorem 1-2", &["Theorem 1", "Theorem 2"]),
        ("Corollary 2.1-2.2", &["Corollary 2.1", "Corollary 2.2"]),
        ("Table 3-Table 4", &["Table 3", "Table 4"]),
    ];
    for (list, expected) in cases {
        assert_eq!(texts(Label::list(list)), expected, "{list}");
    }
    let refused: [(&str, &str); 14] = [
        ("", "`` is neither a numbered item"),
        ("3", "`3` is neither a"),
        ("(3", "`(3` is neither a"),
        ("(3))", "`(3))` is neither a"),
        ("(x)", "`(x)` is neither a"),
        ("Theorm 1", "`Theorm 1` is neither a"),
        ("Theorem 1st", "`Theorem 1st` is neither a"),
        ("(3) and (4)", "`(3) and (4)` is neither a"),
        ("(4)-(3)", "(4) to (3) is not a range"),
        ("(2.1)-(3.2)", "(2.1) to (3.2) is not a range"),
        ("(3.4a)-(3.5c)", "(3.4a) to (3.5c) is not a range"),
        ("(3.4a)-(3.4)", "(3.4a) to (3.4) is not a range"),
        ("Table 1-Theorem 2", "Table 1 to Theorem 2 is not a range"),
        ("(1)-(4000000000)", "more than 1000"),
    ];
    for (list, expected) in refused {
        let error = Label::list(list).expect_err(list);
        assert!(error.contains(expected), "no `{expected}` in: {error}");
    }
}

#[test]
fn what_a_locus_names() {
    let cases: [(&str, &[&str]); 10] = [
        ("(21), (23), (26)", &["(21)", "(23)", "(26)"]),
        ("(2.12) with (2.4)", &["(2.12)"]),
        ("(26) against (6)", &["(26)"]),
        ("before (3.8)", &[]),
        ("(34) under (2)", &["(34)"]),
        ("(1), the rules for q_{2i-1}", &["(1)"]),
        ("Corollary 3, (17)", &["Corollary 3", "(17)"]),
        ("Remark 2.2, α_2 in [0, 1]", &["Remark 2.2"]),
        // A word that only begins like one of the five ends nothing.
        ("withheld Table 2", &["Table 2"]),
        ("f(3), MyTable 2", &[]),
    ];
    for (locus, expected) in cases {
        assert_eq!(texts(Label::in_locus(locus)), expected, "{locus}");
    }
}

proptest! {
    /// A list of labels reads back as itself, and a range is what it spells out.
    #[test]
    fn labels_read_back(section in 1_u32..20, from in 1_u32..50, length in 0_u32..40) {
        for (open, close) in [("(", ")"), ("Lemma ", "")] {
            let one = |number: u32| format!("{open}{section}.{number}{close}");
            let all: Vec<String> = (from..=from + length).map(one).collect();
            prop_assert_eq!(&texts(Label::list(&all.join(", "))), &all);
            let range = format!("{}-{}", one(from), one(from + length));
            prop_assert_eq!(&texts(Label::list(&range)), &all);
            prop_assert_eq!(&texts(Label::in_locus(&format!("{range}, x"))), &all);
        }
    }
}

const HEAD: &str = "key = 'k'\n[paper]\nauthors = ['A']\ntitle = 't'\nvenue = 'v'\nyear = '1'\n";

fn read(text: &str) -> Result<Paper, Diagnostic> {
    read_paper(&SourceText::new("k.toml", format!("{HEAD}{text}")))
}

fn equation(id: &str, locus: &str) -> String {
    format!("[[equation]]\nid = '{id}'\nlocus = '{locus}'\nleft = '1'\nright = '1'\n")
}

fn unclaimed(locus: &str) -> String {
    format!("[[unclaimed]]\nlocus = '{locus}'\nreason = 'a definition'\n")
}

#[test]
fn every_item_is_claimed_excused_or_missing() {
    let text = [
        "numbered = ['(1)-(3)', '(4a)-(4b)', 'Table 1']\n".to_owned(),
        equation("one", "(1), (2) with (3)"),
        equation("whole", "(4)"),
        equation("letter", "(4b), second rule of (4b)"),
        unclaimed("(3)"),
    ];
    let paper = read(&text.concat()).unwrap_or_else(|error| panic!("{error}"));
    let audit = audit(&paper).unwrap_or_else(|error| panic!("{error}"));
    let coverage = audit.coverage();
    let rows: Vec<(String, Vec<&str>, &str)> = coverage
        .iter()
        .map(|coverage| {
            let ids = coverage.claims.iter().map(|claim| claim.id).collect();
            (coverage.item.label.to_string(), ids, coverage.state().name())
        })
        .collect();
    let row = |label: &str, ids: &[&'static str], state| (label.to_owned(), ids.to_vec(), state);
    assert_eq!(
        rows,
        [
            row("(1)", &["one"], "claimed"),
            row("(2)", &["one"], "claimed"),
            row("(3)", &[], "unclaimed"),
            row("(4a)", &["whole"], "claimed"),
            row("(4b)", &["whole", "letter"], "claimed"),
            row("Table 1", &[], "missing"),
        ]
    );
    assert_eq!(coverage[5].state(), CoverageState::Missing);
}

#[test]
fn contents_that_do_not_fit_are_errors() {
    let numbered = "numbered = ['(1)-(3)']\n";
    let cases = [
        ("numbered = ['(1)-(3)', '(2)']\n".to_owned(), "(2) is listed twice", "'(2)'"),
        ("numbered = ['(1)-']\n".to_owned(), "neither a numbered item", "'(1)-'"),
        (numbered.to_owned() + &equation("e", "(4)"), "(4) is not among", "'(4)'"),
        (numbered.to_owned() + &equation("e", "(3)-(1)"), "is not a range", "'(3)-(1)'"),
        (numbered.to_owned() + &unclaimed("(4)"), "(4) is not among", "'(4)'"),
        (unclaimed("(4)"), "(4) is not among", "'(4)'"),
        (numbered.to_owned() + &unclaimed("nothing"), "neither a numbered item", "'nothing'"),
        (
            numbered.to_owned() + &equation("e", "(1), (2)") + &unclaimed("(2)-(3)"),
            "(2) is claimed, by `e`",
            "'(2)-(3)'",
        ),
        (
            numbered.to_owned() + &unclaimed("(1)-(2)") + &unclaimed("(2), (3)"),
            "(2) has two reasons",
            "'(2), (3)'",
        ),
    ];
    for (text, message, place) in cases {
        let error = read(&text).err().unwrap_or_else(|| panic!("{text}: no error"));
        assert!(error.to_string().contains(message), "no `{message}` in: {error}");
        assert_eq!(&error.source.text[error.span.clone()], place, "{error}");
    }
}

/// Nothing of these papers is neither claimed nor excused.
#[test]
fn nothing_of_four_papers_is_missing() {
    for embedded in embedded().iter().filter(|paper| paper.key != "khan2022-doo-sabin") {
        let source = SourceText::new(embedded.key, embedded.text);
        let paper = read_paper(&source).unwrap_or_else(|error| panic!("{error}"));
        assert!(!paper.contents.is_empty());
        for item in paper.contents {
            assert!(!item.claims.is_empty() || item.reason.is_some(), "{}", item.label);
        }
    }
}
