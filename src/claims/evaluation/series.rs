//! Convolutions of sequences that claims define by formulas.

use crate::bound::{Recursion, Suprema, convolution_coefficient, convolution_window};
use crate::cap::Cap;
use crate::evaluation::arguments::{index, narrow, place, within};
use crate::evaluation::options::Options;
use crate::evaluation::trace::NotedNorm;
use crate::exact::{Rational, common_conductor};
use crate::formula::{Call, CallError, Context, FormulaErrorKind, Lookup, SEQUENCE_INDEX, Value};
use std::cell::RefCell;

/// The longest sequence.
const MAX_LENGTH: i64 = 1_000;

/// The greatest number of convolutions of a norm.
const MAX_CONVOLUTIONS: i64 = 16;

/// The greatest number of convolutions of which single coefficients are summed term by term.
const MAX_COEFFICIENT_CONVOLUTIONS: i64 = 3;

/// The greatest number of products of one convolution: the last index plus 1, times the length.
const MAX_PRODUCTS: usize = 1_000_000;

/// The sums Σ_l |E^c_{l,f}| of all windows that were computed, each with its window.
pub(crate) struct Norms<V> {
    known: RefCell<Vec<(Window<V>, Vec<V>)>>,
}

impl<V> Default for Norms<V> {
    fn default() -> Norms<V> {
        Norms { known: RefCell::default() }
    }
}

/// The arguments of [`convolution_window`].
#[derive(PartialEq)]
pub(crate) struct Window<V> {
    terms: Vec<V>,
    arity: usize,
    c: u32,
    last: usize,
    recursion: Recursion,
}

/// A function that receives the norm of a single sequence.
pub(crate) type Note<'n, V> = &'n dyn Fn(NotedNorm<V>);

/// The value of a function of sequences; `None` when `call` is another function. `note`, if given,
/// receives the norm of each single sequence, but for those within sums.
pub(crate) fn call<V: Value + PartialEq>(
    call: &Call<'_, V>,
    context: &dyn Context<V>,
    options: &mut Options<'_>,
    known: &Norms<V>,
    note: Option<Note<'_, V>>,
) -> Option<Result<V, CallError>> {
    Some(match (call.function, call.arguments) {
        ("convolved", [c, n, length, l, f]) => {
            coefficient(call, context, options, [c, n, length, l, f])
        }
        ("convolution_norm", [c, n, length, last]) => {
            norm(call, context, options, [c, n, length, last], (known, note))
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
    let (l, f) = (place("the index l", l)?, index("the index f", f)?);
    let recursion = options.recursion()?;
    let names = Names::of(options)?;
    let terms = names.sequence(&names.first, call, context, length)?;
    Ok(convolution_coefficient(&terms, n, narrow(c), l, f, recursion))
}

fn norm<V: Value + PartialEq>(
    call: &Call<'_, V>,
    context: &dyn Context<V>,
    options: &mut Options<'_>,
    [c, n, length, last]: [&V; 4],
    (known, note): (&Norms<V>, Option<Note<'_, V>>),
) -> Result<V, CallError> {
    let c = within("the number of convolutions", c, 1..=MAX_CONVOLUTIONS)?;
    let n = within("the arity", n, 2..=16)?;
    let last = within("the last index", last, 0..=1_000_000)?;
    let (recursion, suprema) = (options.recursion()?, options.suprema()?);
    let names = Names::of(options)?;
    let sums = |name: &str| {
        let terms = names.sequence(name, call, context, length)?;
        let window = Window { terms, arity: n, c: narrow(c), last, recursion };
        let sums = window.absolute_sums(known)?;
        if let Some(note) = note.filter(|_| call.indices.is_empty()) {
            let value = largest(&sums)?;
            let at = sums.iter().position(|sum| *sum == value).unwrap_or(0);
            let printed =
                if recursion == Recursion::Printed { ", recursion = printed" } else { "" };
            let index = match &names.index[..] {
                SEQUENCE_INDEX => String::new(),
                other => format!(", index = {other}"),
            };
            let formula = format!(
                "convolution_norm({c}, {n}, {length}, {last}, sequence = {name}{index}{printed})"
            );
            note(NotedNorm { formula, index: last + 1 - sums.len() + at, value });
        }
        Ok(sums)
    };
    let first = sums(&names.first)?;
    let Some(second) = &names.second else { return largest(&first) };
    let second = sums(second)?;
    match suprema {
        Suprema::Independent => Ok(largest(&first)?.times(&largest(&second)?)),
        Suprema::Joint => {
            let products: Vec<V> = first.iter().zip(&second).map(|(a, b)| a.times(b)).collect();
            largest(&products)
        }
    }
}

/// The greatest of nonnegative numbers.
fn largest<V: Value>(values: &[V]) -> Result<V, CallError> {
    values.iter().try_fold(V::zero(), |best, value| best.larger(value).ok_or_else(symbolic))
}

fn symbolic() -> CallError {
    let what = "an absolute value has no value while a parameter is symbolic";
    CallError::Inner(FormulaErrorKind::Unsupported(what))
}

impl<V: Value + PartialEq> Window<V> {
    /// Σ_l |E^c_{l,f}| for each f of the window.
    fn absolute_sums(self, known: &Norms<V>) -> Result<Vec<V>, CallError> {
        let mut known = known.known.borrow_mut();
        if let Some((_, sums)) = known.iter().find(|(window, _)| *window == self) {
            return Ok(sums.clone());
        }
        // In the printed recursion both factors may be as long as the window.
        let factor = match self.recursion {
            Recursion::Derived => self.terms.len(),
            Recursion::Printed => self.last + 1,
        };
        if (self.last + 1).saturating_mul(factor) > MAX_PRODUCTS {
            let what = "the last index times the length of the sequences";
            return Err(CallError::BeyondCap(Cap::new(what, MAX_PRODUCTS as u64)));
        }
        let Window { terms, arity, c, last, recursion } = &self;
        let rows = convolution_window(terms, *arity, *c, *last, *recursion);
        let sum = |row: &Vec<V>| {
            row.iter().try_fold(V::zero(), |sum, term| {
                Ok(sum.plus(&term.absolute().ok_or_else(symbolic)?))
            })
        };
        let sums = rows.iter().map(sum).collect::<Result<Vec<V>, CallError>>()?;
        known.push((self, sums.clone()));
        Ok(sums)
    }
}

/// The names of the definitions that give the sequences, and of their index.
struct Names {
    first: String,
    second: Option<String>,
    index: String,
}

impl Names {
    fn of(options: &mut Options<'_>) -> Result<Names, CallError> {
        let first = options.take("sequence").ok_or_else(|| {
            let message = "name the definition that gives the sequence: `sequence = g`";
            CallError::Misuse(message.to_owned())
        })?;
        let index = options.take("index").unwrap_or_else(|| SEQUENCE_INDEX.to_owned());
        Ok(Names { first, second: options.take("with"), index })
    }

    /// The sequence of this name, at the indices 0, …, length − 1.
    fn sequence<V: Value>(
        &self,
        name: &str,
        call: &Call<'_, V>,
        context: &dyn Context<V>,
        length: &V,
    ) -> Result<Vec<V>, CallError> {
        let length = within("the length of a sequence", length, 1..=MAX_LENGTH)?;
        let mut terms: Vec<V> = Vec::with_capacity(length);
        let mut conductor = 1;
        for q in 0..length {
            let mut indices = vec![(self.index.clone(), V::from_rational(&Rational::from(q)))];
            indices.extend_from_slice(call.indices);
            let name = name.to_owned();
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
}
