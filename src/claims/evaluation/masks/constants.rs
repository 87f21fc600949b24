//! Constants of masks.

use crate::bound::{
    ClassCap, Constants, DepthError, MAX_DEPTH, Operator, Order, Suprema, Terms, best_offset,
    displacement, power_norm_generic, surface_displacement,
};
use crate::cap::Cap;
use crate::evaluation::arguments::level;
use crate::evaluation::masks::generic::{Asked, answered};
use crate::evaluation::options::Options;
use crate::exact::{Rational, Real};
use crate::formula::{Call, CallError, Value};
use crate::scheme::{Mask, Rules};
use std::fmt::Display;
use std::rc::Rc;

/// max_β |Σ_j b_{β,j}|.
pub(crate) fn total_contraction<S: Real>(difference: &Rules<S>) -> S {
    S::maximum(difference.rows().iter().map(|row| Terms::Total.gather(row)))
}

fn total_of_one_level() -> CallError {
    CallError::Misuse("`terms = total` is defined for c = 1 only".to_owned())
}

/// σ with the terms and at the offset that the options name; `best` gives the best offset, if the mask has one.
pub(crate) fn moved<S: Real>(
    mask: &Mask<S>,
    options: &mut Options<'_>,
    best: impl Fn() -> Option<i64>,
) -> Result<S, CallError> {
    let terms = options.terms()?;
    let offset = options.offset(mask.offset(), best)?;
    Ok(displacement(&mask.with_offset(offset), terms))
}

/// The number c of levels of a constant, which is 1 if it is left out.
pub(crate) fn levels<V: Value>(c: &[V]) -> Result<u32, CallError> {
    c.first().map_or(Ok(1), level)
}

/// Why a logarithm has no value.
pub(crate) fn no_level(error: &DepthError) -> CallError {
    match error {
        DepthError::TooDeep => {
            let what = "the number of levels, or a number that decides it,";
            CallError::BeyondCap(Cap::new(what, MAX_DEPTH.into()))
        }
        _ => CallError::Undefined(error.to_string()),
    }
}

/// What the constants of a call are computed with.
pub(crate) trait OfMask {
    /// The constants of the mask, with the numbers of its points that the reading says if it is read in this order.
    fn in_order(&self, order: Order) -> Rc<Constants>;

    /// Notes that the norm of so many levels is used.
    fn note(&self, _operator: Operator, _levels: u32, _order: Order) {}
}

impl OfMask for Rc<Constants> {
    fn in_order(&self, _: Order) -> Rc<Constants> {
        Rc::clone(self)
    }
}

/// A constant of a rational mask; `None` if there is no such constant of so many arguments.
pub(crate) fn constant<V: Value>(
    call: &Call<'_, V>,
    options: &mut Options<'_>,
    of: &dyn OfMask,
) -> Result<Option<V>, CallError> {
    let own = of.in_order(Order::Adjoint);
    let value = match (call.function, call.arguments) {
        ("contraction", c @ ([] | [_])) => {
            let (c, order) = (levels(c)?, options.order()?);
            match options.terms()? {
                Terms::Each => {
                    of.note(Operator::Difference, c, order);
                    capped(of.in_order(order).norm(Operator::Difference, c, order))
                }
                Terms::Total if c == 1 => Ok(total_contraction(own.difference())),
                Terms::Total => return Err(total_of_one_level()),
            }
        }
        ("norm", c @ ([] | [_])) => {
            let (c, order) = (levels(c)?, options.order()?);
            of.note(Operator::Scheme, c, order);
            capped(of.in_order(order).norm(Operator::Scheme, c, order))
        }
        ("tensor", c @ ([] | [_])) => {
            let (c, order, suprema) = (levels(c)?, options.order()?, options.suprema()?);
            if suprema == Suprema::Independent {
                of.note(Operator::Difference, c, order);
                of.note(Operator::Scheme, c, order);
            }
            capped(of.in_order(order).tensor(c, order, suprema))
        }
        ("displacement", []) => {
            let mask = own.mask();
            moved(mask, options, || Some(best_offset(mask).0))
        }
        ("surface_displacement", [x1, x2, x3]) => {
            let spreads = [rational(x1)?, rational(x2)?, rational(x3)?];
            let terms = options.terms()?;
            Ok(surface_displacement(own.mask(), spreads.each_ref(), terms))
        }
        _ => return Ok(None),
    };
    value.map(|value| Some(V::from_rational(&value)))
}

