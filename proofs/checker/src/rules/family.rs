//! Rule `family`: no reading of a table explains more cells than the one that is given, and
//! luck would hardly find one as good.

use super::reading::{MAX_DIFFERENCES, Reads, choose, define};
use crate::certificate::Block;
use crate::decimal::{Decimal, Q, int};
use crate::formula::names;
use crate::reading::CHOICES;
use crate::reject::{Checked, Reason, Stop, require};
use crate::rounding::{gives, interval};
use crate::table::{Place, Read, Table};
use crate::value::Value;
use num_traits::{One, Pow, Signed, Zero};
use std::collections::{BTreeMap, BTreeSet};

/// The most members of a family.
const MAX_MEMBERS: usize = 4_096;

/// The greatest numerator and denominator of a scale that someone would choose.
const MAX_SCALE: i64 = 100;

/// The fewest cells that a row or column with a reading of its own explains.
const LEAST_CELLS: usize = 2;

/// The places from which the values of a row or column are taken: its own, and those around.
const SHIFTS: i64 = 5;

/// The printed cells, with their places.
type Cells = Vec<(Place, Decimal)>;

/// Checks the lines `family`, `scale`, `values` and `member` of a table that is read
/// otherwise or has cells that are refuted.
pub fn check(
    table: &Table<'_>,
    reads: &Reads,
    refuted: &[Place],
    block: &mut Block<'_>,
) -> Checked<()> {
    let cells = table.places().filter_map(|place| Some((place, table.printed(place)?.1)));
    let cells: Cells = cells.collect();
    let plain = cells.iter().all(|(place, _)| table.needed(*place).0.is_empty());
    if refuted.is_empty() && (!plain || reads.all().count() == 0) {
        return Ok(());
    }
    let best = block.after("family").map_err(|_| Reason::NoFamily)?;
    let line = block.at;
    require(plain, Reason::Assumed)?;
    let best: usize = best.parse().map_err(|_| Reason::Malformed("a number of cells"))?;
    let scale = scale(table, &cells)?;
    let base = scale.as_ref().and_then(|name| table.given.get(name));
    if let Some(name) = &scale {
        require(block.after("scale")? == name, Reason::Scale)?;
    }
    let mut listed = Listed::new(table, refuted, block)?;
    let mut members = members(table)?;
    let mut family = Family { table, cells, best, scaled: base.is_some(), most: 0, size: 0 };
    let cells = &family.cells;
    while let Some(said) = block.maybe("member") {
        let (differences, said) = said.split_once(':').ok_or(Reason::Malformed("`:`"))?;
        let (counts, numbers) = said.split_once(':').unwrap_or((said, ""));
        let member: BTreeSet<String> = differences.split_whitespace().map(str::to_owned).collect();
        require(members.remove(&member), Reason::Member)?;
        let read = read(table, &member)?;
        let one = table.tolerance.is_some() || member.len() == MAX_DIFFERENCES;
        let roundings = if one { &["nearest"][..] } else { &["nearest", "cut", "away"] };
        let values = values(table, cells, &read)?;
        let mut found = Vec::new();
        for decimals in roundings {
            let count = explained(cells, &values, decimals)?.len();
            let scaled = base.map(|base| at_best_scale(cells, &values, decimals, base, best));
            require(count.max(scaled.transpose()?.unwrap_or(0)) <= best, Reason::NotBest)?;
            found.push(count.to_string());
            family.most = family.most.max(count);
            family.size += 1 + i64::from(base.is_some());
        }
        require(counts.split_whitespace().eq(found.iter().map(String::as_str)), Reason::Explains)?;
        listed.compare(numbers, cells, &values)?;
    }
    let complete = require(members.is_empty() && listed.all_met(), Reason::Member);
    complete.and_then(|()| family.compare(reads)).map_err(|rejection| rejection.at(line))
}

/// What is known of a family when all of its members have been looked at.
struct Family<'f> {
    table: &'f Table<'f>,
    cells: Cells,
    /// No member explains more cells, at any scale.
    best: usize,
    /// Whether there is a scale.
    scaled: bool,
    /// The most cells that a member explains at the stated scale.
    most: usize,
    /// How many readings there are.
    size: i64,
}

