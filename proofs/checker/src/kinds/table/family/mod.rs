//! The rule `family`: no reading of a table explains more cells than the given one, and readings
//! of unrelated values would hardly explain as many.

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
use crate::numbers::{Q, Value, count, int};
use crate::text::{At, Block, Checked, Reason, Stop, Toml, agree, compare, require};
use copied::copied;
use lines::{MAX_LINES, SHIFTS, lines};
use listed::{Listed, same};
use luck::{BothEvidence, Evidence};
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

/// Other values of a parameter. What a cell tells of its value v shows where it is not given at one of them.
fn probes(v: &Q) -> [Q; 8] {
    let ten = int(10);
    let near = [v + int(1), v - int(1), v + ten.recip(), v + &ten];
    let [a, b, c, d] = near;
    [a, b, c, d, v * int(2), v / int(2), v * &ten, v / ten]
}

/// A family all of whose members have been checked.
struct Family<'f> {
    table: &'f Table<'f>,
    cells: Cells,
    /// Whether the parameters of the cells are all stated.
    plain: bool,
    /// The most cells that a member without a copied quantity explains, at any scale.
    best: usize,
    /// The most cells that a member with a copied quantity explains, if these members are listed.
    second: Option<usize>,
    /// The numbers of readings without and with a copied quantity.
    sizes: [i64; 2],
}

