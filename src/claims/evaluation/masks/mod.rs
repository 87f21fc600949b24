//! Functions of masks and of their basic limit functions.

mod coefficients;
mod common;
pub(crate) mod constants;
mod exponents;
mod field;
mod generic;
mod lattice;
pub(crate) mod rules;
mod values;

pub(crate) use common::{numbers, rational};
pub(crate) use exponents::{End, MAX_CLASSES};
pub(crate) use field::over_field;
pub(crate) use lattice::of_lattice;

use crate::cap::Cap;
use crate::evaluation::arguments::index;
use crate::evaluation::options::Options;
use crate::exact::Rational;
use crate::formula::{Call, CallError, Value};
use crate::limit::{Limit, LimitError};
use crate::scheme::Mask;
use crate::smoothness::{
    InnerProductError, InnerProducts, Kept, Shape, Symbol, basic, derivative_symbol,
    integral_symbol, is_independent, shape_kept,
};
use coefficients::of_coefficients;
use common::{MAX_PLACES, as_rational, check_size, converted, not_shown};
use exponents::{bound_at, is_independent_at};
use generic::answered;
use std::cell::RefCell;
use std::rc::Rc;
use values::{InnerProduct, Integral, Keeps, ValueAt};

/// Results by what they are of; of few masks, so that they are searched one by one.
pub(crate) type Results<K, T> = RefCell<Vec<(K, Result<T, CallError>)>>;

/// What is known of the limits of masks: each is computed once for a claim.
#[derive(Default)]
pub(crate) struct KnownLimits {
    limits: Results<Mask, Rc<Limit>>,
    products: Results<(Mask, Mask), Rc<InnerProducts>>,
    shapes: Results<(Mask, Shape), bool>,
}

/// The result that is known, or computed now.
pub(crate) fn once<K: PartialEq, T: Clone>(
    known: &Results<K, T>,
    key: K,
    compute: impl FnOnce(&K) -> Result<T, CallError>,
) -> Result<T, CallError> {
    if let Some((_, result)) = known.borrow().iter().find(|(one, _)| *one == key) {
        return result.clone();
    }
    let result = compute(&key);
    known.borrow_mut().push((key, result.clone()));
    result
}

impl KnownLimits {
    pub(crate) fn limit(&self, mask: Mask) -> Result<Rc<Limit>, CallError> {
        once(&self.limits, mask, |mask| {
            Limit::new(mask).map(Rc::new).map_err(|error| unlimited(&error))
        })
    }

    pub(crate) fn inner_products(
        &self,
        masks: (Mask, Mask),
    ) -> Result<Rc<InnerProducts>, CallError> {
        once(&self.products, masks, |(first, second)| {
            check_size(first, second)?;
            let bits =
                |mask: &Mask| mask.rules().rows().iter().flatten().map(Rational::bits).sum::<u64>();
            if bits(first).saturating_mul(bits(second)) > MAX_BITS {
                let what = "the product of the bits of two masks";
                return Err(CallError::BeyondCap(Cap::new(what, MAX_BITS)));
            }
            InnerProducts::new(first, second).map(Rc::new).map_err(|error| match error {
                InnerProductError::Limit(error) => unlimited(&error),
                InnerProductError::Mask(error) => error
                    .cap()
                    .map_or_else(|| CallError::Misuse(error.to_string()), CallError::BeyondCap),
                other => CallError::Misuse(other.to_string()),
            })
        })
    }

    /// Whether all limits of data with a shape have it.
    fn keeps(&self, mask: Mask, shape: Shape) -> Result<bool, CallError> {
        once(&self.shapes, (mask, shape), |(mask, shape)| {
            let limit = self.limit(mask.clone())?;
            match shape_kept(&limit, *shape).map_err(|error| unlimited(&error))? {
                Kept::Always { .. } => Ok(true),
                Kept::NotAlways { .. } | Kept::NoLines => Ok(false),
                Kept::Open { levels } => {
                    let what = "the shape of limits is not decided: the number of levels";
                    Err(CallError::BeyondCap(Cap::new(what, levels.into())))
                }
            }
        })
    }
}

/// The greatest product of the bits of two masks whose inner products are computed.
const MAX_BITS: u64 = 1 << 24;

