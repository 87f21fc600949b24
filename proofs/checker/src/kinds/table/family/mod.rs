//! The rule `family`: no reading of a table explains more cells than the given one, and readings
//! of unrelated values would hardly explain as many.

mod checked;
pub mod copied;
pub mod degree;
pub mod dependence;
pub mod lines;
pub mod listed;
pub mod luck;
pub mod members;
pub mod scale;

use crate::kinds::table::cell::Standing;
use crate::kinds::table::claim::{Cells, Place, Read, Table};
use crate::kinds::table::reading::{MAX_DIFFERENCES, PartRead, Reads};
use crate::numbers::Value;
use crate::text::{At, Block, Checked, Reason, agree, compare, require};
use checked::Family;
use copied::copied;
use lines::SHIFTS;
use listed::{Listed, same};
use members::{Members, explained, members, read, values};
use scale::{SCALES, at_best_scale, is_scale, is_simple, scale};
use std::collections::{BTreeMap, BTreeSet};

/// Checks the lines `family`, `scale`, `values` and `member` of a table that has a reading, or
/// refuted or reproduced cells.
pub fn check(
    table: &Table<'_>,
    reads: &Reads,
    kinds: &[(Place, Standing)],
    block: &mut Block<'_>,
) -> Checked<()> {
    assumed(table, reads)?;
    let of = |wanted: Standing| kinds.iter().filter(move |(_, kind)| *kind == wanted);
    let refuted: Vec<Place> = of(Standing::Refuted).map(|(place, _)| *place).collect();
    if !refuted.is_empty() || reads.all(true).count() > 0 {
        let whole = reads.all(true).find(|part| part.is_whole()).map(|part| &part.read);
        family(table, reads, &refuted, (true, whole), block)?;
    }
    let as_printed = of(Standing::AsPrinted).count() > 0;
    if as_printed || of(Standing::Reproduced).count() > 0 {
        let whole = reads.all(false).find(|part| part.is_whole()).map(|part| &part.read);
        let whole = whole.or(as_printed.then_some(&table.as_printed));
        family(table, reads, &[], (false, whole), block)?;
    }
    Ok(())
}

/// Checks the family of the cells whose parameters are stated, or of the other cells. `whole` is
/// the reading of all these cells.
fn family(
    table: &Table<'_>,
    reads: &Reads,
    refuted: &[Place],
    (plain, whole): (bool, Option<&Read>),
    block: &mut Block<'_>,
) -> Checked<()> {
    let cells = table.cells(plain);
    let said = block.after("family").map_err(|_| Reason::NoFamily)?;
    let line = block.at;
    let best: Option<Vec<usize>> =
        said.split_whitespace().map(|count| count.parse().ok()).collect();
    let best = best.filter(|best| matches!(best.len(), 1 | 2));
    let best = best.filter(|best| best.iter().all(|count| *count <= cells.len()));
    let best = best.ok_or(Reason::Malformed("one or two numbers of cells"))?;
    let scale = if plain { scale(table, &cells)? } else { None };
    if let Some((name, _)) = scale {
        agree(block.after("scale")?, name, Reason::Scale)?;
    }
    let mut listed = Listed::new(table, refuted, block)?;
    let mut members = members(table, &cells)?;
    let copied = copied(table, &cells, &members)?;
    let all: Members = members.union(&copied).cloned().collect();
    for part in reads.all(plain) {
        belongs(table, &cells, &part.read, &all, scale)?;
    }
    // The second part of the family is needed if cells are refuted, or if a reading that is given
    // is in it.
    let needed = !refuted.is_empty() || reads.all(plain).any(|part| part.read.copied().is_some());
    let second = best.get(1).copied();
    let present = second.is_some() == (needed && !copied.is_empty());
    require(present || second.is_some() && !copied.is_empty(), Reason::NoFamily)?;
    if second.is_some() {
        members = all;
    }
    // Each scale gives another reading.
    let scales = if scale.is_some() { SCALES } else { 0 };
    let mut sizes = [0; 2];
    for member in &members {
        let elsewhere = member.iter().any(|difference| difference.contains('@'));
        let readings = if elsewhere { 1 } else { 1 + scales };
        sizes[usize::from(elsewhere)] +=
            roundings(table, member).iter().map(|_| readings).sum::<i64>();
    }
    let family = Family { table, cells, plain, best: best[0], second, sizes };
    let (cells, mut by_choices) = (&family.cells, false);
    let lines = family.lines(reads, whole, refuted)?;
    while let Some(said) = block.maybe("member") {
        let (differences, said) = said.split_once(':').ok_or(Reason::Malformed("`:`"))?;
        let (counts, numbers) = said.split_once(':').unwrap_or((said, ""));
        let member: BTreeSet<String> = differences.split_whitespace().map(str::to_owned).collect();
        require(members.remove(&member), Reason::Member)?;
        let read = read(table, &member)?;
        let roundings = roundings(table, &member);
        let values = values(table, cells, &read)?;
        let elsewhere = read.copied().is_some();
        let kind = usize::from(elsewhere) + usize::from(read.brings_constants());
        let best = if elsewhere { second.unwrap_or(0) } else { best[0] };
        let mut found = Vec::new();
        for decimals in roundings {
            let count = explained(cells, &values, decimals)?.len();
            require(count <= best, Reason::NotBest(best, count))?;
            if let Some((name, base)) = scale.filter(|_| !elsewhere) {
                let count = at_best_scale(table, cells, &values, decimals, (base, best))?;
                let more = count > best && is_scale(table, cells, name, base, &read)?;
                require(!more, Reason::NotBest(best, count))?;
            }
            by_choices |= count == best && !read.brings_constants();
            found.push(count.to_string());
        }
        let of_cells =
            cells.iter().zip(&values).map(|((place, _), value)| (*place, value.as_ref()));
        let of_cells: BTreeMap<Place, Option<&Value>> = of_cells.collect();
        for (line, shift) in lines.iter().flat_map(|line| SHIFTS.map(|shift| (line, shift))) {
            let values = line.shifted(table, &of_cells, shift);
            for decimals in roundings {
                let mut given = line.is_explained(&values, decimals, kind)?;
                if let Some((name, base)) = scale.filter(|_| !given && !elsewhere) {
                    let most = line.by_luck[1];
                    let count = at_best_scale(table, &line.cells, &values, decimals, (base, most))?;
                    given = count > most && is_scale(table, cells, name, base, &read)?;
                }
                require(!given, Reason::NotLuck)?;
            }
        }
        let same = counts.split_whitespace().eq(found.iter().map(String::as_str));
        compare(same, counts.trim(), &found.join(" "), Reason::Explains)?;
        listed.compare(numbers, cells, &values)?;
    }
    let complete = require(members.is_empty() && listed.all_met(), Reason::Member);
    complete.and_then(|()| family.compare(reads, whole, by_choices)).at(line)
}

