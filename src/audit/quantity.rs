//! The functions that claims can use: constants of the scheme they are about.

use super::library::{Library, Resolved, Unresolved};
use super::options::Options;
use crate::bound::{
    ClassCap, Constants, DepthError, Operator, Recursion, Rounded, Terms, convolution_coefficient,
    displacement, log_level, sequence, surface_displacement,
};
use crate::exact::{Rational, Real};
use crate::formula::{Call, CallError, Context, FormulaErrorKind, Functions, Parameters, Value};
use crate::scheme::{Instance, Mask, Reference, Rules};
use std::cell::{Cell, OnceCell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The functions, with what they are; for help texts.
pub const QUANTITIES: [(&str, &str); 11] = [
    ("contraction(c, order = adjoint|forward)", "T_c; with `terms = total` and c = 1, max |Σ b|"),
    ("norm(c, order = adjoint|forward)", "Λ_c, the norm of the scheme"),
    ("tensor(c, order = …, suprema = independent|joint)", "T_c·Λ_c of the tensor product"),
    ("displacement(terms = each|total, offset = own|0|-1|…)", "σ"),
    ("surface_displacement(x1, x2, x3, terms = each|total)", "ν for the spreads x1, x2, x3"),
    ("levels(ratio, x, rounded = up|nearest|down)", "the logarithm of x to the base `ratio`"),
    ("mask(alpha, j)", "a coefficient of the mask; 0 beyond its ends"),
    ("difference(beta, j)", "a coefficient of the difference mask"),
    (
        "convolution(c, l, f, order = adjoint|forward, recursion = derived|printed)",
        "E^c_{l,f}, a coefficient of c convolutions of the difference mask",
    ),
    ("arity()", "n"),
    ("width()", "N"),
];

fn name_of(usage: &str) -> &str {
    usage.split('(').next().unwrap_or(usage)
}

fn check_name(function: &str) -> Result<(), CallError> {
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
    /// When set, `levels` rounds so, whatever the formula says.
    pub(super) rounded: Option<Rounded>,
    /// Whether a value was given up because it is beyond the caps of the program,
    /// not because it does not exist.
    pub(super) beyond_caps: Cell<bool>,
}

impl Functions<Rational> for Quantities<'_> {
    fn call(&self, call: &Call<'_, Rational>) -> Result<Rational, CallError> {
        check_name(call.function)?;
        let mut options = Options::new(call);
        let other;
        let scheme = match options.take("scheme") {
            None => self.scheme.as_ref(),
            Some(name) => {
                other = self.other_scheme(&name)?;
                Some(&other)
            }
        };
        let constants = || {
            let missing = "this needs a scheme: give the table or equation one".to_owned();
            scheme.map(|scheme| &*scheme.constants[0]).ok_or(CallError::Misuse(missing))
        };
        let value = match (call.function, call.arguments) {
            ("levels", [ratio, x]) => {
                let rounded = self.rounded.unwrap_or(options.rounded()?);
                options.finish()?;
                let level = log_level(ratio, x, rounded);
                return level.map(Rational::from).map_err(|error| {
                    if error == DepthError::TooDeep {
                        self.beyond_caps.set(true);
                    }
                    CallError::Undefined(error.to_string())
                });
            }
            ("contraction", [c]) => self.contraction(constants()?, level(c)?, &mut options),
            ("norm", [c]) => {
                let order = options.order()?;
                self.capped(constants()?.norm(Operator::Scheme, level(c)?, order))
            }
            ("tensor", [c]) => {
                let (order, suprema) = (options.order()?, options.suprema()?);
                self.capped(constants()?.tensor(level(c)?, order, suprema))
            }
            ("displacement", []) => moved(constants()?.mask(), &mut options),
            ("surface_displacement", [x1, x2, x3]) => {
                let terms = options.terms()?;
                Ok(surface_displacement(constants()?.mask(), [x1, x2, x3], terms))
            }
            _ => {
                let constants = constants()?;
                shape(constants.mask(), || constants.difference(), call, &mut options)
            }
        }?;
        options.finish()?;
        Ok(value)
    }
}

