//! The values of formulas as functions of an integer (proofs/format/relation.md, Functions of an integer).

#![warn(clippy::arithmetic_side_effects)]

use super::function::{Function, Functions};
use super::polynomial::{PI, Polynomial, T};
use super::{angle, language};
use crate::formulas::{Expr, Head, Indices, MAX_INTEGER, Range, Scope, of_nothing, range};
use crate::functions::call::Call;
use crate::numbers::Value;
use crate::schemes::Library;
use crate::text::Stop;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;

/// The greatest depth of an evaluation, with those of the formulas of rings.
const MAX_DEPTH: usize = 200;

/// The greatest exponent of a power.
const MAX_POWER: i64 = 64;

const NUMBER: Stop = Stop::Integers("a number that is not rational, or a symbol");
const SCHEME: Stop = Stop::Integers("a function of a scheme within the formulas of another");

/// The value of a function of a ring; `None` if the function is none.
pub type OfRing = fn(&Evaluator<'_>, &mut Call<'_>, &[Function]) -> Result<Option<Function>, Stop>;

/// What formulas mean for all integers from one on.
pub struct Evaluator<'e> {
    pub functions: &'e Functions<'e>,
    pub library: &'e Library<'e>,
    pub scope: &'e Scope<'e>,
    /// The names that mean functions, before those of the scope.
    pub values: BTreeMap<String, Function>,
    /// The name of the integer, and what is about rings, in the formulas of a claim. Formulas of rings have no such name.
    pub claim: Option<Claim<'e>>,
    /// The depth of the evaluation.
    pub depth: &'e Cell<usize>,
    angle: Cell<bool>,
    known: RefCell<BTreeMap<String, Function>>,
}

/// What the formulas of a claim may speak of.
#[derive(Clone, Copy)]
pub struct Claim<'e> {
    /// The name of the integer.
    pub index: &'e str,
    /// The reference of the scheme of the claim. It is none while this reference is read.
    pub own: Option<&'e str>,
    /// The functions of rings.
    pub of_ring: OfRing,
}

