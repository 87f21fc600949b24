//! Products of sequences: t(z)·t(z^n)·t(z^(n²))…

use crate::numbers::{Meter, Number, Piece, Value};
use crate::text::Stop;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The most coefficients of a product, and the most residue classes.
pub const MAX_LENGTH: usize = 1 << 16;

/// An estimate of the steps for the sign of a polynomial on a piece.
const STEPS_OF_SIGN: u64 = 100;

/// The sequence of a mask: t_{nu+β} = r_{β,N−1−u}, or r_{β,u} forwards.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Sequence<'s> {
    /// The rules r_β.
    pub rules: &'s [Vec<Value>],
    /// Whether the sequence is read forwards.
    pub forward: bool,
}

impl Sequence<'_> {
    /// The values t_0, t_1, …
    pub fn values(&self) -> Vec<Value> {
        let last = self.rules[0].len() - 1;
        let columns = (0..=last).map(|u| if self.forward { u } else { last - u });
        columns.flat_map(|column| self.rules.iter().map(move |row| row[column].clone())).collect()
    }
}

/// A convolution of a sequence with itself.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Convolution {
    /// The number c of factors.
    pub c: u32,
    /// The arity n.
    pub arity: usize,
    /// Whether the recursion is E^{c−1}·E^{c−1} and not E¹·E^{c−1}.
    pub printed: bool,
}

impl Convolution {
    /// The number n^c of residue classes.
    pub fn classes(self) -> usize {
        self.arity.saturating_pow(self.c)
    }
}

/// Sums of absolute values for successive f.
#[derive(Clone)]
pub struct Sums {
    /// The first f.
    pub first: usize,
    /// The sums, in units of `scale`.
    pub units: Rc<[Value]>,
    /// The positive unit of the sums.
    pub scale: Value,
}

impl Sums {
    /// These sums, in units of 1.
    pub fn new(sums: Vec<Value>) -> Sums {
        Sums { first: 0, units: sums.into(), scale: Value::int(1) }
    }

    /// The greatest sum.
    pub fn greatest(&self, piece: Option<&Piece<'_>>) -> Result<Value, Stop> {
        Value::greatest(&self.units, piece)?.times(&self.scale)
    }
}

/// E^c of a sequence.
pub struct Product {
    /// The numerators over one denominator.
    coefficients: Vec<Value>,
    /// The reciprocal of the denominator.
    scale: Value,
    /// The s for which E^c_{l,f} is the coefficient of z^(f − sl).
    stride: usize,
    /// The number n^c of residue classes.
    classes: usize,
    /// The sums that are known, by the first and the last f.
    known: RefCell<BTreeMap<(usize, usize), Sums>>,
}

impl Product {
    /// The product E^0 of no factors.
    pub fn one() -> Product {
        let (coefficients, scale, known) = (vec![Value::int(1)], Value::int(1), RefCell::default());
        Product { coefficients, scale, stride: 1, classes: 1, known }
    }

    /// E^c from E^{c−1} for f < length: E^c_{l,f} = Σ_e E_{l,e} E^{c−1}_{e,f}.
    pub fn next(
        meter: &Meter,
        how: Convolution,
        (sequence, length): (&[Value], usize),
        right: &Product,
    ) -> Result<Product, Stop> {
        let step = right.stride;
        let (coefficients, scale, stride) = if how.printed && how.c > 1 {
            let left = &right.coefficients;
            let product = spread(meter, left, left, step, length)?;
            (product, right.scale.times(&right.scale)?, step.saturating_mul(step))
        } else {
            // Integers are quicker to multiply.
            let over = Value::denominator(sequence)?;
            let left = &sequence[..sequence.len().min(length)];
            let left = left.iter().map(|value| value.times(&over));
            let left = left.collect::<Result<Vec<Value>, Stop>>()?;
            let product = spread(meter, &left, &right.coefficients, step, length)?;
            (product, right.scale.over(&over)?, step.saturating_mul(how.arity))
        };
        let (classes, known) = (how.classes(), RefCell::default());
        Ok(Product { coefficients, scale, stride, classes, known })
    }

    /// Whether the product has too many coefficients or residue classes.
    pub fn is_long(&self) -> bool {
        self.coefficients.len() > MAX_LENGTH || self.classes > MAX_LENGTH
    }

