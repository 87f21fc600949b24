//! The rounding of a printed decimal.

use crate::audit::reading::{Choice, Effect, Way};

/// To the nearest, or otherwise.
pub(in crate::audit) const DECIMAL_ROUNDING: Choice = Choice {
    name: "rounding of the decimals",
    effect: Effect::Decimal,
    ways: &[
        Way { word: "nearest", says: "decimals rounded to the nearest" },
        Way { word: "cut", says: "decimals cut" },
        Way { word: "away", says: "decimals rounded away from zero" },
    ],
    source: "Khan et al. 2019, Tables 1 to 3",
};
