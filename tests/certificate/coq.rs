//! Theorems of Coq. That Coq accepts them, and rejects wrong ones, is what `.ci/coq.py` tests.

use crate::common::papers::{AUDITS, audit_of};
use std::collections::BTreeMap;
use std::fs::{read_dir, read_to_string};
use subcert::certificate::{CoqFile, coq_files};

fn written() -> Vec<CoqFile> {
    AUDITS.iter().flat_map(|audit| coq_files(audit).expect("theorems")).collect()
}

/// What Coq compiles is what the program writes, file by file.
#[test]
fn the_files_of_the_papers_are_those_that_the_program_writes() {
    let papers = concat!(env!("CARGO_MANIFEST_DIR"), "/proofs/coq/papers");
    let mut there = BTreeMap::new();
    for paper in read_dir(papers).expect("the folder") {
        let paper = paper.expect("an entry").path();
        for file in read_dir(&paper).expect("a folder") {
            let file = file.expect("an entry").path();
            if file.extension().is_some_and(|extension| extension == "v") {
                let name = file.strip_prefix(papers).expect("below it").to_string_lossy();
                there.insert(name.into_owned(), read_to_string(&file).expect("a text"));
            }
        }
    }
    let written: BTreeMap<String, String> =
        written().into_iter().map(|file| (file.name, file.text)).collect();
    assert_eq!(written.keys().collect::<Vec<_>>(), there.keys().collect::<Vec<_>>());
    for (name, text) in written {
        assert_eq!(text, there[&name], "{name}");
    }
}

/// Table 1: the rules of the difference mask of the six-point scheme at w = 39/2000 have the sum 2·39/2000 +
/// 2·203/2000 + 1/2 = 371/500. The paper reads them from the other end.
#[test]
fn statements_hold_the_numbers_of_the_paper() {
    let files = coq_files(audit_of("mustafa2020-nary")).expect("theorems");
    let of = |name: &str| {
        let found = files.iter().find(|file| file.name == format!("mustafa2020_nary/{name}.v"));
        &found.expect("a file").text
    };
    for said in [
        "Scheme 2000 (-2) [[0; 0; 2000; 0; 0; 0]; [39; -242; 1203; 1203; -242; 39]]%Z.",
        "(* row 1, column 1: Table 1, c_0 = 1 prints 0.742000 *)\n(* It is this constant. *)\nTheorem finding_1 :\n  contraction_constant scheme_1 1 (371 # 500).",
        "Scheme 2000 (-2) [[-39; 203; 1000; -203; 39; 0]; [39; -203; 1000; 203; -39; 0]]%Z.",
        "backwards_constant scheme_1 difference_1 2 (176871 # 400000).",
    ] {
        assert!(of("table_1").contains(said), "{said}");
    }
    // (20) for c = 2, k = 0: σ as printed is 3/5 and T = 193/625, so that the bound is 125/144.
    assert!(of("theorem_5").contains("exceeds_distance scheme_1 0 0 1 (125 # 144)."));
    // At natural parameters, with rules of mean m_0 = (0·7 + 1·21 − 2·3)/25 = 3/5 the shift is −5·(3/5)/4 = −3/4.
    assert!(of("theorem_5").contains("exceeds_distance scheme_1 (-3 # 4) 1 1 (20233 # 617320)."));
    // (32) of the quaternary scheme in both directions, c = 2, k = 1: at (15/16, 15/16) the net is 3/4 off.
    assert!(
        of("theorem_8").contains("exceeds_net_distance scheme_1 scheme_1 0 0 1 1 (1133 # 5120).")
    );
}
