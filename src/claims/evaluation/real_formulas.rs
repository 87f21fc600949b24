//! Formulas whose values are real numbers of any kind.

use crate::evaluation::options::Options;
use crate::evaluation::reals::about;
use crate::evaluation::shape::Coefficients;
use crate::exact::Polynomial;
use crate::formula::{Call, CallError, Context, Functions, Lookup, RealValue, Value as _};

/// The functions of formulas of real numbers: those of formulas of polynomials, and those that these have no value of.
pub(crate) struct Reals<'a> {
    pub(crate) coefficients: &'a Coefficients<'a, Polynomial>,
}

/// The numbers of a field Q(2cos(2π/n)) among the values of names.
struct Numbers<'a>(&'a dyn Context<RealValue>);

impl Context<Polynomial> for Numbers<'_> {
    fn name(
        &self,
        name: &str,
        _: &[(String, Polynomial)],
    ) -> Result<Lookup<Polynomial>, CallError> {
        Ok(match self.0.name(name, &[])? {
            Lookup::Found(value) => match value.number() {
                Some(number) => Lookup::Found(Polynomial::constant(number)),
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
        let number = |value: &RealValue| {
            value.number().map(Polynomial::constant).ok_or_else(|| {
                let function = call.function;
                let message =
                    format!("`{function}` is computed of numbers of a field Q(2cos(2π/n))");
                CallError::Misuse(format!("{message}, and not of {value}"))
            })
        };
        let arguments = call.arguments.iter().map(number);
        let arguments = arguments.collect::<Result<Vec<Polynomial>, CallError>>()?;
        let indices = call.indices.iter().map(|(name, value)| Ok((name.clone(), number(value)?)));
        let indices = indices.collect::<Result<Vec<(String, Polynomial)>, CallError>>()?;
        let call = Call {
            function: call.function,
            arguments: &arguments,
            options: call.options,
            indices: &indices,
        };
        if about(call.function).is_some() {
            let mut options = Options::new(&call);
            let value = self.coefficients.real(&call, &mut options, &Numbers(context))?;
            return options.finished(value);
        }
        let value = self.coefficients.call(&call, &Numbers(context))?;
        let number = value.number();
        number
            .and_then(|number| RealValue::of_number(&number))
            .ok_or_else(|| CallError::Misuse(format!("this is {value}, and no number")))
    }

    fn is_scheme(&self, function: &str, name: &str) -> bool {
        self.coefficients.is_scheme(function, name)
    }
}
