//! How a bound depends on the level, and on the spread.

use crate::diagnostic::Diagnostic;
use crate::evaluation::settings::Settings;
use crate::exact::{Rational, RealCyclotomic, Scalar};
use crate::formula::{Expr, FreeNames, LocatedFormula, Node, Operator};
use crate::judge::theorem::case::Case;
use crate::judge::theorem::evaluate::{LEVEL, SPREADS};

/// The greatest period, and the greatest power of a ratio, that is considered.
const MAX_PERIOD: u32 = 64;

/// by(k + period) = ratio·by(k) for every k, and by is a multiple of beta^spreads.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Growth {
    pub(crate) period: u32,
    pub(crate) ratio: RealCyclotomic,
    pub(crate) spreads: i32,
}

impl Growth {
    fn constant() -> Growth {
        Growth { period: 1, ratio: Rational::one().into(), spreads: 0 }
    }

    /// ratio^times.
    pub(crate) fn power(&self, times: u32) -> RealCyclotomic {
        let one: RealCyclotomic = Rational::one().into();
        (0..times).fold(one, |power, _| power.times(&self.ratio))
    }

    fn times(&self, other: &Growth, divides: bool) -> Option<Growth> {
        let period = least_common(self.period, other.period)?;
        let own = self.power(period / self.period);
        let others = other.power(period / other.period);
        let zero = RealCyclotomic::from(Rational::zero());
        let ratio = match divides {
            false => own.times(&others),
            true if others != zero => &own / &others,
            true => return None,
        };
        let spreads = if divides { -other.spreads } else { other.spreads };
        Some(Growth { period, ratio, spreads: self.spreads.checked_add(spreads)? })
    }
}

/// The growth of a bound, if it is made of constants, beta, and powers with k in their exponents
/// only; `None` for another form. Bounds with beta_1, beta_2 or beta_3 have none: what holds if all
/// are 1 need not hold for other nets.
pub(crate) fn growth(
    case: &Case<'_>,
    by: &LocatedFormula,
    settings: &Settings,
) -> Result<Option<Growth>, Diagnostic> {
    let reader = Reader { case, by, settings };
    reader.of(&by.expr, 0)
}

struct Reader<'a> {
    case: &'a Case<'a>,
    by: &'a LocatedFormula,
    settings: &'a Settings,
}

impl Reader<'_> {
    /// Whether an expression depends on the level or on a spread.
    fn depends(&self, expr: &Expr) -> bool {
        let free = FreeNames::new(self.case.definitions(self.settings)).of(expr);
        free.contains(LEVEL) || SPREADS.iter().any(|spread| free.contains(*spread))
    }

    fn value(&self, expr: &Expr) -> Result<Option<RealCyclotomic>, Diagnostic> {
        Ok(self.case.evaluate_part(self.by, expr, &[], self.settings)?.ok())
    }

    fn of(&self, expr: &Expr, depth: u32) -> Result<Option<Growth>, Diagnostic> {
        if !self.depends(expr) {
            return Ok(Some(Growth::constant()));
        }
        if depth > MAX_PERIOD {
            return Ok(None);
        }
        match &expr.node {
            Node::Name(name) if name == SPREADS[0] => {
                Ok(Some(Growth { spreads: 1, ..Growth::constant() }))
            }
            Node::Name(name) if name != LEVEL && !self.case.has_value(name) => {
                match self.case.definitions(self.settings).get(name) {
                    Some(definition) => self.of(&definition.expr, depth + 1),
                    None => Ok(None),
                }
            }
            Node::Negate(operand) => self.of(operand, depth + 1),
            Node::Power(base, exponent) if !self.depends(base) => {
                let (exponent, inverse) = match &exponent.node {
                    Node::Negate(operand) => (&**operand, true),
                    _ => (&**exponent, false),
                };
                let (Some((period, step)), Some(base)) = (self.slope(exponent)?, self.value(base)?)
                else {
                    return Ok(None);
                };
                if inverse && base.sign() == 0 {
                    return Ok(None);
                }
                let base = if inverse { base.recip() } else { base };
                let ratio = Growth { ratio: base, ..Growth::constant() }.power(step);
                Ok(Some(Growth { period, ratio, spreads: 0 }))
            }
            Node::Chain(first, rest) => {
                let Some(mut growth) = self.of(first, depth + 1)? else { return Ok(None) };
                for (operator, operand) in rest {
                    let Some(next) = self.of(operand, depth + 1)? else { return Ok(None) };
                    let combined = match operator {
                        Operator::Multiply => growth.times(&next, false),
                        Operator::Divide => growth.times(&next, true),
                        Operator::Add | Operator::Subtract => (growth == next).then_some(next),
                    };
                    let Some(combined) = combined else { return Ok(None) };
                    growth = combined;
                }
                Ok(Some(growth))
            }
            _ => Ok(None),
        }
    }

    /// (p, s) such that this exponent grows by s when k grows by p, for the forms k, k − m, m*k and
    /// floor(k/p).
    fn slope(&self, exponent: &Expr) -> Result<Option<(u32, u32)>, Diagnostic> {
        let count = |expr: &Expr| -> Result<Option<u32>, Diagnostic> {
            let value = self.value(expr)?;
            let value = value.as_ref().and_then(RealCyclotomic::as_rational).cloned();
            let integer = value.filter(Rational::is_integer);
            let count = integer.and_then(|value| u32::try_from(value.numerator().to_i64()?).ok());
            Ok(count.filter(|count| (1..=MAX_PERIOD).contains(count)))
        };
        Ok(match &exponent.node {
            Node::Name(name) if name == LEVEL => Some((1, 1)),
            Node::Chain(first, rest) if self.depends(first) => {
                let Some((period, mut step)) = self.slope(first)? else { return Ok(None) };
                for (operator, operand) in rest {
                    match operator {
                        _ if self.depends(operand) => return Ok(None),
                        Operator::Add | Operator::Subtract => {}
                        Operator::Multiply => match count(operand)? {
                            Some(factor) => step *= factor,
                            None => return Ok(None),
                        },
                        Operator::Divide => return Ok(None),
                    }
                }
                (step <= MAX_PERIOD).then_some((period, step))
            }
            Node::Chain(first, rest) => match &rest[..] {
                [(Operator::Multiply, operand)] => match (count(first)?, self.slope(operand)?) {
                    (Some(factor), Some((period, step))) => Some((period, step * factor)),
                    _ => None,
                },
                _ => None,
            },
            Node::Call { function, arguments, .. } if function == "floor" => {
                match arguments.first().map(|argument| &argument.node) {
                    Some(Node::Chain(first, rest)) => match (&first.node, &rest[..]) {
                        (Node::Name(name), [(Operator::Divide, by)]) if name == LEVEL => {
                            count(by)?.map(|period| (period, 1))
                        }
                        _ => None,
                    },
                    _ => None,
                }
            }
            _ => None,
        })
    }
}

fn least_common(left: u32, right: u32) -> Option<u32> {
    (1..=MAX_PERIOD).find(|period| period % left == 0 && period % right == 0)
}
