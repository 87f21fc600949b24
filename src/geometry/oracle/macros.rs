//! Assertion macros for the tests of other programs.

/// Asserts that an f64 is at most a given number of units in the last place from an exact
/// value; see [`check_within_ulps`](crate::oracle::check_within_ulps). The exact value is
/// a `Rational`, a `RealCyclotomic`, a number of num-rational, num-bigint or rug, or a reference to one; a message may
/// follow.
///
/// ```
/// use subcert::assert_within_ulps;
/// use subcert::exact::Rational;
///
/// let third = 1.0 - 2.0 / 3.0;
/// assert_within_ulps!(third, Rational::new(1, 3), 1.0);
/// assert_within_ulps!(third, &Rational::new(1, 3), 1.0, "the weight of rule {}", 0);
/// ```
///
/// # Panics
/// When the distance is greater; the message shows both values.
#[macro_export]
macro_rules! assert_within_ulps {
    ($value:expr, $exact:expr, $ulps:expr $(,)?) => {
        if let Err(mismatch) = $crate::oracle::check_within_ulps($value, &$exact, $ulps) {
            panic!("{mismatch}");
        }
    };
    ($value:expr, $exact:expr, $ulps:expr, $($message:tt)+) => {
        if let Err(mismatch) = $crate::oracle::check_within_ulps($value, &$exact, $ulps) {
            panic!("{}: {mismatch}", format_args!($($message)+));
        }
    };
}

/// Asserts that every f64 of a slice is at most a given number of units in the last place
/// from the exact value at the same index of another slice; see
/// [`check_slice_within_ulps`](crate::oracle::check_slice_within_ulps). Both may be
/// arrays, vectors, slices, or references to them.
///
/// ```
/// use subcert::assert_slice_within_ulps;
/// use subcert::exact::Rational;
///
/// let thirds = [1.0 / 3.0, 2.0 / 3.0];
/// assert_slice_within_ulps!(thirds, [Rational::new(1, 3), Rational::new(2, 3)], 0.5);
/// ```
///
/// # Panics
/// When some value fails, or the lengths differ; the message shows the first and the
/// worst value that fail.
#[macro_export]
macro_rules! assert_slice_within_ulps {
    ($values:expr, $exact:expr, $ulps:expr $(,)?) => {
        if let Err(mismatch) = $crate::oracle::check_slice_within_ulps(&$values[..], &$exact[..], $ulps) {
            panic!("{mismatch}");
        }
    };
    ($values:expr, $exact:expr, $ulps:expr, $($message:tt)+) => {
        if let Err(mismatch) = $crate::oracle::check_slice_within_ulps(&$values[..], &$exact[..], $ulps) {
            panic!("{}: {mismatch}", format_args!($($message)+));
        }
    };
}

/// Asserts that an f64 is at most a given exact distance from an exact value; see
/// [`check_within`](crate::oracle::check_within).
///
/// ```
/// use subcert::assert_within;
/// use subcert::exact::Rational;
///
/// assert_within!(0.1 + 0.2 - 0.3, Rational::zero(), Rational::power_of_ten(-16));
/// ```
///
/// # Panics
/// When the distance is greater; the message shows both values.
#[macro_export]
macro_rules! assert_within {
    ($value:expr, $exact:expr, $tolerance:expr $(,)?) => {
        if let Err(mismatch) = $crate::oracle::check_within($value, &$exact, &$tolerance) {
            panic!("{mismatch}");
        }
    };
    ($value:expr, $exact:expr, $tolerance:expr, $($message:tt)+) => {
        if let Err(mismatch) = $crate::oracle::check_within($value, &$exact, &$tolerance) {
            panic!("{}: {mismatch}", format_args!($($message)+));
        }
    };
}
