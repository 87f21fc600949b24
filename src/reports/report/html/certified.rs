//! The lines of a certificate that are about a claim.

use super::command::quoted;
use super::context::Context;
use crate::report::json::Certificate;
use maud::{Markup, html};

/// The most characters of them on a page.
const MAX_HELD: usize = 20_000;

/// The lines about the claim of this id, behind a word that unfolds them, and the command that writes the whole
/// certificate; nothing of a claim that no certificate is about.
pub(super) fn certified(context: &Context<'_, '_>, id: &str) -> Markup {
    let checked = context.checked.and_then(|checked| checked.get(id));
    html! {
        @if let Some(Certificate { certified, certificate }) = checked {
            p.command {
                @if *certified { "✓ subcert-check has found the certificate valid." }
                @else { "By subcert-check, the certificate is " (certificate) "." }
            }
        }
        @match context.certificate.get(id) {
            None => {}
            Some(Err(why)) => p.command { "No certificate: " (why) }
            Some(Ok(lines)) => (folded(context, lines))
        }
    }
}

/// The lines about one cell of a table.
pub(super) fn of_cell(context: &Context<'_, '_>, table: &str, at: (usize, usize)) -> Markup {
    let Some(Ok(lines)) = context.certificate.get(table) else { return html! {} };
    let (row, column) = ((at.0 + 1).to_string(), (at.1 + 1).to_string());
    let is_own = |line: &&str| {
        let mut words = line.split_whitespace().skip(1);
        words.next() == Some(&row) && words.next() == Some(&column)
    };
    let own: Vec<&str> = lines.lines().filter(is_own).collect();
    html! { @if !own.is_empty() { (folded(context, &own.join("\n"))) } }
}

fn folded(context: &Context<'_, '_>, lines: &str) -> Markup {
    let key = match context.file {
        Some(file) => quoted(file),
        None => context.audit.paper.key.clone(),
    };
    let held: String = lines.chars().take(MAX_HELD).collect();
    let count = lines.lines().count();
    html! {
        details.certificate {
            summary { "Certificate: " (count) @if count == 1 { " line" } @else { " lines" } }
            pre tabindex="0" { (held) }
            @if held.len() < lines.len() { p.remark { "The rest stands in the whole certificate." } }
            p.command { "All claims: " code { "subcert prove " (key) " -o -" } }
        }
    }
}
