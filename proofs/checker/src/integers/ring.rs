//! Rings for all valences from one on: their weights as functions of the valence.

#![warn(clippy::arithmetic_side_effects)]

use super::evaluate::{Claim, Evaluator};
use super::function::{Function, Functions};
use super::pair::{Pair, Turns};
use super::polynomial::{COSINE, H, PLACE, Polynomial, T};
use super::shift::{INDICES, Shifts};
use crate::formulas::{Expr, Scope, formula, formulas, names};
use crate::numbers::{Q, int};
use crate::schemes::Named;
use crate::text::{Stop, Toml};
use num_traits::Zero as _;
use std::collections::BTreeMap;

/// The greatest distance of places that have weights of their own, and the greatest degree of the others.
pub const NEAR: i64 = 6;

/// The most orbits.
const MAX_ORBITS: usize = 12;

const ORBIT: Stop = Stop::Integers("an orbit has neither one point nor as many as the valence");
const TEXT: Stop =
    Stop::Integers("a weight does not depend on the difference of the indices by its text");
const ROUND: Stop = Stop::Integers("a weight is another one a full turn later");
const FAR: Stop = Stop::Integers("the weights far away are no polynomial in a cosine");
const ROWS: Stop = Stop::Integers("the weights of a point are not shown to sum to 1");

/// The weights between two orbits.
enum Weight {
    /// One of these orbits has one point.
    Once(Function),
    /// Both have as many points as the valence: the m_d − w(2πd/t) for d = −6, …, 6, and the b_r, of which b_r cos(rx) is in w(x).
    Turning(Vec<(i64, Function)>, Vec<Function>),
}

/// A ring.
pub struct Ring {
    /// The names of the orbits, and whether they have as many points as the valence.
    pub orbits: Vec<(String, bool)>,
    weights: Vec<Vec<Weight>>,
}

fn wrong<T>(what: &str) -> Result<T, Stop> {
    Err(Stop::Wrong(format!("a ring: {what}")))
}