    /// n^c.
    pub fn number_of_classes(&self) -> usize {
        self.classes
    }

    /// All coefficients, in units of the second value.
    pub fn coefficients(&self) -> (&[Value], &Value) {
        (&self.coefficients, &self.scale)
    }

    fn coefficient(&self, l: usize, f: usize) -> Option<&Value> {
        self.coefficients.get(f.checked_sub(l.checked_mul(self.stride)?)?)
    }

    /// E^c_{l,f}.
    pub fn at(&self, l: usize, f: usize) -> Result<Value, Stop> {
        self.coefficient(l, f).map_or(Ok(Value::int(0)), |value| value.times(&self.scale))
    }

    /// Σ_l |E^c_{l,f}|, l = 0, …, ⌊f/n^c⌋, for f from `first` to `last`.
    pub fn sums(
        &self,
        meter: &Meter,
        (first, last): (usize, usize),
        piece: Option<&Piece<'_>>,
    ) -> Result<Sums, Stop> {
        let known = self.known.borrow().get(&(first, last)).cloned();
        if let Some(known) = known.filter(|_| piece.is_none()) {
            return Ok(known);
        }
        let sum = |f: usize| {
            let mut sum = Value::int(0);
            for value in (0..=f / self.classes).filter_map(|l| self.coefficient(l, f)) {
                meter.spend(if piece.is_some() { STEPS_OF_SIGN } else { 0 })?;
                sum.add(value.sign(piece)?.into(), value)?;
            }
            Ok(sum)
        };
        let units = (first..=last).map(sum).collect::<Result<Rc<[Value]>, Stop>>()?;
        let sums = Sums { first, units, scale: self.scale.clone() };
        if piece.is_none() {
            self.known.borrow_mut().insert((first, last), sums.clone());
        }
        Ok(sums)
    }

    /// Σ_s |(R^c)_{r,s}| for every residue class r mod n^c, up to a shift of r that depends on
    /// n, N and c only.
    pub fn classes(&self, meter: &Meter, piece: Option<&Piece<'_>>) -> Result<Sums, Stop> {
        // From here on, f is beyond all coefficients, and those of its class are E^c_{l,f}.
        let beyond = self.coefficients.len().next_multiple_of(self.classes);
        let sums = self.sums(meter, (beyond, beyond + self.classes - 1), piece)?;
        Ok(Sums { first: 0, ..sums })
    }
}

/// The first `length` coefficients of left(z^step)·right(z).
fn spread(
    meter: &Meter,
    left: &[Value],
    right: &[Value],
    step: usize,
    length: usize,
) -> Result<Vec<Value>, Stop> {
    let whole = left.len().saturating_sub(1).saturating_mul(step).saturating_add(right.len());
    let count = whole.min(length).min(MAX_LENGTH + 1);
    if let (Some(left), Some(right)) = (integers(left), integers(right)) {
        meter.spend((left.len() * right.len()) as u64)?;
        if let Some(product) = spread_small(&left, &right, step, count) {
            return Ok(product);
        }
    }
    let mut product = vec![Value::int(0); count];
    for (i, a) in left.iter().enumerate() {
        let from = i.saturating_mul(step).min(count);
        for (sum, b) in product[from..].iter_mut().zip(right) {
            meter.spend(a.steps(b))?;
            sum.add(1, &a.times(b)?)?;
        }
    }
    Ok(product)
}

/// Values as machine integers, if they are.
fn integers(values: &[Value]) -> Option<Vec<i128>> {
    values.iter().map(|value| value.number().ok()?.integer()).collect()
}

/// The same product in machine integers; `None` if they do not suffice.
fn spread_small(left: &[i128], right: &[i128], step: usize, count: usize) -> Option<Vec<Value>> {
    let mut product = vec![0_i128; count];
    for (i, a) in left.iter().enumerate() {
        let from = i.saturating_mul(step).min(count);
        for (sum, b) in product[from..].iter_mut().zip(right) {
            *sum = sum.checked_add(a.checked_mul(*b)?)?;
        }
    }
    Some(product.into_iter().map(|value| Number::from(value).into()).collect())
}
