//! Schemes: their masks, and the sequences that they give.

use crate::evaluate::{MAX_STEPS, Scope};
use crate::formula::{Expr, MAX_LENGTH, is_name, parse};
use crate::reading::Reading;
use crate::toml::Toml;
use crate::value::{Stop, Value};
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The most rules of a scheme.
const MAX_ARITY: i64 = 64;

/// The most points of a rule.
const MAX_WIDTH: i64 = 256;

/// How deep names may stand for names.
const MAX_ALIASES: usize = 8;

/// The schemes that every claim file may name: data, not code.
const CATALOGUE: [&str; 13] = [
    include_str!("../../../src/scheme/catalogue/b-spline.toml"),
    include_str!("../../../src/scheme/catalogue/bajaj.toml"),
    include_str!("../../../src/scheme/catalogue/catmull-clark.toml"),
    include_str!("../../../src/scheme/catalogue/chaikin.toml"),
    include_str!("../../../src/scheme/catalogue/doo-sabin.toml"),
    include_str!("../../../src/scheme/catalogue/four-point.toml"),
    include_str!("../../../src/scheme/catalogue/newton.toml"),
    include_str!("../../../src/scheme/catalogue/quaternary-four-point.toml"),
    include_str!("../../../src/scheme/catalogue/quinary-three-point.toml"),
    include_str!("../../../src/scheme/catalogue/six-point.toml"),
    include_str!("../../../src/scheme/catalogue/ternary-four-point.toml"),
    include_str!("../../../src/scheme/catalogue/ternary-four-point-approximating.toml"),
    include_str!("../../../src/scheme/catalogue/ternary-three-point.toml"),
];

/// A mask with its difference mask.
#[derive(Debug)]
pub struct Scheme {
    /// a_{α,j}: a row for each rule α.
    pub mask: Vec<Vec<Value>>,
    /// b_{β,j}.
    pub difference: Vec<Vec<Value>>,
    /// o.
    pub offset: i64,
    /// Convolutions of its sequences that are known already, by what they are of.
    pub known: RefCell<BTreeMap<String, Rc<Vec<Value>>>>,
}

/// The schemes of a claim file and of the catalogue.
pub struct Library<'a> {
    file: &'a [Toml],
    catalogue: &'a [Toml],
    masks: RefCell<BTreeMap<String, Rc<Scheme>>>,
    steps: Cell<u64>,
    /// No named formulas.
    pub nothing: BTreeMap<String, Rc<Expr>>,
    /// The reading of formulas of schemes.
    pub as_printed: Reading,
}

/// The files of the catalogue, read.
pub fn catalogue() -> Result<Vec<Toml>, String> {
    CATALOGUE.iter().map(|text| Toml::read(text)).collect()
}

/// A formula of a file.
pub fn formula(text: &str) -> Result<Expr, Stop> {
    parse(text, MAX_LENGTH).map_err(Stop::Wrong)
}

/// Named formulas of a file.
pub fn formulas(entries: &[(String, Toml)]) -> Result<BTreeMap<String, Rc<Expr>>, Stop> {
    let read = |(name, text): &(String, Toml)| {
        let text = text.as_text().filter(|_| is_name(name) && name != "pi");
        let text = text.ok_or_else(|| Stop::Wrong(format!("`{name}` is no named formula")))?;
        Ok((name.clone(), Rc::new(formula(text)?)))
    };
    entries.iter().map(read).collect()
}

