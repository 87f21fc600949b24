//! Rings from formulas over parameters and indices.

use super::formulas::{End, LocalFormulas, NEW_INDEX, OLD_INDEX};
use super::rules::{LocalError, LocalRules, MAX_LOCAL_POINTS, Orbit, point_name};
use crate::diagnostic::Diagnostic;
use crate::exact::{Matrix, Naming, Rational};
use crate::formula::{Dependence, IndexPair, LocatedFormula, Value};
use crate::scheme::definition::{Coefficients, SchemeDefinition};
use crate::scheme::error::{SchemeError, at_values};
use std::collections::BTreeMap;
use std::hash::Hash;
use std::ops::Range;

type Parameters<V> = BTreeMap<String, V>;

/// The weights of the points of one old orbit in the points of one new orbit.
struct Block<'a> {
    formula: Option<&'a LocatedFormula>,
    dependence: Dependence,
    columns: usize,
    /// For each entry, the index of the formula's value in the list of values; 0 before
    /// its evaluation.
    known: Vec<usize>,
}

impl<'a> Block<'a> {
    fn new(
        formula: Option<&'a LocatedFormula>,
        pair: &mut IndexPair<'a>,
        new: &Orbit,
        old: &Orbit,
    ) -> Block<'a> {
        let dependence = formula.map_or(Dependence::Neither, |f| pair.dependence(&f.expr));
        let places = match dependence {
            Dependence::Neither => 1,
            Dependence::First => new.count,
            Dependence::Second => old.count,
            Dependence::Difference => new.count + old.count,
            Dependence::Both => new.count * old.count,
        };
        Block { formula, dependence, columns: old.count, known: vec![0; places] }
    }

    /// The formula, and the entry of `known` for new point i and old point j. All pairs
    /// at which the formula must have the same value share one entry.
    fn place(&mut self, i: usize, j: usize) -> (Option<&'a LocatedFormula>, &mut usize) {
        let at = match self.dependence {
            Dependence::Neither => 0,
            Dependence::First => i,
            Dependence::Second => j,
            Dependence::Difference => self.known.len() - self.columns + j - i,
            Dependence::Both => i * self.columns + j,
        };
        (self.formula, &mut self.known[at])
    }
}

/// The names of a parameter that is a valence.
pub const VALENCE_NAMES: [&str; 2] = ["N", "n"];

impl SchemeError {
    /// Whether what is missing is a valence.
    #[must_use]
    pub fn asks_for_valence(&self) -> bool {
        let SchemeError::MissingParameter { parameter, .. } = self else { return false };
        VALENCE_NAMES.contains(&parameter.as_str())
    }
}

