//! Certificates of the embedded papers, and of wrong audits, before the checker.

use crate::common::papers::{AUDITS, CERTIFICATES};
use std::path::Path;
use subcert::audit::{
    EquationVerdict, FunctionVerdict, PaperAudit, RangeVerdict, TheoremVerdict, Verdict, audit,
};
use subcert::certificate::{Certificate, certificate};
use subcert::claim::{Paper, embedded, read_paper};
use subcert::diagnostic::SourceText;
use subcert_check::{Outcome, Report, check};

/// What the checker says of an audit.
fn checked(audit: &PaperAudit<'_>) -> Report {
    read(audit, &certificate(audit))
}

/// What it says of a certificate.
fn read(audit: &PaperAudit<'_>, written: &Certificate) -> Report {
    let report = check(&audit.paper.source.text, &[&written.text]).expect("a claim file");
    assert!(report.broken.is_empty(), "{:?}", report.broken);
    report
}

/// Whether the checker accepts what an audit says of a claim.
fn valid(audit: &PaperAudit<'_>, id: &str) -> bool {
    let report = checked(audit);
    let claim = report.claims.iter().find(|(_, claim, _)| claim == id);
    claim.is_some_and(|(_, _, outcome)| *outcome == Outcome::Valid)
}

fn paper(text: &str) -> Paper {
    read_paper(&SourceText::new("test", text)).expect("a claim file")
}

/// The checker reads a mask in one text as the program does: the rules are those by hand.
#[test]
fn masks_in_one_text() {
    let text = "key = 'k'\n[paper]\nauthors = ['A B']\ntitle = 't'\nvenue = 'v'\nyear = '2026'\n\
        [[scheme]]\nname = 'two'\nparameters.w = {}\nmask = '{w, 1 - w, 1 - w, quarter}'\n[scheme.let]\nquarter = 'w'\n\
        [[scheme]]\nname = 'three'\nmask = '1/9 * [1 3 6 7 6 3 1]'\n\
        [[equation]]\nid = 'two'\nlocus = 'l'\nscheme = 'two:w=1/4'\n\
        indices = [{ name = 'i', values = ['0', '1', '2', '3'] }]\nleft = ['1/4', '3/4', '3/4', '1/4']\n\
        right = 'mask(floor(i/2), mod(i, 2) + floor(i/2))'\n\
        [[equation]]\nid = 'three'\nlocus = 'l'\nscheme = 'three'\n\
        indices = [{ name = 'i', values = ['0', '1', '2'] }]\nleft = ['1/9', '7/9', '1/9']\nright = 'mask(0, i)'\n";
    let paper = paper(text);
    let audit = audit(&paper).expect("an audit");
    for finding in &audit.equations {
        assert!(matches!(finding.verdict, EquationVerdict::Holds { .. }), "{finding:?}");
        assert!(valid(&audit, &finding.equation.id), "{}", finding.id);
    }
    for wrong in ["'[1, 3, 3, 1]/5'", "'[1, 3, 3, 1'", "'1/4'"] {
        let text = text.replace("'1/9 * [1 3 6 7 6 3 1]'", wrong);
        assert!(read_paper(&SourceText::new("test", &text[..])).is_err(), "{wrong}");
        let written = certificate(&audit).text;
        let report = check(&text, &[&written]);
        let accepted = |report: Report| {
            let mut claims = report.claims.into_iter();
            claims.any(|(_, id, outcome)| id == "three" && outcome == Outcome::Valid)
        };
        assert!(!report.is_ok_and(accepted), "{wrong}");
    }
}

#[test]
fn the_committed_certificates_are_valid_and_as_written() {
    assert_eq!(AUDITS.len(), embedded().len());
    for (audit, written) in AUDITS.iter().zip(&*CERTIFICATES) {
        let paper = audit.paper;
        assert_eq!(written.omitted, []);
        let path = format!("proofs/certificates/{}.cert", paper.key);
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
        let committed = std::fs::read_to_string(path).expect("a certificate");
        assert!(committed == written.text, "{}: `subcert prove` writes another", paper.key);
        for (kind, id, outcome) in read(audit, written).claims {
            let open = || {
                let finding = audit.theorems.iter().find(|finding| finding.theorem.id == id);
                kind == "theorem"
                    && finding.is_some_and(|finding| finding.verdict == TheoremVerdict::Open)
            };
            match outcome {
                Outcome::Valid => {}
                Outcome::Cited(_) => assert_eq!(kind, "theorem", "{}:{id}", paper.key),
                outcome => assert!(open(), "{}:{id}: {outcome:?}", paper.key),
            }
        }
    }
}

/// The examples. In one of them a reading gives every cell, though only by luck: then the readings that
/// take a quantity from another place are looked at too.
#[test]
fn the_certificates_of_the_examples_are_valid() {
    for text in [
        include_str!("../../examples/first-paper.toml"),
        include_str!("../../examples/my-paper.toml"),
    ] {
        let paper = paper(text);
        for (_, id, outcome) in checked(&audit(&paper).expect("an audit")).claims {
            assert!(
                matches!(outcome, Outcome::Valid | Outcome::Incomplete(_)),
                "{id}: {outcome:?}"
            );
        }
    }
}