/// The value of a function of a mask. `other` gives the mask of the scheme that a name stands for.
///
/// # Errors
/// When there is no such value; `None` if there is no such function of so many arguments.
pub(crate) fn of_mask<V: Value + PartialEq>(
    mask: &Mask<V>,
    call: &Call<'_, V>,
    options: &mut Options<'_>,
    other: impl Fn(&str) -> Result<Mask<V>, CallError>,
    known: &KnownLimits,
) -> Result<Option<V>, CallError> {
    if let Some(value) = of_coefficients(mask, call, options, &other)? {
        return Ok(Some(value));
    }
    let truth = |holds: bool| V::from_rational(&Rational::from(i64::from(holds)));
    let keeps = |shape| match as_rational(mask) {
        Some(mask) => known.keeps(mask, shape).map(truth),
        None => answered(&Keeps { shape }, &[mask], &[]),
    };
    let value = match (call.function, call.arguments) {
        ("coefficient", [k]) => Symbol::of(mask).coefficient(index("a place in the mask", k)?),
        ("symbol_at", [z]) => symbol_at(mask, z)?,
        ("limit_value", [x]) => limit_value(mask, x, options.derivative()?, known)?,
        ("integral", [x, y]) => integral(mask, [x, y], known)?,
        ("inner_product", [k]) => inner_product(mask, k, options, other, known)?,
        ("positive", []) => keeps(Shape::Positive)?,
        ("monotone", []) => keeps(Shape::Monotone)?,
        ("convex", []) => keeps(Shape::Convex)?,
        ("independent", []) => truth(match (as_rational(mask), converted(mask, V::at_place)) {
            (Some(mask), _) => is_independent(&Symbol::of(&mask)),
            (None, Some(mask)) => is_independent_at(&mask)?,
            (None, None) => is_independent(&Symbol::of(&over_field(mask)?)),
        }),
        ("same", []) => {
            let Some(name) = options.take("with") else {
                let message = "name the other scheme: `same(with = NAME)`";
                return Err(CallError::Misuse(message.to_owned()));
            };
            truth(Symbol::of(mask) == Symbol::of(&other(&name)?))
        }
        _ => return Ok(None),
    };
    Ok(Some(value))
}

/// An end of what is known of `smoothness` or `hoelder` of a mask that depends on a parameter, on all of its interval.
///
/// # Errors
/// When nothing is known.
pub(crate) fn smoothness_bound<V: Value + PartialEq>(
    mask: &Mask<V>,
    function: &str,
    end: End,
) -> Result<V, CallError> {
    let place = converted(mask, V::at_place).ok_or_else(not_shown)?;
    V::of_place(bound_at(&place, function, end)?).ok_or_else(not_shown)
}

/// Σ_k a_k z^k.
fn symbol_at<V: Value + PartialEq>(mask: &Mask<V>, z: &V) -> Result<V, CallError> {
    let symbol = Symbol::of(mask);
    let (low, high) = symbol.powers();
    // By Horner's rule, from the highest power down to the lowest.
    let value = (low..=high)
        .rev()
        .fold(V::zero(), |value, power| value.times(z).plus(&symbol.coefficient(power)));
    let one = V::from_rational(&Rational::one());
    if low >= 0 {
        return Ok((0..low).fold(value, |value, _| value.times(z)));
    }
    if *z == V::zero() {
        return Err(CallError::Misuse(
            "this symbol has negative powers of z, and no value at 0".to_owned(),
        ));
    }
    let inverse = one.divided(z).map_err(CallError::Inner)?;
    Ok((low..0).fold(value, |value, _| value.times(&inverse)))
}

/// A place of a limit.
fn parameter<V: Value>(x: &V) -> Result<Rational, CallError> {
    x.as_rational().ok_or_else(|| {
        CallError::Misuse(format!("a limit is computed at rational numbers, and not at {x}"))
    })
}

