//! The sections of claims.

use super::certified::certified;
use super::command;
use super::context::Context;
use super::sheet::lines;
use super::typeset::typeset;
use super::verdict::{Look, badge};
use crate::audit::{Finding, Word};
use crate::diagnostic::Diagnostic;
use crate::report::told::told;
use maud::{Markup, html};

/// The section of a claim.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub(super) fn section(
    context: &Context<'_, '_>,
    finding: Finding<'_, '_>,
) -> Result<Markup, Diagnostic> {
    let contents = told(finding).contents(context)?;
    if matches!(finding, Finding::Table(_)) {
        return Ok(contents);
    }
    let (claim, verdict) = (finding.claim(), finding.word().unwrap_or(Word::Open));
    // An equation that fails says its note itself.
    let says_note = matches!(finding, Finding::Equation(_)) && verdict == Word::Fails;
    let note = claim.note().filter(|_| !says_note);
    let (id, locus, title) = (claim.id(), claim.locus(), claim.title());
    Ok(html! {
        section.claim.(Look::of(verdict).class) id=(id) aria-labelledby={ "page:title-" (id) } {
            h3 id={ "page:title-" (id) } {
                (badge(verdict)) " " a href={ "#" (id) } { (typeset(locus)) } " " span.title { (typeset(title)) }
            }
            (contents)
            @if let Some(note) = note { p.note { (lines(note)) } }
            (certified(context, id))
            (command::explain(context, id))
        }
    })
}
