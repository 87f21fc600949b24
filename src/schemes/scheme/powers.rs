//! Symbols as products of powers whose exponents depend on an integer.

use super::definition::{Coefficients, SchemeDefinition};
use crate::exact::{Polynomial, Rational, RationalPolynomial, Scalar as _};
use crate::formula::{
    Context as _, Expr, Laurent, Lookup, Node, Operator, SYMBOL_VARIABLE, Scope, Value as _,
    evaluate,
};
use std::cell::Cell;
use std::collections::BTreeMap;

/// The deepest nesting of names that stand for formulas.
const MAX_DEPTH: usize = 32;

/// f(z)^{e(t)}, f(z) = Σ_i c_i(t) z^{l+i}.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SymbolPower {
    /// l.
    pub lowest: i64,
    /// The c_i; neither the first nor the last is the polynomial 0.
    pub coefficients: Vec<RationalPolynomial>,
    /// e(t) = αt + β.
    pub exponent: RationalPolynomial,
}

/// A symbol whose formula has powers in it, as far as they depend on t.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SymbolPowers {
    /// The arity, if it is stated.
    pub arity: Option<Rational>,
    /// The factors.
    pub factors: Vec<SymbolPower>,
}

impl SchemeDefinition {
    /// The factors of the symbol at these values of the parameters, which are polynomials in `index`, for its values from `first` on;
    /// `None` where there is no symbol, or its formula is no product of powers.
    ///
    /// ```
    /// use std::collections::BTreeMap;
    /// use subcert::diagnostic::SourceText;
    /// use subcert::exact::Polynomial;
    /// use subcert::scheme::read_scheme;
    ///
    /// let text = "name = 'spline'\nparameters.k = {}\nsymbol = '(1+z)^(k+1)/2^k'\n";
    /// let scheme = read_scheme(&SourceText::new("spline.toml", text.to_owned()))?;
    /// let k = BTreeMap::from([("k".to_owned(), Polynomial::variable("n"))]);
    /// let powers = scheme.powers(&k, ("n", 1)).expect("a product");
    /// let exponents: Vec<String> = powers.factors.iter().map(|f| f.exponent.describe("n")).collect();
    /// assert_eq!(exponents, ["1 + n", "-n"]);
    /// # Ok::<(), subcert::diagnostic::Diagnostic>(())
    /// ```
    #[must_use]
    pub fn powers(
        &self,
        values: &BTreeMap<String, Polynomial>,
        (index, first): (&str, i64),
    ) -> Option<SymbolPowers> {
        let Coefficients::Symbol(symbol) = &self.coefficients else { return None };
        if self.is_filter {
            return None;
        }
        let parameters = self.complete(values).ok()?;
        for (name, spec) in &self.parameters {
            let Some(least) = &spec.least else { continue };
            let least = self.value(least, &BTreeMap::<String, Polynomial>::new(), &[]).ok()?;
            let above = (&parameters[name] - &least).in_variable(index)?;
            above.is_nonnegative_line_from(first).then_some(())?;
        }
        let left = Cell::new(super::definition::MAX_OTHERS);
        let functions = self.composed(&left);
        let constants: BTreeMap<String, Laurent<Polynomial>> =
            parameters.into_iter().map(|(name, value)| (name, Laurent::constant(value))).collect();
        let scope = Scope::new(&self.definitions, &functions)
            .with_all(&constants)
            .with(SYMBOL_VARIABLE, Laurent::variable());
        let arity = match &symbol.arity {
            Some(formula) => Some(evaluate(&formula.expr, &scope).ok()?.as_rational()?),
            None => None,
        };
        let mut read = Factors { scheme: self, scope, index, first, found: Vec::new() };
        let one = RationalPolynomial::constant(Rational::one());
        read.add(&symbol.formula.expr, &Power { exponent: one, of_terms: true }, 0)?;
        Some(SymbolPowers { arity, factors: read.found })
    }
}

struct Factors<'a> {
    scheme: &'a SchemeDefinition,
    scope: Scope<'a, Laurent<Polynomial>>,
    index: &'a str,
    first: i64,
    found: Vec<SymbolPower>,
}

/// To which power a formula stands.
struct Power {
    exponent: RationalPolynomial,
    /// Whether it may have several terms: as a divisor, or to a negative power, it may not.
    of_terms: bool,
}

impl Factors<'_> {
    /// Adds the factors of a formula, to this power.
    fn add(&mut self, expr: &Expr, power: &Power, depth: usize) -> Option<()> {
        if let Ok(value) = evaluate(expr, &self.scope) {
            return self.push(&value, power);
        }
        if depth > MAX_DEPTH {
            return None;
        }
        match &expr.node {
            Node::Negate(operand) => {
                self.push(&Laurent::from_rational(&Rational::from(-1)), power)?;
                self.add(operand, power, depth + 1)
            }
            Node::Chain(first, rest) => {
                let rest = self.begin(expr, (first, rest), power, depth)?;
                let inverse = Power { exponent: power.exponent.negated(), of_terms: false };
                rest.iter().try_for_each(|(operator, operand)| match operator {
                    Operator::Multiply => self.add(operand, power, depth + 1),
                    Operator::Divide => self.add(operand, &inverse, depth + 1),
                    Operator::Add | Operator::Subtract => None,
                })
            }
            Node::Power(base, exponent) => {
                let exponent = evaluate(exponent, &self.scope).ok()?.as_constant()?;
                let exponent = exponent.in_variable(self.index)?;
                let of_terms = power.of_terms && exponent.is_nonnegative_line_from(self.first);
                let exponent = power.exponent.times(&exponent);
                self.add(base, &Power { exponent, of_terms }, depth + 1)
            }
            Node::Name(name) => {
                let own = self.scheme.definitions.get(name)?;
                let is_value = matches!(self.scope.name(name, &[]), Ok(Lookup::Found(_)));
                (!is_value).then_some(())?;
                self.add(&own.expr, power, depth + 1)
            }
            _ => None,
        }
    }

    /// Adds the longest part at the beginning of a chain that has a value, or else its first operand; the operands behind it are left.
    fn begin<'e>(
        &mut self,
        chain: &Expr,
        (first, rest): (&'e Expr, &'e [(Operator, Expr)]),
        power: &Power,
        depth: usize,
    ) -> Option<&'e [(Operator, Expr)]> {
        for end in (1..rest.len()).rev() {
            let node = Node::Chain(Box::new(first.clone()), rest[..end].to_vec());
            let part = Expr { node, span: chain.span.clone() };
            if let Ok(value) = evaluate(&part, &self.scope) {
                self.push(&value, power)?;
                return Some(&rest[end..]);
            }
        }
        self.add(first, power, depth + 1)?;
        Some(rest)
    }

    fn push(&mut self, value: &Laurent<Polynomial>, power: &Power) -> Option<()> {
        let linear = power.exponent.degree().is_none_or(|degree| degree <= 1);
        if !linear || power.exponent.coefficients().iter().any(|c| !c.is_integer()) {
            return None;
        }
        let (low, high) = value.powers()?;
        (power.of_terms || low == high).then_some(())?;
        let all = (low..=high).map(|k| value.coefficient(k).in_variable(self.index));
        let coefficients = all.collect::<Option<Vec<RationalPolynomial>>>()?;
        let exponent = power.exponent.clone();
        self.found.push(SymbolPower { lowest: low, coefficients, exponent });
        Some(())
    }
}
