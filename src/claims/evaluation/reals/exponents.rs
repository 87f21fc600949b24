//! Exponents, Riesz bounds and greatest values of the limits of masks.

use crate::cap::Cap;
use crate::evaluation::arguments::within;
use crate::evaluation::masks::{
    KnownLimits, Results, numbers, once, over_field, rational, unlimited,
};
use crate::exact::{
    Adjugate, Enclosed as _, Enclosure, LogSum, LogTerm, MAX_ROOT_DEGREE, Rational, RealCyclotomic,
    RealExpression, Scalar as _, divided, greatest_divisor,
};
use crate::formula::{Call, CallError, RealValue, Value};
use crate::limit::{greatest_of_bounded, greatest_of_step};
use crate::scheme::{Instance, Mask};
use crate::smoothness::{
    Coefficient, ExponentFormula, Smoothness, Symbol, modulus, modulus_extremes, riesz_bounds,
    sobolev_exponent,
};
use crate::spectrum::Spectrum;
use std::cell::RefCell;
use std::cmp::Ordering;
use std::rc::Rc;
use std::sync::Arc;

/// What is too much for the extremes of a cosine polynomial.
const EXTREMES: &str = "the degree of the place where a cosine polynomial is extreme";

/// The enclosures of exponents that are no rational numbers.
const LEVEL: u32 = 2;

/// A mask, and what is proved of its limits.
#[derive(Clone, Debug)]
pub struct Limits {
    /// The mask.
    pub mask: Mask,
    /// What is proved.
    pub smoothness: Smoothness,
}

/// Values that are known: each is computed once for a claim.
#[derive(Default)]
pub(crate) struct KnownReals {
    limits: Results<Mask, Arc<Limits>>,
    greatest: Results<(Mask, bool), RealValue>,
    riesz: Results<Mask, [RealValue; 2]>,
    spectra: Results<Ring, Rc<Spectrum>>,
    eigenvalues: Results<Mask<RealCyclotomic>, Rc<[RealExpression]>>,
}

/// A ring, and its valence.
type Ring = (Vec<Instance<RealCyclotomic>>, usize);

/// The limits that values of a claim rest on, with the name of the scheme.
pub(crate) type Used = RefCell<Vec<(Option<String>, Arc<Limits>)>>;

impl KnownReals {
    /// The value of such a function of a mask. What is known of its limits is added to `used`, with the `name` of the scheme.
    pub(crate) fn of_mask<V: Value + PartialEq>(
        &self,
        mask: &Mask<V>,
        call: &Call<'_, V>,
        known: &KnownLimits,
        (name, used): (&Option<String>, &Used),
    ) -> Result<RealValue, CallError> {
        if let ("modulus", [t]) = (call.function, call.arguments) {
            let symbol = Symbol::of(&numbers(mask)?);
            let turn = t.as_rational().ok_or_else(|| {
                let found = t.number().map(|t| format!(", and not {t}")).unwrap_or_default();
                CallError::Misuse(format!("the t of e^(2πit) is a rational number{found}"))
            })?;
            let found = modulus(&symbol, &turn).map_err(|error| CallError::Inner(error.into()))?;
            return Ok(found.into());
        }
        if call.function == "modulus" {
            return Err(CallError::Misuse("write `modulus(t)`: |a(z)| at z = e^(2πit)".to_owned()));
        }
        if !call.arguments.is_empty() {
            let message = format!("`{}` has no arguments but a scheme", call.function);
            return Err(CallError::Misuse(message));
        }
        if call.function == "sobolev" {
            return sobolev(mask);
        }
        if let "modulus_lower" | "modulus_upper" = call.function {
            let found = modulus_extremes(&Symbol::of(&numbers(mask)?));
            let [lower, upper] = found.ok_or_else(|| beyond(EXTREMES, 16))?;
            return Ok(if call.function == "modulus_lower" { lower } else { upper }.into());
        }
        let mask = match (rational(mask), call.function) {
            // What is known of these is in no certificate.
            (Err(_), "smoothness" | "hoelder") => {
                return exponent(call.function, &smoothness(&over_field(mask)?)?);
            }
            (rational, _) => rational?,
        };
        match call.function {
            "smoothness" | "hoelder" => {
                let limits = self.limits(mask)?;
                if used.borrow().iter().all(|(_, one)| one.mask != limits.mask) {
                    used.borrow_mut().push((name.clone(), Arc::clone(&limits)));
                }
                exponent(call.function, &limits.smoothness)
            }
            "overshoot" | "gibbs" => {
                let step = call.function == "gibbs";
                once(&self.greatest, (mask, step), |(mask, step)| {
                    let limit = known.limit(mask.clone())?;
                    let found =
                        if *step { greatest_of_step(&limit) } else { greatest_of_bounded(&limit) };
                    let bounds = found.map_err(|error| unlimited(&error))?;
                    let what = "the number of cells in which a greatest value is looked for";
                    bounds.map(RealValue::enclosed).ok_or_else(|| beyond(what, 4_096))
                })
            }
            _ => {
                let bounds = once(&self.riesz, mask, |mask| {
                    let products = known.inner_products((mask.clone(), mask.clone()))?;
                    let (first, last) = Symbol::of(mask).support();
                    let last = (last - first).ceil().to_i64();
                    let last =
                        last.and_then(|last| usize::try_from(last).ok()).unwrap_or(usize::MAX);
                    let bounds = riesz_bounds(&products, last);
                    let bounds = bounds.map_err(|error| unlimited(&error))?;
                    bounds.map(|two| two.map(RealValue::from)).ok_or_else(|| beyond(EXTREMES, 16))
                })?;
                let [lower, upper] = bounds;
                Ok(if call.function == "riesz_lower" { lower } else { upper })
            }
        }
    }

