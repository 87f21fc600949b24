//! What holds, whatever the verdict: the sound value of a bound or a depth.

use super::finding::{CellFinding, Sound};
use super::quantity::Quantities;
use super::table::{At, Judge, Outcome};
use crate::claim::{Cell, Promise};
use crate::diagnostic::Diagnostic;
use crate::exact::Rational;
use crate::formula::LocatedFormula;

/// The highest level at which a bound is computed.
const MAX_BOUND_LEVEL: u32 = 1_000;

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
            finding.kept_by_formula = Some(printed >= exact);
        }
        let sound = self.sound(promise, at)?;
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

    fn sound(&self, promise: &Promise, at: At<'_>) -> Result<Sound, Diagnostic> {
        let Ok(Quantities { scheme: Some(scheme), .. }) = self.quantities(at)? else {
            return Ok(Sound::None("no scheme is given".to_owned()));
        };
        let (Promise::Depth { spread, offset, .. } | Promise::Bound { spread, offset, .. }) =
            promise;
        let offset = match offset {
            None => None,
            Some(formula) => Some(self.integer(formula, at)?),
        };
        let bound = match self.library.sound_bound(&scheme, offset) {
            Ok(bound) => bound,
            Err(error) => return Ok(Sound::None(error.to_string())),
        };
        let spread = self.number(spread, at)?;
        match promise {
            Promise::Depth { tolerance, .. } => {
                let tolerance = self.number(tolerance, at)?;
                Ok(match bound.depth(&spread, &tolerance) {
                    Ok(depth) => Sound::Depth { level: depth.level, block: depth.block },
                    Err(error) => Sound::None(error.to_string()),
                })
            }
            Promise::Bound { level, .. } => {
                let level = self.integer(level, at)?;
                let last = u32::try_from(level).ok().filter(|level| *level <= MAX_BOUND_LEVEL);
                let bounds = last.and_then(|last| bound.levels(last));
                Ok(match bounds.as_ref().and_then(|bounds| bounds.last()) {
                    Some(bound) => Sound::Bound(bound * &spread),
                    None => Sound::None("no constant of the scheme is below 1".to_owned()),
                })
            }
        }
    }

    /// The value of a formula of a promise, which must have one.
    fn number(&self, formula: &LocatedFormula, at: At<'_>) -> Result<Rational, Diagnostic> {
        let refuse =
            |message: String| Err(Diagnostic::new(&formula.source, formula.span.clone(), message));
        match self.evaluate(formula, at)? {
            Outcome::Value(value) => Ok(value),
            Outcome::Unstated(name) => refuse(format!(
                "`{name}` has no value here; list it only where the table's value needs it too"
            )),
            Outcome::Undefined(why) => refuse(why),
        }
    }

    fn integer(&self, formula: &LocatedFormula, at: At<'_>) -> Result<i64, Diagnostic> {
        let value = self.number(formula, at)?;
        let integer = value.numerator().to_i64().filter(|value| value.abs() <= 10_000);
        integer.filter(|_| value.is_integer()).ok_or_else(|| {
            let message = format!("an integer from -10000 to 10000 is needed, and this is {value}");
            Diagnostic::new(&formula.source, formula.span.clone(), message)
        })
    }
}
