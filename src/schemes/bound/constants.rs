//! The constants of one scheme, each computed at most once.

use super::branch::{JointSearch, PowerSearch};
use super::budget::Budget;
use super::power::{ClassCap, Order};
use crate::exact::Rational;
use crate::scheme::{Mask, Rules};
use std::collections::BTreeMap;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The operator whose power has the constant as its norm.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Operator {
    /// The difference operator: T_c.
    Difference,
    /// The scheme itself: Λ_c.
    Scheme,
}

/// How the suprema in the constant of a tensor product are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Suprema {
    /// T_c·Λ_c, each over its own residue class: the norm of the tensor product.
    Independent,
    /// One supremum of the product over a common residue class. It does not bound the
    /// differences.
    Joint,
}

type Key = (Option<Operator>, u32, Order);

/// A mask with its constants T_c, Λ_c and joint constants. Each is computed when it is
/// first needed, and then kept, for all threads.
///
/// ```
/// use subcert::bound::{Constants, Operator, Order, Suprema};
/// use subcert::exact::Rational;
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("quinary-three-point")?;
/// let constants = Constants::new(scheme.masks()[0].clone());
/// let t = constants.norm(Operator::Difference, 1, Order::Adjoint)?;
/// assert_eq!(t, Rational::new(17, 25));
/// let tensor = constants.tensor(1, Order::Adjoint, Suprema::Independent)?;
/// assert_eq!(tensor, Rational::new(17 * 31, 625));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Constants {
    mask: Mask,
    difference: Rules,
    known: Mutex<BTreeMap<Key, Rational>>,
    searches: Mutex<BTreeMap<(Operator, Order), PowerSearch>>,
    budget: Budget,
    extreme: bool,
}

impl Constants {
    /// The constants of `mask`.
    #[must_use]
    pub fn new(mask: Mask) -> Constants {
        let difference = mask.difference();
        let (known, searches) = Default::default();
        Constants { mask, difference, known, searches, budget: Budget::unlimited(), extreme: false }
    }

    /// These constants with a budget in products of words, which other computations may
    /// share.
    #[must_use]
    pub fn with_budget(self, budget: Budget) -> Constants {
        Constants { budget, ..self }
    }

    /// These constants with extreme rows, as in
    /// [`PowerSearch::with_extreme_rows`](super::PowerSearch::with_extreme_rows).
    #[must_use]
    pub fn with_extreme_rows(self) -> Constants {
        Constants { extreme: true, ..self }
    }

    /// The mask.
    #[must_use]
    pub fn mask(&self) -> &Mask {
        &self.mask
    }

    /// Its difference mask.
    #[must_use]
    pub fn difference(&self) -> &Rules {
        &self.difference
    }

    /// T_c or Λ_c; 1 for c = 0.
    ///
    /// # Errors
    /// As [`power_norm`](super::power_norm).
    pub fn norm(&self, operator: Operator, c: u32, order: Order) -> Result<Rational, ClassCap> {
        let rules = match operator {
            Operator::Difference => &self.difference,
            Operator::Scheme => self.mask.rules(),
        };
        if c == 1 {
            // The rows of one level stand there: no search is needed.
            return Ok(greatest_sum(rules));
        }
        self.once((Some(operator), c, order), || {
            let mut searches = locked(&self.searches);
            let search = searches.entry((operator, order));
            let new = || {
                let search = PowerSearch::new(rules, order).with_budget(self.budget.clone());
                if self.extreme { search.with_extreme_rows() } else { search }
            };
            Ok(search.or_insert_with(new).norm(c)?.value)
        })
    }

    /// The constant of the tensor product of the scheme with itself, along one
    /// direction and c levels.
    ///
    /// # Errors
    /// As [`power_norm`](super::power_norm).
    pub fn tensor(&self, c: u32, order: Order, suprema: Suprema) -> Result<Rational, ClassCap> {
        match suprema {
            Suprema::Independent => Ok(self.norm(Operator::Difference, c, order)?
                * self.norm(Operator::Scheme, c, order)?),
            Suprema::Joint => self.once((None, c, order), || {
                let search = JointSearch::new(&self.difference, self.mask.rules(), order);
                Ok(search.with_budget(self.budget.clone()).norm(c)?.value)
            }),
        }
    }

    /// The constant of the tensor product of this scheme with `other`, along the
    /// direction of this scheme and over c levels: T_c of this scheme times Λ_c of
    /// `other`.
    ///
    /// # Errors
    /// As [`power_norm`](super::power_norm).
    pub fn tensor_with(&self, other: &Constants, c: u32) -> Result<Rational, ClassCap> {
        Ok(self.norm(Operator::Difference, c, Order::Adjoint)?
            * other.norm(Operator::Scheme, c, Order::Adjoint)?)
    }

    fn once(
        &self,
        key: Key,
        compute: impl FnOnce() -> Result<Rational, ClassCap>,
    ) -> Result<Rational, ClassCap> {
        let known = locked(&self.known).get(&key).cloned();
        if let Some(value) = known {
            return Ok(value);
        }
        let value = compute()?;
        locked(&self.known).insert(key, value.clone());
        Ok(value)
    }
}

/// What is known, also after a stop in another thread.
fn locked<T>(known: &Mutex<T>) -> MutexGuard<'_, T> {
    known.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The greatest sum of the absolute values of a row.
fn greatest_sum(rules: &Rules) -> Rational {
    let sum = |row: &Vec<Rational>| row.iter().fold(Rational::zero(), |sum, x| sum + x.abs());
    rules.rows().iter().map(sum).max().unwrap_or_else(Rational::zero)
}
