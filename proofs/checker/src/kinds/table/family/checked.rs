//! What a family shows once all of its members have been checked.

use super::lines::{self, MAX_LINES, lines};
use super::luck::{BothEvidence, Evidence};
use super::members::{self, explained, values};
use crate::kinds::table::claim::{Cells, Place, Read, Table};
use crate::kinds::table::reading::{PartRead, Reads};
use crate::numbers::{Q, count, int};
use crate::text::{Checked, Reason, Stop, Toml, require};
use std::collections::BTreeSet;

/// Other values of a parameter. What a cell tells of its value v shows where it is not given at one of them.
fn probes(v: &Q) -> [Q; 8] {
    let ten = int(10);
    let near = [v + int(1), v - int(1), v + ten.recip(), v + &ten];
    let [a, b, c, d] = near;
    [a, b, c, d, v * int(2), v / int(2), v * &ten, v / ten]
}

/// A family all of whose members have been checked.
pub struct Family<'f> {
    /// The table.
    pub table: &'f Table<'f>,
    /// Its cells that count.
    pub cells: Cells,
    /// Whether the parameters of the cells are all stated.
    pub plain: bool,
    /// The most cells that a member without a copied quantity explains, at any scale.
    pub best: usize,
    /// The most cells that a member with a copied quantity explains, if these members are listed.
    pub second: Option<usize>,
    /// The numbers of readings without and with a copied quantity.
    pub sizes: [i64; 2],
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
    pub fn compare(&self, reads: &Reads, whole: Option<&Read>, by_choices: bool) -> Checked<()> {
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
    pub fn lines(
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