impl<'a> Library<'a> {
    /// The library of a claim file's `[[scheme]]` tables.
    pub fn new(file: &'a [Toml], catalogue: &'a [Toml]) -> Library<'a> {
        let (masks, steps, nothing, as_printed) = Default::default();
        Library { file, catalogue, masks, steps, nothing, as_printed }
    }

    /// Counts steps of the claim at hand.
    pub fn spend(&self, steps: u64) -> Result<(), Stop> {
        self.steps.set(self.steps.get().saturating_add(steps));
        if self.steps.get() > MAX_STEPS {
            Err(Stop::Capped("the steps of a claim"))
        } else {
            Ok(())
        }
    }

    /// Begins another claim.
    pub fn restart(&self) {
        self.steps.set(0);
    }

    /// The schemes of a reference such as `six-point:w=w`, one for each factor of a tensor
    /// product; parameters are evaluated in the scope.
    pub fn resolve(&'a self, reference: &str, scope: &Scope<'_>) -> Result<Vec<Rc<Scheme>>, Stop> {
        self.follow(reference, scope, 0)
    }

    fn follow(
        &'a self,
        reference: &str,
        scope: &Scope<'_>,
        depth: usize,
    ) -> Result<Vec<Rc<Scheme>>, Stop> {
        let wrong = |what: &str| Stop::Wrong(format!("`{reference}`: {what}"));
        let mut schemes = Vec::new();
        let factors: Vec<&str> = reference.split(" x ").collect();
        if factors.len() > 2 || depth > MAX_ALIASES {
            return Err(wrong("more than two factors, or names for names for names"));
        }
        for factor in factors {
            let (name, table, parameters) = self.entry(factor, scope)?;
            match table.text("use") {
                Some(_) if !parameters.is_empty() => return Err(wrong("it has no parameters")),
                Some(other) => schemes.extend(self.follow(other, scope, depth + 1)?),
                None => schemes.push(self.scheme(name, table, parameters)?),
            }
        }
        Ok(schemes)
    }

    /// Whether a reference names a ring.
    pub fn is_ring(&self, reference: &str) -> bool {
        let name = reference.split(':').next().map(str::trim);
        let mut tables = self.file.iter().chain(self.catalogue);
        let table = tables.find(|table| table.text("name") == name);
        table.is_some_and(|table| table.get("orbits").is_some())
    }

    /// The table of the scheme that a reference names, with its parameters.
    pub fn entry<'r>(
        &'a self,
        reference: &'r str,
        scope: &Scope<'_>,
    ) -> Result<(&'r str, &'a Toml, BTreeMap<String, Value>), Stop> {
        let wrong = |what: &str| Stop::Wrong(format!("`{reference}`: {what}"));
        let (name, arguments) = reference.trim().split_once(':').unwrap_or((reference.trim(), ""));
        let mut parameters = BTreeMap::new();
        for argument in arguments_of(arguments) {
            let (parameter, value) =
                argument.split_once('=').ok_or_else(|| wrong("a parameter is name=value"))?;
            let value = scope.value(&formula(value.trim())?)?;
            if parameters.insert(parameter.trim().to_owned(), value).is_some() {
                return Err(wrong("a parameter is given twice"));
            }
        }
        let named = |table: &&Toml| table.text("name") == Some(name);
        let table = self.file.iter().chain(self.catalogue).find(named);
        Ok((name, table.ok_or_else(|| wrong("there is no such scheme"))?, parameters))
    }

    /// The parameters of a scheme, those without a value at their defaults.
    pub fn complete(
        &'a self,
        name: &str,
        table: &Toml,
        mut parameters: BTreeMap<String, Value>,
    ) -> Result<BTreeMap<String, Value>, Stop> {
        let wrong = |what: &str| Stop::Wrong(format!("scheme `{name}`: {what}"));
        let known: Vec<&String> = table.entries("parameters").iter().map(|(key, _)| key).collect();
        if parameters.keys().any(|parameter| !known.contains(&parameter)) {
            return Err(wrong("it has no such parameter"));
        }
        for (parameter, about) in table.entries("parameters") {
            if !parameters.contains_key(parameter) {
                let default =
                    about.text("default").ok_or_else(|| wrong("a parameter is missing"))?;
                let scope = Scope::new(&self.nothing, self, &self.as_printed);
                let value = scope.value(&formula(default)?)?;
                parameters.insert(parameter.clone(), value);
            }
        }
        Ok(parameters)
    }

    fn scheme(
        &'a self,
        name: &str,
        table: &Toml,
        parameters: BTreeMap<String, Value>,
    ) -> Result<Rc<Scheme>, Stop> {
        let wrong = |what: &str| Stop::Wrong(format!("scheme `{name}`: {what}"));
        let parameters = self.complete(name, table, parameters)?;
        let key = format!("{name} {parameters:?}");
        if let Some(known) = self.masks.borrow().get(&key) {
            return Ok(Rc::clone(known));
        }
        let definitions = formulas(table.entries("let"))?;
        let mut scope = Scope::new(&definitions, self, &self.as_printed);
        scope.values = parameters;
        let integer = |key: &str, limit: i64| {
            let text = table.text(key).ok_or_else(|| wrong("`mask` or `entry` is missing"))?;
            scope.value(&formula(text)?)?.integer(limit)
        };
        let offset = if table.get("offset").is_some() { integer("offset", 10_000)? } else { 0 };
        let mut mask: Vec<Vec<Value>> = Vec::new();
        if let Some(Toml::List(rows)) = table.get("mask") {
            for row in rows {
                let Toml::List(row) = row else { return Err(wrong("a rule is a list")) };
                let entry = |entry: &Toml| scope.value(&formula(entry.as_text().unwrap_or(""))?);
                mask.push(row.iter().map(entry).collect::<Result<_, _>>()?);
            }
        } else {
            let (arity, width) = (integer("arity", MAX_ARITY)?, integer("width", MAX_WIDTH)?);
            let entry = formula(table.text("entry").ok_or_else(|| wrong("`entry` is missing"))?)?;
            for alpha in 0..arity {
                let at = |r| {
                    let indices = [("alpha", alpha), ("r", r)];
                    let indices = indices.map(|(name, i)| (name.to_owned(), Value::int(i)));
                    scope.evaluate(&entry, &mut indices.to_vec())
                };
                mask.push((0..width).map(at).collect::<Result<_, _>>()?);
            }
        }
        let scheme = Rc::new(Scheme::new(mask, offset)?);
        self.masks.borrow_mut().insert(key, Rc::clone(&scheme));
        Ok(scheme)
    }
}

