//! An audit as JSON.

use super::consistency::contradictions_json;
use super::function::{function_json, range_json};
use super::parts::{DECIMAL_DIGITS, exact_json};
use super::promise;
use super::reading::search_json;
use super::summary::summary_json;
use super::theorem::theorem_json;
use crate::audit::{
    CellFinding, EquationFinding, EquationVerdict, PaperAudit, Sound, TableFinding, Verdict,
};
use crate::exact::format::short;
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;

/// The version of the JSON form.
const SCHEMA: u32 = 1;

/// An audit in the JSON form that the README documents.
#[must_use]
pub fn audit_json(audits: &[PaperAudit<'_>]) -> Value {
    json!({ "schema": SCHEMA, "papers": audits.iter().map(paper).collect::<Vec<Value>>() })
}

fn paper(audit: &PaperAudit<'_>) -> Value {
    let cells = audit.tables.iter().flat_map(|table| table.cells.iter().flatten());
    let claims = cells.map(cell).chain(audit.equations.iter().map(equation_json));
    let functions = audit.functions.iter().map(|finding| function_json(audit, finding));
    let claims = claims.chain(functions);
    let claims = claims.chain(audit.ranges.iter().map(range_json));
    let claims: Vec<Value> = claims.chain(audit.theorems.iter().map(theorem_json)).collect();
    let mut summary: BTreeMap<&str, usize> = Verdict::NAMES.iter().map(|name| (*name, 0)).collect();
    let counts = audit.cell_counts().into_iter().chain(audit.equation_counts());
    for (name, count) in counts.chain(audit.range_counts()).chain(audit.theorem_counts()) {
        *summary.entry(name).or_insert(0) += count;
    }
    json!({
        "key": audit.paper.key,
        "claims": claims,
        "summary": summary,
        "contradictions": contradictions_json(audit),
        "tables": audit.tables.iter().map(table).collect::<Vec<Value>>(),
        "cells": summary_json(&audit.cell_summary()),
        "promises": promise::counts_json(audit),
    })
}

/// A table, with what the search for its reading covered and found.
fn table(finding: &TableFinding<'_>) -> Value {
    let mut table = json!({
        "id": finding.table.id,
        "locus": finding.table.locus,
        "value": finding.table.value.text,
        "search": finding.search.as_ref().map(|search| search_json(finding.table, search)),
    });
    if let Some(search) = &finding.assumed_search {
        table["search_of_cells_with_assumptions"] = search_json(finding.table, search);
    }
    table
}

fn cell(cell: &CellFinding) -> Value {
    let why = match &cell.verdict {
        Verdict::Rounding(direction) => Some(direction.to_string()),
        Verdict::Misprint(slip) => Some(slip.to_string()),
        Verdict::NotCheckable(missing) => Some(missing.to_string()),
        _ => cell.undefined.clone(),
    };
    let notes: Vec<String> = [why, cell.note.clone()].into_iter().flatten().collect();
    let assumed: Map<String, Value> =
        cell.assumed.iter().map(|(name, value)| (name.clone(), json!(value.to_string()))).collect();
    json!({
        "id": cell.id,
        "locus": cell.locus,
        "kind": "number",
        "printed": cell.printed,
        "exact": cell.exact.as_ref().map(ToString::to_string),
        "decimal": cell.exact.as_ref().map(|exact| short(exact, DECIMAL_DIGITS)),
        "verdict": cell.verdict.name(),
        "reading": cell.as_read.as_ref().map(|read| json!({
            "differs": read.differs(),
            "exact": read.value.to_string(),
            "decimal": short(&read.value, DECIMAL_DIGITS),
        })),
        "sound": cell.sound.as_ref().map(|sound| sound_json(sound, cell)),
        "note": if notes.is_empty() { None } else { Some(notes.join("; ")) },
        "assumed": if assumed.is_empty() { Value::Null } else { Value::Object(assumed) },
        "verdict_if_assumed": cell.verdict_if_assumed.as_ref().map(Verdict::name),
    })
}

fn sound_json(sound: &Sound, cell: &CellFinding) -> Value {
    let mut object = match sound {
        Sound::Depth { level, block } => json!({ "depth": level, "block": block }),
        Sound::Least(level) => json!({ "depth": level, "least": true }),
        Sound::Bound(bound) => exact_json(bound),
        Sound::None(why) => json!({ "none": why }),
    };
    object["kept_by_formula"] = json!(cell.kept_by_formula);
    object["kept_by_sound_bound"] = json!(cell.kept_by_sound);
    promise::add_json(cell, &mut object);
    object
}

pub(super) fn equation_json(finding: &EquationFinding<'_>) -> Value {
    let (failures, mends, absent) = match &finding.verdict {
        EquationVerdict::Fails { failures, mends, .. } => {
            let failure = |failure: &crate::audit::Failure| {
                json!({
                    "at": failure.at,
                    "left": failure.left.to_string(),
                    "right": failure.right.to_string(),
                    "difference": failure.difference().to_string(),
                })
            };
            (Some(failures.iter().map(failure).collect::<Vec<Value>>()), Some(mends), None)
        }
        EquationVerdict::NotCheckable(absent) => (None, None, Some(format!("missing: {absent}"))),
        EquationVerdict::Holds { .. } => (None, None, None),
    };
    let notes: Vec<String> =
        [absent, finding.equation.note.clone()].into_iter().flatten().collect();
    json!({
        "id": finding.id,
        "locus": finding.equation.locus,
        "kind": "equation",
        "printed": finding.equation.title,
        "exact": null,
        "decimal": null,
        "verdict": finding.verdict.name(),
        "reading": null,
        "sound": null,
        "note": if notes.is_empty() { None } else { Some(notes.join("; ")) },
        "failures": failures,
        "mends": mends,
    })
}
