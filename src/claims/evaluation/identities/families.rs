//! Functions of schemes whose parameters depend on an index that has all values.

use crate::evaluation::masks::of_mask;
use crate::evaluation::options::{Data, Options, Parameters};
use crate::evaluation::reals::about;
use crate::evaluation::reference::{reference, unresolved};
use crate::evaluation::shape::Coefficients;
use crate::exact::{Polynomial, Rational, RationalPolynomial};
use crate::formula::{Call, CallError, Context, Functions, Value};
use crate::scheme::Instance;
use crate::smoothness::SymbolFamily;

/// The functions of a relation for all integers t from `first` on.
pub(crate) struct Families<'a> {
    /// Those of schemes that do not depend on t.
    pub(crate) others: Coefficients<'a, Polynomial>,
    /// The scheme of the claim, if it depends on t.
    pub(crate) own: Option<Vec<Instance<Polynomial>>>,
    /// The name of t.
    pub(crate) index: &'a str,
    pub(crate) first: i64,
}

/// Whether a scheme depends on an index without a value.
pub(crate) fn is_open<V: Value>(scheme: &[Instance<V>]) -> bool {
    scheme.iter().flat_map(|one| one.parameters.values()).any(|value| value.number().is_none())
}

impl Functions<Polynomial> for Families<'_> {
    fn call(
        &self,
        call: &Call<'_, Polynomial>,
        context: &dyn Context<Polynomial>,
    ) -> Result<Polynomial, CallError> {
        let mut options = Options::new(call);
        let named = match options.scheme()? {
            None => None,
            Some(text) => {
                let scheme = self.others.shapes.library().instances(&reference(&text)?, context);
                let scheme = scheme.map_err(|error| unresolved(&text, error))?;
                if !is_open(&scheme) {
                    return self.others.call(call, context);
                }
                Some(scheme)
            }
        };
        match (named.as_ref().or(self.own.as_ref()), named.is_some() || is_taken(call.function)) {
            (Some(scheme), true) => {
                let value = self.value(scheme, call, &mut options)?;
                options.finished(value.in_name(self.index))
            }
            _ => self.others.call(call, context),
        }
    }

    fn is_scheme(&self, function: &str, name: &str) -> bool {
        self.others.is_scheme(function, name)
    }
}

/// Whether a function of a scheme that depends on t may have a value here.
fn is_taken(function: &str) -> bool {
    [
        "arity",
        "support_start",
        "support_end",
        "support",
        "sum_rules",
        "generation",
        "reproduction",
        "approximation_order",
        "symmetric",
    ]
    .contains(&function)
        || change(function, 2).is_some()
}

/// What powers of σ(z), which are added to a symbol, change in the value of a function.
enum Change {
    /// It grows by 1 with each power.
    Grows,
    /// It depends on the zeros of the symbol alone, and stays what it is.
    Stays,
    /// This is the greatest or the least value that there is, and stays what it is.
    StaysAt(Rational),
}

/// The change in a function of masks of this arity, if it is known.
fn change(function: &str, arity: usize) -> Option<Change> {
    Some(match function {
        "smoothness" | "hoelder" | "sobolev" => Change::Grows,
        "independent" | "hurwitz" => Change::Stays,
        "positive" | "monotone" | "convex" | "overshoot" | "gibbs" | "riesz_upper" => {
            Change::StaysAt(Rational::one())
        }
        "modulus_upper" => Change::StaysAt(Rational::from(arity)),
        _ => return None,
    })
}

impl Families<'_> {
    /// The value of a function of a scheme that depends on t.
    pub(crate) fn value(
        &self,
        scheme: &[Instance<Polynomial>],
        call: &Call<'_, Polynomial>,
        options: &mut Options<'_>,
    ) -> Result<RationalPolynomial, CallError> {
        let [instance] = scheme else { return Err(unknown(call)) };
        if !call.arguments.is_empty() {
            return Err(unknown(call));
        }
        let definition = self.others.shapes.library().define(&instance.name);
        let definition = definition.map_err(|_| unknown(call))?;
        let powers = definition.powers(&instance.parameters, (self.index, self.first));
        let family = powers.and_then(|powers| SymbolFamily::of(&powers, self.first));
        let family = family.ok_or_else(|| unknown(call))?;
        let one = RationalPolynomial::constant(Rational::one());
        let [start, end] = family.support();
        let value = match call.function {
            "arity" => Some(RationalPolynomial::constant(Rational::from(family.arity()))),
            "support_start" => Some(start),
            "support_end" => Some(end),
            "support" => Some(end.minus(&start)),
            "sum_rules" => family.sum_rules(),
            "generation" => family.sum_rules().map(|order| order.minus(&one)),
            "reproduction" => match options.parameters()? {
                Parameters::Natural => family.reproduction(),
                Parameters::Indexed => None,
            },
            "approximation_order" => match options.data()? {
                Data::Sampled => family.reproduction().map(|degree| degree.plus(&one)),
                Data::Adapted => family.sum_rules(),
            },
            "symmetric" => family.is_symmetric().then_some(one),
            _ => self.by_first(&family, instance, call, options)?,
        };
        value.ok_or_else(|| unknown(call))
    }

    /// The value at the first t, and by how much it grows. Where the members have the same zeros, what depends on these does not change; and least and
    /// greatest values stay what they are.
    fn by_first(
        &self,
        family: &SymbolFamily,
        instance: &Instance<Polynomial>,
        call: &Call<'_, Polynomial>,
        options: &mut Options<'_>,
    ) -> Result<Option<RationalPolynomial>, CallError> {
        let Some((change, added)) = change(call.function, family.arity()).zip(family.added())
        else {
            return Ok(None);
        };
        let first = Rational::from(family.first());
        let at_first = |(name, value): (&String, &Polynomial)| {
            let value = value.in_variable(self.index)?.value_at(&first);
            Some((name.clone(), Polynomial::constant(value)))
        };
        let Some(parameters) = instance.parameters.iter().map(at_first).collect() else {
            return Ok(None);
        };
        let scheme = Instance { name: instance.name.clone(), parameters };
        let library = self.others.shapes.library();
        let name = scheme.to_string();
        let masks = library.masks(std::slice::from_ref(&scheme));
        let masks = masks.map_err(|error| unresolved(&name, error))?;
        let mask = masks.first();
        let start = if about(call.function).is_some() {
            let used = (&Some(name), &self.others.shapes.used);
            library.reals.of_mask(mask, call, &library.limits, used)?.as_rational()
        } else {
            let none = |_: &str| Err(unknown(call));
            let value = of_mask(mask, call, options, none, &library.limits)?;
            value.and_then(|value| value.as_rational())
        };
        let Some(start) = start else { return Ok(None) };
        let has_value = match &change {
            // Limits that are not continuous may grow otherwise.
            Change::Grows => call.function == "sobolev" || start.sign() >= 0,
            Change::Stays => true,
            Change::StaysAt(value) => start == *value,
        };
        Ok(has_value.then(|| {
            let grows = matches!(change, Change::Grows);
            let added = Rational::from(if grows { added } else { 0 });
            RationalPolynomial::new(&[start - &added * &first, added])
        }))
    }
}

/// The error where nothing is known for all values of the index.
fn unknown(call: &Call<'_, Polynomial>) -> CallError {
    let function = call.function;
    CallError::Undefined(format!("no formula of `{function}` for all values of the index is known"))
}
