//! The parameter at which a new point is compared.

use crate::audit::reading::{Choice, Effect, Way};

/// The index offset 0 that the papers print, or the scheme's own.
pub(in crate::audit) const OFFSET: Choice = Choice {
    name: "offset",
    effect: Effect::Option { option: "offset", functions: &["displacement"] },
    ways: &[
        Way { word: "0", says: "displacement at offset 0" },
        Way { word: "own", says: "displacement at the scheme's own offset" },
    ],
    source: "the papers print their masks from index 0, whatever the scheme's own offset is",
};
