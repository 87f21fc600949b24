//! Tensor product surfaces, on which theorems are tried.

use crate::bound::{Budget, Constants, MAX_CLASSES, Operator, Order, SoundBound, surface_factor};
use crate::claim::Quantity;
use crate::exact::{Enclosure, Rational, RealCyclotomic, Scalar};
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

/// The most residue classes over which a constant is computed here.
const MAX_CONSTANT_CLASSES: u64 = 1 << 12;

/// The highest level whose sound bound is computed.
const MAX_SOUND_LEVEL: u32 = 64;

/// The longest block of a sound bound.
const MAX_BLOCK: u32 = 6;

/// Two curve schemes, one for each index of the nets, at offsets. Both spreads are 1.
pub(crate) struct Surface {
    axes: [Constants; 2],
    distances: KnownDistances,
    /// The sound bounds of the first levels.
    sound: OnceCell<Vec<Rational>>,
    attained: RefCell<BTreeMap<(Quantity, u32), Result<Attained, Reason>>>,
    parametrisation: Parametrisation,
    /// The scheme with the points at their natural parameters, if these are others.
    natural: OnceCell<Option<Box<Surface>>>,
    overshoots: KnownOvershoots,
    budget: Budget,
}

impl Surface {
    pub(crate) fn new(masks: [Mask; 2], budget: &Budget) -> Surface {
        Surface::placed(masks, Parametrisation::Indexed, budget)
    }

    fn placed(masks: [Mask; 2], parametrisation: Parametrisation, budget: &Budget) -> Surface {
        let [first, second] = masks.clone();
        let scheme = AnyScheme::Uniform(Scheme::Tensor(first, second));
        let (sound, attained, natural, overshoots) = Default::default();
        Surface {
            axes: masks.map(Constants::new),
            distances: KnownDistances::placed(scheme, parametrisation, budget),
            sound,
            attained,
            parametrisation,
            natural,
            overshoots,
            budget: budget.clone(),
        }
    }

    /// A lower bound of the greatest difference or step, with a net that attains it. A net that
    /// changes along one index only has the differences of a curve; the sum of two such nets has as
    /// its steps the sums of theirs.
    ///
    /// Source: `proofs/THEOREMS.md`, 43.
    fn attained(&self, quantity: Quantity, level: u32) -> Result<Attained, Reason> {
        let mut known = self.attained.borrow_mut();
        known.entry((quantity, level)).or_insert_with(|| self.separable(quantity, level)).clone()
    }

    fn separable(&self, quantity: Quantity, level: u32) -> Result<Attained, Reason> {
        let of = |axis: usize| {
            let mask = self.axes[axis].mask();
            match quantity {
                Quantity::Step => {
                    greatest_step_from(mask, level, &self.parametrisation.shift(mask))
                }
                _ => greatest_difference(mask, level),
            }
            .map_err(Reason::from)
        };
        let pair = [of(0)?, of(1)?];
        let polygons = pair.each_ref().map(|found| &found.polygon);
        if quantity == Quantity::Step {
            let row = |x: &i64| polygons[1].points.iter().map(|y| x + y).collect();
            let rows = polygons[0].points.iter().map(row).collect();
            let first = polygons.map(|polygon| polygon.first);
            let value = RealCyclotomic::from(&pair[0].value + &pair[1].value);
            let place = Place::Points(pair.each_ref().map(|found| found.index));
            return Ok(Attained { control: Control::Net { first, rows }, place, value });
        }
        let axis = usize::from(pair[1].value > pair[0].value);
        let points = &polygons[axis].points;
        let (first, rows, place) = if axis == 0 {
            let rows = points.iter().map(|x| vec![*x]).collect();
            ([polygons[0].first, 0], rows, [pair[0].index, 0])
        } else {
            ([0, polygons[1].first], vec![points.clone()], [0, pair[1].index])
        };
        let value = pair[axis].value.clone().into();
        Ok(Attained {
            control: Control::Net { first, rows },
            place: Place::Along(place, axis),
            value,
        })
    }

    fn sound_bound(&self) -> Option<SoundBound> {
        let [first, second] = &self.axes;
        let block = (1..=MAX_BLOCK).take_while(|&c| self.factor(c).is_ok()).last()?;
        SoundBound::surface(first, second, block).ok()
    }

