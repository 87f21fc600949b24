//! From formula to value.

use crate::decimal::{Q, int};
use crate::formula::Expr;
use crate::functions;
use crate::memo::Memo;
use crate::number::Number;
use crate::reading::Reading;
use crate::scheme::{Library, Scheme};
use crate::value::{Piece, Stop, Value};
use num_traits::{One, ToPrimitive};
use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// The most steps of one claim: nodes of formulas, sums unrolled, and for products those
/// of [`Value::cost`].
pub const MAX_STEPS: u64 = 20_000_000;

/// How deep formulas may be nested, those that are entered by name included.
const MAX_DEPTH: usize = 200;

/// How deep named formulas may refer to named formulas.
const MAX_DEFINITIONS: usize = 32;

/// The greatest integer that indices and exponents are read as.
const MAX_INTEGER: i64 = 1_000_000;

/// The indices of the sums around a formula, the innermost last.
pub type Indices = Vec<(String, Value)>;

/// What names mean.
pub struct Scope<'a> {
    /// The formulas that names stand for.
    pub definitions: &'a BTreeMap<String, Rc<Expr>>,
    /// Names with values; they go before definitions.
    pub values: BTreeMap<String, Value>,
    /// Names that exist, without a value.
    pub unstated: BTreeSet<String>,
    /// The names of families: every member is a symbol, unless it has a value.
    pub families: BTreeSet<String>,
    /// The scheme that functions are about.
    pub scheme: Option<Rc<Scheme>>,
    /// Where signs of polynomials are taken.
    pub piece: Option<Piece>,
    /// The way in which the options of functions are read.
    pub reading: &'a Reading,
    /// Values of definitions that are known already; not where members of families have values.
    pub memo: Option<&'a Memo>,
    /// The schemes, and what is known of them.
    pub library: &'a Library<'a>,
    /// How many definitions are entered.
    pub entered: Cell<usize>,
    /// How deep the evaluation is.
    pub depth: Cell<usize>,
    /// Whether this is inside of `cos`, where `pi` has a meaning.
    pub angle: Cell<bool>,
}

