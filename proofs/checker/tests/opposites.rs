//! Claims and their opposites: no certificates show both, whatever is made of valid ones.
//!
//! The variable `OPPOSITES_SEED` begins with other random numbers, and `OPPOSITES_TIMES` takes more of them.

// Counts are small.
#![allow(clippy::cast_precision_loss)]

mod floats;
mod formulas;
mod kinds;
mod masks;
mod mutator;
mod programs;
mod radii;
mod ranges;
mod smooth;
mod suite;
mod theorems;
mod together;

use mutator::Random;
use std::time::Instant;
use subcert_check::{Outcome, check, check_radius};
use suite::Suite;

/// How many times as long the tests last: the variable `OPPOSITES_TIMES`.
fn times() -> usize {
    std::env::var("OPPOSITES_TIMES").ok().and_then(|times| times.parse().ok()).unwrap_or(1)
}

/// Tries the pairs of a suite so many times.
fn hold(name: &str, rounds: usize, suite: impl Fn(&mut Random) -> Suite) {
    let mut random = Random::new(name);
    let suite = suite(&mut random);
    let found = suite.run(&mut random, rounds * times());
    println!("{name}: {} pairs, {} accepted, {} proved", found.tried, found.accepted, found.proved);
    assert!(found.wrong.is_empty(), "{} wrong\n{}", found.wrong.len(), found.wrong.join("\n"));
    assert!(found.proved * 6 > suite.pairs.len() && found.accepted * 100 > found.tried);
}

#[test]
fn of_smoothness_and_exponents() {
    hold("smoothness", 25, smooth::suite);
}

#[test]
fn of_ranges_of_smoothness() {
    hold("ranges of smoothness", 60, ranges::suite);
}

#[test]
fn of_joint_spectral_radii() {
    let (accepted, wrong) = radii::run(&mut Random::new("radii"), 20_000 * times());
    println!("radii: {accepted} accepted");
    assert!(wrong.is_empty(), "{} wrong\n{}", wrong.len(), wrong[..wrong.len().min(20)].join("\n"));
    assert!(accepted > 500);
}

#[test]
fn of_the_claims_of_each_rule() {
    hold("rules", 40, |_| kinds::suite());
}

#[test]
fn of_bounds_next_to_the_suprema() {
    hold("bounds", 120, |_| theorems::suite());
}

#[test]
fn of_formulas() {
    hold("formulas", 60, formulas::suite);
}

#[test]
fn of_constants_in_programs() {
    hold("programs", 100, programs::suite);
}

/// Lines that would keep a checker busy for minutes or hours: roots, sums, quotients, cosines and fields.
#[test]
fn what_takes_long_is_left_open() {
    let slow = "key = 'slow'\n[[function]]\nid = 'f'\nvariable = 'w'\nleft = 'max(i = 0..900, abs(w^60 - i/7))'\nright = '-1'\n\
                [[function]]\nid = 'g'\nvariable = 'w'\nleft = 'w'\nright = '1'\n\
                [[equation]]\nid = 'e'\nsymbols = ['x']\nleft = 'x'\nright = '0'\n";
    let coefficients =
        (1..64).map(|k| format!("{}", 3_u128.pow(79) + k)).collect::<Vec<_>>().join(",");
    let case =
        |formula: &str| format!("equation e\n left x\n right 0\n fails 1\n case = {formula}");
    let blocks = [
        "function f\n variable w\n left max(i = 0..900, abs(w^60 - i/7))\n right -1\n breaks\n signs +\n fails 0 900/7 -1".to_owned(),
        format!("function g\n variable w\n left w\n right 1\n breaks{}\n signs +\n fails 0 0 1", format!(" root:-1,{coefficients}:0:1").repeat(20)),
        case("sum(i = 1..400000, 1/i)"),
        case("sum(i = 1..1000, binomial(i/7, 10000))"),
        case("sum(n = 800..1000, sum(i = 1..n, floor(cos(2*pi*i/n))))"),
        case("sum(i = 1..1000, 1/(i + cos(2*pi/997)))"),
    ];
    for block in blocks {
        let text = format!("subcert-certificate 4\npaper slow\n{block}\nend 1\n");
        let begin = Instant::now();
        let report = check(slow, &[&text]).expect("a claim file");
        let open =
            |(.., outcome): &(_, _, Outcome)| matches!(outcome, Outcome::Incomplete(Some(_)));
        assert!(report.claims.iter().any(open), "{report:?}");
        assert!(begin.elapsed().as_secs() < 30, "{:?}: {text}", begin.elapsed());
    }
    let field: Vec<String> = (3..63).map(|c: u32| c.to_string()).collect();
    let entry = vec!["1/3"; 59].join(",");
    let matrix = vec![[&entry[..]; 12].join(" "); 12].join(" | ");
    let text = format!(
        "subcert-radius 1\nfield -1 {}\nbetween 0 1\nmatrix {matrix}\nproduct 0 0\neigenvalue positive 1\nat-most 1\nunit 1\n{}end\n",
        field.join(" "),
        "image\n".repeat(12),
    );
    let begin = Instant::now();
    assert!(check_radius(&text).is_err());
    assert!(begin.elapsed().as_secs() < 30);
}
