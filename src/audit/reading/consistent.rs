//! Whether a printed decimal can stand for an exact value.

use super::choices::DECIMAL_ROUNDING;
use super::search::Difference;
use crate::exact::{Decimal, RealCyclotomic};

/// How a decimal was rounded, as [`DECIMAL_ROUNDING`](super::choices::DECIMAL_ROUNDING)
/// names the ways.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DecimalRounding {
    Nearest,
    Cut,
    Away,
}

impl DecimalRounding {
    pub(super) const ALL: [(Option<&'static str>, DecimalRounding); 3] = [
        (None, DecimalRounding::Nearest),
        (Some("cut"), DecimalRounding::Cut),
        (Some("away"), DecimalRounding::Away),
    ];

    /// How a reading with this rounding differs from one that rounds to the nearest.
    pub(super) fn difference(self) -> Option<Difference> {
        let (word, _) = DecimalRounding::ALL.into_iter().find(|(_, way)| *way == self)?;
        let way = DECIMAL_ROUNDING.ways.iter().find(|way| Some(way.word) == word)?;
        Some(Difference { choice: DECIMAL_ROUNDING.name.to_owned(), says: way.says.to_owned() })
    }

    /// Whether `exact` becomes `printed`.
    pub(super) fn gives(self, printed: &Decimal, exact: &RealCyclotomic) -> bool {
        let number = |value| RealCyclotomic::from(value);
        let unit = number(printed.unit());
        let value = number(printed.value());
        if value.sign() * exact.sign() < 0 {
            return false;
        }
        // How much was lost towards zero.
        let lost = &exact.abs() - &value.abs();
        match self {
            DecimalRounding::Nearest => &lost.abs() + &lost.abs() <= unit,
            DecimalRounding::Cut => lost.sign() >= 0 && lost < unit,
            DecimalRounding::Away => lost.sign() <= 0 && -&lost < unit,
        }
    }
}
