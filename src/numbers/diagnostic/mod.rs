//! Errors that point at a place in a file.

mod errors;
mod json;
pub mod wrap;

pub use errors::Collected;
pub use errors::Errors;
pub use json::{json_elements, json_fields, json_place};
pub use wrap::wrapped;

use crate::cap::Cap;
use crate::files::permitted;
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// A text, and its name in errors: a path, or `--polygon`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceText {
    /// The name.
    pub name: String,
    /// The text.
    pub text: String,
}

impl SourceText {
    /// The text `text`, called `name`.
    #[must_use]
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Arc<SourceText> {
        Arc::new(SourceText { name: name.into(), text: text.into() })
    }
}

/// An error in a file: what is wrong, where, and what would be right.
///
/// `Display` draws the line with the place underlined.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The file.
    pub source: Arc<SourceText>,
    /// The bytes that the error is about.
    pub span: Range<usize>,
    /// What is wrong.
    pub message: String,
    /// What stands there, in a few words.
    pub label: Option<String>,
    /// Another place that the error is about, and what stands there.
    pub other: Option<Box<(Range<usize>, String)>>,
    /// What would be right.
    pub help: Option<String>,
    /// The cap that a value is beyond, if nothing else is wrong.
    pub cap: Option<Box<Cap>>,
}

/// How many characters `error: ` takes.
const ERROR_HEAD: usize = 7;

/// How many ` = help: ` takes, beside the number of a line.
const HELP_HEAD: usize = 9;

impl Diagnostic {
    /// An error about the bytes `span` of `source`.
    #[must_use]
    pub fn new(
        source: &Arc<SourceText>,
        span: Range<usize>,
        message: impl Into<String>,
    ) -> Diagnostic {
        let (source, message) = (Arc::clone(source), message.into());
        Diagnostic { source, span, message, label: None, other: None, help: None, cap: None }
    }

    /// Adds words for what stands at the place.
    #[must_use]
    pub fn with_label(self, label: impl Into<String>) -> Diagnostic {
        Diagnostic { label: Some(label.into()), ..self }
    }

    /// Adds another place that the error is about, and words for what stands there.
    #[must_use]
    pub fn with_place(self, span: Range<usize>, label: impl Into<String>) -> Diagnostic {
        Diagnostic { other: Some(Box::new((span, label.into()))), ..self }
    }

    /// Adds a remedy.
    #[must_use]
    pub fn with_help(self, help: impl Into<String>) -> Diagnostic {
        Diagnostic { help: Some(help.into()), ..self }
    }

    /// Says that nothing is wrong but that a value is beyond this cap, if there is one.
    #[must_use]
    pub fn with_cap(self, cap: Option<Cap>) -> Diagnostic {
        Diagnostic { cap: cap.map(Box::new), ..self }
    }

    /// The value, or the cap that it is beyond; other errors stay errors.
    ///
    /// # Errors
    /// Those of `found` without a cap.
    pub fn or_cap<T>(found: Result<T, Diagnostic>) -> Result<Result<T, Cap>, Diagnostic> {
        found.map(Ok).or_else(|mut error| error.cap.take().map(|cap| Err(*cap)).ok_or(error))
    }

    /// Both values. An error without a cap comes before one with a cap.
    ///
    /// # Errors
    /// Those of the two.
    pub fn both<A, B>(
        first: Result<A, Diagnostic>,
        second: Result<B, Diagnostic>,
    ) -> Result<(A, B), Diagnostic> {
        match (first, second) {
            (Ok(first), Ok(second)) => Ok((first, second)),
            (Err(first), Err(second)) if first.cap.is_some() && second.cap.is_none() => Err(second),
            (Err(error), _) | (_, Err(error)) => Err(error),
        }
    }

    /// Line and column of the place, both counted from 1.
    #[must_use]
    pub fn line_and_column(&self) -> (usize, usize) {
        let before = &self.source.text[..self.span.start.min(self.source.text.len())];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
    }

    /// The message and the place in a few words, for another message that says more of it.
    #[must_use]
    pub fn in_words(&self) -> String {
        let (line, column) = self.line_and_column();
        format!("{} ({}:{line}:{column})", self.message, self.source.name)
    }

    /// The drawing, coloured when `colour`.
    #[must_use]
    pub fn render(&self, colour: bool) -> String {
        self.render_within(colour, None)
    }

