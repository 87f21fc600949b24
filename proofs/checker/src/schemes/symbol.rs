//! A mask by its symbol Σ_k a_k z^k: the formula is multiplied out.

use super::laurent::{Laurent, Powers, add, negated, sum};
use super::scheme::{MAX_ARITY, Scheme};
use crate::formulas::{
    Expr, Head, Indices, MAX_INTEGER, Scope, formula, is_name, names, number_of, of_nothing, range,
};
use crate::numbers::Value;
use crate::text::Stop;
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::rc::Rc;

/// The variable.
pub(super) const Z: [(&str, i64); 1] = [("z", 1)];

/// The function that gives the symbol of another scheme.
const OTHER: &str = "symbol";

/// How deep the formulas in variables may be nested, with those that they name.
const MAX_DEPTH: usize = 200;

/// What another scheme gives to a symbol.
pub(super) enum Other<P> {
    /// A mask of curves, whose symbol is taken at a monomial.
    Curve(Rc<Scheme>),
    /// The symbol of a mask in the same variables.
    Whole(Laurent<P>),
}

/// What gives the other schemes whose symbols a symbol may name, with values of their parameters.
pub(super) type Others<'o, P> = dyn Fn(&str, Indices) -> Result<Other<P>, Stop> + 'o;

/// What `symbol` takes besides a scheme.
const MONOMIAL: &str = "`symbol` takes one power cz^m of z, or of all variables, c ≠ 0 ≠ m";

/// The offset and the rules of a symbol: a_k is in the rule α = k mod n, of the point (α − k)/n. The arity n is stated, or
/// else the value at z = 1.
pub(super) fn mask(
    text: &str,
    stated: Option<&str>,
    scope: &Scope<'_>,
    others: &Others<'_, i64>,
) -> Result<(i64, Vec<Vec<Value>>), Stop> {
    let expansion = Expansion { scope, variables: &Z, others };
    let symbol = expansion.of(&formula(text)?, &mut Vec::new(), 0)?;
    let n = match stated {
        Some(arity) => scope.value(&formula(arity)?)?,
        None => Value::total(symbol.values())?,
    };
    let n = n.integer(MAX_ARITY.into())?;
    if n < 2 {
        return Err(wrong("its value at z = 1 is no arity"));
    }
    let place = |k: i64| (k.rem_euclid(n) - k) / n;
    let (Some((low, _)), Some((high, _))) = (symbol.first_key_value(), symbol.last_key_value())
    else {
        return Err(wrong("it is 0"));
    };
    let (first, last) = (place(*high), place(*low));
    let coefficient = |k: i64| symbol.get(&k).cloned().unwrap_or_else(|| Value::int(0));
    let row = |alpha: i64| (first..=last).map(|point| coefficient(alpha - n * point)).collect();
    Ok((first, (0..n).map(row).collect()))
}

pub(super) fn wrong(what: &str) -> Stop {
    Stop::Wrong(format!("a symbol: {what}"))
}

/// What multiplies the formulas of a symbol out.
pub(super) struct Expansion<'s, P = i64> {
    /// The meanings of names.
    pub(super) scope: &'s Scope<'s>,
    /// The variables, with their exponents.
    pub(super) variables: &'s [(&'s str, P)],
    /// The other schemes whose symbols may stand in it.
    pub(super) others: &'s Others<'s, P>,
}

