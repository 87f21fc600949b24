//! Schemes: their masks, and the sequences that they give.

use crate::convolution::{Large, OfSchemes, Products};
use crate::evaluate::{MAX_STEPS, Scope};
use crate::formula::{Expr, MAX_LENGTH, is_name, parse};
use crate::paper::Definitions;
use crate::reading::Reading;
use crate::reject::Stop;
use crate::toml::Toml;
use crate::value::Value;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;

/// The most rules of a scheme.
const MAX_ARITY: usize = 64;

/// The most points of a rule.
const MAX_WIDTH: usize = 256;

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
pub struct Scheme {
    /// a_{α,j}: a row for each rule α.
    pub mask: Vec<Vec<Value>>,
    /// b_{β,j}.
    pub difference: Vec<Vec<Value>>,
    /// o.
    pub offset: i64,
}

/// The schemes of a claim file and of the catalogue.
pub struct Library<'a> {
    file: &'a [Toml],
    catalogue: &'a [Toml],
    masks: RefCell<BTreeMap<String, Rc<Scheme>>>,
    /// Products of sequences that are known already, by what they are of.
    pub products: RefCell<Products>,
    /// Those of schemes.
    pub of_schemes: RefCell<OfSchemes>,
    /// Constants of more residue classes than can be looked at.
    pub large: RefCell<HashMap<Large, Value>>,
    steps: Cell<u64>,
    /// No named formulas.
    pub nothing: Definitions,
    /// The reading of formulas of schemes.
    pub as_printed: Reading,
}

/// The files of the catalogue, read.
pub fn catalogue() -> Result<Vec<Toml>, String> {
    CATALOGUE.iter().map(|text| Toml::read(text)).collect()
}

fn wrong<T>(of: &str, what: &str) -> Result<T, Stop> {
    Err(Stop::Wrong(format!("`{of}`: {what}")))
}

/// A formula of a file.
pub fn formula(text: &str) -> Result<Expr, Stop> {
    parse(text, MAX_LENGTH).map_err(Stop::Wrong)
}

/// Named formulas of a file.
pub fn formulas(entries: &[(String, Toml)]) -> Result<Definitions, Stop> {
    let read = |(name, text): &(String, Toml)| match text.as_text() {
        Some(text) if is_name(name) && name != "pi" => Ok((name.clone(), Rc::new(formula(text)?))),
        _ => wrong(name, "no named formula"),
    };
    entries.iter().map(read).collect()
}

impl<'a> Library<'a> {
    /// The library of a claim file's `[[scheme]]` tables.
    pub fn new(file: &'a [Toml], catalogue: &'a [Toml]) -> Library<'a> {
        let (masks, products, of_schemes, large) = Default::default();
        let (steps, nothing, as_printed) = Default::default();
        Library { file, catalogue, masks, products, of_schemes, large, steps, nothing, as_printed }
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

    /// Begins another claim, for which nothing is known: what it costs does not depend on others.
    pub fn restart(&self) {
        self.steps.set(0);
        self.masks.borrow_mut().clear();
        self.products.borrow_mut().clear();
        self.of_schemes.borrow_mut().clear();
        self.large.borrow_mut().clear();
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
        let mut schemes = Vec::new();
        let factors: Vec<&str> = reference.split(" x ").collect();
        if factors.len() > 2 || depth > MAX_ALIASES {
            return wrong(reference, "more than two factors, or names for names for names");
        }
        for factor in factors {
            let (name, table, parameters) = self.entry(factor, scope)?;
            match table.text("use") {
                Some(_) if !parameters.is_empty() => {
                    return wrong(reference, "it has no parameters");
                }
                Some(other) => schemes.extend(self.follow(other, scope, depth + 1)?),
                None => schemes.push(self.scheme(name, table, parameters)?),
            }
        }
        Ok(schemes)
    }