/// The roundings of decimals that a member has.
fn roundings(table: &Table<'_>, member: &BTreeSet<String>) -> &'static [&'static str] {
    let one = table.tolerance.is_some() || member.len() == MAX_DIFFERENCES;
    if one { &["nearest"] } else { &["nearest", "cut", "away"] }
}

/// Checks that the readings of cells that need assumptions are members of their family.
fn assumed(table: &Table<'_>, reads: &Reads) -> Checked<()> {
    if reads.all(false).count() == 0 {
        return Ok(());
    }
    let cells = table.cells(false);
    let mut members = members(table, &cells)?;
    members.extend(copied(table, &cells, &members)?);
    for PartRead { read, .. } in reads.all(false) {
        is_member(table, read, &members)?;
        if let Some(name) = read.parameters.keys().next() {
            return Err(Reason::NotInFamily(name.clone()).into());
        }
    }
    Ok(())
}

/// Checks that the choices and definitions of a reading are those of a member, and that depths are not read as cut.
fn is_member(table: &Table<'_>, read: &Read, members: &Members) -> Checked<()> {
    let decimals = read.decimals();
    require(
        table.tolerance.is_none() || decimals == "nearest",
        Reason::NotInFamily(decimals.to_owned()),
    )?;
    let differences = read.differences.iter().cloned().collect::<Vec<String>>().join(" ");
    require(members.contains(&read.differences), Reason::NotInFamily(differences))
}

/// Checks that a reading is in the family: it is a member, or a member at a scale.
fn belongs(
    table: &Table<'_>,
    cells: &Cells,
    read: &Read,
    members: &Members,
    scale: Option<(&str, &Value)>,
) -> Checked<()> {
    let unknown = |name: &str| Reason::NotInFamily(name.to_owned());
    is_member(table, read, members)?;
    for (name, value) in &read.parameters {
        let scale = scale.filter(|(scale, _)| scale == name && is_simple(value));
        let (_, base) = scale.ok_or_else(|| unknown(name))?;
        let member = self::read(table, &read.differences)?;
        require(is_scale(table, cells, name, base, &member)?, unknown(name))?;
        let factor = value.over(base)?;
        let pairs = values(table, cells, &member)?.into_iter().zip(values(table, cells, read)?);
        for (once, scaled) in pairs {
            let once = once.map(|once| once.times(&factor)).transpose()?;
            require(same(once.as_ref(), scaled.as_ref())?, unknown(name))?;
        }
    }
    Ok(())
}
