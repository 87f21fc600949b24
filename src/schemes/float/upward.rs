//! Sums, products and quotients of non-negative f64, rounded upwards.
//!
//! The machine rounds to nearest. Let z be the true result of an operation, and r the
//! rounded one. Then z ≤ next_up(r), since no f64 lies strictly between z and r. Also
//! next_up(∞) = ∞, and next_up(0) = 2^−1074 is at least any product that underflows to 0.
//! So the functions with the suffix `_up` return upper bounds of the true result.

/// An upper bound of x + y, for x, y ≥ 0; exact when x or y is 0.
pub(super) fn add_up(x: f64, y: f64) -> f64 {
    if x == 0.0 || y == 0.0 { x + y } else { (x + y).next_up() }
}

/// An upper bound of x·y, for x, y ≥ 0; ∞ when x or y is infinite, also if the other
/// is 0.
pub(super) fn mul_up(x: f64, y: f64) -> f64 {
    if x.is_infinite() || y.is_infinite() {
        f64::INFINITY
    } else if x == 0.0 || y == 0.0 {
        0.0
    } else {
        (x * y).next_up()
    }
}

/// An upper bound of x/y, for x ≥ 0 and y > 0 finite.
pub(super) fn div_up(x: f64, y: f64) -> f64 {
    if x == 0.0 { 0.0 } else { (x / y).next_up() }
}

/// The greater of 0 and a lower bound of x − y, for x, y ≥ 0.
pub(super) fn sub_down(x: f64, y: f64) -> f64 {
    let difference = if y == 0.0 { x } else { (x - y).next_down() };
    if difference > 0.0 { difference } else { 0.0 }
}
