//! A mask by its symbol Σ_k a_k z^k: the formula is multiplied out.

use super::laurent::{Laurent, POWER, add, constant, negated, sum};
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
const Z: &str = "z";

/// The function that gives the symbol of another scheme.
const OTHER: &str = "symbol";

/// The greatest |exponent| of what has z in it.
const MAX_EXPONENT: u64 = 64;

/// How deep the formulas in z may be nested, with those that they name.
const MAX_DEPTH: usize = 200;

/// What gives the other schemes whose symbols a symbol may name, with values of their parameters.
pub(super) type Others<'o> = dyn Fn(&str, Indices) -> Result<Rc<Scheme>, Stop> + 'o;

/// What `symbol` takes besides a scheme.
const MONOMIAL: &str = "`symbol` takes cz^m, c ≠ 0 ≠ m";

/// The offset and the rules of a symbol: a_k is in the rule α = k mod n, of the point (α − k)/n. The arity n is stated, or
/// else the value at z = 1.
pub(super) fn mask(
    text: &str,
    stated: Option<&str>,
    scope: &Scope<'_>,
    others: &Others<'_>,
) -> Result<(i64, Vec<Vec<Value>>), Stop> {
    let symbol = Expansion { scope, others }.of(&formula(text)?, &mut Vec::new(), 0)?;
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

fn wrong(what: &str) -> Stop {
    Stop::Wrong(format!("a symbol: {what}"))
}

/// What multiplies the formulas of a symbol out.
pub(super) struct Expansion<'s> {
    /// The meanings of names.
    pub(super) scope: &'s Scope<'s>,
    /// The other schemes whose symbols may stand in it.
    pub(super) others: &'s Others<'s>,
}

