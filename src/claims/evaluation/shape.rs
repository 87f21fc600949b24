//! Masks over numbers of any kind, and the functions that read only their coefficients.

use crate::bound::{
    Constants, Order, Recursion, convolution_coefficient, power_norm_generic, sequence,
};
use crate::cap::Cap;
use crate::claim::LocatedReference;
use crate::diagnostic::Diagnostic;
use crate::evaluation::arguments::{index, narrow, place, within};
use crate::evaluation::functions::{QUANTITIES, check_name, name_of};
use crate::evaluation::library::Library;
use crate::evaluation::masks::constants::{constant, levels, moved, no_level};
use crate::evaluation::masks::{KnownLimits, numbers, of_mask, rational};
use crate::evaluation::options::{Exponent, Options};
use crate::evaluation::reference::{self, Unresolved, reference, unresolved};
use crate::evaluation::series;
use crate::evaluation::series::Norms;
use crate::exact::{Rational, RealCyclotomic};
use crate::formula::{Call, CallError, Context, Functions, Parameters, Value};
use crate::scheme::{Instance, Mask, Reference, Rules, Scheme};
use std::borrow::Borrow;
use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The scheme that a claim is about; of a tensor product, the first.
pub(crate) fn own_shape<V: Value + PartialEq>(
    shapes: &Shapes<'_, V>,
    located: &LocatedReference,
    context: &dyn Context<V>,
) -> Result<Rc<Shape<V>>, Diagnostic> {
    let found = shapes.own(&located.reference, context);
    found.map_err(|error| reference::located(located, &error))
}

/// A mask over numbers of any kind; its difference mask is computed when it is first used.
pub(crate) struct Shape<V> {
    pub(crate) mask: Mask<V>,
    difference: OnceCell<Rules<V>>,
    /// The constants, if the mask is rational.
    constants: OnceCell<Option<Rc<Constants>>>,
}

impl<V: Value> Shape<V> {
    fn new(scheme: &Scheme<V>) -> Rc<Shape<V>> {
        let (difference, constants) = Default::default();
        Rc::new(Shape { mask: scheme.first().clone(), difference, constants })
    }

    /// The constants of the mask, if it is rational.
    fn constants(&self, library: &Library<'_>) -> Option<&Rc<Constants>> {
        let constants = || rational(&self.mask).ok().map(|mask| library.constants_of(mask));
        self.constants.get_or_init(constants).as_ref()
    }

    pub(crate) fn difference(&self) -> &Rules<V> {
        self.difference.get_or_init(|| self.mask.difference())
    }
}

/// A scheme, with one name and its parameters for each direction, and its shape.
type Own<V> = (Vec<Instance<V>>, Rc<Shape<V>>);

/// The shapes of the schemes in a claim: of its own scheme for the parameters that were used last,
/// and of the schemes that formulas name.
pub(crate) struct Shapes<'a, V> {
    library: &'a Library<'a>,
    own: RefCell<Option<Own<V>>>,
    named: RefCell<BTreeMap<String, Rc<Shape<V>>>>,
    pub(crate) norms: Norms<V>,
}

impl<'a, V: Value + PartialEq> Shapes<'a, V> {
    pub(crate) fn new(library: &'a Library<'a>) -> Shapes<'a, V> {
        let (own, named, norms) = Default::default();
        Shapes { library, own, named, norms }
    }

    /// The schemes.
    pub(crate) fn library(&self) -> &'a Library<'a> {
        self.library
    }

    /// The shape of the scheme that `reference` means in `context`.
    pub(crate) fn own(
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
        let shape = Shape::new(&self.library.masks(&instances)?);
        *self.own.borrow_mut() = Some((instances, Rc::clone(&shape)));
        Ok(shape)
    }

    fn named(&self, name: &str) -> Result<Rc<Shape<V>>, CallError> {
        if let Some(shape) = self.named.borrow().get(name) {
            return Ok(Rc::clone(shape));
        }
        let instances = self.library.instances(&reference(name)?, &Parameters::<V>::default());
        let masks = instances.and_then(|instances| self.library.masks(&instances));
        let shape = Shape::new(&masks.map_err(|error| unresolved(name, error))?);
        self.named.borrow_mut().insert(name.to_owned(), Rc::clone(&shape));
        Ok(shape)
    }
}

/// The coefficients of a scheme over numbers of any kind, for identities.
pub(crate) struct Coefficients<'a, V> {
    pub(crate) shapes: &'a Shapes<'a, V>,
    pub(crate) own: Option<Rc<Shape<V>>>,
}

impl<V: Value + PartialEq> Functions<V> for Coefficients<'_, V> {
    fn call(&self, call: &Call<'_, V>, context: &dyn Context<V>) -> Result<V, CallError> {
        let mut options = Options::new(call);
        if let Some(value) = series::call(call, context, &mut options, &self.shapes.norms, None) {
            return options.finished(value?);
        }
        if let ("levels", [ratio, x, c @ ..]) = (call.function, call.arguments) {
            let level = self.level(ratio, x, &mut options)?;
            let value = match (c, options.exponent()?) {
                ([], _) | ([_], Exponent::Level) => level,
                ([c], Exponent::Block) => level.times(c),
                _ => return Err(usage(call)),
            };
            return options.finished(value);
        }
        let found = self.shape(call, &mut options)?;
        let other = |name: &str| self.named(name);
        let value = match found.constants(self.shapes.library) {
            Some(constants) => constant(call, &mut options, constants)?,
            None => irrational(call, &mut options, &found)?,
        };
        let value = value.map_or_else(
            || {
                let known = &self.shapes.library.limits;
                shape(&found.mask, || found.difference(), call, &mut options, (other, known))
            },
            Ok,
        )?;
        options.finished(value)
    }

    fn is_scheme(&self, function: &str, name: &str) -> bool {
        self.shapes.library.is_scheme(function, name)
    }
}