impl Ring {
    /// The ring that a reference names, whose valence is the integer of the claim.
    pub fn new(evaluator: &Evaluator<'_>, reference: &str) -> Result<Ring, Stop> {
        let named = |scope, claim| {
            let with = (evaluator.functions, evaluator.library);
            Evaluator::new(with, scope, claim, evaluator.depth)
        };
        let claim = evaluator.claim.map(|claim| Claim { own: None, ..claim });
        let evaluate = |expr: &Expr, values: &mut Vec<(String, Function)>| {
            let mut inner = named(evaluator.scope, claim);
            inner.values = values.iter().cloned().collect();
            inner.value(expr)
        };
        let definitions = evaluator.scope.definitions;
        let library = evaluator.library;
        let entries = library.follow_as(reference, (definitions, &evaluate), &mut Vec::new(), 0)?;
        let entries: Result<[Named<'_, Function>; 1], _> = entries.try_into();
        let Ok([(_, table, given)]) = entries else { return wrong("it is a tensor product") };
        if table.get("orbits").is_none() {
            return wrong("there are no orbits");
        }
        let closed = library.closed();
        let mut defaults = named(&closed, None);
        let parameters = complete(table, given, &mut defaults)?;
        let definitions = formulas(table.entries("let"))?;
        let hidden = |name: &String| parameters.contains_key(name) || is_index(name);
        if definitions.keys().any(hidden) || parameters.keys().any(|name| is_index(name)) {
            return wrong("a name has two meanings");
        }
        let scope = library.scope(&definitions);
        let mut inner = named(&scope, None);
        inner.values = parameters;
        let ring = Ring::read(table, &inner)?;
        ring.sums_to_one(evaluator.functions)?;
        Ok(ring)
    }

    fn read(table: &Toml, evaluator: &Evaluator<'_>) -> Result<Ring, Stop> {
        let mut orbits = Vec::new();
        for (name, count) in table.entries("orbits") {
            let count = evaluator.value(&formula(count.as_text().unwrap_or_default())?)?;
            let count = count.polynomial().ok_or(ORBIT)?;
            if count != Polynomial::int(1) && count != Polynomial::variable(T) {
                return Err(ORBIT);
            }
            orbits.push((name.clone(), count != Polynomial::int(1)));
        }
        if orbits.len() > MAX_ORBITS {
            return Err(Stop::Capped("the orbits of a ring"));
        }
        let nothing = Toml::Table(Vec::new());
        let of_new = table.get("weights").unwrap_or(&nothing);
        let mut weights = Vec::new();
        for (new, turns) in &orbits {
            let mut row = Vec::new();
            for (old, others) in &orbits {
                let text = of_new.get(new).and_then(|of_old| of_old.text(old));
                row.push(match text {
                    None => Weight::Once(Function::default()),
                    Some(text) if *turns && *others => turning(evaluator, &formula(text)?)?,
                    Some(text) => Weight::Once(once(evaluator, &formula(text)?)?),
                });
            }
            weights.push(row);
        }
        Ok(Ring { orbits, weights })
    }

    /// M_0.
    pub fn still(&self, functions: &Functions<'_>) -> Result<Vec<Vec<Pair>>, Stop> {
        let t = Polynomial::variable(T).into();
        let mut matrix = Vec::new();
        for (weights, (_, new)) in self.weights.iter().zip(&self.orbits) {
            let mut row = Vec::new();
            for (weight, (_, old)) in weights.iter().zip(&self.orbits) {
                let entry = match weight {
                    Weight::Once(value) if *old && !*new => functions.product(value, &t)?,
                    Weight::Once(value) => value.clone(),
                    Weight::Turning(near, far) => {
                        let none = Function::default();
                        let mut sum = functions.product(far.first().unwrap_or(&none), &t)?;
                        for (_, value) in near {
                            sum = functions.sum(&sum, 1, value)?;
                        }
                        sum
                    }
                };
                row.push(entry.into());
            }
            matrix.push(row);
        }
        Ok(matrix)
    }

    /// M_k for an e^{2πik/t} with this cosine; k is 0 where it is greater than 6.
    pub fn turning(&self, turns: &Turns<'_>, k: usize) -> Result<Vec<Vec<Pair>>, Stop> {
        let functions = turns.functions;
        let t = Polynomial::variable(T).into();
        let own = |orbit: &(String, bool)| orbit.1;
        let rows = self.weights.iter().zip(&self.orbits).filter(|(_, orbit)| own(orbit));
        let mut matrix = Vec::new();
        for (weights, _) in rows {
            let mut row = Vec::new();
            let others = weights.iter().zip(&self.orbits).filter(|(_, orbit)| own(orbit));
            for (weight, _) in others {
                let mut sum = Pair::default();
                if let Weight::Turning(near, far) = weight {
                    for (d, value) in near {
                        let term = turns.scaled(&turns.power(*d)?, value)?;
                        sum = turns.sum(&sum, &term)?;
                    }
                    if let Some(value) = far.get(k).filter(|_| k > 0) {
                        let half = functions.scaled(value, &Q::new(1.into(), 2.into()))?;
                        sum = turns.sum(&sum, &functions.product(&half, &t)?.into())?;
                    }
                }
                row.push(sum);
            }
            matrix.push(row);
        }
        Ok(matrix)
    }

    /// Checks that the rows of M_0 sum to 1.
    fn sums_to_one(&self, functions: &Functions<'_>) -> Result<(), Stop> {
        for row in self.still(functions)? {
            let mut sum = Function::int(-1);
            for entry in row {
                sum = functions.sum(&sum, 1, &entry.real)?;
            }
            if !functions.is_zero(&sum)? {
                return Err(ROWS);
            }
        }
        Ok(())
    }
}

fn is_index(name: &str) -> bool {
    INDICES.contains(&name)
}

/// The parameters of a ring. The valence is the value of `N`, or else `n`, that has none; missing ones have their defaults.
fn complete(
    table: &Toml,
    mut given: BTreeMap<String, Function>,
    defaults: &mut Evaluator<'_>,
) -> Result<BTreeMap<String, Function>, Stop> {
    let known = table.entries("parameters");
    let is_open =
        |name: &&str| known.iter().any(|(known, _)| known == name) && !given.contains_key(*name);
    let Some(open) = ["N", "n"].into_iter().find(is_open) else {
        return wrong("no parameter is its valence");
    };
    given.insert(open.to_owned(), Polynomial::variable(T).into());
    if given.keys().any(|name| known.iter().all(|(known, _)| known != name)) {
        return wrong("it has no such parameter");
    }
    defaults.values.clone_from(&given);
    for (name, about) in known {
        if !given.contains_key(name) {
            let Some(default) = about.text("default") else {
                return wrong("a parameter is missing");
            };
            given.insert(name.clone(), defaults.value(&formula(default)?)?);
        }
    }
    Ok(given)
}

/// A weight from or to an orbit of one point.
fn once(evaluator: &Evaluator<'_>, expr: &Expr) -> Result<Function, Stop> {
    let names = names(expr, evaluator.scope.definitions);
    if INDICES.iter().any(|index| names.contains(*index)) {
        return Err(TEXT);
    }
    evaluator.value(expr)
}

/// The weights between two orbits of as many points as the valence.
fn turning(evaluator: &Evaluator<'_>, expr: &Expr) -> Result<Weight, Stop> {
    let functions = evaluator.functions;
    let meter = functions.meter();
    let scope: &Scope<'_> = evaluator.scope;
    let shifts = Shifts { meter, definitions: scope.definitions };
    if !shifts.of(expr, 0)?.is_some_and(|shift| shift.is_zero()) {
        return Err(TEXT);
    }
    let at = |i: &Function, j: &Function| {
        let with = (functions, evaluator.library);
        let mut inner = Evaluator::new(with, scope, None, evaluator.depth);
        inner.values.clone_from(&evaluator.values);
        for (name, value) in INDICES.into_iter().zip([i, j]) {
            inner.values.insert(name.to_owned(), value.clone());
        }
        inner.value(expr)
    };
    let (t, zero) = (Function::from(Polynomial::variable(T)), Function::default());
    // The values at (0, d) and at (t − d, 0), which have to be the same.
    let both = |d: &Function| {
        let around = functions.sum(&t, -1, d)?;
        let (one, other) = (at(&zero, d)?, at(&around, &zero)?);
        let differ = functions.sum(&one, -1, &other)?;
        if functions.is_zero(&differ)? { Ok(one) } else { Err(ROUND) }
    };
    let far = both(&Polynomial::variable(PLACE).into())?;
    if far.degree(PLACE) > 0 || i64::from(far.degree(COSINE)) > NEAR {
        return Err(FAR);
    }
    let mut near = Vec::new();
    for d in -NEAR..=NEAR {
        let place = Function::int(d);
        let own = match d {
            0 => at(&zero, &zero)?,
            1.. => both(&place)?,
            // (0, t − d) and (d, 0).
            _ => both(&functions.sum(&t, 1, &place)?)?,
        };
        let twice = d.unsigned_abs().saturating_mul(2);
        let cosine = Polynomial::chebyshev(meter, twice, &Polynomial::variable(H))?;
        let rest = functions.sum(&own, -1, &functions.with(&far, COSINE, &cosine)?)?;
        near.push((d, rest));
    }
    Ok(Weight::Turning(near, cosines(functions, &far)?))
}

/// The b_r of Σ b_r T_r(g), where the g are those of the function.
fn cosines(functions: &Functions<'_>, far: &Function) -> Result<Vec<Function>, Stop> {
    let half = Q::new(1.into(), 2.into());
    let mut sums: Vec<Function> = Vec::new();
    for c in far.coefficients(COSINE).into_iter().rev() {
        // g·T_0 = T_1, and g·T_r = (T_{r+1} + T_{r−1})/2.
        let mut next = vec![Function::default(); sums.len().saturating_add(1)];
        for (r, value) in sums.iter().enumerate() {
            let factor = if r == 0 { int(1) } else { half.clone() };
            let part = functions.scaled(value, &factor)?;
            for place in [Some(r.saturating_add(1)), r.checked_sub(1)].into_iter().flatten() {
                if let Some(sum) = next.get_mut(place) {
                    *sum = functions.sum(sum, 1, &part)?;
                }
            }
        }
        if let Some(first) = next.first_mut() {
            *first = functions.sum(first, 1, &c)?;
        }
        sums = next;
    }
    Ok(sums)
}
