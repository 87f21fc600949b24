//! Errata as JSON.

use super::cells::{correct, origin};
use crate::audit::{Errata, Erratum, PaperAudit, Subject, Unchecked};
use crate::report::consistency::contradictions_json;
use crate::report::function::{function_json, range_json};
use crate::report::json::equation_json;
use crate::report::summary::summary_json;
use crate::report::theorem::theorem_json;
use serde_json::{Value, json};

/// The version of the JSON form.
const SCHEMA: u32 = 1;

/// The errata of papers.
#[must_use]
pub fn errata_json(audits: &[PaperAudit<'_>]) -> Value {
    let papers: Vec<Value> = audits.iter().map(|audit| paper(&audit.errata())).collect();
    json!({ "schema": SCHEMA, "papers": papers })
}

fn paper(errata: &Errata<'_, '_>) -> Value {
    let audit = errata.audit;
    let one = |(i, entry): (usize, &Erratum<'_, '_>)| erratum(audit, i + 1, entry);
    json!({
        "key": audit.paper.key,
        "note": audit.paper.bibliography.note,
        "errata": errata.errata.iter().enumerate().map(one).collect::<Vec<Value>>(),
        "unchecked": errata.unchecked.iter().map(unchecked).collect::<Vec<Value>>(),
        "contradictions": contradictions_json(audit),
        "theorems": audit.theorems.iter().map(theorem_json).collect::<Vec<Value>>(),
        "cells": summary_json(&audit.cell_summary()),
    })
}

fn erratum(audit: &PaperAudit<'_>, number: usize, erratum: &Erratum<'_, '_>) -> Value {
    let (subject, changes) = (&erratum.subject, &erratum.consequences);
    let detail = match subject {
        Subject::Cells(cells) => {
            let cell = |&(row, column): &(usize, usize)| {
                let finding = &cells.finding.cells[row][column];
                let printed = cells.finding.table.cells[row][column].printed();
                json!({
                    "id": finding.id,
                    "locus": finding.locus,
                    "printed": finding.printed,
                    "by_definition": printed.map(|printed| correct(finding.exact.as_ref(), printed)),
                })
            };
            json!({
                "standing": cells.outcome.standing.name(),
                "cause": cells.outcome.cause,
                "origin": origin(cells),
                "cells": cells.cells.iter().map(cell).collect::<Vec<Value>>(),
            })
        }
        Subject::Equation(finding) => equation_json(finding),
        Subject::Function(finding) => function_json(audit, finding),
        Subject::Range(finding) => range_json(finding),
        Subject::Theorem(finding) => theorem_json(finding),
    };
    let theorems: Vec<&str> = changes.theorems.iter().map(|t| t.id.as_str()).collect();
    json!({
        "number": number,
        "id": format!("{}:{}", audit.paper.key, subject.id()),
        "locus": subject.locus(),
        "verdict": subject.verdict(),
        "detail": detail,
        "changes": {
            "any": changes.any(),
            "smaller": changes.smaller,
            "larger": changes.larger,
            "broken_by_formula": changes.broken_by_formula,
            "kept": changes.kept,
            "broken": changes.broken,
            "open": changes.open,
            "used_by": changes.used_by,
            "theorems": theorems,
        },
    })
}

fn unchecked(group: &Unchecked<'_, '_>) -> Value {
    json!({
        "table": group.finding.table.id,
        "locus": group.finding.table.locus,
        "cause": group.cause,
        "cells": group.findings().map(|cell| cell.id.as_str()).collect::<Vec<&str>>(),
        "outcomes": summary_json(&group.if_assumed()),
    })
}
