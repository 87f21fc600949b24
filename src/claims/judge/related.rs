//! Tables that are judged together, since the numbers of one may determine a parameter of another.

use crate::claim::{Paper, Promise, Table};
use crate::cores;
use crate::diagnostic::Diagnostic;
use crate::exact::Rational;
use crate::finding::{
    CellKind, Difference, Explanation, Recovered, RecoveredFrom, TableFinding, Verdict,
};
use crate::judge::kind::Judge;
use crate::judge::reading::chance::{Evidence, is_small};
use crate::judge::reading::dependence::Known;
use crate::judge::reading::plain::{as_plain, height};
use crate::judge::reading::space::Family;
use crate::judge::recovery::{self, RecoveredValues, Values, combinations, reproduced};
use crate::judge::table::{judge, judge_promises};
use std::collections::BTreeSet;

impl<'a> Judge<'a> for Table {
    type Finding = TableFinding<'a>;

    /// Tables about schemes of the same name are judged together, since the numbers of one may determine a
    /// parameter of another.
    fn groups(tables: &'a [Table]) -> Vec<Vec<&'a Table>> {
        let mut groups: Vec<(Vec<usize>, BTreeSet<&str>)> = Vec::new();
        for (place, table) in tables.iter().enumerate() {
            let ring = table.promise.as_ref().and_then(Promise::ring);
            let references = table.schemes().chain(ring);
            let names: BTreeSet<&str> = references.flat_map(|one| one.reference.names()).collect();
            let (same, others) = groups
                .into_iter()
                .partition(|(_, others): &(_, BTreeSet<&str>)| !others.is_disjoint(&names));
            groups = others;
            groups.push(same.into_iter().fold(
                (vec![place], names),
                |mut group, (places, names)| {
                    group.0.extend(places);
                    group.1.extend(names);
                    group
                },
            ));
        }
        let sorted = |(mut places, _): (Vec<usize>, _)| {
            places.sort_unstable();
            places.into_iter().map(|place| &tables[place]).collect()
        };
        groups.into_iter().map(sorted).collect()
    }

    fn work(&self) -> usize {
        self.cells.iter().flatten().count()
    }

    /// Judges related tables. Parameters that the paper does not state are recovered in passes, each of which may
    /// use the values that earlier passes have found.
    fn judge(
        paper: &'a Paper,
        tables: &[&'a Table],
        after_claim: &(dyn Fn() + Sync),
    ) -> Result<Vec<TableFinding<'a>>, Diagnostic> {
        let judged = cores::map(tables, |&table| {
            // Of these tables nothing is recovered.
            let known = open(table).next().is_none();
            let family = if known { Family::InTurn } else { Family::Plain };
            judge(paper, table, Values::new(), family)
        });
        let mut findings =
            judged.into_iter().collect::<Result<Vec<TableFinding<'a>>, Diagnostic>>()?;
        let mut fitting = vec![None; findings.len()];
        let mut tried: Vec<Option<Offers>> = vec![None; findings.len()];
        // A pass may recover values that help the next one.
        loop {
            let mut more = false;
            for i in 0..findings.len() {
                if missing(&findings[i]).is_empty() {
                    continue;
                }
                let offers = offers(&findings[i], &findings);
                // With the same offers an earlier pass found nothing.
                if tried[i].as_ref() == Some(&offers) {
                    continue;
                }
                let found = recover(paper, &findings[i], &offers);
                (tried[i], fitting[i]) = (Some(offers), None);
                match found? {
                    RecoveredValues::Values(found) => (findings[i], more) = (*found, true),
                    RecoveredValues::Fitting(values) => fitting[i] = Some(values),
                    RecoveredValues::Nothing => {}
                }
            }
            if !more {
                break;
            }
        }
        let judged: Vec<_> = findings.into_iter().zip(fitting).collect();
        let judged = cores::map(&judged, |(finding, fitting)| {
            let mut finding = finding.clone();
            widen(paper, &mut finding)?;
            finding.fitting.clone_from(fitting);
            judge_promises(paper, &mut finding)?;
            after_claim();
            Ok(finding)
        });
        judged.into_iter().collect()
    }
}

/// Judges a table again by the whole family of readings, if the readings that take nothing from
/// elsewhere leave cells unexplained, and this has not been done yet.
fn widen<'a>(paper: &'a Paper, finding: &mut TableFinding<'a>) -> Result<(), Diagnostic> {
    if open(finding.table).next().is_some() && !finding.is_explained() {
        let recovered = std::mem::take(&mut finding.recovered);
        *finding = judge(paper, finding.table, recovered, Family::Whole)?;
    }
    Ok(())
}

