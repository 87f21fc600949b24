//! The values at the integers of a function with f(x) = Σ_k a_k f(nx − k).

#![warn(clippy::arithmetic_side_effects)]

use super::polynomials::solve_on;
use crate::functions::masks::{Mask, signed};
use crate::functions::steps::{add, over};
use crate::numbers::{Meter, Piece, Value};
use crate::text::Stop;

/// The most integers of a support.
const MAX_UNKNOWNS: usize = 256;

/// The cap of places.
pub const PLACE: Stop = Stop::Capped("the places of a limit function");

/// The first and the last integer from l/(n − 1) to K/(n − 1).
pub fn window(mask: &Mask) -> Result<(i64, i64), Stop> {
    let below = signed(mask.arity)?.checked_sub(1).ok_or(PLACE)?;
    let floor = |place: i64| place.checked_div_euclid(below);
    let first = mask.first.checked_neg().and_then(floor).and_then(i64::checked_neg);
    first.zip(floor(mask.last()?)).ok_or(PLACE)
}

/// The values f(i) at the integers of the support, where f(x) = Σ_k a_k f(nx − k) and Σ_i f(i) = 1.
///
/// Where the mask has the symbol of a piece, the limit has to be shown to exist: then there is only one solution.
pub fn at_integers(
    meter: &Meter,
    mask: &Mask,
    piece: Option<&Piece<'_>>,
) -> Result<Vec<Value>, Stop> {
    let (first, last) = window(mask)?;
    let size = last.checked_sub(first).and_then(|size| usize::try_from(size).ok());
    let size = size.and_then(|size| size.checked_add(1)).ok_or(PLACE)?;
    if size > MAX_UNKNOWNS {
        return Err(Stop::Capped("the unknowns of a limit function"));
    }
    let n = signed(mask.arity)?;
    if let Some(piece) = piece
        && let Some(point) = kept_point(mask, piece)?
    {
        return (first..=last).map(|i| Ok(Value::int(i64::from(i == point)))).collect();
    }
    let mut rows = Vec::new();
    for i in first..=last {
        meter.spend(size as u64)?;
        let at = n.checked_mul(i).ok_or(PLACE)?;
        let entry = |j: i64| {
            let a = at.checked_sub(j).and_then(|k| mask.at(k)).cloned();
            let a = a.unwrap_or_else(|| Value::int(0));
            if i == j { a.minus(&Value::int(1)) } else { Ok(a) }
        };
        let row = (first..=last).map(entry).chain([Ok(Value::int(0))]);
        rows.push(row.collect::<Result<Vec<Value>, Stop>>()?);
    }
    // The coefficients of one class mod n sum to 1, so that all these equations sum to 0, and one of them follows from the
    // others.
    let sum = vec![Value::int(1); size.saturating_add(1)];
    if let Some(piece) = piece {
        rows.push(sum);
        return solve_on(meter, rows, piece);
    }
    rows[0] = sum;
    solve(meter, rows)
}

/// The integer p for which f(p) = 1 and f = 0 at all others is a solution: a_k = 1 for k = (n − 1)p, and 0 for all other k = ni − p.
fn kept_point(mask: &Mask, piece: &Piece<'_>) -> Result<Option<i64>, Stop> {
    let (n, (first, last)) = (signed(mask.arity)?, window(mask)?);
    for p in first..=last {
        let kept = n.checked_sub(1).and_then(|below| below.checked_mul(p)).ok_or(PLACE)?;
        let mut is = mask.at(kept).is_some();
        for (k, a) in (mask.first..).zip(&mask.values) {
            let of_class = k.checked_add(p).is_some_and(|at| at.checked_rem_euclid(n) == Some(0));
            if is && of_class {
                is = a.minus(&Value::int(i64::from(k == kept)))?.is_known_zero(Some(piece))?;
            }
        }
        if is {
            return Ok(Some(p));
        }
    }
    Ok(None)
}

/// The solution of linear equations, if it is the only one. The right side of each comes last.
pub fn solve(meter: &Meter, mut rows: Vec<Vec<Value>>) -> Result<Vec<Value>, Stop> {
    let size = rows.len();
    for j in 0..size {
        let least = (j..size).filter(|i| !rows[*i][j].is_zero());
        let least = least.min_by_key(|i| rows[*i][j].steps(&rows[*i][j]));
        rows.swap(j, least.ok_or(Stop::Capped("a solution that is not unique"))?);
        let (above, below) = rows.split_at_mut(j.saturating_add(1));
        let Some(pivot) = above.last() else { return Err(PLACE) };
        for row in below.iter_mut().filter(|row| !row[j].is_zero()) {
            let factor = over(meter, &row[j], &pivot[j])?.negated()?;
            for (value, p) in row.iter_mut().zip(pivot).skip(j) {
                add(meter, value, &factor, p)?;
            }
        }
    }
    let mut solution: Vec<Value> = Vec::new();
    for (j, row) in rows.iter().enumerate().rev() {
        let mut rest = row[size].clone();
        // The values are known from the last one down.
        for (a, value) in row[..size].iter().rev().zip(&solution) {
            add(meter, &mut rest, &a.negated()?, value)?;
        }
        solution.push(over(meter, &rest, &row[j])?);
    }
    solution.reverse();
    Ok(solution)
}
