//! Progress as lines on the standard error, for the page in a browser.

use subcert::files::is_confined;

/// What every line begins with; `web/wasi.js` knows it too.
pub(crate) const PREFIX: &str = "progress: ";

/// Whether a page reads these lines.
pub(super) fn are_read() -> bool {
    cfg!(target_family = "wasm") || is_confined()
}

/// The line of a template of a bar, without the bar and the time, which the page shows itself.
pub(super) fn line(template: &str, position: u64, length: u64, message: &str) -> String {
    let percent = position.saturating_mul(100).checked_div(length).unwrap_or(0);
    let parts = [
        ("{bar:40} ", String::new()),
        ("{spinner} ", String::new()),
        (", {elapsed}", String::new()),
        ("{pos}", position.to_string()),
        ("{len}", length.to_string()),
        ("{percent}", percent.to_string()),
        ("{msg}", message.to_owned()),
    ];
    parts.iter().fold(format!("{PREFIX}{template}"), |line, (name, text)| line.replace(name, text))
}
