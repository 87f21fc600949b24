//! Curves, on which theorems are tried.

use crate::bound::{Budget, Constants, MAX_CLASSES, Operator, Order, SoundBound, best_offset};
use crate::claim::Quantity;
use crate::exact::{Enclosed, Rational, RealCyclotomic};
use crate::finding::{Attained, Control, LevelEvidence, Place, Reason, Supremum};
use crate::judge::distance::{KnownDistances, KnownOvershoots};
use crate::judge::theorem::levels::sums;
use crate::judge::theorem::setting::{Setting, later};
use crate::limit::{
    Comparison, Overshoot, Parametrisation, greatest_difference, greatest_step_from, step_supremum,
};
use crate::scheme::{AnyScheme, Axes, Mask, Scheme};
use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;

/// The longest block of a sound bound.
const MAX_BLOCK: u32 = 6;

/// The highest level whose sound bound is computed.
const MAX_SOUND_LEVEL: u32 = 64;

/// The most residue classes over which a constant is computed here.
const MAX_CONSTANT_CLASSES: u64 = 1 << 14;

/// A curve scheme at an offset.
pub(crate) struct Curve {
    constants: Constants,
    distances: KnownDistances,
    greatest: RefCell<BTreeMap<(Quantity, u32), Result<Attained, Reason>>>,
    /// The sound bounds of the first levels.
    sound: OnceCell<Vec<Rational>>,
    /// The scheme at its best offset, if that is another one.
    centred: OnceCell<Option<Box<Curve>>>,
    /// Where the points are: x^k_i at (i + shift)/n^k.
    shift: Rational,
    /// The scheme with the points at their natural parameters, if these are others.
    natural: OnceCell<Option<Box<Curve>>>,
    overshoots: KnownOvershoots,
    budget: Budget,
}

impl Curve {
    pub(crate) fn new(mask: Mask, budget: &Budget) -> Curve {
        Curve::placed(mask, Parametrisation::Indexed, budget)
    }

    fn placed(mask: Mask, parametrisation: Parametrisation, budget: &Budget) -> Curve {
        let scheme = AnyScheme::Uniform(Scheme::Curve(mask.clone()));
        let (greatest, sound, centred, natural, overshoots) = Default::default();
        Curve {
            distances: KnownDistances::placed(scheme, parametrisation, budget),
            shift: parametrisation.shift(&mask),
            constants: Constants::new(mask),
            greatest,
            sound,
            centred,
            natural,
            overshoots,
            budget: budget.clone(),
        }
    }

    /// The supremum of a step or of a difference.
    fn most(&self, quantity: Quantity, level: u32) -> Result<RealCyclotomic, Reason> {
        if quantity == Quantity::Difference || self.shift.is_zero() {
            return Ok(self.greatest(quantity, level)?.value);
        }
        let most = step_supremum(self.mask(), level, &self.shift);
        most.map(RealCyclotomic::from).map_err(Reason::from)
    }

    fn mask(&self) -> &Mask {
        self.constants.mask()
    }

    fn sound_bound(&self) -> Option<SoundBound> {
        let block = (1..=MAX_BLOCK).take_while(|&c| self.factor(c).is_ok()).last()?;
        SoundBound::curve(&self.constants, block).ok()
    }

    /// The greatest step at a point of level k + 1, or the greatest difference, with data that
    /// attain it.
    fn greatest(&self, quantity: Quantity, level: u32) -> Result<Attained, Reason> {
        let mut known = self.greatest.borrow_mut();
        known
            .entry((quantity, level))
            .or_insert_with(|| self.find_greatest(quantity, level))
            .clone()
    }

    fn find_greatest(&self, quantity: Quantity, level: u32) -> Result<Attained, Reason> {
        let found = match quantity {
            Quantity::Step => greatest_step_from(self.mask(), level, &self.shift),
            _ => greatest_difference(self.mask(), level),
        };
        let found = found.map_err(Reason::from)?;
        let place = match quantity {
            Quantity::Step => Place::Point(found.index),
            _ => Place::Difference(found.index),
        };
        Ok(Attained { control: Control::Polygon(found.polygon), place, value: found.value.into() })
    }
}

impl Setting for Curve {
    fn compare(
        &self,
        quantity: Quantity,
        level: u32,
        bound: &RealCyclotomic,
    ) -> Result<Comparison<Attained>, Reason> {
        if quantity == Quantity::Distance {
            if self.soundly_within(level, bound) {
                return Ok(Comparison::Within);
            }
            return self.distances.compare(level, bound);
        }
        let found = self.greatest(quantity, level)?;
        if found.value > *bound {
            return Ok(Comparison::Exceeds(found));
        }
        let most = self.most(quantity, level)?;
        // The greatest step may be at a point of level k, which certificates cannot express.
        Ok(if most <= *bound {
            Comparison::Within
        } else {
            Comparison::Undecided(Box::new(most.enclosure(0)))
        })
    }

    fn supremum(&self, quantity: Quantity, level: u32, parts: u32) -> Result<Supremum, Reason> {
        if quantity != Quantity::Distance {
            let most = self.most(quantity, level)?;
            return Ok(Supremum { lower: most.clone(), upper: Some(most) });
        }
        self.distances.supremum(level, parts)
    }

    fn factor(&self, c: u32) -> Result<RealCyclotomic, Reason> {
        let classes = (self.mask().arity() as u64).checked_pow(c);
        if classes.is_none_or(|classes| classes > MAX_CONSTANT_CLASSES.min(MAX_CLASSES)) {
            return Err(Reason::Constant(c));
        }
        let norm = self.constants.norm(Operator::Difference, c, Order::Adjoint);
        norm.map(RealCyclotomic::from).map_err(Reason::from)
    }

    fn evidence(
        &self,
        quantity: Quantity,
        bounds: &[(u32, RealCyclotomic)],
    ) -> Result<LevelEvidence, Reason> {
        match quantity {
            Quantity::Distance => {
                sums(&Axes::Curve(&self.constants), self.sound_bound().as_ref(), bounds)
            }
            _ => Ok(LevelEvidence::Suprema),
        }
    }

    fn sound(&self, level: u32) -> Option<RealCyclotomic> {
        if !self.shift.is_zero() {
            return None;
        }
        let levels = || self.sound_bound()?.levels(MAX_SOUND_LEVEL);
        let bounds = self.sound.get_or_init(|| levels().unwrap_or_default());
        bounds.get(level as usize).cloned().map(RealCyclotomic::from)
    }

    fn centred(&self) -> Option<&dyn Setting> {
        let centred = self.centred.get_or_init(|| {
            let (offset, _) = best_offset(self.mask());
            let other = offset != self.mask().offset();
            other.then(|| Box::new(Curve::new(self.mask().with_offset(offset), &self.budget)))
        });
        centred.as_deref().map(|curve| curve as &dyn Setting)
    }

    fn overshoot(&self, quantity: Quantity, level: u32) -> Option<Overshoot> {
        self.overshoots.greatest(&[self.mask()], level, later(quantity)?)
    }

    fn natural(&self) -> Option<&dyn Setting> {
        let natural = self.natural.get_or_init(|| {
            let shift = Parametrisation::Natural.shift(self.mask());
            (shift != self.shift).then(|| {
                let (mask, natural) = (self.mask().clone(), Parametrisation::Natural);
                Box::new(Curve::placed(mask, natural, &self.budget))
            })
        });
        natural.as_deref().map(|curve| curve as &dyn Setting)
    }
}
