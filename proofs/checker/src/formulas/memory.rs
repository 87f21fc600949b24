//! What is known of the values of definitions.

use crate::numbers::Value;
use crate::schemes::Ring;
use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

/// The indices of the sums around a formula, the innermost last.
pub type Indices = Vec<(String, Value)>;

/// A cache of the values of definitions.
#[derive(Default)]
pub struct Memory {
    /// The values.
    pub(super) values: RefCell<HashMap<Known, Value>>,
    /// The names that occur in a definition or in those that it leads to.
    pub(super) names: RefCell<HashMap<String, BTreeSet<String>>>,
}

/// A definition and what its value depends on: the values of the names and indices that occur in
/// it, and the scheme, the mask on Z^d or the ring.
pub(super) type Known = (String, Indices, Option<*const ()>, Option<Rc<Ring>>);
