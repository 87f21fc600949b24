//! A value beyond a cap leaves its claim open, with the cap, and no other claim.

use crate::common::claims::judged;
use std::collections::BTreeMap;
use subcert::audit::{Outcome, PaperAudit, TheoremVerdict, audit};
use subcert::claim::{Paper, read_paper};
use subcert::diagnostic::SourceText;

const CLAIMS: &str = include_str!("caps.toml");

/// Blocks of claims beyond a cap.
#[cfg(feature = "cli")]
const CLAIMED: [&str; 6] = [
    "equation equation-of-a-power\n  left x^100000\n  right x\n  holds 1",
    "equation equation-of-cases\n  left i\n  right i\n  holds 1000001",
    "equation equation-of-convolutions\n  left convolution(5, 0, 0)\n  right 0\n  holds 1",
    "function function-of-a-degree\n  variable w\n  left w^40*w^40\n  right w\n  breaks\n  signs 0\n  holds",
    "range range-of-a-limit\n  variable w\n  value w\n  below 2^(10^9)\n  breaks\n  signs -\n  \
     end to \"1\" none apart\n  inexact",
    "theorem theorem-of-levels\n  open",
];

fn paper(text: &str) -> Paper {
    read_paper(&SourceText::new("caps.toml", text)).unwrap_or_else(|error| panic!("{error}"))
}

/// The verdicts of the claims.
fn verdicts<'a>(audit: &PaperAudit<'a>) -> BTreeMap<&'a str, Vec<&'static str>> {
    let claims = audit.claims().into_iter();
    claims
        .map(|claim| (claim.id, claim.verdicts.iter().map(|(word, _)| word.name()).collect()))
        .collect()
}

/// Whether a claim of the file is right: the first row of the table of orders is.
fn is_right(id: &str) -> bool {
    id.starts_with("right") || id == "regularity.1.order"
}

#[test]
fn other_claims_are_judged() {
    let paper = paper(CLAIMS);
    let audit = judged(&paper);
    for (id, verdicts) in verdicts(&audit) {
        let expected = match id {
            "wrong-theorem" => "refuted",
            "promise" => "confirmed",
            _ if is_right(id) => verdicts[0],
            _ if id.starts_with("theorem") => "open",
            _ => "not-checkable",
        };
        assert_eq!(verdicts, [expected], "{id}");
        let failed = ["refuted", "fails", "inexact", "open", "not-checkable"];
        assert!(!is_right(id) || !failed.contains(&verdicts[0]), "{id}: {verdicts:?}");
    }
    // Each names its cap.
    let beyond = audit.beyond_caps();
    assert_eq!(beyond.len(), 13, "{beyond:?}");
    assert!(
        beyond.iter().all(|one| !is_right(one.id) && one.cap.contains("at most")),
        "{beyond:?}"
    );
    for theorem in audit.theorems.iter().filter(|one| one.verdict == TheoremVerdict::Open) {
        let [case] = &theorem.cases[..] else { panic!("{}: one case", theorem.id) };
        let Outcome::Unknown(why) = &case.outcome else { panic!("{}: {case:?}", theorem.id) };
        assert!(why.to_string().contains("at most"), "{}: {why}", theorem.id);
    }
    assert_eq!(audit.promise_counts().open, 1);
}

/// What is wrong otherwise is an error at its place, also beside a value beyond a cap.
#[test]
fn other_errors_stay_errors() {
    for (right, wrong) in [
        ("left = 'x^100000'\nright = 'x'", "left = 'x^100000'\nright = 'nonsense'"),
        ("left = 'w^40*w^40'\nright = 'w'", "left = 'w^40*w^40'\nright = 'nonsense'"),
        ("value = 'w'\nbelow = '2^(10^9)'", "value = 'nonsense'\nbelow = '2^(10^9)'"),
        ("by = '2^(10^9)*beta'", "by = 'nonsense*beta'"),
    ] {
        let text = CLAIMS.replace(right, wrong);
        assert_ne!(text, CLAIMS);
        let paper = paper(&text);
        let error = audit(&paper).expect_err(wrong);
        assert_eq!(&text[error.span], "nonsense", "{}", error.message);
    }
}

#[cfg(feature = "cli")]
#[test]
fn reports_name_the_caps() {
    use subcert::report::html::audit_page;
    use subcert::report::json::{AuditReport, ErrataReport};
    use subcert::report::{audit_sheet, errata_sheet, overview_sheet, unicode};
    let paper = paper(CLAIMS);
    let audits = [judged(&paper)];
    // Lines may be broken anywhere between words.
    let words = |text: String| text.split_whitespace().collect::<Vec<&str>>().join(" ");
    let page = words(audit_page(&audits[0], None, None).expect("a page"));
    let page = page.replace("<sup>", "^").replace("</sup>", "");
    let whole = words(audit_sheet(&audits, true).to_text(None));
    let json = serde_json::to_value(AuditReport::of(&audits)).expect("JSON");
    let claims = json["papers"][0]["claims"].as_array().expect("claims");
    let errata = words(errata_sheet(&audits).to_text(None));
    let listed = serde_json::to_value(ErrataReport::of(&audits)).expect("JSON");
    let listed = listed["papers"][0]["beyond_caps"].as_array().expect("a list");
    let beyond = audits[0].beyond_caps();
    assert_eq!(listed.len(), beyond.len());
    for (one, json) in beyond.iter().zip(listed) {
        assert_eq!((&json["id"], &json["cap"]), (&one.id.into(), &one.cap[..].into()));
        let id = format!("caps:{}", one.id);
        let claim = claims.iter().find(|claim| claim["id"] == id[..]).expect("the claim");
        assert_eq!(claim["verdict"], "not-checkable", "{id}");
        assert!(claim["note"].as_str().is_some_and(|note| note.contains(&one.cap)), "{claim}");
        assert!(page.contains(&one.cap), "{id}: {}", one.cap);
        let typeset = unicode(&one.cap);
        assert!([&whole, &errata].iter().all(|text| text.contains(&typeset)), "{id}: {typeset}");
    }
    let head = words(overview_sheet(&audits).to_text(None));
    assert!(head.contains("13 claims need a value beyond a cap."), "{head}");
}

/// The checker accepts what is certified, and nothing is certified of a claim beyond a cap.
#[cfg(feature = "cli")]
#[test]
fn nothing_is_certified_beyond_a_cap() {
    use subcert_check::{Outcome, check};
    let paper = paper(CLAIMS);
    let written = subcert::certificate::certificate(&judged(&paper));
    // Nor does the checker believe what is said of one all the same.
    let blocks: Vec<String> = CLAIMED.iter().map(|block| format!("{block}\n")).collect();
    let end = format!("end {}", written.blocks);
    let more = format!("{}end {}", blocks.concat(), written.blocks + blocks.len());
    let text = written.text.replace(&end, &more);
    let report = check(CLAIMS, &[&text]).expect("a claim file");
    assert!(report.broken.is_empty(), "{:?}", report.broken);
    // The number of a table is right where its promise is open.
    for (kind, id, outcome) in report.claims.iter().filter(|(_, id, _)| id != "promise") {
        let certified = is_right(id) || id == "wrong-theorem";
        assert_eq!(*outcome == Outcome::Valid, certified, "{kind} {id}: {outcome:?}");
        let claimed = CLAIMED.iter().any(|block| block.starts_with(&format!("{kind} {id}\n")));
        let invalid = matches!(outcome, Outcome::Invalid(..));
        assert!(claimed || !invalid, "{kind} {id}: {outcome:?}");
    }
}
