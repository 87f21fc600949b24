//! Certificates of claims about smoothness, checked, and the papers that have such claims.

use crate::common::claims::{HEAD, judged, paper};
use std::path::Path;
use subcert::audit::audit;
use subcert::certificate::certificate;
use subcert::claim::read_paper_file;
use subcert_check::{Outcome, check};

/// The papers with claims about smoothness, and the claims of each that no certificate carries.
const PAPERS: [(&str, &[&str]); 9] = [
    ("dyn1987", &[]),
    ("dyn1991", &[]),
    ("dyn2005", &[]),
    ("hassan2002", &["hassan2002:only"]),
    ("hassan2003", &[]),
    ("hechler2009", &["hechler2009:sharp"]),
    ("ko2007", &[]),
    ("lane1980", &[]),
    ("rioul1992", &["rioul1992:four-points"]),
];

#[test]
fn the_claims_of_the_papers_hold_and_are_certified() {
    for (key, omitted) in PAPERS {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/claims/smoothness");
        let path = path.join(format!("{key}.toml"));
        let paper = read_paper_file(&path).expect("a file").expect("a claim file");
        assert_eq!(paper.key, key);
        let audit = audit(&paper).unwrap_or_else(|error| panic!("{error}"));
        for finding in &audit.smoothness {
            let rounded = finding.id == "hechler2009:sharp";
            let expected = if rounded { "rounding" } else { "confirmed" };
            assert_eq!(finding.verdict.name(), expected, "{}", finding.id);
        }
        assert!(audit.errata().errata.is_empty());
        let certificate = certificate(&audit);
        let left_out: Vec<&str> = certificate.omitted.iter().map(|one| one.id.as_str()).collect();
        assert_eq!(left_out, omitted);
        let text = std::fs::read_to_string(&path).expect("a file");
        let report = check(&text, &[&certificate.text]).expect("a claim file");
        assert!(report.broken.is_empty(), "{:?}", report.broken);
        for (_, id, outcome) in &report.claims {
            let without = omitted.contains(&&format!("{key}:{id}")[..]);
            let expected = if without { Outcome::Incomplete(None) } else { Outcome::Valid };
            assert_eq!(*outcome, expected, "{key}:{id}");
        }
    }
}

#[test]
fn what_the_radius_does_not_show_is_left_out() {
    let claims = "[[exponent]]\nid = 'attained'\nlocus = ''\nscheme = 'chaikin'\nvalue = '2'\nattained = true\n\
                  [[exponent]]\nid = 'base'\nlocus = ''\nscheme = 'chaikin'\nat_least = 'log_3(2)'\n\
                  [[exponent]]\nid = 'open'\nlocus = ''\nscheme = 'chaikin'\nvalue = 'log_3(9) + log_5(5) - 1'\n\
                  [[range]]\nid = 'only'\nlocus = ''\nscheme = 'ternary-four-point:mu=w'\nvariable = 'w'\n\
                  smoothness = '2'\nfrom = '1/15'\nto = '1/9'\nonly = true\n\
                  [[range]]\nid = 'hulls'\nlocus = ''\nscheme = 'four-point:w=w'\nvariable = 'w'\n\
                  smoothness = '1'\nfrom = '0'\nto = '0.1927'\n";
    let paper = paper(claims);
    let written = certificate(&judged(&paper));
    let left_out: Vec<&str> = written.omitted.iter().map(|one| one.id.as_str()).collect();
    assert_eq!(left_out, ["k:attained", "k:base", "k:open", "k:only", "k:hulls"]);
    assert_eq!(written.blocks, 0);
    let report = check(&format!("{HEAD}{claims}"), &[&written.text]).expect("a claim file");
    assert!(report.claims.iter().all(|(_, _, outcome)| *outcome == Outcome::Incomplete(None)));
}
