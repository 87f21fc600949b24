//! What holds, whatever the verdict: the sound value of a bound or a depth.

use super::finding::{CellFinding, Sound};
use super::judge::{At, Judge, Outcome};
use super::quantity::Quantities;
use super::reading::{DEPTH_ROUNDING, Settings};
use crate::claim::{Cell, Promise};
use crate::diagnostic::Diagnostic;
use crate::exact::{Rational, RealCyclotomic};
use crate::formula::LocatedFormula;

/// The highest level at which a bound is computed.
const MAX_BOUND_LEVEL: u32 = 1_000;

/// Why there is no sound value: a finding, or an error of the claim file.
enum NoSound {
    Because(String),
    Wrong(Diagnostic),
}

impl From<Diagnostic> for NoSound {
    fn from(diagnostic: Diagnostic) -> NoSound {
        NoSound::Wrong(diagnostic)
    }
}

impl From<Outcome> for NoSound {
    fn from(outcome: Outcome) -> NoSound {
        NoSound::Because(match outcome {
            Outcome::Value(value) => value.to_string(),
            Outcome::Unstated(name) => format!("the paper does not state {name}"),
            Outcome::Undefined(why) | Outcome::BeyondCaps(why) => why,
        })
    }
}

impl Judge<'_> {
    pub(super) fn judge_promise(
        &self,
        cell: &Cell,
        at: At<'_>,
        finding: &mut CellFinding,
    ) -> Result<(), Diagnostic> {
        let Some(promise) = &self.table.promise else { return Ok(()) };
        let printed = match cell {
            Cell::Lost => None,
            Cell::Printed(printed) => Some(printed.decimal.value()),
        };
        if let (Some(printed), Some(exact)) = (&printed, &finding.exact) {
            // A depth that the definition itself rounds down keeps no promise.
            let needed = match promise {
                Promise::Bound { .. } => Outcome::Value(exact.clone()),
                Promise::Depth { .. } => {
                    let settings = Settings::new(vec![(DEPTH_ROUNDING.name, "up")]);
                    self.evaluate(&self.table.value, At { settings: &settings, ..at })?
                }
            };
            if let Outcome::Value(needed) = needed {
                finding.kept_by_formula = Some(RealCyclotomic::from(printed.clone()) >= needed);
            }
        }
        let sound = match self.sound(promise, at) {
            Ok(sound) => sound,
            Err(NoSound::Because(why)) => Sound::None(why),
            Err(NoSound::Wrong(diagnostic)) => return Err(diagnostic),
        };
        if let Some(printed) = printed {
            finding.kept_by_sound = match &sound {
                Sound::Depth { level, .. } => Some(printed >= Rational::from(*level)),
                Sound::Bound(bound) => Some(printed >= *bound),
                Sound::None(_) => None,
            };
        }
        finding.sound = Some(sound);
        Ok(())
    }

    fn sound(&self, promise: &Promise, at: At<'_>) -> Result<Sound, NoSound> {
        let because = |why: String| NoSound::Because(why);
        let Quantities { scheme, .. } = self.quantities(at)??;
        let scheme = scheme.ok_or_else(|| because("no scheme is given".to_owned()))?;
        let (Promise::Depth { spread, offset, .. } | Promise::Bound { spread, offset, .. }) =
            promise;
        let offset = offset.as_ref().map(|formula| self.integer(formula, at)).transpose()?;
        let bound = self.library.sound_bound(&scheme, offset);
        let bound = bound.map_err(|error| because(error.to_string()))?;
        let spread = self.number(spread, at)?;
        match promise {
            Promise::Depth { tolerance, .. } => {
                let tolerance = self.number(tolerance, at)?;
                let depth = bound.depth(&spread, &tolerance);
                let depth = depth.map_err(|error| because(error.to_string()))?;
                Ok(Sound::Depth { level: depth.level, block: depth.block })
            }
            Promise::Bound { level, .. } => {
                let level = self.integer(level, at)?;
                let last = u32::try_from(level).ok().filter(|level| *level <= MAX_BOUND_LEVEL);
                let last = last.ok_or_else(|| {
                    because(format!("a level is from 0 to {MAX_BOUND_LEVEL}, and this is {level}"))
                })?;
                let last = bound.levels(last).and_then(|mut bounds| bounds.pop());
                let none = || because("no constant of the scheme is below 1".to_owned());
                Ok(Sound::Bound(last.ok_or_else(none)? * &spread))
            }
        }
    }

    /// The value of a formula of a promise.
    fn number(&self, formula: &LocatedFormula, at: At<'_>) -> Result<Rational, NoSound> {
        match self.evaluate(formula, at)? {
            Outcome::Value(value) => value.as_rational().cloned().ok_or_else(|| {
                NoSound::Because(format!(
                    "sound values are computed at rational numbers, not at {value}"
                ))
            }),
            outcome => Err(outcome.into()),
        }
    }

    fn integer(&self, formula: &LocatedFormula, at: At<'_>) -> Result<i64, NoSound> {
        let value = self.number(formula, at)?;
        let integer = value.numerator().to_i64().filter(|value| value.abs() <= 10_000);
        integer.filter(|_| value.is_integer()).ok_or_else(|| {
            let message = format!("an integer from -10000 to 10000 is needed, and this is {value}");
            NoSound::Wrong(Diagnostic::new(&formula.source, formula.span.clone(), message))
        })
    }
}
