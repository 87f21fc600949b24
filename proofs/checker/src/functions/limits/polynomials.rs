//! Linear equations with polynomials in the symbol of a piece.

#![warn(clippy::arithmetic_side_effects)]

use crate::functions::steps::{add, over, times};
use crate::numbers::{Meter, Piece, Value};
use crate::text::Stop;

/// An equation. The right side comes last.
type Row = Vec<Value>;

/// The solution on a piece of linear equations that have exactly one. No value is divided by a polynomial: if that does not lead to the
/// solution, it is not known.
pub fn solve_on(meter: &Meter, mut rows: Vec<Row>, piece: &Piece<'_>) -> Result<Vec<Value>, Stop> {
    let size = rows.first().map_or(0, Vec::len).saturating_sub(1);
    let mut solved: Vec<(usize, Row)> = Vec::new();
    for row in &mut rows {
        simplify(meter, row, piece)?;
    }
    while solved.len() < size {
        let (place, column) = pivot(meter, &rows, size)?
            .ok_or(Stop::Capped("equations without numbers as divisors"))?;
        let row = rows.swap_remove(place);
        for other in rows.iter_mut().filter(|other| !other[column].is_zero()) {
            let factor = over(meter, &other[column], &row[column])?.negated()?;
            for (value, p) in other.iter_mut().zip(&row) {
                add(meter, value, &factor, p)?;
            }
            simplify(meter, other, piece)?;
        }
        solved.push((column, row));
    }
    // Each of these has no unknowns of those before it.
    let mut solution = vec![Value::int(0); size];
    for (column, row) in solved.iter().rev() {
        let mut rest = row[size].clone();
        for (i, a) in row[..size].iter().enumerate() {
            if i != *column {
                add(meter, &mut rest, &a.negated()?, &solution[i])?;
            }
        }
        solution[*column] = over(meter, &rest, &row[*column])?;
    }
    Ok(solution)
}

/// Makes 0 what is 0 on the piece. An equation that is one polynomial times numbers becomes these numbers, since the polynomial is not 0.
fn simplify(meter: &Meter, row: &mut Row, piece: &Piece<'_>) -> Result<(), Stop> {
    for value in row.iter_mut() {
        if value.number().is_err() && value.is_known_zero(Some(piece))? {
            *value = Value::int(0);
        }
    }
    let Some(common) = row.iter().find(|value| !value.is_zero()).cloned() else { return Ok(()) };
    if common.number().is_ok() {
        return Ok(());
    }
    let mut numbers = Row::with_capacity(row.len());
    for value in &*row {
        match multiple(meter, value, &common)? {
            Some(number) => numbers.push(number),
            None => return Ok(()),
        }
    }
    // The piece is cut where the polynomial is 0.
    if common.sign(Some(piece))? != 0 {
        *row = numbers;
    }
    Ok(())
}

/// The number c with `value` = c·`common`.
fn multiple(meter: &Meter, value: &Value, common: &Value) -> Result<Option<Value>, Stop> {
    let Some((on, top)) = value.all().last() else { return Ok(Some(Value::int(0))) };
    let Some((_, bottom)) = common.all().last().filter(|(monomial, _)| *monomial == on) else {
        return Ok(None);
    };
    let number = over(meter, &top.clone().into(), &bottom.clone().into())?;
    let same = times(meter, &number, common)?.equals(value)?;
    Ok(same.then_some(number))
}

/// A number that is not 0 as a divisor, by its row and its column: in the shortest row, and of the shortest column.
fn pivot(meter: &Meter, rows: &[Row], size: usize) -> Result<Option<(usize, usize)>, Stop> {
    meter.spend((rows.len() as u64).saturating_mul(size as u64))?;
    let mut columns = vec![0_usize; size];
    for row in rows {
        for (count, a) in columns.iter_mut().zip(row) {
            *count = count.saturating_add(usize::from(!a.is_zero()));
        }
    }
    let mut best = None;
    for (place, row) in rows.iter().enumerate() {
        let length = row.iter().filter(|a| !a.is_zero()).count();
        for (column, a) in row[..size].iter().enumerate() {
            let found = (length, columns[column], place, column);
            let is = a.number().is_ok_and(|a| !a.is_zero());
            if is && best.is_none_or(|best| found < best) {
                best = Some(found);
            }
        }
    }
    Ok(best.map(|(_, _, place, column)| (place, column)))
}
