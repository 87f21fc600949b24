//! Products of sequences: t(z)·t(z^n)·t(z^(n²))…

use crate::evaluate::Scope;
use crate::number::{Number, multiply};
use crate::scheme::{Library, Scheme};
use crate::value::{Stop, Value};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};
use std::rc::Rc;

/// The most coefficients of a product, and the most residue classes.
const MAX_LENGTH: usize = 1 << 16;

/// c convolutions with a sequence of a scheme of this arity.
pub struct Convolution {
    /// c.
    pub c: u32,
    /// n.
    pub arity: usize,
    /// Whether by the recursion E^{c−1}·E^{c−1} in place of E¹·E^{c−1}.
    pub printed: bool,
}

impl Convolution {
    /// How many sequences are multiplied.
    fn factors(&self) -> u32 {
        if self.printed { 1_u32.checked_shl(self.c - 1).unwrap_or(u32::MAX) } else { self.c }
    }

    /// E^c_{l,f} is the coefficient of z^(f − stride·l).
    pub fn stride(&self) -> usize {
        self.arity.saturating_pow(self.factors())
    }

    /// The first `length` coefficients of the product.
    pub fn of(
        &self,
        library: &Library<'_>,
        sequence: &[Value],
        length: usize,
    ) -> Result<Vec<Value>, Stop> {
        let mut product = sequence[..sequence.len().min(length)].to_vec();
        let mut factors = 1;
        while factors < self.factors() {
            // E^c_{l,f} = Σ_e E_{l,e} E^{c−1}_{e,f}: the left factor in z^(n^factors).
            let step = self.arity.saturating_pow(factors);
            let left = if self.printed { &product } else { sequence };
            let next = spread(library, left, &product, step, length)?;
            factors = if self.printed { 2 * factors } else { factors + 1 };
            product = next;
        }
        Ok(product)
    }

    /// All coefficients of the product for the mask (`a`) or the difference mask (`b`) of a
    /// scheme, read backwards or forwards.
    pub fn of_scheme(
        &self,
        library: &Library<'_>,
        scheme: &Scheme,
        of: &str,
        forward: bool,
    ) -> Result<Rc<Vec<Value>>, Stop> {
        let key = format!("{of} {} {} {forward}", self.c, self.printed);
        if let Some(known) = scheme.known.borrow().get(&key) {
            return Ok(Rc::clone(known));
        }
        // t_{nu+β} = r_{β,N−1−u}, or r_{β,u} forwards.
        let rules = if of == "a" { &scheme.mask } else { &scheme.difference };
        let last = scheme.width() - 1;
        let columns = (0..=last).map(|u| if forward { u } else { last - u });
        let sequence = columns.flat_map(|column| rules.iter().map(move |row| row[column].clone()));
        let sequence: Vec<Value> = sequence.collect();
        let product = Rc::new(self.of(library, &sequence, MAX_LENGTH + 1)?);
        if product.len() > MAX_LENGTH {
            return Err(Stop::Capped("the length of a product of sequences"));
        }
        scheme.known.borrow_mut().insert(key, Rc::clone(&product));
        Ok(product)
    }
}

/// left(z^step)·right(z), its first `length` coefficients.
fn spread(
    library: &Library<'_>,
    left: &[Value],
    right: &[Value],
    step: usize,
    length: usize,
) -> Result<Vec<Value>, Stop> {
    let whole = left.len().saturating_sub(1).saturating_mul(step).saturating_add(right.len());
    let length = whole.min(length).min(MAX_LENGTH + 1);
    library.spend((left.len() * right.len()) as u64 / 4)?;
    // Of numbers the numerators are multiplied, over common denominators.
    if let Some(n) = common_field(left.iter().chain(right)) {
        let ((left, p), (right, q)) = (integers(left, n)?, integers(right, n)?);
        let mut product = vec![Vec::new(); length];
        for (i, a) in left.iter().enumerate() {
            let from = i.saturating_mul(step).min(length);
            for (sum, b) in product[from..].iter_mut().zip(&right) {
                let term = multiply(n, a, b);
                sum.resize(term.len(), BigInt::zero());
                sum.iter_mut().zip(term).for_each(|(sum, term)| *sum += term);
            }
        }
        let value = |mut top: Vec<BigInt>| {
            top.resize(top.len().max(1), BigInt::zero());
            Value::Number(Number::new(n, top, &p * &q))
        };
        return Ok(product.into_iter().map(value).collect());
    }
    let mut product = vec![Value::int(0); length];
    for (i, a) in left.iter().enumerate() {
        let from = i.saturating_mul(step).min(length);
        for (sum, b) in product[from..].iter_mut().zip(right) {
            library.spend(a.cost(b))?;
            *sum = sum.plus(1, &a.times(b)?)?;
        }
    }
    Ok(product)
}