impl<'e> Evaluator<'e> {
    /// The meanings of a scope.
    pub fn new(
        (functions, library): (&'e Functions<'e>, &'e Library<'e>),
        scope: &'e Scope<'e>,
        claim: Option<Claim<'e>>,
        depth: &'e Cell<usize>,
    ) -> Evaluator<'e> {
        let (values, angle, known) = Default::default();
        Evaluator { functions, library, scope, values, claim, depth, angle, known }
    }

    /// The value of a formula.
    pub fn value(&self, expr: &Expr) -> Result<Function, Stop> {
        self.evaluate(expr, &mut Vec::new())
    }

    /// The value of a formula inside of sums.
    pub fn evaluate(&self, expr: &Expr, indices: &mut Indices) -> Result<Function, Stop> {
        self.functions.meter().spend(1)?;
        if self.depth.get() >= MAX_DEPTH {
            return Err(Stop::Capped("the nesting of formulas"));
        }
        self.depth.set(self.depth.get().saturating_add(1));
        let value = self.parts(expr, indices);
        self.depth.set(self.depth.get().saturating_sub(1));
        value
    }

    fn parts(&self, expr: &Expr, indices: &mut Indices) -> Result<Function, Stop> {
        match expr {
            Expr::Number(value) => self.of_value(value),
            Expr::Name(name) => self.name(name, indices),
            Expr::Of(Head::Minus, parts) if parts.len() == 1 => {
                self.functions.negated(&self.evaluate(&parts[0], indices)?)
            }
            Expr::Of(Head::Chain(operators), parts) => self.chain(operators, parts, indices),
            Expr::Of(Head::Power, parts) if parts.len() == 2 => {
                let base = self.evaluate(&parts[0], indices)?;
                let exponent = self.evaluate(&parts[1], indices)?.integer();
                self.power(&base, exponent.ok_or(Stop::Integers("an exponent that is no integer"))?)
            }
            Expr::Of(Head::Over(fold, index), parts) => self.over(fold, index, parts, indices),
            Expr::Of(head @ Head::Call(name, _), parts) => self.call(head, name, parts, indices),
            Expr::Of(..) if self.is_of_claim() => {
                self.of_value(&self.scope.evaluate(expr, indices)?)
            }
            Expr::Of(..) => Err(SCHEME),
        }
    }

    /// Whether all names mean what they mean in the claim.
    fn is_of_claim(&self) -> bool {
        self.claim.is_some() && self.values.is_empty()
    }

    /// The polynomial in t that a value is.
    fn of_value(&self, value: &Value) -> Result<Function, Stop> {
        if let Some(number) = value.rational() {
            return Ok(Polynomial::from(number).into());
        }
        let index = self.claim.map(|claim| claim.index).ok_or(NUMBER)?;
        let coefficients = value.univariate(index).ok_or(NUMBER)?;
        let (t, meter) = (Polynomial::variable(T), self.functions.meter());
        let mut sum = Polynomial::default();
        for c in coefficients.into_iter().rev() {
            sum = sum.times(meter, &t)?.plus(meter, 1, &Polynomial::from(c))?;
        }
        Ok(sum.into())
    }

    fn name(&self, name: &str, indices: &mut Indices) -> Result<Function, Stop> {
        if name == "pi" && self.angle.get() {
            return Ok(Polynomial::variable(PI).into());
        }
        if let Some((_, value)) = indices.iter().rev().find(|(index, _)| index == name) {
            return self.of_value(value);
        }
        if let Some(value) = self.values.get(name) {
            return Ok(value.clone());
        }
        let scope = self.scope;
        if let Some(value) = scope.values.get(name) {
            return self.of_value(value);
        }
        let without = scope.unstated.contains(name) || scope.beyond.contains_key(name);
        let Some(definition) = scope.definitions.get(name).filter(|_| !without) else {
            return self.of_value(&scope.name(name, indices)?);
        };
        if indices.is_empty()
            && let Some(known) = self.known.borrow().get(name)
        {
            return Ok(known.clone());
        }
        let angle = self.angle.replace(false);
        let value = self.evaluate(definition, indices);
        self.angle.set(angle);
        if let (true, Ok(value)) = (indices.is_empty(), &value) {
            self.known.borrow_mut().insert(name.to_owned(), value.clone());
        }
        value
    }

    /// Sums and products, from left to right.
    fn chain(
        &self,
        operators: &[char],
        parts: &[Expr],
        indices: &mut Indices,
    ) -> Result<Function, Stop> {
        let Some((first, rest)) = parts.split_first() else {
            return Err(Stop::Wrong("an operand is missing".into()));
        };
        let mut value = self.evaluate(first, indices)?;
        for (operator, part) in operators.iter().zip(rest) {
            let right = self.evaluate(part, indices)?;
            value = match operator {
                '+' => self.functions.sum(&value, 1, &right)?,
                '-' => self.functions.sum(&value, -1, &right)?,
                '/' => self.functions.quotient(&value, &right)?,
                _ => self.functions.product(&value, &right)?,
            };
        }
        Ok(value)
    }

    fn power(&self, base: &Function, exponent: i64) -> Result<Function, Stop> {
        if exponent.unsigned_abs() > MAX_POWER.unsigned_abs() {
            return Err(Stop::Capped("the size of an exponent"));
        }
        let mut power = Function::int(1);
        for _ in 0..exponent.unsigned_abs() {
            power = self.functions.product(&power, base)?;
        }
        if exponent < 0 { self.functions.quotient(&Function::int(1), &power) } else { Ok(power) }
    }

    fn over(
        &self,
        fold: &str,
        index: &str,
        parts: &[Expr],
        indices: &mut Indices,
    ) -> Result<Function, Stop> {
        let [from, to, body] = range(parts)?;
        self.scope.index(index)?;
        if self.values.contains_key(index) {
            return Err(Stop::Wrong(format!("the index `{index}` has another meaning")));
        }
        let mut end = |part: &Expr| {
            let end = self.evaluate(part, indices)?.integer();
            let end = end.ok_or(Stop::Integers("the end of a range that is no integer"))?;
            let within = end.unsigned_abs() <= MAX_INTEGER.unsigned_abs();
            if within { Ok(end) } else { Err(Stop::Capped("the size of an integer")) }
        };
        let ends = [end(from)?, end(to)?];
        let range = Range { index, ends, others: indices, value: Value::int };
        range.total(
            of_nothing(fold).map(Function::int),
            |indices| self.evaluate(body, indices),
            |total, term| match fold {
                "sum" => self.functions.sum(total, 1, term),
                "product" => self.functions.product(total, term),
                _ => language::extreme(self.functions, fold, total, term),
            },
        )
    }

    fn call(
        &self,
        head: &Head,
        name: &str,
        parts: &[Expr],
        indices: &mut Indices,
    ) -> Result<Function, Stop> {
        if name == "cos"
            && let [part] = parts
        {
            let outside = self.angle.replace(true);
            let value = self.evaluate(part, indices);
            self.angle.set(outside);
            return angle::cosine(self.functions, &value?);
        }
        if let (true, Head::Call(_, options)) = (language::has(name), head) {
            let values = parts.iter().map(|part| self.evaluate(part, indices));
            let values = values.collect::<Result<Vec<Function>, Stop>>()?;
            if !options.is_empty() {
                return Err(Stop::Wrong(format!("`{name}` takes no options")));
            }
            return language::value(self.functions, name, &values);
        }
        // The names in references are those of the claim.
        let Some(claim) = self.claim.filter(|_| self.is_of_claim()) else { return Err(SCHEME) };
        let (arguments, options) = self.scope.asked(head, parts, indices);
        let values = arguments.iter().map(|part| self.evaluate(part, indices));
        if let Ok(values) = values.collect::<Result<Vec<Function>, Stop>>() {
            let mut call = Call::new(self.library, self.scope, (name, &[], &options));
            if let Some(value) = (claim.of_ring)(self, &mut call, &values)? {
                call.finished()?;
                return Ok(value);
            }
        }
        let head = Expr::Of(head.clone(), parts.to_vec());
        self.of_value(&self.scope.evaluate(&head, indices)?)
    }
}
