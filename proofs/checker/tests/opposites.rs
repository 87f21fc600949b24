//! Claims and their opposites: no certificates show both, whatever is made of valid ones.
//!
//! The variable `OPPOSITES_SEED` begins with other random numbers.

#[path = "opposites/formulas.rs"]
mod formulas;
#[path = "opposites/kinds.rs"]
mod kinds;
#[path = "opposites/masks.rs"]
mod masks;
#[path = "opposites/mutator.rs"]
mod mutator;
#[path = "opposites/programs.rs"]
mod programs;
#[path = "opposites/radii.rs"]
mod radii;
#[path = "opposites/smooth.rs"]
mod smooth;
#[path = "opposites/suite.rs"]
mod suite;
#[path = "opposites/together.rs"]
mod together;
#[path = "altered/words.rs"]
mod words;

use mutator::Random;
use suite::Suite;

/// Tries the pairs of a suite so many times.
fn hold(name: &str, rounds: usize, suite: impl Fn(&mut Random) -> Suite) {
    let mut random = Random::new(name);
    let suite = suite(&mut random);
    let proved = suite.proved();
    let found = suite.run(&mut random, rounds);
    println!("{name}: {} pairs, {} accepted, {proved} proved", found.tried, found.accepted);
    assert!(found.wrong.is_empty(), "{} wrong\n{}", found.wrong.len(), found.wrong.join("\n"));
    assert!(proved * 3 > suite.pairs.len() && found.accepted * 100 > found.tried);
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
    let (accepted, wrong) = radii::run(&mut Random::new("radii"), 20_000);
    println!("radii: {accepted} accepted");
    assert!(wrong.is_empty(), "{} wrong\n{}", wrong.len(), wrong[..wrong.len().min(20)].join("\n"));
    assert!(accepted > 500);
}

#[test]
fn of_the_claims_of_each_rule() {
    hold("rules", 60, |_| kinds::suite());
}

#[test]
fn of_formulas() {
    hold("formulas", 60, formulas::suite);
}

#[test]
fn of_constants_in_programs() {
    hold("programs", 100, programs::suite);
}
