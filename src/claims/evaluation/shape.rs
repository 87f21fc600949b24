//! Masks over numbers of any kind, and the functions that read only their coefficients.

use crate::bound::Constants;
use crate::claim::LocatedReference;
use crate::diagnostic::Diagnostic;
use crate::evaluation::functions::{check_name, is_about_scheme, takes_filters};
use crate::evaluation::library::Library;
use crate::evaluation::masks::constants::{constant, constant_by_sums, no_level};
use crate::evaluation::masks::rules::{shape, usage};
use crate::evaluation::masks::{End, of_lattice, rational, smoothness_bound};
use crate::evaluation::options::{Exponent, Options};
use crate::evaluation::reals::{About, Used, about, as_value, is_of_mask_too, of_ring};
use crate::evaluation::reference::{self, Unresolved, reference, unresolved};
use crate::evaluation::series::{self, Norms};
use crate::formula::{Call, CallError, Context, Functions, RealValue, Value};
use crate::scheme::{Instance, LatticeMask, Mask, Reference, Rules};
use std::cell::{OnceCell, RefCell};
use std::rc::Rc;

/// The scheme that a claim is about; of a tensor product, the first.
pub(crate) fn own_shape<V: Value + PartialEq>(
    shapes: &Shapes<'_, V>,
    located: &LocatedReference,
    context: &dyn Context<V>,
) -> Result<Own<V>, Diagnostic> {
    let found = shapes.own(&located.reference, context);
    found.map_err(|error| reference::located(located, &error))
}

/// The scheme of a claim.
pub(crate) enum Own<V> {
    /// A mask; of a tensor product, the first.
    Mask(Rc<Shape<V>>),
    /// A mask on Z^d.
    Lattice(Rc<LatticeMask<V>>),
    /// Rules around a vertex or on a face.
    Ring(Rc<[Instance<V>]>),
}

/// A mask over numbers of any kind; its difference mask is computed when it is first used.
pub(crate) struct Shape<V> {
    pub(crate) mask: Mask<V>,
    /// Whether its rules may have any sums.
    is_filter: bool,
    /// The scheme as certificates name it, if its parameters are rational.
    name: Option<String>,
    difference: OnceCell<Rules<V>>,
    /// The constants, if the mask is rational.
    constants: OnceCell<Option<Rc<Constants>>>,
}

impl<V: Value> Shape<V> {
    fn new(mask: Mask<V>, is_filter: bool, instances: &[Instance<V>]) -> Rc<Shape<V>> {
        let (difference, constants) = Default::default();
        let rational =
            |one: &&Instance<V>| one.parameters.values().all(|value| value.as_rational().is_some());
        let name = instances.first().filter(rational).map(ToString::to_string);
        Rc::new(Shape { mask, is_filter, name, difference, constants })
    }

    /// The constants of the mask, if it is rational.
    fn constants(&self, library: &Library<'_>) -> Option<&Rc<Constants>> {
        let mask = || rational(&self.mask).ok().filter(|_| !self.is_filter);
        let constants = || mask().map(|mask| library.constants_of(mask));
        self.constants.get_or_init(constants).as_ref()
    }

    pub(crate) fn difference(&self) -> &Rules<V> {
        self.difference.get_or_init(|| self.mask.difference())
    }
}

impl<V> Clone for Own<V> {
    fn clone(&self) -> Own<V> {
        match self {
            Own::Mask(shape) => Own::Mask(Rc::clone(shape)),
            Own::Lattice(mask) => Own::Lattice(Rc::clone(mask)),
            Own::Ring(ring) => Own::Ring(Rc::clone(ring)),
        }
    }
}

/// A scheme, with one name and its parameters for each direction, and what it is.
type Known<V> = (Vec<Instance<V>>, Own<V>);

