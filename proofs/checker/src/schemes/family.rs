//! Families: schemes that depend on an index with all integers from one on.

#![warn(clippy::arithmetic_side_effects)]

use super::laurent::Laurent;
use super::scheme::Ring;
use crate::numbers::{Integers, Value, int};
use crate::text::Stop;
use std::cell::OnceCell;
use std::rc::Rc;

/// The indices of a relation that have all integers from one on.
pub struct Every {
    /// These indices.
    pub indices: Vec<Integers>,
    /// Whether schemes may depend on one of them, in the functions of families.
    pub families: bool,
    /// The scheme of the claim, if it depends on one of them.
    pub family: Option<Rc<Family>>,
}

impl Every {
    /// Whether a value depends on one of the indices.
    pub fn concerns(&self, value: &Value) -> bool {
        let known = |name: &str| self.indices.iter().any(|integers| integers.index == name);
        value.all().any(|(monomial, _)| monomial.iter().any(|(name, _)| known(name)))
    }
}

/// A factor f(z)^(αt + β) of a symbol.
pub struct Factor {
    /// f.
    pub terms: Laurent,
    /// α.
    pub slope: i64,
    /// β.
    pub constant: i64,
}

impl Factor {
    /// What stands once in a symbol.
    pub fn once(terms: Laurent) -> Factor {
        Factor { terms, slope: 0, constant: 1 }
    }

    /// αt + β.
    pub fn exponent(&self, integers: &Integers) -> Value {
        integers.polynomial(vec![int(self.constant), int(self.slope)])
    }

    /// Whether f has several terms.
    pub fn has_several(&self) -> bool {
        self.terms.len() > 1
    }

    /// f(1).
    pub fn at_one(&self) -> Result<Value, Stop> {
        Value::total(self.terms.values())
    }

    /// The lowest and the highest power of z in f.
    pub fn ends(&self) -> [i64; 2] {
        let ends = [self.terms.keys().next(), self.terms.keys().next_back()];
        ends.map(|end| end.copied().unwrap_or(0))
    }

    /// The coefficients of f from the lowest power of z to the highest one.
    pub fn dense(&self) -> Vec<Value> {
        let [low, high] = self.ends();
        let at = |k: i64| self.terms.get(&k).cloned().unwrap_or_else(|| Value::int(0));
        (low..=high).map(at).collect()
    }
}

/// The schemes for all values of an index.
pub struct Family {
    /// The index.
    pub integers: Integers,
    /// The arity n of all these schemes.
    pub arity: usize,
    /// The factors of their symbols.
    pub factors: Vec<Factor>,
    /// The name of the scheme, and its parameters, which depend on the index.
    pub of: Ring,
    /// The number of sum rules, once it is known.
    pub sum_rules: OnceCell<Value>,
}
