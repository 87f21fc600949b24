//! Certificates of relations, checked, and the papers that have such claims.

use crate::common::claims::judged;
use std::path::Path;
use subcert::audit::Word;
use subcert::certificate::certificate;
use subcert::claim::read_paper_file;
use subcert_check::{Outcome, check};

/// The claims that lack something. The checker reads what that is.
const WITHOUT: [&str; 1] = ["lawton1991:translates"];

/// The claims about masks over other fields, which the checker leaves incomplete.
const INCOMPLETE: [&str; 5] = [
    "antonini1992:nine-seven",
    "antonini1992:nine-seven-pair",
    "daubechieslagarias1992:daubechies-4",
    "daubechieslagarias1992:daubechies-6",
    "daubechieslagarias1992:daubechies-8",
];

#[test]
fn the_relations_of_the_papers_hold_and_are_certified() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/claims/relations");
    let mut papers = 0;
    for file in std::fs::read_dir(folder).expect("a folder") {
        let path = file.expect("a file").path();
        let paper = read_paper_file(&path).expect("a file").expect("a claim file");
        assert_eq!(path.file_stem().and_then(|stem| stem.to_str()), Some(&paper.key[..]));
        let audit = judged(&paper);
        for finding in &audit.equations {
            let without = WITHOUT.contains(&&finding.id[..]);
            let expected = if without { Word::NotCheckable } else { Word::Holds };
            assert_eq!(finding.verdict.word(), expected, "{}", finding.id);
        }
        let text = std::fs::read_to_string(&path).expect("a file");
        let report = check(&text, &[&certificate(&audit).text]).expect("a claim file");
        assert!(report.broken.is_empty(), "{:?}", report.broken);
        for (_, id, outcome) in &report.claims {
            let known = INCOMPLETE.contains(&&format!("{}:{id}", paper.key)[..]);
            let valid = matches!(outcome, Outcome::Valid);
            let incomplete = known && matches!(outcome, Outcome::Incomplete(_));
            assert!(valid || incomplete, "{}:{id}: {outcome:?}", paper.key);
        }
        papers += 1;
    }
    assert!(papers >= 37, "{papers}");
}
