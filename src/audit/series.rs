//! Convolutions of sequences that claims give by formulas.

use super::options::Options;
use super::shape::index;
use crate::bound::{Recursion, convolution_coefficient, convolution_window};
use crate::exact::{Rational, common_conductor};
use crate::formula::{Call, CallError, Context, FormulaErrorKind, Lookup, Value};
use std::cell::RefCell;

/// The longest sequence.
const MAX_LENGTH: i64 = 1_000;

/// The most convolutions of a norm.
const MAX_CONVOLUTIONS: i64 = 16;

/// The most convolutions of which single coefficients are summed term by term.
const MAX_COEFFICIENT_CONVOLUTIONS: i64 = 3;

/// The most products of one convolution: the last index times the length.
const MAX_PRODUCTS: usize = 1_000_000;

/// The index of a sequence when the call does not name it.
const INDEX: &str = "q";

/// Norms of sequences by what they depend on, each computed once.
pub(super) type Norms<V> = RefCell<Vec<(Key<V>, V)>>;

/// A sequence, and the arity, number of convolutions, last index and recursion.
type Key<V> = (Vec<V>, usize, u32, usize, Recursion);

/// The value of a function of a sequence; `None` when `call` is another function.
pub(super) fn call<V: Value + PartialEq>(
    call: &Call<'_, V>,
    context: &dyn Context<V>,
    options: &mut Options<'_>,
    known: &Norms<V>,
) -> Option<Result<V, CallError>> {
    Some(match (call.function, call.arguments) {
        ("convolved", [c, n, length, l, f]) => {
            coefficient(call, context, options, [c, n, length, l, f])
        }
        ("convolution_norm", [c, n, length, last]) => {
            norm(call, context, options, [c, n, length, last], known)
        }
        _ => return None,
    })
}

fn coefficient<V: Value>(
    call: &Call<'_, V>,
    context: &dyn Context<V>,
    options: &mut Options<'_>,
    [c, n, length, l, f]: [&V; 5],
) -> Result<V, CallError> {
    let c = within("the number of convolutions", c, 1..=MAX_COEFFICIENT_CONVOLUTIONS)?;
    let n = within("the arity", n, 2..=16)?;
    let (l, f) = (index("the index l", l)?, index("the index f", f)?);
    let recursion = options.recursion()?;
    let terms = sequence(call, context, options, length)?;
    Ok(convolution_coefficient(&terms, n, narrow(c), l, f, recursion))
}

fn norm<V: Value + PartialEq>(
    call: &Call<'_, V>,
    context: &dyn Context<V>,
    options: &mut Options<'_>,
    [c, n, length, last]: [&V; 4],
    known: &Norms<V>,
) -> Result<V, CallError> {
    let c = within("the number of convolutions", c, 1..=MAX_CONVOLUTIONS)?;
    let n = within("the arity", n, 2..=16)?;
    let last = within("the last index", last, 0..=1_000_000)?;
    let recursion = options.recursion()?;
    let terms = sequence(call, context, options, length)?;
    // By the printed recursion both factors grow.
    let factor = match recursion {
        Recursion::Derived => terms.len(),
        Recursion::Printed => last + 1,
    };
    if (last + 1).saturating_mul(factor) > MAX_PRODUCTS {
        let message = format!(
            "the last index times the length of the sequences is at most {MAX_PRODUCTS} here"
        );
        return Err(CallError::Misuse(message));
    }
    let key = (terms, n, narrow(c), last, recursion);
    if let Some((_, value)) = known.borrow().iter().find(|(other, _)| *other == key) {
        return Ok(value.clone());
    }
    let value = largest_sum(&convolution_window(&key.0, n, narrow(c), last, recursion))?;
    known.borrow_mut().push((key, value.clone()));
    Ok(value)
}

/// The largest sum of absolute values of a row.
fn largest_sum<V: Value>(rows: &[Vec<V>]) -> Result<V, CallError> {
    let symbolic = || {
        let what = "an absolute value has no value while a parameter is symbolic";
        CallError::Inner(FormulaErrorKind::Unsupported(what))
    };
    rows.iter().try_fold(V::zero(), |best, row| {
        let sum = row.iter().try_fold(V::zero(), |sum, term| {
            Ok::<V, CallError>(sum.plus(&term.absolute().ok_or_else(symbolic)?))
        })?;
        best.larger(&sum).ok_or_else(symbolic)
    })
}

/// The sequence that the option `sequence` names, at the indices 0, …, length − 1.
fn sequence<V: Value>(
    call: &Call<'_, V>,
    context: &dyn Context<V>,
    options: &mut Options<'_>,
    length: &V,
) -> Result<Vec<V>, CallError> {
    let length = within("the length of a sequence", length, 1..=MAX_LENGTH)?;
    let name = options.take("sequence").ok_or_else(|| {
        let message = "name the definition that gives the sequence: `sequence = g`";
        CallError::Misuse(message.to_owned())
    })?;
    let at = options.take("index").unwrap_or_else(|| INDEX.to_owned());
    let mut terms: Vec<V> = Vec::with_capacity(length);
    let mut conductor = 1;
    for q in 0..length {
        let mut indices = vec![(at.clone(), V::from_rational(&Rational::from(q)))];
        indices.extend_from_slice(call.indices);
        let term = match context.name(&name, &indices)? {
            Lookup::Found(term) => term,
            Lookup::Unstated => return Err(CallError::Inner(FormulaErrorKind::Unstated(name))),
            Lookup::Unknown => {
                let known = context.names();
                return Err(CallError::Inner(FormulaErrorKind::UnknownName { name, known }));
            }
        };
        conductor = common_conductor(conductor, term.conductor())
            .map_err(|error| CallError::Inner(error.into()))?;
        terms.push(term);
    }
    Ok(terms)
}

/// An integer argument that has to be in `range`.
fn within<V: Value>(
    what: &'static str,
    value: &V,
    range: std::ops::RangeInclusive<i64>,
) -> Result<usize, CallError> {
    let integer = index(what, value)?;
    let found = usize::try_from(integer).ok().filter(|_| range.contains(&integer));
    found.ok_or_else(|| {
        let (first, last) = (range.start(), range.end());
        CallError::Misuse(format!("{what} is from {first} to {last}, and not {integer}"))
    })
}

fn narrow(c: usize) -> u32 {
    u32::try_from(c).expect("capped")
}
