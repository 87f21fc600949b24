//! Subdivision depths: the least level at which a bound meets a tolerance.

use crate::exact::{Integer, Rational};

/// The greatest depth that is computed.
pub const MAX_DEPTH: u32 = 100_000;

/// The greatest number of binary digits of a power in the computation of a depth.
pub(super) const MAX_POWER_BITS: u64 = 8_000_000;

/// Why there is no depth.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DepthError {
    /// The bound does not shrink with the level.
    #[error("the ratio {0} is not below 1, so the bound does not shrink")]
    NoContraction(String),
    /// A tolerance, a ratio or a factor that is not positive.
    #[error("{what} must be positive, and is {value}")]
    NotPositive {
        /// What must be positive.
        what: &'static str,
        /// Its value.
        value: String,
    },
    /// Beyond [`MAX_DEPTH`], or too large to decide.
    #[error("the depth is beyond the caps: {MAX_DEPTH} levels, or numbers too large to decide it")]
    TooDeep,
}

/// How a real number of levels is rounded to an integer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Rounded {
    /// Up, to the least integer that is at least the number. This gives a depth.
    Up,
    /// To the nearest integer; of two equally near ones, to the greater.
    Nearest,
    /// Down, to the greatest integer that is at most the number.
    Down,
}

/// log_ratio(x), rounded to an integer as `rounded` says, for 0 < ratio < 1 and x > 0.
/// Rounded up, it is the least integer k ≥ 0 with ratio^k ≤ x. Negative results become 0,
/// the first level. The computation uses integers only, no logarithm.
///
/// # Errors
/// When the ratio or x is out of range, or the depth beyond the caps.
///
/// ```
/// use subcert::bound::{Rounded, log_level};
/// use subcert::exact::Rational;
///
/// let half = Rational::new(1, 2);
/// assert_eq!(log_level(&half, &Rational::new(1, 8), Rounded::Up)?, 3);
/// assert_eq!(log_level(&half, &Rational::new(1, 9), Rounded::Up)?, 4);
/// assert_eq!(log_level(&half, &Rational::new(1, 9), Rounded::Nearest)?, 3);
/// # Ok::<(), subcert::bound::DepthError>(())
/// ```
pub fn log_level(ratio: &Rational, x: &Rational, rounded: Rounded) -> Result<u32, DepthError> {
    if ratio.sign() <= 0 {
        return Err(DepthError::NotPositive { what: "the ratio", value: ratio.to_string() });
    }
    if *ratio >= Rational::one() {
        return Err(DepthError::NoContraction(crate::exact::format::short(ratio, 6)));
    }
    match rounded {
        Rounded::Up => least_level(&Rational::one(), ratio, x),
        Rounded::Down => {
            let up = least_level(&Rational::one(), ratio, x)?;
            // If x is a power of the ratio, both directions agree.
            let exact = ratio.pow(up.cast_signed()) == *x;
            Ok(if exact { up } else { up.saturating_sub(1) })
        }
        Rounded::Nearest => {
            // ⌊t + 1/2⌋ for t = log_ratio(x) is k = ⌈t⌉ if ratio^(2k−1) ≥ x², and k − 1 otherwise.
            let up = least_level(&Rational::one(), ratio, x)?;
            let nearer = up == 0 || ratio.pow((2 * up).cast_signed() - 1) >= x * x;
            Ok(if nearer { up } else { up - 1 })
        }
    }
}

/// The least level k ≥ 0 with factor · ratio^k ≤ tolerance, computed with integers only.
///
/// # Errors
/// When ratio is not in [0, 1) although the factor exceeds the tolerance, the
/// tolerance is not positive, the factor is negative, or the depth is beyond the caps.
///
/// ```
/// use subcert::bound::least_level;
/// use subcert::exact::Rational;
///
/// let k = least_level(&Rational::from(10), &Rational::new(1, 10), &Rational::new(1, 100))?;
/// assert_eq!(k, 3);
/// # Ok::<(), subcert::bound::DepthError>(())
/// ```
pub fn least_level(
    factor: &Rational,
    ratio: &Rational,
    tolerance: &Rational,
) -> Result<u32, DepthError> {
    if tolerance.sign() <= 0 {
        let value = tolerance.to_string();
        return Err(DepthError::NotPositive { what: "the tolerance", value });
    }
    if factor.sign() < 0 {
        let value = factor.to_string();
        return Err(DepthError::NotPositive { what: "the factor of a bound", value });
    }
    if factor <= tolerance {
        return Ok(0);
    }
    if *ratio >= Rational::one() || ratio.sign() < 0 {
        let value = crate::exact::format::short(ratio, 6);
        return Err(DepthError::NoContraction(value));
    }
    if ratio.is_zero() {
        return Ok(1);
    }
    // factor·(p/q)^k ≤ tolerance  ⇔  left·p^k ≤ right·q^k.
    let left = factor.numerator() * tolerance.denominator();
    let right = tolerance.numerator() * factor.denominator();
    let (p, q) = (ratio.numerator(), ratio.denominator());
    let limit = u32::try_from(MAX_POWER_BITS / q.bits()).unwrap_or(MAX_DEPTH).min(MAX_DEPTH);
    least(limit, [left, right], [p, q]).ok_or(DepthError::TooDeep)
}

/// The least k in 1, …, `limit` with left·p^k ≤ right·q^k, where p < q and left > right; `None` if there is
/// none. The greatest k with left·p^k > right·q^k is found digit by digit, from squares of squares of p and q.
fn least(limit: u32, [left, right]: [Integer; 2], [p, q]: [Integer; 2]) -> Option<u32> {
    let times =
        |sides: &[Integer; 2], power: &[Integer; 2]| [&sides[0] * &power[0], &sides[1] * &power[1]];
    let meets = |sides: &[Integer; 2]| sides[0] <= sides[1];
    let mut powers = vec![[p, q]];
    let (mut sides, mut step) = ([left, right], 1);
    while let Some(last) = powers.last().filter(|_| 2 * step <= limit)
        && !meets(&times(&sides, last))
    {
        powers.push(times(last, last));
        step *= 2;
    }
    let mut greatest = 0;
    for power in powers.iter().rev() {
        let next = times(&sides, power);
        if greatest + step <= limit && !meets(&next) {
            (sides, greatest) = (next, greatest + step);
        }
        step /= 2;
    }
    (greatest < limit).then_some(greatest + 1)
}