impl Scheme {
    fn new(mask: Vec<Vec<Value>>, offset: i64) -> Result<Scheme, Stop> {
        let width = mask.first().map_or(0, Vec::len);
        let even = mask.iter().all(|row| row.len() == width);
        let fits = |count: usize, cap: i64| i64::try_from(count).is_ok_and(|count| count <= cap);
        let small = fits(mask.len(), MAX_ARITY) && fits(width, MAX_WIDTH);
        if mask.len() < 2 || width == 0 || !even || !small {
            return Err(Stop::Wrong("the rules of a scheme are two or more, equally long".into()));
        }
        for row in &mask {
            let sum = total(row)?;
            if !sum.plus(-1, &Value::int(1))?.is_zero() {
                return Err(Stop::Wrong("a rule does not sum to 1".into()));
            }
        }
        let mut difference: Vec<Vec<Value>> = Vec::new();
        for pair in mask.windows(2) {
            // b_{β,j} = Σ_{h≤j} (a_{β,h} − a_{β+1,h})
            let (mut sum, mut row) = (Value::int(0), Vec::new());
            for (this, next) in pair[0].iter().zip(&pair[1]) {
                sum = sum.plus(1, this)?.plus(-1, next)?;
                row.push(sum.clone());
            }
            difference.push(row);
        }
        // b_{n−1,j} = a_{0,j} − Σ_{β<n−1} b_{β,j}
        let mut last = mask[0].clone();
        for row in &difference {
            for (rest, b) in last.iter_mut().zip(row) {
                *rest = rest.plus(-1, b)?;
            }
        }
        difference.push(last);
        Ok(Scheme { mask, difference, offset, known: RefCell::default() })
    }

    /// n.
    pub fn arity(&self) -> usize {
        self.mask.len()
    }

    /// N.
    pub fn width(&self) -> usize {
        self.mask[0].len()
    }
}

/// The sum of values.
pub fn total<'v>(values: impl IntoIterator<Item = &'v Value>) -> Result<Value, Stop> {
    values.into_iter().try_fold(Value::int(0), |sum, value| sum.plus(1, value))
}

/// The pieces between commas outside of parentheses; blank ones are left out.
fn arguments_of(text: &str) -> Vec<&str> {
    let mut depth = 0_i64;
    let pieces = text.split(|c| {
        depth += i64::from(c == '(') - i64::from(c == ')');
        c == ',' && depth <= 0
    });
    pieces.filter(|piece| !piece.trim().is_empty()).collect()
}