impl<V: Value + PartialEq> Coefficients<'_, V> {
    /// The logarithm of x to the base `ratio`.
    fn level(&self, ratio: &V, x: &V, options: &mut Options<'_>) -> Result<V, CallError> {
        let rounded = options.rounded()?;
        let number = |value: &V| {
            let message =
                || CallError::Misuse(format!("levels are counted of numbers, not of {value}"));
            value.number().ok_or_else(message)
        };
        let level = self.shapes.library.log_level(&number(ratio)?, &number(x)?, rounded);
        level.map(|level| V::from_rational(&level.into())).map_err(|error| no_level(&error))
    }

    /// The mask of the scheme that a name stands for.
    pub(crate) fn named(&self, name: &str) -> Result<Mask<V>, CallError> {
        Ok(self.shapes.named(name)?.mask.clone())
    }

    /// The scheme that a call is about.
    pub(crate) fn shape(
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

/// The value of a function that reads only coefficients.
pub(crate) fn shape<V: Value + PartialEq, R: Borrow<Rules<V>>>(
    mask: &Mask<V>,
    difference: impl FnOnce() -> R,
    call: &Call<'_, V>,
    options: &mut Options<'_>,
    (other, known): (impl FnOnce(&str) -> Result<Mask<V>, CallError>, &KnownLimits),
) -> Result<V, CallError> {
    let number = |value: usize| V::from_rational(&Rational::from(value));
    match (call.function, call.arguments) {
        ("mask", [rule, column]) => coefficient(mask.rules(), rule, column),
        ("difference", [rule, column]) => coefficient(difference().borrow(), rule, column),
        ("convolution", [c, l, f]) => {
            let (order, recursion) = (options.order()?, options.recursion()?);
            let most = match recursion {
                Recursion::Derived => MAX_CONVOLUTIONS,
                Recursion::Printed => MAX_PRINTED_CONVOLUTIONS,
            };
            let c = within("the number of convolutions", c, 1..=most)?;
            let (l, f) = (place("the index l", l)?, index("the index f", f)?);
            let t = sequence(difference().borrow(), order);
            Ok(convolution_coefficient(&t, mask.arity(), narrow(c), l, f, recursion))
        }
        ("arity", []) => Ok(number(mask.arity())),
        ("width", []) => Ok(number(mask.width())),
        _ => of_mask(mask, call, options, other, known).unwrap_or_else(|| Err(usage(call))),
    }
}

/// The error of a call that has not the form of its function.
fn usage<V>(call: &Call<'_, V>) -> CallError {
    let (name, count) = (call.function, call.arguments.len());
    let usage = QUANTITIES.iter().find(|(usage, _)| name_of(usage) == name);
    let usage = usage.map_or(name, |(usage, _)| usage);
    CallError::Misuse(format!(
        "`{name}` cannot be used so with {count} arguments; its form is {usage}"
    ))
}

/// The most residue classes of a constant of an irrational mask.
const MAX_CLASSES: usize = 4_096;

/// A constant of a mask that is not rational, if the call asks for one.
fn irrational<V: Value + PartialEq>(
    call: &Call<'_, V>,
    options: &mut Options<'_>,
    of: &Shape<V>,
) -> Result<Option<V>, CallError> {
    let known = ["contraction", "norm", "tensor", "displacement", "surface_displacement"];
    if !known.contains(&call.function) {
        return Ok(None);
    }
    let mask = numbers(&of.mask)?;
    let norm = |rules: &Rules<RealCyclotomic>, c: u32, order: Order| {
        let classes = rules.arity().checked_pow(c);
        if classes.is_none_or(|classes| classes > MAX_CLASSES) {
            let what = "the number of residue classes of an irrational mask";
            return Err(CallError::BeyondCap(Cap::new(what, MAX_CLASSES as u64)));
        }
        let norm = power_norm_generic(rules, c, order);
        norm.map_err(|error| CallError::BeyondCap(error.cap()))
    };
    let value = match (call.function, call.arguments) {
        ("contraction", c @ ([] | [_])) => {
            let (c, order) = (levels(c)?, options.order()?);
            norm(&mask.difference(), c, order)?
        }
        ("norm", c @ ([] | [_])) => {
            let (c, order) = (levels(c)?, options.order()?);
            norm(mask.rules(), c, order)?
        }
        ("displacement", []) => moved(&mask, options, || None)?,
        (name, _) => {
            return Err(CallError::Misuse(format!("`{name}` is computed for rational masks only")));
        }
    };
    Ok(V::of_number(&value))
}

/// The greatest number of convolutions whose coefficients are summed term by term.
const MAX_CONVOLUTIONS: i64 = 4;

/// The same cap for the printed recursion, which has far more terms.
const MAX_PRINTED_CONVOLUTIONS: i64 = 3;

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
