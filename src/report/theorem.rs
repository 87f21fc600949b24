//! Findings about theorems.

use super::explain::definitions;
use super::mark;
use super::sheet::Sheet;
use crate::audit::{PaperAudit, TheoremFinding};
use crate::claim::Statement;
use serde_json::{Value, json};

/// The section on theorems. An open theorem is nothing right, so all are shown.
pub(super) fn section(sheet: &mut Sheet, audit: &PaperAudit<'_>) {
    if audit.theorems.is_empty() {
        return;
    }
    sheet.heading(2, "Theorems");
    let fact = |finding: &TheoremFinding<'_>| {
        let name = format!("{} {}", mark(finding.verdict.name()), finding.theorem.locus);
        (name, format!("{}\n{}", finding.theorem.title, outcome(finding)))
    };
    sheet.facts(audit.theorems.iter().map(fact).collect());
}

/// How many theorems have which verdict, for the summary.
pub(super) fn summary(audit: &PaperAudit<'_>) -> String {
    let counts = audit.theorem_counts();
    let parts: Vec<String> = counts.iter().map(|(name, count)| format!("{count} {name}")).collect();
    if parts.is_empty() { "·".to_owned() } else { parts.join(", ") }
}

/// `open · rests on (24), (25), which fail`.
fn outcome(finding: &TheoremFinding<'_>) -> String {
    let mut loci: Vec<&str> = Vec::new();
    for premise in &finding.failing {
        // Several claims may stand in one place.
        if !loci.contains(&premise.locus) {
            loci.push(premise.locus);
        }
    }
    let failing = match loci.len() {
        0 => String::new(),
        1 => format!(" · rests on {}, which fails", loci[0]),
        _ => format!(" · rests on {}, which fail", loci.join("; ")),
    };
    format!("{}{failing}", finding.verdict.name())
}

/// What is stated, in the formula language.
fn statement(statement: &Statement) -> String {
    match statement {
        Statement::Bound { quantity, by, from } => {
            format!("{} ≤ {} for k ≥ {from}", quantity.notation(), by.text)
        }
        Statement::Depth(by) => format!("‖P^∞ − P^k‖ ≤ epsilon for k ≥ {}", by.text),
        Statement::Other(says) => says.clone(),
    }
}

/// The theorem of this id in full, if it is one.
pub(super) fn explain(audit: &PaperAudit<'_>, id: &str) -> Option<Sheet> {
    let finding = audit.theorems.iter().find(|finding| finding.id == id)?;
    let theorem = finding.theorem;
    let mut sheet = Sheet::default();
    sheet.heading(1, format!("{id} · {}", theorem.locus));
    sheet.text(theorem.title.clone());
    let mut facts = Vec::new();
    facts.extend(theorem.scheme.as_ref().map(|s| ("scheme".to_owned(), s.reference.to_string())));
    facts.push(("states".to_owned(), statement(&theorem.statement)));
    if let Statement::Bound { by, .. } | Statement::Depth(by) = &theorem.statement {
        facts.extend(definitions(audit, by));
    }
    if !theorem.rests.is_empty() {
        facts.push(("rests on".to_owned(), theorem.rests.join(", ")));
    }
    let verdict = format!("{} {}", mark(finding.verdict.name()), outcome(finding));
    facts.push(("verdict".to_owned(), verdict));
    facts.extend(theorem.note.clone().map(|note| ("note".to_owned(), note)));
    sheet.facts(facts);
    Some(sheet)
}

pub(super) fn theorem_json(finding: &TheoremFinding<'_>) -> Value {
    let theorem = finding.theorem;
    let (bounds, from) = match &theorem.statement {
        Statement::Bound { quantity, from, .. } => (Some(quantity.name()), Some(from)),
        Statement::Depth(_) => (Some("depth"), None),
        Statement::Other(_) => (None, None),
    };
    let printed = match &theorem.statement {
        Statement::Bound { by, .. } | Statement::Depth(by) => &by.text,
        Statement::Other(says) => says,
    };
    let failing: Vec<&str> = finding.failing.iter().map(|premise| premise.id).collect();
    json!({
        "id": finding.id,
        "locus": theorem.locus,
        "kind": "theorem",
        "printed": printed,
        "exact": null,
        "decimal": null,
        "verdict": finding.verdict.name(),
        "reading": null,
        "sound": null,
        "note": theorem.note,
        "bounds": bounds,
        "from": from,
        "rests": theorem.rests,
        "failing": failing,
    })
}
