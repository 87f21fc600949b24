//! Curves and tensor product surfaces, on which theorems are tried.

use crate::bound::{
    Budget, Constants, MAX_CLASSES, Operator, Order, SoundBound, best_offset, surface_factor,
};
use crate::claim::Quantity;
use crate::exact::{Enclosure, Rational, RealCyclotomic, Scalar};
use crate::finding::{Attained, Control, LevelEvidence, Place, Reason, Supremum};
use crate::judge::distance::{KnownDistances, KnownOvershoots};
use crate::judge::theorem::levels::sums;
use crate::judge::theorem::setting::{Setting, later};
use crate::limit::{
    self, Comparison, Overshoot, Parametrisation, greatest_difference, greatest_step_from,
    step_supremum,
};
use crate::scheme::{Axes, Mask, Scheme};
use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;

/// The longest block of a sound bound.
const MAX_BLOCK: u32 = 6;

/// The highest level whose sound bound is computed.
const MAX_SOUND_LEVEL: u32 = 64;

/// The most residue classes over which a constant of a curve is computed here.
const MAX_CURVE_CLASSES: u64 = 1 << 14;

/// The same for the factors of a product.
const MAX_SURFACE_CLASSES: u64 = 1 << 12;

/// A mask for each index of the control data, at offsets. All spreads are 1.
pub(crate) struct Uniform {
    axes: Axes<Constants>,
    distances: KnownDistances,
    attained: RefCell<BTreeMap<(Quantity, u32), Result<Attained, Reason>>>,
    /// The sound bounds of the first levels.
    sound: OnceCell<Vec<Rational>>,
    /// The scheme for curves at its best offset, if that is another one.
    centred: OnceCell<Option<Box<Uniform>>>,
    parametrisation: Parametrisation,
    /// The scheme with the points at their natural parameters, if these are others.
    natural: OnceCell<Option<Box<Uniform>>>,
    overshoots: KnownOvershoots,
    budget: Budget,
}

impl Uniform {
    pub(crate) fn new(scheme: Scheme, budget: &Budget) -> Uniform {
        Uniform::placed(scheme, Parametrisation::Indexed, budget)
    }

    fn placed(scheme: Scheme, parametrisation: Parametrisation, budget: &Budget) -> Uniform {
        let (attained, sound, centred, natural, overshoots) = Default::default();
        Uniform {
            axes: scheme.map(|mask| Constants::new(mask.clone())),
            distances: KnownDistances::placed(scheme, parametrisation, budget),
            attained,
            sound,
            centred,
            parametrisation,
            natural,
            overshoots,
            budget: budget.clone(),
        }
    }

    /// Of a curve the greatest difference, or the greatest step at a point of level k + 1; of a surface a lower bound;
    /// with data that attain it.
    fn attained(&self, quantity: Quantity, level: u32) -> Result<Attained, Reason> {
        let mut known = self.attained.borrow_mut();
        known.entry((quantity, level)).or_insert_with(|| self.find(quantity, level)).clone()
    }

    fn find(&self, quantity: Quantity, level: u32) -> Result<Attained, Reason> {
        let of = |axis: &Constants| {
            let (mask, step) = (axis.mask(), quantity == Quantity::Step);
            let found = if step {
                greatest_step_from(mask, level, &self.parametrisation.shift(mask))
            } else {
                greatest_difference(mask, level)
            };
            found.map_err(Reason::from)
        };
        match &self.axes {
            Axes::Curve(axis) => {
                let limit::Attained { value, index, polygon } = of(axis)?;
                let place = match quantity {
                    Quantity::Step => Place::Point(index),
                    _ => Place::Difference(index),
                };
                Ok(Attained { control: Control::Polygon(polygon), place, value: value.into() })
            }
            Axes::Tensor(first, second) => Ok(separable(quantity, &[of(first)?, of(second)?])),
        }
    }

    fn sound_bound(&self) -> Option<SoundBound> {
        let block = (1..=MAX_BLOCK).take_while(|&c| self.factor(c).is_ok()).last()?;
        match &self.axes {
            Axes::Curve(axis) => SoundBound::curve(axis, block).ok(),
            Axes::Tensor(first, second) => SoundBound::surface(first, second, block).ok(),
        }
    }

    /// Of a curve a step or a difference, also at points of level k; of a surface an upper bound.
    fn upper(&self, quantity: Quantity, level: u32) -> Result<RealCyclotomic, Reason> {
        let natural_step =
            quantity == Quantity::Step && self.parametrisation == Parametrisation::Natural;
        match &self.axes {
            Axes::Curve(axis) if natural_step => Ok(self.step(axis, level)?.into()),
            Axes::Curve(_) => Ok(self.attained(quantity, level)?.value),
            Axes::Tensor(first, second) if natural_step => {
                self.natural_step([first, second], level)
            }
            Axes::Tensor(first, second) => {
                let differences = self.factor(level)?;
                Ok(match quantity {
                    Quantity::Step => {
                        let one = surface_factor(first.mask(), second.mask());
                        let other = surface_factor(second.mask(), first.mask());
                        differences.times(&RealCyclotomic::from(one.min(other)))
                    }
                    _ => differences,
                })
            }
        }
    }

    /// The supremum of the steps along an axis.
    fn step(&self, axis: &Constants, level: u32) -> Result<Rational, Reason> {
        let shift = self.parametrisation.shift(axis.mask());
        step_supremum(axis.mask(), level, &shift).map_err(Reason::from)
    }

