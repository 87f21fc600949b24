//! The built-in functions of the formula language.

use super::ast::{Operator, OptionWord};
use super::error::FormulaErrorKind;
use super::root::{ROOT, SQUARE_ROOT, root, square_root};
use super::values::value::Value;
use crate::exact::{Integer, Rational};

/// The names of the functions.
pub(super) const NAMES: [&str; 14] = [
    "abs",
    "min",
    "max",
    "floor",
    "ceil",
    "mod",
    "kronecker",
    "binomial",
    "factorial",
    "sum",
    "product",
    COSINE,
    SQUARE_ROOT,
    ROOT,
];

/// Whether `name` is a built-in function.
#[must_use]
pub fn is_builtin(name: &str) -> bool {
    NAMES.contains(&name)
}

/// The function whose argument is an angle. The evaluator handles it itself.
pub(super) const COSINE: &str = "cos";

/// The cap on the cost of a product or a quotient and on the size of a power, in bits.
pub(super) const MAX_BITS: u64 = 500_000;

/// The greatest absolute value of the exponent of a symbol or an irrational number, and the
/// greatest lower index of a binomial coefficient of one.
const MAX_SYMBOLIC_POWER: u64 = 64;

/// The greatest lower index of a binomial coefficient of a rational number.
const MAX_BINOMIAL: u64 = 10_000;

/// The greatest argument of `factorial`.
const MAX_FACTORIAL: u64 = 1_000;

/// The value of the built-in function `function`; `None` when there is none of this name.
pub(super) fn call<V: Value>(
    function: &str,
    arguments: &[V],
    options: &[OptionWord],
) -> Option<Result<V, FormulaErrorKind>> {
    if !NAMES.contains(&function) {
        return None;
    }
    if let Some(option) = options.first() {
        return Some(Err(no_option(function, option)));
    }
    Some(match (function, arguments) {
        ("abs", [x]) => x.absolute().ok_or(FormulaErrorKind::Unsupported(SYMBOLIC)),
        ("max", [first, rest @ ..]) => {
            rest.iter().try_fold(first.clone(), |best, value| greater(&best, value))
        }
        ("min", [first, rest @ ..]) => {
            rest.iter().try_fold(first.clone(), |best, value| lesser(&best, value))
        }
        ("floor", [x]) => floor(x).map(|floor| V::from_rational(&Rational::from(floor))),
        ("ceil", [x]) => {
            floor(&V::zero().minus(x)).map(|floor| V::from_rational(&Rational::from(-floor)))
        }
        ("mod", [x, modulus]) => modulo(x, modulus),
        ("kronecker", [left, right]) => kronecker(left, right),
        ("binomial", [top, bottom]) => binomial(top, bottom),
        ("factorial", [n]) => factorial(n),
        (SQUARE_ROOT, [x]) => square_root(x),
        (ROOT, [coefficients @ .., number]) => {
            integer("the number of a root", number).and_then(|number| root(coefficients, number))
        }
        (name, given) => Err(wrong_count(name, given.len())),
    })
}

/// The error that `name` was given an option, which it does not take.
pub(super) fn no_option(name: &str, option: &OptionWord) -> FormulaErrorKind {
    FormulaErrorKind::Call(format!("`{name}` takes no option `{}`", option.name))
}

/// The error that `name` was given a wrong number of arguments; the message states the
/// right number.
pub(super) fn wrong_count(name: &str, given: usize) -> FormulaErrorKind {
    let takes = match name {
        "min" | "max" => "one argument or more",
        "binomial" | "kronecker" | "mod" => "two arguments",
        ROOT => "a list of coefficients and a number",
        _ => "one argument",
    };
    FormulaErrorKind::Call(format!("`{name}` takes {takes}, and was given {given} arguments"))
}

const SYMBOLIC: &str =
    "this has no value while a parameter is symbolic, or while its sign is not decided";

fn floor<V: Value>(value: &V) -> Result<Integer, FormulaErrorKind> {
    value.floor().ok_or(FormulaErrorKind::Unsupported(SYMBOLIC))
}

