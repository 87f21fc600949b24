//! Evaluation of syntax trees.

use super::angle::{Angle, PI};
use super::ast::{Expr, Fold, Node, Operator, OptionWord, Span};
use super::builtin;
use super::context::{Call, Context, Lookup, Work};
use super::error::{CallError, FormulaError, FormulaErrorKind};
use super::hyphens::differences;
use super::values::value::Value;
use crate::exact::Rational;

/// The cap on the work of one evaluation, as counted by [`Work::spent`].
const MAX_WORK: u64 = 1_000_000;

/// The greatest nesting depth of nodes in one evaluation. The nodes of a named formula
/// count as nested in its use.
const MAX_DEPTH: u32 = 256;

/// The option that names the scheme of a call.
const SCHEME: &str = "scheme";

/// The value of a formula.
///
/// # Errors
/// When a name or function is unknown or unstated, a value does not exist, or a
/// cap (size of a power, length of a sum, total work) is reached.
pub fn evaluate<V: Value>(expr: &Expr, context: &dyn Context<V>) -> Result<V, FormulaError> {
    evaluate_with(expr, context, &[])
}

/// As [`evaluate`], inside sums whose `indices` have values. The first value of a name
/// counts, and hides the context's.
///
/// # Errors
/// As [`evaluate`].
pub fn evaluate_with<V: Value>(
    expr: &Expr,
    context: &dyn Context<V>,
    indices: &[(String, V)],
) -> Result<V, FormulaError> {
    let own = Work::default();
    let work = context.work().unwrap_or(&own);
    if work.depth.get() == 0 {
        work.spent.set(0);
    }
    Evaluator { context, work }.value(expr, &mut indices.to_vec())
}

struct Evaluator<'a, V> {
    context: &'a dyn Context<V>,
    work: &'a Work,
}

fn fail<T>(kind: FormulaErrorKind, span: &Span) -> Result<T, FormulaError> {
    Err(FormulaError { kind, span: span.clone(), definition: None })
}

