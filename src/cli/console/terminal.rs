//! The size of the terminal, and the flags of all commands about output.

use crate::cli::arguments::Colour;
use anstream::ColorChoice;
use std::ffi::OsString;
use std::sync::OnceLock;
#[cfg(not(target_family = "wasm"))]
use terminal_size::terminal_size_of;
#[cfg(target_family = "wasm")]
use terminal_size::{Height, Width};

/// The height, in lines, of a screen whose height is not known.
const HEIGHT: usize = 50;

/// WebAssembly has no terminal.
#[cfg(target_family = "wasm")]
fn terminal_size_of<T>(_: T) -> Option<(Width, Height)> {
    None
}

static QUIET: OnceLock<bool> = OnceLock::new();

/// Stores the values of the flags for the whole run.
pub(crate) fn set(color: Colour, quiet: bool) {
    choice(color).write_global();
    let _ = QUIET.set(quiet);
}

/// Whether only errors, files and the exit code are asked for.
pub(crate) fn is_quiet() -> bool {
    QUIET.get().copied().unwrap_or(false)
}

/// The greatest width of lines: by COLUMNS, or by the terminal; `None` for files and pipes.
pub(crate) fn width() -> Option<usize> {
    number_in("COLUMNS").or_else(|| Some(usize::from(terminal_size_of(std::io::stdout())?.0.0)))
}

/// The greatest width of the lines of errors: as [`width`], for the standard error.
pub(crate) fn error_width() -> Option<usize> {
    number_in("COLUMNS").or_else(|| Some(usize::from(terminal_size_of(std::io::stderr())?.0.0)))
}

/// The number of lines of the screen: by LINES, or by the terminal.
pub(crate) fn height() -> usize {
    let own = || terminal_size_of(std::io::stdout()).map(|(_, height)| usize::from(height.0));
    number_in("LINES").or_else(own).unwrap_or(HEIGHT)
}

fn number_in(variable: &str) -> Option<usize> {
    let text = std::env::var(variable).ok()?;
    text.trim().parse().ok().filter(|number| *number > 0)
}

fn choice(color: Colour) -> ColorChoice {
    match color {
        Colour::Auto => ColorChoice::Auto,
        Colour::Always => ColorChoice::AlwaysAnsi,
        Colour::Never => ColorChoice::Never,
    }
}

/// The value of `--color`, before the arguments are read, so that errors about them have colours
/// too.
pub(crate) fn early_color(arguments: impl Iterator<Item = OsString>) -> clap::ColorChoice {
    let mut arguments = arguments.skip(1);
    let mut color = clap::ColorChoice::Auto;
    while let Some(argument) = arguments.next() {
        let value = match argument.to_str() {
            Some("--") => break,
            Some("--color") => arguments.next(),
            Some(text) => text.strip_prefix("--color=").map(OsString::from),
            None => None,
        };
        color = match value.as_ref().and_then(|value| value.to_str()) {
            Some("always") => clap::ColorChoice::Always,
            Some("never") => clap::ColorChoice::Never,
            _ => color,
        };
    }
    color
}
