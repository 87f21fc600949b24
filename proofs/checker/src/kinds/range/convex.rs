//! Formulas in two variables that are greatest or least values of linear functions.

#![warn(clippy::arithmetic_side_effects)]

use crate::formulas::{Expr, Head, Indices, MAX_INTEGER, Range, Scope, names, of_nothing, range};
use crate::numbers::{Q, Value, int};
use crate::text::Stop;
use num_traits::{Signed as _, Zero as _};

/// The most linear functions of which one value is the greatest.
const MAX_FUNCTIONS: usize = 1_000;

/// How deep formulas may be nested, with those that names stand for.
const MAX_DEPTH: usize = 200;

/// What a region has to be.
pub const REGION: Stop = Stop::Capped(
    "regions other than bounded convex polygons with inner points, by linear functions",
);

/// A linear function with rational coefficients: those of the two variables, and the constant.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Linear(pub [Q; 3]);

/// The value of a formula.
#[derive(Clone)]
pub enum Shape {
    /// A linear function.
    Linear(Linear),
    /// The greatest value of several.
    Greatest(Vec<Linear>),
    /// The least value of several.
    Least(Vec<Linear>),
}

/// The formulas of a scope in which two names are symbols.
pub struct Shapes<'s> {
    pub scope: &'s Scope<'s>,
    pub names: [&'s str; 2],
}

impl Linear {
    fn plus(&self, other: &Linear) -> Linear {
        let [a, b, c] = &self.0;
        let [d, e, f] = &other.0;
        Linear([a + d, b + e, c + f])
    }

    fn times(&self, factor: &Q) -> Linear {
        Linear(self.0.each_ref().map(|c| c * factor))
    }

    /// A polynomial in two symbols, if it is linear.
    pub fn of(value: &Value, names: [&str; 2]) -> Option<Linear> {
        let mut linear = [int(0), int(0), int(0)];
        for (monomial, coefficient) in value.all() {
            let place = match monomial {
                [] => 2,
                [(name, 1)] => names.iter().position(|known| **known == **name)?,
                _ => return None,
            };
            linear[place] = coefficient.rational()?;
        }
        Some(Linear(linear))
    }

    /// The function with the same zeros of which the first coefficient of a variable that is not 0 is 1.
    pub fn monic(&self) -> Option<Linear> {
        let [x, y, _] = &self.0;
        let first = [x, y].into_iter().find(|c| !c.is_zero())?;
        Some(self.times(&first.recip()))
    }

    /// The negative of it.
    pub fn negated(&self) -> Linear {
        self.times(&int(-1))
    }

    /// Its value, if it has only one.
    pub fn constant(&self) -> Option<&Q> {
        let [x, y, constant] = &self.0;
        (x.is_zero() && y.is_zero()).then_some(constant)
    }

    /// The binary digits of its longest coefficient.
    pub fn bits(&self) -> u64 {
        self.0.iter().map(crate::numbers::bits).max().unwrap_or(0)
    }
}

impl Shape {
    fn times(&self, factor: &Q) -> Shape {
        let each = |all: &[Linear]| all.iter().map(|one| one.times(factor)).collect();
        match self {
            Shape::Linear(one) => Shape::Linear(one.times(factor)),
            _ if factor.is_zero() => Shape::Linear(Linear([int(0), int(0), int(0)])),
            Shape::Greatest(all) if factor.is_positive() => Shape::Greatest(each(all)),
            Shape::Least(all) if factor.is_positive() => Shape::Least(each(all)),
            Shape::Greatest(all) => Shape::Least(each(all)),
            Shape::Least(all) => Shape::Greatest(each(all)),
        }
    }

    /// The linear functions of which the value is the greatest, if it is.
    pub fn convex(self) -> Result<Vec<Linear>, Stop> {
        match self {
            Shape::Linear(one) => Ok(vec![one]),
            Shape::Greatest(all) => Ok(all),
            Shape::Least(_) => Err(REGION),
        }
    }
}

