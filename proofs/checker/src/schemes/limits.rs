//! What is known of the limits of masks, by lines `limits`.

use crate::numbers::Value;
use crate::radius::Radius;
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

/// The rules of a mask.
type Rules = Vec<Vec<Value>>;

/// Radii by the rules of masks.
#[derive(Default)]
pub struct Limits {
    known: RefCell<HashMap<Rules, Vec<Rc<Radius>>>>,
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

    /// Forgets everything.
    pub fn clear(&self) {
        self.known.borrow_mut().clear();
    }
}