    fn named(&self, name: &str) -> Option<&'a Toml> {
        let mut tables = self.file.iter().chain(self.catalogue);
        tables.find(|table| table.text("name") == Some(name))
    }

    /// Whether a reference names a ring.
    pub fn is_ring(&self, reference: &str) -> bool {
        let (name, _) = reference.split_once(':').unwrap_or((reference, ""));
        self.named(name.trim()).is_some_and(|table| table.get("orbits").is_some())
    }

    /// The table of the scheme that a reference names, with its parameters.
    pub fn entry<'r>(
        &'a self,
        reference: &'r str,
        scope: &Scope<'_>,
    ) -> Result<(&'r str, &'a Toml, BTreeMap<String, Value>), Stop> {
        let (name, arguments) = reference.trim().split_once(':').unwrap_or((reference.trim(), ""));
        let mut parameters = BTreeMap::new();
        for argument in arguments_of(arguments) {
            let Some((parameter, value)) = argument.split_once('=') else {
                return wrong(reference, "a parameter is name=value");
            };
            let value = scope.value(&formula(value.trim())?)?;
            if parameters.insert(parameter.trim().to_owned(), value).is_some() {
                return wrong(reference, "a parameter is given twice");
            }
        }
        match self.named(name) {
            Some(table) => Ok((name, table, parameters)),
            None => wrong(reference, "there is no such scheme"),
        }
    }

    /// The parameters of a scheme, those without a value at their defaults.
    pub fn complete(
        &'a self,
        name: &str,
        table: &Toml,
        mut parameters: BTreeMap<String, Value>,
    ) -> Result<BTreeMap<String, Value>, Stop> {
        let known = table.entries("parameters");
        if parameters.keys().any(|given| known.iter().all(|(known, _)| known != given)) {
            return wrong(name, "it has no such parameter");
        }
        let nothing = Scope::new(&self.nothing, self, &self.as_printed);
        for (parameter, about) in known {
            if !parameters.contains_key(parameter) {
                let Some(default) = about.text("default") else {
                    return wrong(name, "a parameter is missing");
                };
                parameters.insert(parameter.clone(), nothing.value(&formula(default)?)?);
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
        let parameters = self.complete(name, table, parameters)?;
        let key = format!("{name} {parameters:?}");
        if let Some(known) = self.masks.borrow().get(&key) {
            return Ok(Rc::clone(known));
        }
        let definitions = formulas(table.entries("let"))?;
        let mut scope = Scope::new(&definitions, self, &self.as_printed);
        scope.values = parameters;
        let integer = |key: &str, most: usize| match table.text(key) {
            Some(text) => scope.value(&formula(text)?)?.integer(i64::try_from(most).unwrap_or(0)),
            None => wrong(name, "`mask` or `entry` is missing"),
        };
        let offset = if table.get("offset").is_some() { integer("offset", 10_000)? } else { 0 };
        let mask: Result<Vec<Vec<Value>>, Stop> = if table.get("mask").is_some() {
            let entry = |entry: &Toml| scope.value(&formula(entry.as_text().unwrap_or(""))?);
            let rows = table.list("mask").iter();
            rows.map(|row| row.as_list().iter().map(entry).collect()).collect()
        } else {
            let (arity, width) = (integer("arity", MAX_ARITY)?, integer("width", MAX_WIDTH)?);
            let entry = formula(table.text("entry").unwrap_or(""))?;
            let at = |alpha, r| {
                let indices = [("alpha", alpha), ("r", r)];
                let indices = indices.map(|(name, i)| (name.to_owned(), Value::int(i)));
                scope.evaluate(&entry, &mut indices.to_vec())
            };
            (0..arity).map(|alpha| (0..width).map(|r| at(alpha, r)).collect()).collect()
        };
        let scheme = Rc::new(Scheme::new(mask?, offset)?);
        self.masks.borrow_mut().insert(key, Rc::clone(&scheme));
        Ok(scheme)
    }
}

impl Scheme {
    fn new(mask: Vec<Vec<Value>>, offset: i64) -> Result<Scheme, Stop> {
        let width = mask.first().map_or(0, Vec::len);
        let even = mask.iter().all(|row| row.len() == width);
        if !(2..=MAX_ARITY).contains(&mask.len()) || !(1..=MAX_WIDTH).contains(&width) || !even {
            return wrong("mask", "the rules of a scheme are two or more, equally long");
        }
        for row in &mask {
            if total(row)? != Value::int(1) {
                return wrong("mask", "a rule does not sum to 1");
            }
        }
        // b_{n−1,j} = a_{0,j} − Σ_{β<n−1} b_{β,j}
        let (mut difference, mut last) = (Vec::new(), mask[0].clone());
        for pair in mask.windows(2) {
            // b_{β,j} = Σ_{h≤j} (a_{β,h} − a_{β+1,h})
            let (mut sum, mut row) = (Value::int(0), Vec::new());
            for (j, rest) in last.iter_mut().enumerate() {
                sum = sum.plus(1, &pair[0][j])?.minus(&pair[1][j])?;
                *rest = rest.minus(&sum)?;
                row.push(sum.clone());
            }
            difference.push(row);
        }
        difference.push(last);
        Ok(Scheme { mask, difference, offset })
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