impl Family<'_> {
    /// Compares the readings that are given with the family, and with luck.
    fn compare(&self, reads: &Reads) -> Checked<()> {
        let Family { table, cells, best, .. } = self;
        let explained_by =
            |read: &Read| explained(cells, &values(table, cells, read)?, read.decimals());
        let printed = explained_by(&table.as_printed)?;
        let mut left: BTreeSet<Place> = cells.iter().map(|(place, _)| *place).collect();
        left.retain(|place| !printed.contains(place));
        let lucky = |m| chance(table, cells, m, self.size);
        if let Some(read) = reads.whole() {
            let found = explained_by(read)?;
            require(found.len() == *best && *best > printed.len(), Reason::NotBest)?;
            require(!lucky(best.saturating_sub(read.parameters.len())), Reason::Luck)?;
            left.retain(|place| !found.contains(place));
        } else {
            require(self.most <= printed.len() || lucky(self.most), Reason::NotLuck)?;
            let m = best.saturating_sub(self.scaled.into());
            require(*best <= printed.len() || lucky(m), Reason::NotLuck)?;
        }
        // What rows and columns explain of what is left.
        let (rows, columns) = table.size();
        let lines = i64::try_from(rows + columns).unwrap_or(i64::MAX);
        for part in reads.all().filter(|part| !part.is_whole()) {
            let cells = cells.iter().filter(|(at, _)| left.contains(at) && part.holds(*at));
            let cells: Cells = cells.cloned().collect();
            let values = cells.iter().map(|(place, _)| part.value(table, *place));
            let values = values.collect::<Result<Vec<_>, Stop>>()?;
            let found = explained(&cells, &values, part.read.decimals())?;
            let m = found.len().saturating_sub(part.read.parameters.len());
            let lucky = chance(table, &cells, m, self.size * SHIFTS * lines);
            require(found.len() >= LEAST_CELLS && !lucky, Reason::Luck)?;
            left.retain(|place| !found.contains(place));
        }
        Ok(())
    }
}

/// A value, and whether a member has it.
type Met = (Option<Value>, bool);

/// The values that members give in the refuted cells.
struct Listed {
    /// Of each cell: the values.
    cells: Vec<(Place, Vec<Met>)>,
}

impl Listed {
    /// Reads the lines `values ROW COLUMN VALUE…`, one for each refuted cell.
    fn new(table: &Table<'_>, refuted: &[Place], block: &mut Block<'_>) -> Checked<Listed> {
        let mut cells = Vec::new();
        for place in refuted {
            let said = block.after("values")?;
            let said = said.strip_prefix(&format!("{} {} ", place.0 + 1, place.1 + 1));
            let mut values: Vec<Met> = Vec::new();
            for value in said.ok_or(Reason::Cell)?.split_whitespace() {
                let value = Some(value).filter(|value| *value != "undefined");
                let value = value.map(|value| table.paper.number(value)).transpose()?;
                for (known, _) in &values {
                    require(!same(known.as_ref(), value.as_ref())?, Reason::Member)?;
                }
                values.push((value, false));
            }
            cells.push((*place, values));
        }
        Ok(Listed { cells })
    }

    /// Compares the values of a member with those of these numbers.
    fn compare(&mut self, said: &str, cells: &Cells, values: &[Option<Value>]) -> Checked<()> {
        let mut numbers = said.split_whitespace();
        for (place, listed) in &mut self.cells {
            let number = numbers.next().and_then(|number| number.parse().ok());
            let number: usize = number.ok_or(Reason::Malformed("the number of a value"))?;
            let value = cells.iter().zip(values).find(|((at, _), _)| at == place);
            let known = number.checked_sub(1).and_then(|i| listed.get_mut(i));
            let (known, met) = known.ok_or(Reason::Value)?;
            let value = value.and_then(|(_, value)| value.as_ref());
            require(same(known.as_ref(), value)?, Reason::Value)?;
            *met = true;
        }
        require(numbers.next().is_none(), Reason::Malformed("the end of the line"))
    }

    fn all_met(&self) -> bool {
        self.cells.iter().flat_map(|(_, values)| values).all(|(_, met)| *met)
    }
}

/// Whether two values are equal, or both undefined.
fn same(one: Option<&Value>, other: Option<&Value>) -> Result<bool, Stop> {
    one.zip(other).map_or(Ok(one.is_none() && other.is_none()), |(one, other)| one.equals(other))
}

