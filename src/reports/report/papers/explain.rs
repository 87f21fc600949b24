//! One claim in full.

use super::audit::assumed;
use crate::audit::{CellFinding, Finding, PaperAudit, Sound, TableFinding, Verdict};
use crate::claim::{Table, Target};
use crate::exact::format::{raised_digits, short};
use crate::report::smooth::smoothness;
use crate::report::tables::eye;
use crate::report::tables::headers;
use crate::report::tables::promise;
use crate::report::tables::tried;
use crate::report::tables::working;
use crate::report::told::{Background, told};
use crate::report::words::kernel;
use crate::report::words::parts::definition;
use crate::report::words::sheet::Sheet;

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
    let target = Target::of(id);
    let audit = audits.iter().find(|audit| audit.paper.key == target.key)?;
    let Some(finding) = audit.find(target) else {
        return smoothness::explain_table(audit, target);
    };
    let (claim, mut sheet) = (finding.claim(), Sheet::default());
    if target.part.is_none() {
        if let Finding::Table(_) = finding {
            sheet.heading(1, format!("{id} · {}", claim.title()));
        } else {
            sheet.heading(1, format!("{id} · {}", claim.locus()));
            sheet.text(claim.title().to_owned());
        }
        told(finding).in_full(&mut sheet, audit, background, all);
        return Some(sheet);
    }
    let Finding::Table(finding) = finding else { return None };
    let Background { readings, working, eye, .. } = background;
    let cell = finding.cells.iter().flatten().find(|cell| cell.id == id)?;
    sheet.heading(1, format!("{id} · {}", cell.locus));
    sheet.text(finding.table.title.clone());
    let scheme = target.cell().and_then(|place| headers::scheme_at(finding.table, place));
    match working {
        Some(working) => {
            let facts = working::facts(audit, finding, scheme, working);
            sheet.facts(facts);
        }
        None => sheet.facts(definition(audit, finding, scheme)),
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

/// What is known of a cell.
pub(crate) fn cell_facts(cell: &CellFinding) -> Vec<(String, String)> {
    let mut facts = Vec::new();
    let mut fact = |name: &str, value: String| facts.push((name.to_owned(), value));
    fact("printed", cell.shown().to_owned());
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
    fact(
        "verdict",
        if cell.is_blank() {
            "none: nothing is printed, and so nothing is claimed".to_owned()
        } else {
            verdict_text(&cell.verdict)
        },
    );
    match &cell.sound {
        Some(Sound::Depth { level, block }) => {
            fact("sound depth", format!("{level}, with c = {block}"));
        }
        Some(Sound::Least(level)) => fact("least level, exactly", level.to_string()),
        Some(Sound::Bound(bound)) => fact("sound bound", short(&raised_digits(bound, 17), 17)),
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
