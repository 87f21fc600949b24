//! Tables that are judged together, since the numbers of one may determine a parameter of another.

use crate::claim::{Paper, Promise, Table};
use crate::diagnostic::Diagnostic;
use crate::exact::Rational;
use crate::finding::{Recovered, RecoveredFrom, TableFinding};
use crate::judge::parallel;
use crate::judge::reading::space::Family;
use crate::judge::recovery::{self, Given, Values, combinations, reproduced};
use crate::judge::table::{judge, judge_promises};
use std::collections::BTreeSet;

/// An error with the place of its table.
type Placed<T> = Result<T, (usize, Diagnostic)>;

/// Groups the tables of a paper, given by their places. Tables about schemes of the same name are
/// judged together, since the numbers of one may determine a parameter of another.
pub(crate) fn related(paper: &Paper) -> Vec<Vec<usize>> {
    let mut groups: Vec<(Vec<usize>, BTreeSet<&str>)> = Vec::new();
    for (place, table) in paper.tables.iter().enumerate() {
        let ring = table.promise.as_ref().and_then(Promise::ring);
        let references = table.schemes().chain(ring);
        let names: BTreeSet<&str> = references.flat_map(|one| one.reference.names()).collect();
        let (same, others) = groups
            .into_iter()
            .partition(|(_, others): &(_, BTreeSet<&str>)| !others.is_disjoint(&names));
        groups = others;
        groups.push(same.into_iter().fold((vec![place], names), |mut group, (places, names)| {
            group.0.extend(places);
            group.1.extend(names);
            group
        }));
    }
    let sorted = |(mut places, _): (Vec<usize>, _)| {
        places.sort_unstable();
        places
    };
    groups.into_iter().map(sorted).collect()
}

/// Judges related tables, and gives the findings with their places. Parameters that the paper does
/// not state are recovered in passes, each of which may use the values that earlier passes have
/// found.
///
/// # Errors
/// The first, with the place of its table.
pub(crate) fn judge_all<'a>(
    paper: &'a Paper,
    places: &[usize],
    after_table: &(dyn Fn() + Sync),
) -> Placed<Vec<(usize, TableFinding<'a>)>> {
    let judged = parallel::map(places, |&place| {
        let table = &paper.tables[place];
        // Of these tables nothing is recovered.
        let known = open(table).next().is_none();
        let family = if known { Family::InTurn } else { Family::Plain };
        judge(paper, table, Values::new(), family).map_err(|error| (place, error))
    });
    let mut findings = judged.into_iter().collect::<Placed<Vec<TableFinding<'a>>>>()?;
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
            match found.map_err(|error| (places[i], error))? {
                Given::Values(found) => (findings[i], more) = (*found, true),
                Given::Fitting(values) => fitting[i] = Some(values),
                Given::Nothing => {}
            }
        }
        if !more {
            break;
        }
    }
    let judged: Vec<_> = findings.into_iter().zip(fitting).zip(places).collect();
    let judged = parallel::map(&judged, |((finding, fitting), place)| {
        let mut finding = finding.clone();
        widen(paper, &mut finding).map_err(|error| (**place, error))?;
        finding.fitting.clone_from(fitting);
        judge_promises(paper, &mut finding).map_err(|error| (**place, error))?;
        after_table();
        Ok((**place, finding))
    });
    judged.into_iter().collect()
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
/// the value that another table of the paper gives for the same name. If most tables have another
/// value than a table's own, and it suits this table as well, the table gets that value. Tables
/// that get a value are judged again.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub(crate) fn borrow<'a>(
    paper: &'a Paper,
    findings: &mut [TableFinding<'a>],
) -> Result<(), Diagnostic> {
    for i in 0..findings.len() {
        agree(paper, findings, i)?;
    }
    // What a table gets here it hands on to no other.
    let borrowed = parallel::map(findings, |finding| {
        let mut values = finding.recovered.clone();
        for name in missing(finding) {
            let others = offered(finding, findings, &name, |_| true);
            values.extend(others.into_iter().next().map(|value| (name, value)));
        }
        if values.len() == finding.recovered.len() {
            return Ok(None);
        }
        let mut found = judge(paper, finding.table, values, Family::Whole)?;
        judge_promises(paper, &mut found)?;
        Ok(Some(found))
    });
    for (finding, found) in findings.iter_mut().zip(borrowed) {
        if let Some(found) = found? {
            *finding = found;
        }
    }
    Ok(())
}

/// How many cells a table may lose when it gets a value that other tables have. One such cell may
/// be a slip.
const MAX_LOST: usize = 1;

/// Replaces a table's own value by the value that most tables were solved for, where this gives as
/// many cells, or one less.
fn agree<'a>(
    paper: &'a Paper,
    findings: &mut [TableFinding<'a>],
    i: usize,
) -> Result<(), Diagnostic> {
    for (name, own) in findings[i].recovered.clone() {
        let has = |value: &Rational| {
            let same = |finding: &&TableFinding<'_>| {
                let known = finding.recovered.get(&name);
                known.is_some_and(|known| known.is_own() && known.value == *value)
            };
            findings.iter().filter(same).count()
        };
        let offers = offered(&findings[i], findings, &name, |_| true);
        let most = offers.into_iter().max_by_key(|offer| has(&offer.value));
        let Some(most) = most.filter(|most| own.is_own() && has(&most.value) > has(&own.value))
        else {
            continue;
        };
        // The value is kept if another table has taken it over from this one.
        let id = &findings[i].table.id;
        let lends = |other: &TableFinding<'_>| {
            let from = other.recovered.get(&name).map(|recovered| &recovered.from);
            matches!(from, Some(RecoveredFrom::Table { id: of, .. }) if of == id)
        };
        if findings.iter().any(lends) {
            continue;
        }
        let mut values = findings[i].recovered.clone();
        values.insert(name, most);
        let mut found = judge(paper, findings[i].table, values, Family::Whole)?;
        let count = reproduced(&found);
        if count > 0 && count + MAX_LOST >= reproduced(&findings[i]) {
            judge_promises(paper, &mut found)?;
            findings[i] = found;
        }
    }
    Ok(())
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
) -> Result<Given<'a>, Diagnostic> {
    let table = finding.table;
    if finding.cells.iter().flatten().all(|cell| cell.printed.is_none()) {
        // A table without printed numbers determines nothing, and contradicts no value of another
        // table.
        let Some(values) = combinations(offers).into_iter().next() else {
            return Ok(Given::Nothing);
        };
        return judge(paper, table, values, Family::Plain)
            .map(|found| Given::Values(Box::new(found)));
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