/// Every member: its differences from the printed text, `NAME=WAY` or `NAME#NUMBER`.
fn members(table: &Table<'_>) -> Result<BTreeSet<BTreeSet<String>>, Stop> {
    let consulted = table.as_printed.reading.consulted.borrow();
    let tolerance = table.axes.iter().flatten().any(|axis| table.tolerance == Some(axis.name));
    let mut changes: Vec<Vec<String>> = Vec::new();
    for choice in &CHOICES {
        let printed = match (consulted.get(choice.name), choice.name) {
            (Some(word), _) => word.as_str(),
            (None, "tolerance") if tolerance => "exact",
            _ => continue,
        };
        let ways = choice.ways.iter().filter(|way| **way != printed);
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
    let mut members = BTreeSet::from([BTreeSet::new()]);
    for ways in changes {
        let shorter = members.iter().filter(|member| member.len() < MAX_DIFFERENCES);
        let longer = shorter.flat_map(|member| {
            ways.iter().map(|way| member.iter().chain([way]).cloned().collect::<BTreeSet<_>>())
        });
        members = longer.chain(members.iter().cloned()).collect();
        if members.len() > MAX_MEMBERS {
            return Err(Stop::Capped("the members of a family"));
        }
    }
    Ok(members)
}

/// The reading of a member.
fn read(table: &Table<'_>, member: &BTreeSet<String>) -> Checked<Read> {
    let mut read = Read::default();
    for difference in member {
        if let Some((name, way)) = difference.split_once('=') {
            choose(&mut read, name, way)?;
        } else {
            let (name, number) = difference.split_once('#').unwrap_or_default();
            define(table, &mut read, name, number)?;
        }
    }
    Ok(read)
}

/// The values of the cells under a reading, where they have one.
fn values(table: &Table<'_>, cells: &Cells, read: &Read) -> Result<Vec<Option<Value>>, Stop> {
    cells.iter().map(|(place, _)| table.read(*place, read)).collect()
}

/// The cells that these values give.
fn explained(cells: &Cells, values: &[Option<Value>], decimals: &str) -> Result<Vec<Place>, Stop> {
    let mut found = Vec::new();
    for ((place, decimal), value) in cells.iter().zip(values) {
        if let Some(value) = value
            && gives(decimal, value, decimals)?
        {
            found.push(*place);
        }
    }
    Ok(found)
}

/// The first stated parameter, by name, that is positive and that every value is proportional to.
fn scale(table: &Table<'_>, cells: &Cells) -> Result<Option<String>, Stop> {
    if table.tolerance.is_some() {
        return Ok(None);
    }
    let once = values(table, cells, &table.as_printed)?;
    for (name, base) in &table.given {
        if base.sign(None)? <= 0 {
            continue;
        }
        let mut read = Read::default();
        read.parameters.insert(name.clone(), base.plus(1, base)?);
        let twice = values(table, cells, &read)?;
        let mut pairs = once.iter().zip(&twice);
        if pairs.all(|pair| match pair {
            (Some(once), Some(twice)) => twice.plus(-2, once).is_ok_and(|rest| rest.is_zero()),
            (once, twice) => once.is_none() && twice.is_none(),
        }) {
            return Ok(Some(name.clone()));
        }
    }
    Ok(None)
}

/// How many cells the values give at most when they are multiplied by (p/q)/base, p, q = 1, …, 100;
/// exact above `enough` only.
fn at_best_scale(
    cells: &Cells,
    values: &[Option<Value>],
    decimals: &str,
    base: &Value,
    enough: usize,
) -> Result<usize, Stop> {
    let given = |s: &Value| -> Result<usize, Stop> {
        let factor = s.over(base)?;
        let scaled = values.iter().map(|v| v.as_ref().map(|v| v.times(&factor)).transpose());
        Ok(explained(cells, &scaled.collect::<Result<Vec<_>, Stop>>()?, decimals)?.len())
    };
    // The p/q that may give a cell, by its |value| at 1. A value that is 0 is so at all of them.
    let (mut ranges, mut zeros) = (Vec::new(), 0);
    for ((_, decimal), value) in cells.iter().zip(values) {
        let Some(value) = value else { continue };
        if value.is_zero() {
            zeros += 1;
            continue;
        }
        let unit = value.over(base)?.abs(None)?;
        let (low, high) = interval(decimal, decimals);
        ranges.push((Value::from(low).over(&unit)?, Value::from(high).over(&unit)?));
    }
    // No fewer than are given there.
    let covering = |s: &Value| -> Result<usize, Stop> {
        let mut count = zeros;
        for (low, high) in &ranges {
            count += usize::from(low.compare(s)?.is_le() && s.compare(high)?.is_le());
        }
        Ok(count)
    };
    let mut best = 0;
    if zeros > enough {
        best = given(&Value::int(1))?;
    }
    for (low, high) in &ranges {
        // The ranges that meet at some value all hold the greatest of their lower ends.
        if covering(low)? <= enough {
            continue;
        }
        for q in 1..=MAX_SCALE {
            let mut p = low.times(&Value::int(q))?.floor()?;
            loop {
                let s = Value::from(Q::new(p.clone(), q.into()));
                if p > MAX_SCALE.into() || s.compare(high)?.is_gt() {
                    break;
                }
                best = best.max(if p.is_positive() { given(&s)? } else { 0 });
                p += 1;
            }
        }
    }
    Ok(best)
}

/// Whether one of so many readings of unrelated values is likely enough to become m of these
/// printed cells: readings·e_m of the likelihoods that a value becomes a cell, against 1/1000.
fn chance(table: &Table<'_>, cells: &Cells, m: usize, readings: i64) -> bool {
    let mut symmetric = vec![Q::zero(); m + 1];
    symmetric[0] = Q::one();
    for (_, decimal) in cells {
        let digits = decimal.digits.abs().to_string();
        let digits = i32::try_from(digits.trim_end_matches('0').len().max(1)).unwrap_or(i32::MAX);
        let depth = table.tolerance.is_some();
        let likely = if depth { int(4).recip() } else { int(10).pow(1 - digits) / int(9) };
        for k in (1..=m).rev() {
            let more = &symmetric[k - 1] * &likely;
            symmetric[k] += more;
        }
    }
    &symmetric[m] * int(readings) > int(1_000).recip()
}
