//! What follows from the numbers of a table: sums that are not kept, and equal values that are shipped differently.

use super::claim::ShippedClaim;
use super::finding::{BrokenSums, ShippedCell, SplitEquals};
use super::number::Settled as _;
use crate::exact::{Rational, RealCyclotomic, RealExpression, Scalar as _};
use std::collections::BTreeMap;

/// The most binary digits that are computed to see that two values are equal.
const EQUALITY_BITS: u64 = 10_000;

/// Lines along the last index that do not have their exact sum, if all lines have one exact sum, a rational number.
pub(super) fn sums(claim: &ShippedClaim, cells: &[ShippedCell]) -> Option<BrokenSums> {
    let length = claim.line();
    if length < 2 {
        return None;
    }
    let exact = common_sum(cells, length)?;
    let mut broken: Option<BrokenSums> = None;
    let (mut lines, mut nearest) = (0, Rational::zero());
    for first in (0..cells.len()).step_by(length) {
        let line = first..first + length;
        let held = line.clone().fold(Rational::zero(), |sum, at| sum + &claim.numbers[at].held);
        let right = line.map(|at| cells[at].exact.settled(|x| claim.kind.nearest(x)).flatten());
        let right = right.collect::<Option<Vec<Rational>>>()?;
        let right = right.iter().fold(Rational::zero(), |sum, one| sum + one);
        let distance = (&right - &exact).abs();
        nearest = if distance > nearest { distance } else { nearest };
        let error = (&held - &exact).abs();
        if error.is_zero() {
            continue;
        }
        lines += 1;
        if broken.as_ref().is_none_or(|worst| (&worst.held - &exact).abs() < error) {
            broken = Some(BrokenSums {
                exact: exact.clone(),
                first,
                held,
                nearest: Rational::zero(),
                lines: 0,
            });
        }
    }
    broken.map(|worst| BrokenSums { nearest, lines, ..worst })
}

/// The exact sum of every line, if they have one and it is a short fraction.
fn common_sum(cells: &[ShippedCell], length: usize) -> Option<Rational> {
    let sum = |line: &[ShippedCell]| RealExpression::total(line.iter().map(|cell| &cell.exact));
    let mut lines = cells.chunks(length);
    let first = sum(lines.next()?);
    let value = simple(&first)?;
    let equal = |line: RealExpression| {
        line.minus(&RealExpression::from(value.clone())).sign_within(EQUALITY_BITS) == Some(0)
    };
    (equal(first) && lines.all(|line| equal(sum(line)))).then_some(value)
}

/// The fraction with a small denominator that a number seems to be.
fn simple(value: &RealExpression) -> Option<Rational> {
    if let Some(value) = value.as_number().and_then(RealCyclotomic::as_rational) {
        return Some(value.clone());
    }
    (1..=64_i64).find_map(|q| {
        let scale = Rational::from(q);
        let near = value.settled(|value| (value * &scale).round_half_even())?;
        let candidate = Rational::from(near) / scale;
        value.near(1).contains(&candidate).then_some(candidate)
    })
}

/// Values that are equal up to the sign, and shipped with different sizes.
pub(super) fn equals(claim: &ShippedClaim, cells: &[ShippedCell]) -> Option<SplitEquals> {
    // Equal values round to equal numbers; only those have to be compared exactly.
    let mut groups: BTreeMap<Option<String>, Vec<usize>> = BTreeMap::new();
    for (place, cell) in cells.iter().enumerate() {
        let rounded = cell.exact.settled(|x| crate::exact::format::scientific(&x.abs(), 15));
        if rounded.is_some() {
            groups.entry(rounded).or_default().push(place);
        }
    }
    let held = |place: usize| claim.numbers[place].held.abs();
    let (mut values, mut pair) = (0, None);
    for group in groups.values() {
        let first = group[0];
        let other = group.iter().copied().find(|&place| held(place) != held(first));
        if let Some(other) = other.filter(|&other| same_size(&cells[first], &cells[other])) {
            values += 1;
            pair = pair.or(Some([first, other]));
        }
    }
    pair.map(|pair| SplitEquals { values, pair })
}

/// Whether two numbers have one exact absolute value.
fn same_size(one: &ShippedCell, other: &ShippedCell) -> bool {
    let zero = |value: RealExpression| value.sign_within(EQUALITY_BITS) == Some(0);
    zero(one.exact.minus(&other.exact)) || zero(one.exact.plus(&other.exact))
}
