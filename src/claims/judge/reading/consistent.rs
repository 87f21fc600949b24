//! Whether a printed decimal can stand for an exact value.

use crate::evaluation::choices::DECIMAL_ROUNDING;
use crate::exact::{Decimal, RealCyclotomic, Rounding};
use crate::finding::Difference;

/// How a decimal was rounded, as [`DECIMAL_ROUNDING`](super::choices::DECIMAL_ROUNDING)
/// names the ways.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DecimalRounding {
    Nearest,
    Cut,
    Away,
}

impl DecimalRounding {
    pub(crate) const ALL: [(Option<&'static str>, DecimalRounding); 3] = [
        (None, DecimalRounding::Nearest),
        (Some("cut"), DecimalRounding::Cut),
        (Some("away"), DecimalRounding::Away),
    ];

    /// How a reading with this rounding differs from one that rounds to the nearest.
    pub(crate) fn difference(self) -> Option<Difference> {
        let (word, _) = DecimalRounding::ALL.into_iter().find(|(_, way)| *way == self)?;
        let way = DECIMAL_ROUNDING.ways.iter().find(|way| Some(way.word) == word)?;
        Some(Difference::Way(&DECIMAL_ROUNDING, way))
    }

    /// Whether `exact` becomes `printed`.
    pub(crate) fn gives(self, printed: &Decimal, exact: &RealCyclotomic) -> bool {
        let rounding = printed.rounding_of(exact);
        let shown = || RealCyclotomic::from(printed.value()).abs();
        rounding != Rounding::Neither
            && match self {
                DecimalRounding::Nearest => {
                    matches!(rounding, Rounding::Exact | Rounding::Nearest)
                }
                DecimalRounding::Cut => shown() <= exact.abs(),
                DecimalRounding::Away => shown() >= exact.abs(),
            }
    }
}