/// The n of a field that holds all these values, if they are numbers.
fn common_field<'v>(mut values: impl Iterator<Item = &'v Value>) -> Option<u32> {
    values.try_fold(1, |n, value| value.number().ok()?.common_field(n))
}

/// Coefficients in the field of n, over one common denominator.
fn integers(values: &[Value], n: u32) -> Result<(Vec<Vec<BigInt>>, BigInt), Stop> {
    let lifted = values.iter().map(|value| Ok(value.number()?.lift(n)));
    let lifted = lifted.collect::<Result<Vec<_>, Stop>>()?;
    let common = lifted.iter().fold(BigInt::one(), |common, (_, bottom)| common.lcm(bottom));
    let scale = |(mut top, bottom): (Vec<BigInt>, &BigInt)| {
        for coefficient in &mut top {
            *coefficient *= &common / bottom;
        }
        top
    };
    Ok((lifted.into_iter().map(scale).collect(), common))
}

/// Σ_s |(R^c)_{r,s}| for every residue class r mod n^c, up to a shift of r that depends on
/// n, N and c only.
pub fn classes(
    scope: &Scope<'_>,
    scheme: &Scheme,
    of: &str,
    forward: bool,
    c: &Value,
) -> Result<Vec<Value>, Stop> {
    let c = u32::try_from(c.integer(64)?).map_err(|_| Stop::Wrong("a negative level".into()))?;
    if c == 0 {
        return Ok(vec![Value::int(1)]);
    }
    let convolution = Convolution { c, arity: scheme.arity(), printed: false };
    if convolution.stride() > MAX_LENGTH {
        return Err(Stop::Capped("the number of residue classes"));
    }
    let product = convolution.of_scheme(scope.library, scheme, of, forward)?;
    let count = convolution.stride();
    if common_field(product.iter()) == Some(1) {
        let (tops, bottom) = integers(&product, 1)?;
        let mut sums = vec![BigInt::zero(); count];
        for (f, top) in tops.into_iter().enumerate() {
            sums[f % count] += top[0].abs();
        }
        let value = |sum| Value::Number(Number::new(1, vec![sum], bottom.clone()));
        return Ok(sums.into_iter().map(value).collect());
    }
    let mut sums = vec![Value::int(0); count];
    for (f, coefficient) in product.iter().enumerate() {
        sums[f % count] = sums[f % count].plus(1, &coefficient.abs(scope.piece.as_ref())?)?;
    }
    Ok(sums)
}

/// Σ_l |E^c_{l,f}|, l = 0, …, ⌊f/n^c⌋, for the last n^c values f up to `last`.
pub fn sums(
    scope: &Scope<'_>,
    product: &[Value],
    convolution: &Convolution,
    last: usize,
) -> Result<Vec<Value>, Stop> {
    if last > MAX_LENGTH {
        return Err(Stop::Capped("the length of a product of sequences"));
    }
    let classes = convolution.arity.saturating_pow(convolution.c);
    let mut sums = Vec::new();
    for f in (last + 1).saturating_sub(classes)..=last {
        let mut sum = Value::int(0);
        for l in 0..=f / classes {
            let at = l.checked_mul(convolution.stride()).and_then(|skipped| f.checked_sub(skipped));
            if let Some(value) = at.and_then(|at| product.get(at)) {
                sum = sum.plus(1, &value.abs(scope.piece.as_ref())?)?;
            }
        }
        sums.push(sum);
    }
    Ok(sums)
}
