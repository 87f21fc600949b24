//! The choice of the verdicts that a page shows: radio buttons, which the style sheet reads.

use super::verdict::{BROKEN, LOOKS, Look};
use crate::audit::{CellFinding, Kept, PaperAudit};
use maud::{Markup, html};

/// How many cells and other claims have this look.
fn count(audit: &PaperAudit<'_>, look: &Look) -> usize {
    let claims = audit.claims();
    let verdicts = claims.iter().flat_map(|claim| claim.verdicts.iter());
    verdicts.filter(|(word, _)| Look::of(*word).class == look.class).map(|(_, count)| count).sum()
}

/// Whether a printed number does not keep its promise.
pub(super) fn is_broken(cell: &CellFinding) -> bool {
    matches!(cell.kept, Some(Kept::No(_)))
}

/// The buttons, of looks that the page has.
pub(super) fn buttons(audit: &PaperAudit<'_>) -> Markup {
    let broken = audit.promise_counts().broken;
    html! {
        fieldset.filter {
            legend { "Show" }
            (button("all", true, &html! { "everything" }))
            @for look in &LOOKS {
                @let count = count(audit, look);
                @if count > 0 {
                    (button(look.class, false, &html! {
                        span class={ "sign " (look.class) } aria-hidden="true" { (look.sign()) }
                        " " (look.says) " (" (count) ")"
                    }))
                }
            }
            @if broken > 0 {
                (button(BROKEN, false, &html! {
                    span class={ "sign " (BROKEN) } aria-hidden="true" { "⚑" }
                    " promise broken (" (broken) ")"
                }))
            }
        }
    }
}

fn button(name: &str, checked: bool, label: &Markup) -> Markup {
    html! {
        label {
            input type="radio" name="show" id={ "page:show-" (name) } value=(name) checked[checked];
            span { (label) }
        }
    }
}
