//! The known distances of one scheme from its limit.

use crate::bound::Budget;
use crate::exact::{Rational, RealCyclotomic, comparable};
use crate::finding::{Attained, Reason, Supremum};
use crate::judge::distance::attained::at_point;
use crate::judge::distance::compare::{curve, net};
use crate::limit::{
    Comparison, Distances, Limit, LocalDistances, LocalLimit, Parametrisation, Spreads,
    SurfaceDistances,
};
use crate::scheme::{AnyScheme, Mask, Scheme};
use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;

/// The most levels that are looked at to compare a level and all later ones.
const MAX_LATER: u32 = 24;

/// The most cells that one comparison looks at.
const MAX_CELLS: u32 = 1 << 13;

/// The distances of a scheme from its limit for control data of spread 1; results are kept.
/// Promises of tables and theorems ask the same questions.
///
/// Errors are texts that say why there is no answer.
pub(crate) struct KnownDistances {
    scheme: AnyScheme,
    parametrisation: Parametrisation,
    budget: Budget,
    distances: OnceCell<Result<AnyDistances, Reason>>,
    levels: RefCell<BTreeMap<u32, LevelFindings>>,
    suprema: RefCell<BTreeMap<(u32, u32), Result<Supremum, Reason>>>,
}

/// The distances, for each kind of scheme.
enum AnyDistances {
    Curve(Box<Distances>),
    Surface(Box<(SurfaceDistances, [Limit; 2])>),
    LocalRules(Box<LocalDistances>),
}

/// The known results on the distance constant of a level.
#[derive(Default)]
struct LevelFindings {
    at_most: Option<RealCyclotomic>,
    /// The greatest distance found.
    found: Option<Attained>,
    /// The bounds that are not decided.
    open: Vec<(RealCyclotomic, Comparison<Attained>)>,
}

impl KnownDistances {
    /// The distances of this scheme with points at i/n^k, found within a budget that others may
    /// share.
    pub(crate) fn new(scheme: impl Into<AnyScheme>, budget: &Budget) -> KnownDistances {
        KnownDistances::placed(scheme, Parametrisation::Indexed, budget)
    }

    /// As [`KnownDistances::new`], with points in either parametrisation.
    pub(crate) fn placed(
        scheme: impl Into<AnyScheme>,
        parametrisation: Parametrisation,
        budget: &Budget,
    ) -> KnownDistances {
        let (scheme, budget) = (scheme.into(), budget.clone());
        let (distances, levels, suprema) = Default::default();
        KnownDistances { scheme, parametrisation, budget, distances, levels, suprema }
    }

    /// The distances of the same scheme with the points at their natural parameters; `None` for
    /// a ring, and where the points are there already.
    pub(crate) fn natural(&self) -> Option<KnownDistances> {
        let AnyScheme::Uniform(scheme) = &self.scheme else { return None };
        let other = self.parametrisation == Parametrisation::Indexed
            && Parametrisation::Natural.moves(scheme.iter());
        other.then(|| {
            KnownDistances::placed(self.scheme.clone(), Parametrisation::Natural, &self.budget)
        })
    }

    fn of(&self) -> Result<&AnyDistances, Reason> {
        let of = self
            .distances
            .get_or_init(|| AnyDistances::new(&self.scheme, self.parametrisation, &self.budget));
        of.as_ref().map_err(Clone::clone)
    }

    /// Compares the distance constant of a level, which is the supremum over all control data of
    /// spread 1, with a bound. If it exceeds the bound, the result has data that attain a greater
    /// distance.
    pub(crate) fn compare(
        &self,
        level: u32,
        bound: &RealCyclotomic,
    ) -> Result<Comparison<Attained>, Reason> {
        let of = self.of()?;
        let mut levels = self.levels.borrow_mut();
        let known = levels.entry(level).or_default();
        let within = |most: &RealCyclotomic| comparable(most, bound) && most <= bound;
        if known.at_most.as_ref().is_some_and(within) {
            return Ok(Comparison::Within);
        }
        let exceeds = |found: &&Attained| comparable(&found.value, bound) && found.value > *bound;
        if let Some(found) = known.found.as_ref().filter(exceeds) {
            return Ok(Comparison::Exceeds(found.clone()));
        }
        if let Some((_, undecided)) = known.open.iter().find(|(open, _)| open == bound) {
            return Ok(undecided.clone());
        }
        let compared = of.compare(level, bound)?;
        match &compared {
            Comparison::Within => known.at_most = Some(bound.clone()),
            Comparison::Exceeds(found) => known.found = Some(found.clone()),
            Comparison::Undecided(_) => known.open.push((bound.clone(), compared.clone())),
        }
        Ok(compared)
    }

    /// Compares the distance constants of a level and of all later levels with a bound. If one
    /// exceeds the bound, the result has its level, and data that attain a greater distance.
    pub(crate) fn compare_from(
        &self,
        level: u32,
        bound: &RealCyclotomic,
    ) -> Result<Comparison<(u32, Attained)>, Reason> {
        let lasting = self.of()?.lasting();
        let mut undecided = None;
        for later in level..level.saturating_add(MAX_LATER) {
            if self.of()?.surely(later, bound) {
                return Ok(undecided.map_or(Comparison::Within, Comparison::Undecided));
            }
            match self.compare(later, bound)? {
                Comparison::Within => {}
                Comparison::Exceeds(found) => return Ok(Comparison::Exceeds((later, found))),
                Comparison::Undecided(enclosure) => {
                    undecided.get_or_insert(enclosure);
                }
            }
            if lasting.is_some_and(|levels| later + 1 - level >= levels) {
                return Ok(undecided.map_or(Comparison::Within, Comparison::Undecided));
            }
        }
        Err(Reason::Later(level))
    }

