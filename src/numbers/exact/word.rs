//! Arithmetic of machine words: fractions p/q in lowest terms, q > 0.

/// The word, if its absolute value is at most `cap`. −2^63 has no absolute value in an `i64`, and so no cap of a number that
/// is read is compared with one.
///
/// ```
/// use subcert::exact::within;
///
/// assert_eq!(within(-7, 7), Some(-7));
/// assert_eq!(within(i64::MIN, i64::MAX), None);
/// ```
#[must_use]
pub fn within(value: i64, cap: i64) -> Option<i64> {
    (value.unsigned_abs() <= cap.unsigned_abs()).then_some(value)
}

/// The greatest common divisor, by the binary algorithm.
pub(super) fn gcd(mut a: u64, mut b: u64) -> u64 {
    if a == 0 || b == 0 {
        return a | b;
    }
    let twos = (a | b).trailing_zeros();
    a >>= a.trailing_zeros();
    while b != 0 {
        b >>= b.trailing_zeros();
        (a, b) = (a.min(b), a.abs_diff(b));
    }
    a << twos
}

/// The number of binary digits of |value|.
pub(super) fn bits(value: i64) -> u64 {
    u64::from(64 - value.unsigned_abs().leading_zeros())
}

/// value / divisor, which is an integer.
fn over(value: i128, divisor: u64) -> i128 {
    match (i64::try_from(value), i64::try_from(divisor)) {
        (_, Ok(1)) => value,
        // A 64-bit division; a 128-bit division is about ten times slower.
        (Ok(value), Ok(divisor)) if divisor > 0 => (value / divisor).into(),
        _ => value / i128::from(divisor),
    }
}

/// The greatest common divisor of `value` and `word` ≠ 0.
fn common(value: i128, word: u64) -> u64 {
    let rest = match u64::try_from(value.unsigned_abs()) {
        Ok(value) => value,
        Err(_) => u64::try_from(value.unsigned_abs() % u128::from(word)).expect("less than a word"),
    };
    gcd(rest, word)
}

/// p/q in lowest terms, q ≠ 0.
pub(super) fn fraction(p: i64, q: i64) -> (i128, i128) {
    let divisor = gcd(p.unsigned_abs(), q.unsigned_abs());
    let sign = i128::from(q.signum());
    (sign * over(p.into(), divisor), sign * over(q.into(), divisor))
}

/// p/q + r/s. The numerators are words or their negatives, so that nothing overflows.
pub(super) fn sum((p, q): (i128, i64), (r, s): (i128, i64)) -> (i128, i128) {
    let divisor = if q == s { q.unsigned_abs() } else { gcd(q.unsigned_abs(), s.unsigned_abs()) };
    if divisor == 1 {
        return (p * i128::from(s) + r * i128::from(q), i128::from(q) * i128::from(s));
    }
    let (q, cofactor) = (over(q.into(), divisor), over(s.into(), divisor));
    let numerator = p * cofactor + r * q;
    // Every common factor of the numerator and the least common denominator divides
    // `divisor`.
    let shared = common(numerator, divisor);
    (over(numerator, shared), q * over(s.into(), shared))
}

/// p/q · r/s.
pub(super) fn product((p, q): (i64, i64), (r, s): (i64, i64)) -> (i128, i128) {
    let first = gcd(p.unsigned_abs(), s.unsigned_abs());
    let second = gcd(r.unsigned_abs(), q.unsigned_abs());
    let numerator = over(p.into(), first) * over(r.into(), second);
    (numerator, over(q.into(), second) * over(s.into(), first))
}
