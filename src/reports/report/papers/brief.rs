//! An audit at first sight: for each paper what does most harm, and the counts.

use super::overview::counted;
use crate::audit::{Harm, PaperAudit};
use crate::report::errata::differences::{Line, cut, lines};
use crate::report::words::sheet::Sheet;

/// How many differences are shown of each paper.
const SHOWN: usize = 3;

/// The most characters of a line.
const WIDEST: usize = 94;

/// For each paper the verdicts of all claims, counted, and the differences from the exact values that do most harm,
/// with what is right instead.
///
/// No line of a finding is longer than `width`, where the terminal has one.
#[must_use]
pub fn brief_sheet(audits: &[PaperAudit<'_>], width: Option<usize>) -> Sheet {
    let width = width.map_or(WIDEST, |width| width.saturating_sub(6).min(WIDEST));
    let mut sheet = Sheet::default();
    let differences: Vec<_> = audits.iter().map(lines).collect();
    sheet.text(format!(
        "{} papers: {} differences between what they print and the exact values. Below stand the differences of each \
         paper that do most harm, in the form: what is printed → what is right, or why it is false.",
        audits.len(),
        differences.iter().map(Vec::len).sum::<usize>(),
    ));
    for (audit, lines) in audits.iter().zip(differences) {
        let (all, source) = (lines.len(), audit.paper.bibliography.short());
        sheet.heading(2, format!("{} · {source} · {all} differences", audit.paper.key));
        sheet.text(format!("{}.", counted(audit)));
        let fact = |line: Line| (line.word.mark().to_owned(), words(&line, width));
        sheet.facts(worst(lines).into_iter().map(fact).collect());
    }
    sheet
}

/// First one difference of each harm, then the second of each, and so on; in the end the worst first.
fn worst(lines: Vec<(Harm, Line)>) -> Vec<Line> {
    let mut ranked: Vec<(usize, Harm, Line)> = Vec::new();
    for (harm, line) in lines {
        let rank = ranked.iter().filter(|(_, other, _)| *other == harm).count();
        ranked.push((rank, harm, line));
    }
    ranked.sort_by_key(|(rank, harm, _)| (*rank, *harm));
    ranked.truncate(SHOWN);
    ranked.sort_by_key(|(_, harm, _)| *harm);
    ranked.into_iter().map(|(.., line)| line).collect()
}

/// Where it stands and what it is about; and what is right, or how it came about where that is shorter.
fn words(line: &Line, width: usize) -> String {
    let fits = |text: &String| text.chars().count() <= width;
    let mut change = format!("{} → {}", line.printed, line.exact);
    // What comes last says who checked it.
    if !fits(&change)
        && let Some((shorter, _)) = change.rsplit_once(" · ")
    {
        change.truncate(shorter.len());
    }
    let fits = fits(&change) || line.origin.is_empty();
    let what = if fits { change } else { line.origin.clone() };
    let id = &line.id;
    let place = cut(line.place.clone(), width.saturating_sub(id.chars().count() + 3));
    format!("{place} · {id}\n{}", cut(what, width))
}
