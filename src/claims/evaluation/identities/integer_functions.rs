//! Functions of formulas that have one value for all integers from one on.

use super::families::{Families, is_open};
use crate::evaluation::arguments::index;
use crate::evaluation::library::Library;
use crate::evaluation::options::Options;
use crate::evaluation::reals::{About, about};
use crate::evaluation::reference::{reference, unresolved};
use crate::evaluation::shape::Coefficients;
use crate::exact::{IntegerFunction, Polynomial};
use crate::formula::{Call, CallError, Context, Functions};
use crate::scheme::Instance;
use crate::spectrum::EverySpectrum;

/// The functions of a relation for all integers t from `first` on.
pub(crate) struct IntegerFunctions<'a> {
    /// Those of schemes that do not depend on t.
    pub(crate) others: Coefficients<'a, IntegerFunction>,
    /// Those of families.
    pub(crate) families: Families<'a>,
    /// The scheme of the claim.
    pub(crate) own: Option<Vec<Instance<IntegerFunction>>>,
    pub(crate) first: i64,
}

impl Functions<IntegerFunction> for IntegerFunctions<'_> {
    fn call(
        &self,
        call: &Call<'_, IntegerFunction>,
        context: &dyn Context<IntegerFunction>,
    ) -> Result<IntegerFunction, CallError> {
        let mut options = Options::new(call);
        let scheme = match options.scheme()? {
            None => self.own.clone(),
            Some(text) => {
                let scheme = self.library().instances(&reference(&text)?, context);
                Some(scheme.map_err(|error| unresolved(&text, error))?)
            }
        };
        let scheme = scheme.unwrap_or_default();
        if about(call.function) == Some(About::Ring)
            && let [valence, rest @ ..] = call.arguments
            && *valence == IntegerFunction::index(self.first)
        {
            let value = self.of_ring(&scheme, call.function, rest, &mut options)?;
            return options.finished(value.ok_or_else(|| unknown(call.function))?);
        }
        if call.arguments.iter().any(|value| value.as_constant().is_none()) {
            return Err(unknown(call.function));
        }
        if !is_open(&scheme) {
            return self.others.call(call, context);
        }
        let value = self.of_family(&scheme, call, &mut options)?;
        options.finished(value)
    }

    fn is_scheme(&self, function: &str, name: &str) -> bool {
        self.others.is_scheme(function, name)
    }
}

impl IntegerFunctions<'_> {
    fn library(&self) -> &Library<'_> {
        self.others.shapes.library()
    }

    /// The value of a function of a ring of the valence t, with its other arguments.
    fn of_ring(
        &self,
        scheme: &[Instance<IntegerFunction>],
        function: &str,
        arguments: &[IntegerFunction],
        options: &mut Options<'_>,
    ) -> Result<Option<IntegerFunction>, CallError> {
        let [instance] = scheme else { return Ok(None) };
        let definition = self.library().define(&instance.name);
        let definition = definition.map_err(|_| unknown(function))?;
        let ring = definition.every_ring(&instance.parameters, self.first);
        let spectrum = ring.and_then(|ring| EverySpectrum::new(ring, self.first));
        let spectrum = spectrum.ok_or_else(|| unknown(function))?;
        Ok(match (function, arguments) {
            ("eigenvalue", [block, number]) => {
                let block = index("the number of a block", block)?;
                let number = usize::try_from(index("the number of an eigenvalue", number)?);
                number.ok().and_then(|number| spectrum.eigenvalue(block, number))
            }
            ("subdominant", []) => spectrum.subdominant(),
            ("curvature", []) => spectrum.curvature(options.part()?),
            ("limit_weight", []) => spectrum.limit_weight(options.take("orbit").as_deref()),
            ("tangent_weight", [point]) => {
                let point = index("the number of a point", point)?;
                let is_second = options.is_second_tangent()?;
                let orbit = options.take("orbit");
                let weight = || spectrum.tangent_weight(point, orbit.as_deref());
                if is_second { None } else { weight() }
            }
            _ => None,
        })
    }

    fn of_family(
        &self,
        scheme: &[Instance<IntegerFunction>],
        call: &Call<'_, IntegerFunction>,
        options: &mut Options<'_>,
    ) -> Result<IntegerFunction, CallError> {
        let polynomial = |(name, value): (&String, &IntegerFunction)| {
            Some((name.clone(), value.as_polynomial()?.in_name(self.families.index)))
        };
        let instance = |one: &Instance<IntegerFunction>| {
            let parameters = one.parameters.iter().map(polynomial).collect::<Option<_>>()?;
            Some(Instance::<Polynomial> { name: one.name.clone(), parameters })
        };
        let scheme = scheme.iter().map(instance).collect::<Option<Vec<_>>>();
        let scheme = scheme.filter(|scheme| is_open(scheme) && call.arguments.is_empty());
        let scheme = scheme.ok_or_else(|| unknown(call.function))?;
        let call =
            Call { function: call.function, arguments: &[], options: call.options, indices: &[] };
        let value = self.families.value(&scheme, &call, options)?;
        Ok(IntegerFunction::polynomial(self.first, &value))
    }
}

/// The error where nothing is known for all values of the index.
fn unknown(function: &str) -> CallError {
    CallError::Undefined(format!("no value of `{function}` for all values of the index is known"))
}
