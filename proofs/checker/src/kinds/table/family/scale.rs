//! The scale of a table: a parameter to which all values are proportional.

use super::degree::is_linear;
use super::members::{self, explained, values};
use crate::kinds::table::claim::{Cells, Read, Table};
use crate::numbers::{Q, Value, interval, signum};
use crate::text::{Checked, Stop};
use num_bigint::BigInt;
use num_traits::Signed;

/// The greatest numerator and denominator of a scale.
const MAX_SCALE: i64 = 100;

/// The number of fractions in lowest terms with such numerators and denominators.
pub const SCALES: i64 = 6_087;

/// Whether a scale is p/q with p, q = 1, …, 100.
pub fn is_simple(scale: &Value) -> bool {
    let simple = |part: &BigInt| part.is_positive() && *part <= MAX_SCALE.into();
    scale.rational().is_some_and(|s| simple(s.numer()) && simple(s.denom()))
}

/// The first stated parameter, by name, that is positive and to which the values as printed are
/// proportional, with its value.
pub fn scale<'t>(table: &'t Table<'_>, cells: &Cells) -> Checked<Option<(&'t str, &'t Value)>> {
    let once = values(table, cells, &table.as_printed)?;
    if table.tolerance.is_some() || once.iter().flatten().all(Value::is_zero) {
        return Ok(None);
    }
    for (name, base) in &table.given {
        let printed = Read::default();
        if base.sign(None)?.is_positive() && is_scale(table, cells, name, base, &printed)? {
            return Ok(Some((name, base)));
        }
    }
    Ok(None)
}

/// Whether all values under a reading are proportional to a parameter: the value has the degree 1 in
/// it, and the values double and triple with it.
pub fn is_scale(
    table: &Table<'_>,
    cells: &Cells,
    name: &str,
    base: &Value,
    read: &Read,
) -> Checked<bool> {
    if !is_linear(table, name, read) {
        return Ok(false);
    }
    let once = values(table, cells, read)?;
    for times in [2, 3] {
        let mut scaled = members::read(table, &read.differences)?;
        scaled.parameters.insert(name.to_owned(), base.plus(times - 1, base)?);
        let more = values(table, cells, &scaled)?;
        let mut pairs = once.iter().zip(&more);
        if !pairs.all(|pair| match pair {
            (Some(once), Some(more)) => more.plus(-times, once).is_ok_and(|rest| rest.is_zero()),
            (once, more) => once.is_none() && more.is_none(),
        }) {
            return Ok(false);
        }
    }
    Ok(true)
}

/// The greatest number of cells that the values explain if they are multiplied by (p/q)/base,
/// p, q = 1, …, 100. The search ends when more than `enough` are found, and a smaller number is
/// not exact.
pub fn at_best_scale(
    table: &Table<'_>,
    cells: &Cells,
    values: &[Option<Value>],
    decimals: &str,
    (base, enough): (&Value, usize),
) -> Result<usize, Stop> {
    let spend = || table.paper.library.meter.spend(cells.len() as u64);
    let given = |s: &Value| -> Result<usize, Stop> {
        spend()?;
        let factor = s.over(base)?;
        let scaled = values.iter().map(|v| v.as_ref().map(|v| v.times(&factor)).transpose());
        Ok(explained(cells, &scaled.collect::<Result<Vec<_>, Stop>>()?, decimals)?.len())
    };
    // Each cell has a range of p/q that may explain it. A value 0 is 0 at all of them.
    let (mut ranges, mut zeros) = (Vec::new(), 0);
    for ((_, decimal), value) in cells.iter().zip(values) {
        let Some(value) = value else { continue };
        if value.is_zero() {
            zeros += 1;
            continue;
        }
        // A cell that is printed with the other sign is explained at no scale.
        if signum(&decimal.digits) == -value.sign(None)? {
            continue;
        }
        let unit = value.over(base)?.abs(None)?;
        let (low, high) = interval(decimal, decimals);
        ranges.push((Value::from(low).over(&unit)?, Value::from(high).over(&unit)?));
    }
    // An upper bound of the number of cells that are explained at a scale.
    let covering = |s: &Value| -> Result<usize, Stop> {
        spend()?;
        let mut count = zeros;
        for (low, high) in &ranges {
            count += usize::from(low.compare(s)?.is_le() && s.compare(high)?.is_le());
        }
        Ok(count)
    };
    let mut best = 0;
    for (low, high) in &ranges {
        // The ranges that meet at some value all contain the greatest of their lower ends. A cell
        // that is printed as 0 suggests no scale.
        if low.sign(None)? <= 0 || covering(low)? <= enough {
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
                if best > enough {
                    return Ok(best);
                }
                p += 1;
            }
        }
    }
    Ok(best)
}
