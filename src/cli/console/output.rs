//! Results to the standard output, messages to the standard error.

use super::interrupt::writing;
use super::save::save;
use super::terminal;
use serde::Serialize;
use std::fmt::Display;
use std::io::{ErrorKind, Write as _};
use std::path::Path;
use std::process::ExitCode;
use subcert::bound::polynomial_rules;
use subcert::diagnostic::{Diagnostic, Errors, wrapped};
use subcert::exact::{Enclosed, Rational, format::short, parse_rational};
use subcert::scheme::{SchemeError, parse_parametric};
use subcert::smoothness::SpecialValues;

/// The exit code when a reader such as `head` has gone away: success.
pub(crate) const BROKEN_PIPE: u8 = 0;

/// What a command returns.
pub(crate) type Outcome = Result<(), Failure>;

/// Why a command did not do all that was asked.
#[derive(Debug)]
pub(crate) enum Failure {
    /// A stated expectation failed: exit code 1.
    Expectation(String),
    /// Bad usage or input: exit code 2.
    Input(String),
    /// Errors in a file: exit code 2.
    File(Errors),
    /// The results cannot be written: exit code 2.
    Output(std::io::Error),
}

impl From<Diagnostic> for Failure {
    fn from(diagnostic: Diagnostic) -> Failure {
        Failure::File(diagnostic.into())
    }
}

impl From<Errors> for Failure {
    fn from(errors: Errors) -> Failure {
        Failure::File(errors)
    }
}

impl From<SchemeError> for Failure {
    fn from(error: SchemeError) -> Failure {
        match error {
            SchemeError::File(diagnostic) => Failure::from(*diagnostic),
            SchemeError::MissingParameter { ref scheme, ref parameter } => {
                let family = of_family(scheme, parameter).unwrap_or_default();
                Failure::Input(format!("{error}{family}"))
            }
            other => Failure::Input(other.to_string()),
        }
    }
}

/// What there is to know of a family whose parameter has no value, if it is one parameter in which the mask is polynomial.
fn of_family(scheme: &str, parameter: &str) -> Option<String> {
    let mask = parse_parametric(scheme, parameter).ok()?;
    let rules = polynomial_rules(mask.rules(), parameter).ok()?;
    let special = SpecialValues::of(&rules);
    let such = special.best().map_or_else(String::new, |value| {
        let (more, order) = (format!(", such as {value}"), special.sum_rules);
        format!("{more}, where the sum rules are of a higher order than {order}")
    });
    Some(format!(
        "{such}; `subcert range {} --param {parameter} --smoothness 1` says for which {parameter} the limits are C^1",
        quoted(scheme)
    ))
}

/// A text as a shell takes it: in quotes where it needs them.
pub(crate) fn quoted(text: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./:=,+%@".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        return text.to_owned();
    }
    format!("'{}'", text.replace('\'', "'\\''"))
}

impl Failure {
    /// Writes the message and gives the exit code.
    pub(crate) fn report(self) -> ExitCode {
        let (message, code) = match self {
            Failure::Expectation(message) => (fitted(&format!("subcert: {message}")), 1),
            Failure::Input(message) => (fitted(&format!("error: {message}")), 2),
            Failure::File(errors) => (drawn(&errors), 2),
            Failure::Output(error) if error.kind() == ErrorKind::BrokenPipe => {
                return ExitCode::from(BROKEN_PIPE);
            }
            Failure::Output(error) => {
                (fitted(&format!("error: cannot write the results: {error}")), 2)
            }
        };
        // Nobody is left to tell when even the standard error is closed.
        let _ = writeln!(anstream::stderr(), "{message}");
        ExitCode::from(code)
    }
}

/// Tells of something that is no failure.
pub(crate) fn note(message: &str) {
    let _ = writeln!(anstream::stderr(), "{}", fitted(&format!("note: {message}")));
}

/// A message in lines as wide as the terminal. A longer word, such as a path, is not cut.
fn fitted(message: &str) -> String {
    match terminal::error_width() {
        Some(width) => wrapped(message, width, 0, false).join("\n"),
        None => message.to_owned(),
    }
}

/// Fails if something occurs that is denied. `count` gives for a word the number of its
/// occurrences, and what these are called in the singular and in the plural.
pub(crate) fn none_denied<T: Copy>(
    denied: &[T],
    name: fn(T) -> &'static str,
    count: impl Fn(T) -> (usize, [&'static str; 2]),
) -> Outcome {
    let words: Vec<String> = denied
        .iter()
        .filter_map(|denied| match count(*denied) {
            (0, _) => None,
            (count, [one, several]) => {
                let what = if count == 1 { one } else { several };
                Some(format!("{count} {what}: {}", name(*denied)))
            }
        })
        .collect();
    if words.is_empty() { Ok(()) } else { Err(Failure::Expectation(words.join(", "))) }
}

/// The most errors of a file that are shown.
const MAX_SHOWN: usize = 20;

fn drawn(errors: &Errors) -> String {
    let all = errors.all();
    let mut drawn: Vec<String> = { all.iter().take(MAX_SHOWN) }
        .map(|error| error.render_within(true, terminal::error_width()))
        .collect();
    if all.len() > 1 {
        let shown = all.len().min(MAX_SHOWN);
        let more =
            if shown < all.len() { format!(", of which {shown} are shown") } else { String::new() };
        drawn.push(format!("{} errors{more}", all.len()));
    }
    drawn.join("\n\n")
}

/// Writes a text to the standard output; styles only to a terminal.
pub(crate) fn write(text: &str) -> Result<(), Failure> {
    let _writing = writing();
    let mut out = anstream::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(Failure::Output)
}

/// Writes results to the standard output, unless only the exit code is asked for.
pub(crate) fn write_results(text: &str) -> Outcome {
    if terminal::is_quiet() { Ok(()) } else { write(text) }
}

/// Writes results into a file, without styles; or to the standard output, for which `-` stands too.
pub(crate) fn deliver(text: &str, file: Option<&Path>) -> Outcome {
    let Some(path) = file.filter(|path| path.as_os_str() != "-") else {
        return write_results(text);
    };
    save(path, &anstream::adapter::strip_str(text).to_string()).map_err(|error| {
        let path = path.display();
        Failure::Input(format!("cannot write `{path}`: {error}; name another file with -o FILE"))
    })
}

/// A report as JSON, with a line for each field.
pub(crate) fn json_text(json: &impl Serialize) -> String {
    let text = serde_json::to_string_pretty(json).expect("keys that are texts");
    format!("{text}\n")
}

/// An exact value with its decimal, where they differ; only the decimal if the value is long.
pub(crate) fn with_decimal(value: &(impl Enclosed + Display)) -> String {
    let decimal = short(value, 12);
    let exact = value.to_string();
    match (decimal == exact, exact.len() > 40) {
        (true, _) => exact,
        (false, false) => format!("{exact} = {decimal}"),
        (false, true) => format!("{decimal}  (exact in --format json)"),
    }
}

/// The exact number given for `flag`, which must be positive.
pub(crate) fn positive(flag: &str, text: &str) -> Result<Rational, Failure> {
    let value = parse_rational(text).map_err(|e| Failure::Input(format!("{flag}: {e}")))?;
    if value.sign() > 0 {
        return Ok(value);
    }
    Err(Failure::Input(format!("{flag} must be positive, and is {text}")))
}