/// A table, an equation, a closed form and a range, each with something wrong in it.
const WRONG: &str = r#"
key = "wrong"
[paper]
authors = []
title = ""
venue = ""
year = ""
[[scheme]]
name = "corner"
parameters.w = { about = "tension" }
mask = [['1 - w', 'w'], ['w', '1 - w']]
[[table]]
id = "t"
locus = ""
title = ""
scheme = "corner:w=w"
value = 'contraction(1)'
columns = { name = "w", values = ['1/5', '1/4', '1/3', '1/7'] }
cells = [['0.60', '0.51', '0.66', '0.6429']]
[[equation]]
id = "e"
locus = ""
title = ""
symbols = ["w"]
indices = [{ name = "i", values = ['1', '1/2'] }]
left = 'w*i'
right = 'w^2*i + (1 - i)*(w - w^2)/2'
[[function]]
id = "f"
locus = ""
title = ""
variable = "w"
scheme = "corner:w=w"
left = 'max(1 - 2*w, w)'
right = 'contraction(1)'
[[function]]
id = "g"
locus = ""
title = ""
variable = "w"
left = 'abs(w)*abs(w)'
right = 'w^2'
[[range]]
id = "r"
locus = ""
title = ""
variable = "w"
scheme = "corner:w=w"
value = 'contraction(1)'
below = '1'
from = '0'
to = '0.3'
[[range]]
id = "irrational"
locus = ""
title = ""
variable = "w"
value = 'w^2'
at_most = '2'
from = '-1.414'
to = '1.415'
[[range]]
id = "between"
locus = ""
title = ""
variable = "w"
value = 'abs(w^3 - 2*w)'
below = '1/2'
from = '-1.53'
to = '0.26'
"#;

/// A table that nothing can be certified of.
const DEEP: &str = r#"
[[table]]
id = "deep"
locus = ""
title = ""
value = 'levels(1 - 1/10^9, eps)'
promise = { tolerance = 'eps', spread = '1' }
columns = { name = "eps", values = ['1e-9'] }
cells = [['7']]
"#;

#[test]
fn wrong_verdicts_are_rejected() {
    let paper = paper(WRONG);
    let right = audit(&paper).expect("an audit");
    let claims = checked(&right).claims;
    for id in ["t", "e", "f", "g", "r", "irrational", "between"] {
        let valid = claims.iter().any(|(_, claim, is)| claim == id && *is == Outcome::Valid);
        assert!(valid, "{id}: {}", certificate(&right).text);
    }
    let cells = right.tables[0].cells[0].len();
    for cell in 0..cells {
        for verdict in [Verdict::Confirmed, Verdict::Refuted, Verdict::OtherReading] {
            let mut audit = right.clone();
            let finding = &mut audit.tables[0].cells[0][cell];
            if finding.verdict != verdict {
                finding.verdict = verdict;
                assert!(!valid(&audit, "t"), "cell {cell}");
            }
        }
    }
    let mut audit = right.clone();
    audit.equations[0].verdict = EquationVerdict::Holds { cases: 2 };
    assert!(!valid(&audit, "e"));
    let mut audit = right.clone();
    if let EquationVerdict::Fails { failures, .. } = &mut audit.equations[0].verdict {
        failures.pop();
    }
    assert!(!valid(&audit, "e"));
    let mut audit = right.clone();
    let failing = audit.functions[0].verdict.clone();
    audit.functions[0].verdict = FunctionVerdict::Holds;
    audit.functions[1].verdict = failing;
    assert!(!valid(&audit, "f") && !valid(&audit, "g"));
    for verdict in [RangeVerdict::Exact, RangeVerdict::Rounding] {
        let mut audit = right.clone();
        audit.ranges[0].found.as_mut().expect("within the caps").verdict = verdict;
        assert!(!valid(&audit, "r"));
    }
}

/// What could not be computed has no words in the format: the claim is left out.
#[test]
fn what_has_no_words_is_said() {
    let paper = paper(&format!("{WRONG}{DEEP}"));
    let audit = audit(&paper).expect("an audit");
    let written = certificate(&audit);
    let [omission] = &written.omitted[..] else { panic!("{:?}", written.omitted) };
    assert_eq!(omission.id, "wrong:deep");
    assert!(written.text.contains(&format!("# nothing of deep: {}\n", omission.why)));
    let claims = checked(&audit).claims;
    let deep = claims.iter().find(|(_, id, _)| id == "deep");
    assert_eq!(deep.map(|(_, _, outcome)| outcome), Some(&Outcome::Incomplete(None)));
}

/// Of data without a spread nothing is to be divided, and every promise that is not negative is kept;
/// one of a deep level is kept by its sound bound.
#[test]
fn promises_of_flat_data_and_deep_levels() {
    let paper = paper(
        "key = 'flat'\n[paper]\nauthors = []\ntitle = ''\nvenue = ''\nyear = ''\n[[table]]\nid = 't'\n\
         locus = ''\nvalue = 'contraction(1)*k'\nscheme = 'chaikin'\n\
         promise = { level = 'k', spread = '0' }\n\
         columns = { name = 'k', values = ['1', '2'] }\ncells = [['0.5', '1.0']]\n[[table]]\n\
         id = 'deep'\nlocus = ''\nvalue = 'levels(0.99, epsilon)'\nscheme = 'chaikin'\n\
         promise = { tolerance = 'epsilon', spread = '1' }\n\
         columns = { name = 'epsilon', values = ['1e-8'] }\ncells = [['1833']]\n",
    );
    let audit = audit(&paper).expect("an audit");
    let text = certificate(&audit).text;
    assert!(text.contains("kept 1 1 ") && text.contains("kept 1 2 "), "{text}");
    assert!(text.contains("kept 1 1 1833 "), "{text}");
    assert!(["t", "deep"].iter().all(|id| valid(&audit, id)));
}
