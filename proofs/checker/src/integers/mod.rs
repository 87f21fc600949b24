//! Functions of an integer: comparisons for all integers from one on (proofs/format/relation.md, Functions of an integer).

#![warn(clippy::arithmetic_side_effects)]

mod angle;
mod blocks;
mod evaluate;
mod function;
mod language;
mod pair;
mod polynomial;
mod quotient;
mod ring;
mod rings;
mod roots;
mod shift;
mod sign;
mod spectrum;
mod weights;

use crate::formulas::{Expr, Scope};
use crate::schemes::Library;
use crate::text::Stop;
use evaluate::{Claim, Evaluator};
use function::Functions;
use ring::Ring;
pub use sign::LEAST;
use std::cell::Cell;

/// What is said of all integers from one on.
pub struct Said<'s> {
    pub library: &'s Library<'s>,
    /// The meanings of names. That of the index is a symbol.
    pub scope: &'s Scope<'s>,
    /// The name of the index, and the first integer.
    pub index: (&'s str, i64),
    /// The reference of the scheme of the claim.
    pub own: Option<&'s str>,
}

impl Said<'_> {
    /// The signs of the differences of a formula and others, each the same for all integers; or why one is not known.
    pub fn signs(&self, left: &Expr, others: &[&Expr]) -> Result<Vec<Result<i8, Stop>>, Stop> {
        self.within(|evaluator| {
            let left = evaluator.value(left)?;
            let sign = |other: &&Expr| evaluator.functions.compare(&left, &evaluator.value(other)?);
            Ok(others.iter().map(sign).collect())
        })
    }

    /// Checks that the scheme of the claim is a ring at each of these valences.
    pub fn has_ring(&self) -> Result<(), Stop> {
        let own = self.own.filter(|own| self.library.is_ring(own));
        let own = own.ok_or(Stop::Integers("the scheme of the claim is no ring"))?;
        self.within(|evaluator| Ring::new(evaluator, own).map(|_| ()))
    }

    fn within<T>(&self, found: impl Fn(&Evaluator<'_>) -> Result<T, Stop>) -> Result<T, Stop> {
        let (index, from) = self.index;
        let (functions, depth) = (Functions::new(self.library.meter, from)?, Cell::new(0));
        let claim = Claim { index, own: self.own, of_ring: rings::of };
        let with = (&functions, self.library);
        found(&Evaluator::new(with, self.scope, Some(claim), &depth))
    }
}
