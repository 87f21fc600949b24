//! The constants that lines `constant` have shown, of more residue classes than can be summed.

use crate::convolution::Sequence;
use crate::reject::Stop;
use crate::value::Value;
use std::cell::RefCell;
use std::collections::HashMap;

/// A constant: the rules, whether they are read forwards, and the level.
type Key = (Vec<Vec<Value>>, bool, u32);

/// The greatest sums over the residue classes of products.
#[derive(Default)]
pub struct Constants(RefCell<HashMap<Key, Value>>);

impl Constants {
    /// Forgets all constants.
    pub fn clear(&self) {
        self.0.borrow_mut().clear();
    }

    /// Makes a constant known.
    pub fn insert(&self, of: Sequence<'_>, level: u32, value: Value) {
        self.0.borrow_mut().insert((of.rules().to_vec(), of.forward, level), value);
    }

    /// The constant of a level, if it is known.
    pub fn get(&self, of: Sequence<'_>, level: u32) -> Option<Value> {
        self.0.borrow().get(&(of.rules().to_vec(), of.forward, level)).cloned()
    }

    /// Whether a constant of some level is known to be below 1.
    pub fn contract(&self, of: Sequence<'_>) -> bool {
        let below = |value: &Value| Ok::<_, Stop>(value.compare(&Value::int(1))?.is_lt());
        self.0.borrow().iter().any(|((rules, forward, _), value)| {
            *forward == of.forward && rules == of.rules() && below(value).unwrap_or(false)
        })
    }
}