/// Uses recovered values in other tables. A table whose own numbers do not give a parameter gets
/// the value, of those that other tables of the paper give for the same name, at which most of its
/// cells are reproduced. Tables with different values of their own share one where their numbers
/// together say so. Tables that get a value are judged again.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub(crate) fn borrow<'a>(
    paper: &'a Paper,
    findings: &mut [TableFinding<'a>],
) -> Result<(), Diagnostic> {
    let names: BTreeSet<String> =
        findings.iter().flat_map(|finding| finding.recovered.keys().cloned()).collect();
    for name in &names {
        agree(paper, findings, name)?;
    }
    // What a table gets here it hands on to no other.
    let borrowed = cores::map(findings, |finding| {
        let offers: Offers = missing(finding)
            .into_iter()
            .map(|name| (name.clone(), offered(finding, findings, &name, |_| true)))
            .filter(|(_, offers)| !offers.is_empty())
            .collect();
        let mut best: Option<TableFinding<'a>> = None;
        for offered in combinations(&offers).into_iter().filter(|offered| !offered.is_empty()) {
            let values = finding.recovered.clone().into_iter().chain(offered).collect();
            let found = judge(paper, finding.table, values, Family::Whole)?;
            if best.as_ref().is_none_or(|best| reproduced(best) < reproduced(&found)) {
                best = Some(found);
            }
        }
        if let Some(found) = &mut best {
            judge_promises(paper, found)?;
        }
        Ok(best)
    });
    for (finding, found) in findings.iter_mut().zip(borrowed) {
        if let Some(found) = found? {
            *finding = found;
        }
    }
    Ok(())
}

/// Where the numbers of tables give a parameter different values, the plainest, or the one for which
/// all tables that have a value tell, becomes that of all, but for a table with evidence of its own
/// or with a reading that is nearer to the printed text at its own, and for the tables that have
/// their value from it. A difference from the printed text that another table has too is none.
fn agree<'a>(
    paper: &'a Paper,
    findings: &mut [TableFinding<'a>],
    name: &String,
) -> Result<(), Diagnostic> {
    let mut own: Vec<Recovered> = Vec::new();
    for finding in &*findings {
        let Some(known) = finding.recovered.get(name).filter(|known| known.is_own()) else {
            continue;
        };
        if own.iter().all(|other| other.value != known.value) {
            let (id, locus) = (finding.table.id.clone(), finding.table.locus.clone());
            let from = RecoveredFrom::Table { id, locus };
            own.push(Recovered { value: known.value.clone(), from });
        }
    }
    if own.len() < 2 {
        return Ok(());
    }
    own.sort_by_key(|known| height(&known.value));
    // Of each table, the findings at the values of the others.
    let having: Vec<usize> =
        (0..findings.len()).filter(|&i| findings[i].recovered.contains_key(name)).collect();
    let tried = cores::map(&having, |&i| {
        let finding = &findings[i];
        let at = |value: &Recovered| {
            if finding.recovered[name].value == value.value {
                return Ok(finding.clone());
            }
            let mut values = finding.recovered.clone();
            values.insert(name.clone(), value.clone());
            judge(paper, finding.table, values, Family::Whole)
        };
        own.iter().map(at).collect::<Result<Vec<TableFinding<'a>>, Diagnostic>>()
    });
    let tried = tried.into_iter().collect::<Result<Vec<_>, Diagnostic>>()?;
    // The plainest, unless the numbers of all tables tell for another.
    let most = (1..own.len()).fold(0, |most, k| {
        let pairs: Vec<_> = tried.iter().map(|found| (&found[k], &found[most])).collect();
        if has_evidence(&pairs, &own[k].value) { k } else { most }
    });
    let moves = |place: usize| {
        let (now, then) = (&findings[having[place]], &tried[place][most]);
        let (known, id) = (&now.recovered[name], &now.table.id);
        let others = findings.iter().filter(|other| other.table.id != *id);
        let others: Vec<&Difference> =
            others.filter_map(reading).flat_map(|best| &best.differences).collect();
        known.is_own()
            && known.value != own[most].value
            && reproduced(then) > 0
            && differences(then, &others) <= differences(now, &others)
            && !has_evidence(&[(now, then)], &known.value)
    };
    let moving: Vec<usize> = (0..having.len()).filter(|&place| moves(place)).collect();
    let ids: BTreeSet<String> =
        moving.iter().map(|&place| findings[having[place]].table.id.clone()).collect();
    for (place, mut found) in having.into_iter().zip(tried) {
        let lent = match &findings[place].recovered[name].from {
            RecoveredFrom::Table { id, .. } => ids.contains(id),
            RecoveredFrom::Solved(..) | RecoveredFrom::Tried => false,
        };
        if lent || ids.contains(&findings[place].table.id) {
            let mut found = found.swap_remove(most);
            judge_promises(paper, &mut found)?;
            findings[place] = found;
        }
    }
    Ok(())
}