impl<'a> Scope<'a> {
    /// A scope in which nothing has a value.
    pub fn new(
        definitions: &'a BTreeMap<String, Rc<Expr>>,
        library: &'a Library<'a>,
        reading: &'a Reading,
    ) -> Scope<'a> {
        Scope {
            definitions,
            values: BTreeMap::new(),
            unstated: BTreeSet::new(),
            families: BTreeSet::new(),
            scheme: None,
            piece: None,
            reading,
            memo: None,
            library,
            entered: Cell::new(0),
            depth: Cell::new(0),
            angle: Cell::new(false),
        }
    }

    /// The value of a formula.
    pub fn value(&self, expr: &Expr) -> Result<Value, Stop> {
        self.evaluate(expr, &mut Vec::new())
    }

    /// The value of a formula inside of sums.
    pub fn evaluate(&self, expr: &Expr, indices: &mut Indices) -> Result<Value, Stop> {
        self.library.spend(1)?;
        if self.depth.get() == MAX_DEPTH {
            return Err(Stop::Capped("the nesting of formulas"));
        }
        self.depth.set(self.depth.get() + 1);
        let value = self.node(expr, indices);
        self.depth.set(self.depth.get() - 1);
        value
    }

    fn node(&self, expr: &Expr, indices: &mut Indices) -> Result<Value, Stop> {
        match expr {
            Expr::Number(value) => Ok(Value::from(value.clone())),
            Expr::Name(name) => self.name(name, indices),
            Expr::Member(name, positions) => {
                let mut key = Vec::new();
                for position in positions {
                    let position = self.evaluate(position, indices)?;
                    key.push(position.integer(MAX_INTEGER)?.to_string());
                }
                self.name(&format!("{name}[{}]", key.join(",")), indices)
            }
            Expr::Minus(operand) => Value::int(0).plus(-1, &self.evaluate(operand, indices)?),
            Expr::Chain(first, rest) => {
                let mut value = self.evaluate(first, indices)?;
                for (operator, operand) in rest {
                    let right = self.evaluate(operand, indices)?;
                    value = match operator {
                        '+' => value.add(1, &right)?,
                        '-' => value.add(-1, &right)?,
                        '*' => {
                            self.library.spend(value.cost(&right))?;
                            value.times(&right)?
                        }
                        _ => value.over(&right)?,
                    };
                }
                Ok(value)
            }
            Expr::Power(base, exponent) => {
                let base = self.evaluate(base, indices)?;
                let exponent = self.evaluate(exponent, indices)?.integer(MAX_INTEGER)?;
                let power = base.power(exponent)?;
                self.library.spend(power.cost(&power))?;
                Ok(power)
            }
            Expr::Call(name, arguments, _) if name == "cos" => self.cosine(arguments, indices),
            Expr::Call(name, arguments, options) => {
                let mut values = Vec::with_capacity(arguments.len());
                for argument in arguments {
                    values.push(self.evaluate(argument, indices)?);
                }
                match self.own_function(name, &values) {
                    Some(value) if options.is_empty() => value,
                    Some(_) => Err(Stop::Wrong(format!("`{name}` takes no options"))),
                    None => functions::call(self, name, &values, options, indices),
                }
            }
            Expr::Over(fold, index, parts) => self.over(fold, index, parts, indices),
        }
    }

    /// The value of a name.
    pub fn name(&self, name: &str, indices: &mut Indices) -> Result<Value, Stop> {
        if name == "pi" && self.angle.get() {
            return Ok(Value::symbol("pi"));
        }
        let index = indices.iter().rev().find(|(index, _)| index == name);
        if let Some(value) = index.map(|(_, value)| value).or_else(|| self.values.get(name)) {
            return Ok(value.clone());
        }
        if self.unstated.contains(name) {
            return Err(Stop::Unstated(name.to_owned()));
        }
        if name.split_once('[').is_some_and(|(family, _)| self.families.contains(family)) {
            return Ok(Value::symbol(name));
        }
        let Some(definition) = self.definitions.get(name) else {
            return Err(Stop::Wrong(format!("`{name}` is unknown")));
        };
        if self.entered.get() == MAX_DEFINITIONS {
            return Err(Stop::Wrong(format!("`{name}` is defined by itself, or too deep")));
        }
        self.entered.set(self.entered.get() + 1);
        let angle = self.angle.replace(false);
        let value = match self.memo.filter(|_| indices.is_empty()) {
            Some(memo) => self.known(memo, name, definition),
            None => self.evaluate(definition, indices),
        };
        self.angle.set(angle);
        self.entered.set(self.entered.get() - 1);
        value
    }

    /// The value of a definition outside of sums, evaluated once for each meaning of the
    /// names in it.
    fn known(&self, memo: &Memo, name: &str, definition: &Expr) -> Result<Value, Stop> {
        let free = memo.names(name, definition, self.definitions);
        let meanings = free.iter().map(|name| self.values.get(name).cloned());
        let meanings: Vec<Option<Value>> = meanings.collect();
        let scheme = self.scheme.as_ref().map_or(0, |scheme| Rc::as_ptr(scheme) as usize);
        if let Some(value) = memo.get(name, scheme, &meanings) {
            return Ok(value);
        }
        let value = self.evaluate(definition, &mut Vec::new())?;
        memo.keep(name, scheme, meanings, &value);
        Ok(value)
    }

    fn cosine(&self, arguments: &[Expr], indices: &mut Indices) -> Result<Value, Stop> {
        let wrong = || Stop::Wrong("`cos` takes one rational multiple of pi".into());
        let [argument] = arguments else { return Err(wrong()) };
        let outer = self.angle.replace(true);
        let angle = self.evaluate(argument, indices);
        self.angle.set(outer);
        let multiple = match angle? {
            Value::Number(number) if number.is_zero() => int(0),
            Value::Polynomial(terms) if terms.len() == 1 => {
                let only = terms.into_iter().next();
                let only = only.filter(|(monomial, _)| *monomial == [("pi".into(), 1)]);
                only.and_then(|(_, multiple)| multiple.rational()).ok_or_else(wrong)?
            }
            _ => return Err(wrong()),
        };
        let cosine = Number::cosine(&(multiple / int(2)));
        cosine.map(Value::Number).ok_or(Stop::Capped("the field of the cosines"))
    }

    fn over(
        &self,
        fold: &str,
        index: &str,
        [from, to, body]: &[Expr; 3],
        indices: &mut Indices,
    ) -> Result<Value, Stop> {
        let from = self.evaluate(from, indices)?.integer(MAX_INTEGER)?;
        let to = self.evaluate(to, indices)?.integer(MAX_INTEGER)?;
        let mut total = (fold == "sum").then(|| Value::int(0));
        for i in from..=to {
            indices.push((index.to_owned(), Value::int(i)));
            let term = self.evaluate(body, indices);
            indices.pop();
            let term = term?;
            total = Some(match total {
                None => term,
                Some(total) => match fold {
                    "sum" => total.add(1, &term)?,
                    "max" => total.max(&term, self.piece.as_ref())?,
                    _ => self.min(&total, &term)?,
                },
            });
        }
        total.ok_or_else(|| Stop::Wrong("an extreme of nothing".into()))
    }

    /// min(a, b) = a + b − max(a, b).
    fn min(&self, a: &Value, b: &Value) -> Result<Value, Stop> {
        a.plus(1, b)?.plus(-1, &a.max(b, self.piece.as_ref())?)
    }

    /// The functions of the language itself; `None` for others.
    fn own_function(&self, name: &str, arguments: &[Value]) -> Option<Result<Value, Stop>> {
        let piece = self.piece.as_ref();
        let whole = |value: &Value| Ok(Value::from(Q::from_integer(value.floor()?)));
        Some(match (name, arguments) {
            ("abs", [x]) => x.abs(piece),
            ("max", [first, rest @ ..]) => {
                rest.iter().try_fold(first.clone(), |best, x| best.max(x, piece))
            }
            ("min", [first, rest @ ..]) => {
                rest.iter().try_fold(first.clone(), |best, x| self.min(&best, x))
            }
            ("floor", [x]) => whole(x),
            ("ceil", [x]) => Value::int(0)
                .plus(-1, x)
                .and_then(|x| whole(&x))
                .and_then(|floor| Value::int(0).plus(-1, &floor)),
            ("mod", [x, m]) => {
                let quotient = x.over(m).and_then(|quotient| whole(&quotient));
                quotient.and_then(|quotient| x.plus(-1, &m.times(&quotient)?))
            }
            ("kronecker", [a, b]) => a.plus(-1, b).and_then(|difference| {
                difference.number().map(|_| Value::int(i64::from(difference.is_zero())))
            }),
            ("binomial", [top, bottom]) => self.binomial(top, bottom),
            ("abs" | "max" | "min" | "floor" | "ceil" | "mod" | "kronecker" | "binomial", _) => {
                Err(Stop::Wrong(format!("`{name}` does not take {} arguments", arguments.len())))
            }
            _ => return None,
        })
    }

    /// top(top − 1)…(top − bottom + 1)/bottom!, and 0 for bottom < 0.
    fn binomial(&self, top: &Value, bottom: &Value) -> Result<Value, Stop> {
        let bottom = bottom.integer(10_000)?;
        if bottom < 0 {
            return Ok(Value::int(0));
        }
        self.library.spend(bottom.to_u64().unwrap_or(0))?;
        (0..bottom).try_fold(Value::from(Q::one()), |product, i| {
            let factor = top.plus(-1, &Value::int(i))?;
            product.times(&factor)?.over(&Value::int(i + 1))
        })
    }
}
