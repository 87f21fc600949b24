//! The extremes of Σ_k g_k cos(kξ), a polynomial P(t) in t = cos ξ, on the interval from −1 to 1: at the ends, or at the roots
//! of P′.

#![warn(clippy::arithmetic_side_effects)]

use super::call::number;
use super::exponent::characteristic;
use super::masks::signed;
use super::real::Real;
use super::steps::add;
use crate::numbers::{
    Meter, Q, Value, at, bits, divide, gcd, int, multiplied, roots_between, signum, steps_of_gcd,
    trimmed,
};
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::{One as _, Zero as _};

/// The binary digits to which the roots of P′ are known.
const DIGITS: u64 = 160;

const HALVINGS: Stop = Stop::Capped("the halvings of an interval");

/// Two bounds of a number; they are equal if it is known.
type Bounds = [Q; 2];

/// The least value, or the greatest one, of Σ_k g_k cos(kξ); the known g_k are those from the first k on.
pub fn extreme(meter: &Meter, (first, known): (i64, &[Value]), upper: bool) -> Result<Real, Stop> {
    let polynomial = polynomial(meter, first, known)?;
    if let [constant] = &polynomial[..] {
        return Ok(Real::Exact(constant.clone()));
    }
    let rational: Option<Vec<Q>> = polynomial.iter().map(Value::rational).collect();
    let Some(p) = rational else {
        if !is_monotone(meter, &polynomial)? {
            return Err(Stop::Capped("the extremes of a polynomial that is not rational"));
        }
        let ends = [1, -1].map(|end| {
            let terms = (0_usize..).zip(&polynomial);
            let even = |k: usize| end > 0 || k.is_multiple_of(2);
            let term =
                |sum: Value, (k, c): (usize, &Value)| sum.plus(if even(k) { 1 } else { -1 }, c);
            terms.into_iter().try_fold(Value::int(0), term)
        });
        let [one, other] = ends;
        let (one, other) = (one?, other?);
        let below = one.compare(&other)?.is_lt();
        return Ok(Real::Exact(if below == upper { other } else { one }));
    };
    if !upper {
        return least(meter, &p);
    }
    // The greatest value of P is that of −P, negated.
    let negated: Vec<Q> = p.iter().map(|c| -c).collect();
    Ok(match least(meter, &negated)? {
        Real::Exact(value) => Real::Exact(value.negated()?),
        Real::Between(ends) => Real::Between(Box::new(opposite(&ends))),
        Real::Root(f, ends) => {
            let sign = |k: usize| if k.is_multiple_of(2) { int(1) } else { int(-1) };
            let f = (0..).zip(f).map(|(k, c)| c * sign(k)).collect();
            Real::Root(f, Box::new(opposite(&ends)))
        }
        Real::RootOf(..) | Real::At(..) | Real::Ratio(..) | Real::SquareRoot(_) => {
            return Err(HALVINGS);
        }
    })
}

fn opposite([low, high]: &Bounds) -> Bounds {
    [-high, -low]
}

/// P = Σ_k g_k C_k, with cos(kξ) = C_k(cos ξ): C_0 = 1, C_1 = t, C_{k+1} = 2tC_k − C_{k−1}.
fn polynomial(meter: &Meter, first: i64, known: &[Value]) -> Result<Vec<Value>, Stop> {
    let mut sum: Vec<Value> = vec![Value::int(0); known.len().saturating_add(1)];
    let (mut before, mut cosine) = (vec![BigInt::zero(), BigInt::one()], vec![BigInt::one()]);
    let last = signed(known.len())?.saturating_sub(1).saturating_add(first);
    for k in 0..=first.unsigned_abs().max(last.unsigned_abs()) {
        let of = |k: i64| k.checked_sub(first).and_then(|place| usize::try_from(place).ok());
        let of = |k: i64| of(k).and_then(|place| known.get(place));
        let k = i64::try_from(k).unwrap_or(i64::MAX);
        let both = [of(k), of(k.saturating_neg()).filter(|_| k > 0)];
        for g in both.into_iter().flatten() {
            for (sum, c) in sum.iter_mut().zip(&cosine) {
                let c = Value::from(Q::from_integer(c.clone()));
                add(meter, sum, g, &c)?;
            }
        }
        // C_1 = 2tC_0 − t.
        let mut next = vec![BigInt::zero()];
        next.extend(cosine.iter().map(|c| c * 2_u8));
        next.iter_mut().zip(&before).for_each(|(c, b)| *c -= b);
        (before, cosine) = (cosine, next);
    }
    while sum.len() > 1 && sum.last().is_some_and(Value::is_zero) {
        sum.pop();
    }
    Ok(sum)
}