    /// As [`Diagnostic::render`], with the message and the remedy in lines of at most `width`
    /// characters. Lines of the source stay as they are.
    #[must_use]
    pub fn render_within(&self, colour: bool, width: Option<usize>) -> String {
        let fitted = |text: &str, head: usize| match width {
            Some(width) => wrapped(text, width, head, false).join("\n"),
            None => text.to_owned(),
        };
        let mut annotation = AnnotationKind::Primary.span(self.span.clone());
        if let Some(label) = &self.label {
            annotation = annotation.label(label);
        }
        let mut snippet =
            Snippet::source(&self.source.text).path(&self.source.name).annotation(annotation);
        if let Some((span, label)) = self.other.as_deref() {
            snippet = snippet.annotation(AnnotationKind::Context.span(span.clone()).label(label));
        }
        let message = fitted(&self.message, ERROR_HEAD);
        let mut group = Level::ERROR.primary_title(message).element(snippet);
        if let Some(help) = &self.help {
            let lines = self.line_and_column().0.to_string().len();
            group = group.element(Level::HELP.message(fitted(help, lines + HELP_HEAD)));
        }
        let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
        renderer.render(&[group])
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

impl std::error::Error for Diagnostic {}

/// The text of a file of at most `max_bytes`, without a byte order mark.
///
/// # Errors
/// When it cannot be read, is larger, or is not UTF-8; the message says which.
pub fn read_text(path: &std::path::Path, max_bytes: u64) -> Result<String, String> {
    utf8(read_bytes(path, max_bytes)?)
}

/// The text that a reader gives, of at most `max_bytes`, without a byte order mark.
///
/// # Errors
/// As [`read_text`].
pub fn read_text_from(reader: impl std::io::Read, max_bytes: u64) -> Result<String, String> {
    utf8(read_bytes_from(reader, max_bytes)?)
}

fn utf8(bytes: Vec<u8>) -> Result<String, String> {
    let text = String::from_utf8(bytes).map_err(|_| "it is not UTF-8 text".to_owned())?;
    Ok(without_mark(text))
}

fn without_mark(mut text: String) -> String {
    if text.starts_with('\u{feff}') {
        text.remove(0);
    }
    text
}

/// The text of these bytes without a byte order mark: UTF-8, or else Latin-1, in which programs write names and comments; `None` where a byte is a
/// control character of neither.
///
/// ```
/// use subcert::diagnostic::text_or_latin1;
///
/// assert_eq!(text_or_latin1(b"# W\xfcrfel\n".to_vec()).as_deref(), Some("# Würfel\n"));
/// assert_eq!(text_or_latin1(b"\xef\xbb\xbf0, 1\n".to_vec()).as_deref(), Some("0, 1\n"));
/// assert_eq!(text_or_latin1(vec![b'#', 0, 0xff]), None);
/// ```
#[must_use]
pub fn text_or_latin1(bytes: Vec<u8>) -> Option<String> {
    String::from_utf8(bytes).map_or_else(
        |error| {
            let bytes = error.into_bytes();
            let control = |byte: &u8| byte.is_ascii_control() && !byte.is_ascii_whitespace();
            let latin = !bytes.iter().any(control);
            latin.then(|| bytes.into_iter().map(char::from).collect())
        },
        |text| Some(without_mark(text)),
    )
}

/// The bytes of a file, at most `max_bytes`.
///
/// # Errors
/// When they cannot be read, or are more; the message says which.
pub fn read_bytes(path: &std::path::Path, max_bytes: u64) -> Result<Vec<u8>, String> {
    permitted(path).map_err(|error| error.to_string())?;
    let file = std::fs::File::open(path).map_err(|error| error.to_string())?;
    read_bytes_from(file, max_bytes)
}

/// The bytes that a reader gives, at most `max_bytes`.
///
/// # Errors
/// When they cannot be read, or are more; the message says which.
pub fn read_bytes_from(reader: impl std::io::Read, max_bytes: u64) -> Result<Vec<u8>, String> {
    use std::io::Read as _;
    let mut bytes = Vec::new();
    // Reading one byte more than is allowed detects a text that is too large, even if the system
    // does not know its size.
    reader.take(max_bytes + 1).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
    if bytes.len() as u64 > max_bytes {
        return Err(format!("it is larger than {max_bytes} bytes"));
    }
    Ok(bytes)
}