    /// An enclosure of the distance constant of a level; its width is about 1/`parts` of the
    /// constant.
    pub(crate) fn supremum(&self, level: u32, parts: u32) -> Result<Supremum, Reason> {
        let of = self.of()?;
        let mut known = self.suprema.borrow_mut();
        known.entry((level, parts)).or_insert_with(|| of.supremum(level, parts)).clone()
    }

    /// The distances of a ring.
    pub(crate) fn of_ring(&self) -> Result<&LocalDistances, Reason> {
        match self.of()? {
            AnyDistances::LocalRules(distances) => Ok(distances),
            AnyDistances::Curve(_) | AnyDistances::Surface(_) => Err(Reason::NoRing),
        }
    }
}

impl AnyDistances {
    fn new(
        scheme: &AnyScheme,
        parametrisation: Parametrisation,
        budget: &Budget,
    ) -> Result<AnyDistances, Reason> {
        let limit = |mask: &Mask| Limit::new(mask).map_err(Reason::from);
        Ok(match scheme {
            AnyScheme::Uniform(Scheme::Curve(mask)) => {
                let distances =
                    Distances::placed(&limit(mask)?, parametrisation).map_err(Reason::from)?;
                let distances = distances.with_cells(MAX_CELLS).with_budget(budget.clone());
                AnyDistances::Curve(Box::new(distances))
            }
            AnyScheme::Uniform(Scheme::Tensor(first, second)) => {
                let limits = [limit(first)?, limit(second)?];
                let distances =
                    SurfaceDistances::placed(&limits[0], &limits[1], parametrisation, budget);
                AnyDistances::Surface(Box::new((distances.map_err(Reason::from)?, limits)))
            }
            AnyScheme::Lattice(_) => return Err(Reason::Lattice),
            AnyScheme::LocalRules(ring) => {
                let limit = LocalLimit::new(ring).map_err(Reason::from)?;
                AnyDistances::LocalRules(Box::new(LocalDistances::new(limit)))
            }
        })
    }

    /// Whether a bound that needs no search shows that the distance constants of a level and of all
    /// later levels are at most `bound`.
    fn surely(&self, level: u32, bound: &RealCyclotomic) -> bool {
        let Some(bound) = bound.as_rational() else { return false };
        match self {
            AnyDistances::Curve(distances) => distances.at_most(level) <= *bound,
            AnyDistances::Surface(surface) => surface.0.at_most(level, &Spreads::one()) <= *bound,
            AnyDistances::LocalRules(_) => false,
        }
    }

    /// A c such that if c consecutive levels are within a bound, all later ones are; `None` where
    /// none is known.
    fn lasting(&self) -> Option<u32> {
        match self {
            AnyDistances::Curve(distances) => distances.lasting(),
            AnyDistances::Surface(surface) => surface.0.lasting(),
            AnyDistances::LocalRules(distances) => Some(distances.lasting()),
        }
    }

    fn compare(&self, level: u32, bound: &RealCyclotomic) -> Result<Comparison<Attained>, Reason> {
        let rational = || {
            let irrational = || Reason::IrrationalBound(bound.clone());
            bound.as_rational().ok_or_else(irrational)
        };
        match self {
            AnyDistances::Curve(distances) => curve(distances, level, rational()?),
            AnyDistances::Surface(surface) => {
                let (distances, limits) = &**surface;
                net(distances, limits, level, rational()?)
            }
            AnyDistances::LocalRules(distances) => {
                let found = at_point(
                    distances.limit().ring(),
                    distances.constant(level).map_err(Reason::from)?,
                );
                if !comparable(&found.value, bound) {
                    return Err(Reason::NoField(bound.clone()));
                }
                let exceeds = found.value > *bound;
                Ok(if exceeds { Comparison::Exceeds(found) } else { Comparison::Within })
            }
        }
    }

    fn supremum(&self, level: u32, parts: u32) -> Result<Supremum, Reason> {
        let (one, parts) = (Rational::one(), Rational::from(parts));
        let enclosure = match self {
            AnyDistances::Curve(distances) => {
                let coarse = distances.constant(level, &one).map_err(Reason::from)?;
                let width = coarse.enclosure.upper() / &parts;
                let finer =
                    if width.is_zero() { Ok(coarse) } else { distances.constant(level, &width) };
                finer.map_err(Reason::from)?.enclosure
            }
            AnyDistances::Surface(surface) => {
                let (distances, ones) = (&surface.0, Spreads::one());
                let (coarse, _) = distances.constant(level, &one, &ones).map_err(Reason::from)?;
                let width = coarse.upper() / &parts;
                let finer = || distances.constant(level, &width, &ones).map_err(Reason::from);
                if width.is_zero() { coarse } else { finer()?.0 }
            }
            AnyDistances::LocalRules(distances) => {
                let value = distances.constant(level).map_err(Reason::from)?.distance;
                return Ok(Supremum { lower: value.clone(), upper: Some(value) });
            }
        };
        let (lower, upper) = (enclosure.lower().clone(), enclosure.upper().clone());
        Ok(Supremum { lower: lower.into(), upper: Some(upper.into()) })
    }
}
