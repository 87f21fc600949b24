//! What is known of the limits of masks, by lines `limits`, and of the independence of their shifts.

use crate::numbers::{Q, Value};
use crate::radius::Radius;
use crate::text::Stop;
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

/// The rules of a mask.
type Rules = Vec<Vec<Value>>;

/// The coefficients of a symbol, which are polynomials, and its arity.
type Symbol = (Vec<Vec<Q>>, usize);

/// Polynomials in a parameter, one of which is 0 where shifts are dependent, and whether they are so at each of its roots.
pub type Conditions = Vec<(Vec<Q>, bool)>;

/// Radii by the rules of masks, and conditions by symbols.
#[derive(Default)]
pub struct Limits {
    known: RefCell<HashMap<Rules, Vec<Rc<Radius>>>>,
    conditions: RefCell<HashMap<Symbol, Rc<Conditions>>>,
}

impl Limits {
    /// Adds what is shown of a mask.
    pub fn show(&self, mask: &[Vec<Value>], radius: Radius) {
        self.known.borrow_mut().entry(mask.to_vec()).or_default().push(Rc::new(radius));
    }

    /// What is known of a mask.
    pub fn of(&self, mask: &[Vec<Value>]) -> Vec<Rc<Radius>> {
        self.known.borrow().get(mask).cloned().unwrap_or_default()
    }

    /// The conditions for dependent shifts of a symbol, which are found once.
    pub fn conditions(
        &self,
        symbol: Symbol,
        find: impl FnOnce(&Symbol) -> Result<Conditions, Stop>,
    ) -> Result<Rc<Conditions>, Stop> {
        let known = self.conditions.borrow().get(&symbol).cloned();
        if let Some(known) = known {
            return Ok(known);
        }
        let found = Rc::new(find(&symbol)?);
        self.conditions.borrow_mut().insert(symbol, Rc::clone(&found));
        Ok(found)
    }

    /// Forgets everything.
    pub fn clear(&self) {
        self.known.borrow_mut().clear();
        self.conditions.borrow_mut().clear();
    }
}