/// The most residue classes of a constant of a mask that is not rational.
const MAX_SUMMED_CLASSES: usize = 4_096;

/// A constant by its definition.
enum BySums {
    Contraction(u32, Order, Terms),
    Norm(u32, Order),
    /// The product of both.
    Tensor(u32, Order),
    Displacement(Terms, i64),
}

/// A constant of a mask that is not rational, by its definition; `None` if there is no such constant of so many arguments.
pub(crate) fn constant_by_sums<V: Value>(
    call: &Call<'_, V>,
    options: &mut Options<'_>,
    mask: &Mask<V>,
) -> Result<Option<V>, CallError> {
    let asked = match (call.function, call.arguments) {
        ("contraction", c @ ([] | [_])) => {
            BySums::Contraction(levels(c)?, options.order()?, options.terms()?)
        }
        ("norm", c @ ([] | [_])) => BySums::Norm(levels(c)?, options.order()?),
        ("displacement", []) => {
            let terms = options.terms()?;
            BySums::Displacement(terms, options.offset(mask.offset(), || None)?)
        }
        ("tensor", c @ ([] | [_])) => {
            let (c, order) = (levels(c)?, options.order()?);
            if options.suprema()? == Suprema::Joint {
                return Err(of_rational_masks("tensor` with `suprema = joint"));
            }
            BySums::Tensor(c, order)
        }
        ("surface_displacement", _) => return Err(of_rational_masks("surface_displacement")),
        _ => return Ok(None),
    };
    answered(&asked, &[mask], &[]).map(Some)
}

impl Asked for BySums {
    fn value<F: Real + PartialEq + Display>(
        &self,
        masks: &[Mask<F>],
        _: &[F],
    ) -> Result<F, CallError> {
        let mask = &masks[0];
        match *self {
            BySums::Contraction(c, order, Terms::Each) => norm(&mask.difference(), c, order),
            BySums::Contraction(1, _, Terms::Total) => Ok(total_contraction(&mask.difference())),
            BySums::Contraction(_, _, Terms::Total) => Err(total_of_one_level()),
            BySums::Norm(c, order) => norm(mask.rules(), c, order),
            BySums::Tensor(c, order) => {
                Ok(norm(&mask.difference(), c, order)?.times(&norm(mask.rules(), c, order)?))
            }
            BySums::Displacement(terms, offset) => {
                Ok(displacement(&mask.with_offset(offset), terms))
            }
        }
    }
}

fn of_rational_masks(what: &str) -> CallError {
    CallError::Misuse(format!("`{what}` is computed for masks of rational numbers only"))
}

fn norm<F: Real>(rules: &Rules<F>, c: u32, order: Order) -> Result<F, CallError> {
    let classes = rules.arity().checked_pow(c);
    if classes.is_none_or(|classes| classes > MAX_SUMMED_CLASSES) {
        let what = "the number of residue classes of a mask that is not rational";
        return Err(CallError::BeyondCap(Cap::new(what, MAX_SUMMED_CLASSES as u64)));
    }
    let norm = power_norm_generic(rules, c, order);
    norm.map_err(|error| CallError::BeyondCap(error.cap()))
}

fn capped(value: Result<Rational, ClassCap>) -> Result<Rational, CallError> {
    value.map_err(|error| CallError::BeyondCap(error.cap()))
}

/// The value as a rational number; an error if it is irrational.
fn rational<V: Value>(value: &V) -> Result<Rational, CallError> {
    value.as_rational().ok_or_else(|| {
        CallError::Misuse(format!("this is computed at rational numbers only, and not at {value}"))
    })
}
