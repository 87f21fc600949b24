//! The products of sequences that are known.

use crate::convolution::{Convolution, MAX_LENGTH, Product, Sequence, Sums};
use crate::meter::Meter;
use crate::piece::Piece;
use crate::reject::Stop;
use crate::scheme::{Part, Scheme};
use crate::value::Value;
use std::cell::RefCell;
use std::collections::HashMap;
use std::hash::Hash;
use std::rc::Rc;

/// The most products that are kept.
const MAX_PRODUCTS: usize = 1_000;

/// Products by what they are made of.
type Known<K> = RefCell<HashMap<K, Rc<Product>>>;

/// The products of a claim. A meter counts the steps of new ones.
pub struct Products<'m> {
    meter: &'m Meter,
    /// The convolution, its length and the sequence.
    known: Known<(Convolution, usize, Vec<Value>)>,
    /// The convolution, the scheme, which of its masks, and whether it is read forwards.
    of_schemes: Known<(Convolution, *const Scheme, Part, bool)>,
}

impl<'m> Products<'m> {
    /// No products.
    pub fn new(meter: &'m Meter) -> Products<'m> {
        Products { meter, known: RefCell::default(), of_schemes: RefCell::default() }
    }

    /// Forgets all products.
    pub fn clear(&self) {
        self.known.borrow_mut().clear();
        self.of_schemes.borrow_mut().clear();
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

    /// E^c of the sequence of a scheme.
    pub fn of_scheme(&self, how: Convolution, of: Sequence<'_>) -> Result<Rc<Product>, Stop> {
        // The address stands for the scheme, since the library keeps the schemes of a claim.
        let key = (how, std::ptr::from_ref(of.scheme), of.part, of.forward);
        if let Some(known) = self.of_schemes.borrow().get(&key) {
            return Ok(Rc::clone(known));
        }
        let product = self.of(how, &of.values(), MAX_LENGTH + 1)?;
        if product.is_long() {
            return Err(Stop::Capped("the length of a product of sequences"));
        }
        keep(&self.of_schemes, key, &product);
        Ok(product)
    }

    /// The class sums of the sequence of a scheme at level c.
    pub fn classes(
        &self,
        of: Sequence<'_>,
        c: &Value,
        piece: Option<&Piece>,
    ) -> Result<Sums, Stop> {
        let c = u32::try_from(c.integer(64)?);
        let c = c.map_err(|_| Stop::Wrong("a negative level".into()))?;
        let how = Convolution { c, arity: of.scheme.arity(), printed: false };
        self.of_scheme(how, of)?.classes(self.meter, piece)
    }
}

fn keep<K: Eq + Hash>(known: &Known<K>, key: K, product: &Rc<Product>) {
    let mut known = known.borrow_mut();
    if known.len() == MAX_PRODUCTS {
        known.clear();
    }
    known.insert(key, Rc::clone(product));
}
