//! Caches of products of sequences, and of constants.

use super::convolution::{Convolution, MAX_LENGTH, Product, Sequence, Sums};
use crate::numbers::{Meter, Piece, Value};
use crate::text::Stop;
use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::hash::Hash;
use std::rc::Rc;

/// The most products in a cache.
const MAX_PRODUCTS: usize = 1_000;

/// A cache of products.
type Known<K> = RefCell<HashMap<K, Rc<Product>>>;

/// The rules of a constant, whether they are read forwards, and the level.
type Constant = (Vec<Vec<Value>>, bool, u32);

/// The products and constants of a claim. A meter counts the steps of new products.
pub struct Products<'m> {
    meter: &'m Meter,
    /// The convolution, its length and the sequence.
    known: Known<(Convolution, usize, Vec<Value>)>,
    /// The convolution, the address of the rules, and whether they are read forwards.
    of_masks: Known<(Convolution, *const Vec<Value>, bool)>,
    /// The constants that lines `constant` have shown.
    constants: RefCell<HashMap<Constant, Value>>,
}

impl<'m> Products<'m> {
    /// Empty caches.
    pub fn new(meter: &'m Meter) -> Products<'m> {
        let (known, of_masks, constants) = Default::default();
        Products { meter, known, of_masks, constants }
    }

    /// Forgets all products and constants.
    pub fn clear(&self) {
        self.known.borrow_mut().clear();
        self.of_masks.borrow_mut().clear();
        self.constants.borrow_mut().clear();
    }

    /// E^c of a sequence, for f < length.
    pub fn of(
        &self,
        how: Convolution,
        sequence: &[Value],
        length: usize,
    ) -> Result<Rc<Product>, Stop> {
        let key = (how, length, sequence.to_vec());
        if let Some(known) = self.known.borrow().get(&key) {
            return Ok(Rc::clone(known));
        }
        let product = Rc::new(if how.c == 0 {
            Product::one()
        } else {
            let right = self.of(Convolution { c: how.c - 1, ..how }, sequence, length)?;
            Product::next(self.meter, how, (sequence, length), &right)?
        });
        keep(&self.known, key, &product);
        Ok(product)
    }

    /// E^c of the sequence of a mask.
    pub fn of_mask(&self, how: Convolution, of: Sequence<'_>) -> Result<Rc<Product>, Stop> {
        // The address stands for the rules, since the library keeps the schemes of a claim.
        let key = (how, of.rules.as_ptr(), of.forward);
        if let Some(known) = self.of_masks.borrow().get(&key) {
            return Ok(Rc::clone(known));
        }
        let product = self.of(how, &of.values(), MAX_LENGTH + 1)?;
        if product.is_long() {
            return Err(Stop::Capped("the length of a product of sequences"));
        }
        keep(&self.of_masks, key, &product);
        Ok(product)
    }

    /// The class sums of the sequence of a mask at level c.
    pub fn classes(
        &self,
        of: Sequence<'_>,
        c: &Value,
        piece: Option<&Piece<'_>>,
    ) -> Result<Sums, Stop> {
        let c = u32::try_from(c.integer(64)?);
        let c = c.map_err(|_| Stop::Wrong("the level is negative".into()))?;
        let how = Convolution { c, arity: of.rules.len(), printed: false };
        self.of_mask(how, of)?.classes(self.meter, piece)
    }

    /// Whether all class sums of a mask at level c are less than 1. No library needs to keep this mask.
    pub fn are_below_one(
        &self,
        of: Sequence<'_>,
        c: u32,
        piece: Option<&Piece<'_>>,
    ) -> Result<bool, Stop> {
        let (how, values) = (Convolution { c, arity: of.rules.len(), printed: false }, of.values());
        self.meter.spend(values.len() as u64)?;
        let product = self.of(how, &values, MAX_LENGTH + 1)?;
        if product.is_long() {
            return Err(Stop::Capped("the length of a product of sequences"));
        }
        let sums = product.classes(self.meter, piece)?;
        for unit in &*sums.units {
            let sum = unit.times(&sums.scale)?;
            if !sum.compare_on(&Value::int(1), piece)?.is_lt() {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The greatest class sum of a mask that is not read forwards, at level c.
    pub fn greatest(&self, rules: &[Vec<Value>], c: &Value) -> Result<Value, Stop> {
        self.classes(Sequence { rules, forward: false }, c, None)?.greatest(None)
    }

    /// Adds a constant that has been shown.
    pub fn show(&self, of: Sequence<'_>, level: u32, value: Value) {
        self.constants.borrow_mut().insert((of.rules.to_vec(), of.forward, level), value);
    }

    /// The constant of a level, if a line `constant` has shown it.
    pub fn shown(&self, of: Sequence<'_>, level: u32) -> Option<Value> {
        self.constants.borrow().get(&(of.rules.to_vec(), of.forward, level)).cloned()
    }

    /// Whether a constant of some level has been shown to be below 1.
    pub fn contract(&self, of: Sequence<'_>) -> bool {
        self.constants.borrow().iter().any(|((rules, forward, _), value)| {
            let order = value.compare(&Value::int(1));
            rules == of.rules && *forward == of.forward && order.is_ok_and(Ordering::is_lt)
        })
    }
}

fn keep<K: Eq + Hash>(known: &Known<K>, key: K, product: &Rc<Product>) {
    let mut known = known.borrow_mut();
    if known.len() == MAX_PRODUCTS {
        known.clear();
    }
    known.insert(key, Rc::clone(product));
}