    /// An upper bound of a step of a surface with the points at their natural parameters.
    ///
    /// Source: `proofs/THEOREMS.md`, 90.
    fn natural_step(&self, axes: [&Constants; 2], level: u32) -> Result<RealCyclotomic, Reason> {
        let of = |axis: &Constants| -> Result<[Rational; 3], Reason> {
            let step = self.step(axis, level)?;
            let norm =
                |level| axis.norm(Operator::Scheme, level, Order::Adjoint).map_err(Reason::from);
            Ok([step, norm(level)?, norm(level + 1)?])
        };
        let [[step, norm, next], [other_step, other_norm, other_next]] =
            [of(axes[0])?, of(axes[1])?];
        let one = &step * &other_next + &norm * &other_step;
        let other = &other_step * &next + &other_norm * &step;
        Ok(one.min(other).into())
    }

    /// Two bounds of a step or a difference.
    fn bounds(&self, quantity: Quantity, level: u32) -> Result<[RealCyclotomic; 2], Reason> {
        let lower = match &self.axes {
            Axes::Curve(_) => None,
            Axes::Tensor(..) => Some(self.attained(quantity, level)?.value),
        };
        let upper = self.upper(quantity, level)?;
        Ok([lower.unwrap_or_else(|| upper.clone()), upper])
    }
}

/// A lower bound of the greatest difference or step, with a net that attains it. A net that
/// changes along one index only has the differences of a curve; the sum of two such nets has as
/// its steps the sums of theirs.
///
/// Source: `proofs/THEOREMS.md`, 43.
fn separable(quantity: Quantity, pair: &[limit::Attained; 2]) -> Attained {
    let polygons = pair.each_ref().map(|found| &found.polygon);
    if quantity == Quantity::Step {
        let row = |x: &i64| polygons[1].points.iter().map(|y| x + y).collect();
        let rows = polygons[0].points.iter().map(row).collect();
        let first = polygons.map(|polygon| polygon.first);
        let value = RealCyclotomic::from(&pair[0].value + &pair[1].value);
        let place = Place::Points(pair.each_ref().map(|found| found.index));
        return Attained { control: Control::Net { first, rows }, place, value };
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
    Attained { control: Control::Net { first, rows }, place: Place::Along(place, axis), value }
}

impl Setting for Uniform {
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
        let bounds = self.bounds(quantity, level)?;
        if bounds[1] <= *bound {
            return Ok(Comparison::Within);
        }
        // The greatest step may be at a point of level k, which certificates cannot express.
        let [lower, upper] =
            bounds.map(|end| end.as_rational().cloned().unwrap_or_else(Rational::zero));
        Ok(Comparison::Undecided(Box::new(Enclosure::new(lower, upper))))
    }

    fn supremum(&self, quantity: Quantity, level: u32, parts: u32) -> Result<Supremum, Reason> {
        if quantity != Quantity::Distance {
            let [lower, upper] = self.bounds(quantity, level)?;
            return Ok(Supremum { lower, upper: Some(upper) });
        }
        self.distances.supremum(level, parts)
    }

    fn factor(&self, c: u32) -> Result<RealCyclotomic, Reason> {
        let arity = self.axes.iter().map(|axis| axis.mask().arity() as u64).max().unwrap_or(2);
        let beyond =
            |most: u64| arity.checked_pow(c).is_none_or(|classes| classes > most.min(MAX_CLASSES));
        match &self.axes {
            Axes::Curve(_) if beyond(MAX_CURVE_CLASSES) => Err(Reason::Constant(c)),
            Axes::Curve(axis) => {
                let norm = axis.norm(Operator::Difference, c, Order::Adjoint);
                norm.map(RealCyclotomic::from).map_err(Reason::from)
            }
            Axes::Tensor(..) if beyond(MAX_SURFACE_CLASSES) => Err(Reason::Constants(c)),
            Axes::Tensor(first, second) => {
                let one = first.tensor_with(second, c).map_err(Reason::from)?;
                let other = second.tensor_with(first, c).map_err(Reason::from)?;
                Ok(one.max(other).into())
            }
        }
    }

    fn evidence(
        &self,
        quantity: Quantity,
        bounds: &[(u32, RealCyclotomic)],
    ) -> Result<LevelEvidence, Reason> {
        match quantity {
            Quantity::Distance => sums(&self.axes, self.sound_bound().as_ref(), bounds),
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
        match &self.axes {
            Axes::Curve(_) => 6,
            Axes::Tensor(..) => 4,
        }
    }

    fn centred(&self) -> Option<&dyn Setting> {
        let Axes::Curve(axis) = &self.axes else { return None };
        let centred = self.centred.get_or_init(|| {
            let (offset, _) = best_offset(axis.mask());
            let scheme = Axes::Curve(axis.mask().with_offset(offset));
            let other = offset != axis.mask().offset();
            other.then(|| Box::new(Uniform::new(scheme, &self.budget)))
        });
        centred.as_deref().map(|centred| centred as &dyn Setting)
    }

    fn overshoot(&self, quantity: Quantity, level: u32) -> Option<Overshoot> {
        let masks: Vec<&Mask> = self.axes.iter().map(Constants::mask).collect();
        self.overshoots.greatest(&masks, level, later(quantity)?)
    }

    fn natural(&self) -> Option<&dyn Setting> {
        let natural = self.natural.get_or_init(|| {
            let other = self.parametrisation == Parametrisation::Indexed;
            let scheme = self.axes.map(|axis| axis.mask().clone());
            let moves = other && Parametrisation::Natural.moves(scheme.iter());
            let place = || Uniform::placed(scheme, Parametrisation::Natural, &self.budget);
            moves.then(|| Box::new(place()))
        });
        natural.as_deref().map(|natural| natural as &dyn Setting)
    }
}
