//! What follows from shipped numbers.

use super::{found, project, table};
use crate::common::r;
use subcert::exact::Rational;
use subcert::shipped::BrokenSums;

/// 0.3333f is 11183692/2^25.
#[test]
fn sums_that_are_not_kept() {
    let cells = ["0.3333f", "0.3333f", "0.3333f", "0.33333334f", "0.33333334f", "0.33333334f"];
    let project = project(&table("f32", "'i = 1..2', 'k = 1..3'", "1/3", &cells));
    let held = Rational::from(3) * r(11_183_692, 1 << 25);
    // The f32 nearest to 1/3 is 11184811/2^25; three of them are 1/2^25 above 1.
    let expected = BrokenSums { exact: r(1, 1), first: 0, held, nearest: r(1, 1 << 25), lines: 1 };
    assert_eq!(found(&project).sums, Some(expected));
}

#[test]
fn sums_of_the_nearest_numbers_are_not_reported() {
    let cells = ["0.33333334f"; 3];
    let right = project(&table("f32", "'k = 1..3'", "1/3", &cells));
    assert_eq!(found(&right).sums, None);
    // A sum of unrelated numbers is no law.
    let unrelated = project(&table("f32", "'k = 1..3'", "k/7", &["0.1f", "0.2f", "0.3f"]));
    assert_eq!(found(&unrelated).sums, None);
}

/// Sums of algebraic numbers that are rational: cos(2πk/5) over k is 0.
#[test]
fn sums_of_algebraic_numbers() {
    let cells = ["1", "0.309", "-0.809", "-0.809", "0.308"];
    let project = project(&table("decimal:3", "'k = 0..4'", "cos(2*pi*k/5)", &cells));
    let sums = found(&project).sums.expect("broken");
    assert_eq!((sums.exact, sums.held, sums.nearest), (r(0, 1), r(-1, 1000), r(0, 1)));
}

#[test]
fn equal_values_that_differ() {
    let cells = ["0.309", "-0.809", "-0.81", "0.309"];
    let project = project(&table("decimal:3", "'k = 1..4'", "cos(2*pi*k/5)", &cells));
    let equals = found(&project).equals.expect("different");
    assert_eq!((equals.values, equals.pair), (1, [1, 2]));
    let same = super::project(&table("decimal:3", "'k = 1..2'", "(-1)^k/3", &["-0.333", "0.333"]));
    assert_eq!(found(&same).equals, None);
}

#[test]
fn the_greatest_error() {
    let project = project(&table("decimal:3", "'k = 1..3'", "k/3", &["0.333", "0.6", "1.000"]));
    let finding = found(&project);
    assert_eq!(finding.farthest, Some(1));
    assert_eq!(finding.cells[1].error, Some(r(1, 15)));
    assert_eq!(finding.cells[2].error, Some(r(0, 1)));
}