    /// The j-th greatest real eigenvalue of the matrix (a_{nk−l}), where k and l are the integers inside the support of φ: that of the rules for the
    /// points of which the limit at 0 depends.
    pub(crate) fn eigenvalue<V: Value + PartialEq>(
        &self,
        mask: &Mask<V>,
        number: &V,
    ) -> Result<RealValue, CallError> {
        let number = within("the number of an eigenvalue", number, 1..=1_000)?;
        let all = once(&self.eigenvalues, numbers(mask)?, eigenvalues)?;
        let found = all.get(number - 1).cloned().map(RealValue::from);
        found.ok_or_else(|| {
            let count = all.len();
            CallError::Undefined(format!(
                "the local matrix has {count} real eigenvalue(s), and no number {number}"
            ))
        })
    }

    /// The spectrum of a ring at a valence.
    pub(super) fn spectrum(
        &self,
        ring: Ring,
        compute: impl FnOnce() -> Result<Spectrum, CallError>,
    ) -> Result<Rc<Spectrum>, CallError> {
        once(&self.spectra, ring, |_| compute().map(Rc::new))
    }

    fn limits(&self, mask: Mask) -> Result<Arc<Limits>, CallError> {
        once(&self.limits, mask, |mask| {
            let smoothness = smoothness(mask)?;
            Ok(Arc::new(Limits { mask: mask.clone(), smoothness }))
        })
    }
}

fn smoothness<F: Coefficient>(mask: &Mask<F>) -> Result<Smoothness<F>, CallError> {
    Smoothness::of(mask)
        .map_err(|_| beyond("the number of rows of the matrices of differences", 64))
}

/// The value of `smoothness` or `hoelder`.
fn exponent<F: Coefficient>(function: &str, known: &Smoothness<F>) -> Result<RealValue, CallError> {
    if function == "smoothness" { continuity(known) } else { hoelder(known) }
}

fn beyond(what: &'static str, most: u64) -> CallError {
    CallError::BeyondCap(Cap::new(what, most))
}

/// The greatest m for which all limits are C^m; −1 without continuous limits.
fn continuity<F: Coefficient>(known: &Smoothness<F>) -> Result<RealValue, CallError> {
    let whole = |m: usize| Rational::from(m);
    match (known.continuity, known.continuity_fails) {
        (_, Some(0)) => Ok(RealValue::from_rational(&Rational::from(-1))),
        (Some(m), fails) => {
            let most = fails.unwrap_or(known.sum_rules).max(m + 1) - 1;
            Ok(RealValue::enclosed(Enclosure::new(whole(m), whole(most))))
        }
        (None, _) => Err(undecided()),
    }
}

fn hoelder<F: Coefficient>(known: &Smoothness<F>) -> Result<RealValue, CallError> {
    let exponent = known.hoelder.as_ref().ok_or_else(|| match known.continuity_fails {
        Some(0) => {
            CallError::Undefined("there is no exponent, as limits are not continuous".to_owned())
        }
        _ => undecided(),
    })?;
    if let Some(bounds) = shown(known) {
        return Ok(bounds);
    }
    Ok(match &exponent.formula {
        Some(formula) => of_formula(formula),
        None => RealValue::enclosed(Enclosure::new(exponent.lower.clone(), exponent.upper.clone())),
    })
}

