//! Masks over numbers of any kind, and the functions that read only their coefficients.

use crate::bound::{Recursion, convolution_coefficient, sequence};
use crate::claim::LocatedReference;
use crate::diagnostic::Diagnostic;
use crate::evaluation::arguments::{index, narrow, place, within};
use crate::evaluation::functions::{QUANTITIES, check_name, name_of};
use crate::evaluation::library::Library;
use crate::evaluation::options::Options;
use crate::evaluation::reference::{self, Unresolved, reference, unresolved};
use crate::evaluation::series;
use crate::evaluation::series::Norms;
use crate::exact::Rational;
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
}

impl<V: Value> Shape<V> {
    fn new(scheme: &Scheme<V>) -> Rc<Shape<V>> {
        Rc::new(Shape { mask: scheme.first().clone(), difference: OnceCell::new() })
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
        let found = self.shape(call, &mut options)?;
        let value = shape(&found.mask, || found.difference(), call, &mut options)?;
        options.finished(value)
    }
}

impl<V: Value + PartialEq> Coefficients<'_, V> {
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
pub(crate) fn shape<V: Value, R: Borrow<Rules<V>>>(
    mask: &Mask<V>,
    difference: impl FnOnce() -> R,
    call: &Call<'_, V>,
    options: &mut Options<'_>,
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
