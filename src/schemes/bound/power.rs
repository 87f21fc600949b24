//! The powers of an operator: the order in which rules are read, norms, and caps.

use crate::cap::Cap;
use crate::exact::{Integer, Rational, Scalar};
use crate::scheme::Rules;

/// The greatest number n^c of residue classes that are visited one by one: 2^24.
pub const MAX_CLASSES: u64 = 1 << 24;

/// The greatest number of levels of a search.
pub const MAX_LEVELS: u32 = 256;

/// The cap on the products of words that a search computes, for one norm or for all norms
/// that share a [`Budget`](super::Budget).
pub const MAX_WORK: u64 = 1 << 33;

/// The order in which a difference mask is read as a sequence.
///
/// For c = 1 both orders give the same norms; for c ≥ 2 in general they do not. Only the
/// adjoint order bounds the differences of a subdivided polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Order {
    /// t_{nu+β} = b_{β,N−1−u}: the rows of the operator, the sound order.
    Adjoint,
    /// t_{nu+β} = b_{β,u}, as printed in some papers.
    Forward,
}

/// A norm, and the row that attains it.
#[derive(Clone, Debug, PartialEq)]
pub struct PowerNorm {
    /// max over r of Σ_s |(Rᶜ)_{r,s}|.
    pub value: Rational,
    /// The least row r of 0, …, n^c − 1 that attains it.
    pub class: Integer,
}

/// A norm that is not found within the caps on residue classes, levels and work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the largest of {arity}^{levels} row sums is out of reach: every row is visited up to \
     {MAX_CLASSES}, and branch and bound goes up to {MAX_LEVELS} levels and to {work} products \
     of words, for all constants that are asked for together; take a smaller number of levels"
)]
pub struct ClassCap {
    /// The arity n.
    pub arity: usize,
    /// The number c of levels.
    pub levels: u32,
    /// The cap on products of words.
    pub work: u64,
}

impl ClassCap {
    /// The cap on levels or on work that a search is beyond.
    #[must_use]
    pub fn cap(&self) -> Cap {
        let ClassCap { arity, levels, work } = self;
        if *levels > MAX_LEVELS {
            return Cap::new(format!("the number {levels} of levels"), MAX_LEVELS.into());
        }
        let what = format!("the work for the largest of {arity}^{levels} row sums");
        Cap::new(what, *work)
    }

    /// Checks that the residue classes mod `arity`^`levels` are few enough to visit all.
    ///
    /// # Errors
    /// When there are more than 2^24 of them.
    pub fn check(arity: usize, levels: u32) -> Result<(), ClassCap> {
        let classes = (arity as u64).checked_pow(levels);
        match classes.filter(|&count| count <= MAX_CLASSES) {
            Some(_) => Ok(()),
            None => Err(ClassCap { arity, levels, work: MAX_WORK }),
        }
    }
}

/// The rules, each reversed for the forward order.
pub(super) fn oriented<S: Scalar>(rules: &Rules<S>, order: Order) -> Rules<S> {
    match order {
        Order::Adjoint => rules.clone(),
        Order::Forward => rules.reversed(),
    }
}
