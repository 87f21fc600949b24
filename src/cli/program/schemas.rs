//! `subcert schemas DIR`: the JSON schemas of what `--format json` writes, from the types that are
//! written, and of claim files, from those that are read.

use crate::cli::console::output::{Failure, Outcome, json_text};
use crate::cli::console::save::save;
use crate::cli::json::{
    certify, constants, depth, facts, geometric_depth, listing, mesh_depth, range, schemes,
    smoothness, spectrum, vertex,
};
use schemars::{JsonSchema, Schema, generate::SchemaSettings};
use serde_json::Value;
use std::path::Path;
use subcert::oracle::OracleValues;
use subcert::report::json::{
    AuditReport, CoverageReport, ErrataReport, Explained, Facts, ProjectsReport, ShippedTable,
};

/// The name of a file, and its schema.
fn all() -> Vec<(&'static str, Schema)> {
    fn of<T: JsonSchema>() -> Schema {
        // What is written, not what could be read: an absent field may be required otherwise.
        SchemaSettings::draft2020_12().for_serialize().into_generator().into_root_schema_for::<T>()
    }
    vec![
        ("atlas", of::<facts::Atlas<'_>>()),
        ("audit", of::<AuditReport>()),
        ("audit-project", of::<ProjectsReport>()),
        ("claims", read(subcert::claim::paper_schema())),
        ("claims-project", read(subcert::shipped::project_schema())),
        ("certify", of::<certify::Certification<'_>>()),
        ("constants", of::<constants::Constants<'_>>()),
        ("constants-ring", of::<constants::LocalConstants<'_>>()),
        ("coverage", of::<CoverageReport>()),
        ("depth", of::<depth::Report<'_>>()),
        ("depth-mesh", of::<mesh_depth::Report<'_>>()),
        ("depth-mesh-geometric", of::<geometric_depth::Report<'_>>()),
        ("depth-ring", of::<depth::LocalReport<'_>>()),
        ("errata", of::<ErrataReport>()),
        ("explain", of::<Explained>()),
        ("explain-list", of::<listing::Listing<'_>>()),
        ("explain-project", of::<ShippedTable>()),
        ("jsr", of::<smoothness::JointRadius<'_>>()),
        ("oracle", of::<OracleValues>()),
        ("range", of::<range::Range<'_>>()),
        ("range-smoothness", of::<range::SmoothRange<'_>>()),
        ("range-smoothness-map", of::<range::SmoothMap<'_>>()),
        ("scheme", of::<Facts<'_>>()),
        ("schemes", of::<schemes::Catalogue<'_>>()),
        ("smoothness", of::<smoothness::Smoothness<'_>>()),
        ("smoothness-vertex", of::<vertex::Vertices<'_>>()),
        ("spectrum", of::<spectrum::Spectrum<'_>>()),
        ("spectrum-sector", of::<spectrum::Sector<'_>>()),
    ]
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
        let file = folder.join(format!("{name}.json"));
        save(&file, &json_text(&schema)).map_err(|error| {
            Failure::Input(format!("cannot write `{}`: {error}", file.display()))
        })?;
    }
    Ok(())
}
