//! Rings as written: formulas over parameters and indices, and what they give.

use super::definition::{Coefficients, SchemeDefinition};
use super::reference::SchemeError;
use super::ring::{MAX_RING_POINTS, Orbit, Ring, RingError, point_name};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::{Matrix, Naming};
use crate::formula::{Dependence, IndexPair, LocatedFormula, Value};
use std::collections::BTreeMap;
use std::hash::Hash;
use std::ops::Range;
use std::sync::Arc;

/// The index of a new point within its orbit, and of the place along an edge.
pub(super) const NEW_INDEX: &str = "i";

/// The index of an old point within its orbit.
pub(super) const OLD_INDEX: &str = "j";

/// The formulas of a ring.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct RingFormulas {
    /// The orbits, and how many points each has.
    pub(super) orbits: Vec<(String, LocatedFormula)>,
    /// For each orbit of new points, for each of old ones, the weight in i and j; 0 where
    /// there is none.
    pub(super) weights: Vec<Vec<Option<LocatedFormula>>>,
    /// The families of edges.
    pub(super) edges: Vec<EdgeFormulas>,
}

/// A family of edges, in i.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct EdgeFormulas {
    pub(super) ends: [End; 2],
    pub(super) source: Arc<SourceText>,
    pub(super) span: Range<usize>,
}

/// An end of an edge: `vertex`, `edge[i + 1]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct End {
    pub(super) orbit: usize,
    /// What stands between the brackets, counted mod the number of points of the orbit.
    pub(super) index: Option<LocatedFormula>,
}

type Parameters<V> = BTreeMap<String, V>;

/// The weights of one orbit of old points in one of new points.
struct Block<'a> {
    formula: Option<&'a LocatedFormula>,
    dependence: Dependence,
    columns: usize,
    /// Where the values that the formula has had stand; 0 where it has had none.
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

    /// The formula, and one place for all (i, j) that look the same to it.
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

impl SchemeDefinition {
    /// Whether this is a ring, and has no mask.
    #[must_use]
    pub fn is_ring(&self) -> bool {
        matches!(self.coefficients, Coefficients::Ring(_))
    }

    /// The ring at these parameter values, over any [`Value`]; weights with cosines need
    /// [`RealCyclotomic`](crate::exact::RealCyclotomic) ones.
    ///
    /// # Errors
    /// When this is a mask, a parameter is missing or unknown, a formula has no value,
    /// the weights have no [`common_conductor`](crate::exact::common_conductor), or they
    /// are not a ring.
    pub fn ring<V: Value + Eq + Hash>(
        &self,
        values: &BTreeMap<String, V>,
    ) -> Result<Ring<V>, SchemeError> {
        let Coefficients::Ring(formulas) = &self.coefficients else {
            return Err(SchemeError::NotRing { scheme: self.name.clone() });
        };
        let parameters = self.complete(values)?;
        let orbits = self.orbits(formulas, &parameters)?;
        let weights = self.weights(formulas, &orbits, &parameters)?;
        let edges = self.edges(formulas, &orbits, &parameters)?;
        Ring::with_weights(orbits, weights, edges).map_err(|error| formulas.refusal(&error))
    }

    fn orbits<V: Value>(
        &self,
        formulas: &RingFormulas,
        parameters: &Parameters<V>,
    ) -> Result<Vec<Orbit>, SchemeError> {
        let range = 1..i64::try_from(MAX_RING_POINTS).expect("a small cap") + 1;
        let mut points = 0;
        let mut orbits = Vec::with_capacity(formulas.orbits.len());
        for (name, formula) in &formulas.orbits {
            let what = format!("the number of points of `{name}`");
            let count = self.integer(formula, parameters, &[], &what, range.clone())?;
            let count = usize::try_from(count).expect("in the range");
            points += count;
            if points > MAX_RING_POINTS {
                return Err(at_formula(formula, &RingError::Points(points)));
            }
            orbits.push(Orbit { name: name.clone(), count });
        }
        Ok(orbits)
    }

    /// Each formula is evaluated once for all places that look the same to it.
    fn weights<V: Value + Eq + Hash>(
        &self,
        formulas: &RingFormulas,
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

    /// The edges of every family, i running over the indices of its larger orbit.
    fn edges<V: Value>(
        &self,
        formulas: &RingFormulas,
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
                    let error = RingError::Loop(point_name(orbits, a));
                    return Err(family.refusal(&error.to_string(), None));
                }
                edges.push((a, b));
            }
        }
        Ok(edges)
    }
}

impl EdgeFormulas {
    /// Makes sure that `edge` of N > 1 points has an index.
    fn check_brackets(&self, orbits: &[Orbit]) -> Result<(), SchemeError> {
        let bare = |end: &&End| end.index.is_none() && orbits[end.orbit].count > 1;
        let Some(end) = self.ends.iter().find(bare) else { return Ok(()) };
        let Orbit { name, count } = &orbits[end.orbit];
        let message = format!("`{name}` has {count} points, and this does not say which");
        Err(self.refusal(&message, Some(format!("write {name}[i], for i = 0, …, {}", count - 1))))
    }

    fn refusal(&self, message: &str, help: Option<String>) -> SchemeError {
        let diagnostic = Diagnostic::new(&self.source, self.span.clone(), message);
        SchemeError::File(Box::new(Diagnostic { help, ..diagnostic }))
    }
}

impl RingFormulas {
    /// The place of all the weights.
    pub(super) fn whole(&self) -> (&Arc<SourceText>, Range<usize>) {
        extent(self.weights.iter().flatten().flatten())
    }

    /// Why these formulas do not give a ring, at their place in the file.
    fn refusal(&self, error: &RingError) -> SchemeError {
        let (source, span) = match error {
            RingError::NotAffine { point, .. } => {
                let orbit = point.split('[').next().unwrap_or_default();
                let rows = self.orbits.iter().zip(&self.weights);
                let rows = rows.filter(|((name, _), _)| name == orbit).map(|(_, row)| row);
                extent(rows.flatten().flatten())
            }
            RingError::Disconnected { .. } => {
                let (first, last) = (&self.edges[0], &self.edges[self.edges.len() - 1]);
                (&first.source, first.span.start..last.span.end)
            }
            _ => self.whole(),
        };
        SchemeError::File(Box::new(Diagnostic::new(source, span, error.to_string())))
    }
}

/// From the first to the last of these formulas. The reader has made sure that each
/// orbit of new points has one.
fn extent<'a>(
    formulas: impl Iterator<Item = &'a LocatedFormula> + Clone,
) -> (&'a Arc<SourceText>, Range<usize>) {
    let spans = formulas.clone().map(|formula| &formula.span);
    let start = spans.clone().map(|span| span.start).min();
    let end = spans.map(|span| span.end).max();
    let mut formulas = formulas;
    let first = formulas.next().expect("the reader refuses orbits without weights");
    (&first.source, start.unwrap_or(0)..end.unwrap_or(0))
}

fn indices(orbit: &Orbit) -> Range<i64> {
    0..index(orbit.count)
}

fn index(i: usize) -> i64 {
    i64::try_from(i).expect("a small cap")
}

fn at_formula(formula: &LocatedFormula, error: &RingError) -> SchemeError {
    let span = formula.span.clone();
    SchemeError::File(Box::new(Diagnostic::new(&formula.source, span, error.to_string())))
}