impl Family<'_> {
    /// The evidence of some of the cells. At recovered values, the printed text is a reading like the others, and no cells
    /// depend on each other by it.
    fn evidence(&self, cells: &Cells) -> Result<BothEvidence, Stop> {
        let printed = self.plain.then(|| values(self.table, cells, &self.table.as_printed));
        BothEvidence::new(self.table, cells, printed.transpose()?.as_deref())
    }

    /// Compares the readings that are given with the family, and checks that they are no luck. `by_choices` says whether a
    /// first member that brings no constant explains as many cells as any.
    fn compare(&self, reads: &Reads, whole: Option<&Read>, by_choices: bool) -> Checked<()> {
        let Family { table, cells, plain, best, .. } = self;
        let explained_by =
            |read: &Read| explained(cells, &values(table, cells, read)?, read.decimals());
        let printed = explained_by(&table.as_printed)?;
        let mut left: BTreeSet<Place> = cells.iter().map(|(place, _)| *place).collect();
        left.retain(|place| !printed.contains(place));
        // The cells that the printed text gives are no evidence for another reading. At recovered
        // values the printed text is a reading like the others.
        let given = if *plain { printed.len() } else { 0 };
        let counts = |at: &Place| !plain || left.contains(at);
        let others: Cells = cells.iter().filter(|(at, _)| counts(at)).cloned().collect();
        let sizes = self.readings(&self.cells)?;
        let others = self.evidence(&others)?;
        let lucky = |m: usize, part: usize, constants: bool| {
            let (m, others) = (m.saturating_sub(given), others.of(constants));
            Ok::<bool, Stop>(!others.are_enough(m) || others.is_luck(table, m, &sizes[part])?)
        };
        // No member of this part explains more than `than` cells, or that would be luck.
        let no_better = |most: usize, part: usize, than: usize| {
            let constants = part == 1 || !by_choices;
            Ok::<bool, Stop>(most <= than || lucky(most, part, constants)?)
        };
        let second = self.second.unwrap_or(0);
        if let Some(read) = whole {
            let found = explained_by(read)?;
            let part = usize::from(read.copied().is_some());
            let most = if part == 1 { second } else { *best };
            require(found.len() == most, Reason::NotBest(most, found.len()))?;
            require(most > given, Reason::NotBest(most, given))?;
            require(!lucky(most, part, read.brings_constants())?, Reason::Luck)?;
            if part == 1 {
                require(no_better(*best, 0, most - 1)?, Reason::NotBest(most, *best))?;
            } else {
                require(no_better(second, 1, most)?, Reason::NotLuck)?;
            }
            self.determined(read, &found, part)?;
            left.retain(|place| !found.contains(place));
        } else if *plain {
            let none = no_better(*best, 0, given)? && no_better(second, 1, given)?;
            require(none, Reason::NotLuck)?;
        } else if let Some(name) = table.own().next() {
            return Err(Reason::Undetermined(name.clone()).into());
        }
        // Rows and columns with readings explain some of the cells that are left.
        for part in reads.all(*plain).filter(|part| !part.is_whole()) {
            let (cells, found) = self.explained_in_line(part, &left)?;
            let size = &sizes[usize::from(part.read.copied().is_some())];
            let evidence = self.evidence(&cells)?;
            let evidence = evidence.of(part.read.brings_constants());
            require(!lines::is_luck(table, evidence, found.len(), size)?, Reason::Luck)?;
            left.retain(|place| !found.contains(place));
        }
        Ok(())
    }

    /// Of the cells that are left, those of a row or column, and which of them its reading explains.
    fn explained_in_line(
        &self,
        part: &PartRead,
        left: &BTreeSet<Place>,
    ) -> Checked<(Cells, BTreeSet<Place>)> {
        let inside = |at: &Place| left.contains(at) && part.holds(self.table, *at);
        let cells: Cells = self.cells.iter().filter(|(at, _)| inside(at)).cloned().collect();
        let values = cells.iter().map(|(place, _)| part.value(self.table, *place));
        let values = values.collect::<Result<Vec<_>, Stop>>()?;
        let found = explained(&cells, &values, part.read.decimals())?;
        Ok((cells, found))
    }

    /// The rows and columns with refuted cells, which may have no other readings than those that are given.
    fn lines(
        &self,
        reads: &Reads,
        whole: Option<&Read>,
        refuted: &[Place],
    ) -> Checked<Vec<lines::Line>> {
        let parts: Vec<&PartRead> = reads.all(self.plain).filter(|part| !part.is_whole()).collect();
        if refuted.is_empty() || parts.len() >= MAX_LINES {
            return Ok(Vec::new());
        }
        let mut left: BTreeSet<Place> = self.cells.iter().map(|(place, _)| *place).collect();
        for read in whole.into_iter().chain([&self.table.as_printed]) {
            let found =
                explained(&self.cells, &values(self.table, &self.cells, read)?, read.decimals())?;
            left.retain(|place| !found.contains(place));
        }
        for part in parts {
            let (_, found) = self.explained_in_line(part, &left)?;
            left.retain(|place| !found.contains(place));
        }
        let left: Cells = self.cells.iter().filter(|(at, _)| left.contains(at)).cloned().collect();
        let sizes = self.readings(&self.cells)?;
        Ok(lines(self.table, &left, refuted, &sizes, |cells| self.evidence(cells))?)
    }

    /// Checks that the cells which tell a parameter's value are no luck by themselves, for each
    /// parameter that the table's own numbers give. `found` are the cells that the reading gives.
    fn determined(&self, read: &Read, found: &BTreeSet<Place>, part: usize) -> Checked<()> {
        let table = self.table;
        for name in table.own().filter(|_| !self.plain) {
            let undetermined = || Reason::Undetermined(name.clone());
            let value = table.assumed[name].rational().ok_or_else(undetermined)?;
            let needs = |place: &Place| table.needed(*place).0.contains(name);
            let cells: Cells =
                self.cells.iter().filter(|(place, _)| needs(place)).cloned().collect();
            let (mut rest, mut tried): (Cells, Cells) =
                cells.iter().cloned().partition(|(place, _)| found.contains(place));
            let missed = tried.len();
            for probe in probes(&value) {
                let mut other = members::read(table, &read.differences)?;
                other.reading.words.clone_from(&read.reading.words);
                other.parameters.insert(name.clone(), probe.into());
                let values = values(table, &rest, &other)?;
                let given = explained(&rest, &values, read.decimals())?;
                let (telling, others): (Vec<_>, Vec<_>) = rest
                    .into_iter()
                    .zip(&values)
                    .partition(|((place, _), value)| value.is_some() && !given.contains(place));
                tried.extend(telling.into_iter().map(|(cell, _)| cell));
                rest = others.into_iter().map(|(cell, _)| cell).collect();
            }
            let size = &self.readings(&cells)?[part];
            let evidence = Evidence::new(table, &tried, None)?;
            let lucky = evidence.is_luck(table, tried.len() - missed, size)?;
            require(!lucky, undetermined())?;
        }
        Ok(())
    }

    /// The numbers of readings of the first part and of both parts, times the numbers of candidates
    /// for the recovered parameters of these cells, twice the number of tables, since each part of
    /// each table has its share of the luck.
    fn readings(&self, cells: &Cells) -> Checked<[Q; 2]> {
        let [first, second] = self.sizes;
        // The tables of a paper share the luck that is allowed.
        let printed = |table: &&Toml| table.text("cells") != Some("lost");
        let tables = self.table.paper.file.list("table").iter().filter(printed).count();
        let parts = int(2) * count(tables);
        let mut sizes = [int(first) * &parts, int(first + second) * &parts];
        if !self.plain {
            let needed = cells.iter().map(|(place, _)| self.table.needed(*place).0);
            for name in needed.reduce(|one, other| &one | &other).unwrap_or_default() {
                let count = self.table.recovered.get(&name);
                let (count, _) = count.ok_or_else(|| Reason::Recovered(name.clone()))?;
                for size in &mut sizes {
                    *size *= count;
                }
            }
        }
        Ok(sizes)
    }
}