/// Whether P′ is shown to have one sign: the coefficients of (1 + u)^d P′((u − 1)/(u + 1)), 0 < u < ∞, have.
fn is_monotone(meter: &Meter, p: &[Value]) -> Result<bool, Stop> {
    let mut sum: Vec<Value> = Vec::new();
    // By Horner's rule with u − 1 in place of the argument, and a power of u + 1 for each missing factor.
    let mut power = vec![BigInt::one()];
    let times = |p: &[Value], sign: i64| {
        let mut product = vec![Value::int(0); p.len().saturating_add(1)];
        for (k, c) in p.iter().enumerate() {
            product[k].add(sign, c)?;
            product[k.saturating_add(1)].add(1, c)?;
        }
        Ok::<Vec<Value>, Stop>(product)
    };
    for (k, c) in p.iter().enumerate().skip(1).rev() {
        let c = c.times(&number(k))?;
        sum = times(&sum, -1)?;
        sum.resize(power.len(), Value::int(0));
        for (sum, binomial) in sum.iter_mut().zip(&power) {
            add(meter, sum, &c, &Q::from_integer(binomial.clone()).into())?;
        }
        let mut next = [&power[..], &[BigInt::zero()]].concat();
        next.iter_mut().skip(1).zip(&power).for_each(|(sum, c)| *sum += c);
        power = next;
    }
    let signs = sum.iter().map(|c| c.number()?.sign());
    let signs = signs.collect::<Result<Vec<i8>, Stop>>()?;
    Ok(signs.iter().all(|sign| *sign >= 0) || signs.iter().all(|sign| *sign <= 0))
}

fn derivative(p: &[Q]) -> Vec<Q> {
    trimmed((1..).zip(p.iter().skip(1)).map(|(k, c)| c * int(k)).collect())
}

/// p without multiple roots.
fn simple(meter: &Meter, p: Vec<Q>) -> Result<Vec<Q>, Stop> {
    let slope = derivative(&p);
    meter.spend(steps_of_gcd(&p, &slope).saturating_mul(2))?;
    let common = gcd(&p, &slope);
    Ok(if common.len() > 1 { divide(p, &common).0 } else { p })
}

/// The least value of P on the interval.
fn least(meter: &Meter, p: &[Q]) -> Result<Real, Stop> {
    let mut slope = simple(meter, derivative(p))?;
    for end in [1, -1].map(int) {
        if at(&slope, &end).is_zero() {
            slope = divide(slope, &[-end, int(1)]).0;
        }
    }
    let mut values: Vec<Bounds> =
        [1, -1].map(|end| at(p, &int(end))).map(|x| [x.clone(), x]).into();
    for root in roots(meter, &slope)? {
        values.push(enclosed(p, &root));
    }
    let least = values.iter().map(|[_, high]| high).min().cloned().unwrap_or_else(Q::zero);
    values.retain(|[low, _]| *low <= least);
    let (exact, mut roots): (Vec<Bounds>, Vec<Bounds>) =
        values.into_iter().partition(|[low, high]| low == high);
    let exact = exact.into_iter().map(|[value, _]| value).min();
    roots.sort();
    let (Some(low), Some(high)) = (
        roots.iter().map(|[low, _]| low).min().cloned(),
        roots.iter().map(|[_, high]| high).max().cloned(),
    ) else {
        return exact.map(|value| Real::Exact(value.into())).ok_or(HALVINGS);
    };
    // All of these values are roots of one polynomial: they are equal if it has one root there.
    let f = values_of(meter, p, &slope)?;
    let [low, high] = apart(&f, low, high);
    let count = |low: &Q, high: &Q| {
        meter.spend(steps_of_gcd(&f, &f))?;
        Ok::<usize, Stop>(roots_between(&f, low, high))
    };
    if count(&low, &high)? != 1 {
        return Err(HALVINGS);
    }
    match exact {
        Some(value) if at(&f, &value).is_zero() || value <= low => Ok(Real::Exact(value.into())),
        Some(value) if value < high && count(&low, &value)? == 0 => Ok(Real::Exact(value.into())),
        _ => Ok(Real::Root(f, Box::new([low, high]))),
    }
}

