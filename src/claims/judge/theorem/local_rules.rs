//! Rings, on which theorems are tried.

use crate::bound::{Budget, LocalConstants};
use crate::claim::Quantity;
use crate::exact::{Enclosed, Rational, RealCyclotomic, comparable};
use crate::finding::{Attained, LevelEvidence, Place, Reason, Supremum};
use crate::judge::distance::{KnownDistances, at_point, points};
use crate::judge::theorem::setting::Setting;
use crate::limit::{Comparison, LocalDistances, LocalWitness, least_flows, minus, unit};
use crate::scheme::LocalRules;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// The points around an extraordinary vertex or on a face. The points x^{k+1} are compared with x^k
/// by their names or, if there is an interpolant L, with Lx^k; then the distance from the limit is
/// known only at points that L keeps.
pub(crate) struct AroundPoint {
    ring: LocalRules,
    interpolant: Option<LocalRules>,
    distances: KnownDistances,
    /// Suprema, but for distances without an interpolant.
    known: RefCell<BTreeMap<(&'static str, u32), Attained>>,
}

impl AroundPoint {
    pub(crate) fn new(
        ring: LocalRules,
        interpolant: Option<LocalRules>,
        budget: &Budget,
    ) -> AroundPoint {
        let distances = KnownDistances::new(ring.clone(), budget);
        AroundPoint { ring, interpolant, distances, known: RefCell::default() }
    }

    fn distances(&self) -> Result<&LocalDistances, Reason> {
        self.distances.of_ring()
    }

    fn difference(&self, level: u32) -> Result<Attained, Reason> {
        let power = LocalConstants::new(&self.ring, level.max(1)).map_err(Reason::from)?;
        let ((a, b), transport) = if level == 0 {
            let zeroth = self.ring.edges()[0];
            let mut heights = vec![0; self.ring.point_count()];
            heights[zeroth.0] = 1;
            return Ok(Attained {
                control: points(&self.ring, &heights),
                place: self.edge(zeroth.0, zeroth.1),
                value: Rational::one().into(),
            });
        } else {
            power.contraction(level).ok_or(Reason::NoConstant)?
        };
        Ok(Attained {
            control: points(&self.ring, &transport.heights),
            place: self.edge(*a, *b),
            value: transport.value.clone(),
        })
    }

    /// The functionals e_aᵀ − e_bᵀ for the edges (a, b).
    fn edge_differences(&self) -> Vec<Vec<RealCyclotomic>> {
        let count = self.ring.point_count();
        let edges = self.ring.edges().iter();
        edges.map(|&(a, b)| minus(&unit(count, a), &unit(count, b))).collect()
    }

    /// The rows of M − L with the interpolant L, or of M − 1 without.
    fn steps(&self) -> Vec<Vec<RealCyclotomic>> {
        let count = self.ring.point_count();
        let step = |a| {
            let new = self.ring.weights().row(a);
            match &self.interpolant {
                Some(interpolant) => minus(new, interpolant.weights().row(a)),
                None => minus(new, &unit(count, a)),
            }
        };
        (0..count).map(step).collect()
    }

    /// The first point that the interpolant keeps; an error if it keeps none.
    fn kept(&self) -> Option<Result<usize, Reason>> {
        let interpolant = self.interpolant.as_ref()?;
        let (weights, count) = (interpolant.weights(), self.ring.point_count());
        let kept = (0..count).find(|&a| weights.row(a).eq(unit(count, a).iter()));
        Some(kept.ok_or(Reason::NothingKept))
    }

    fn edge(&self, a: usize, b: usize) -> Place {
        Place::Edge([a, b].map(|point| self.ring.name(point)))
    }

    fn greatest(&self, quantity: Quantity, level: u32) -> Result<Attained, Reason> {
        let key = (quantity.name(), level);
        if let Some(known) = self.known.borrow().get(&key) {
            return Ok(known.clone());
        }
        let far =
            |found: Result<LocalWitness, _>| found.map(|witness| at_point(&self.ring, witness));
        let found = match quantity {
            Quantity::Difference => self.difference(level),
            Quantity::Distance => {
                let kept = self.kept().ok_or(Reason::NoInterpolant)??;
                far(self.distances()?.at_point(kept, level)).map_err(Reason::from)
            }
            Quantity::Step => match &self.interpolant {
                None => far(self.distances()?.step(level)).map_err(Reason::from),
                Some(earlier) => {
                    far(self.distances()?.step_from(earlier, level)).map_err(Reason::from)
                }
            },
        }?;
        self.known.borrow_mut().insert(key, found.clone());
        Ok(found)
    }
}

impl Setting for AroundPoint {
    fn ring(&self) -> Option<&LocalRules> {
        Some(&self.ring)
    }

    fn interpolant(&self) -> Option<&LocalRules> {
        self.interpolant.as_ref()
    }

    fn compare(
        &self,
        quantity: Quantity,
        level: u32,
        bound: &RealCyclotomic,
    ) -> Result<Comparison<Attained>, Reason> {
        if quantity == Quantity::Distance && self.interpolant.is_none() {
            return self.distances.compare(level, bound);
        }
        let found = self.greatest(quantity, level)?;
        if !comparable(&found.value, bound) {
            return Err(Reason::NoField(bound.clone()));
        }
        Ok(if found.value > *bound {
            Comparison::Exceeds(found)
        } else if quantity == Quantity::Distance {
            Comparison::Undecided(Box::new(found.value.enclosure(0)))
        } else {
            Comparison::Within
        })
    }

    fn supremum(&self, quantity: Quantity, level: u32, parts: u32) -> Result<Supremum, Reason> {
        if quantity == Quantity::Distance && self.interpolant.is_none() {
            return self.distances.supremum(level, parts);
        }
        let value = self.greatest(quantity, level)?.value;
        let exact = quantity != Quantity::Distance;
        Ok(Supremum { upper: exact.then(|| value.clone()), lower: value })
    }

    fn factor(&self, c: u32) -> Result<RealCyclotomic, Reason> {
        self.greatest(Quantity::Difference, c).map(|found| found.value)
    }

    fn evidence(
        &self,
        quantity: Quantity,
        bounds: &[(u32, RealCyclotomic)],
    ) -> Result<LevelEvidence, Reason> {
        let flows = |functionals: &[Vec<RealCyclotomic>], level| {
            least_flows(&self.ring, functionals.to_vec(), level).map_err(Reason::from)
        };
        let differences = self.edge_differences();
        let (functionals, weights) = match quantity {
            Quantity::Difference => (differences.clone(), Vec::new()),
            Quantity::Step => (self.steps(), Vec::new()),
            Quantity::Distance => {
                let limit = self.distances()?.limit();
                (limit.errors(), limit.weights().to_vec())
            }
        };
        let levels = bounds.iter().map(|(level, _)| flows(&functionals, *level));
        let levels = levels.collect::<Result<_, Reason>>()?;
        let count = u32::try_from(bounds.len()).expect("few levels");
        Ok(LevelEvidence::Flows { weights, contraction: flows(&differences, count)?, levels })
    }

    fn sound(&self, _: u32) -> Option<RealCyclotomic> {
        // The suprema are exact, and no bound is better.
        None
    }

    fn centred(&self) -> Option<&dyn Setting> {
        None
    }

    fn natural(&self) -> Option<&dyn Setting> {
        None
    }

    fn limit(&self) -> Option<&[RealCyclotomic]> {
        self.distances().ok().map(|distances| distances.limit().weights())
    }
}