impl Quantities<'_> {
    fn other_scheme(&self, name: &str) -> Result<Resolved, CallError> {
        let reference = reference(name)?;
        let resolved = self.library.resolve(&reference, &Parameters::<Rational>::default());
        resolved.map_err(|error| unresolved(name, error))
    }

    fn capped(&self, value: Result<Rational, ClassCap>) -> Result<Rational, CallError> {
        value.map_err(|error| {
            self.beyond_caps.set(true);
            CallError::Undefined(error.to_string())
        })
    }

    fn contraction(
        &self,
        constants: &Constants,
        c: u32,
        options: &mut Options<'_>,
    ) -> Result<Rational, CallError> {
        let order = options.order()?;
        match options.terms()? {
            Terms::Each => self.capped(constants.norm(Operator::Difference, c, order)),
            Terms::Total if c == 1 => Ok(total_contraction(constants.difference())),
            Terms::Total => {
                Err(CallError::Misuse("`terms = total` is defined for c = 1 only".to_owned()))
            }
        }
    }
}

/// A mask over any numbers, with its difference mask once that is asked for.
pub(super) struct Shape<V> {
    pub(super) mask: Mask<V>,
    difference: OnceCell<Rules<V>>,
}

impl<V: Value> Shape<V> {
    fn new(masks: Vec<Mask<V>>) -> Rc<Shape<V>> {
        let mask = masks.into_iter().next().expect("a scheme has one mask or two");
        Rc::new(Shape { mask, difference: OnceCell::new() })
    }

    pub(super) fn difference(&self) -> &Rules<V> {
        self.difference.get_or_init(|| self.mask.difference())
    }
}

/// A scheme, one name with parameters per direction, and its shape.
type Own<V> = (Vec<Instance<V>>, Rc<Shape<V>>);

/// The shapes of the schemes that an identity refers to: its own at the last
/// parameters, and those that are named in formulas.
pub(super) struct Shapes<'a, V> {
    library: &'a Library<'a>,
    own: RefCell<Option<Own<V>>>,
    named: RefCell<BTreeMap<String, Rc<Shape<V>>>>,
}

impl<'a, V: Value + PartialEq> Shapes<'a, V> {
    pub(super) fn new(library: &'a Library<'a>) -> Shapes<'a, V> {
        Shapes { library, own: RefCell::default(), named: RefCell::default() }
    }

    /// The shape of the scheme that `reference` means in `context`.
    pub(super) fn own(
        &self,
        reference: &Reference,
        context: &dyn Context<V>,
    ) -> Result<Rc<Shape<V>>, Unresolved> {
        let instances = self.library.instances(reference, context)?;
        if let Some((known, shape)) = &*self.own.borrow()
            && *known == instances
        {
            return Ok(Rc::clone(shape));
        }
        let shape = Shape::new(self.library.masks(&instances)?);
        *self.own.borrow_mut() = Some((instances, Rc::clone(&shape)));
        Ok(shape)
    }

    fn named(&self, name: &str) -> Result<Rc<Shape<V>>, CallError> {
        if let Some(shape) = self.named.borrow().get(name) {
            return Ok(Rc::clone(shape));
        }
        let instances = self.library.instances(&reference(name)?, &Parameters::<V>::default());
        let masks = instances.and_then(|instances| self.library.masks(&instances));
        let shape = Shape::new(masks.map_err(|error| unresolved(name, error))?);
        self.named.borrow_mut().insert(name.to_owned(), Rc::clone(&shape));
        Ok(shape)
    }
}

/// The coefficients of a scheme over any numbers, for identities.
pub(super) struct Coefficients<'a, V> {
    pub(super) shapes: &'a Shapes<'a, V>,
    pub(super) own: Option<Rc<Shape<V>>>,
}

impl<V: Value + PartialEq> Functions<V> for Coefficients<'_, V> {
    fn call(&self, call: &Call<'_, V>) -> Result<V, CallError> {
        let mut options = Options::new(call);
        let found = self.shape(call, &mut options)?;
        let value = shape(&found.mask, || found.difference(), call, &mut options)?;
        options.finish()?;
        Ok(value)
    }
}

