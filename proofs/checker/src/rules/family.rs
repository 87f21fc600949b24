//! Rule `family`: no reading of a table explains more cells than the one that is given.

use crate::certificate::{Block, Line};
use crate::decimal::{Decimal, Q, int, power_of_ten};
use crate::memo::names;
use crate::reading::CHOICES;
use crate::reject::{Checked, Reason};
use crate::rounding::{gives, interval};
use crate::rules::reading::{MAX_DIFFERENCES, choose, define};
use crate::table::{Read, Table};
use crate::value::{Stop, Value};
use num_traits::{One, Signed, Zero};
use std::collections::{BTreeMap, BTreeSet};

/// The most members of a family.
const MAX_MEMBERS: usize = 4_096;

/// The greatest numerator and denominator of a scale that someone would choose.
const MAX_SCALE: i64 = 100;

/// The printed cells, with their places.
type Cells = Vec<((usize, usize), Decimal)>;

/// Checks the lines `family`, `scale` and `member` of a table with a refuted cell.
pub fn check(table: &Table<'_>, read: Option<&Read>, block: &mut Block<'_>) -> Checked<()> {
    let line = block.peek().unwrap_or(block.head);
    let (line, best) = block.take("family").map_err(|_| line.reject(Reason::NoFamily))?;
    let stopped = |line: Line<'_>, stop| line.reject(Reason::Stopped(stop));
    let (rows, columns) = table.size();
    let places = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
    let cells = places.filter_map(|place| Some((place, table.printed(place.0, place.1)?.1)));
    let cells: Cells = cells.collect();
    if cells.iter().any(|(place, _)| !table.needed(*place).0.is_empty()) {
        return Err(line.reject(Reason::Assumed));
    }
    let best: usize =
        best.parse().map_err(|_| line.reject(Reason::Malformed("a number of cells")))?;
    let scale = scale(table, &cells).map_err(|stop| stopped(line, stop))?;
    if let Some(name) = &scale {
        let (line, said) = block.take("scale")?;
        if said != name {
            return Err(line.reject(Reason::Scale));
        }
    }
    let mut members = members(table).map_err(|stop| stopped(line, stop))?;
    let mut size = 0;
    let mut as_printed = 0;
    while let Some((line, said)) = block.optional("member") {
        let (differences, counts) = said
            .split_once(':')
            .ok_or(line.reject(Reason::Malformed("member DIFFERENCE… : N…")))?;
        let member: BTreeSet<String> = differences.split_whitespace().map(str::to_owned).collect();
        if !members.remove(&member) {
            return Err(line.reject(Reason::Member));
        }
        let mut read = Read::default();
        for difference in &member {
            if let Some((name, way)) = difference.split_once('=') {
                choose(&mut read, line, name, way)?;
            } else {
                let (name, number) = difference.split_once('#').unwrap_or_default();
                define(table, &mut read, line, name, number)?;
            }
        }
        let one = table.tolerance.is_some() || member.len() == MAX_DIFFERENCES;
        let roundings = if one { &["nearest"][..] } else { &["nearest", "cut", "away"] };
        let values = values(table, &cells, &read).map_err(|stop| stopped(line, stop))?;
        let mut found = Vec::new();
        for decimals in roundings {
            let count = explained(&cells, &values, decimals).map_err(|stop| stopped(line, stop))?;
            let base = scale.as_ref().and_then(|name| table.given.get(name));
            let scaled = base.map(|base| at_best_scale(&cells, &values, decimals, base, best));
            let scaled = scaled.transpose().map_err(|stop| stopped(line, stop))?;
            if count.max(scaled.unwrap_or(0)) > best {
                return Err(line.reject(Reason::NotBest));
            }
            found.push(count.to_string());
            size += 1 + i64::from(scale.is_some());
        }
        if member.is_empty() {
            as_printed = found[0].parse().unwrap_or(0);
        }
        if !counts.split_whitespace().eq(found.iter().map(String::as_str)) {
            return Err(line.reject(Reason::Explains));
        }
    }
    if !members.is_empty() {
        return Err(block.peek().unwrap_or(line).reject(Reason::Member));
    }
    let by = read.unwrap_or(&table.as_printed);
    let values = values(table, &cells, by).map_err(|stop| stopped(line, stop))?;
    let count = explained(&cells, &values, by.decimals()).map_err(|stop| stopped(line, stop))?;
    let chance = chance(table, &cells, best.saturating_sub(by.parameters.len())) * int(size);
    let luck = chance > Q::new(1.into(), 1_000.into());
    match read {
        Some(_) if count < best || best <= as_printed => Err(line.reject(Reason::NotBest)),
        Some(_) if luck => Err(line.reject(Reason::Luck)),
        None if best > as_printed && !luck => Err(line.reject(Reason::NotLuck)),
        _ => Ok(()),
    }
}

