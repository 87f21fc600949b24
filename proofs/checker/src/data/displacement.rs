//! The displacement of a refined polygon from the polygon before.

use crate::numbers::{Meter, Piece, Q, Value};
use crate::schemes::Scheme;
use crate::text::Stop;

/// The sum of the absolute values (terms = 0), or the absolute value of the sum (terms = 1).
pub fn gather(piece: Option<&Piece<'_>>, values: &[Value], terms: usize) -> Result<Value, Stop> {
    if terms == 1 {
        return Value::total(values)?.abs(piece);
    }
    values.iter().try_fold(Value::int(0), |sum, value| sum.plus(1, &value.abs(piece)?))
}

/// ã_{α,m} of `x'_{ni+α} − ((1−α/n)x_i + (α/n)x_{i+1}) = Σ_m ã_{α,m} Δ_{i+m}`, in the order
/// of m, from m = min(0, o) on.
fn displaced(scheme: &Scheme, alpha: usize, offset: i64) -> Result<Vec<Value>, Stop> {
    let row = &scheme.mask[alpha];
    let width = i64::try_from(row.len()).unwrap_or(0);
    // The sums of the weights from each place on.
    let mut after = vec![Value::int(0)];
    for weight in row.iter().rev() {
        after.push(weight.plus(1, &after[after.len() - 1])?);
    }
    after.reverse();
    let coefficient = |m: i64| {
        // x_{i+s} − x_i is the sum of the Δ_{i+m} over 0 ≤ m < s, or, for s < 0, minus their sum
        // over s ≤ m < 0. Hence Δ_{i+m} has the sum of the weights with s > m if m ≥ 0, and minus
        // the sum of those with s ≤ m if m < 0.
        let cut = usize::try_from((m + 1 - offset).clamp(0, width)).unwrap_or(0);
        match m {
            ..0 => after[cut].minus(&after[0]),
            0 => after[cut].minus(&fraction(alpha, scheme.arity())),
            _ => Ok(after[cut].clone()),
        }
    };
    (offset.min(0)..=(offset + width - 2).max(0)).map(coefficient).collect()
}

/// The terms of every rule, gathered.
pub fn moved(
    meter: &Meter,
    piece: Option<&Piece<'_>>,
    (scheme, offset): (&Scheme, i64),
    terms: usize,
) -> Result<Vec<Value>, Stop> {
    let of = |alpha| {
        let displaced = displaced(scheme, alpha, offset)?;
        meter.spend(displaced.len() as u64)?;
        gather(piece, &displaced, terms)
    };
    (0..scheme.arity()).map(of).collect()
}

/// The offset from −N to 1 at which max_α Σ_m |ã_{α,m}| is least; of several the one nearest to 0, −1 before 1.
pub fn best_offset(meter: &Meter, scheme: &Scheme) -> Result<i64, Stop> {
    let width = scheme.mask.first().map_or(0, Vec::len);
    let width = i64::try_from(width).map_err(|_| Stop::Capped("the width of a mask"))?;
    let mut offsets: Vec<i64> = (-width..=1).collect();
    offsets.sort_by_key(|offset| offset.unsigned_abs());
    let mut best: Option<(Q, i64)> = None;
    for offset in offsets {
        let greatest = Value::greatest(&moved(meter, None, (scheme, offset), 0)?, None)?;
        let greatest = greatest.rational();
        let greatest =
            greatest.ok_or(Stop::Capped("the best offset of a mask that is not rational"))?;
        if best.as_ref().is_none_or(|(least, _)| greatest < *least) {
            best = Some((greatest, offset));
        }
    }
    Ok(best.map_or(0, |(_, offset)| offset))
}

fn fraction(top: usize, bottom: usize) -> Value {
    Q::new(top.into(), bottom.into()).into()
}

/// The sums x1·η¹ + x2·η² + x3·η³ of FORMAT.md, one for each α and β.
pub fn surface(
    meter: &Meter,
    piece: Option<&Piece<'_>>,
    scheme: &Scheme,
    spreads: [&Value; 3],
    terms: usize,
) -> Result<Vec<Value>, Stop> {
    let n = scheme.arity();
    // A_α = Σ_{h≥1} a_{α,h}, and s_α the sum of the ã_{α,m} with m ≥ 1.
    let of_rule = |rule: usize| -> Result<[Value; 3], Stop> {
        let row = &scheme.mask[rule];
        meter.spend(row.len() as u64)?;
        let later = gather(piece, &displaced(scheme, rule, 0)?[1..], terms)?;
        Ok([Value::total(&row[1..])?, later, gather(piece, row, terms)?])
    };
    let rules = (0..n).map(of_rule).collect::<Result<Vec<_>, Stop>>()?;
    // |x − top/bottom| + factor·s
    let eta = |x: &Value, top: usize, bottom: usize, factor: &Value, s: &Value| {
        x.minus(&fraction(top, bottom))?.abs(piece)?.plus(1, &factor.times(s)?)
    };
    let mut sums = Vec::new();
    for (alpha, [a, s, norm]) in rules.iter().enumerate() {
        for (beta, [b, later, _]) in rules.iter().enumerate() {
            meter.spend(1)?;
            let first = &scheme.mask[beta][0];
            let eta = [
                eta(&first.times(a)?, alpha * (n - beta), n * n, &first.abs(piece)?, s)?,
                eta(b, beta, n, norm, later)?,
                eta(&a.times(b)?, alpha * beta, n * n, &b.abs(piece)?, s)?,
            ];
            let terms = eta.iter().zip(spreads).map(|(eta, spread)| eta.times(spread));
            sums.push(Value::total(&terms.collect::<Result<Vec<Value>, Stop>>()?)?);
        }
    }
    Ok(sums)
}
