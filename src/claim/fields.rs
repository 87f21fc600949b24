//! The fields of a claim file, as TOML gives them.

use super::function_file::{FunctionTable, RangeTable};
use crate::scheme::SchemeTable;
use serde::Deserialize;
use serde::de::{MapAccess, Visitor};
use std::collections::BTreeMap;
use std::fmt;
use toml::Spanned;

pub(super) type Formulas = BTreeMap<Spanned<String>, Spanned<String>>;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PaperFile {
    pub(super) key: Spanned<String>,
    pub(super) paper: BibliographyTable,
    #[serde(default)]
    pub(super) define: Formulas,
    #[serde(default)]
    pub(super) given: Formulas,
    #[serde(default)]
    pub(super) scheme: Vec<SchemeTable>,
    #[serde(default)]
    pub(super) table: Vec<TableTable>,
    #[serde(default)]
    pub(super) equation: Vec<EquationTable>,
    #[serde(default)]
    pub(super) function: Vec<FunctionTable>,
    #[serde(default)]
    pub(super) range: Vec<RangeTable>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct BibliographyTable {
    pub(super) authors: Vec<String>,
    pub(super) title: String,
    pub(super) venue: String,
    pub(super) year: String,
    pub(super) doi: Option<String>,
    pub(super) note: Option<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TableTable {
    pub(super) id: Spanned<String>,
    pub(super) locus: String,
    #[serde(default)]
    pub(super) title: String,
    pub(super) scheme: Option<Spanned<String>>,
    pub(super) value: Spanned<String>,
    pub(super) promise: Option<Spanned<PromiseTable>>,
    pub(super) rows: Option<AxisTable>,
    pub(super) columns: AxisTable,
    pub(super) cells: Spanned<CellsField>,
    #[serde(default)]
    pub(super) given: Formulas,
    #[serde(default)]
    pub(super) unstated: Formulas,
    pub(super) note: Option<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PromiseTable {
    pub(super) tolerance: Option<Spanned<String>>,
    pub(super) level: Option<Spanned<String>>,
    pub(super) spread: Spanned<String>,
    pub(super) offset: Option<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct AxisTable {
    pub(super) name: Spanned<String>,
    pub(super) label: Option<String>,
    pub(super) values: Option<Spanned<Vec<Spanned<NumberField>>>>,
    pub(super) from: Option<Spanned<String>>,
    pub(super) to: Option<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EquationTable {
    pub(super) id: Spanned<String>,
    pub(super) locus: String,
    #[serde(default)]
    pub(super) title: String,
    pub(super) scheme: Option<Spanned<String>>,
    #[serde(default)]
    pub(super) symbols: Vec<Spanned<String>>,
    #[serde(default)]
    pub(super) hypotheses: Vec<Spanned<String>>,
    #[serde(default)]
    pub(super) indices: Vec<AxisTable>,
    pub(super) left: Option<Spanned<LeftField>>,
    pub(super) right: Option<Spanned<String>>,
    pub(super) absent: Option<String>,
    pub(super) note: Option<String>,
}

/// One formula for all combinations of the indices, or one for each.
#[derive(Debug)]
pub(super) enum LeftField {
    One(String),
    Each(Vec<Spanned<String>>),
}

impl<'de> Deserialize<'de> for LeftField {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<LeftField, D::Error> {
        struct Either;
        impl<'de> Visitor<'de> for Either {
            type Value = LeftField;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a formula in quotes, or a list of them")
            }
            fn visit_str<E>(self, text: &str) -> Result<LeftField, E> {
                Ok(LeftField::One(text.to_owned()))
            }
            fn visit_seq<S: serde::de::SeqAccess<'de>>(
                self,
                formulas: S,
            ) -> Result<LeftField, S::Error> {
                let formulas = serde::de::value::SeqAccessDeserializer::new(formulas);
                Vec::deserialize(formulas).map(LeftField::Each)
            }
        }
        deserializer.deserialize_any(Either)
    }
}

/// `"0.742"`, or `{ printed = "h1.69e-4", read = "1.69e-4", note = "…" }`.
#[derive(Debug)]
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
                let fields = serde::de::value::MapAccessDeserializer::new(map);
                let Corrected { printed, read, note } = Corrected::deserialize(fields)?;
                Ok(NumberField { printed, read: Some(read), note: Some(note) })
            }
        }
        deserializer.deserialize_any(Either)
    }
}

/// Rows of cells, or `"lost"` when the source has none of them.
#[derive(Debug)]
pub(super) enum CellsField {
    Lost,
    Rows(Vec<Spanned<Vec<Spanned<NumberField>>>>),
}

impl<'de> Deserialize<'de> for CellsField {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<CellsField, D::Error> {
        struct Either;
        impl<'de> Visitor<'de> for Either {
            type Value = CellsField;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("rows of cells such as [['0.68', '0.31'], …], or \"lost\"")
            }
            fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<CellsField, E> {
                if text == "lost" {
                    return Ok(CellsField::Lost);
                }
                Err(E::invalid_value(serde::de::Unexpected::Str(text), &self))
            }
            fn visit_seq<S: serde::de::SeqAccess<'de>>(
                self,
                rows: S,
            ) -> Result<CellsField, S::Error> {
                let rows = serde::de::value::SeqAccessDeserializer::new(rows);
                Vec::deserialize(rows).map(CellsField::Rows)
            }
        }
        deserializer.deserialize_any(Either)
    }
}