impl<V: Value> Evaluator<'_, V> {
    /// Adds the work of `value` to the total. Returns `value`, or an error when the cap
    /// is exceeded.
    fn spend(&self, value: V, span: &Span) -> Result<V, FormulaError> {
        let size = value.size() / 512;
        let spent = self.work.spent.get().saturating_add(1 + size.saturating_mul(size));
        self.work.spent.set(spent);
        if spent > MAX_WORK {
            let what = "the work of this formula";
            return fail(FormulaErrorKind::too_large(what, MAX_WORK), span);
        }
        Ok(value)
    }

    fn value(&self, expr: &Expr, indices: &mut Vec<(String, V)>) -> Result<V, FormulaError> {
        let depth = self.work.depth.get();
        if depth >= MAX_DEPTH {
            let what = "the nesting of this formula and those it names";
            let cap = u64::from(MAX_DEPTH);
            return fail(FormulaErrorKind::too_large(what, cap), &expr.span);
        }
        self.work.depth.set(depth + 1);
        let value = self.node(expr, indices);
        self.work.depth.set(depth);
        self.spend(value?, &expr.span)
    }

    // A formula may be deeply nested, so stack frames are kept small: one function for
    // each kind of node, and no iterator adapters around the recursion.
    fn node(&self, expr: &Expr, indices: &mut Vec<(String, V)>) -> Result<V, FormulaError> {
        match &expr.node {
            Node::Number(number) => Ok(V::from_rational(number)),
            Node::Name(name) => self.name(name, &expr.span, indices),
            Node::Indexed { name, indices: positions } => {
                let mut key = Vec::with_capacity(positions.len());
                for position in positions {
                    key.push(self.integer("an index", position, indices)?.to_string());
                }
                self.name(&format!("{name}[{}]", key.join(",")), &expr.span, indices)
            }
            Node::Negate(operand) => Ok(V::zero().minus(&self.value(operand, indices)?)),
            Node::Chain(first, rest) => self.chain(first, rest, indices),
            Node::Power(base, exponent) => self.power(base, exponent, &expr.span, indices),
            Node::Call { function, arguments, options } if function == builtin::COSINE => {
                self.cosine(arguments, options, &expr.span, indices)
            }
            Node::Call { function, arguments, options } => {
                let (scheme, arguments) = self.scheme(function, arguments, indices);
                let arguments = self.arguments(arguments, indices).map_err(|error| {
                    // A function that is misspelt may have the name of a scheme as its argument.
                    let unknown = |error: &FormulaError| {
                        matches!(error.kind, FormulaErrorKind::UnknownFunction { .. })
                    };
                    let name = matches!(error.kind, FormulaErrorKind::UnknownName { .. });
                    let called = || self.call(function, &[], options, indices, &expr.span).err();
                    name.then(called).flatten().filter(unknown).unwrap_or(error)
                })?;
                match scheme {
                    None => self.call(function, &arguments, options, indices, &expr.span),
                    Some(scheme) => {
                        let options = [&[scheme], &options[..]].concat();
                        self.call(function, &arguments, &options, indices, &expr.span)
                    }
                }
            }
            Node::Fold { fold, index, from, to, body } => {
                let first = self.integer("the first index of a range", from, indices)?;
                let last = self.integer("the last index of a range", to, indices)?;
                self.fold(*fold, index, first..=last, body, indices)?
                    .map_or_else(|| fail(FormulaErrorKind::EmptyRange, &expr.span), Ok)
            }
        }
    }

    fn chain(
        &self,
        first: &Expr,
        rest: &[(Operator, Expr)],
        indices: &mut Vec<(String, V)>,
    ) -> Result<V, FormulaError> {
        let mut value = self.value(first, indices)?;
        for (operator, operand) in rest {
            let right = self.value(operand, indices)?;
            let result = builtin::apply(*operator, value, &right);
            value = self.spend(result.or_else(|kind| fail(kind, &operand.span))?, &operand.span)?;
        }
        Ok(value)
    }

    fn power(
        &self,
        base: &Expr,
        exponent: &Expr,
        span: &Span,
        indices: &mut Vec<(String, V)>,
    ) -> Result<V, FormulaError> {
        let base = self.value(base, indices)?;
        let exponent = self.value(exponent, indices)?;
        builtin::power(&base, &exponent).or_else(|kind| fail(kind, span))
    }

    /// The scheme that a call is about, if its first argument is the name of one, and the other arguments.
    fn scheme<'e>(
        &self,
        function: &str,
        arguments: &'e [Expr],
        indices: &[(String, V)],
    ) -> (Option<OptionWord>, &'e [Expr]) {
        let Some((first, rest)) = arguments.split_first() else { return (None, arguments) };
        // `four-point` reads as a difference.
        let Some(names) = differences(first) else { return (None, arguments) };
        let name = names.join("-");
        let unknown = |name: &String| {
            !name.starts_with(|c: char| c.is_ascii_digit())
                && indices.iter().all(|(index, _)| index != name)
                && matches!(self.context.name(name, indices), Ok(Lookup::Unknown))
        };
        let is_name = names.len() > 1 || indices.iter().all(|(index, _)| *index != name);
        let is_free = names.len() == 1 || names.iter().any(unknown);
        if is_name && is_free && self.context.is_scheme(function, &name) {
            let span = first.span.clone();
            return (Some(OptionWord { name: SCHEME.to_owned(), word: name, span }), rest);
        }
        (None, arguments)
    }

    fn arguments(
        &self,
        arguments: &[Expr],
        indices: &mut Vec<(String, V)>,
    ) -> Result<Vec<V>, FormulaError> {
        let mut values = Vec::with_capacity(arguments.len());
        for argument in arguments {
            values.push(self.value(argument, indices)?);
        }
        Ok(values)
    }

    /// The sum, product, maximum or minimum of `body` over `range`; `None` for the maximum or
    /// minimum over an empty range.
    fn fold(
        &self,
        fold: Fold,
        index: &str,
        range: std::ops::RangeInclusive<i64>,
        body: &Expr,
        indices: &mut Vec<(String, V)>,
    ) -> Result<Option<V>, FormulaError> {
        indices.insert(0, (index.to_owned(), V::zero()));
        let total = self.folded(fold, range, body, indices);
        indices.remove(0);
        total
    }

    /// As `fold`, where `indices[0]` is the index of the range.
    fn folded(
        &self,
        fold: Fold,
        range: std::ops::RangeInclusive<i64>,
        body: &Expr,
        indices: &mut Vec<(String, V)>,
    ) -> Result<Option<V>, FormulaError> {
        let mut total = match fold {
            Fold::Sum => Some(V::zero()),
            Fold::Product => Some(V::from_rational(&Rational::one())),
            Fold::Max | Fold::Min => None,
        };
        for i in range {
            indices[0].1 = V::from_rational(&Rational::from(i));
            let term = self.value(body, indices)?;
            total = Some(match total {
                None => term,
                Some(total) => {
                    let next = match fold {
                        Fold::Sum => builtin::apply(Operator::Add, total, &term),
                        Fold::Product => builtin::apply(Operator::Multiply, total, &term),
                        Fold::Max => builtin::greater(&total, &term),
                        Fold::Min => builtin::lesser(&total, &term),
                    };
                    self.spend(next.or_else(|kind| fail(kind, &body.span))?, &body.span)?
                }
            });
        }
        Ok(total)
    }

    fn name(&self, name: &str, span: &Span, indices: &[(String, V)]) -> Result<V, FormulaError> {
        if name == PI {
            return fail(FormulaErrorKind::PiOutsideCosine, span);
        }
        if let Some((_, value)) = indices.iter().find(|(index, _)| index == name) {
            return Ok(value.clone());
        }
        match self.context.name(name, indices) {
            Ok(Lookup::Found(value)) => Ok(value),
            Ok(Lookup::Unstated) => fail(FormulaErrorKind::Unstated(name.to_owned()), span),
            Ok(Lookup::Unknown) => {
                let known = self.context.names();
                fail(FormulaErrorKind::UnknownName { name: name.to_owned(), known }, span)
            }
            Err(error) => fail_call(error, name, span),
        }
    }

    fn integer(
        &self,
        what: &'static str,
        expr: &Expr,
        indices: &mut Vec<(String, V)>,
    ) -> Result<i64, FormulaError> {
        let value = self.value(expr, indices)?;
        builtin::integer(what, &value).or_else(|kind| fail(kind, &expr.span))
    }

    fn call(
        &self,
        function: &str,
        arguments: &[V],
        options: &[OptionWord],
        indices: &[(String, V)],
        span: &Span,
    ) -> Result<V, FormulaError> {
        if let Some(value) = builtin::call(function, arguments, options) {
            return value.or_else(|kind| fail(kind, span));
        }
        let call = Call { function, arguments, options, indices };
        self.context.call(&call).or_else(|error| fail_call(error, function, span))
    }

    /// `cos` of its single argument.
    fn cosine(
        &self,
        arguments: &[Expr],
        options: &[OptionWord],
        span: &Span,
        indices: &mut Vec<(String, V)>,
    ) -> Result<V, FormulaError> {
        let [argument] = arguments else {
            return fail(builtin::wrong_count(builtin::COSINE, arguments.len()), span);
        };
        if let Some(option) = options.first() {
            return fail(builtin::no_option(builtin::COSINE, option), span);
        }
        let angle = self.angle(argument, indices)?;
        angle.cosine().or_else(|kind| match kind {
            FormulaErrorKind::Angle(_) => fail(kind, &argument.span),
            _ => fail(kind, span),
        })
    }

    /// The value of an expression that may contain `pi` in sums, in products and in
    /// numerators. Subexpressions without `pi` may be arbitrary.
    fn angle(&self, expr: &Expr, indices: &mut Vec<(String, V)>) -> Result<Angle<V>, FormulaError> {
        match &expr.node {
            Node::Name(name) if name == PI => {
                let pi = self.spend(V::from_rational(&Rational::one()), &expr.span)?;
                Ok(Angle { plain: V::zero(), pi })
            }
            Node::Negate(operand) => {
                let Angle { plain, pi } = self.angle(operand, indices)?;
                Ok(Angle { plain: V::zero().minus(&plain), pi: V::zero().minus(&pi) })
            }
            Node::Chain(first, rest) => {
                let mut angle = self.angle(first, indices)?;
                for (operator, operand) in rest {
                    let right = self.angle(operand, indices)?;
                    let result = Angle::combine(*operator, &angle, &right);
                    angle = result.or_else(|kind| fail(kind, &operand.span))?;
                    angle.plain = self.spend(angle.plain, &operand.span)?;
                    angle.pi = self.spend(angle.pi, &operand.span)?;
                }
                Ok(angle)
            }
            _ => Ok(Angle { plain: self.value(expr, indices)?, pi: V::zero() }),
        }
    }
}

/// The error of the context's name or function `name`, which stands at `span`.
fn fail_call<T>(error: CallError, name: &str, span: &Span) -> Result<T, FormulaError> {
    let (kind, definition) = match error {
        CallError::UnknownFunction(mut known) => {
            known.extend(builtin::NAMES.iter().map(|&name| name.to_owned()));
            (FormulaErrorKind::UnknownFunction { name: name.to_owned(), known }, None)
        }
        CallError::Misuse(message) => (FormulaErrorKind::Call(message), None),
        CallError::Undefined(message) => (FormulaErrorKind::Undefined(message), None),
        CallError::BeyondCap(cap) => (FormulaErrorKind::BeyondCap(cap), None),
        CallError::Inner(kind) => (kind, None),
        CallError::Definition(kind, place) => (kind, Some(place)),
    };
    Err(FormulaError { kind, span: span.clone(), definition })
}
