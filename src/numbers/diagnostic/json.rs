//! JSON whose numbers are read from their text, and whose errors have a place.

use super::{Diagnostic, SourceText};
use serde::de::{Deserialize, MapAccess, Visitor};
use serde_json::value::RawValue;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// The elements of the JSON array at `span`, with their text; `help` goes with errors.
///
/// # Errors
/// When no array stands there.
pub fn json_elements<'a>(
    source: &'a Arc<SourceText>,
    span: Range<usize>,
    help: &str,
) -> Result<Vec<&'a RawValue>, Diagnostic> {
    parse(source, span, help)
}

/// The fields of the JSON object at `span`, in order.
///
/// # Errors
/// When no object stands there.
pub fn json_fields<'a>(
    source: &'a Arc<SourceText>,
    span: Range<usize>,
    help: &str,
) -> Result<Vec<(String, &'a RawValue)>, Diagnostic> {
    parse::<Fields<'a>>(source, span, help).map(|fields| fields.0)
}

/// Where in the source an element stands: a part of its text.
#[must_use]
pub fn json_place(source: &Arc<SourceText>, raw: &RawValue) -> Range<usize> {
    let start = raw.get().as_ptr().addr().saturating_sub(source.text.as_ptr().addr());
    start..start + raw.get().len()
}

fn parse<'a, T: Deserialize<'a>>(
    source: &'a Arc<SourceText>,
    span: Range<usize>,
    help: &str,
) -> Result<T, Diagnostic> {
    let text = &source.text[span.clone()];
    serde_json::from_str(text).map_err(|error| {
        // Line and column of the character before which reading stopped, from 1.
        let line = text.split_inclusive('\n').take(error.line().saturating_sub(1));
        let before = line.map(str::len).sum::<usize>() + error.column().saturating_sub(1);
        let at =
            (0..=before.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
        let length = text[at..].chars().next().map_or(0, char::len_utf8);
        let place = span.start + at..span.start + at + length;
        let message = error.to_string();
        let message = message.split(" at line ").next().unwrap_or_default().to_owned();
        Diagnostic::new(source, place, message).with_help(help)
    })
}

/// The fields of an object in their order, also when one stands there twice.
struct Fields<'a>(Vec<(String, &'a RawValue)>);

impl<'de> Deserialize<'de> for Fields<'de> {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct InOrder;
        impl<'de> Visitor<'de> for InOrder {
            type Value = Fields<'de>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut fields = Vec::new();
                while let Some(field) = map.next_entry()? {
                    fields.push(field);
                }
                Ok(Fields(fields))
            }
        }
        deserializer.deserialize_map(InOrder)
    }
}