impl<P: Powers> Expansion<'_, P> {
    /// The Laurent polynomial that a formula is.
    pub(super) fn of(
        &self,
        expr: &Expr,
        indices: &mut Indices,
        depth: usize,
    ) -> Result<Laurent<P>, Stop> {
        if depth == MAX_DEPTH {
            return Err(Stop::Capped("the nesting of formulas"));
        }
        let found = names(expr, self.scope.definitions);
        self.scope.spend(1 + found.len() as u64)?;
        if !self.has_variable(expr, &found) {
            return sum([(P::zero(), self.scope.evaluate(expr, indices)?)]);
        }
        match expr {
            Expr::Name(name) => {
                if let Some(power) = self.variable(name) {
                    return sum([(power, Value::int(1))]);
                }
                let definition = self.scope.definitions.get(name);
                let definition = definition.ok_or_else(|| wrong("a name is unknown"))?;
                self.of(definition, indices, depth + 1)
            }
            Expr::Of(Head::Minus, parts) if parts.len() == 1 => {
                negated(self.of(&parts[0], indices, depth + 1)?)
            }
            Expr::Of(Head::Chain(operators), parts) => {
                let mut parts = parts.iter();
                let first = parts.next().ok_or_else(|| wrong("an operand is missing"))?;
                let mut value = self.of(first, indices, depth + 1)?;
                for (operator, part) in operators.iter().zip(parts) {
                    let right = self.of(part, indices, depth + 1)?;
                    value = match operator {
                        '+' => sum(value.into_iter().chain(right))?,
                        '-' => sum(value.into_iter().chain(negated(right)?))?,
                        '/' => self.over(&value, &right)?,
                        _ => self.times(&value, &right)?,
                    };
                }
                Ok(value)
            }
            Expr::Of(Head::Power, parts) if parts.len() == 2 => {
                let base = self.of(&parts[0], indices, depth + 1)?;
                let exponent = self.scope.evaluate(&parts[1], indices)?.integer(MAX_INTEGER)?;
                self.power(&base, exponent)
            }
            Expr::Of(head @ Head::Call(function, _), parts) if function == OTHER => {
                self.other((head, parts), indices, depth)
            }
            Expr::Of(Head::Over(fold, index), parts)
                if of_nothing(fold).is_some() && parts.len() == 3 =>
            {
                self.over_index((fold, index), parts, indices, depth)
            }
            _ => Err(wrong("a variable stands where it has no meaning")),
        }
    }

    /// A sum or a product over an index.
    fn over_index(
        &self,
        (fold, index): (&str, &str),
        parts: &[Expr],
        indices: &mut Indices,
        depth: usize,
    ) -> Result<Laurent<P>, Stop> {
        let [from, to, term] = range(parts)?;
        if self.variable(index).is_some() {
            return Err(wrong("a variable is an index"));
        }
        self.scope.index(index)?;
        let [from, to] = [from, to].map(|end| self.scope.evaluate(end, indices));
        let mut total = sum([(P::zero(), Value::int(of_nothing(fold).unwrap_or(0)))])?;
        for i in from?.integer(MAX_INTEGER)?..=to?.integer(MAX_INTEGER)? {
            indices.push((index.to_owned(), Value::int(i)));
            let term = self.of(term, indices, depth + 1);
            indices.pop();
            let term = term?;
            self.scope.spend((total.len() + term.len()) as u64)?;
            total = if fold == "product" {
                self.times(&total, &term)?
            } else {
                sum(total.into_iter().chain(term))?
            };
        }
        Ok(total)
    }

    /// The exponents of a variable of this name.
    fn variable(&self, name: &str) -> Option<P> {
        self.variables.iter().find(|(known, _)| *known == name).map(|(_, power)| *power)
    }

    /// Whether a variable or the symbol of another scheme is in a formula, or in what these names in it stand for.
    fn has_variable(&self, expr: &Expr, found: &BTreeSet<String>) -> bool {
        let definitions = found.iter().filter_map(|name| self.scope.definitions.get(name));
        found.iter().any(|name| self.variable(name).is_some())
            || names_other(expr)
            || definitions.into_iter().any(|of| names_other(of))
    }

    /// b(u), u = cz^m: the symbol of another scheme. That of a mask in the same variables is taken as it is.
    fn other(
        &self,
        (head, parts): (&Head, &[Expr]),
        indices: &mut Indices,
        depth: usize,
    ) -> Result<Laurent<P>, Stop> {
        let (arguments, options) = match (head, parts.first()) {
            // A variable is no scheme.
            (Head::Call(_, options), Some(Expr::Name(name))) if self.variable(name).is_some() => {
                (parts, Cow::Borrowed(&options[..]))
            }
            _ => self.scope.asked(head, parts, indices),
        };
        let (scheme, m, c) = match (self.named(&options, indices)?, arguments, self.variables) {
            (Other::Whole(symbol), [], _) => {
                self.scope.spend(symbol.len() as u64)?;
                return Ok(symbol);
            }
            (Other::Curve(scheme), [], [(_, z)]) => (scheme, *z, Value::int(1)),
            (Other::Curve(scheme), [u], _) => {
                let u = self.of(u, indices, depth + 1)?;
                let term = u.into_iter().collect::<Vec<(P, Value)>>().try_into();
                let one: Option<[(P, Value); 1]> = term.ok();
                let one = one.filter(|[(m, _)]| *m != P::zero());
                let [(m, c)] = one.ok_or_else(|| wrong(MONOMIAL))?;
                (scheme, m, c)
            }
            _ => return Err(wrong("`symbol` takes a scheme, and of one of curves a power")),
        };
        c.number()?;
        let mut symbol = Laurent::new();
        let (mut power, mut at) = (Value::int(1), 0);
        for (k, b) in scheme.coefficients() {
            self.scope.spend(1)?;
            if c != Value::int(1) {
                // The first k may be far from 0. The others follow.
                if at == 0 || k - at > 64 {
                    power = c.power(k)?;
                    self.scope.spend(power.steps(&power))?;
                } else {
                    for _ in at..k {
                        self.scope.spend(power.steps(&c))?;
                        power = power.times(&c)?;
                    }
                }
                at = k;
            }
            self.scope.spend(b.steps(&power))?;
            add(&mut symbol, P::zero().plus(k, m)?, &b.times(&power)?)?;
        }
        Ok(symbol)
    }

    /// The scheme of the option `scheme`. Other options give values to its parameters.
    fn named(&self, options: &[(String, String)], indices: &mut Indices) -> Result<Other<P>, Stop> {
        let is_scheme = |option: &&(String, String)| option.0 == "scheme";
        let (schemes, options): (Vec<_>, Vec<_>) = options.iter().partition(is_scheme);
        let [(_, scheme)] = &schemes[..] else {
            return Err(wrong("`symbol` takes one scheme"));
        };
        let mut parameters = Indices::new();
        for (parameter, word) in options {
            let value = match number_of(word) {
                Some(number) => Value::from(number),
                None if is_name(word) => self.scope.name(word, indices)?,
                None => return Err(wrong("a parameter is a number or a name")),
            };
            parameters.push((parameter.clone(), value));
        }
        (self.others)(scheme, parameters)
    }
}

/// Whether a symbol of another scheme is in a formula, without those that names in it stand for.
fn names_other(expr: &Expr) -> bool {
    let is = |node: &&Expr| matches!(node, Expr::Of(Head::Call(name, _), _) if name == OTHER);
    expr.nodes().iter().any(is)
}
