//! Formulas whose values are real numbers of any kind.

use crate::cap::Cap;
use crate::evaluation::options::Options;
use crate::evaluation::reals::about;
use crate::evaluation::shape::Coefficients;
use crate::exact::{
    AlgebraicNumber, FieldElement, MAX_ROOT_DEGREE, Polynomial, Rational, RealAlgebraic,
    RealCyclotomic, RealExpression, Scalar as _,
};
use crate::formula::{Call, CallError, Context, Functions, Lookup, RealValue, Value};

/// The functions of formulas of real numbers: those of formulas of polynomials, and those that these have no value of.
pub(crate) struct Reals<'a> {
    /// Those of masks of numbers of a field Q(2cos(2π/n)); none if the scheme of the claim has no such mask.
    pub(crate) coefficients: Option<&'a Coefficients<'a, Polynomial>>,
    /// Those of masks over any real field.
    pub(crate) in_fields: &'a dyn Fn() -> Result<Coefficients<'a, AlgebraicNumber>, CallError>,
}

/// The numbers among the values of names that another type of values has.
struct Numbers<'a>(&'a dyn Context<RealValue>);

impl<V: Value> Context<V> for Numbers<'_> {
    fn name(&self, name: &str, _: &[(String, V)]) -> Result<Lookup<V>, CallError> {
        Ok(match self.0.name(name, &[])? {
            Lookup::Found(value) => match value.number().and_then(|number| V::of_number(&number)) {
                Some(number) => Lookup::Found(number),
                None => Lookup::Unstated,
            },
            Lookup::Unstated => Lookup::Unstated,
            Lookup::Unknown => Lookup::Unknown,
        })
    }

    fn names(&self) -> Vec<String> {
        self.0.names()
    }
}

impl Functions<RealValue> for Reals<'_> {
    fn call(
        &self,
        call: &Call<'_, RealValue>,
        context: &dyn Context<RealValue>,
    ) -> Result<RealValue, CallError> {
        let found = self.coefficients.map(|coefficients| {
            let number = |value: Polynomial| {
                let number = value.number();
                let number = number.and_then(|number| RealValue::of_number(&number));
                number.ok_or_else(|| CallError::Misuse(format!("this is {value}, and no number")))
            };
            called(coefficients, call, context, number)
        });
        match found {
            Some(Ok(value)) => Ok(value),
            Some(Err(error @ CallError::BeyondCap(_))) => Err(error),
            // The reason why there is no value over any field is the better one: it is never that of the first field.
            Some(Err(_)) | None => self.called_in_field(call, context),
        }
    }

    fn is_scheme(&self, function: &str, name: &str) -> bool {
        match self.coefficients {
            Some(coefficients) => coefficients.is_scheme(function, name),
            None => (self.in_fields)().is_ok_and(|found| found.is_scheme(function, name)),
        }
    }
}

impl Reals<'_> {
    fn called_in_field(
        &self,
        call: &Call<'_, RealValue>,
        context: &dyn Context<RealValue>,
    ) -> Result<RealValue, CallError> {
        let coefficients = (self.in_fields)()?;
        called(&coefficients, call, context, |value| of_field(value.element()).map(RealValue::from))
    }
}

/// The value of a call, whose arguments are numbers of another type.
fn called<V: Value + PartialEq>(
    coefficients: &Coefficients<'_, V>,
    call: &Call<'_, RealValue>,
    context: &dyn Context<RealValue>,
    number: impl Fn(V) -> Result<RealValue, CallError>,
) -> Result<RealValue, CallError> {
    let argument = |value: &RealValue| {
        value.number().and_then(|number| V::of_number(&number)).ok_or_else(|| {
            let function = call.function;
            let message = format!("`{function}` is computed of numbers of a field Q(2cos(2π/n))");
            CallError::Misuse(format!("{message}, and not of {value}"))
        })
    };
    let arguments = call.arguments.iter().map(argument);
    let arguments = arguments.collect::<Result<Vec<V>, CallError>>()?;
    let indices = call.indices.iter().map(|(name, value)| Ok((name.clone(), argument(value)?)));
    let indices = indices.collect::<Result<Vec<(String, V)>, CallError>>()?;
    let call = Call {
        function: call.function,
        arguments: &arguments,
        options: call.options,
        indices: &indices,
    };
    if about(call.function).is_some() {
        let mut options = Options::new(&call);
        let value = coefficients.real(&call, &mut options, &Numbers(context))?;
        return options.finished(value);
    }
    number(coefficients.call(&call, &Numbers(context))?)
}

/// A number of a real field as a real number of any kind.
fn of_field(element: &FieldElement) -> Result<RealExpression, CallError> {
    let Some((root, minimal)) = element.field() else {
        return Ok(RealExpression::from(element.as_rational().unwrap_or_else(Rational::zero)));
    };
    let below = RealAlgebraic::roots_of(minimal).iter().filter(|other| *other < root).count();
    let coefficients = minimal.coefficients().iter().map(|c| RealCyclotomic::from(c.clone()));
    let coefficients: Vec<RealCyclotomic> = coefficients.collect();
    let generator = RealExpression::root(&coefficients, below + 1);
    let generator = generator.map_err(|_| {
        let what = "the degree of the field of a value that is compared";
        CallError::BeyondCap(Cap::new(what, MAX_ROOT_DEGREE as u64))
    })?;
    let terms = element.coordinates().coefficients();
    Ok(terms.iter().rev().fold(RealExpression::zero(), |sum, c| {
        sum.times(&generator).plus(&RealExpression::from(c.clone()))
    }))
}
