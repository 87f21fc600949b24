//! The values of formulas, enclosed by intervals.

use super::functions::{Call, is_zero};
use crate::enclosures::{Circle, Interval};
use crate::formulas::{
    Definitions, Expr, Head, MAX_INTEGER, Range, names as names_in, of_nothing, range,
};
use crate::numbers::{Meter, Q};
use crate::text::Stop;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeSet, HashMap};

/// The greatest depth of an evaluation. Names that stand for formulas count.
const MAX_DEPTH: usize = 200;

/// Names with their values, the innermost last.
type Indices = Vec<(String, Interval)>;

/// What becomes of the value of a definition before it is used.
pub type Change<'a> = (&'a str, &'a dyn Fn(&Interval) -> Result<Interval, Stop>);

/// The values of formulas with enclosures of so many binary digits.
pub struct Values<'a> {
    definitions: &'a Definitions,
    call: Call<'a>,
    change: Option<Change<'a>>,
    circle: RefCell<Option<Circle>>,
    cosines: RefCell<HashMap<Q, Interval>>,
    known: RefCell<HashMap<(String, Indices), Interval>>,
    names: RefCell<HashMap<String, BTreeSet<String>>>,
    depth: Cell<usize>,
}

impl<'a> Values<'a> {
    /// The values under these definitions, of which one may be changed.
    pub fn new(
        definitions: &'a Definitions,
        bits: u64,
        meter: &'a Meter,
        change: Option<Change<'a>>,
    ) -> Values<'a> {
        let (circle, cosines, known, names, depth) = Default::default();
        let call = Call { bits, meter };
        Values { definitions, call, change, circle, cosines, known, names, depth }
    }

    /// The value of a formula in these indices.
    pub fn value(&self, expr: &Expr, indices: &[(String, i64)]) -> Result<Interval, Stop> {
        let mut indices: Indices =
            indices.iter().map(|(name, value)| (name.clone(), (*value).into())).collect();
        self.evaluate(expr, &mut indices)
    }

    fn evaluate(&self, expr: &Expr, indices: &mut Indices) -> Result<Interval, Stop> {
        if self.depth.get() == MAX_DEPTH {
            return Err(Stop::Capped("the nesting of formulas"));
        }
        self.depth.set(self.depth.get() + 1);
        let value = match expr {
            Expr::Number(number) => match number.rational() {
                Some(value) => Interval::point(value),
                None => Err(Stop::Wrong("this is no number".to_owned())),
            },
            Expr::Name(name) => self.name(name, indices),
            Expr::Of(Head::Over(fold, index), parts) => self.over(fold, index, parts, indices),
            Expr::Of(head, parts) => self.of(head, parts, indices),
        };
        self.depth.set(self.depth.get() - 1);
        let words = value.as_ref().map_or(0, |value| value.size() / 64);
        self.call.meter.spend(1 + words * words / 256)?;
        value
    }

    fn of(&self, head: &Head, parts: &[Expr], indices: &mut Indices) -> Result<Interval, Stop> {
        if let (Head::Call(name, options), [angle]) = (head, parts)
            && name == "cos"
            && options.is_empty()
        {
            return self.cosine(angle, indices);
        }
        let values = parts.iter().map(|part| self.evaluate(part, indices));
        let values = values.collect::<Result<Vec<Interval>, Stop>>()?;
        match (head, &values[..]) {
            (Head::Minus, [x]) => Ok(x.negated()),
            (Head::Chain(operators), [first, rest @ ..]) => {
                let mut parts = operators.iter().zip(rest);
                parts.try_fold(first.clone(), |left, (sign, right)| self.join(*sign, &left, right))
            }
            (Head::Power, [base, exponent]) => {
                base.power(exponent.integer(MAX_INTEGER)?, self.call.bits)
            }
            (Head::Call(name, options), values) if options.is_empty() => {
                self.call.value(name, values)
            }
            _ => Err(Stop::Wrong("this is no formula of a number".to_owned())),
        }
    }

    fn join(&self, sign: char, left: &Interval, right: &Interval) -> Result<Interval, Stop> {
        let bits = self.call.bits;
        match sign {
            '+' => left.plus(right, bits),
            '-' => left.minus(right, bits),
            '/' => left.times(&right.inverse(bits)?, bits),
            _ => left.times(right, bits),
        }
    }

    /// The value of a name.
    fn name(&self, name: &str, indices: &mut Indices) -> Result<Interval, Stop> {
        if let Some((_, value)) = indices.iter().rev().find(|(index, _)| index == name) {
            return Ok(value.clone());
        }
        let definition = self.definitions.get(name);
        let definition = definition.ok_or_else(|| Stop::Wrong(format!("`{name}` is unknown")))?;
        let occurring: Indices = {
            let mut names = self.names.borrow_mut();
            let names = names.entry(name.to_owned());
            let names = names.or_insert_with(|| names_in(definition, self.definitions));
            indices.iter().filter(|(index, _)| names.contains(index)).cloned().collect()
        };
        let key = (name.to_owned(), occurring);
        if let Some(known) = self.known.borrow().get(&key) {
            return Ok(known.clone());
        }
        let mut value = self.evaluate(definition, indices)?;
        if let Some((changed, change)) = self.change
            && changed == name
        {
            value = change(&value)?;
        }
        self.known.borrow_mut().insert(key, value.clone());
        Ok(value)
    }

    fn over(
        &self,
        fold: &str,
        index: &str,
        parts: &[Expr],
        indices: &mut Indices,
    ) -> Result<Interval, Stop> {
        let [from, to, body] = range(parts)?;
        let hides = indices.iter().any(|(name, _)| name == index);
        if hides || self.definitions.contains_key(index) || index == "pi" {
            return Err(Stop::Wrong(format!("the index `{index}` has another meaning")));
        }
        let from = self.evaluate(from, indices)?.integer(MAX_INTEGER)?;
        let to = self.evaluate(to, indices)?.integer(MAX_INTEGER)?;
        let range = Range { index, ends: [from, to], others: indices, value: Interval::from };
        range.total(
            of_nothing(fold).map(Interval::from),
            |indices| self.evaluate(body, indices),
            |total, term| self.call.join(fold, total, term),
        )
    }

    /// The cosine of an angle.
    fn cosine(&self, angle: &Expr, indices: &mut Indices) -> Result<Interval, Stop> {
        let [plain, pi] = self.angle(angle, indices)?;
        let (true, Some(multiple)) = (is_zero(&plain), pi.exact()) else {
            return Err(if plain.exact().is_some() && pi.exact().is_some() {
                Stop::Wrong("`cos` takes one rational multiple of pi".to_owned())
            } else {
                Stop::Undecided("whether an angle is a rational multiple of pi")
            });
        };
        let turns = multiple / Q::from_integer(2.into());
        let turns = &turns - turns.floor();
        if let Some(known) = self.cosines.borrow().get(&turns) {
            return Ok(known.clone());
        }
        let mut circle = self.circle.borrow_mut();
        let circle = circle.get_or_insert_with(|| Circle::new(self.call.bits));
        self.call.meter.spend(circle.cost())?;
        let value = circle.cosine(&turns)?;
        self.cosines.borrow_mut().insert(turns, value.clone());
        Ok(value)
    }

    /// a and b of an angle a + bπ.
    fn angle(&self, expr: &Expr, indices: &mut Indices) -> Result<[Interval; 2], Stop> {
        let bits = self.call.bits;
        match expr {
            Expr::Name(name) if name == "pi" => Ok([0.into(), 1.into()]),
            Expr::Of(Head::Minus, parts) if parts.len() == 1 => {
                Ok(self.angle(&parts[0], indices)?.map(|part| part.negated()))
            }
            Expr::Of(Head::Chain(operators), parts) => {
                let mut angles = Vec::with_capacity(parts.len());
                for part in parts {
                    angles.push(self.angle(part, indices)?);
                }
                let mut angles = angles.into_iter();
                let mut left = angles.next().unwrap_or([0.into(), 0.into()]);
                for (operator, right) in operators.iter().zip(angles) {
                    let [a, b] = &left;
                    let [c, d] = &right;
                    left = match operator {
                        '+' | '-' => [self.join(*operator, a, c)?, self.join(*operator, b, d)?],
                        _ if is_zero(d) => {
                            [self.join(*operator, a, c)?, self.join(*operator, b, c)?]
                        }
                        '*' if is_zero(b) => [a.times(c, bits)?, a.times(d, bits)?],
                        _ => {
                            let why = "`cos` takes one rational multiple of pi";
                            return Err(Stop::Wrong(why.to_owned()));
                        }
                    };
                }
                Ok(left)
            }
            _ => Ok([self.evaluate(expr, indices)?, 0.into()]),
        }
    }
}
