//! Claims and their opposites: no certificates show both, whatever is made of valid ones.
//!
//! The variable `OPPOSITES_SEED` begins with other random numbers, and `OPPOSITES_TIMES` takes more of them.

mod formulas;
mod kinds;
mod masks;
mod mutator;
mod programs;
mod radii;
mod smooth;
mod suite;
mod theorems;
mod together;

use mutator::Random;
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
    hold("ranges of smoothness", 60, smooth::ranges);
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
    hold("rules", 60, |_| kinds::suite());
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

/// One line that would keep the checker busy for minutes.
#[test]
fn what_takes_long_is_left_open() {
    let (low, high) = ("w^60 - i/7", "-1");
    let claims = format!(
        "key = 'slow'\n[[function]]\nid = 'f'\nvariable = 'w'\nleft = 'max(i = 0..900, abs({low}))'\nright = '{high}'\n"
    );
    let certificate = format!(
        "subcert-certificate 4\npaper slow\nfunction f\n  variable w\n  left max(i = 0..900, abs({low}))\n  \
         right {high}\n  breaks\n  signs +\n  fails 0 900/7 -1\nend 1\n"
    );
    let begin = std::time::Instant::now();
    let report = subcert_check::check(&claims, &[&certificate]).expect("a claim file");
    assert!(matches!(report.claims[0].2, subcert_check::Outcome::Incomplete(_)), "{report:?}");
    assert!(begin.elapsed().as_secs() < 20);
}
