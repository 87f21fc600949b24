//! Printed Hölder exponents, and their comparison with K − log_n(q)/l.

use crate::formulas::{Expr, Head, Scope};
use crate::numbers::{Q, compare, count, int};
use crate::text::Stop;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};
use std::cmp::Ordering;

/// a + Σ c·log_b(x): a, and for each logarithm c, b and x.
#[derive(Clone)]
pub struct LogSum {
    rational: Q,
    terms: Vec<(Q, usize, Q)>,
}

/// K − log_n(q)/l.
pub struct Bound<'q> {
    /// The order K of the sum rules.
    pub order: usize,
    /// The arity n.
    pub arity: usize,
    /// q.
    pub radius: &'q Q,
    /// l.
    pub degree: usize,
}

impl From<Q> for LogSum {
    fn from(rational: Q) -> LogSum {
        LogSum { rational, terms: Vec::new() }
    }
}

fn wrong<T>() -> Result<T, Stop> {
    Err(Stop::Wrong("an exponent is a rational combination of logarithms".into()))
}

/// The base of `log_2`.
fn base(function: &str) -> Option<usize> {
    function.strip_prefix("log_")?.parse().ok().filter(|base| (2..=64).contains(base))
}

impl LogSum {
    /// The value of a formula without names.
    pub fn of(expr: &Expr, scope: &Scope<'_>) -> Result<LogSum, Stop> {
        if !has_logarithm(expr) {
            let value = scope.value(expr)?.rational();
            return value.map_or_else(wrong, |value| Ok(value.into()));
        }
        let Expr::Of(head, parts) = expr else { return wrong() };
        match head {
            Head::Minus => Ok(LogSum::of(&parts[0], scope)?.scaled(&int(-1))),
            Head::Chain(operators) => {
                let mut values = parts.iter().map(|part| LogSum::of(part, scope));
                let Some(first) = values.next() else { return wrong() };
                operators
                    .iter()
                    .zip(values)
                    .try_fold(first?, |sum, (operator, other)| sum.joined(*operator, other?))
            }
            Head::Call(function, options) => match (base(function), &parts[..]) {
                (Some(base), [part]) if options.is_empty() => {
                    let of = scope.value(part)?.rational().filter(Q::is_positive);
                    let term = |of| LogSum { rational: Q::zero(), terms: vec![(int(1), base, of)] };
                    of.map_or_else(wrong, |of| Ok(term(of)))
                }
                _ => wrong(),
            },
            _ => wrong(),
        }
    }

    fn joined(mut self, operator: char, other: LogSum) -> Result<LogSum, Stop> {
        match operator {
            '+' | '-' => {
                let other = if operator == '-' { other.scaled(&int(-1)) } else { other };
                self.rational += other.rational;
                self.terms.extend(other.terms);
                Ok(self)
            }
            '*' if other.terms.is_empty() => Ok(self.scaled(&other.rational)),
            '*' if self.terms.is_empty() => Ok(other.scaled(&self.rational)),
            '/' if other.terms.is_empty() && !other.rational.is_zero() => {
                Ok(self.scaled(&other.rational.recip()))
            }
            _ => wrong(),
        }
    }

    fn scaled(mut self, factor: &Q) -> LogSum {
        self.rational *= factor;
        self.terms.iter_mut().for_each(|(c, ..)| *c *= factor);
        self
    }
}

fn has_logarithm(expr: &Expr) -> bool {
    let own = |of: &&Expr| matches!(of, Expr::Of(Head::Call(f, _), _) if base(f).is_some());
    expr.nodes().iter().any(own)
}

impl Bound<'_> {
    /// How K − log_n(q)/l compares with a + Σ c·log_n(x): n^{K − a} with q^{1/l} Π x^c.
    pub fn compare(&self, value: &LogSum) -> Result<Ordering, Stop> {
        let mut powers = vec![
            (count(self.arity), count(self.order) - &value.rational),
            (self.radius.clone(), -count(self.degree).recip()),
        ];
        for (c, base, of) in &value.terms {
            if *base != self.arity && !of.is_one() {
                return Err(Stop::Capped("logarithms to another base than the arity"));
            }
            powers.push((of.clone(), -c.clone()));
        }
        let common = powers.iter().fold(BigInt::one(), |lcm, (_, e)| lcm.lcm(e.denom()));
        let whole = |e: Q| (e * Q::from_integer(common.clone())).to_integer();
        let powers: Vec<(Q, BigInt)> = powers.into_iter().map(|(x, e)| (x, whole(e))).collect();
        compare(&powers)
    }
}
