//! Better offsets for scheme files that state none.

use crate::cli::console::output::Failure;
use serde::Serialize;
use subcert::bound;
use subcert::exact::format::short;
use subcert::report::json;
use subcert::scheme::{Scheme, files_without_offset};

/// An offset that is better than 0, which is taken where a file states none.
#[derive(PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct BetterOffset {
    /// The file.
    file: String,
    /// The better offset.
    #[serde(flatten)]
    better: json::BetterOffset,
    /// It in words.
    #[serde(skip)]
    pub(crate) words: String,
}

impl BetterOffset {
    /// The better offsets of a scheme, one for each file that states none. `text` is the scheme as
    /// given.
    pub(crate) fn all_of(text: &str, scheme: &Scheme) -> Result<Vec<BetterOffset>, Failure> {
        let mut found = Vec::new();
        for (file, mask) in files_without_offset(text)?.into_iter().zip(scheme.masks()) {
            let better = file.zip(bound::BetterOffset::of(mask));
            let better = better.map(|(file, better)| BetterOffset::new(file, &better));
            found.extend(better.filter(|better| !found.contains(better)));
        }
        Ok(found)
    }

    fn new(file: String, better: &bound::BetterOffset) -> BetterOffset {
        let bound::BetterOffset { offset, least, at_zero } = better;
        let words = format!(
            "`{file}` states no offset, so it is 0, with σ = {}. At offset {offset} σ is {}, and the \
             depth by the sound bound is never greater. The points of a level are then numbered \
             differently; the limit stays the same. For that, write in the file, beside the mask: \
             offset = '{offset}'",
            short(at_zero, 9),
            short(least, 9)
        );
        BetterOffset { file, better: json::BetterOffset::of(better), words }
    }
}
