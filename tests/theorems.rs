//! Theorems as claims: reading, and what they rest on.

#![allow(missing_docs)]

use subcert::audit::{PaperAudit, TheoremFinding, audit};
use subcert::claim::{Paper, Quantity, Statement, read_paper};
use subcert::diagnostic::{Diagnostic, SourceText};

const HEAD: &str = "key = 'k'\n[paper]\nauthors = ['A']\ntitle = 't'\nvenue = 'v'\nyear = '1'\n";

fn read(text: &str) -> Result<Paper, Diagnostic> {
    read_paper(&SourceText::new("k.toml", format!("{HEAD}{text}")))
}

fn paper(text: &str) -> Paper {
    read(text).unwrap_or_else(|error| panic!("{error}"))
}

fn equation(id: &str, right: &str) -> String {
    format!("[[equation]]\nid = '{id}'\nlocus = '({id})'\nleft = '1'\nright = '{right}'\n")
}

fn theorem(id: &str, rests: &str) -> String {
    format!("[[theorem]]\nid = '{id}'\nlocus = 'Theorem {id}'\nsays = 'x'\nrests = [{rests}]\n")
}

fn failing(audit: &PaperAudit<'_>, id: &str) -> Vec<String> {
    let found = |finding: &&TheoremFinding<'_>| finding.theorem.id == id;
    let finding = audit.theorems.iter().find(found).expect("the theorem");
    finding.failing.iter().map(|premise| premise.id.to_owned()).collect()
}

#[test]
fn what_is_bounded_and_from_which_level_on() {
    let paper = paper(
        "[[theorem]]\nid = 'a'\nlocus = 'Theorem 1'\nbounds = 'step'\nby = 'beta/2^k'\nfrom = '1'\n\
         [[theorem]]\nid = 'b'\nlocus = 'Theorem 2'\nbounds = 'depth'\nby = 'levels(1/2, epsilon)'\n\
         [[theorem]]\nid = 'c'\nlocus = 'Remark 1'\nsays = 'something else'\n",
    );
    let [step, depth, other] = &paper.theorems[..] else { panic!("three theorems") };
    assert!(matches!(
        &step.statement,
        Statement::Bound { quantity: Quantity::Step, by, from: 1 } if by.text == "beta/2^k"
    ));
    assert!(matches!(&depth.statement, Statement::Depth(by) if by.text == "levels(1/2, epsilon)"));
    assert!(matches!(&other.statement, Statement::Other(says) if says == "something else"));
}

/// A theorem rests on what it names, and on what the theorems that it names rest on.
#[test]
fn failing_premises_are_followed_through_theorems() {
    let text = [
        equation("right", "1"),
        equation("wrong", "2"),
        equation("unused", "2"),
        theorem("first", "'right', 'wrong'"),
        theorem("second", "'first'"),
        theorem("third", "'right'"),
        // Two theorems that rest on each other are followed once.
        theorem("fourth", "'fifth', 'wrong'"),
        theorem("fifth", "'fourth'"),
        "[[table]]\nid = 'table'\nlocus = 'T'\nvalue = '1'\n\
         columns = { name = 'c', values = ['1', '2'] }\ncells = [['1', '5']]\n"
            .to_owned(),
        theorem("sixth", "'table', 'second'"),
    ];
    let paper = paper(&text.concat());
    let audit = audit(&paper).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(failing(&audit, "first"), ["wrong"]);
    assert_eq!(failing(&audit, "second"), ["wrong"]);
    assert!(failing(&audit, "third").is_empty());
    assert_eq!(failing(&audit, "fifth"), ["wrong"]);
    assert_eq!(failing(&audit, "sixth"), ["table", "wrong"]);
    assert_eq!(audit.theorem_counts().get("open"), Some(&6));
}

#[test]
fn malformed_theorems() {
    let bound = "bounds = 'distance'\nby = 'beta/2^k'\nfrom = '0'\n";
    let cases: [(&str, &str, &str); 10] = [
        ("", "needs `bounds` and `by`, or `says`", "'t'"),
        ("bounds = 'distance'\n", "needs `bounds` and `by`, or `says`", "'t'"),
        (&format!("{bound}says = 'x'\n"), "needs `bounds` and `by`, or `says`", "'t'"),
        (&bound.replace("distance", "distanse"), "`distanse` is nothing to bound", "'distanse'"),
        (&bound.replace("from = '0'\n", ""), "needs the first level", "'distance'"),
        (&bound.replace("'0'", "'-1'"), "`-1` is no level", "'-1'"),
        (&bound.replace("distance", "depth"), "a depth has no first level", "'0'"),
        (&bound.replace("2^k", "2^"), "expected a number", ""),
        ("says = 'x'\nrests = ['e']\n", "`e` is no other claim", "'e'"),
        ("says = 'x'\nrests = ['t']\n", "`t` is no other claim", "'t'"),
    ];
    for (text, message, place) in cases {
        let text = format!("[[theorem]]\nid = 't'\nlocus = 'l'\n{text}");
        let error = read(&text).err().unwrap_or_else(|| panic!("{text}: no error"));
        assert!(error.to_string().contains(message), "no `{message}` in: {error}");
        let underlined = &error.source.text[error.span.clone()];
        assert!(place.is_empty() || underlined == place, "{underlined}: {error}");
    }
}
