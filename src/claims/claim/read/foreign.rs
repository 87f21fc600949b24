//! Files that are no claim files: their kind, and what to do with them.

use crate::diagnostic::{Diagnostic, SourceText};
use std::sync::Arc;

/// The error that a file is none in TOML but one in another format, as its first line shows: no line of TOML begins with
/// `\\`, `%`, `{` or `<`, or is without `=`, unless it is a comment or the name of a table.
pub(super) fn foreign(source: &Arc<SourceText>) -> Option<Diagnostic> {
    let line = source.text.lines().find(|line| !line.trim().is_empty())?;
    let what = match line.trim_start().chars().next()? {
        '\\' | '%' => "LaTeX",
        '{' => "JSON",
        '<' => "HTML or XML",
        '#' | '[' => return None,
        _ if !line.contains('=') && line.contains([',', ';', '\t']) => "a table of numbers, CSV",
        _ => return None,
    };
    let start = source.text.find(line)?;
    let end = start.saturating_add(line.len());
    let message = format!("this is {what}, and no claim file");
    Some(Diagnostic::new(source, start..end, message).with_help(
        "a claim file says in TOML what a paper asserts: `subcert new doe2026` writes one to start from; the \
         cells of a table stand in it as cells = [['0.68', '0.31'], …]",
    ))
}
