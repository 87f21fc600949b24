//! Reading the list of a paper's numbered items, and which of them are claimed.

use super::fields::CommonFields;
use super::reader::Reader;
use crate::claim::{Item, Label};
use crate::diagnostic::Diagnostic;
use crate::scheme::Spanned;
use serde::Deserialize;
use std::ops::Range;

#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct UnclaimedTable {
    /// What the paper numbers: `(1), (4)-(6)`.
    locus: Spanned<String>,
    /// Why nothing of it can be checked.
    reason: String,
}

const HELP: &str = "numbered = [\"(1)-(37)\", \"Theorem 1-2\"] in [paper] lists them all";

/// How many lists of numbered items an error repeats.
const MAX_LISTS: usize = 3;

impl Reader<'_> {
    /// The numbered items of the paper, each with the claims whose locus names it or
    /// with the reason that there is none. A paper without a list has no items.
    pub(super) fn contents<'f>(
        &self,
        numbered: &[Spanned<String>],
        claims: impl Iterator<Item = CommonFields<'f>>,
        unclaimed: &[UnclaimedTable],
    ) -> Result<Vec<Item>, Diagnostic> {
        let mut items: Vec<Item> = Vec::new();
        let lists = numbered.iter().take(MAX_LISTS).map(|list| format!("\"{}\", ", list.get_ref()));
        let help = format!(
            "add it to the list in [paper], numbered = [{}…], or mend this place",
            lists.collect::<String>()
        );
        for list in numbered {
            for label in self.labels(list, Label::list)? {
                if items.iter().any(|item| item.label == label) {
                    return Err(self.error(list.span(), format!("{label} is listed twice")));
                }
                items.push(Item { label, claims: Vec::new(), reason: None });
            }
        }
        if !items.is_empty() {
            for CommonFields { id, locus, .. } in claims {
                for label in self.labels(locus, Label::in_locus)? {
                    for item in self.covered(&mut items, &label, locus.span(), &help)? {
                        if item.claims.last() != Some(id.get_ref()) {
                            item.claims.push(id.get_ref().clone());
                        }
                    }
                }
            }
        }
        for UnclaimedTable { locus, reason } in unclaimed {
            for label in self.labels(locus, Label::list)? {
                for item in self.covered(&mut items, &label, locus.span(), &help)? {
                    if let Some(id) = item.claims.first() {
                        let message = format!("{} is claimed, by `{id}`", item.label);
                        return Err(self.error(locus.span(), message));
                    }
                    if item.reason.replace(reason.clone()).is_some() {
                        let message = format!("{} has two reasons", item.label);
                        return Err(self.error(locus.span(), message));
                    }
                }
            }
        }
        Ok(items)
    }

    fn labels(
        &self,
        text: &Spanned<String>,
        read: impl Fn(&str) -> Result<Vec<Label>, String>,
    ) -> Result<Vec<Label>, Diagnostic> {
        read(text.get_ref()).map_err(|reason| self.error(text.span(), reason).with_help(HELP))
    }

    /// The items that a label covers: the item itself, or its lettered parts.
    fn covered<'i>(
        &self,
        items: &'i mut [Item],
        label: &Label,
        span: Range<usize>,
        help: &str,
    ) -> Result<Vec<&'i mut Item>, Diagnostic> {
        let covered: Vec<&mut Item> =
            items.iter_mut().filter(|item| label.covers(&item.label)).collect();
        if covered.is_empty() {
            let message = format!("{label} is not among the numbered items of the paper");
            return Err(self.error(span, message).with_help(help));
        }
        Ok(covered)
    }
}
