//! The options of a function call in a claim.

use crate::bound::{Order, Recursion, Rounded, Suprema, Terms};
use crate::formula::{Call, CallError, OptionWord};

/// The options of a call, each to be used once.
pub(super) struct Options<'a> {
    function: &'a str,
    left: Vec<&'a OptionWord>,
}

impl<'a> Options<'a> {
    pub(super) fn new<V>(call: &Call<'a, V>) -> Options<'a> {
        Options { function: call.function, left: call.options.iter().collect() }
    }

    pub(super) fn take(&mut self, name: &str) -> Option<String> {
        let at = self.left.iter().position(|option| option.name == name)?;
        Some(self.left.remove(at).word.clone())
    }

    fn choose<T: Copy>(&mut self, name: &str, choices: &[(&str, T)]) -> Result<T, CallError> {
        let Some(word) = self.take(name) else { return Ok(choices[0].1) };
        let found = choices.iter().find(|(choice, _)| *choice == word);
        found.map(|(_, value)| *value).ok_or_else(|| {
            let known: Vec<&str> = choices.iter().map(|(choice, _)| *choice).collect();
            CallError::Misuse(format!("`{name}` is one of {}, not `{word}`", known.join(", ")))
        })
    }

    pub(super) fn order(&mut self) -> Result<Order, CallError> {
        self.choose("order", &[("adjoint", Order::Adjoint), ("forward", Order::Forward)])
    }

    pub(super) fn terms(&mut self) -> Result<Terms, CallError> {
        self.choose("terms", &[("each", Terms::Each), ("total", Terms::Total)])
    }

    pub(super) fn suprema(&mut self) -> Result<Suprema, CallError> {
        let choices = [("independent", Suprema::Independent), ("joint", Suprema::Joint)];
        self.choose("suprema", &choices)
    }

    pub(super) fn recursion(&mut self) -> Result<Recursion, CallError> {
        let choices = [("derived", Recursion::Derived), ("printed", Recursion::Printed)];
        self.choose("recursion", &choices)
    }

    pub(super) fn rounded(&mut self) -> Result<Rounded, CallError> {
        let choices = [("up", Rounded::Up), ("nearest", Rounded::Nearest), ("down", Rounded::Down)];
        self.choose("rounded", &choices)
    }

    pub(super) fn offset(&mut self, own: i64) -> Result<i64, CallError> {
        match self.take("offset").as_deref() {
            None | Some("own") => Ok(own),
            Some(word) => word.parse().ok().filter(|o: &i64| o.abs() <= 10_000).ok_or_else(|| {
                CallError::Misuse(format!("`offset` is `own` or an integer, not `{word}`"))
            }),
        }
    }

    /// `value`, once every option has been used.
    pub(super) fn finished<V>(&self, value: V) -> Result<V, CallError> {
        self.finish().map(|()| value)
    }

    pub(super) fn finish(&self) -> Result<(), CallError> {
        self.left.first().map_or(Ok(()), |option| {
            let (name, function) = (&option.name, self.function);
            Err(CallError::Misuse(format!("`{function}` takes no option `{name}`")))
        })
    }
}
