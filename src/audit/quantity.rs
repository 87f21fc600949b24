//! The functions that claims can use: constants of the scheme they are about.

use super::attained::NotedConstant;
use super::library::{Library, Resolved, Unresolved};
use super::options::{Exponent, Options};
use super::reading::Settings;
use super::series;
use super::shape::shape;
use crate::bound::{
    ClassCap, Constants, DepthError, Operator, Rounded, Suprema, Terms, displacement,
    surface_displacement,
};
use crate::exact::{Rational, Real, RealCyclotomic};
use crate::formula::{Call, CallError, Context, Functions, Parameters, Value};
use crate::scheme::{Mask, Reference, Rules};
use std::cell::{Cell, RefCell};
use std::rc::Rc;

/// The functions, with what they are; for help texts.
pub const QUANTITIES: [(&str, &str); 13] = [
    ("contraction(c, order = adjoint|forward)", "T_c; with `terms = total` and c = 1, max |Σ b|"),
    ("norm(c, order = adjoint|forward)", "Λ_c, the norm of the scheme"),
    ("tensor(c, order = …, suprema = independent|joint)", "T_c·Λ_c of the tensor product"),
    ("displacement(terms = each|total, offset = own|0|-1|…)", "σ"),
    ("surface_displacement(x1, x2, x3, terms = each|total)", "ν for the spreads x1, x2, x3"),
    (
        "levels(ratio, x, c, rounded = up|nearest|down, exponent = level|block)",
        "the logarithm of x to the base `ratio`; with c, which may be left out, and \
         `exponent = block` c times that",
    ),
    ("mask(alpha, j)", "a coefficient of the mask; 0 beyond its ends"),
    ("difference(beta, j)", "a coefficient of the difference mask"),
    (
        "convolution(c, l, f, order = adjoint|forward, recursion = derived|printed)",
        "E^c_{l,f}, a coefficient of c convolutions of the difference mask",
    ),
    (
        "convolved(c, n, length, l, f, sequence = NAME, index = q, recursion = derived|printed)",
        "the same for arity n and the sequence that the definition NAME gives in the index q",
    ),
    (
        "convolution_norm(c, n, length, last, sequence = NAME, with = NAME, suprema = …, index = q, \
         recursion = …)",
        "the largest Σ_l |E^c_{l,f}| over the n^c values of f up to `last`; with a second sequence, \
         the product of both, with independent or joint suprema",
    ),
    ("arity()", "n"),
    ("width()", "N"),
];

pub(super) fn name_of(usage: &str) -> &str {
    usage.split('(').next().unwrap_or(usage)
}

pub(super) fn check_name(function: &str) -> Result<(), CallError> {
    let names = QUANTITIES.iter().map(|(usage, _)| name_of(usage));
    if names.clone().any(|name| name == function) {
        return Ok(());
    }
    Err(CallError::UnknownFunction(names.map(str::to_owned).collect()))
}

/// The quantities of one scheme, in exact numbers.
pub(super) struct Quantities<'a> {
    pub(super) library: &'a Library<'a>,
    pub(super) scheme: Option<Resolved>,
    /// How the formula is read.
    pub(super) settings: &'a Settings,
    /// Whether a value was given up because it is beyond the caps of the program,
    /// not because it does not exist.
    pub(super) beyond_caps: Cell<bool>,
    /// The last call of `levels`.
    pub(super) last_levels: RefCell<Option<LevelCall>>,
}

/// A number of levels: the logarithm of `x` to the base `ratio`, rounded.
pub(super) struct LevelCall {
    pub(super) ratio: RealCyclotomic,
    pub(super) x: RealCyclotomic,
    pub(super) rounded: Rounded,
    /// How many; `None` where there is no such number.
    pub(super) level: Option<u32>,
}

impl Functions<RealCyclotomic> for Quantities<'_> {
    fn call(
        &self,
        call: &Call<'_, RealCyclotomic>,
        context: &dyn Context<RealCyclotomic>,
    ) -> Result<RealCyclotomic, CallError> {
        check_name(call.function)?;
        let mut options = Options::new(call).read_as(self.settings);
        let value = match (call.function, call.arguments) {
            ("levels", [ratio, x]) => self.levels(ratio, x, &mut options)?,
            ("levels", [ratio, x, c]) => {
                let levels = self.levels(ratio, x, &mut options)?;
                match options.exponent()? {
                    Exponent::Level => levels,
                    Exponent::Block => &levels * c,
                }
            }
            _ => match series::call(call, context, &mut options, &self.library.norms) {
                Some(value) => value?,
                None => self.of_scheme(call, &mut options)?,
            },
        };
        options.finished(value)
    }
}

