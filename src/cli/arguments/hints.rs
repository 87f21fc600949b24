//! What people type in place of the arguments that there are.

use clap::Error;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use std::ffi::OsString;
use subcert::exact::parse_rational;
use subcert::formula::is_identifier;

/// The error with a tip that fits, where an argument is not known: for a value of a parameter, and for a mask.
pub(in crate::cli) fn with_hint(mut error: Error, arguments: &[String]) -> Error {
    let Some(ContextValue::String(unknown)) = error.get(ContextKind::InvalidArg).cloned() else {
        return error;
    };
    let similar = error.get(ContextKind::SuggestedArg).is_some();
    let found = match error.kind() {
        ErrorKind::UnknownArgument => hint(&unknown, similar, arguments),
        _ => None,
    };
    if let Some(found) = found {
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![found.into()]));
    }
    error
}

/// The arguments, where a mask that begins with a minus, such as `-z^-1*(1 - z)`, is no list of flags: behind a blank,
/// which the readers of schemes and numbers take away, clap reads it as a value.
pub(in crate::cli) fn with_masks(
    arguments: impl Iterator<Item = OsString>,
) -> impl Iterator<Item = OsString> {
    let is_mask = |argument: &str| {
        let begins =
            |c: char| c == 'z' || c == '√' || c == '.' || c.is_numeric() || "([{".contains(c);
        let rest = argument.strip_prefix('-').unwrap_or_default();
        rest.starts_with(begins) && rest.contains(['(', '[', '{', '^'])
    };
    arguments.map(move |argument| match argument.to_str() {
        Some(text) if is_mask(text) => format!(" {text}").into(),
        _ => argument,
    })
}

fn hint(unknown: &str, similar: bool, arguments: &[String]) -> Option<String> {
    let mask = || {
        Some("a mask stands in brackets and in quotes: '[-1, 0, 9, 16, 9, 0, -1]/16'".to_owned())
    };
    let begins = |argument: &&String| argument.starts_with(['[', '{']);
    let whole = |argument: &&String| argument.contains([']', '}']);
    let name = unknown.trim_start_matches('-');
    if unknown.starts_with('-') && name.starts_with(|c: char| c.is_ascii_digit() || c == '.')
        || arguments.iter().any(|argument| begins(&argument) && !whole(&argument))
    {
        return mask();
    }
    let is_value = |text: &str| {
        text.split_once('=').is_some_and(|(name, value)| is_identifier(name) && !value.is_empty())
    };
    // The command, then what follows.
    let at = arguments
        .iter()
        .position(|argument| argument.split('=').next() == unknown.split('=').next());
    let next = at.and_then(|at| arguments.get(at + 1)).map(String::as_str).unwrap_or_default();
    let whole = at.map_or(unknown, |at| arguments[at].as_str()).trim_start_matches('-');
    let scheme =
        arguments.get(2).filter(|scheme| !scheme.starts_with('-') && scheme.as_str() != whole);
    let scheme = scheme.map_or("SCHEME", String::as_str);
    let behind = |value: &str| {
        let separator = if scheme.contains('=') { ',' } else { ':' };
        Some(format!(
            "a value of a parameter stands behind the scheme: '{scheme}{separator}{value}'"
        ))
    };
    match name {
        _ if is_value(whole) && !similar => behind(whole),
        _ if is_value(next) => behind(next),
        "param" | "parameter" => Some(format!(
            "`subcert range '{scheme}' --param {next}` is about all values of a parameter"
        )),
        _ if !similar && is_identifier(name) && parse_rational(next).is_ok() => {
            behind(&format!("{name}={next}"))
        }
        _ => None,
    }
}
