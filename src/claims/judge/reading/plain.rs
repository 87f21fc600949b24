//! How plain a number is: which of many someone would choose as a parameter.

use crate::exact::{Integer, Rational};
use crate::judge::reading::scale::simplest_between;

/// The most decimal places that count: beyond them a fraction is plainer.
const MAX_PLACES: u32 = 40;

/// The least range from which a parameter is thought to be chosen: from −10 to 10.
const LEAST_RANGE: i64 = 10;

/// How plain a number is, the plainest least: min(10^e, q²), with e decimal places if it has so
/// few, and its denominator q; then its absolute value, and positive before negative.
pub(crate) fn height(value: &Rational) -> (Integer, Rational, bool) {
    (cost(value), value.abs(), value.sign() < 0)
}

fn cost(value: &Rational) -> Integer {
    let denominator = value.denominator();
    let square = denominator.pow(2);
    let holds = |power: &Integer| power.div_floor(&denominator) * &denominator == *power;
    // Most denominators that occur divide no power of 10, which one division shows.
    if !holds(&Integer::power_of_ten(MAX_PLACES)) {
        return square;
    }
    let mut powers = (0..=MAX_PLACES).map(Integer::power_of_ten);
    powers.find(holds).map_or(square.clone(), |power| power.min(square))
}

/// An upper bound of how many numbers are as plain as this one: with K as of [`height`] and
/// R = max(10, ⌈|v|⌉), the decimals m/10^e from −R to R with 10^e ≤ K are at most 2RK + 1, and the
/// fractions with q² ≤ K at most 2RK + √K; together at most (4R + 2)K.
pub(crate) fn as_plain(value: &Rational) -> Integer {
    let range = value.abs().ceil().max(Integer::from(LEAST_RANGE));
    (range * Integer::from(4) + Integer::from(2)) * cost(value)
}

/// The plainest number strictly between two others.
pub(crate) fn plainest_between(low: &Rational, high: &Rational) -> Rational {
    let fraction = match (low.sign(), high.sign()) {
        (-1, 1) => return Rational::zero(),
        (-1, _) => -simplest_between(&-high, &-low),
        _ => simplest_between(low, high),
    };
    let decimal = (0..=MAX_PLACES).find_map(|places| decimal_between(low, high, places));
    [Some(fraction), decimal].into_iter().flatten().min_by_key(height).expect("the fraction")
}

/// The least decimal in absolute value with so many places strictly between two numbers of one
/// sign.
fn decimal_between(low: &Rational, high: &Rational, places: u32) -> Option<Rational> {
    let unit = Rational::from(Integer::power_of_ten(places));
    let (low, high) = (low * &unit, high * &unit);
    let (least, greatest) = (low.floor() + Integer::one(), high.ceil() - Integer::one());
    let chosen = if low.sign() < 0 { &greatest } else { &least };
    (least <= greatest).then(|| Rational::from(chosen.clone()) / unit)
}

/// The plainest numbers, in their order: those from −1 to 1 with a denominator of 1, 2, 3 or 10.
pub(crate) fn plain_numbers() -> Vec<Rational> {
    let denominators = [1_i64, 2, 3, 10].into_iter();
    let fractions = denominators.flat_map(|q| (-q..=q).map(move |p| Rational::new(p, q)));
    let mut numbers: Vec<Rational> = fractions.collect();
    numbers.sort_by_key(height);
    numbers.dedup();
    numbers
}
