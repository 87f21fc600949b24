//! One claim in full.

use super::audit::{assumed, remarks, table_values};
use crate::audit::{
    ByHand, CellFinding, EquationFinding, EquationVerdict, Explanation, Failure, Finding,
    PaperAudit, Sound, TableFinding, Verdict, Working,
};
use crate::claim::{EquationBody, Table, Target};
use crate::exact::format::short;
use crate::report::formulas::equation::{outcome, sides};
use crate::report::formulas::function;
use crate::report::smooth::smoothness;
use crate::report::tables::eye::{self, Eye};
use crate::report::tables::headers;
use crate::report::tables::promise;
use crate::report::tables::reading;
use crate::report::tables::tried;
use crate::report::tables::working;
use crate::report::theorems::theorem;
use crate::report::words::kernel;
use crate::report::words::parts::definitions;
use crate::report::words::sheet::Sheet;

/// The results, beyond those of the audit, that explain a claim.
#[derive(Clone, Copy, Debug, Default)]
pub struct Background<'e> {
    /// The readings of the claim's table, from [`crate::audit::readings`]; empty if it has none.
    pub readings: &'e [Explanation],
    /// The result of [`crate::audit::by_hand`] for a theorem.
    pub by_hand: Option<&'e ByHand>,
    /// The result of [`crate::audit::working`] for a cell.
    pub working: Option<&'e Working>,
    /// The result of [`to_the_eye`](crate::report::to_the_eye) for a cell.
    pub eye: Option<&'e Eye>,
}

/// The claim, table or equation of this id (`key:table-1`, `key:table-1:2:3`, `key:eq-3.8`,
/// `key:range-1`, `key:theorem-1`) in full; `None` when there is none. With `all`, every reading is
/// shown.
#[must_use]
pub fn explain_sheet(
    audits: &[PaperAudit<'_>],
    id: &str,
    background: Background<'_>,
    all: bool,
) -> Option<Sheet> {
    let Background { readings, by_hand, working, eye } = background;
    let target = Target::of(id);
    let audit = audits.iter().find(|audit| audit.paper.key == target.key)?;
    let Some(finding) = audit.find(target) else {
        return smoothness::explain_table(audit, target);
    };
    let Finding::Table(finding) = finding else {
        if target.part.is_some() {
            return None;
        }
        let (claim, mut sheet) = (finding.claim(), Sheet::default());
        sheet.heading(1, format!("{id} · {}", claim.locus()));
        sheet.text(claim.title().to_owned());
        match finding {
            Finding::Table(_) => {}
            Finding::Equation(finding) => equation(&mut sheet, finding),
            Finding::Function(finding) => sheet.facts(function::function_facts(audit, finding)),
            Finding::Range(finding) => sheet.facts(function::range_facts(finding)),
            Finding::Smoothness(finding) => sheet.facts(smoothness::in_full(finding)),
            Finding::Theorem(finding) => sheet.facts(theorem::in_full(audit, finding, by_hand)),
        }
        return Some(sheet);
    };
    let mut sheet = Sheet::default();
    if target.part.is_none() {
        sheet.heading(1, format!("{id} · {}", finding.table.title));
        definition(&mut sheet, audit, finding, headers::schemes(finding.table));
        sheet.grid(table_values(finding));
        for line in remarks(finding).into_iter().chain(finding.table.note.clone()) {
            sheet.text(line);
        }
        for search in finding.searches() {
            sheet.facts(reading::facts(finding.table, search));
        }
        tried::section(&mut sheet, finding, readings, None, all);
        return Some(sheet);
    }
    let cell = finding.cells.iter().flatten().find(|cell| cell.id == id)?;
    sheet.heading(1, format!("{id} · {}", cell.locus));
    sheet.text(finding.table.title.clone());
    let scheme = target.cell().and_then(|place| headers::scheme_at(finding.table, place));
    match working {
        Some(working) => {
            let facts = working::facts(audit, finding, scheme, working);
            sheet.facts(facts);
        }
        None => definition(&mut sheet, audit, finding, scheme),
    }
    let mut facts = cell_facts(cell);
    facts.extend(eye.map(eye::fact));
    sheet.facts(facts);
    let at = cell_place(finding.table, target);
    if at.is_some() {
        tried::section(&mut sheet, finding, readings, at, all);
    }
    Some(sheet)
}

fn equation(sheet: &mut Sheet, finding: &EquationFinding<'_>) {
    let equation = finding.equation;
    if let EquationBody::Identity(identity) = &equation.body {
        sheet.facts(sides(identity));
    }
    sheet.text(format!("{} {}", finding.verdict.word().mark(), outcome(finding)));
    if let EquationVerdict::Fails { failures, .. } = &finding.verdict {
        let fact = |failure: &Failure| {
            let sides = format!("left  = {}\nright = {}", failure.left, failure.right);
            (failure.at.clone(), sides)
        };
        sheet.facts(failures.iter().map(fact).collect());
    } else if let Some(note) = &equation.note {
        sheet.text(note.clone());
    }
}

/// The table that an id names, or of which it names a cell, and the place of the cell,
/// counted from 0.
#[must_use]
pub fn table_of<'e, 'a>(
    audits: &'e [PaperAudit<'a>],
    id: &str,
) -> Option<(&'e TableFinding<'a>, Option<(usize, usize)>)> {
    let target = Target::of(id);
    let finding = audits.iter().find_map(|audit| audit.find(target))?;
    let Finding::Table(finding) = finding else { return None };
    Some((finding, cell_place(finding.table, target)))
}

