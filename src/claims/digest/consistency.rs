//! Contradictions between the tables of a paper: choices and parameters of which two tables, or
//! parts of tables, need different values.

use crate::claim::Paper;
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::Library;
use crate::evaluation::table::Evaluator;
use crate::exact::Rational;
use crate::finding::{
    CellFinding, Contradiction, Difference, Explanation, Line, Needed, Recovered, RecoveredFrom,
    Side, TableFinding, TablePart, WayCounts,
};
use crate::judge::reading::tried;
use std::collections::BTreeSet;

/// How many cells a table may lose under a reading that still suits it: one, which may
/// be a slip.
const MAX_LOST: usize = 1;

/// A table, or a row or column of one, whose cells are explained.
struct Explained<'f, 'a> {
    finding: &'f TableFinding<'a>,
    line: Option<Line>,
    /// The reading; `None` where every cell is as printed.
    by: Option<&'f Explanation>,
    needs: &'f [WayCounts],
}

/// The contradictions between the tables of a paper, choices first.
pub(crate) fn judge(
    paper: &Paper,
    tables: &[TableFinding<'_>],
    library: &Library<'_>,
) -> Result<Vec<Contradiction>, Diagnostic> {
    let explained: Vec<Explained<'_, '_>> = tables.iter().flat_map(places).collect();
    let mut found = choices(&explained);
    found.extend(parameters(paper, &explained, library)?);
    Ok(found)
}

/// The explained parts of a table: the whole table, or rows and columns of it.
fn places<'f, 'a>(finding: &'f TableFinding<'a>) -> Vec<Explained<'f, 'a>> {
    let whole = |by| Explained { finding, line: None, by, needs: &finding.needs };
    if finding.searches().next().is_none() {
        let valued = |cell: &CellFinding| cell.printed.is_some() && cell.unknown.is_none();
        let printed = finding.cells.iter().flatten().any(valued);
        return printed.then(|| whole(None)).into_iter().collect();
    }
    let parts = finding.searches().flat_map(|search| {
        let lines = search.lines.iter().filter(|line| line.shift == (0, 0));
        let lines = lines.map(|line| Explained {
            finding,
            line: Some(line.line),
            by: Some(&line.best),
            needs: &line.needs,
        });
        search.best.first().map(|best| whole(Some(best))).into_iter().chain(lines)
    });
    parts.collect()
}

impl Explained<'_, '_> {
    fn place(&self, explained: usize, otherwise: usize) -> TablePart {
        let table = self.finding.table.id.clone();
        TablePart { table, line: self.line, explained, otherwise }
    }

    /// How many cells are explained.
    fn count(&self) -> usize {
        self.by.map_or_else(
            || self.finding.cells.iter().flatten().filter(|cell| cell.printed.is_some()).count(),
            Explanation::count,
        )
    }
}

/// The choices without a way that suits every place.
fn choices(explained: &[Explained<'_, '_>]) -> Vec<Contradiction> {
    let names: BTreeSet<&str> =
        explained.iter().flat_map(|place| place.needs).map(|need| need.about.as_str()).collect();
    names.into_iter().filter_map(|name| one_choice(explained, name)).collect()
}

fn one_choice(explained: &[Explained<'_, '_>], name: &str) -> Option<Contradiction> {
    let need =
        |place: &Explained<'_, '_>| place.needs.iter().find(|need| need.about == name).cloned();
    // A place that every way suits says nothing.
    let mut left: Vec<(&Explained<'_, '_>, WayCounts)> = explained
        .iter()
        .filter_map(|place| Some((place, need(place)?)))
        .filter(|(_, need)| need.suitable(MAX_LOST).len() < need.ways.len())
        .collect();
    let mut sides = Vec::new();
    // The way that suits most places makes one side of them; the remaining places make the next
    // sides.
    while !left.is_empty() {
        let ways: BTreeSet<Option<Difference>> = left
            .iter()
            .flat_map(|(_, need)| need.suitable(MAX_LOST))
            .map(Option::<&Difference>::cloned)
            .collect();
        let suits = |need: &WayCounts, way: &Option<Difference>| {
            need.suitable(MAX_LOST).contains(&way.as_ref())
        };
        let suited =
            |way: &Option<Difference>| left.iter().filter(|(_, need)| suits(need, way)).count();
        // Of equally good ways the first.
        let way = ways.into_iter().rev().max_by_key(|way| suited(way))?;
        let (here, rest): (Vec<_>, Vec<_>) =
            left.into_iter().partition(|(_, need)| suits(need, &way));
        left = rest;
        sides.push((way, here));
    }
    if sides.len() < 2 {
        return None;
    }
    let all: Vec<Option<Difference>> = sides.iter().map(|(way, _)| way.clone()).collect();
    let side = |(way, here): (Option<Difference>, Vec<(&Explained<'_, '_>, WayCounts)>)| {
        let place = |(place, need): (&Explained<'_, '_>, WayCounts)| {
            let others = all.iter().filter(|other| **other != way);
            let otherwise = others.filter_map(|other| need.ways.get(other)).max();
            let explained = need.ways.get(&way).copied().unwrap_or(0);
            place.place(explained, otherwise.copied().unwrap_or(0))
        };
        let places = here.into_iter().map(place).collect();
        Side { places, needs: way.clone().map_or(Needed::AsPrinted, Needed::Difference) }
    };
    let sides = sides.into_iter().map(side).collect();
    Some(Contradiction { about: name.to_owned(), sides })
}

/// The parameters of which places need different values: each of two places loses more than one
/// cell at the value that the other needs.
fn parameters(
    paper: &Paper,
    explained: &[Explained<'_, '_>],
    library: &Library<'_>,
) -> Result<Vec<Contradiction>, Diagnostic> {
    let solved = explained.iter().filter_map(|place| place.by).flat_map(|by| &by.solved);
    let solved = solved.map(|solved| solved.name.as_str());
    let recovered = explained.iter().flat_map(|place| place.finding.recovered.keys());
    let names: BTreeSet<&str> = solved.chain(recovered.map(String::as_str)).collect();
    let mut found = Vec::new();
    for name in names {
        let mut valued = Vec::new();
        for place in explained {
            let judge =
                Evaluator::new(paper, place.finding.table, library, &place.finding.values())?;
            let value = own_value(place, &judge, name);
            valued.extend(value.map(|value| (place, judge, value)));
        }
        let mut sides: Vec<(Rational, Vec<TablePart>)> = Vec::new();
        for (place, judge, value) in &valued {
            let mut worst = None;
            for (other, other_judge, other_value) in &valued {
                if value == other_value || overlap(place, other, name) {
                    continue;
                }
                let (here, there) = (
                    tried::remaining(judge, place.finding, place.by, name, other_value),
                    tried::remaining(other_judge, other.finding, other.by, name, value),
                );
                if here + MAX_LOST < place.count() && there + MAX_LOST < other.count() {
                    worst = worst.max(Some(here));
                }
            }
            let Some(otherwise) = worst else { continue };
            let place = place.place(place.count(), otherwise);
            match sides.iter_mut().find(|(known, _)| known == value) {
                Some((_, places)) => places.push(place),
                None => sides.push((value.clone(), vec![place])),
            }
        }
        let side = |(value, places)| Side { needs: Needed::Value(name.to_owned(), value), places };
        if sides.len() > 1 {
            let sides = sides.into_iter().map(side).collect();
            found.push(Contradiction { about: name.to_owned(), sides });
        }
    }
    Ok(found)
}

/// The value of a parameter at which a place is explained: solved for, assumed or recovered, or
/// stated.
fn own_value(place: &Explained<'_, '_>, judge: &Evaluator<'_>, name: &str) -> Option<Rational> {
    let solved = place.by.and_then(|by| by.solved.iter().find(|solved| solved.name == name));
    let solved = solved.map(|solved| &solved.simplest);
    let value = solved.or_else(|| judge.assumed.get(name));
    value.or_else(|| judge.given.get(name)).cloned()
}

/// Whether two places that were solved for a parameter have a value in common.
fn overlap(first: &Explained<'_, '_>, second: &Explained<'_, '_>, name: &str) -> bool {
    let between = |place: &Explained<'_, '_>| match place.finding.recovered.get(name) {
        Some(Recovered { from: RecoveredFrom::Solved(low, high), .. }) => {
            Some((low.clone(), high.clone()))
        }
        Some(_) => None,
        None => {
            let solved = place.by?.solved.iter().find(|solved| solved.name == name)?;
            Some(solved.between.clone())
        }
    };
    match (between(first), between(second)) {
        (Some(first), Some(second)) => first.0 <= second.1 && second.0 <= first.1,
        _ => false,
    }
}
