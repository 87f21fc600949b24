//! The fields that several tables of a claim file share, as TOML gives them.

use crate::scheme::Spanned;
use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{MapAccess, SeqAccess, Visitor};
use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;
use std::ops::Range;

pub(super) type Formulas = BTreeMap<Spanned<String>, Spanned<String>>;

/// `["w", "tau"]`: the names of unstated parameters; or `{ w = '1/16' }`: each with a value to
/// assume.
#[derive(Debug)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(untagged))]
pub(super) enum Unstated {
    Names(Vec<Spanned<String>>),
    Assumed(Formulas),
}

impl Default for Unstated {
    fn default() -> Unstated {
        Unstated::Names(Vec::new())
    }
}

impl Unstated {
    pub(super) fn names(&self) -> Vec<&Spanned<String>> {
        match self {
            Unstated::Names(names) => names.iter().collect(),
            Unstated::Assumed(values) => values.keys().collect(),
        }
    }
}

impl<'de> Deserialize<'de> for Unstated {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Unstated, D::Error> {
        struct Either;
        impl<'de> Visitor<'de> for Either {
            type Value = Unstated;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("names such as [\"w\"], or values to assume such as { w = '1/16' }")
            }
            fn visit_seq<S: SeqAccess<'de>>(self, names: S) -> Result<Unstated, S::Error> {
                Vec::deserialize(SeqAccessDeserializer::new(names)).map(Unstated::Names)
            }
            fn visit_map<M: MapAccess<'de>>(self, values: M) -> Result<Unstated, M::Error> {
                Formulas::deserialize(MapAccessDeserializer::new(values)).map(Unstated::Assumed)
            }
        }
        deserializer.deserialize_any(Either)
    }
}

/// A table, and nothing else. An array is taken for a struct as well by the code that serde derives, field by field: what
/// is no table to a reader of the format.
#[derive(Debug)]
pub(super) struct TableOf<T>(pub(super) T);

#[cfg(feature = "schema")]
impl<T: schemars::JsonSchema> schemars::JsonSchema for TableOf<T> {
    fn inline_schema() -> bool {
        T::inline_schema()
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        T::schema_name()
    }

    fn schema_id() -> std::borrow::Cow<'static, str> {
        T::schema_id()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        T::json_schema(generator)
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for TableOf<T> {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<TableOf<T>, D::Error> {
        struct Only<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Only<T> {
            type Value = TableOf<T>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a table such as { locus = \"Figure 1\" }")
            }
            fn visit_map<M: MapAccess<'de>>(self, map: M) -> Result<TableOf<T>, M::Error> {
                T::deserialize(MapAccessDeserializer::new(map)).map(TableOf)
            }
        }
        deserializer.deserialize_any(Only(PhantomData))
    }
}

/// The fields of every claim.
#[derive(Clone, Copy)]
pub(super) struct CommonFields<'a> {
    pub(super) id: &'a Spanned<String>,
    pub(super) locus: &'a Spanned<String>,
    pub(super) title: &'a str,
    pub(super) scheme: Option<&'a Spanned<String>>,
    pub(super) note: Option<&'a str>,
}

