//! Cells whose numbers agree with the printed text for one cause: up to one factor, or one summand.

use crate::kinds::table::claim::{Cells, Place, Table};
use crate::numbers::{Q, Value, int};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};
use std::collections::BTreeSet;

/// The fewest cells that are one number for this cause.
const LEAST: usize = 3;

/// The fewest units of the last place of a number that depends on others.
const LEAST_UNITS: i64 = 10;

/// An irrational value is cut to a multiple of the first of these powers of 1/2 of which it has 2^63 or more.
const PLACES: [u32; 5] = [64, 128, 256, 512, 1_024];

/// A cell, and the ends of its factors or of its summands.
struct Range {
    cell: usize,
    place: Place,
    low: Q,
    high: Q,
}

/// Sets of three cells or more, by their places in the list, that are one number. `values` are those of the cells as printed.
pub fn dependent(
    table: &Table<'_>,
    cells: &Cells,
    values: &[Option<Value>],
) -> Result<Vec<Vec<usize>>, Stop> {
    let (mut factors, mut summands) = (Vec::new(), Vec::new());
    for (cell, ((place, decimal), value)) in cells.iter().zip(values).enumerate() {
        let Some(value) = value.as_ref().map(cut).transpose()?.flatten() else { continue };
        let (shown, unit) = (&decimal.value, &decimal.unit);
        let off = shown - &value;
        let imprecise = unit * int(LEAST_UNITS) > shown.abs();
        if imprecise || off.is_zero() || *unit > off.abs() {
            continue;
        }
        let range = |low: Q, high: Q| Range { cell, place: *place, low, high };
        summands.push(range(&off - unit, &off + unit));
        if !value.is_zero() {
            let [one, other] = [shown - unit, shown + unit].map(|end| end / &value);
            factors.push(if one < other { range(one, other) } else { range(other, one) });
        }
    }
    let mut sets = Vec::new();
    for ranges in [factors, summands] {
        let all: Vec<&Range> = ranges.iter().collect();
        for axis in [0, 1] {
            let line = |range: &Range| [range.place.0, range.place.1][axis];
            for number in ranges.iter().map(line).collect::<BTreeSet<usize>>() {
                let inside = all.iter().filter(|range| line(range) == number);
                sets.push(meeting(table, &inside.copied().collect::<Vec<_>>())?);
            }
        }
        sets.push(meeting(table, &all)?);
    }
    sets.retain(|set| set.len() >= LEAST);
    Ok(sets)
}

/// A rational value, or an irrational one cut.
fn cut(value: &Value) -> Result<Option<Q>, Stop> {
    if let Some(value) = value.rational() {
        return Ok(Some(value));
    }
    let size = value.abs(None)?;
    for places in PLACES {
        let unit = BigInt::one() << places;
        let times = size.times(&Value::from(Q::from_integer(unit.clone())))?.floor()?;
        if times.bits() >= 64 {
            let cut = Q::new(times, unit);
            return Ok(Some(if value.sign(None)? < 0 { -cut } else { cut }));
        }
    }
    Ok(None)
}

/// The cells of the ranges that contain x, where x is the first of the lower ends that most ranges contain.
fn meeting(table: &Table<'_>, ranges: &[&Range]) -> Result<Vec<usize>, Stop> {
    // The lower ends come before equal upper ends.
    let lows = ranges.iter().map(|range| (&range.low, false));
    let mut ends: Vec<(&Q, bool)> =
        lows.chain(ranges.iter().map(|range| (&range.high, true))).collect();
    table.paper.library.meter.spend(ends.len() as u64)?;
    ends.sort_unstable();
    let (mut open, mut most, mut best) = (0_usize, 0, None);
    for (end, is_high) in ends {
        if is_high {
            open -= 1;
        } else {
            open += 1;
            if open > most {
                (most, best) = (open, Some(end));
            }
        }
    }
    let Some(x) = best else { return Ok(Vec::new()) };
    let holds = |range: &&&Range| range.low <= *x && *x <= range.high;
    Ok(ranges.iter().filter(holds).map(|range| range.cell).collect())
}