impl Quantities<'_> {
    /// A constant or a coefficient of a scheme.
    fn of_scheme(
        &self,
        call: &Call<'_, RealCyclotomic>,
        options: &mut Options<'_>,
    ) -> Result<RealCyclotomic, CallError> {
        let other;
        let named = options.take("scheme");
        let scheme = match &named {
            None => self.scheme.as_ref(),
            Some(name) => {
                other = self.other_scheme(name)?;
                Some(&other)
            }
        };
        let missing = || CallError::Misuse("this needs a scheme: give the table one".to_owned());
        let scheme = scheme.ok_or_else(missing)?;
        let constants: &Constants = &scheme.constants[0];
        let note = |operator, levels, order| {
            self.library.note_constant(|| NotedConstant {
                instance: scheme.instances[0].clone(),
                constants: Rc::clone(&scheme.constants[0]),
                operator,
                levels,
                order,
                named: named.clone(),
            });
        };
        let value = match (call.function, call.arguments) {
            ("contraction", [c]) => {
                let (c, order) = (level(c)?, options.order()?);
                match options.terms()? {
                    Terms::Each => {
                        note(Operator::Difference, c, order);
                        self.capped(constants.norm(Operator::Difference, c, order))
                    }
                    Terms::Total if c == 1 => Ok(total_contraction(constants.difference())),
                    Terms::Total => {
                        let message = "`terms = total` is defined for c = 1 only";
                        return Err(CallError::Misuse(message.to_owned()));
                    }
                }
            }
            ("norm", [c]) => {
                let (c, order) = (level(c)?, options.order()?);
                note(Operator::Scheme, c, order);
                self.capped(constants.norm(Operator::Scheme, c, order))
            }
            ("tensor", [c]) => {
                let (c, order, suprema) = (level(c)?, options.order()?, options.suprema()?);
                if suprema == Suprema::Independent {
                    note(Operator::Difference, c, order);
                    note(Operator::Scheme, c, order);
                }
                self.capped(constants.tensor(c, order, suprema))
            }
            ("displacement", []) => moved(constants.mask(), options),
            ("surface_displacement", [x1, x2, x3]) => {
                let spreads = [rational(x1)?, rational(x2)?, rational(x3)?];
                let terms = options.terms()?;
                Ok(surface_displacement(constants.mask(), spreads, terms))
            }
            _ => {
                let rules = |rules: &Rules| rules.map(|value| RealCyclotomic::from(value.clone()));
                let mask = constants.mask().map(|value| RealCyclotomic::from(value.clone()));
                return shape(&mask, || rules(constants.difference()), call, options);
            }
        };
        value.map(RealCyclotomic::from)
    }

    fn levels(
        &self,
        ratio: &RealCyclotomic,
        x: &RealCyclotomic,
        options: &mut Options<'_>,
    ) -> Result<RealCyclotomic, CallError> {
        let rounded = options.rounded()?;
        let level = self.library.log_level(ratio, x, rounded);
        let (ratio, x) = (ratio.clone(), x.clone());
        let call = LevelCall { ratio, x, rounded, level: level.clone().ok() };
        self.last_levels.replace(Some(call));
        level.map(RealCyclotomic::from).map_err(|error| {
            if error == DepthError::TooDeep {
                self.beyond_caps.set(true);
            }
            CallError::Undefined(error.to_string())
        })
    }

    fn other_scheme(&self, name: &str) -> Result<Resolved, CallError> {
        let reference = reference(name)?;
        let resolved = self.library.resolve(&reference, &Parameters::<RealCyclotomic>::default());
        resolved.map_err(|error| unresolved(name, error))
    }

    fn capped(&self, value: Result<Rational, ClassCap>) -> Result<Rational, CallError> {
        value.map_err(|error| {
            self.beyond_caps.set(true);
            CallError::Undefined(error.to_string())
        })
    }
}

pub(super) fn reference(name: &str) -> Result<Reference, CallError> {
    Reference::parse(name).map_err(|error| CallError::Misuse(error.to_string()))
}

pub(super) fn unresolved(name: &str, error: Unresolved) -> CallError {
    match error {
        Unresolved::Formula(error) => CallError::Inner(error.kind),
        Unresolved::Scheme(error) => CallError::Misuse(format!("scheme `{name}`: {error}")),
    }
}

/// max_β |Σ_j b_{β,j}|.
pub(super) fn total_contraction<S: Real>(difference: &Rules<S>) -> S {
    S::maximum(difference.rows().iter().map(|row| Terms::Total.gather(row)))
}

/// σ with the terms and at the offset that the options name.
pub(super) fn moved<S: Real>(mask: &Mask<S>, options: &mut Options<'_>) -> Result<S, CallError> {
    let terms = options.terms()?;
    let offset = options.offset(mask.offset())?;
    Ok(displacement(&mask.with_offset(offset), terms))
}

pub(super) fn level<V: Value>(value: &V) -> Result<u32, CallError> {
    let integer = value.as_rational().filter(Rational::is_integer);
    let level = integer.and_then(|level| u32::try_from(level.numerator().to_i64()?).ok());
    level.ok_or_else(|| {
        CallError::Misuse(format!("a number of levels is 0, 1, 2, …, and not {value}"))
    })
}

/// A number that has to be rational here.
fn rational(value: &RealCyclotomic) -> Result<&Rational, CallError> {
    value.as_rational().ok_or_else(|| {
        CallError::Misuse(format!("this is computed at rational numbers only, and not at {value}"))
    })
}
