//! The command that shows a finding again.

use super::context::Context;
use maud::{Markup, html};

/// `subcert explain khan2019-newton:table-1:2:3`, with the claim file of a paper that is not embedded.
pub(super) fn explain(context: &Context<'_, '_>, id: &str) -> Markup {
    let file = context.file.map(|file| format!(" {}", quoted(file))).unwrap_or_default();
    html! {
        p.command {
            "Reproduce: " code { "subcert explain " (context.audit.paper.key) ":" (id) (file) }
        }
    }
}

/// A text as a word of a shell.
///
/// ```
/// use subcert::report::html::shell_word;
///
/// assert_eq!(shell_word("my paper.toml"), "'my paper.toml'");
/// ```
#[must_use]
pub fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./:=,".contains(c);
    if !text.is_empty() && text.chars().all(plain) {
        return text.to_owned();
    }
    format!("'{}'", text.replace('\'', "'\\''"))
}
