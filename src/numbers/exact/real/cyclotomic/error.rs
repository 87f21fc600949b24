//! Errors of cosines: the value is irrational, or its field is too large.

use crate::cap::Cap;
use crate::exact::{Integer, Rational};

/// The largest conductor n of the fields Q(2cos(2π/n)) in which the program computes.
pub const MAX_CONDUCTOR: u32 = 10_000;

/// Why a cosine is not a number of the required kind.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CosineError {
    /// A rational number was needed.
    #[error("cos({angle}) is not rational")]
    Irrational {
        /// The angle as a formula, such as `2*pi/5`.
        angle: String,
    },
    /// The least n such that all the cosines are in Q(2cos(2π/n)) is beyond
    /// [`MAX_CONDUCTOR`].
    #[error(
        "the cosines need the field of 2cos(2π/n) for n = {conductor}; \
         at most n = {MAX_CONDUCTOR} is computed in"
    )]
    Conductor {
        /// n.
        conductor: String,
    },
}

impl CosineError {
    /// cos(2π·`turn`) is not rational.
    pub(crate) fn irrational(turn: &Rational) -> CosineError {
        CosineError::Irrational { angle: angle(turn) }
    }

    /// The cap that the conductor is beyond.
    #[must_use]
    pub fn cap(&self) -> Option<Cap> {
        let what = "n of the field of 2cos(2π/n) that the cosines need";
        match self {
            CosineError::Irrational { .. } => None,
            CosineError::Conductor { .. } => Some(Cap::new(what, MAX_CONDUCTOR.into())),
        }
    }
}

/// The conductor lcm(m, n) of a field that contains the fields of conductors m and n.
///
/// # Errors
/// When lcm(m, n) is beyond [`MAX_CONDUCTOR`]. Arithmetic with numbers of two such fields
/// panics, so callers check here first.
pub fn common_conductor(m: u32, n: u32) -> Result<u32, CosineError> {
    let lcm = num_integer::lcm(u64::from(m), u64::from(n));
    match u32::try_from(lcm) {
        Ok(lcm) if lcm <= MAX_CONDUCTOR => Ok(lcm),
        _ => Err(CosineError::Conductor { conductor: lcm.to_string() }),
    }
}

/// 2π·`turn` as a formula: `0`, `pi`, `2*pi/5`.
pub(super) fn angle(turn: &Rational) -> String {
    let halves = turn + turn;
    let (p, q) = (halves.numerator(), halves.denominator());
    let top = match p.to_i64() {
        Some(0) => return "0".to_owned(),
        Some(1) => "pi".to_owned(),
        Some(-1) => "-pi".to_owned(),
        _ => format!("{p}*pi"),
    };
    if q == Integer::one() { top } else { format!("{top}/{q}") }
}