/// The shapes of the schemes in a claim: of its own scheme for the parameters that were used last,
/// and of the schemes that formulas name.
pub(crate) struct Shapes<'a, V> {
    library: &'a Library<'a>,
    /// Whether filters may stand where schemes do.
    filters: bool,
    own: RefCell<Option<Known<V>>>,
    named: RefCell<Vec<Known<V>>>,
    pub(crate) norms: Norms<V>,
    /// The limits that values of the claim rest on.
    pub(crate) used: Used,
}

impl<'a, V: Value + PartialEq> Shapes<'a, V> {
    pub(crate) fn new(library: &'a Library<'a>) -> Shapes<'a, V> {
        let (own, named, norms, used) = Default::default();
        Shapes { library, filters: false, own, named, norms, used }
    }

    /// Those of a relation or an equation, which may name filters.
    pub(crate) fn with_filters(library: &'a Library<'a>) -> Shapes<'a, V> {
        Shapes { filters: true, ..Shapes::new(library) }
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
    ) -> Result<Own<V>, Unresolved> {
        let instances = self.library.instances(reference, context)?;
        if let Some((known, own)) = &*self.own.borrow()
            && *known == instances
        {
            return Ok(own.clone());
        }
        let own = self.scheme(&instances)?;
        *self.own.borrow_mut() = Some((instances, own.clone()));
        Ok(own)
    }

    /// What the scheme of these names is.
    pub(crate) fn scheme(&self, instances: &[Instance<V>]) -> Result<Own<V>, Unresolved> {
        if self.library.is_ring(instances).map_err(Unresolved::Scheme)? {
            return Ok(Own::Ring(instances.into()));
        }
        if let Some(mask) = self.library.lattice(instances).map_err(Unresolved::Scheme)? {
            return Ok(Own::Lattice(Rc::new(mask)));
        }
        if self.filters
            && let Some(filter) = self.library.filter(instances).map_err(Unresolved::Scheme)?
        {
            return Ok(Own::Mask(Shape::new(filter, true, instances)));
        }
        let mask = self.library.masks(instances)?.first().clone();
        Ok(Own::Mask(Shape::new(mask, false, instances)))
    }

    /// The scheme that a reference in a formula means.
    fn named(&self, text: &str, context: &dyn Context<V>) -> Result<Own<V>, CallError> {
        let instances = self.library.instances(&reference(text)?, context);
        let instances = instances.map_err(|error| unresolved(text, error))?;
        if let Some((_, own)) = self.named.borrow().iter().find(|(known, _)| *known == instances) {
            return Ok(own.clone());
        }
        let own = self.scheme(&instances).map_err(|error| unresolved(text, error))?;
        self.named.borrow_mut().push((instances, own.clone()));
        Ok(own)
    }
}

