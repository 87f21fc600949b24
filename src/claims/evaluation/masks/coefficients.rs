//! Functions of masks that read only coefficients, and compare them.

use super::common::check_pair;
use super::generic::{Asked, answered};
use crate::evaluation::arguments::{narrow, within};
use crate::evaluation::options::{Data, Options, Parameters};
use crate::exact::{Rational, Real};
use crate::facts::{centre, is_interpolating};
use crate::formula::{Call, CallError, Value};
use crate::scheme::Mask;
use crate::smoothness::{
    Symbol, is_hurwitz, keeps_ratios, moments, reproduction_degree, reproduction_degree_at,
    vanishing_moments,
};
use std::fmt::Display;

/// The greatest m of a moment.
const MAX_MOMENT: i64 = 64;

/// The greatest order of differences whose ratios are bounded.
const MAX_DIFFERENCES: i64 = 8;

/// What is asked of a mask.
enum Coefficients {
    Support,
    SupportStart,
    SupportEnd,
    Symmetric,
    Interpolating,
    SumRules,
    Generation,
    Reproduction(Parameters),
    ApproximationOrder(Data),
    Moment(u32),
    VanishingMoments,
    Hurwitz,
    /// Whether a bound of the ratios of neighbouring differences of this order is kept.
    KeepsRatios(usize),
    /// Whether it is dual to the last mask: another one, or itself.
    Dual,
}

/// The value of a function that compares coefficients; `None` if there is no such function of so many arguments.
pub(super) fn of_coefficients<V: Value + PartialEq>(
    mask: &Mask<V>,
    call: &Call<'_, V>,
    options: &mut Options<'_>,
    other: impl FnOnce(&str) -> Result<Mask<V>, CallError>,
) -> Result<Option<V>, CallError> {
    let (mut second, mut others) = (None, Vec::new());
    let asked = match (call.function, call.arguments) {
        ("support", []) => Coefficients::Support,
        ("support_start", []) => Coefficients::SupportStart,
        ("support_end", []) => Coefficients::SupportEnd,
        ("symmetric", []) => Coefficients::Symmetric,
        ("interpolating", []) => Coefficients::Interpolating,
        ("sum_rules", []) => Coefficients::SumRules,
        ("generation", []) => Coefficients::Generation,
        ("reproduction", []) => Coefficients::Reproduction(options.parameters()?),
        ("approximation_order", []) => Coefficients::ApproximationOrder(options.data()?),
        ("moment", [m]) => {
            Coefficients::Moment(narrow(within("the order of a moment", m, 0..=MAX_MOMENT)?))
        }
        ("vanishing_moments", []) => Coefficients::VanishingMoments,
        ("hurwitz", []) => Coefficients::Hurwitz,
        ("keeps_ratios", [m, ratio]) => {
            others.push(ratio);
            let order = within("the order of differences", m, 0..=MAX_DIFFERENCES)?;
            Coefficients::KeepsRatios(order)
        }
        ("orthogonal", []) => Coefficients::Dual,
        ("biorthogonal", []) => {
            let Some(name) = options.take("with") else {
                let message = "name the other scheme: `biorthogonal(with = NAME)`";
                return Err(CallError::Misuse(message.to_owned()));
            };
            second = Some(other(&name)?);
            Coefficients::Dual
        }
        _ => return Ok(None),
    };
    let masks: Vec<&Mask<V>> = [mask].into_iter().chain(&second).collect();
    answered(&asked, &masks, &others).map(Some)
}

impl Asked for Coefficients {
    fn value<F: Real + PartialEq + Display>(
        &self,
        masks: &[Mask<F>],
        others: &[F],
    ) -> Result<F, CallError> {
        let mask = &masks[0];
        let number = |value: Rational| F::from_rational(&value);
        let truth = |holds: bool| number(Rational::from(i64::from(holds)));
        let count = |count: usize| number(Rational::from(count));
        let degree = |parameters: Parameters| match parameters {
            Parameters::Natural => reproduction_degree(mask),
            Parameters::Indexed => reproduction_degree_at(mask, &F::zero()),
        };
        let symbol = Symbol::of(mask);
        Ok(match self {
            Coefficients::Support => {
                let (first, last) = symbol.support();
                number(last - first)
            }
            Coefficients::SupportStart => number(symbol.support().0),
            Coefficients::SupportEnd => number(symbol.support().1),
            Coefficients::Symmetric => truth(centre(&symbol).is_some()),
            Coefficients::Interpolating => truth(is_interpolating(mask)),
            Coefficients::SumRules | Coefficients::ApproximationOrder(Data::Adapted) => {
                count(symbol.sum_rules().0)
            }
            // The rules sum to 1, so that the order is 1 at least.
            Coefficients::Generation => count(symbol.sum_rules().0 - 1),
            Coefficients::Reproduction(parameters) => count(degree(*parameters)),
            Coefficients::ApproximationOrder(Data::Sampled) => {
                count(degree(Parameters::Natural) + 1)
            }
            Coefficients::Moment(m) => moments(&symbol, *m).pop().unwrap_or_else(F::zero),
            Coefficients::VanishingMoments => count(vanishing_moments(symbol.coefficients())),
            Coefficients::Hurwitz => truth(is_hurwitz(&symbol)),
            Coefficients::KeepsRatios(order) => {
                let ratio = &others[0];
                let one = number(Rational::one());
                if one.greater(ratio) != *ratio {
                    let message = "a bound r of ratios is 1 or more: they are between 1/r and r";
                    return Err(CallError::Misuse(message.to_owned()));
                }
                truth(keeps_ratios(&symbol, *order, ratio).ok_or_else(|| {
                    CallError::Undefined(format!(
                        "the differences of order {order} are refined by no scheme, as there are fewer sum rules"
                    ))
                })?)
            }
            Coefficients::Dual => {
                let second = masks.last().unwrap_or(mask);
                check_pair(mask, second)?;
                truth(symbol.is_dual_to(&Symbol::of(second)))
            }
        })
    }
}
