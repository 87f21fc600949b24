//! Products of powers of named variables.

use std::sync::Arc;

/// A product of powers of variables, as pairs of name and exponent > 0 in the order of the
/// names; no pairs for 1. The pairs are shared by reference counting, as monomials are
/// copied more often than they are made.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Monomial(Arc<[(Arc<str>, u32)]>);

impl Monomial {
    pub(super) fn one() -> Monomial {
        Monomial(Arc::from([]))
    }

    pub(super) fn variable(name: &str) -> Monomial {
        Monomial(Arc::from([(Arc::from(name), 1)]))
    }

    /// The product of these powers, in the order of their names.
    pub(super) fn of(powers: Vec<(Arc<str>, u32)>) -> Monomial {
        Monomial(powers.into())
    }

    pub(super) fn is_one(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn powers(&self) -> &[(Arc<str>, u32)] {
        &self.0
    }

    /// The exponent of `variable`, 0 for the monomial 1; `None` when another variable
    /// occurs.
    pub(super) fn only(&self, variable: &str) -> Option<u32> {
        match self.powers() {
            [] => Some(0),
            [(name, exponent)] if **name == *variable => Some(*exponent),
            _ => None,
        }
    }

    /// The sum of the exponents.
    pub(super) fn degree(&self) -> u64 {
        self.powers().iter().map(|&(_, exponent)| u64::from(exponent)).sum()
    }

    /// self · other.
    ///
    /// # Panics
    /// When an exponent is 2^32 or more.
    pub(super) fn times(&self, other: &Monomial) -> Monomial {
        if self.is_one() || other.is_one() {
            return if self.is_one() { other.clone() } else { self.clone() };
        }
        let mut product = self.0.to_vec();
        for (variable, exponent) in other.powers() {
            match product.binary_search_by(|(name, _)| name.cmp(variable)) {
                Ok(at) => {
                    let power = &mut product[at].1;
                    *power = power.checked_add(*exponent).expect("an exponent below 2^32");
                }
                Err(at) => product.insert(at, (Arc::clone(variable), *exponent)),
            }
        }
        Monomial(product.into())
    }
}
