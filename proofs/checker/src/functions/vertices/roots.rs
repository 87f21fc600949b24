//! The real roots of a polynomial with their multiplicities, in order.

#![warn(clippy::arithmetic_side_effects)]

use super::places::{DIGITS, Factor, Place, decide};
use super::polynomials::{Polynomial, square_free, without};
use crate::functions::steps::over;
use crate::numbers::{Meter, Value};
use crate::text::Stop;
use std::cmp::Ordering;
use std::rc::Rc;

/// A real root.
#[derive(Clone)]
pub struct Root {
    /// Where it is.
    pub place: Place,
    /// How often it is one.
    pub multiplicity: usize,
}

/// The roots of a polynomial.
pub struct Roots {
    /// The real ones, descending.
    pub real: Vec<Root>,
    /// Factors with others.
    pub complex: Vec<Rc<Factor>>,
}

impl Roots {
    /// Finds the roots of p ≠ 0.
    pub fn new(meter: &Meter, p: &[Value]) -> Result<Roots, Stop> {
        let (mut real, mut complex, mut rest) = (Vec::new(), Vec::new(), p.to_vec());
        for x in [0, 1].map(Value::int) {
            let (multiplicity, quotient) = without(meter, &rest, &x)?;
            if multiplicity > 0 {
                real.push(Root { place: Place::Exact(x), multiplicity });
            }
            rest = quotient;
        }
        for (factor, multiplicity) in factors(meter, rest)? {
            let (exact, factor) = known(meter, factor)?;
            real.extend(exact.into_iter().map(|x| Root { place: Place::Exact(x), multiplicity }));
            let Some(factor) = factor else { continue };
            for index in 1..=factor.real {
                real.push(Root { place: Place::Of(Rc::clone(&factor), index), multiplicity });
            }
            if usize::try_from(factor.real).ok() != factor.p.len().checked_sub(1) {
                complex.push(factor);
            }
        }
        let order = decide(|bits| descending(meter, &real, bits))?;
        let real = order.into_iter().filter_map(|at| real.get(at).cloned()).collect();
        Ok(Roots { real, complex })
    }

    /// The j-th greatest real root, j ≥ 1, each as often as its multiplicity.
    pub fn nth(&self, j: usize) -> Option<&Root> {
        let mut passed = 0_usize;
        self.real.iter().find(|root| {
            passed = passed.saturating_add(root.multiplicity);
            passed >= j
        })
    }
}

/// Factors without multiple roots, with their multiplicities.
fn factors(meter: &Meter, p: Polynomial) -> Result<Vec<(Polynomial, usize)>, Stop> {
    // Most polynomials have no multiple roots, which enclosures show.
    match p.len() {
        0 | 1 => return Ok(Vec::new()),
        2 => return Ok(vec![(p, 1)]),
        _ => {}
    }
    match Factor::sturm(meter, &p, DIGITS[0]) {
        Ok(sturm) if sturm.is_simple() => Ok(vec![(p, 1)]),
        Ok(_) | Err(Stop::Undecided(_)) => square_free(meter, &p),
        Err(stop) => Err(stop),
    }
}

/// The exact roots that are found, and the factor of the others.
fn known(meter: &Meter, p: Polynomial) -> Result<(Vec<Value>, Option<Rc<Factor>>), Stop> {
    if let [constant, leading] = &p[..] {
        return Ok((vec![over(meter, &constant.negated()?, leading)?], None));
    }
    let mut exact = Vec::new();
    let factor = Factor::new(meter, p)?;
    if factor.p.iter().any(|c| c.rational().is_none()) {
        return Ok((exact, Some(Rc::new(factor))));
    }
    let mut rest = factor.p.clone();
    let sturm = Factor::sturm(meter, &factor.p, DIGITS[0])?;
    for index in 1..=factor.real {
        if let Some(x) = sturm.root(index)?.exact() {
            let x = Value::from(x.clone());
            rest = without(meter, &rest, &x)?.1;
            exact.push(x);
        }
    }
    match &rest[..] {
        [] | [_] => return Ok((exact, None)),
        [constant, leading] => {
            exact.push(over(meter, &constant.negated()?, leading)?);
            return Ok((exact, None));
        }
        _ => {}
    }
    let factor = if exact.is_empty() { factor } else { Factor::new(meter, rest)? };
    Ok((exact, Some(Rc::new(factor))))
}

/// The places of the roots, descending, if enclosures tell them apart.
fn descending(meter: &Meter, roots: &[Root], bits: u64) -> Result<Option<Vec<usize>>, Stop> {
    let mut enclosures = Vec::new();
    for (at, root) in roots.iter().enumerate() {
        enclosures.push((root.place.enclosed(meter, bits)?, at));
    }
    enclosures.sort_by_cached_key(|(enclosure, _)| enclosure.ends());
    enclosures.reverse();
    let mut pairs = enclosures.windows(2);
    let apart = pairs.all(|pair| match pair {
        [(a, _), (b, _)] => a.compare(b) == Some(Ordering::Greater),
        _ => false,
    });
    Ok(apart.then(|| enclosures.into_iter().map(|(_, at)| at).collect()))
}