/// x − m⌊x/m⌋.
fn modulo<V: Value>(x: &V, modulus: &V) -> Result<V, FormulaErrorKind> {
    let quotient = floor(&apply(Operator::Divide, x.clone(), modulus)?)?;
    let multiple = multiply(modulus, &V::from_rational(&Rational::from(quotient)))?;
    apply(Operator::Subtract, x.clone(), &multiple)
}

/// 1 if left = right, otherwise 0.
fn kronecker<V: Value>(left: &V, right: &V) -> Result<V, FormulaErrorKind> {
    let difference = apply(Operator::Subtract, left.clone(), right)?;
    let equal = difference.vanishes().ok_or(FormulaErrorKind::Unsupported(SYMBOLIC))?;
    Ok(V::from_rational(&Rational::from(i64::from(equal))))
}

/// An error unless some field within the cap contains both values.
fn together<V: Value>(left: &V, right: &V) -> Result<(), FormulaErrorKind> {
    left.meets(right)
}

/// max(left, right).
pub(super) fn greater<V: Value>(left: &V, right: &V) -> Result<V, FormulaErrorKind> {
    together(left, right)?;
    left.larger(right).ok_or(FormulaErrorKind::Unsupported(SYMBOLIC))
}

/// min(left, right), computed as left + right − max(left, right).
pub(super) fn lesser<V: Value>(left: &V, right: &V) -> Result<V, FormulaErrorKind> {
    Ok(left.plus(right).minus(&greater(left, right)?))
}

/// left ∘ right, computed in a field that contains both.
pub(super) fn apply<V: Value>(
    operator: Operator,
    mut left: V,
    right: &V,
) -> Result<V, FormulaErrorKind> {
    together(&left, right)?;
    match operator {
        Operator::Add => {
            left.accumulate(right);
            Ok(left)
        }
        Operator::Subtract => Ok(left.minus(right)),
        Operator::Multiply => multiply(&left, right),
        Operator::Divide => divide(&left, right),
    }
}

/// left · right.
fn multiply<V: Value>(left: &V, right: &V) -> Result<V, FormulaErrorKind> {
    if left.product_size(right) > MAX_BITS {
        return Err(FormulaErrorKind::too_large("the number of bits", MAX_BITS));
    }
    Ok(left.times(right))
}

/// left / right.
fn divide<V: Value>(left: &V, right: &V) -> Result<V, FormulaErrorKind> {
    if right.vanishes() == Some(true) {
        return Err(FormulaErrorKind::DivisionByZero);
    }
    if left.quotient_size(right) > MAX_BITS {
        return Err(FormulaErrorKind::too_large("the number of bits", MAX_BITS));
    }
    left.divided(right)
}

/// `value` as a machine integer; an error unless it is an integer of absolute value below
/// 2^40.
pub(super) fn integer<V: Value>(what: &'static str, value: &V) -> Result<i64, FormulaErrorKind> {
    let rational = value.as_rational().filter(Rational::is_integer);
    let integer = rational
        .ok_or_else(|| FormulaErrorKind::NotAnInteger { what, value: value.to_string() })?;
    integer.numerator().within((1 << 40) - 1).ok_or(FormulaErrorKind::too_large(what, 1 << 40))
}

/// base^exponent, for an integer exponent.
pub(super) fn power<V: Value>(base: &V, exponent: &V) -> Result<V, FormulaErrorKind> {
    let too_large = FormulaErrorKind::too_large("the power", MAX_BITS);
    let exponent = integer("an exponent", exponent)?;
    let magnitude = u32::try_from(exponent.unsigned_abs()).map_err(|_| too_large.clone())?;
    if let Some(base) = base.as_rational() {
        if base.is_zero() && exponent < 0 {
            return Err(FormulaErrorKind::DivisionByZero);
        }
        if base.bits() > 2 && base.bits().saturating_mul(u64::from(magnitude)) > MAX_BITS {
            return Err(too_large);
        }
        let exponent = i32::try_from(exponent).map_err(|_| too_large)?;
        return Ok(V::from_rational(&base.pow(exponent)));
    }
    if u64::from(magnitude) > MAX_SYMBOLIC_POWER {
        let what = "the power of a symbol or cosine";
        return Err(FormulaErrorKind::too_large(what, MAX_SYMBOLIC_POWER));
    }
    let one = V::from_rational(&Rational::one());
    let power =
        (0..magnitude).try_fold(one.clone(), |power, _| apply(Operator::Multiply, power, base))?;
    if exponent < 0 { divide(&one, &power) } else { Ok(power) }
}