impl SchemeDefinition {
    /// The parameter that is a valence, if it has no value among these: `N` or `n`.
    #[must_use]
    pub fn valence_name<V>(&self, values: &BTreeMap<String, V>) -> Option<&'static str> {
        let open = |name: &&str| self.parameters.contains_key(*name) && !values.contains_key(*name);
        VALENCE_NAMES.into_iter().find(open)
    }

    /// Gives the parameter that is a valence this value.
    ///
    /// # Errors
    /// When it is `given` already, or there is none. The error calls the scheme by the `name` that is given.
    pub fn set_valence<V: Value, G>(
        &self,
        name: &str,
        given: &BTreeMap<String, G>,
        values: &mut BTreeMap<String, V>,
        valence: usize,
    ) -> Result<(), SchemeError> {
        let open = self.valence_name(given);
        let open = open.ok_or_else(|| SchemeError::NoValence { scheme: name.to_owned() })?;
        values.insert(open.to_owned(), V::from_rational(&Rational::from(valence)));
        Ok(())
    }

    /// Whether this is a ring rather than a mask.
    #[must_use]
    pub fn is_ring(&self) -> bool {
        matches!(self.coefficients, Coefficients::LocalRules(_))
    }

    /// The ring at these parameter values, over any [`Value`]. Weights with cosines need
    /// [`RealCyclotomic`](crate::exact::RealCyclotomic) values.
    ///
    /// # Errors
    /// When this is a mask, a parameter is missing or unknown, a formula has no value,
    /// the weights have no [`common_conductor`](crate::exact::common_conductor), or they
    /// are not a ring.
    pub fn ring<V: Value + Eq + Hash>(
        &self,
        values: &BTreeMap<String, V>,
    ) -> Result<LocalRules<V>, SchemeError> {
        let Coefficients::LocalRules(formulas) = &self.coefficients else {
            return Err(SchemeError::NotRing { scheme: self.name.clone() });
        };
        let parameters = self.complete(values)?;
        let orbits = self.orbits(formulas, &parameters)?;
        let weights = self.weights(formulas, &orbits, &parameters)?;
        let edges = self.edges(formulas, &orbits, &parameters)?;
        LocalRules::with_weights(orbits, weights, edges)
            .map_err(|error| formulas.refusal(&error, |error| at_values(error, &parameters)))
    }

    fn orbits<V: Value>(
        &self,
        formulas: &LocalFormulas,
        parameters: &Parameters<V>,
    ) -> Result<Vec<Orbit>, SchemeError> {
        let range = 1..i64::try_from(MAX_LOCAL_POINTS).expect("a small cap") + 1;
        let mut points = 0;
        let mut orbits = Vec::with_capacity(formulas.orbits.len());
        for (name, formula) in &formulas.orbits {
            let what = format!("the number of points of `{name}`");
            let count = self.integer(formula, parameters, &[], &what, range.clone())?;
            let count = usize::try_from(count).expect("in the range");
            points += count;
            if points > MAX_LOCAL_POINTS {
                return Err(at_formula(formula, &LocalError::Points(points)));
            }
            orbits.push(Orbit { name: name.clone(), count });
        }
        Ok(orbits)
    }

    /// The matrix of weights. Each formula is evaluated once for all (i, j) at which it
    /// must have the same value.
    fn weights<V: Value + Eq + Hash>(
        &self,
        formulas: &LocalFormulas,
        orbits: &[Orbit],
        parameters: &Parameters<V>,
    ) -> Result<Matrix<V>, SchemeError> {
        let mut pair = IndexPair::new([NEW_INDEX, OLD_INDEX], &self.definitions);
        let (mut values, mut rows) = (vec![V::zero()], Vec::new());
        for (new, formulas) in orbits.iter().zip(&formulas.weights) {
            let blocks = orbits.iter().zip(formulas);
            let mut blocks: Vec<Block> = blocks
                .map(|(old, formula)| Block::new(formula.as_ref(), &mut pair, new, old))
                .collect();
            for i in 0..new.count {
                let mut row = Vec::new();
                for block in &mut blocks {
                    for j in 0..block.columns {
                        let (formula, known) = block.place(i, j);
                        if let (Some(formula), 0) = (formula, *known) {
                            let at = [(NEW_INDEX, index(i)), (OLD_INDEX, index(j))];
                            values.push(self.value(formula, parameters, &at)?);
                            *known = values.len() - 1;
                        }
                        row.push(*known);
                    }
                }
                rows.push(row);
            }
        }
        self.check_common_field(values.iter())?;
        let mut naming = Naming::new();
        let names: Vec<u32> = values.into_iter().map(|value| naming.name(value)).collect();
        let row = |row: Vec<usize>| row.into_iter().map(|place| names[place]).collect();
        let rows = rows.into_iter().map(row).collect();
        Ok(naming.matrix(rows))
    }

    /// The edges of all families. In each family i runs over the indices of the larger of
    /// its two orbits.
    fn edges<V: Value>(
        &self,
        formulas: &LocalFormulas,
        orbits: &[Orbit],
        parameters: &Parameters<V>,
    ) -> Result<Vec<(usize, usize)>, SchemeError> {
        let first = |orbit: usize| orbits[..orbit].iter().map(|orbit| orbit.count).sum::<usize>();
        let point = |end: &End, i: i64| -> Result<usize, SchemeError> {
            let index = match &end.index {
                Some(formula) => {
                    let range = -1_000_000..1_000_001;
                    let at = [(NEW_INDEX, i)];
                    self.integer(formula, parameters, &at, "the index of a point", range)?
                }
                None => 0,
            };
            let count = i64::try_from(orbits[end.orbit].count).expect("a small cap");
            Ok(first(end.orbit) + usize::try_from(index.rem_euclid(count)).expect("0 ≤ it"))
        };
        let mut edges = Vec::new();
        for family in &formulas.edges {
            family.check_brackets(orbits)?;
            let larger = family.ends.each_ref().map(|end| &orbits[end.orbit]);
            let larger = larger.into_iter().max_by_key(|orbit| orbit.count).expect("two ends");
            for i in indices(larger) {
                let [a, b] = &family.ends;
                let (a, b) = (point(a, i)?, point(b, i)?);
                if a == b {
                    let error = LocalError::Loop(point_name(orbits, a));
                    return Err(family.refusal(&error.to_string(), None));
                }
                edges.push((a, b));
            }
        }
        Ok(edges)
    }
}

fn indices(orbit: &Orbit) -> Range<i64> {
    0..index(orbit.count)
}

fn index(i: usize) -> i64 {
    i64::try_from(i).expect("a small cap")
}

fn at_formula(formula: &LocatedFormula, error: &LocalError) -> SchemeError {
    let span = formula.span.clone();
    SchemeError::File(Box::new(
        Diagnostic::new(&formula.source, span, error.to_string()).with_cap(error.cap()),
    ))
}
