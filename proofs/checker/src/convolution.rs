//! Products of sequences: t(z)·t(z^n)·t(z^(n²))…

use crate::evaluate::{MAX_INTEGER, Scope};
use crate::number::Number;
use crate::reject::Stop;
use crate::scheme::{Library, Scheme};
use crate::value::Value;
use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::hash::Hash;
use std::rc::Rc;

/// The most coefficients of a product, and the most residue classes.
pub const MAX_LENGTH: usize = 1 << 16;

/// About what the sign of a polynomial on a piece costs.
const STEPS_OF_SIGN: u64 = 100;

/// The most products that are kept.
const MAX_PRODUCTS: usize = 1_000;

/// Products by how they are made: the convolution, its length and the sequence.
pub type Products = HashMap<(Convolution, usize, Vec<Value>), Rc<Product>>;

/// Those of a scheme: the convolution, the scheme, whether of its mask, and whether forwards.
pub type OfSchemes = HashMap<(Convolution, *const Scheme, bool, bool), Rc<Product>>;

/// A constant: the rules, whether they are read forwards, and the level.
pub type Large = (Vec<Vec<Value>>, bool, u32);

/// E^c of a sequence.
pub struct Product {
    /// Integers, over one denominator.
    coefficients: Vec<Value>,
    /// One over the denominator.
    scale: Value,
    /// E^c_{l,f} is the coefficient of z^(f − stride·l).
    stride: usize,
    /// n^c.
    classes: usize,
    /// The sums for values of f that are known already.
    known: RefCell<BTreeMap<(usize, usize), Sums>>,
}

/// Sums of absolute values, one for each of some values of f.
#[derive(Clone)]
pub struct Sums {
    /// The first f.
    pub first: usize,
    /// The sums, in units of `scale`.
    pub units: Rc<[Value]>,
    /// A positive number.
    pub scale: Value,
}

impl Sums {
    /// These sums.
    pub fn new(sums: Vec<Value>) -> Sums {
        Sums { first: 0, units: sums.into(), scale: Value::int(1) }
    }

    /// The greatest one.
    pub fn greatest(&self, scope: &Scope<'_>) -> Result<Value, Stop> {
        scope.greatest(&self.units)?.times(&self.scale)
    }
}

/// How sequences are convolved.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Convolution {
    /// c.
    pub c: u32,
    /// n.
    pub arity: usize,
    /// Whether by the recursion E^{c−1}·E^{c−1} in place of E¹·E^{c−1}.
    pub printed: bool,
}

impl Convolution {
    /// n^c.
    pub fn classes(self) -> usize {
        self.arity.saturating_pow(self.c)
    }

    /// E^c of a sequence, for f < length.
    pub fn of(
        self,
        library: &Library<'_>,
        sequence: &[Value],
        length: usize,
    ) -> Result<Rc<Product>, Stop> {
        let Convolution { c, arity, printed } = self;
        let key = (self, length, sequence.to_vec());
        if let Some(known) = library.products.borrow().get(&key) {
            return Ok(Rc::clone(known));
        }
        let (coefficients, scale, stride) = if c == 0 {
            (vec![Value::int(1)], Value::int(1), 1)
        } else {
            // E^c_{l,f} = Σ_e E_{l,e} E^{c−1}_{e,f}: the left factor in z^stride, in integers,
            // which are quicker to multiply.
            let right = Convolution { c: c - 1, ..self }.of(library, sequence, length)?;
            let step = right.stride;
            if printed && c > 1 {
                let left = &right.coefficients;
                let product = spread(library, left, left, step, length)?;
                (product, right.scale.times(&right.scale)?, step.saturating_mul(step))
            } else {
                let over = Value::denominator(sequence)?;
                let left = &sequence[..sequence.len().min(length)];
                let left = left.iter().map(|value| value.times(&over));
                let left = left.collect::<Result<Vec<Value>, Stop>>()?;
                let product = spread(library, &left, &right.coefficients, step, length)?;
                (product, right.scale.over(&over)?, step.saturating_mul(arity))
            }
        };
        let (classes, known) = (self.classes(), RefCell::default());
        let product = Rc::new(Product { coefficients, scale, stride, classes, known });
        keep(&mut library.products.borrow_mut(), key, &product);
        Ok(product)
    }

