//! The displacement of a refined polygon from the polygon before.

use crate::decimal::Q;
use crate::meter::Meter;
use crate::piece::Piece;
use crate::reject::Stop;
use crate::scheme::Scheme;
use crate::value::Value;
use num_traits::{Signed, Zero};

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
pub fn best_offset(scheme: &Scheme) -> Result<i64, Stop> {
    let rows = Value::rationals(&scheme.mask);
    let rows = rows.ok_or(Stop::Capped("the best offset of a mask that is not rational"))?;
    // With a coefficient 0 before its first, a rule at the offset o is one at o − 1 = −b, and b ≥ 0. For each rule the sums
    // Σ_{h<c} a_h, c = 0, 1, …
    let heads = |row: &Vec<Q>| {
        let mut sums = vec![Q::zero(), Q::zero()];
        for (a, place) in row.iter().zip(1..) {
            sums.push(&sums[place] + a);
        }
        sums
    };
    let heads: Vec<Vec<Q>> = rows.iter().map(heads).collect();
    let width = heads.first().map_or(0, |sums| sums.len() - 1);
    // ã_{α,m} is Σ_{h≥c} a_h for m > 0, less α/n for m = 0, and −Σ_{h<c} a_h for m < 0, with c = m + 1 + b.
    let moved = |b: usize, sums: &Vec<Q>, alpha: usize| {
        let above = (b + 2..=width).map(|c| (&sums[width] - &sums[c]).abs());
        let below = sums[..=b].iter().map(Q::abs);
        let middle = &sums[width] - &sums[(b + 1).min(width)];
        above.chain(below).sum::<Q>() + (middle - Q::new(alpha.into(), rows.len().into())).abs()
    };
    let greatest =
        |b: usize| heads.iter().enumerate().map(|(alpha, sums)| moved(b, sums, alpha)).max();
    let order = [1, 2, 0].into_iter().chain(3..=width);
    let best = order.filter(|b| *b <= width).min_by_key(|b| greatest(*b));
    let best = best.and_then(|b| i64::try_from(b).ok());
    best.map(|b| 1 - b).ok_or(Stop::Capped("the width of a mask"))
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
