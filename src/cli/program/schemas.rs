//! `subcert schemas DIR`: the JSON schemas of what `--format json` writes, from the types that are
//! written, and of claim files, from those that are read.

use super::flags::Flags;
use crate::cli::console::answer::Answer;
use crate::cli::console::output::{Failure, Outcome, json_text};
use crate::cli::console::save::save_in;
use crate::cli::constants::{Certification, Constants, LatticeConstants, RingConstants};
use crate::cli::depth::{Depth, LatticeDepth, LocalReport, ParametricDepth, SetDepth};
use crate::cli::papers::{Audit, Coverage, Errata, Explanation, Listing, Projects, Shipped};
use crate::cli::ranges::{
    BestContraction, BestExponentAnswer, Range, SmoothMap, SmoothRange, VertexRange,
};
use crate::cli::schemes::{Atlas, Catalogue, Comparison, Scheme};
use crate::cli::smoothness::{JointRadius, LatticeSmoothness, Smoothness, Vertices};
use crate::cli::spectrum::{Sector, Spectrum};
use schemars::{JsonSchema, Schema, generate::SchemaSettings};
use serde_json::Value;
use std::path::Path;
use subcert::oracle::OracleValues;

/// What is written, not what could be read: an absent field may be required otherwise.
fn of<T: JsonSchema>() -> Schema {
    SchemaSettings::draft2020_12().for_serialize().into_generator().into_root_schema_for::<T>()
}

/// The schemas of these answers, by the names of their files.
macro_rules! answers {
    ($($answer:ty),* $(,)?) => { [$((<$answer>::NAME, of::<$answer>())),*] };
}

/// The name of a file, and its schema.
fn all() -> Vec<(&'static str, Schema)> {
    let answers = answers![
        Depth<'_>,
        ParametricDepth<'_>,
        SetDepth<'_>,
        LocalReport<'_>,
        LatticeDepth<'_>,
        Atlas<'_>,
        Catalogue<'_>,
        Certification<'_>,
        Constants<'_>,
        RingConstants<'_>,
        LatticeConstants<'_>,
        Range<'_>,
        SmoothRange<'_>,
        SmoothMap<'_>,
        BestContraction<'_>,
        BestExponentAnswer<'_>,
        VertexRange<'_>,
        Smoothness<'_>,
        LatticeSmoothness<'_>,
        Vertices<'_>,
        JointRadius<'_>,
        Spectrum<'_>,
        Sector<'_>,
        Flags,
        Scheme,
        Comparison,
        Audit<'_>,
        Projects<'_>,
        Coverage<'_>,
        Errata<'_>,
        Explanation<'_>,
        Listing<'_>,
        Shipped<'_>,
    ];
    let others = [
        ("claims", read(subcert::claim::paper_schema())),
        ("claims-project", read(subcert::shipped::project_schema())),
        ("oracle", of::<OracleValues>()),
    ];
    answers.into_iter().chain(others).collect()
}

/// The schema of a file of TOML: it has no null, and whole numbers stand for the texts that they spell.
fn read(mut schema: Schema) -> Schema {
    fn typed(value: &mut Value) {
        if let Some(Value::Array(options)) = value.get_mut("anyOf") {
            options.retain(|option| option.get("type") != Some(&Value::from("null")));
        }
        match value.get_mut("type") {
            Some(kind) if kind == "string" => *kind = Value::from(vec!["string", "integer"]),
            Some(Value::Array(kinds)) => {
                kinds.retain(|kind| kind != "null");
                if kinds.iter().any(|kind| kind == "string") {
                    kinds.push(Value::from("integer"));
                }
            }
            _ => {}
        }
        match value {
            Value::Array(items) => items.iter_mut().for_each(typed),
            Value::Object(fields) => fields.iter_mut().for_each(|(_, value)| typed(value)),
            _ => {}
        }
    }
    let fields = schema.ensure_object();
    fields.iter_mut().for_each(|(_, value)| typed(value));
    schema
}

/// Writes all of them into a folder.
pub(crate) fn schemas(folder: &Path) -> Outcome {
    for (name, schema) in all() {
        let file = format!("{name}.json");
        save_in(folder, &file, &json_text(&schema)).map_err(|error| {
            Failure::Input(format!("cannot write `{}`: {error}", folder.join(&file).display()))
        })?;
    }
    Ok(())
}