/// n! for an integer n ≥ 0.
fn factorial<V: Value>(n: &V) -> Result<V, FormulaErrorKind> {
    let what = "the argument of `factorial`";
    let n = integer(what, n)?;
    if n.unsigned_abs() > MAX_FACTORIAL {
        return Err(FormulaErrorKind::too_large(what, MAX_FACTORIAL));
    }
    if n < 0 {
        return Err(FormulaErrorKind::Undefined(format!("there is no factorial of {n}")));
    }
    let factors: Vec<Integer> = (1..=n).map(Integer::from).collect();
    Ok(V::from_rational(&Rational::from(product(&factors))))
}

/// C(top, bottom) = top(top − 1)…(top − bottom + 1)/bottom!, 0 for bottom < 0.
fn binomial<V: Value>(top: &V, bottom: &V) -> Result<V, FormulaErrorKind> {
    let what = "the lower index of `binomial`";
    let bottom = integer(what, bottom)?;
    if bottom < 0 {
        return Ok(V::zero());
    }
    let cap = if top.as_rational().is_some() { MAX_BINOMIAL } else { MAX_SYMBOLIC_POWER };
    if bottom.unsigned_abs() > cap {
        return Err(FormulaErrorKind::too_large(what, cap));
    }
    let Some(top) = top.as_rational() else {
        let factor = |i| top.minus(&V::from_rational(&Rational::from(i)));
        let factorial = product(&(1..=bottom).map(Integer::from).collect::<Vec<_>>());
        let first = V::from_rational(&Rational::new(1, factorial));
        return (0..bottom).try_fold(first, |product, i| multiply(&product, &factor(i)));
    };
    // Each factor adds at most the bits of `top` plus 14, as an index is below 2^14.
    if bottom.unsigned_abs().saturating_mul(top.bits() + 14) > MAX_BITS {
        return Err(FormulaErrorKind::too_large("the number of bits", MAX_BITS));
    }
    // With top = p/q the factors are (p − iq)/q. The numerators are coprime to q. Their product is
    // divisible by the part of bottom! that is coprime to q, since binomial coefficients of p/q are
    // integral at every prime that does not divide q.
    let (p, q) = (top.numerator(), top.denominator());
    let numerators: Vec<Integer> = (0..bottom).map(|i| &p - &q * Integer::from(i)).collect();
    let (mut without, mut with) = (Vec::new(), Vec::new());
    for i in (1..=bottom).map(Integer::from) {
        let mut rest = i.clone();
        loop {
            let common = rest.gcd(&q);
            if common == Integer::one() {
                break;
            }
            rest = rest.div_floor(&common);
        }
        with.push(i.div_floor(&rest));
        without.push(rest);
    }
    let numerator = product(&numerators).div_floor(&product(&without));
    let scale = u32::try_from(bottom).map(|bottom| q.pow(bottom)).expect("at most the cap");
    Ok(V::from_rational(&Rational::new(numerator, product(&with) * scale)))
}

/// The product of `factors`, by halves, so that the two factors of each multiplication
/// have similar lengths.
fn product(factors: &[Integer]) -> Integer {
    match factors {
        [] => Integer::one(),
        [one] => one.clone(),
        _ => {
            let (left, right) = factors.split_at(factors.len() / 2);
            product(left) * product(right)
        }
    }
}