/// The reading of the reproduced cells.
fn reading<'f>(finding: &'f TableFinding<'_>) -> Option<&'f Explanation> {
    finding.search_of(CellKind::Assumed)?.best.first()
}

/// How many differences from the printed text the reading of the reproduced cells has, other than
/// those of the readings of other tables.
fn differences(finding: &TableFinding<'_>, others: &[&Difference]) -> usize {
    let own = reading(finding).into_iter().flat_map(|best| &best.differences);
    own.filter(|difference| !others.contains(difference)).count()
}

/// Whether what is reproduced in the first table of each pair, at `value`, and not in the second, at
/// another value, is no luck: one of the numbers as plain as `value` would give as many of the cells
/// that the second leaves.
fn has_evidence(pairs: &[(&TableFinding<'_>, &TableFinding<'_>)], value: &Rational) -> bool {
    let (mut cells, mut count, mut start) = (Vec::new(), 0, 0);
    for (now, then) in pairs {
        let is_depth = matches!(now.table.promise, Some(Promise::Depth { .. }));
        let (rows, columns) = (now.table.cells.len(), now.table.cells.iter().map(Vec::len).max());
        for (row, printed) in now.table.cells.iter().enumerate() {
            for (column, cell) in printed.iter().enumerate() {
                let left = then.cells[row][column].verdict != Verdict::Reproduced;
                let Some(printed) = cell.printed().filter(|_| left) else { continue };
                let place = (start + row, start + column);
                cells.push((Known { place, printed, value: None }, is_depth));
                count += usize::from(now.cells[row][column].verdict == Verdict::Reproduced);
            }
        }
        start += rows.max(columns.unwrap_or(0));
    }
    is_small(&Evidence::of(cells).chance(count, &as_plain(value)))
}

/// The parameters that a table leaves open and that were not recovered.
fn missing(finding: &TableFinding<'_>) -> Vec<String> {
    let names = open(finding.table);
    names.filter(|name| !finding.recovered.contains_key(*name)).cloned().collect()
}

/// The parameters that a table leaves open.
fn open(table: &Table) -> impl Iterator<Item = &String> {
    let unstated = table.unstated.iter().filter(|(_, assumed)| assumed.is_none());
    unstated.map(|(name, _)| name)
}

/// The values of a parameter that suitable other tables give by their own numbers. Each value comes
/// once, from the first table that has it.
fn offered(
    finding: &TableFinding<'_>,
    all: &[TableFinding<'_>],
    name: &str,
    suitable: impl Fn(&Table) -> bool,
) -> Vec<Recovered> {
    let mut found: Vec<Recovered> = Vec::new();
    for other in all.iter().filter(|other| suitable(other.table)) {
        let Some(recovered) = other.recovered.get(name) else { continue };
        let known = found.iter().any(|known| known.value == recovered.value);
        if recovered.is_own() && !known && other.table.id != finding.table.id {
            let (id, locus) = (other.table.id.clone(), other.table.locus.clone());
            let from = RecoveredFrom::Table { id, locus };
            found.push(Recovered { value: recovered.value.clone(), from });
        }
    }
    found
}

/// For parameters that a table lacks, the values that other tables have recovered.
type Offers = Vec<(String, Vec<Recovered>)>;

/// For each parameter that a table misses, the values that tables of its schemes have.
fn offers(finding: &TableFinding<'_>, all: &[TableFinding<'_>]) -> Offers {
    let suitable = |other: &Table| same_scheme(finding.table, other);
    let offers = missing(finding).into_iter().map(|name| {
        let values = offered(finding, all, &name, suitable);
        (name, values)
    });
    offers.collect()
}

/// A table judged at recovered values.
fn recover<'a>(
    paper: &'a Paper,
    finding: &TableFinding<'a>,
    offers: &[(String, Vec<Recovered>)],
) -> Result<RecoveredValues<'a>, Diagnostic> {
    let table = finding.table;
    if finding.cells.iter().flatten().all(|cell| cell.printed.is_none()) {
        // A table without printed numbers determines nothing, and contradicts no value of another
        // table.
        let Some(values) = combinations(offers).into_iter().next() else {
            return Ok(RecoveredValues::Nothing);
        };
        return judge(paper, table, values, Family::Plain)
            .map(|found| RecoveredValues::Values(Box::new(found)));
    }
    recovery::recover(paper, table, offers)
}

/// Whether the other table has schemes, all of which occur in this one.
fn same_scheme(one: &Table, other: &Table) -> bool {
    fn names(table: &Table) -> BTreeSet<&str> {
        table.schemes().flat_map(|located| located.reference.names()).collect()
    }
    let (here, there) = (names(one), names(other));
    !there.is_empty() && there.is_subset(&here)
}
