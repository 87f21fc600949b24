//! The limit between the ends of a cell, and the differences on which it depends.

use crate::exact::Rational;
use crate::limit::error::{LimitError, MAX_WINDOW};
use crate::limit::functional::{Functional, rule_at};
use crate::limit::parameter::next_digit;
use crate::limit::value::Limit;
use crate::scheme::Rules;

/// The distances of P^∞ from its chord from φ to φ + 1 at φ + α/n, α = 1, …, n − 1, as functionals
/// of Δ.
pub(super) struct Middles {
    /// φ.
    pub(super) part: Rational,
    /// ⌊nφ⌋.
    pub(super) carry: i64,
    /// {nφ}.
    pub(super) next: Rational,
    pub(super) functionals: Vec<Functional>,
}

/// The [`Middles`] for φ = {s} and for all φ = {n^m s}, m = 1, 2, …, each φ once.
pub(super) fn middles(limit: &Limit, shift: &Rational) -> Result<Vec<Middles>, LimitError> {
    let arity = limit.mask().arity();
    let mut part = shift.fract();
    let mut all: Vec<Middles> = Vec::new();
    while all.iter().all(|known| known.part != part) {
        let left = limit.at(&part)?;
        let right = left.shifted(1);
        let middle = |alpha: usize| {
            let u = Rational::new(alpha, arity);
            let value = limit.at(&(&part + &u))?;
            let off = value.plus(&(&u - Rational::one()), &left).plus(&-u, &right);
            Ok(off.on_differences().expect("both are affine combinations"))
        };
        let functionals = (1..arity).map(middle).collect::<Result<_, LimitError>>()?;
        let mut next = part.clone();
        let carry = next_digit(&mut next, arity).expect("a digit is below the arity");
        all.push(Middles { part, carry, next: next.clone(), functionals });
        part = next;
    }
    Ok(all)
}

/// The least window that contains 0 and the supports of `functionals`, and is closed
/// under splits: the Δ^{M+1} in the windows of all parts are determined by the Δ^M in the
/// window.
pub(super) fn window<'a>(
    difference: &Rules,
    functionals: impl Iterator<Item = &'a Functional>,
    carry: i64,
) -> Result<(i64, i64), LimitError> {
    let ends = functionals.filter_map(Functional::support);
    let (mut first, mut last) =
        ends.fold((0, 0), |(first, last), (from, to)| (first.min(from), last.max(to)));
    let parts = i64::try_from(difference.arity()).expect("the arity is capped");
    loop {
        let size = usize::try_from(last - first + 1).unwrap_or(usize::MAX);
        if size > MAX_WINDOW {
            return Err(LimitError::Window(size));
        }
        let (mut from, mut to) = (first, last);
        for i in first..last + parts + carry {
            let used = rule_at(difference, i).filter(|(_, c)| !c.is_zero());
            for (column, _) in used {
                (from, to) = (from.min(column), to.max(column));
            }
        }
        if (from, to) == (first, last) {
            return Ok((first, last));
        }
        (first, last) = (from, to);
    }
}
