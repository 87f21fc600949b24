//! Rings whose valence is an integer t without a value: their weights for all t from one on.

use super::formulas::{LocalFormulas, NEW_INDEX, OLD_INDEX};
use crate::exact::{IntegerFunction, Rational, Scalar as _};
use crate::formula::{Dependence, IndexPair, LocatedFormula};
use crate::scheme::definition::{Coefficients, SchemeDefinition};
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// The weights of a ring for all valences t from one on, of which each orbit has one point or t points.
#[derive(Clone, Debug, PartialEq)]
pub struct EveryRing {
    /// The names of the orbits, and whether they have t points.
    pub orbits: Vec<(String, bool)>,
    /// For each orbit of new points and each orbit of old ones.
    pub weights: Vec<Vec<EveryWeight>>,
}

/// The weights of the points of one old orbit in those of one new orbit.
#[derive(Clone, Debug, PartialEq)]
pub enum EveryWeight {
    /// All have this one.
    Same(IntegerFunction),
    /// Both orbits have t points, and the weight depends on d = j − i mod t only.
    Turning {
        /// Those for d = −6, …, 6.
        near: Vec<IntegerFunction>,
        /// b_0, …, b_6: for 6 < d < t − 6 it is Σ_r b_r cos(2πrd/t).
        waves: Vec<IntegerFunction>,
    },
}

/// Values of the parameters.
type Values = BTreeMap<String, IntegerFunction>;

impl SchemeDefinition {
    /// The ring at all valences t ≥ `first` ≥ 16; `None` if this is none, or the weights are not known.
    ///
    /// ```
    /// use subcert::scheme::{EveryWeight, find_in_catalogue};
    ///
    /// let loop_rules = find_in_catalogue("loop")?.every_ring(&[].into(), 27).expect("known weights");
    /// let EveryWeight::Turning { near, .. } = &loop_rules.weights[1][1] else { panic!() };
    /// let near: Vec<String> = near.iter().map(|weight| weight.to_string()).collect();
    /// assert_eq!(near[4..9], ["0", "1/8", "3/8", "1/8", "0"]);
    /// # Ok::<(), subcert::scheme::SchemeError>(())
    /// ```
    #[must_use]
    pub fn every_ring(&self, given: &Values, first: i64) -> Option<EveryRing> {
        let Coefficients::LocalRules(formulas) = &self.coefficients else { return None };
        let valence = self.valence_name(given)?;
        let mut values = given.clone();
        values.insert(valence.to_owned(), IntegerFunction::index(first));
        let values = self.complete(&values).ok()?;
        for (name, spec) in &self.parameters {
            let Some(least) = &spec.least else { continue };
            let least: IntegerFunction = self.value(least, &BTreeMap::new(), &[]).ok()?;
            values[name].minus(&least).sign().filter(|sign| sign.is_ge())?;
        }
        self.orbits_and_weights(formulas, &values, first)
    }

    fn orbits_and_weights(
        &self,
        formulas: &LocalFormulas,
        values: &Values,
        first: i64,
    ) -> Option<EveryRing> {
        let t = IntegerFunction::index(first);
        let mut orbits = Vec::new();
        for (name, count) in &formulas.orbits {
            let count = self.value(count, values, &[]).ok()?;
            let is_full = count.minus(&t).sign().is_some_and(Ordering::is_eq);
            if !is_full && count.as_constant()? != Rational::one() {
                return None;
            }
            orbits.push((name.clone(), is_full));
        }
        let mut pair = IndexPair::new([NEW_INDEX, OLD_INDEX], &self.definitions);
        let mut weights = Vec::new();
        for (new, row) in orbits.iter().zip(&formulas.weights) {
            let mut found = Vec::new();
            for (old, formula) in orbits.iter().zip(row) {
                let dependence = formula
                    .as_ref()
                    .map_or(Dependence::Neither, |formula| pair.dependence(&formula.expr));
                let at = Entry { scheme: self, formula: formula.as_ref(), values, first };
                found.push(match dependence {
                    Dependence::Difference if new.1 && old.1 => at.turning()?,
                    Dependence::Neither if new.1 && old.1 => at.constant()?,
                    Dependence::Neither => EveryWeight::Same(at.value(None)?),
                    _ => return None,
                });
            }
            weights.push(found);
        }
        Some(EveryRing { orbits, weights })
    }
}

/// The formula of a weight.
struct Entry<'a> {
    scheme: &'a SchemeDefinition,
    formula: Option<&'a LocatedFormula>,
    values: &'a Values,
    first: i64,
}

impl Entry<'_> {
    /// The value, for these i and j.
    fn value(&self, places: Option<[&IntegerFunction; 2]>) -> Option<IntegerFunction> {
        let Some(formula) = self.formula else { return Some(IntegerFunction::zero()) };
        let mut values = self.values.clone();
        for (name, place) in [NEW_INDEX, OLD_INDEX].into_iter().zip(places.into_iter().flatten()) {
            values.insert(name.to_owned(), place.clone());
        }
        self.scheme.value(formula, &values, &[]).ok().filter(|value| !value.is_unknown())
    }

    /// The same for all i and j.
    fn constant(&self) -> Option<EveryWeight> {
        let value = self.value(None)?;
        let near = vec![value.clone(); usize::try_from(2 * IntegerFunction::NEAR + 1).ok()?];
        Some(EveryWeight::Turning { near, waves: vec![value] })
    }

    fn turning(&self) -> Option<EveryWeight> {
        let t = IntegerFunction::index(self.first);
        let zero = IntegerFunction::zero();
        // The weight at d, also where j − i is d − t.
        let both = |d: &IntegerFunction| {
            let ahead = self.value(Some([&zero, d]))?;
            let behind = self.value(Some([&t.minus(d), &zero]))?;
            ahead.minus(&behind).sign()?.is_eq().then_some(ahead)
        };
        let near = (-IntegerFunction::NEAR..=IntegerFunction::NEAR).map(|d| {
            let number = IntegerFunction::from(d);
            match d {
                0 => self.value(Some([&zero, &zero])),
                1.. => both(&number),
                _ => both(&t.plus(&number)),
            }
        });
        let near = near.collect::<Option<Vec<_>>>()?;
        let waves = both(&IntegerFunction::place(self.first))?.waves()?;
        Some(EveryWeight::Turning { near, waves })
    }
}
