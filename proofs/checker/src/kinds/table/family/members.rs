//! The members of the family of a table, and the cells that they explain.

use crate::claims::Headers;
use crate::formulas::{CHOICES, names};
use crate::kinds::table::claim::{Cells, Place, Read, Table};
use crate::kinds::table::reading::{MAX_DIFFERENCES, choose, define};
use crate::numbers::{Value, gives};
use crate::text::{Checked, Stop};
use std::collections::{BTreeMap, BTreeSet};

/// The most members of a family.
const MAX_MEMBERS: usize = 4_096;

/// The most values of cells under all members of a family.
const MAX_VALUES: usize = 100_000;

/// The most members of the family of a table.
pub fn most_members(table: &Table<'_>) -> usize {
    let (rows, columns) = table.size();
    MAX_MEMBERS.min(MAX_VALUES / (rows * columns).max(1)).max(1)
}

/// The members: each is a set of differences from the printed text, `NAME=WAY`, `NAME#NUMBER`, or
/// the name of a copied quantity.
pub type Members = BTreeSet<BTreeSet<String>>;

/// Every member of the family of these cells without a copied quantity.
pub fn members(table: &Table<'_>, cells: &Cells) -> Result<Members, Stop> {
    let printed = Read::default();
    values(table, cells, &printed)?;
    let consulted = printed.reading.consulted.borrow();
    let mut axes = table.axes.iter().flatten().filter_map(Headers::axis);
    let tolerance = axes.any(|axis| table.tolerance == Some(axis.name));
    let mut changes: Vec<Vec<String>> = Vec::new();
    for choice in &CHOICES {
        let printed = match (consulted.get(choice.name), choice.name) {
            (Some(word), _) => word.as_str(),
            (None, "tolerance") if tolerance => "exact",
            _ => continue,
        };
        let known = |way: &&&str| **way != "best" || table.leaves_offset_out();
        let ways = choice.ways.iter().filter(|way| **way != printed).filter(known);
        changes.push(ways.map(|way| format!("{}={way}", choice.name)).collect());
    }
    let mut others: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    let used = names(&table.value, &table.paper.definitions);
    for name in table.paper.file.list("alternative").iter().filter_map(|other| other.text("of")) {
        if used.contains(name) {
            let known = others.entry(name).or_default();
            known.push(format!("{name}#{}", known.len() + 1));
        }
    }
    changes.extend(others.into_values());
    let most = most_differences(&changes, most_members(table));
    let mut members = BTreeSet::from([BTreeSet::new()]);
    for ways in changes {
        let shorter = members.iter().filter(|member: &&BTreeSet<String>| member.len() < most);
        let longer = shorter.flat_map(|member| {
            ways.iter().map(|way| member.iter().chain([way]).cloned().collect::<BTreeSet<_>>())
        });
        members = longer.chain(members.iter().cloned()).collect();
    }
    Ok(members)
}

/// The most differences with which there are no more members than `most`.
fn most_differences(changes: &[Vec<String>], most: usize) -> usize {
    // How many sets have so many differences.
    let mut sizes = vec![1_usize];
    for ways in changes {
        let longer: Vec<usize> = sizes.iter().map(|size| size.saturating_mul(ways.len())).collect();
        sizes.resize(MAX_DIFFERENCES.min(sizes.len()) + 1, 0);
        for (size, more) in sizes.iter_mut().skip(1).zip(longer) {
            *size = size.saturating_add(more);
        }
    }
    let all = |differences: &usize| {
        sizes.iter().take(differences + 1).fold(0, |all: usize, size| all.saturating_add(*size))
    };
    (0..=MAX_DIFFERENCES).take_while(|differences| all(differences) <= most).last().unwrap_or(0)
}

/// The reading of a member.
pub fn read(table: &Table<'_>, member: &BTreeSet<String>) -> Checked<Read> {
    let mut read = Read::default();
    for difference in member {
        if difference.contains('@') {
            read.differences.insert(difference.clone());
        } else if let Some((name, way)) = difference.split_once('=') {
            choose(&mut read, name, way)?;
        } else {
            let (name, number) = difference.split_once('#').unwrap_or_default();
            define(table, &mut read, name, number)?;
        }
    }
    Ok(read)
}

/// The values of the cells under a reading. Some cells may have none.
pub fn values(table: &Table<'_>, cells: &Cells, read: &Read) -> Result<Vec<Option<Value>>, Stop> {
    cells.iter().map(|(place, _)| table.read(*place, read)).collect()
}

/// The cells that these values explain.
pub fn explained(
    cells: &Cells,
    values: &[Option<Value>],
    decimals: &str,
) -> Result<BTreeSet<Place>, Stop> {
    let mut found = BTreeSet::new();
    for ((place, decimal), value) in cells.iter().zip(values) {
        if let Some(value) = value
            && gives(decimal, value, decimals)?
        {
            found.insert(*place);
        }
    }
    Ok(found)
}
