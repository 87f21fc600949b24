//! Several errors at once.

use super::Diagnostic;
use std::fmt;

/// The errors of a file, from its beginning to its end; there is at least one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Errors(Vec<Diagnostic>);

impl Errors {
    /// The first error.
    ///
    /// # Panics
    /// Never, since there is always one.
    #[must_use]
    pub fn first(self) -> Diagnostic {
        self.0.into_iter().next().expect("at least one error")
    }

    /// All errors.
    #[must_use]
    pub fn all(&self) -> &[Diagnostic] {
        &self.0
    }
}

impl From<Diagnostic> for Errors {
    fn from(error: Diagnostic) -> Errors {
        Errors(vec![error])
    }
}

impl fmt::Display for Errors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let errors: Vec<String> = self.0.iter().map(Diagnostic::to_string).collect();
        f.write_str(&errors.join("\n\n"))
    }
}

impl std::error::Error for Errors {}

/// The errors that have been met so far.
#[derive(Debug, Default)]
pub struct Collected(Vec<Diagnostic>);

impl Collected {
    /// The value of a result; of an error, `None`, and the error is added.
    pub fn take<T>(&mut self, result: Result<T, Diagnostic>) -> Option<T> {
        result.map_err(|error| self.add(error)).ok()
    }

    /// The values of all items that can be read; the errors of the others are added.
    pub fn all<'t, T: 't, C>(
        &mut self,
        items: impl IntoIterator<Item = &'t T>,
        read: impl Fn(&'t T) -> Result<C, Diagnostic>,
    ) -> Vec<C> {
        items.into_iter().filter_map(|item| self.take(read(item))).collect()
    }

    /// Adds an error, unless there is one at its place already: of two, the one that needs no label, as it holds for all
    /// values of parameters, and else the first.
    pub fn add(&mut self, error: Diagnostic) {
        let is_there =
            |known: &&mut Diagnostic| (&known.source, &known.span) == (&error.source, &error.span);
        match self.0.iter_mut().find(is_there) {
            Some(known) if known.label.is_some() && error.label.is_none() => *known = error,
            Some(_) => {}
            None => self.0.push(error),
        }
    }

    /// Adds the errors of another collection.
    pub fn append(&mut self, other: Collected) {
        other.0.into_iter().for_each(|error| self.add(error));
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Fails if there are errors; gives all of them, by their places in the file.
    ///
    /// # Errors
    /// All that were added.
    pub fn none(self) -> Result<(), Errors> {
        let mut errors = self.0;
        errors.sort_by_key(|error| error.span.start);
        if errors.is_empty() { Ok(()) } else { Err(Errors(errors)) }
    }
}
