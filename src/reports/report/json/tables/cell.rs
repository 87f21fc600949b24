//! The findings about a cell of a table.

use super::promise::Promise;
use crate::audit::{self, CellFinding};
use crate::report::json::exact::{Exact, decimal};
use serde::Serialize;

/// A cell under another reading than the printed one.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct AsRead {
    /// How the reading differs from the printed text.
    pub differs: String,
    /// The value of the cell under the reading.
    pub exact: String,
    /// That value as a decimal.
    pub decimal: String,
}

/// The sound value of a printed bound or depth, and whether its promise is kept, whatever its
/// verdict is.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CellSound<'a> {
    /// The sound value; its fields stand here.
    #[serde(flatten)]
    pub value: SoundValue,
    /// Whether the printed number is at least the value of the printed formula, of a depth rounded
    /// up.
    pub kept_by_formula: Option<bool>,
    /// Whether the printed number is at least the sound value, so that it keeps its promise.
    pub kept_by_sound_bound: Option<bool>,
    /// Whether it keeps its promise for all control data; its fields stand here, and are missing
    /// where there is no promise.
    #[serde(flatten)]
    pub promise: Option<Promise<'a>>,
}

/// A sound value.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum SoundValue {
    /// A depth by the sound bound.
    Depth {
        /// The least level at which the bound meets the tolerance.
        depth: u32,
        /// The block length of the bound.
        block: u32,
    },
    /// The true depth of a ring.
    Least {
        /// The least level from which on the tolerance is met.
        depth: u32,
        /// Always true.
        least: bool,
    },
    /// An upper bound of the distance.
    Bound(Exact),
    /// There is none.
    None {
        /// The reason.
        none: String,
    },
}

impl AsRead {
    pub(crate) fn of(read: &audit::AsRead) -> AsRead {
        AsRead {
            differs: read.differs(),
            exact: read.value.to_string(),
            decimal: decimal(&read.value),
        }
    }
}

impl<'a> CellSound<'a> {
    pub(crate) fn of(sound: &'a audit::Sound, cell: &'a CellFinding) -> CellSound<'a> {
        CellSound {
            value: match sound {
                audit::Sound::Depth { level, block } => {
                    SoundValue::Depth { depth: *level, block: *block }
                }
                audit::Sound::Least(level) => SoundValue::Least { depth: *level, least: true },
                audit::Sound::Bound(bound) => SoundValue::Bound(Exact::of(bound)),
                audit::Sound::None(why) => SoundValue::None { none: why.to_string() },
            },
            kept_by_formula: cell.kept_by_formula,
            kept_by_sound_bound: cell.kept_by_sound,
            promise: Promise::of(cell),
        }
    }
}
