//! Sums, products and quotients of non-negative f64, rounded upwards.
//!
//! The machine rounds to nearest. If r is the rounded result of an operation with
//! the true result z, then z ≤ next_up(r), since no f64 lies between z and one of
//! its two neighbours; and next_up(∞) = ∞, next_up(0) = 2^−1074 ≥ a product that
//! underflowed. Hence each function here is an upper bound of the true result.

/// x + y ≤ the result, for x, y ≥ 0. Exact when one of them is 0.
pub(super) fn add_up(x: f64, y: f64) -> f64 {
    if x == 0.0 || y == 0.0 { x + y } else { (x + y).next_up() }
}

/// x·y ≤ the result, for x, y ≥ 0; ∞ when one of them is, whatever the other.
pub(super) fn mul_up(x: f64, y: f64) -> f64 {
    if x.is_infinite() || y.is_infinite() {
        f64::INFINITY
    } else if x == 0.0 || y == 0.0 {
        0.0
    } else {
        (x * y).next_up()
    }
}

/// x/y ≤ the result, for x ≥ 0 and y > 0 finite.
pub(super) fn div_up(x: f64, y: f64) -> f64 {
    if x == 0.0 { 0.0 } else { (x / y).next_up() }
}

/// A lower bound of x − y, for x, y ≥ 0: 0 where it is not surely positive.
pub(super) fn sub_down(x: f64, y: f64) -> f64 {
    let difference = if y == 0.0 { x } else { (x - y).next_down() };
    if difference > 0.0 { difference } else { 0.0 }
}
