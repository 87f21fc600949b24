//! Random papers: the program and the checker agree on them, and neither says what is false.
//!
//! `SUBCERT_CASES` sets the number of papers, `PROPTEST_RNG_SEED` which ones.

#![allow(clippy::format_push_string, reason = "a claim file is written line by line")]

mod agree;
mod choices;
mod draft;
mod failure;
mod formula;
mod naive;
mod neighbours;
mod opposites;
mod program;
mod truth;
mod variety;

use draft::Draft;
use failure::settled;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

/// The number of papers of each test.
fn cases(few: u32) -> ProptestConfig {
    let asked = std::env::var("SUBCERT_CASES").ok().and_then(|cases| cases.parse().ok());
    // What fails is found again by the seed, not by choices, which change their meaning.
    let (max_shrink_time, failure_persistence) = (20_000, None);
    ProptestConfig {
        max_shrink_time,
        failure_persistence,
        ..ProptestConfig::with_cases(asked.unwrap_or(few))
    }
}

/// Papers of up to six claims.
fn papers() -> impl Strategy<Value = Draft> {
    let numbers = |count| prop::collection::vec(0_usize..1_000, 0..count);
    let claims = prop::collection::vec(numbers(60), 1..7);
    (numbers(80), claims).prop_map(|(head, claims)| Draft::new(head, claims))
}

#[test]
fn papers_are_of_all_kinds() {
    let mut runner = TestRunner::deterministic();
    let mut draft = || papers().new_tree(&mut runner).expect("a paper").current();
    let drafts: Vec<Draft> = (0..100).map(|_| draft()).collect();
    let counts = variety::counts(&drafts);
    let missing: Vec<&&str> =
        variety::NEEDED.iter().filter(|what| !counts.contains_key(**what)).collect();
    assert!(missing.is_empty(), "{missing:?} are missing among {counts:#?}");
}

proptest! {
    #![proptest_config(cases(40))]

    #[test]
    fn the_checker_accepts_what_the_program_certifies(draft in papers()) {
        settled(&draft, agree::accepted)?;
    }

    #[test]
    fn a_claim_is_judged_by_itself(draft in papers()) {
        settled(&draft, neighbours::independent)?;
    }

    #[test]
    fn what_is_certified_is_true(draft in papers()) {
        settled(&draft, truth::of_claims)?;
    }
}

proptest! {
    // Every block is checked with many others.
    #![proptest_config(cases(12))]

    #[test]
    fn opposite_verdicts_exclude_each_other(draft in papers()) {
        settled(&draft, opposites::excluded)?;
    }
}