/// Declares the TOML table of a kind of claim: the fields of every claim, then its
/// own. Serde's `flatten` would lose the places in the file.
macro_rules! claim_table {
    ($name:ident { $($(#[$attribute:meta])* $visible:vis $field:ident: $type:ty,)* }) => {
        #[derive(Debug, serde::Deserialize)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        #[serde(deny_unknown_fields)]
        pub(super) struct $name {
            /// The name of the claim, its own in the file: letters, digits, `-`, `_` and `.`.
            pub(super) id: crate::scheme::Spanned<String>,
            /// Where it stands: `Table 2`, `(3), (5)-(7)`.
            pub(super) locus: crate::scheme::Spanned<String>,
            /// What it says.
            #[serde(default)]
            pub(super) title: String,
            /// The scheme that it is about, such as `"corner:w=w"` or `"corner:w=w x chaikin"`.
            pub(super) scheme: Option<crate::scheme::Spanned<String>>,
            /// What a reader should know.
            pub(super) note: Option<String>,
            $($(#[$attribute])* $visible $field: $type,)*
        }

        impl $name {
            pub(super) fn common(&self) -> super::fields::CommonFields<'_> {
                super::fields::CommonFields {
                    id: &self.id,
                    locus: &self.locus,
                    title: &self.title,
                    scheme: self.scheme.as_ref(),
                    note: self.note.as_deref(),
                }
            }
        }
    };
}
pub(super) use claim_table;

/// A field that is one text, or a list of texts.
macro_rules! one_or_each {
    ($(#[$doc:meta])* $name:ident, $expected:literal) => {
        $(#[$doc])*
        #[derive(Debug)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(untagged))]
        enum $name {
            One(String),
            Each(Vec<crate::scheme::Spanned<String>>),
        }

        impl $name {
            /// The texts with their places; `whole` is that of the field.
            fn texts(&self, whole: std::ops::Range<usize>) -> Vec<(&str, std::ops::Range<usize>)> {
                match self {
                    $name::One(text) => vec![(text, whole)],
                    $name::Each(all) => {
                        all.iter().map(|text| (text.get_ref().as_str(), text.span())).collect()
                    }
                }
            }
        }

        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<$name, D::Error> {
                struct Either;
                impl<'de> serde::de::Visitor<'de> for Either {
                    type Value = $name;
                    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                        f.write_str($expected)
                    }
                    fn visit_str<E>(self, text: &str) -> Result<$name, E> {
                        Ok($name::One(text.to_owned()))
                    }
                    fn visit_seq<S: serde::de::SeqAccess<'de>>(
                        self,
                        texts: S,
                    ) -> Result<$name, S::Error> {
                        let texts = serde::de::value::SeqAccessDeserializer::new(texts);
                        Vec::deserialize(texts).map($name::Each)
                    }
                }
                deserializer.deserialize_any(Either)
            }
        }
    };
}
pub(super) use one_or_each;

/// Texts with their places, as fields have them.
pub(super) fn spanned(texts: Vec<(&str, Range<usize>)>) -> Vec<Spanned<String>> {
    texts.into_iter().map(|(text, span)| Spanned::new(span, text.to_owned())).collect()
}

/// `"0.742"`, or `{ printed = "h1.69e-4", read = "1.69e-4", note = "…" }`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(with = "OneOf<Corrected>"))]
pub(super) struct NumberField {
    pub(super) printed: String,
    pub(super) read: Option<String>,
    pub(super) note: Option<String>,
}

/// A number of which the text is damaged, or is no decimal.
#[derive(Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
struct Corrected {
    /// As the paper prints it.
    printed: String,
    /// What it means.
    read: String,
    /// Why.
    note: String,
}

impl<'de> Deserialize<'de> for NumberField {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<NumberField, D::Error> {
        struct Either;
        impl<'de> Visitor<'de> for Either {
            type Value = NumberField;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number in quotes, or { printed = …, read = …, note = … }")
            }
            fn visit_str<E>(self, text: &str) -> Result<NumberField, E> {
                Ok(NumberField { printed: text.to_owned(), read: None, note: None })
            }
            fn visit_map<M: MapAccess<'de>>(self, map: M) -> Result<NumberField, M::Error> {
                let fields = MapAccessDeserializer::new(map);
                let Corrected { printed, read, note } = Corrected::deserialize(fields)?;
                Ok(NumberField { printed, read: Some(read), note: Some(note) })
            }
        }
        deserializer.deserialize_any(Either)
    }
}

/// `"chaikin"`, or `{ printed = "Chaikin", scheme = "chaikin", note = "…" }` with or without `note`.
#[derive(Debug)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(with = "OneOf<Named>"))]
pub(super) struct SchemeField {
    pub(super) printed: String,
    /// The reference, where it is not what is printed.
    pub(super) scheme: Option<Spanned<String>>,
    pub(super) note: Option<String>,
}

/// A scheme under the name that the paper prints.
#[derive(Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
struct Named {
    /// As the paper prints it.
    printed: String,
    /// The reference, such as `"four-point:w=1/16"`.
    scheme: Spanned<String>,
    /// What a reader should know.
    note: Option<String>,
}

impl<'de> Deserialize<'de> for SchemeField {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<SchemeField, D::Error> {
        struct Either;
        impl<'de> Visitor<'de> for Either {
            type Value = SchemeField;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a scheme such as \"six-point:w=w\", or { printed = …, scheme = … }")
            }
            fn visit_str<E>(self, text: &str) -> Result<SchemeField, E> {
                Ok(SchemeField { printed: text.to_owned(), scheme: None, note: None })
            }
            fn visit_map<M: MapAccess<'de>>(self, map: M) -> Result<SchemeField, M::Error> {
                let fields = MapAccessDeserializer::new(map);
                let Named { printed, scheme, note } = Named::deserialize(fields)?;
                Ok(SchemeField { printed, scheme: Some(scheme), note })
            }
        }
        deserializer.deserialize_any(Either)
    }
}

/// A text, or this: what the readers by hand take.
#[cfg(feature = "schema")]
#[derive(schemars::JsonSchema)]
#[schemars(untagged)]
#[expect(dead_code, reason = "it is a form, and no value")]
pub(super) enum OneOf<T> {
    Text(String),
    Other(T),
}
