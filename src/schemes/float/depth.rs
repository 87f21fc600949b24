//! Subdivision depths by logarithms in f64, compared with the exact depths.

use crate::bound::{DepthError, MAX_DEPTH, least_level};
use crate::exact::Rational;
use crate::machine::nearest;

/// The greatest number of binary digits of a power in the computation of a margin.
const MAX_MARGIN_BITS: u64 = 1 << 20;

/// One depth, the least k with σβ C^k/(1 − C) ≤ ε, computed in f64 and exactly.
#[derive(Clone, Debug, PartialEq)]
pub struct DepthDecision {
    /// The block length c of the constant C. k counts blocks of c levels, as in the
    /// papers. For a bound level by level, see [`SoundBound`](crate::bound::SoundBound).
    pub block: u32,
    /// ε.
    pub tolerance: Rational,
    /// The f64 value of ln(ε(1−C)/(σβ))/ln C before it is rounded up; it may be NaN
    /// or infinite.
    pub logarithm: f64,
    /// The f64 depth; `None` when C ≥ 1, the logarithm is NaN, or the depth is beyond
    /// [`MAX_DEPTH`].
    pub float: Option<u32>,
    /// The exact depth, or the reason why there is none.
    pub exact: Result<u32, DepthError>,
    /// Whether both results agree; they also agree if neither gives a depth. `None` when
    /// the exact depth is beyond the caps.
    pub agree: Option<bool>,
    /// How close the exact depth is to another one; `None` without an exact depth, or
    /// when the powers have more than 2^20 binary digits.
    pub margin: Option<Margin>,
}

/// How close the bounds at the levels k and k − 1 are to the tolerance, for an exact
/// depth k.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Margin {
    /// bound(k)/ε ≤ 1.
    pub at: Rational,
    /// bound(k − 1)/ε > 1; `None` for k = 0.
    pub before: Option<Rational>,
}

/// The depth as a programmer computes it: ⌈ln(ε(1−C)/(σβ))/ln C⌉, at least 0, all in f64.
/// Returns the quotient before it is rounded, and the depth: `None` when C is not below
/// 1, the quotient is NaN, or the depth is beyond [`MAX_DEPTH`].
///
/// Unlike +, −, ·, /, the logarithm of the standard library is not correctly rounded. Its
/// last digits may depend on the platform.
///
/// ```
/// use subcert::float::float_depth;
///
/// // 1·(1/2)^k/(1 − 1/2) ≤ 1/8 from k = 4 on.
/// assert_eq!(float_depth(1.0, 1.0, 0.5, 0.125), (4.0, Some(4)));
/// // It does not shrink.
/// assert_eq!(float_depth(1.0, 1.0, 1.5, 0.125).1, None);
/// ```
#[must_use]
pub fn float_depth(sigma: f64, spread: f64, ratio: f64, tolerance: f64) -> (f64, Option<u32>) {
    let quotient = (tolerance * (1.0 - ratio) / (sigma * spread)).ln() / ratio.ln();
    let level = quotient.ceil().max(0.0);
    let usable = ratio < 1.0 && !quotient.is_nan() && level <= f64::from(MAX_DEPTH);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 ≤ it ≤ 100000")]
    let decision = usable.then_some(level as u32);
    (quotient, decision)
}

/// The factor σ and the ratio C of a bound, in f64 and exactly.
pub(super) struct Bound<'a> {
    pub block: u32,
    pub spread: &'a Rational,
    pub float: (f64, f64),
    pub exact: (&'a Rational, &'a Rational),
}

impl Bound<'_> {
    pub(super) fn decide(&self, tolerance: &Rational) -> DepthDecision {
        let (sigma, ratio) = self.float;
        let (logarithm, float) =
            float_depth(sigma, nearest(self.spread), ratio, nearest(tolerance));
        let exact = self.exact_depth(tolerance);
        let agree = match &exact {
            Err(DepthError::TooDeep) => None,
            other => Some(other.as_ref().ok() == float.as_ref()),
        };
        let margin = exact.as_ref().ok().and_then(|&level| self.margin(tolerance, level));
        let tolerance = tolerance.clone();
        DepthDecision { block: self.block, tolerance, logarithm, float, exact, agree, margin }
    }

    fn exact_depth(&self, tolerance: &Rational) -> Result<u32, DepthError> {
        let ratio = self.exact.1;
        if *ratio >= Rational::one() {
            return Err(DepthError::NoContraction(crate::exact::format::short(ratio, 6)));
        }
        least_level(&self.factor(), ratio, tolerance)
    }

    /// σβ/(1 − C), for C ≠ 1.
    fn factor(&self) -> Rational {
        self.exact.0 * self.spread / (Rational::one() - self.exact.1)
    }

    fn margin(&self, tolerance: &Rational, level: u32) -> Option<Margin> {
        if self.exact.1.bits().saturating_mul(u64::from(level)) > MAX_MARGIN_BITS {
            return None;
        }
        let unit = self.factor() / tolerance;
        let at = |k: u32| &unit * self.exact.1.pow(k.cast_signed());
        Some(Margin { at: at(level), before: level.checked_sub(1).map(at) })
    }
}