/// Ends a little farther out, that are no roots.
fn apart(f: &[Q], mut low: Q, mut high: Q) -> Bounds {
    let step = Q::new(BigInt::one(), BigInt::one() << DIGITS);
    while at(f, &low).is_zero() {
        low -= &step;
    }
    while at(f, &high).is_zero() {
        high += &step;
    }
    [low, high]
}

/// The roots between −1 and 1, which are simple and none at the ends.
fn roots(meter: &Meter, p: &[Q]) -> Result<Vec<Bounds>, Stop> {
    let (mut found, mut waiting) = (Vec::new(), vec![[int(-1), int(1)]]);
    if p.len() < 2 {
        return Ok(found);
    }
    let cost = steps_of_gcd(p, p);
    while let Some([low, high]) = waiting.pop() {
        meter.spend(cost)?;
        if bits(&low) > DIGITS {
            return Err(HALVINGS);
        }
        match roots_between(p, &low, &high) {
            0 => {}
            1 => found.push(narrowed(meter, p, [low, high])?),
            _ => {
                // A point that is no root.
                let middle = (1..).map(|k| {
                    let part = Q::new(k.into(), BigInt::from(k).pow(2) * 2 + 1);
                    &low + (&high - &low) * part
                });
                let middle = middle.into_iter().find(|x| !at(p, x).is_zero()).ok_or(HALVINGS)?;
                waiting.push([low, middle.clone()]);
                waiting.push([middle, high]);
            }
        }
    }
    Ok(found)
}

/// The only root in an interval, in a narrow one.
fn narrowed(meter: &Meter, p: &[Q], [mut low, mut high]: Bounds) -> Result<Bounds, Stop> {
    let (unit, side) = (BigInt::one() << DIGITS, signum(&at(p, &low)));
    while &high - &low > Q::new(BigInt::one(), unit.clone()) {
        meter.spend((p.len() as u64).saturating_mul(8))?;
        // Halves in whole units remain short.
        let middle = ((&low + &high) / int(2) * Q::from_integer(unit.clone())).round()
            / Q::from_integer(unit.clone());
        if middle <= low || middle >= high {
            break;
        }
        match signum(&at(p, &middle)) {
            0 => return Ok([middle.clone(), middle]),
            sign if sign == side => low = middle,
            _ => high = middle,
        }
    }
    Ok([low, high])
}

/// Bounds of P between two numbers.
fn enclosed(p: &[Q], [low, high]: &Bounds) -> Bounds {
    let mut sum = [Q::zero(), Q::zero()];
    for c in p.iter().rev() {
        let [a, b] = &sum;
        let products = [a * low, a * high, b * low, b * high];
        let least = products.iter().min().cloned().unwrap_or_else(Q::zero);
        let most = products.into_iter().max().unwrap_or_else(Q::zero);
        sum = [least + c, most + c];
    }
    sum
}

/// The polynomial without multiple roots whose roots are the values of P at the roots of another one: the characteristic polynomial
/// of the multiplication by P modulo that one.
fn values_of(meter: &Meter, p: &[Q], modulus: &[Q]) -> Result<Vec<Q>, Stop> {
    let degree = modulus.len().saturating_sub(1);
    let mut column = divide(p.to_vec(), modulus).1;
    let mut columns = Vec::new();
    for _ in 0..degree {
        column.resize(degree, Q::zero());
        let row: Vec<Value> = column.iter().map(|c| c.clone().into()).collect();
        columns.push(row);
        column = divide(multiplied(&column, &[Q::zero(), Q::one()]), modulus).1;
    }
    let f = characteristic(meter, &columns)?;
    let f: Option<Vec<Q>> = f.iter().map(Value::rational).collect();
    simple(meter, f.ok_or(HALVINGS)?)
}