impl<V: Value + PartialEq> Coefficients<'_, V> {
    /// The scheme that a call is about.
    pub(super) fn shape(
        &self,
        call: &Call<'_, V>,
        options: &mut Options<'_>,
    ) -> Result<Rc<Shape<V>>, CallError> {
        check_name(call.function)?;
        match options.take("scheme") {
            Some(name) => self.shapes.named(&name),
            None => self.own.clone().ok_or_else(|| {
                CallError::Misuse("this needs a scheme: give the claim one".to_owned())
            }),
        }
    }
}

fn reference(name: &str) -> Result<Reference, CallError> {
    Reference::parse(name).map_err(|error| CallError::Misuse(error.to_string()))
}

fn unresolved(name: &str, error: Unresolved) -> CallError {
    match error {
        Unresolved::Formula(error) => CallError::Inner(error.kind),
        Unresolved::Scheme(error) => CallError::Misuse(format!("scheme `{name}`: {error}")),
    }
}

pub(super) fn undefined(error: ClassCap) -> CallError {
    CallError::Undefined(error.to_string())
}

/// The functions that only read coefficients.
pub(super) fn shape<'m, V: Value + 'm>(
    mask: &Mask<V>,
    difference: impl FnOnce() -> &'m Rules<V>,
    call: &Call<'_, V>,
    options: &mut Options<'_>,
) -> Result<V, CallError> {
    let number = |value: usize| V::from_rational(&Rational::from(value));
    match (call.function, call.arguments) {
        ("mask", [rule, column]) => coefficient(mask.rules(), rule, column),
        ("difference", [rule, column]) => coefficient(difference(), rule, column),
        ("convolution", [c, l, f]) => {
            let (order, recursion) = (options.order()?, options.recursion()?);
            let c = u32::try_from(index("a number of convolutions", c)?).unwrap_or(0);
            let most = match recursion {
                Recursion::Derived => MAX_CONVOLUTIONS,
                Recursion::Printed => MAX_PRINTED_CONVOLUTIONS,
            };
            if !(1..=most).contains(&c) {
                let message = format!("from 1 to {most} convolutions here, and not {c}");
                return Err(CallError::Misuse(message));
            }
            let (l, f) = (index("the index l", l)?, index("the index f", f)?);
            let t = sequence(difference(), order);
            Ok(convolution_coefficient(&t, mask.arity(), c, l, f, recursion))
        }
        ("arity", []) => Ok(number(mask.arity())),
        ("width", []) => Ok(number(mask.width())),
        (name, given) => {
            let usage = QUANTITIES.iter().find(|(usage, _)| name_of(usage) == name);
            let usage = usage.map_or(name, |(usage, _)| usage);
            let count = given.len();
            let message =
                format!("`{name}` cannot be used so with {count} arguments; its form is {usage}");
            Err(CallError::Misuse(message))
        }
    }
}

/// The most convolutions whose coefficients are summed term by term.
const MAX_CONVOLUTIONS: u32 = 4;

/// The same by the printed recursion, whose terms are far more.
const MAX_PRINTED_CONVOLUTIONS: u32 = 3;

fn index<V: Value>(what: &'static str, value: &V) -> Result<i64, CallError> {
    let integer = value.as_rational().filter(Rational::is_integer);
    let integer = integer.and_then(|value| value.numerator().to_i64());
    integer.filter(|value| value.abs() <= 1_000_000).ok_or_else(|| {
        CallError::Inner(FormulaErrorKind::NotAnInteger { what, value: value.to_string() })
    })
}

fn coefficient<V: Value>(rules: &Rules<V>, rule: &V, column: &V) -> Result<V, CallError> {
    let (rule, column) = (index("the index of a rule", rule)?, index("a column", column)?);
    let row = usize::try_from(rule).ok().and_then(|rule| rules.rows().get(rule));
    let row = row.ok_or_else(|| {
        let last = rules.arity() - 1;
        CallError::Misuse(format!("there is no rule {rule}; the rules are 0 to {last}"))
    })?;
    let entry = usize::try_from(column).ok().and_then(|column| row.get(column));
    Ok(entry.cloned().unwrap_or_else(V::zero))
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
