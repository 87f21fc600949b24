//! What follows from the numbers of a table: sums that are not kept, and equal values that are shipped differently.

use super::claim::ShippedClaim;
use super::finding::{BrokenSums, ShippedCell, SplitEquals};
use super::number::Settled as _;
use crate::exact::{Rational, RealCyclotomic, RealExpression, Scalar as _};
use std::collections::BTreeMap;

/// The longest line whose sum is computed: sums of many irrational numbers take long.
const MAX_LINE: usize = 256;

/// The most binary digits that are computed to see that two values are equal.
const EQUALITY_BITS: u64 = 10_000;

/// Lines along the last index whose sums are farther from the exact one than those of the nearest numbers are
/// anywhere, if all lines have one exact sum, a rational number.
///
/// The numbers of a single line may be unrelated, and any rational numbers have a rational sum: there only the sums 0, 1
/// and 2 count, which weights and filters have.
pub(super) fn sums(claim: &ShippedClaim, cells: &[ShippedCell]) -> Option<BrokenSums> {
    let length = claim.line();
    let values = values(cells)?;
    if !(2..=MAX_LINE).contains(&length) {
        return None;
    }
    let exact = common_sum(&values, length)?;
    let usual = |sum: i64| exact == Rational::from(sum);
    if cells.len() == length && !(0..=2).any(usual) {
        return None;
    }
    let right = values.iter().map(|value| value.settled(|x| claim.kind.nearest(x)).flatten());
    let right = right.collect::<Option<Vec<Rational>>>()?;
    let held: Vec<Rational> = claim.numbers.iter().map(|number| number.held.clone()).collect();
    let sums = |numbers: &[Rational]| -> Vec<Rational> {
        numbers.chunks(length).map(|line| Rational::total(line.iter())).collect()
    };
    let away = |sum: &Rational| (sum - &exact).abs();
    let nearest = sums(&right).iter().map(away).max()?;
    let held = sums(&held);
    let broken = held.iter().filter(|sum| away(sum) > nearest).count();
    let farthest = (0..held.len()).rev().max_by_key(|&line| away(&held[line]))?;
    (broken > 0).then(|| BrokenSums {
        first: farthest * length,
        held: held[farthest].clone(),
        exact,
        nearest,
        lines: broken,
    })
}

/// The exact values; `None` where one is beyond a cap.
fn values(cells: &[ShippedCell]) -> Option<Vec<&RealExpression>> {
    cells.iter().map(|cell| cell.exact.as_ref().ok()).collect()
}

/// The exact sum of every line, if they have one and it is a short fraction.
fn common_sum(values: &[&RealExpression], length: usize) -> Option<Rational> {
    let sum = |line: &[&RealExpression]| RealExpression::total(line.iter().copied());
    let mut lines = values.chunks(length);
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
        let Ok(exact) = &cell.exact else { continue };
        let rounded = exact.settled(|x| crate::exact::format::scientific(&x.abs(), 15));
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
    let both = one.exact.as_ref().ok().zip(other.exact.as_ref().ok());
    both.is_some_and(|(one, other)| zero(one.minus(other)) || zero(one.plus(other)))
}
