//! The fields that several tables of a claim file share, as TOML gives them.

use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{MapAccess, SeqAccess, Visitor};
use std::collections::BTreeMap;
use std::fmt;
use toml::Spanned;

pub(super) type Formulas = BTreeMap<Spanned<String>, Spanned<String>>;

/// `["w", "tau"]`: the names of unstated parameters; or `{ w = '1/16' }`: each with a value to
/// assume.
#[derive(Debug)]
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
        #[serde(deny_unknown_fields)]
        pub(super) struct $name {
            pub(super) id: toml::Spanned<String>,
            pub(super) locus: toml::Spanned<String>,
            #[serde(default)]
            pub(super) title: String,
            pub(super) scheme: Option<toml::Spanned<String>>,
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

/// `"0.742"`, or `{ printed = "h1.69e-4", read = "1.69e-4", note = "…" }`.
#[derive(Clone, Debug)]
pub(super) struct NumberField {
    pub(super) printed: String,
    pub(super) read: Option<String>,
    pub(super) note: Option<String>,
}

impl<'de> Deserialize<'de> for NumberField {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<NumberField, D::Error> {
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Corrected {
            printed: String,
            read: String,
            note: String,
        }
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
pub(super) struct SchemeField {
    pub(super) printed: String,
    /// The reference, where it is not what is printed.
    pub(super) scheme: Option<Spanned<String>>,
    pub(super) note: Option<String>,
}

impl<'de> Deserialize<'de> for SchemeField {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<SchemeField, D::Error> {
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Named {
            printed: String,
            scheme: Spanned<String>,
            note: Option<String>,
        }
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