/// Every member: its differences from the printed text, `NAME=WAY` or `NAME#NUMBER`.
fn members(table: &Table<'_>) -> Result<BTreeSet<BTreeSet<String>>, Stop> {
    let consulted = table.as_printed.reading.consulted.borrow();
    let axes = table.axes.iter().flatten();
    let tolerance = axes.filter(|axis| table.tolerance == Some(axis.name)).count() > 0;
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
        let longer: Vec<BTreeSet<String>> = longer.collect();
        members.extend(longer);
        if members.len() > MAX_MEMBERS {
            return Err(Stop::Capped("the members of a family"));
        }
    }
    Ok(members)
}

/// The values of the cells under a reading, where they have one.
fn values(table: &Table<'_>, cells: &Cells, read: &Read) -> Result<Vec<Option<Value>>, Stop> {
    let value = |(place, _): &((usize, usize), Decimal)| match table.value(
        *place,
        read,
        &BTreeSet::new(),
    ) {
        Err(Stop::Capped(cap)) => Err(Stop::Capped(cap)),
        value => Ok(value.ok()),
    };
    cells.iter().map(value).collect()
}

/// How many cells these values give.
fn explained(cells: &Cells, values: &[Option<Value>], decimals: &str) -> Result<usize, Stop> {
    let mut count = 0;
    for ((_, decimal), value) in cells.iter().zip(values) {
        if let Some(value) = value {
            count += usize::from(gives(decimal, value, decimals)?);
        }
    }
    Ok(count)
}

/// The first stated parameter, by name, that is not 0 and that every value is proportional to.
fn scale(table: &Table<'_>, cells: &Cells) -> Result<Option<String>, Stop> {
    if table.tolerance.is_some() {
        return Ok(None);
    }
    let once = values(table, cells, &table.as_printed)?;
    for (name, base) in table.given.iter().filter(|(_, base)| !base.is_zero()) {
        let double = base.plus(1, base)?;
        let read = Read { parameters: [(name.clone(), double)].into(), ..Read::default() };
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

/// How many cells the values give at most when they are those at `base` of a parameter that
/// they are proportional to, and it is p/q with p, q = 1, …, 100; exact above `enough` only.
fn at_best_scale(
    cells: &Cells,
    values: &[Option<Value>],
    decimals: &str,
    base: &Value,
    enough: usize,
) -> Result<usize, Stop> {
    let Some(base) = base.rational().filter(Signed::is_positive) else { return Ok(0) };
    // The values of the parameter that give a cell, by its |value| at 1.
    let mut ranges = Vec::new();
    for ((_, decimal), value) in cells.iter().zip(values) {
        let Some(value) = value.as_ref().filter(|value| !value.is_zero()) else { continue };
        let unit = value.over(&Value::from(base.clone()))?.abs(None)?;
        let (low, high) = interval(decimal, decimals);
        ranges.push((Value::from(low).over(&unit)?, Value::from(high).over(&unit)?));
    }
    let least = |a: &Value, b: &Value| Ok(a.plus(-1, b)?.sign(None)? <= 0);
    let covering = |s: &Value| -> Result<usize, Stop> {
        let mut count = 0;
        for (low, high) in &ranges {
            count += usize::from(least(low, s)? && least(s, high)?);
        }
        Ok(count)
    };
    let mut best = 0;
    for (low, high) in &ranges {
        // The ranges that meet at some value all hold the greatest of their lower ends.
        if covering(low)? <= enough {
            continue;
        }
        for q in 1..=MAX_SCALE {
            let mut p = low.times(&Value::int(q))?.floor()?;
            loop {
                let s = Value::from(Q::new(p.clone(), q.into()));
                if p > MAX_SCALE.into() || !least(&s, high)? {
                    break;
                }
                best = best.max(if p.is_positive() { covering(&s)? } else { 0 });
                p += 1;
            }
        }
    }
    Ok(best)
}

/// e_m of the likelihoods that an unrelated value becomes a printed cell: a bound on how
/// likely m of them do.
fn chance(table: &Table<'_>, cells: &Cells, m: usize) -> Q {
    let mut symmetric = vec![Q::zero(); m + 1];
    symmetric[0] = Q::one();
    for (_, decimal) in cells {
        let digits = decimal.digits.abs().to_string();
        let digits = digits.trim_end_matches('0').len().max(1);
        let likely = if table.tolerance.is_some() {
            Q::new(1.into(), 4.into())
        } else {
            power_of_ten(1 - i64::try_from(digits).unwrap_or(1)) / int(9)
        };
        for k in (1..=m).rev() {
            let more = &symmetric[k - 1] * &likely;
            symmetric[k] += more;
        }
    }
    symmetric.swap_remove(m)
}
