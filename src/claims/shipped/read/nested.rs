//! Texts in nested lists, as a table has them row by row.

use crate::scheme::Spanned;
use serde::Deserialize;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{SeqAccess, Visitor};
use std::fmt;
use std::ops::Range;

/// A text, or a list of such.
#[derive(Debug)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(untagged))]
pub(super) enum Nested {
    Text(String),
    List(Vec<Spanned<Nested>>),
}

impl<'de> Deserialize<'de> for Nested {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Nested, D::Error> {
        struct Either;
        impl<'de> Visitor<'de> for Either {
            type Value = Nested;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a text in quotes, or a list of such")
            }
            fn visit_str<E>(self, text: &str) -> Result<Nested, E> {
                Ok(Nested::Text(text.to_owned()))
            }
            fn visit_seq<S: SeqAccess<'de>>(self, list: S) -> Result<Nested, S::Error> {
                Vec::deserialize(SeqAccessDeserializer::new(list)).map(Nested::List)
            }
        }
        deserializer.deserialize_any(Either)
    }
}

/// The place of the first list that is no row like the others beside it: of a text beside lists, or of lists with other numbers
/// of texts.
pub(super) fn uneven(list: &[Spanned<Nested>]) -> Option<Range<usize>> {
    let kind = |one: &Spanned<Nested>| match one.get_ref() {
        Nested::Text(_) => None,
        Nested::List(list) => Some(flattened(list).len()),
    };
    let first = list.first().map(kind);
    let other = list.iter().find(|one| Some(kind(one)) != first);
    other.map(Spanned::span).or_else(|| {
        list.iter().find_map(|one| match one.get_ref() {
            Nested::Text(_) => None,
            Nested::List(list) => uneven(list),
        })
    })
}

/// The texts in their order, without the brackets.
pub(super) fn flattened(list: &[Spanned<Nested>]) -> Vec<Spanned<&str>> {
    let mut texts = Vec::new();
    for one in list {
        match one.get_ref() {
            Nested::Text(text) => texts.push(Spanned::new(one.span(), text.as_str())),
            Nested::List(list) => texts.extend(flattened(list)),
        }
    }
    texts
}