impl Expansion<'_> {
    /// The Laurent polynomial that a formula is.
    pub(super) fn of(
        &self,
        expr: &Expr,
        indices: &mut Indices,
        depth: usize,
    ) -> Result<Laurent, Stop> {
        if depth == MAX_DEPTH {
            return Err(Stop::Capped("the nesting of formulas"));
        }
        let found = names(expr, self.scope.definitions);
        self.scope.spend(1 + found.len() as u64)?;
        if !self.has_variable(expr, &found) {
            return sum([(0, self.scope.evaluate(expr, indices)?)]);
        }
        match expr {
            Expr::Name(name) if name == Z => sum([(1, Value::int(1))]),
            Expr::Name(name) => {
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
            _ => Err(wrong("`z` stands where it has no meaning")),
        }
    }

    /// A sum or a product over an index.
    fn over_index(
        &self,
        (fold, index): (&str, &str),
        parts: &[Expr],
        indices: &mut Indices,
        depth: usize,
    ) -> Result<Laurent, Stop> {
        let [from, to, term] = range(parts)?;
        if index == Z {
            return Err(wrong("`z` is an index"));
        }
        self.scope.index(index)?;
        let [from, to] = [from, to].map(|end| self.scope.evaluate(end, indices));
        let mut total = sum([(0, Value::int(of_nothing(fold).unwrap_or(0)))])?;
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

    /// Whether z or the symbol of another scheme is in a formula, or in what these names in it stand for.
    fn has_variable(&self, expr: &Expr, found: &BTreeSet<String>) -> bool {
        let definitions = found.iter().filter_map(|name| self.scope.definitions.get(name));
        found.contains(Z) || names_other(expr) || definitions.into_iter().any(|of| names_other(of))
    }

    /// b(u), u = cz^m: the symbol of another scheme.
    fn other(
        &self,
        (head, parts): (&Head, &[Expr]),
        indices: &mut Indices,
        depth: usize,
    ) -> Result<Laurent, Stop> {
        let (arguments, options) = match (head, parts.first()) {
            // `z` is the variable here, and no scheme.
            (Head::Call(_, options), Some(Expr::Name(name))) if name == Z => {
                (parts, Cow::Borrowed(&options[..]))
            }
            _ => self.scope.asked(head, parts, indices),
        };
        let scheme = self.named(&options, indices)?;
        let (m, c) = match arguments {
            [] => (1, Value::int(1)),
            [u] => {
                let u = self.of(u, indices, depth + 1)?;
                let term = u.into_iter().collect::<Vec<(i64, Value)>>().try_into();
                let one: Option<[(i64, Value); 1]> = term.ok();
                let [(m, c)] = one.filter(|[(m, _)]| *m != 0).ok_or_else(|| wrong(MONOMIAL))?;
                (m, c)
            }
            _ => return Err(wrong("`symbol` takes a scheme, and one more argument at most")),
        };
        c.number()?;
        let mut symbol = Laurent::new();
        let (mut power, mut at) = (Value::int(1), 0);
        for (k, b) in coefficients(&scheme) {
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
            let k = k.checked_mul(m).ok_or(POWER)?;
            add(&mut symbol, k, &b.times(&power)?)?;
        }
        Ok(symbol)
    }

    /// The scheme of the option `scheme`. Other options give values to its parameters.
    fn named(
        &self,
        options: &[(String, String)],
        indices: &mut Indices,
    ) -> Result<Rc<Scheme>, Stop> {
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

    /// The product.
    pub(super) fn times(&self, left: &Laurent, right: &Laurent) -> Result<Laurent, Stop> {
        let mut product = Laurent::new();
        for (p, a) in left {
            for (q, b) in right {
                self.scope.spend(a.cost(b))?;
                add(&mut product, p + q, &a.times(b)?)?;
            }
        }
        Ok(product)
    }

    fn power(&self, base: &Laurent, exponent: i64) -> Result<Laurent, Stop> {
        if let Some(constant) = constant(base) {
            let power = constant.power(exponent)?;
            self.scope.spend(power.cost(&power))?;
            return sum([(0, power)]);
        }
        if exponent.unsigned_abs() > MAX_EXPONENT {
            return Err(Stop::Capped("the exponent of a symbol"));
        }
        let one = sum([(0, Value::int(1))])?;
        let mut power = one.clone();
        for _ in 0..exponent.unsigned_abs() {
            power = self.times(&power, base)?;
        }
        if exponent < 0 { self.over(&one, &power) } else { Ok(power) }
    }

    /// The quotient, which leaves no remainder. By a number or one power of z each coefficient is divided; otherwise the
    /// terms of one end of the dividend are taken away, one after the other.
    pub(super) fn over(&self, left: &Laurent, divisor: &Laurent) -> Result<Laurent, Stop> {
        let (Some((first, low)), Some((last, high))) =
            (divisor.first_key_value(), divisor.last_key_value())
        else {
            return Err(Stop::Undefined("division by zero"));
        };
        if first == last {
            let each = |(k, c): (&i64, &Value)| {
                self.scope.spend(c.cost_of_quotient(low))?;
                Ok((k - first, c.over(low)?))
            };
            return sum(left.iter().map(each).collect::<Result<Vec<_>, Stop>>()?);
        }
        let (from_above, end, lead) =
            if high.number().is_ok() { (true, last, high) } else { (false, first, low) };
        let (mut rest, mut quotient) = (left.clone(), Laurent::new());
        while let (Some(least), Some(most)) = (rest.keys().next(), rest.keys().next_back()) {
            // What is left is longer than the divisor, as a multiple of it is.
            if most - least < last - first {
                return Err(wrong("a division leaves a remainder"));
            }
            let at = if from_above { *most } else { *least };
            let k = at - end;
            let c = rest[&at].over(lead)?;
            self.scope.spend(rest[&at].cost_of_quotient(lead))?;
            for (power, d) in divisor {
                self.scope.spend(c.cost(d))?;
                let known = rest.remove(&(power + k)).unwrap_or_else(|| Value::int(0));
                let value = known.minus(&c.times(d)?)?;
                if !value.is_zero() {
                    rest.insert(power + k, value);
                }
            }
            quotient.insert(k, c);
        }
        sum(quotient)
    }
}

/// Whether a symbol of another scheme is in a formula, without those that names in it stand for.
fn names_other(expr: &Expr) -> bool {
    let is = |node: &&Expr| matches!(node, Expr::Of(Head::Call(name, _), _) if name == OTHER);
    expr.nodes().iter().any(is)
}

/// The coefficients of a scheme that are not 0, by ascending powers: a_k is a_{α,j} for k = α − n(o + j).
fn coefficients(scheme: &Scheme) -> Vec<(i64, Value)> {
    let n = i64::try_from(scheme.arity()).unwrap_or(0);
    let columns = (scheme.offset..).take(scheme.width()).zip(0..);
    let of = |(point, j): (i64, usize)| {
        let entry = move |(alpha, rule): (i64, &Vec<Value>)| (alpha - n * point, rule[j].clone());
        (0..).zip(&scheme.mask).map(entry)
    };
    let mut all: Vec<(i64, Value)> = columns.flat_map(of).collect();
    all.retain(|(_, value)| !value.is_zero());
    all.sort_by_key(|(k, _)| *k);
    all
}
