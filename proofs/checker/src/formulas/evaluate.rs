//! The evaluation of formulas.

use super::definitions::{Definitions, names as names_in};
use super::formula::{Expr, Head, differences};
use super::memory::{Indices, Memory};
use super::range::{Range, of_nothing, range};
use super::reading::Reading;
use crate::numbers::{Meter, Piece, Value};
use crate::schemes::{Every, Lattice, Ring, Scheme};
use crate::text::Stop;
use std::borrow::Cow;
use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// The greatest depth of an evaluation. Names that stand for formulas count.
const MAX_DEPTH: usize = 200;

/// The greatest integer that indices and exponents are read as.
pub const MAX_INTEGER: i64 = 1_000_000;

/// A function with its arguments and options.
pub type Asked<'c> = (&'c str, &'c [Value], &'c [(String, String)]);

/// The options of a call.
type Options<'e> = Cow<'e, [(String, String)]>;

/// The functions that formulas call.
pub trait Functions {
    /// The value of a function.
    fn call(&self, scope: &Scope<'_>, of: Asked<'_>, indices: &mut Indices) -> Result<Value, Stop>;

    /// The meter that counts the steps of an evaluation.
    fn meter(&self) -> &Meter;

    /// Whether there is a scheme of this name.
    fn has_scheme(&self, name: &str) -> bool;
}

/// A scope: the meanings of names.
pub struct Scope<'a> {
    /// The formulas that names stand for.
    pub definitions: &'a Definitions,
    /// The names with values. They hide definitions.
    pub values: BTreeMap<String, Value>,
    /// The names of parameters without a value.
    pub unstated: BTreeSet<String>,
    /// The names of stated values that are beyond a cap.
    pub beyond: BTreeMap<String, Stop>,
    /// The names of families. A member without a value is a symbol.
    pub families: BTreeSet<String>,
    /// The scheme that functions are about.
    pub scheme: Option<Rc<Scheme>>,
    /// The mask on Z^d that functions are about.
    pub lattice: Option<Rc<Lattice>>,
    /// Whether filters may stand in functions: in relations and equations.
    pub filters: bool,
    /// The ring that functions are about, if it is none of a mask.
    pub ring: Option<Rc<Ring>>,
    /// Names without a value that no index may have either.
    pub reserved: &'static [&'static str],
    /// Names with values that an index may have. They are the indices of an equation.
    pub hidden: BTreeSet<String>,
    /// The piece on which polynomials have signs.
    pub piece: Option<Piece<'a>>,
    /// The indices with all integers from one on, where a relation is shown for all of them.
    pub every: Option<Every>,
    /// The reading of the options of functions.
    pub reading: &'a Reading,
    /// The number of the point that becomes number 0, where masks are read forwards.
    pub first: usize,
    functions: &'a dyn Functions,
    /// The values of definitions that are known under this reading.
    pub memory: Rc<Memory>,
    /// The depth of the evaluation.
    depth: Cell<usize>,
    /// Whether the evaluation is inside of `cos`, where `pi` has a meaning.
    angle: Cell<bool>,
}