    /// An upper bound of a step or a difference.
    fn upper(&self, quantity: Quantity, level: u32) -> Result<RealCyclotomic, Reason> {
        if quantity == Quantity::Step && self.parametrisation == Parametrisation::Natural {
            return self.natural_step(level);
        }
        let differences = self.factor(level)?;
        Ok(match quantity {
            Quantity::Step => {
                let [first, second] = self.axes.each_ref().map(Constants::mask);
                let one = surface_factor(first, second);
                let other = surface_factor(second, first);
                differences.times(&RealCyclotomic::from(one.min(other)))
            }
            _ => differences,
        })
    }
}

impl Surface {
    /// An upper bound of a step with the points at their natural parameters.
    ///
    /// Source: `proofs/THEOREMS.md`, 90.
    fn natural_step(&self, level: u32) -> Result<RealCyclotomic, Reason> {
        let of = |axis: &Constants| -> Result<[Rational; 3], Reason> {
            let shift = self.parametrisation.shift(axis.mask());
            let step = step_supremum(axis.mask(), level, &shift).map_err(Reason::from)?;
            let norm =
                |level| axis.norm(Operator::Scheme, level, Order::Adjoint).map_err(Reason::from);
            Ok([step, norm(level)?, norm(level + 1)?])
        };
        let [[step, norm, next], [other_step, other_norm, other_next]] =
            [of(&self.axes[0])?, of(&self.axes[1])?];
        let one = &step * &other_next + &norm * &other_step;
        let other = &other_step * &next + &other_norm * &step;
        Ok(one.min(other).into())
    }
}

impl Setting for Surface {
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
        let attained = self.attained(quantity, level)?;
        if attained.value > *bound {
            return Ok(Comparison::Exceeds(attained));
        }
        let upper = self.upper(quantity, level)?;
        if upper <= *bound {
            return Ok(Comparison::Within);
        }
        let ends = [attained.value, upper]
            .map(|end| end.as_rational().cloned().unwrap_or_else(Rational::zero));
        let [lower, upper] = ends;
        Ok(Comparison::Undecided(Box::new(Enclosure::new(lower, upper))))
    }

    fn supremum(&self, quantity: Quantity, level: u32, parts: u32) -> Result<Supremum, Reason> {
        if quantity != Quantity::Distance {
            let lower = self.attained(quantity, level)?.value;
            return Ok(Supremum { lower, upper: Some(self.upper(quantity, level)?) });
        }
        self.distances.supremum(level, parts)
    }

    fn factor(&self, c: u32) -> Result<RealCyclotomic, Reason> {
        let arity = self.axes.iter().map(|axis| axis.mask().arity() as u64).max().unwrap_or(2);
        let classes = arity.checked_pow(c);
        if classes.is_none_or(|classes| classes > MAX_CONSTANT_CLASSES.min(MAX_CLASSES)) {
            return Err(Reason::Constants(c));
        }
        let [first, second] = &self.axes;
        let one = first.tensor_with(second, c).map_err(Reason::from)?;
        let other = second.tensor_with(first, c).map_err(Reason::from)?;
        Ok(one.max(other).into())
    }

    fn evidence(
        &self,
        quantity: Quantity,
        bounds: &[(u32, RealCyclotomic)],
    ) -> Result<LevelEvidence, Reason> {
        match quantity {
            Quantity::Distance => {
                let [first, second] = &self.axes;
                sums(&Axes::Tensor(first, second), self.sound_bound().as_ref(), bounds)
            }
            _ => Ok(LevelEvidence::Suprema),
        }
    }

    fn sound(&self, level: u32) -> Option<RealCyclotomic> {
        if self.parametrisation == Parametrisation::Natural {
            return None;
        }
        let levels = || self.sound_bound()?.levels(MAX_SOUND_LEVEL);
        let bounds = self.sound.get_or_init(|| levels().unwrap_or_default());
        bounds.get(level as usize).cloned().map(RealCyclotomic::from)
    }

    fn levels(&self) -> u32 {
        4
    }

    fn centred(&self) -> Option<&dyn Setting> {
        None
    }

    fn overshoot(&self, quantity: Quantity, level: u32) -> Option<Overshoot> {
        let masks = self.axes.each_ref().map(Constants::mask);
        self.overshoots.greatest(&masks, level, later(quantity)?)
    }

    fn natural(&self) -> Option<&dyn Setting> {
        let natural = self.natural.get_or_init(|| {
            let masks = self.axes.each_ref().map(|axis| axis.mask().clone());
            let other = self.parametrisation == Parametrisation::Indexed;
            let place = || Surface::placed(masks.clone(), Parametrisation::Natural, &self.budget);
            (other && Parametrisation::Natural.moves(&masks)).then(|| Box::new(place()))
        });
        natural.as_deref().map(|surface| surface as &dyn Setting)
    }
}
