//! Reading printed exponents: rational numbers, and rational combinations of logarithms.

use crate::claim::PrintedExponent;
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::{LogSum, LogTerm, Rational};
use crate::formula::{Expr, LocatedFormula, Node, Operator, Parameters, evaluate};
use std::ops::Range;
use std::sync::Arc;

/// The greatest base of a logarithm.
const MAX_BASE: usize = 64;

/// The most binary digits of the numerator or the denominator of a rational number.
const MAX_BITS: u64 = 256;

/// The most logarithms.
const MAX_TERMS: usize = 8;

const HELP: &str = "an exponent is a sum of rational numbers and of multiples of logarithms of rational numbers: \
                    '2', '6 - log_2(9)', '2 - 1/2*log_3(5)'; any other number is printed as a decimal: printed = '2.830'";

/// Reads a formula such as `6 - log_2(9)`.
pub(super) fn exponent(
    source: &Arc<SourceText>,
    span: Range<usize>,
    text: &str,
) -> Result<PrintedExponent, Diagnostic> {
    let formula = LocatedFormula::read(source, span.clone(), text)?;
    let value = sum(&formula, &formula.expr)?;
    if value.terms.len() > MAX_TERMS {
        let message = format!("an exponent with more than {MAX_TERMS} logarithms");
        return Err(Diagnostic::new(source, span, message).with_help(HELP));
    }
    Ok(PrintedExponent { text: text.to_owned(), value })
}

fn sum(formula: &LocatedFormula, expr: &Expr) -> Result<LogSum, Diagnostic> {
    if !has_logarithm(expr) {
        return rational(formula, expr).map(LogSum::from);
    }
    let minus = Rational::from(-1);
    match &expr.node {
        Node::Negate(operand) => Ok(sum(formula, operand)?.scaled(&minus)),
        Node::Chain(first, rest) => {
            rest.iter().try_fold(sum(formula, first)?, |value, (operator, operand)| {
                let other = sum(formula, operand)?;
                match operator {
                    Operator::Add => Ok(value.plus(other)),
                    Operator::Subtract => Ok(value.plus(other.scaled(&minus))),
                    Operator::Multiply if other.terms.is_empty() => {
                        Ok(value.scaled(&other.rational))
                    }
                    Operator::Multiply if value.terms.is_empty() => {
                        Ok(other.scaled(&value.rational))
                    }
                    Operator::Divide if other.terms.is_empty() && !other.rational.is_zero() => {
                        Ok(value.scaled(&other.rational.recip()))
                    }
                    _ => Err(refused(formula)),
                }
            })
        }
        Node::Call { function, arguments, options } => {
            let base = base(function).filter(|_| options.is_empty());
            let (Some(base), [argument]) = (base, &arguments[..]) else {
                return Err(refused(formula));
            };
            let of = rational(formula, argument)?;
            if of.sign() <= 0 {
                return Err(refused(formula));
            }
            let term = LogTerm { factor: Rational::one(), base, of };
            Ok(LogSum { rational: Rational::zero(), terms: vec![term] })
        }
        _ => Err(refused(formula)),
    }
}

/// The base of `log_2`, if this is the name of a logarithm.
fn base(function: &str) -> Option<usize> {
    let base = function.strip_prefix("log_")?.parse().ok()?;
    (2..=MAX_BASE).contains(&base).then_some(base)
}

fn has_logarithm(expr: &Expr) -> bool {
    expr.functions().iter().any(|function| base(function).is_some())
}

fn rational(formula: &LocatedFormula, expr: &Expr) -> Result<Rational, Diagnostic> {
    let value = evaluate(expr, &Parameters::<Rational>::default());
    let value = value.map_err(|error| formula.diagnostic(&error).with_help(HELP))?;
    if value.numerator().bits().max(value.denominator().bits()) > MAX_BITS {
        let message = format!("a number of an exponent has more than {MAX_BITS} binary digits");
        return Err(Diagnostic::new(&formula.source, formula.span.clone(), message).with_help(HELP));
    }
    Ok(value)
}

fn refused(formula: &LocatedFormula) -> Diagnostic {
    let message = format!("`{}` is not of the form that an exponent has", formula.text);
    Diagnostic::new(&formula.source, formula.span.clone(), message).with_help(HELP)
}