    /// E^c of the mask (`a`) or the difference mask (`b`) of a scheme, read backwards or
    /// forwards.
    pub fn of_scheme(
        self,
        library: &Library<'_>,
        scheme: &Scheme,
        of: &str,
        forward: bool,
    ) -> Result<Rc<Product>, Stop> {
        // A claim's schemes stay where they are until the next claim.
        let key = (self, std::ptr::from_ref(scheme), of == "a", forward);
        if let Some(known) = library.of_schemes.borrow().get(&key) {
            return Ok(Rc::clone(known));
        }
        // t_{nu+β} = r_{β,N−1−u}, or r_{β,u} forwards.
        let rules = if of == "a" { &scheme.mask } else { &scheme.difference };
        let last = scheme.width() - 1;
        let columns = (0..=last).map(|u| if forward { u } else { last - u });
        let sequence = columns.flat_map(|column| rules.iter().map(move |row| row[column].clone()));
        let product = self.of(library, &sequence.collect::<Vec<Value>>(), MAX_LENGTH + 1)?;
        if product.coefficients.len() > MAX_LENGTH || product.classes > MAX_LENGTH {
            return Err(Stop::Capped("the length of a product of sequences"));
        }
        keep(&mut library.of_schemes.borrow_mut(), key, &product);
        Ok(product)
    }
}

fn keep<K: Eq + Hash>(known: &mut HashMap<K, Rc<Product>>, key: K, product: &Rc<Product>) {
    if known.len() == MAX_PRODUCTS {
        known.clear();
    }
    known.insert(key, Rc::clone(product));
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
    let count = whole.min(length).min(MAX_LENGTH + 1);
    if let Some(product) = spread_small(left, right, step, count) {
        library.spend((left.len() * right.len()) as u64)?;
        return Ok(product);
    }
    let mut product = vec![Value::int(0); count];
    for (i, a) in left.iter().enumerate() {
        let from = i.saturating_mul(step).min(count);
        for (sum, b) in product[from..].iter_mut().zip(right) {
            library.spend(a.cost(b))?;
            sum.add(1, &a.times(b)?)?;
        }
    }
    Ok(product)
}

/// The same with machine integers, which most products consist of; `None` if one is none.
fn spread_small(left: &[Value], right: &[Value], step: usize, count: usize) -> Option<Vec<Value>> {
    let integer = |value: &Value| value.number().ok()?.integer();
    let right: Vec<i128> = right.iter().map(integer).collect::<Option<_>>()?;
    let mut product = vec![0_i128; count];
    for (i, a) in left.iter().enumerate() {
        let (from, a) = (i.saturating_mul(step).min(count), integer(a)?);
        for (sum, b) in product[from..].iter_mut().zip(&right) {
            *sum = sum.checked_add(a.checked_mul(*b)?)?;
        }
    }
    Some(product.into_iter().map(|value| Number::from(value).into()).collect())
}

impl Product {
    fn coefficient(&self, l: usize, f: usize) -> Option<&Value> {
        self.coefficients.get(f.checked_sub(l.checked_mul(self.stride)?)?)
    }

    /// E^c_{l,f}.
    pub fn at(&self, l: usize, f: usize) -> Result<Value, Stop> {
        self.coefficient(l, f).map_or(Ok(Value::int(0)), |value| value.times(&self.scale))
    }

    /// Σ_l |E^c_{l,f}|, l = 0, …, ⌊f/n^c⌋, for f from `first` to `last`.
    pub fn sums(&self, scope: &Scope<'_>, first: usize, last: usize) -> Result<Sums, Stop> {
        let piece = scope.piece.as_ref();
        if let Some(known) = self.known.borrow().get(&(first, last)).filter(|_| piece.is_none()) {
            return Ok(known.clone());
        }
        let sum = |f: usize| {
            let mut sum = Value::int(0);
            for value in (0..=f / self.classes).filter_map(|l| self.coefficient(l, f)) {
                scope.library.spend(if piece.is_some() { STEPS_OF_SIGN } else { 0 })?;
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
}

/// Σ_s |(R^c)_{r,s}| for every residue class r mod n^c, up to a shift of r that depends on
/// n, N and c only.
pub fn classes(
    scope: &Scope<'_>,
    scheme: &Scheme,
    of: &str,
    forward: bool,
    c: &Value,
) -> Result<Sums, Stop> {
    let c = u32::try_from(c.integer(64)?).map_err(|_| Stop::Wrong("a negative level".into()))?;
    let convolution = Convolution { c, arity: scheme.arity(), printed: false };
    let product = convolution.of_scheme(scope.library, scheme, of, forward)?;
    // Where f is beyond all coefficients, those of its class are the E^c_{l,f}.
    let beyond = product.coefficients.len().next_multiple_of(product.classes);
    Ok(Sums { first: 0, ..product.sums(scope, beyond, beyond + product.classes - 1)? })
}

/// The greatest of these sums, if it is one that a line `constant` has shown.
pub fn large(
    scope: &Scope<'_>,
    scheme: &Scheme,
    of: &str,
    forward: bool,
    c: &Value,
) -> Option<Value> {
    let rules = if of == "a" { &scheme.mask } else { &scheme.difference };
    let c = u32::try_from(c.integer(MAX_INTEGER).ok()?).ok()?;
    scope.library.large.borrow().get(&(rules.clone(), forward, c)).cloned()
}