/// The place of the printed cell of this id.
pub(crate) fn cell_place(table: &Table, target: Target<'_>) -> Option<(usize, usize)> {
    let at = target.cell()?;
    table.cells.get(at.0)?.get(at.1)?.printed()?;
    Some(at)
}

fn definition(
    sheet: &mut Sheet,
    audit: &PaperAudit<'_>,
    finding: &TableFinding<'_>,
    scheme: Option<(String, String)>,
) {
    let mut facts = Vec::from_iter(scheme);
    facts.push(("said to equal".to_owned(), finding.table.value.text.clone()));
    facts.extend(definitions(audit, &finding.table.value));
    sheet.facts(facts);
}

/// What is known of a cell.
pub(crate) fn cell_facts(cell: &CellFinding) -> Vec<(String, String)> {
    let mut facts = Vec::new();
    let mut fact = |name: &str, value: String| facts.push((name.to_owned(), value));
    fact("printed", cell.printed.clone().unwrap_or_else(|| "lost".to_owned()));
    if let Some(note) = &cell.note {
        fact("note", note.clone());
    }
    if let Some(exact) = &cell.exact {
        let (text, decimal) = (exact.to_string(), short(exact, 17));
        fact("exact", text.clone());
        if text != decimal {
            fact("decimal", decimal);
        }
    }
    if let Some(why) = &cell.undefined {
        fact("exact", format!("none: {why}"));
    }
    if let Some(read) = &cell.as_read {
        fact("read differently", read.differs());
        let (text, decimal) = (read.value.to_string(), short(&read.value, 17));
        let value = if text == decimal { text } else { format!("{text} = {decimal}") };
        fact("exact, as read", value);
    }
    if !cell.assumed.is_empty() {
        fact("computed at", format!("{}, which the paper does not state", assumed(cell)));
    }
    if let Some(verdict) = &cell.verdict_if_assumed {
        fact("verdict, if they were stated", verdict_text(verdict));
    }
    fact("verdict", verdict_text(&cell.verdict));
    match &cell.sound {
        Some(Sound::Depth { level, block }) => {
            fact("sound depth", format!("{level}, with c = {block}"));
        }
        Some(Sound::Least(level)) => fact("least level, exactly", level.to_string()),
        Some(Sound::Bound(bound)) => fact("sound bound", short(bound, 17)),
        Some(Sound::None(why)) => fact("sound value", format!("none: {why}")),
        None => {}
    }
    let kept = |kept| if kept { "kept" } else { "not kept" };
    if let Some(by_formula) = cell.kept_by_formula {
        fact("promise, by the printed formula", kept(by_formula).to_owned());
    }
    if let Some(by_sound) = cell.kept_by_sound {
        let text = if by_sound { "kept" } else { "not shown to be kept" };
        fact("promise, by the sound bound", text.to_owned());
    }
    facts.extend(promise::facts(cell));
    facts.extend(kernel::fact(cell));
    facts
}

fn verdict_text(verdict: &Verdict) -> String {
    let reason = match verdict {
        Verdict::Rounding(direction) => format!(": {direction}"),
        Verdict::Misprint(slip) => format!(": {slip}"),
        Verdict::NotCheckable(missing) => format!(": {missing}"),
        _ => String::new(),
    };
    format!("{} {}{reason}", verdict.word().mark(), verdict.word())
}