impl Shapes<'_> {
    /// The value of the first formula less that of the second.
    pub fn difference(&self, one: &Expr, other: &Expr) -> Result<Shape, Stop> {
        let [one, other] = [self.of(one)?, self.of(other)?];
        self.sum(&one, &other.times(&int(-1)))
    }

    fn of(&self, expr: &Expr) -> Result<Shape, Stop> {
        self.shape(expr, &mut Indices::new(), 0)
    }

    /// The value as a polynomial if it is one, and otherwise by its parts.
    fn shape(&self, expr: &Expr, indices: &mut Indices, depth: usize) -> Result<Shape, Stop> {
        let stop = match self.scope.evaluate(expr, indices) {
            Ok(value) => return self.linear(&value).map(Shape::Linear),
            Err(stop) => stop,
        };
        // A meter that has run out stays so.
        self.scope.spend(1)?;
        if depth == MAX_DEPTH {
            return Err(Stop::Capped("the nesting of formulas"));
        }
        let depth = depth.saturating_add(1);
        match expr {
            Expr::Name(name) if !self.scope.values.contains_key(name) => {
                let definition = self.scope.definitions.get(name).ok_or(stop)?;
                self.shape(definition, indices, depth)
            }
            Expr::Of(Head::Minus, parts) if parts.len() == 1 => {
                Ok(self.shape(&parts[0], indices, depth)?.times(&int(-1)))
            }
            Expr::Of(Head::Chain(operators), parts) => {
                self.chain((operators, parts), indices, depth)
            }
            Expr::Of(Head::Call(name, options), parts)
                if ["abs", "max", "min"].contains(&&**name) && options.is_empty() =>
            {
                let shapes = parts.iter().map(|part| self.shape(part, indices, depth));
                let shapes = shapes.collect::<Result<Vec<Shape>, Stop>>()?;
                match (&**name, &shapes[..]) {
                    ("abs", [Shape::Linear(one)]) => {
                        Ok(Shape::Greatest(vec![one.clone(), one.times(&int(-1))]))
                    }
                    ("max" | "min", [first, rest @ ..]) => {
                        rest.iter().try_fold(first.clone(), |all, next| join(name, &all, next))
                    }
                    _ => Err(REGION),
                }
            }
            Expr::Of(Head::Over(fold, index), parts) if fold != "product" => {
                let [from, to, body] = range(parts)?;
                self.scope.index(index)?;
                let ends = [self.scope.evaluate(from, indices)?, self.scope.evaluate(to, indices)?];
                let [from, to] = ends.map(|end| end.integer(MAX_INTEGER));
                let ends = [from?, to?];
                Range { index, ends, others: indices, value: Value::int }.total(
                    of_nothing(fold).map(|_| Shape::Linear(Linear([int(0), int(0), int(0)]))),
                    |indices| self.shape(body, indices, depth),
                    |all, next| match &**fold {
                        "sum" => self.sum(all, next),
                        fold => join(fold, all, next),
                    },
                )
            }
            _ => {
                // What is said of the variables by other functions may well have values.
                let found = names(expr, self.scope.definitions);
                Err(if self.names.iter().any(|name| found.contains(*name)) { REGION } else { stop })
            }
        }
    }

    /// A polynomial that is linear.
    fn linear(&self, value: &Value) -> Result<Linear, Stop> {
        Linear::of(value, self.names).ok_or(REGION)
    }

    fn chain(
        &self,
        (operators, parts): (&[char], &[Expr]),
        indices: &mut Indices,
        depth: usize,
    ) -> Result<Shape, Stop> {
        let Some((first, rest)) = parts.split_first() else { return Err(REGION) };
        let mut total = self.shape(first, indices, depth)?;
        for (operator, part) in operators.iter().zip(rest) {
            let part = self.shape(part, indices, depth)?;
            let number = |shape: &Shape| match shape {
                Shape::Linear(one) => one.constant().cloned(),
                _ => None,
            };
            total = match (operator, number(&total), number(&part)) {
                ('+', ..) => self.sum(&total, &part)?,
                ('-', ..) => self.sum(&total, &part.times(&int(-1)))?,
                ('/', _, Some(number)) if number.is_zero() => {
                    return Err(Stop::Undefined("division by zero"));
                }
                ('/', _, Some(number)) => total.times(&number.recip()),
                ('*', _, Some(number)) => total.times(&number),
                ('*', Some(number), None) => part.times(&number),
                _ => return Err(REGION),
            };
        }
        Ok(total)
    }

    /// The sum: one of greatest values is the greatest of all sums.
    fn sum(&self, one: &Shape, other: &Shape) -> Result<Shape, Stop> {
        let all = |one: &[Linear], other: &[Linear]| {
            let count = one.len().saturating_mul(other.len());
            if count > MAX_FUNCTIONS {
                return Err(Stop::Capped("the linear functions of a region"));
            }
            let longest = one.iter().chain(other).map(Linear::bits).max().unwrap_or(0);
            self.scope.spend((count as u64).saturating_mul(steps(longest)))?;
            Ok(one.iter().flat_map(|one| other.iter().map(|other| one.plus(other))).collect())
        };
        match (one, other) {
            (Shape::Linear(one), Shape::Linear(other)) => Ok(Shape::Linear(one.plus(other))),
            (Shape::Linear(one), Shape::Greatest(more))
            | (Shape::Greatest(more), Shape::Linear(one)) => {
                Ok(Shape::Greatest(all(std::slice::from_ref(one), more)?))
            }
            (Shape::Linear(one), Shape::Least(more)) | (Shape::Least(more), Shape::Linear(one)) => {
                Ok(Shape::Least(all(std::slice::from_ref(one), more)?))
            }
            (Shape::Greatest(one), Shape::Greatest(other)) => Ok(Shape::Greatest(all(one, other)?)),
            (Shape::Least(one), Shape::Least(other)) => Ok(Shape::Least(all(one, other)?)),
            _ => Err(REGION),
        }
    }
}

/// The steps of a product of fractions of so many binary digits. Common divisors of long ones take long.
pub fn steps(bits: u64) -> u64 {
    let words = bits / 64;
    words.saturating_mul(words).saturating_add(words).saturating_add(1)
}

/// The greater or the lesser one of two values.
fn join(fold: &str, one: &Shape, other: &Shape) -> Result<Shape, Stop> {
    let greatest = fold == "max";
    let of = |shape: &Shape| match shape {
        Shape::Linear(one) => Ok(vec![one.clone()]),
        Shape::Greatest(all) if greatest => Ok(all.clone()),
        Shape::Least(all) if !greatest => Ok(all.clone()),
        _ => Err(REGION),
    };
    let all = [of(one)?, of(other)?].concat();
    if all.len() > MAX_FUNCTIONS {
        return Err(Stop::Capped("the linear functions of a region"));
    }
    Ok(if greatest { Shape::Greatest(all) } else { Shape::Least(all) })
}
