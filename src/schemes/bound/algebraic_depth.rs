//! Levels for algebraic ratios.

use super::depth::{DepthError, MAX_POWER_BITS, Rounded, log_level};
use crate::exact::{Enclosed, RealCyclotomic, format};

/// The precision from which equality is tested. Enclosures to 256 binary digits leave two
/// levels possible only at an equality or very close to one.
const EXACT_FROM: u32 = 2;

/// The last precision that is tried.
const MAX_PRECISION: u32 = 10;

/// [`log_level`] for real numbers of the fields Q(2cos(2π/n)).
///
/// Enclosures of both numbers are refined until their ends give the same level. The
/// refinement would never end if a power of the ratio equals x, or, for
/// [`Rounded::Nearest`], if an odd power equals x². These cases are tested exactly.
///
/// # Errors
/// As [`log_level`].
///
/// ```
/// use subcert::bound::{Rounded, log_level_algebraic};
/// use subcert::exact::{Rational, RealCyclotomic};
///
/// // The golden ratio less 1, and its fourth power.
/// let cosine = RealCyclotomic::cosine(&Rational::new(1, 5))?;
/// let ratio = &cosine + &cosine;
/// let square = &ratio * &ratio;
/// assert_eq!(log_level_algebraic(&ratio, &(&square * &square), Rounded::Up)?, 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn log_level_algebraic(
    ratio: &RealCyclotomic,
    x: &RealCyclotomic,
    rounded: Rounded,
) -> Result<u32, DepthError> {
    if let (Some(ratio), Some(x)) = (ratio.as_rational(), x.as_rational()) {
        return log_level(ratio, x, rounded);
    }
    for (what, value) in [("the ratio", ratio), ("the tolerance", x)] {
        if value.sign() <= 0 {
            return Err(DepthError::NotPositive { what, value: value.to_string() });
        }
    }
    if *ratio >= RealCyclotomic::from(1) {
        return Err(DepthError::NoContraction(format::short(ratio, 6)));
    }
    for precision in 0..=MAX_PRECISION {
        let (base, target) = (ratio.enclosure(precision), x.enclosure(precision));
        // The level increases with the ratio and decreases with x.
        let ends = [(base.lower(), target.upper()), (base.upper(), target.lower())];
        let [least, greatest] = ends.map(|(ratio, x)| log_level(ratio, x, rounded));
        match (least, greatest) {
            (Ok(least), Ok(greatest)) if least == greatest => return Ok(least),
            (Ok(least), Ok(greatest)) if precision >= EXACT_FROM => {
                if let Some(level) = equality(ratio, x, rounded, least..=greatest)? {
                    return Ok(level);
                }
            }
            (_, Err(DepthError::TooDeep)) => return Err(DepthError::TooDeep),
            // The enclosure still reaches 0 or 1.
            _ => {}
        }
    }
    Err(DepthError::TooDeep)
}

/// The level k in `levels` with ratio^k = x, or, for [`Rounded::Nearest`], ratio^(2k−1) =
/// x².
fn equality(
    ratio: &RealCyclotomic,
    x: &RealCyclotomic,
    rounded: Rounded,
    mut levels: std::ops::RangeInclusive<u32>,
) -> Result<Option<u32>, DepthError> {
    let bits = u64::from(2 * *levels.end()) * ratio.bits();
    if bits > MAX_POWER_BITS {
        return Err(DepthError::TooDeep);
    }
    Ok(levels.find(|&level| match rounded {
        Rounded::Up | Rounded::Down => power(ratio, level) == *x,
        Rounded::Nearest => level > 0 && power(ratio, 2 * level - 1) == x * x,
    }))
}

/// base^exponent, by squaring.
fn power(base: &RealCyclotomic, exponent: u32) -> RealCyclotomic {
    let half = || power(base, exponent / 2);
    match (exponent, exponent % 2) {
        (0, _) => RealCyclotomic::from(1),
        (_, 0) => {
            let half = half();
            &half * &half
        }
        _ => {
            let half = half();
            &(&half * &half) * base
        }
    }
}
