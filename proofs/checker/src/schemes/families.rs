//! The family of schemes that a reference names while an index has all integers from one on.

#![warn(clippy::arithmetic_side_effects)]

use super::factors::{Factoring, open};
use super::family::{Every, Factor, Family};
use super::lattice::is_lattice;
use super::library::{Entry, Library, is_filter};
use super::scheme::{MAX_ARITY, Scheme};
use super::symbol::{Expansion, Z};
use crate::formulas::{Indices, Scope, formula, formulas};
use crate::numbers::{Integers, Value, at, int};
use crate::text::{Stop, Toml};
use std::cell::{Cell, OnceCell};
use std::collections::BTreeMap;
use std::rc::Rc;

const HERE: Stop = Stop::Family("there is more than one such index, a symbol or a sign ≈");
const NO_SYMBOL: Stop = Stop::Family("the scheme is not given by one symbol");
const PARAMETER: Stop = Stop::Family("a parameter is no rational polynomial in the index");
const OTHER: Stop = Stop::Family("another scheme in the symbol depends on the index");
const ENDS: Stop = Stop::Family("the ends of a factor may be 0");
const TERM: Stop = Stop::Family("the coefficient of a factor of one term is no number");
const SUM: Stop = Stop::Family("the sum of a factor is no number other than 0");
const ARITY: Stop = Stop::Family("the sum of the symbol is not one arity for all values");

impl<'a> Library<'a> {
    /// The schemes that a reference names, if one of them depends on an index with all values.
    pub fn depending(
        &self,
        reference: &str,
        scope: &Scope<'_>,
    ) -> Result<Option<Vec<Entry<'a>>>, Stop> {
        let Some(every) = &scope.every else { return Ok(None) };
        let entries = self.follow(reference, (scope, &mut Indices::new()), 0)?;
        let depends =
            |(_, _, parameters): &Entry<'_>| parameters.values().any(|value| every.concerns(value));
        Ok(entries.iter().any(depends).then_some(entries))
    }

    /// The family of these schemes, of which there has to be one.
    pub fn family(&self, entries: Vec<Entry<'a>>, every: &Every) -> Result<Family, Stop> {
        let ([integers], true) = (&every.indices[..], every.families) else { return Err(HERE) };
        let one: Result<[Entry<'a>; 1], _> = entries.try_into();
        let [(name, table, given)] = one.map_err(|_| NO_SYMBOL)?;
        let parameters = self.complete(name, table, given);
        let parameters = parameters.map_err(|stop| open(stop, PARAMETER))?;
        if !parameters.values().all(|value| integers.has(value)) {
            return Err(PARAMETER);
        }
        let definitions = formulas(table.entries("let"))?;
        let mut scope = self.scope(&definitions);
        scope.values.clone_from(&parameters);
        // Functions within the symbol are of schemes that do not depend on the index.
        scope.every = Some(Every { indices: every.indices.clone(), families: false, family: None });
        let factors = self.factors((name, table), &scope, integers)?;
        let arity = arity(&scope, &factors)?;
        if let Some(stated) = table.text("arity")
            && scope.value(&formula(stated)?).map_err(|stop| open(stop, ARITY))?
                != Value::int(arity)
        {
            return Err(ARITY);
        }
        let arity = usize::try_from(arity).map_err(|_| ARITY)?;
        let of = (name.to_owned(), parameters);
        let integers = integers.clone();
        Ok(Family { integers, arity, factors, of, sum_rules: OnceCell::new() })
    }

    /// The factors of the symbol of a table.
    fn factors(
        &self,
        (name, table): (&str, &Toml),
        scope: &Scope<'_>,
        integers: &Integers,
    ) -> Result<Vec<Factor>, Stop> {
        let others = ["mask", "width", "entry", "offset", "orbits", "use"];
        let symbol = table.text("symbol").ok_or(NO_SYMBOL)?;
        if is_lattice(table)
            || is_filter(name, table)?
            || others.iter().any(|key| table.get(key).is_some())
        {
            return Err(NO_SYMBOL);
        }
        let longest = Cell::new(0);
        let depends = |value: &Value| !integers.has(value) || value.number().is_err();
        let other = |other: &str, with: Indices| {
            if with.iter().any(|(_, value)| depends(value)) {
                return Err(OTHER);
            }
            self.other((name, other), with, &longest, &|reference, scope| {
                self.curve(reference, scope)
            })
        };
        let expansion = Expansion { scope, variables: &Z, others: &other };
        let factors = Factoring { expansion, integers }.of(&formula(symbol)?, 0)?;
        for factor in &factors {
            self.check(factor, integers)?;
        }
        Ok(factors)
    }

    /// Checks what has to be so of each factor.
    fn check(&self, factor: &Factor, integers: &Integers) -> Result<(), Stop> {
        let ends = [factor.terms.values().next(), factor.terms.values().next_back()];
        for end in ends {
            if !integers.never_zero(self.meter, end.ok_or(ENDS)?)? {
                return Err(ENDS);
            }
        }
        let sum = factor.at_one()?;
        if sum.number().is_err() || sum.is_zero() {
            return Err(if factor.has_several() { SUM } else { TERM });
        }
        Ok(())
    }

    /// The scheme of a family for one value of the index.
    pub fn member(&self, family: &Family, t: i64) -> Result<Rc<Scheme>, Stop> {
        let (name, table, parameters) = self.of_ring(&family.of).ok_or(NO_SYMBOL)?;
        let value = |(parameter, value): (String, Value)| {
            let polynomial = value.univariate(&family.integers.index).ok_or(PARAMETER)?;
            Ok((parameter, at(&polynomial, &int(t)).into()))
        };
        let parameters =
            parameters.into_iter().map(value).collect::<Result<BTreeMap<String, Value>, Stop>>()?;
        self.scheme(name, table, parameters)
    }
}

/// n = Π f(1)^β, where Π f(1)^α is 1.
fn arity(scope: &Scope<'_>, factors: &[Factor]) -> Result<i64, Stop> {
    let product = |exponent: fn(&Factor) -> i64| {
        factors.iter().try_fold(Value::int(1), |product, factor| {
            let base = factor.at_one()?;
            if base == Value::int(1) {
                return Ok(product);
            }
            let power = base.power(exponent(factor))?;
            scope.spend(power.cost(&power))?;
            scope.join("product", &product, &power)
        })
    };
    if product(|factor| factor.slope)? != Value::int(1) {
        return Err(ARITY);
    }
    let n = product(|factor| factor.constant)?;
    let most = i64::from(MAX_ARITY);
    n.integer(most).ok().filter(|n| (2..=most).contains(n)).ok_or(ARITY)
}
