//! Better offsets for scheme files that state none.

use crate::cli::console::output::Failure;
use crate::cli::json::offset as form;
use subcert::bound::BetterOffset;
use subcert::exact::format::short;
use subcert::report::{Sheet, json};
use subcert::scheme::{Scheme, files_without_offset};

/// A better offset of a file that states none.
#[derive(PartialEq)]
pub(crate) struct OfFile {
    file: String,
    better: BetterOffset,
}

impl OfFile {
    /// The better offsets of a scheme, one for each file that states none. `text` is the scheme as
    /// given.
    pub(crate) fn all_of(text: &str, scheme: &Scheme) -> Result<Vec<OfFile>, Failure> {
        let mut found = Vec::new();
        for (file, mask) in files_without_offset(text)?.into_iter().zip(scheme.masks()) {
            let better = file.zip(BetterOffset::of(mask));
            let better = better.map(|(file, better)| OfFile { file, better });
            found.extend(better.filter(|better| !found.contains(better)));
        }
        Ok(found)
    }

    pub(crate) fn write(&self, sheet: &mut Sheet) {
        let OfFile { file, better: BetterOffset { offset, least, at_zero } } = self;
        sheet.text(format!(
            "`{file}` states no offset, so it is 0, with σ = {}. At offset {offset} σ is {}, and the \
             depth by the sound bound is never greater. The points of a level are then numbered \
             otherwise; the limit stays the same. To have it so, write in the file, beside the mask: \
             offset = '{offset}'",
            short(at_zero, 9),
            short(least, 9)
        ));
    }

    pub(crate) fn form(&self) -> form::BetterOffset<'_> {
        form::BetterOffset { file: &self.file, better: json::BetterOffset::of(&self.better) }
    }
}