/// The derivative of this order at x: Σ_i (−1)^i binomial(m, i) ψ(x − i).
fn limit_value<V: Value>(
    mask: &Mask<V>,
    x: &V,
    order: u32,
    known: &KnownLimits,
) -> Result<V, CallError> {
    let x = parameter(x)?;
    let Some(mask) = as_rational(mask) else {
        return answered(&ValueAt { x: &x, order }, &[mask], &[]);
    };
    known.limit(mask.clone())?;
    let derived = if order == 0 {
        mask
    } else {
        let symbol = derivative_symbol(&Symbol::of(&mask), order);
        let mask = symbol.and_then(|symbol| symbol.mask().ok());
        mask.ok_or_else(|| {
            let message = format!("limits have no continuous derivative of order {order}");
            CallError::Undefined(message)
        })?
    };
    let mut sum = Rational::zero();
    // (−1)^i binomial(m, i)
    let mut factor = Rational::one();
    for i in 0..=order {
        sum += &(basic_value(&derived, &(&x - Rational::from(i)), known)? * &factor);
        factor = factor * Rational::from(i64::from(i) - i64::from(order)) / Rational::from(i + 1);
    }
    Ok(V::from_rational(&sum))
}

/// φ(x).
fn basic_value(mask: &Mask, x: &Rational, known: &KnownLimits) -> Result<Rational, CallError> {
    let (first, last) = Symbol::of(mask).support();
    let limit = known.limit(mask.clone())?;
    if *x <= first || *x >= last {
        return Ok(Rational::zero());
    }
    basic(&limit, x).map_err(|error| unlimited(&error))
}

/// ∫ φ from x to y: Σ_{j ≥ 0} (χ(y − j) − χ(x − j)).
fn integral<V: Value>(mask: &Mask<V>, ends: [&V; 2], known: &KnownLimits) -> Result<V, CallError> {
    let ends = [parameter(ends[0])?, parameter(ends[1])?];
    let Some(mask) = as_rational(mask) else {
        return answered(&Integral { ends: ends.each_ref() }, &[mask], &[]);
    };
    known.limit(mask.clone())?;
    let symbol = integral_symbol(&Symbol::of(&mask));
    let (first, last) = symbol.support();
    let sums = symbol.mask().map_err(|error| CallError::Misuse(error.to_string()))?;
    let mut up_to = [Rational::zero(), Rational::zero()];
    for (sum, end) in up_to.iter_mut().zip(ends) {
        // All of φ is before what is not less than the end of the support of χ less 1.
        if end >= &last - Rational::one() {
            *sum = Rational::one();
            continue;
        }
        let count = (&end - &first).ceil().to_i64().unwrap_or(i64::MAX);
        if count > MAX_PLACES {
            return Err(CallError::BeyondCap(Cap::new(
                "the support of a limit",
                MAX_PLACES.unsigned_abs(),
            )));
        }
        for j in 0..count.max(0) {
            *sum += &basic_value(&sums, &(&end - Rational::from(j)), known)?;
        }
    }
    let [from, to] = up_to;
    Ok(V::from_rational(&(to - from)))
}

fn inner_product<V: Value>(
    mask: &Mask<V>,
    k: &V,
    options: &mut Options<'_>,
    other: impl FnOnce(&str) -> Result<Mask<V>, CallError>,
    known: &KnownLimits,
) -> Result<V, CallError> {
    let k = Rational::from(index("the distance of two functions", k)?);
    let second = options.take("with").map(|name| other(&name)).transpose()?;
    let second = second.as_ref().unwrap_or(mask);
    let (Some(first), Some(second)) = (as_rational(mask), as_rational(second)) else {
        return answered(&InnerProduct { k }, &[mask, second], &[]);
    };
    let products = known.inner_products((first, second))?;
    products.at(&k).map(|value| V::from_rational(&value)).map_err(|error| unlimited(&error))
}

/// Why a limit is not computed: there is none, or it is not shown that there is one.
pub(crate) fn unlimited(error: &LimitError) -> CallError {
    match error {
        LimitError::NoLimit { .. } => {
            let what = "there is no continuous limit: the multiplicity of the eigenvalue 1";
            CallError::BeyondCap(Cap::new(what, 1))
        }
        LimitError::NotShown { .. } => not_shown(),
        LimitError::Window(_) => {
            let what = "the number of points that determine a limit";
            CallError::BeyondCap(Cap::new(what, crate::limit::MAX_WINDOW as u64))
        }
        _ => CallError::BeyondCap(Cap::new(
            "the number of digits after which those of a parameter repeat",
            crate::limit::MAX_PERIOD.into(),
        )),
    }
}