/// The coefficients of a scheme over numbers of any kind, for identities.
pub(crate) struct Coefficients<'a, V> {
    pub(crate) shapes: &'a Shapes<'a, V>,
    pub(crate) own: Option<Own<V>>,
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
        if is_about_scheme(call.function)
            && let Ok(Own::Lattice(mask)) = self.scheme(&mut Options::new(call), context)
        {
            options.scheme()?;
            let other = |name: &str| match self.shapes.named(name, context)? {
                Own::Lattice(mask) => Ok(Some((*mask).clone())),
                Own::Mask(_) => Ok(None),
                Own::Ring(_) => Err(CallError::Misuse(format!("`{name}` is no mask"))),
            };
            let value = of_lattice(&mask, call, &mut options, other)?;
            return options.finished(value);
        }
        if about(call.function).is_some() {
            let value = self.real(call, &mut options, context)?;
            return options.finished(as_value(call.function, &value)?);
        }
        let found = self.shape(call, &mut options, context)?;
        let other = |name: &str| self.named(call.function, name, context);
        let value = match found.constants(self.shapes.library) {
            Some(constants) => constant(call, &mut options, constants)?,
            None => constant_by_sums(call, &mut options, &found.mask)?,
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
    pub(crate) fn named(
        &self,
        function: &str,
        name: &str,
        context: &dyn Context<V>,
    ) -> Result<Mask<V>, CallError> {
        Ok(of_mask_only(function, self.shapes.named(name, context)?)?.mask.clone())
    }

    /// The scheme that a call is about.
    pub(crate) fn shape(
        &self,
        call: &Call<'_, V>,
        options: &mut Options<'_>,
        context: &dyn Context<V>,
    ) -> Result<Rc<Shape<V>>, CallError> {
        check_name(call.function)?;
        of_mask_only(call.function, self.scheme(options, context)?)
    }

    fn scheme(
        &self,
        options: &mut Options<'_>,
        context: &dyn Context<V>,
    ) -> Result<Own<V>, CallError> {
        match options.scheme()? {
            Some(text) => self.shapes.named(&text, context),
            None => self.own.clone().ok_or_else(|| {
                CallError::Misuse("this needs a scheme: give the claim one".to_owned())
            }),
        }
    }

    /// An end of what is known of a call of `smoothness` or `hoelder` on a whole interval of a parameter; the value itself if the scheme does not
    /// depend on it.
    pub(crate) fn end(
        &self,
        call: &Call<'_, V>,
        end: End,
        context: &dyn Context<V>,
    ) -> Result<V, CallError> {
        let mut options = Options::new(call);
        let shape = self.shape(call, &mut options, context)?;
        if rational(&shape.mask).is_err() {
            return options.finished(smoothness_bound(&shape.mask, call.function, end)?);
        }
        let known = self.real(call, &mut Options::new(call), context)?.interval();
        let known = if end == End::Lower { known.lower() } else { known.upper() };
        options.finished(V::from_rational(known))
    }

    /// The value of a function that may be any real number.
    pub(crate) fn real(
        &self,
        call: &Call<'_, V>,
        options: &mut Options<'_>,
        context: &dyn Context<V>,
    ) -> Result<RealValue, CallError> {
        let library = self.shapes.library;
        match (about(call.function), self.scheme(options, context)?) {
            (Some(About::Ring), Own::Mask(shape)) if is_of_mask_too(call) => {
                let shape = of_mask_only(call.function, Own::Mask(shape))?;
                library.reals.eigenvalue(&shape.mask, &call.arguments[0])
            }
            (Some(About::Ring), Own::Ring(ring)) => {
                let rules = |ring: &[_], valence| library.ring_of_valence(ring, valence);
                of_ring(&library.reals, &ring, &rules, call, options)
            }
            (Some(About::Ring), Own::Mask(_)) => Err(CallError::Misuse(format!(
                "`{}` is about rules around a vertex or on a face, such as `loop`, and this is a mask",
                call.function
            ))),
            (_, own) => {
                let shape = of_mask_only(call.function, own)?;
                let used = (&shape.name, &self.shapes.used);
                library.reals.of_mask(&shape.mask, call, &library.limits, used)
            }
        }
    }
}

/// The scheme if it is a mask.
fn of_mask_only<V>(what: &str, own: Own<V>) -> Result<Rc<Shape<V>>, CallError> {
    match own {
        Own::Mask(shape) if shape.is_filter && !takes_filters(what) => {
            Err(CallError::Misuse(format!(
                "`{what}` is about schemes, and this is a filter, whose rules may have any sums"
            )))
        }
        Own::Mask(shape) => Ok(shape),
        Own::Lattice(_) => Err(CallError::Misuse(format!(
            "`{what}` is about masks of curves, and this is a mask on Z^d, of which this cannot be claimed yet"
        ))),
        Own::Ring(_) => Err(CallError::Misuse(format!(
            "`{what}` is about a mask, and these are rules around a vertex or on a face; their functions are `eigenvalue`, \
             `subdominant`, `curvature`, `limit_weight` and `tangent_weight`"
        ))),
    }
}
