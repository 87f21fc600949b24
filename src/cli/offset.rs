//! Better offsets for scheme files that state none.

use super::json::offset as form;
use super::output::Failure;
use subcert::bound::{Terms, best_offset, displacement};
use subcert::exact::{Rational, format::short};
use subcert::report::{Sheet, json::Exact};
use subcert::scheme::{Scheme, files_without_offset};

/// An offset with a smaller σ than that of offset 0, which is taken where a file states none.
#[derive(PartialEq)]
pub(super) struct BetterOffset {
    file: String,
    offset: i64,
    /// σ at that offset.
    least: Rational,
    /// σ at offset 0.
    at_zero: Rational,
}

impl BetterOffset {
    /// The better offsets of a scheme, one for each file that states none. `text` is the scheme as
    /// given.
    pub(super) fn all_of(text: &str, scheme: &Scheme) -> Result<Vec<BetterOffset>, Failure> {
        let mut found = Vec::new();
        for (file, mask) in files_without_offset(text)?.into_iter().zip(scheme.masks()) {
            let Some(file) = file else { continue };
            let (offset, least) = best_offset(mask);
            let at_zero = displacement(mask, Terms::Each);
            if least >= at_zero {
                continue;
            }
            let better = BetterOffset { file, offset, least, at_zero };
            if !found.contains(&better) {
                found.push(better);
            }
        }
        Ok(found)
    }

    pub(super) fn write(&self, sheet: &mut Sheet) {
        let BetterOffset { file, offset, least, at_zero } = self;
        sheet.text(format!(
            "`{file}` states no offset, so it is 0, with σ = {}. At offset {offset} σ is {}, and the \
             depth by the sound bound is never greater. The points of a level are then numbered \
             otherwise; the limit stays the same. To have it so, write in the file, beside the mask: \
             offset = '{offset}'",
            short(at_zero, 9),
            short(least, 9)
        ));
    }

    pub(super) fn form(&self) -> form::BetterOffset<'_> {
        form::BetterOffset {
            file: &self.file,
            offset: self.offset,
            displacement: Exact::of(&self.least),
            displacement_at_zero: Exact::of(&self.at_zero),
        }
    }
}
