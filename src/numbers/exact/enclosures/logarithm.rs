//! Enclosures of logarithms.

use crate::exact::{Enclosure, Integer, Rational};

/// An enclosure of ln x, no wider than 2^(−bits) in all practice: the series of the inverse
/// hyperbolic tangent on a grid of 2^(−bits−32), rounded outwards at each step.
///
/// With x = 2^k m, 2/3 ≤ m ≤ 4/3, and y = (m − 1)/(m + 1): ln x = k ln 2 + 2 artanh y, |y| ≤ 1/5, and
/// ln 2 = 2 artanh(1/3). The terms from y^{2j+1}/(2j+1) on are at most |y|^{2j+1}/(1 − y²) together.
///
/// # Panics
/// When x ≤ 0.
///
/// ```
/// use subcert::exact::{Rational, natural_logarithm};
///
/// let ten = natural_logarithm(&Rational::from(10), 64);
/// // 2.302585092994045684017…
/// let digits = |p: i64| Rational::new(p, 1_000_000_000_000_000_000_i64);
/// let below = digits(2_302_585_092_994_045_684);
/// assert!(*ten.lower() > below && ten.upper() - &below < digits(1));
/// assert!(ten.width() < Rational::new(1, 1_i64 << 60));
/// ```
#[must_use]
pub fn natural_logarithm(x: &Rational, bits: u32) -> Enclosure {
    assert!(x.sign() > 0, "the logarithm of a number that is not positive");
    let scale = bits + 32;
    let (mut m, mut k) = (x.clone(), 0_i64);
    let size = |integer: &Integer| i64::try_from(integer.bits()).expect("it fits in memory");
    let guess = size(&x.numerator()) - size(&x.denominator());
    m *= power_of_two(-guess);
    k += guess;
    while m > Rational::new(4, 3) {
        m /= Rational::from(2);
        k += 1;
    }
    while m < Rational::new(2, 3) {
        m *= Rational::from(2);
        k -= 1;
    }
    let two = Rational::from(2);
    let y = (&m - Rational::one()) / (m + Rational::one());
    let fine = artanh(&y, scale);
    let whole = artanh(&Rational::new(1, 3), scale);
    let factor = Enclosure::exact(Rational::from(k) * &two);
    &(&factor * &whole) + &(&Enclosure::exact(two) * &fine)
}

fn power_of_two(exponent: i64) -> Rational {
    let power = Integer::one()
        .shifted_left(u32::try_from(exponent.unsigned_abs()).expect("it fits in memory"));
    if exponent < 0 { Rational::new(1, power) } else { Rational::from(power) }
}

/// artanh y for |y| ≤ 1/3 on the grid of 2^(−scale).
fn artanh(y: &Rational, scale: u32) -> Enclosure {
    let unit = Integer::one().shifted_left(scale);
    let down = |x: &Rational| (x * Rational::from(unit.clone())).floor();
    let (y_low, y_high) = (down(y), down(y) + Integer::one());
    // Powers and sums are integers times the unit; all roundings go outwards.
    let grid = |n: Integer| Rational::new(n, unit.clone());
    let mut power = Enclosure::new(grid(y_low), grid(y_high));
    let square = outward(&(&power * &power), &unit);
    let mut sum = Enclosure::exact(Rational::zero());
    let mut odd = 1_i64;
    loop {
        let term = &power * &Enclosure::exact(Rational::new(1, odd));
        sum = outward(&(&sum + &term), &unit);
        power = outward(&(&power * &square), &unit);
        odd += 2;
        let size = power.lower().abs().max(power.upper().abs());
        if size <= Rational::new(4, unit.clone()) {
            // 1/(1 − y²) ≤ 9/8.
            let rest = Rational::new(9, 8) * size;
            return &sum + &Enclosure::new(-&rest, rest);
        }
    }
}

fn outward(x: &Enclosure, unit: &Integer) -> Enclosure {
    let scaled = |x: &Rational| x * Rational::from(unit.clone());
    let low = Rational::new(scaled(x.lower()).floor(), unit.clone());
    Enclosure::new(low, Rational::new(scaled(x.upper()).ceil(), unit.clone()))
}