impl<'a> Scope<'a> {
    /// A scope in which nothing has a value.
    pub fn new(
        definitions: &'a Definitions,
        functions: &'a dyn Functions,
        reading: &'a Reading,
    ) -> Scope<'a> {
        let (values, unstated, beyond, families) = Default::default();
        let (scheme, ring, piece, every, depth, angle) = Default::default();
        let (memory, reserved, hidden, lattice) = Default::default();
        Scope {
            definitions,
            values,
            unstated,
            beyond,
            families,
            scheme,
            lattice,
            filters: false,
            ring,
            reserved,
            hidden,
            piece,
            every,
            reading,
            first: 0,
            functions,
            memory,
            depth,
            angle,
        }
    }

    /// Counts steps of the claim at hand.
    pub fn spend(&self, steps: u64) -> Result<(), Stop> {
        self.functions.meter().spend(steps)
    }

    /// The value of a formula.
    pub fn value(&self, expr: &Expr) -> Result<Value, Stop> {
        self.evaluate(expr, &mut Vec::new())
    }

    /// The value of a formula inside of sums.
    pub fn evaluate(&self, expr: &Expr, indices: &mut Indices) -> Result<Value, Stop> {
        self.spend(1)?;
        if self.depth.get() == MAX_DEPTH {
            return Err(Stop::Capped("the nesting of formulas"));
        }
        self.depth.set(self.depth.get() + 1);
        let value = match expr {
            Expr::Number(value) => Ok(value.clone()),
            Expr::Name(name) => self.name(name, indices),
            Expr::Of(Head::Over(fold, index), parts) => self.over(fold, index, parts, indices),
            Expr::Of(Head::Chain(operators), parts) => self.chain(operators, parts, indices),
            Expr::Of(head, parts) => self.of(head, parts, indices),
        };
        self.depth.set(self.depth.get() - 1);
        value
    }

    /// Sums and products, from left to right.
    fn chain(
        &self,
        operators: &[char],
        parts: &[Expr],
        indices: &mut Indices,
    ) -> Result<Value, Stop> {
        let [first, rest @ ..] = parts else {
            return Err(Stop::Wrong("an operand is missing".into()));
        };
        let mut value = self.evaluate(first, indices)?;
        for (operator, part) in operators.iter().zip(rest) {
            let right = self.evaluate(part, indices)?;
            self.spend(match operator {
                '+' | '-' => value.cost_of_sum(&right),
                '/' => value.cost_of_quotient(&right),
                _ => value.cost(&right),
            })?;
            match operator {
                '+' => value.add(1, &right)?,
                '-' => value.add(-1, &right)?,
                '/' => value = value.over(&right)?,
                _ => value = value.times(&right)?,
            }
        }
        Ok(value)
    }

    fn of(&self, head: &Head, parts: &[Expr], indices: &mut Indices) -> Result<Value, Stop> {
        let cosine = matches!(head, Head::Call(name, _) if name == "cos");
        let outside = self.angle.replace(self.angle.get() || cosine);
        let (parts, options) = self.asked(head, parts, indices);
        let values = parts.iter().map(|part| self.evaluate(part, indices));
        let values = values.collect::<Result<Vec<Value>, Stop>>();
        self.angle.set(outside);
        match (head, &values?[..]) {
            (Head::Member(family), positions) => self.name(&member(family, positions)?, indices),
            (Head::Minus, [x]) => x.negated(),
            (Head::Power, [base, exponent]) => {
                let power = base.power(exponent.integer(MAX_INTEGER)?)?;
                self.spend(power.cost(&power))?;
                Ok(power)
            }
            (Head::Call(name, _), values) => {
                self.functions.call(self, (name, values, &options), indices)
            }
            _ => Err(Stop::Wrong("this is no formula".into())),
        }
    }

    /// The arguments and the options of a call. A first argument that names a scheme, and nothing else here, is an option.
    pub fn asked<'e>(
        &self,
        head: &'e Head,
        parts: &'e [Expr],
        indices: &Indices,
    ) -> (&'e [Expr], Options<'e>) {
        let Head::Call(_, options) = head else { return (parts, Cow::default()) };
        let named = parts.split_first().and_then(|(first, rest)| Some((differences(first)?, rest)));
        match named {
            Some((names, rest))
                if names
                    .iter()
                    .any(|name| !is_number(name) && !self.has_meaning(name, indices))
                    && self.functions.has_scheme(&names.join("-")) =>
            {
                let scheme = [("scheme".to_owned(), names.join("-"))];
                (rest, Cow::Owned([&options[..], &scheme].concat()))
            }
            _ => (parts, Cow::Borrowed(options)),
        }
    }

    /// Whether a name that is no index means nothing.
    pub fn is_unknown(&self, name: &str) -> bool {
        !self.has_meaning(name, &Indices::new())
    }

    /// Whether a name means something other than a scheme.
    fn has_meaning(&self, name: &str, indices: &Indices) -> bool {
        indices.iter().any(|(index, _)| index == name)
            || self.values.contains_key(name)
            || self.unstated.contains(name)
            || self.beyond.contains_key(name)
            || self.definitions.contains_key(name)
            || self.reserved.contains(&name)
            || name == "pi"
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
        if let Some(stop) = self.beyond.get(name) {
            return Err(stop.clone());
        }
        let definition = self.definitions.get(name);
        let definition = definition.ok_or_else(|| Stop::Wrong(format!("`{name}` is unknown")))?;
        let scheme = self.scheme.as_ref().map(|scheme| Rc::as_ptr(scheme).cast());
        let scheme = scheme.or(self.lattice.as_ref().map(|mask| Rc::as_ptr(mask).cast()));
        let occurring = self.occurring(name, definition, indices);
        let key = (name.to_owned(), occurring, scheme, self.ring.clone());
        if let Some(known) = self.memory.values.borrow().get(&key) {
            return Ok(known.clone());
        }
        let angle = self.angle.replace(false);
        let value = self.evaluate(definition, indices);
        self.angle.set(angle);
        if let Ok(value) = &value {
            self.memory.values.borrow_mut().insert(key, value.clone());
        }
        value
    }

    /// The names and indices with values that occur in a definition or in those that it leads to.
    fn occurring(&self, name: &str, definition: &Expr, indices: &Indices) -> Indices {
        let mut names = self.memory.names.borrow_mut();
        let names = names.entry(name.to_owned());
        let names = names.or_insert_with(|| names_in(definition, self.definitions));
        let values = self.values.iter().filter(|(name, _)| names.contains(family_of(name)));
        let values = values.map(|(name, value)| (name.clone(), value.clone()));
        values.chain(indices.iter().filter(|(name, _)| names.contains(name)).cloned()).collect()
    }

    fn over(
        &self,
        fold: &str,
        index: &str,
        parts: &[Expr],
        indices: &mut Indices,
    ) -> Result<Value, Stop> {
        let [from, to, body] = range(parts)?;
        self.index(index)?;
        let from = self.evaluate(from, indices)?.integer(MAX_INTEGER)?;
        let to = self.evaluate(to, indices)?.integer(MAX_INTEGER)?;
        let range = Range { index, ends: [from, to], others: indices, value: Value::int };
        range.total(
            of_nothing(fold).map(Value::int),
            |indices| self.evaluate(body, indices),
            |total, term| self.join(fold, total, term),
        )
    }

    /// Checks that an index does not hide a name to which definitions may refer.
    pub fn index(&self, name: &str) -> Result<(), Stop> {
        let valued = self.values.contains_key(name) && !self.hidden.contains(name);
        let named = self.definitions.contains_key(name)
            || self.unstated.contains(name)
            || self.beyond.contains_key(name);
        if valued || named || name == "pi" || self.reserved.contains(&name) {
            return Err(Stop::Wrong(format!("the index `{name}` has another meaning")));
        }
        Ok(())
    }

    /// The `sum`, `product`, `max` or `min` of two values.
    pub fn join(&self, fold: &str, a: &Value, b: &Value) -> Result<Value, Stop> {
        match fold {
            "sum" => {
                self.spend(a.cost_of_sum(b))?;
                a.plus(1, b)
            }
            "product" => {
                // Fractions need their common divisors, and irrational numbers their coordinates.
                self.spend(a.steps(b).saturating_add(a.cost_of_sum(b)))?;
                a.times(b)
            }
            "max" => a.max(b, self.piece.as_ref()),
            _ => a.negated()?.max(&b.negated()?, self.piece.as_ref())?.negated(),
        }
    }
}

fn is_number(part: &str) -> bool {
    part.starts_with(|c: char| c.is_ascii_digit())
}

/// The family `q` of a member `q[3]`, or the whole of another name.
fn family_of(name: &str) -> &str {
    name.split_once('[').map_or(name, |(family, _)| family)
}

/// The name of a member of a family.
pub fn member(family: &str, positions: &[Value]) -> Result<String, Stop> {
    let positions = positions.iter().map(|i| Ok(i.integer(MAX_INTEGER)?.to_string()));
    Ok(format!("{family}[{}]", positions.collect::<Result<Vec<_>, Stop>>()?.join(",")))
}