/// What the bounds of the joint spectral radius in certificates show of the exponent; `None` where they show nothing on one side.
fn shown<F: Coefficient>(known: &Smoothness<F>) -> Option<RealValue> {
    let differences = &known.differences;
    if known.reduced.is_some() || known.continuity.is_none() {
        return None;
    }
    let (hull, lower) =
        (differences.radius.hull.as_ref()?, differences.radius.eigenvalue(&differences.matrices)?);
    let bound = |of: &Rational, degree: usize| {
        let factor = -Rational::from(degree).recip();
        let term = LogTerm { factor, base: differences.symbol.arity(), of: of.clone() };
        LogSum { rational: Rational::from(differences.order), terms: vec![term] }
    };
    let (low, high) = (bound(&hull.bound, 1), bound(&lower.at_least, differences.radius.degree));
    let exact = known.hoelder.as_ref()?.formula.as_ref().and_then(ExponentFormula::as_rational);
    if let Some(exact) = exact {
        let is_exact =
            |bound: &LogSum| bound.compare(&LogSum::from(exact.clone())) == Some(Ordering::Equal);
        if is_exact(&low) && is_exact(&high) {
            return Some(RealValue::from_rational(exact));
        }
    }
    let [low, high] = [low.enclosure(LEVEL), high.enclosure(LEVEL)];
    Some(RealValue::enclosed(Enclosure::new(low.lower().clone(), high.upper().clone())))
}

fn undecided() -> CallError {
    beyond("it is not decided whether limits are continuous: the number of levels", 24)
}

fn of_formula(formula: &ExponentFormula) -> RealValue {
    match formula.as_rational() {
        Some(value) => RealValue::from_rational(value),
        None => RealValue::enclosed(formula.enclosure(LEVEL)),
    }
}

fn sobolev<V: Value + PartialEq>(mask: &Mask<V>) -> Result<RealValue, CallError> {
    let found = match rational(mask) {
        Ok(mask) => sobolev_exponent(&Symbol::of(&mask)),
        Err(_) => sobolev_exponent(&Symbol::of(&over_field(mask)?)),
    };
    let what = "the number of rows of the matrix of a Sobolev exponent";
    found.as_ref().map(of_formula).ok_or_else(|| beyond(what, 40))
}

/// The most rows of a local matrix.
const MAX_ROWS: usize = 32;

/// The real eigenvalues of the local matrix of a mask, each as often as it is a root, in decreasing order.
fn eigenvalues(mask: &Mask<RealCyclotomic>) -> Result<Rc<[RealExpression]>, CallError> {
    let symbol = Symbol::of(mask);
    let n = i64::try_from(symbol.arity()).expect("a small arity");
    let (low, high) = symbol.powers();
    let places = low.div_euclid(n - 1) + 1..=-(-high).div_euclid(n - 1) - 1;
    let size = places.clone().count();
    if size == 0 {
        let message = "the support of φ has no integer inside, so that there is no local matrix";
        return Err(CallError::Undefined(message.to_owned()));
    }
    if size > MAX_ROWS {
        return Err(beyond("the number of rows of a local matrix", MAX_ROWS as u64));
    }
    let row = |k: i64| places.clone().map(|l| symbol.coefficient(n * k - l)).collect();
    let matrix: Vec<Vec<RealCyclotomic>> = places.clone().map(row).collect();
    let mut rest = Adjugate::of(&matrix).characteristic;
    let mut all = Vec::new();
    // Of the roots of the greatest common divisor with the derivative, each is there once less often.
    while rest.len() > 1 {
        let slope: Vec<RealCyclotomic> = (1..)
            .zip(&rest[1..])
            .map(|(k, c): (i64, _)| c.times(&RealCyclotomic::from(k)))
            .collect();
        let common = greatest_divisor(&rest, &slope);
        let (simple, _) = divided(&rest, &common);
        let what = "the degree of a characteristic polynomial without multiple roots";
        let roots = RealExpression::roots(&simple);
        all.extend(roots.map_err(|_| beyond(what, MAX_ROOT_DEGREE as u64))?);
        rest = common;
    }
    all.sort_by(|a, b| b.cmp(a));
    Ok(all.into())
}
