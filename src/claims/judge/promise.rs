//! The sound value of a bound or a depth, whatever its verdict is, and whether the printed number
//! keeps its promise for every control polygon.

use crate::cap::Cap;
use crate::claim::{Cell, Promise};
use crate::diagnostic::Diagnostic;
use crate::evaluation::choices::DEPTH_ROUNDING;
use crate::evaluation::context::{CellReading, Outcome};
use crate::evaluation::library::Resolved;
use crate::evaluation::quantity::Quantities;
use crate::evaluation::settings::Settings;
use crate::evaluation::table::Evaluator;
use crate::exact::{Rational, RealCyclotomic};
use crate::finding::{Broken, CellFinding, Kept, PointsAt, Reason, Sound};
use crate::formula::{FormulaErrorKind, LocatedFormula};
use crate::judge::distance::{KnownDistances, Schemes};
use crate::limit::{Comparison, Parametrisation};
use crate::scheme::Mask;
use std::rc::Rc;

/// The highest level at which a bound is computed.
const MAX_BOUND_LEVEL: u32 = 1_000;

/// The greatest absolute value of a level or an offset.
const MAX_INTEGER: i64 = 10_000;

/// Why there is no sound value: a finding, or an error of the claim file.
enum NoSound {
    Because(Box<Reason>),
    Wrong(Diagnostic),
}

impl NoSound {
    fn because(why: impl Into<Reason>) -> NoSound {
        NoSound::Because(Box::new(why.into()))
    }
}

impl From<Diagnostic> for NoSound {
    fn from(diagnostic: Diagnostic) -> NoSound {
        NoSound::Wrong(diagnostic)
    }
}

impl From<Outcome> for NoSound {
    fn from(outcome: Outcome) -> NoSound {
        NoSound::because(match outcome {
            Outcome::Value(value) => Reason::Irrational(value),
            Outcome::Unstated(name) => Reason::Unstated(name),
            Outcome::Undefined(why) => FormulaErrorKind::Undefined(why).into(),
            Outcome::BeyondCap(cap) => cap.into(),
        })
    }
}

/// A promise with its values.
struct Promised {
    scheme: PromisedScheme,
    spread: Rational,
    of: PromiseKind,
}

impl Promised {
    /// The natural parameters of the points of masks.
    fn natural(&self) -> Vec<PointsAt> {
        let PromisedScheme::Masks(scheme, offset) = &self.scheme else { return Vec::new() };
        let at = |mask: &Mask| PointsAt {
            arity: mask.arity(),
            shift: Parametrisation::Natural.shift(mask),
        };
        scheme.at(*offset).masks().into_iter().map(at).collect()
    }
}

/// A scheme whose points are compared with their limit.
enum PromisedScheme {
    /// Masks, at this offset or at their own.
    Masks(Resolved, Option<i64>),
    LocalRules(Rc<KnownDistances>),
}

/// What is promised of a printed number.
#[derive(Clone)]
enum PromiseKind {
    /// It is a depth for this tolerance.
    Tolerance(Rational),
    /// It is a bound of the distance at this level.
    Level(i64),
}

impl Evaluator<'_> {
    pub(crate) fn judge_promise(
        &self,
        cell: &Cell,
        at: CellReading<'_>,
        distances: &Schemes,
        finding: &mut CellFinding,
    ) -> Result<(), Diagnostic> {
        let Some(promise) = &self.table.promise else { return Ok(()) };
        let printed = match cell {
            Cell::Lost | Cell::Blank => None,
            Cell::Printed(printed) => Some(printed.decimal.value()),
        };
        if let (Some(printed), Some(exact)) = (&printed, &finding.exact) {
            // A depth keeps its promise only if it is rounded up, even where the definition rounds
            // it down.
            let needed = match promise {
                Promise::Bound { .. } => Outcome::Value(exact.clone()),
                Promise::Depth { .. } => {
                    let settings = Settings::new(vec![(DEPTH_ROUNDING.key, "up")]);
                    self.evaluate(&self.table.value, CellReading { settings: &settings, ..at })?
                }
            };
            if let Outcome::Value(needed) = needed {
                finding.kept_by_formula = Some(RealCyclotomic::from(printed.clone()) >= needed);
            }
        }
        let promised = match self.promised(promise, at, distances) {
            Ok(promised) => promised,
            Err(NoSound::Because(why)) => {
                finding.kept = printed.map(|_| Kept::Open((*why).clone()));
                finding.sound = Some(Sound::None(*why));
                return Ok(());
            }
            Err(NoSound::Wrong(diagnostic)) => return Err(diagnostic),
        };
        let sound = self.sound(&promised).unwrap_or_else(Sound::None);
        if let Some(printed) = printed {
            finding.kept_by_sound = match &sound {
                Sound::Depth { level, .. } | Sound::Least(level) => {
                    Some(printed.is_integer() && printed >= Rational::from(*level))
                }
                Sound::Bound(bound) => Some(printed >= *bound),
                Sound::None(_) => None,
            };
            if finding.kept_by_sound == Some(true) {
                finding.kept = Some(Kept::Yes);
            } else {
                let kept = Self::kept(&promised, &printed, distances, Parametrisation::Indexed);
                if kept.as_ref() != Some(&Kept::Yes) {
                    let natural = Parametrisation::Natural;
                    finding.kept_naturally = Self::kept(&promised, &printed, distances, natural);
                    if finding.kept_naturally.is_some() {
                        finding.natural = promised.natural();
                    }
                }
                finding.kept = kept;
            }
        }
        finding.sound = Some(sound);
        Ok(())
    }

    fn promised(
        &self,
        promise: &Promise,
        at: CellReading<'_>,
        distances: &Schemes,
    ) -> Result<Promised, NoSound> {
        let (Promise::Depth { spread, offset, ring, .. }
        | Promise::Bound { spread, offset, ring, .. }) = promise;
        let scheme = if let Some(ring) = ring {
            PromisedScheme::LocalRules(
                distances.of_ring(&self.ring(ring, at)??).map_err(NoSound::because)?,
            )
        } else {
            let Quantities { scheme, .. } = self.quantities(at)??;
            let no_scheme = || NoSound::because(Reason::NoScheme);
            let offset = offset.as_ref().map(|formula| self.integer(formula, at)).transpose()?;
            PromisedScheme::Masks(scheme.ok_or_else(no_scheme)?, offset)
        };
        let (formula, spread) = (spread, self.number(spread, at)?);
        if spread.sign() < 0 {
            let (source, span) = (&formula.source, formula.span.clone());
            let message = format!("the spread of the data is negative: {spread}");
            return Err(NoSound::Wrong(Diagnostic::new(source, span, message).with_help(
                "the spread is the largest absolute difference of neighbouring points",
            )));
        }
        let of = match promise {
            Promise::Depth { tolerance, .. } => PromiseKind::Tolerance(self.number(tolerance, at)?),
            Promise::Bound { level, .. } => PromiseKind::Level(self.integer(level, at)?),
        };
        Ok(Promised { scheme, spread, of })
    }

    fn sound(&self, promised: &Promised) -> Result<Sound, Reason> {
        let Promised { scheme, spread, of } = promised;
        let (scheme, offset) = match (scheme, of) {
            (PromisedScheme::Masks(scheme, offset), _) => (scheme, offset),
            (PromisedScheme::LocalRules(ring), PromiseKind::Tolerance(tolerance)) => {
                let depth = ring.of_ring()?.depth(spread, tolerance);
                let depth = depth.map_err(Reason::from)?;
                return Ok(Sound::Least(depth.settled));
            }
            (PromisedScheme::LocalRules(_), PromiseKind::Level(_)) => {
                return Err(Reason::RingBound);
            }
        };
        let bound = self.library.sound_bound(scheme, *offset).map_err(Reason::from)?;
        match of {
            PromiseKind::Tolerance(tolerance) => {
                let depth = bound.depth(spread, tolerance).map_err(Reason::from)?;
                Ok(Sound::Depth { level: depth.level, block: depth.block })
            }
            PromiseKind::Level(level) => {
                let last = u32::try_from(*level).ok().filter(|level| *level <= MAX_BOUND_LEVEL);
                let last = last.ok_or(Reason::LevelOf(*level, MAX_BOUND_LEVEL))?;
                let last = bound.levels(last).and_then(|mut bounds| bounds.pop());
                Ok(Sound::Bound(last.ok_or(Reason::NoContraction)? * spread))
            }
        }
    }

    /// Whether the printed number keeps its promise for every control polygon. `None` if the
    /// natural parameters are asked for and the points are there already, as those of rings are.
    fn kept(
        promised: &Promised,
        printed: &Rational,
        schemes: &Schemes,
        parametrisation: Parametrisation,
    ) -> Option<Kept> {
        let Promised { scheme, spread, of } = promised;
        let level = match of {
            PromiseKind::Tolerance(_) => {
                printed.numerator().to_i64().filter(|_| printed.is_integer())
            }
            PromiseKind::Level(level) => Some(*level),
        };
        let Some(level) = level.and_then(|level| u32::try_from(level).ok()) else {
            return Some(Kept::Open(Reason::NoLevel));
        };
        let most = match of {
            PromiseKind::Tolerance(tolerance) => tolerance,
            PromiseKind::Level(_) => printed,
        };
        let distances = match (scheme, parametrisation) {
            (PromisedScheme::Masks(scheme, offset), Parametrisation::Indexed) => {
                schemes.of(scheme, *offset)
            }
            (PromisedScheme::Masks(scheme, offset), Parametrisation::Natural) => {
                schemes.naturally(scheme, *offset)?
            }
            (PromisedScheme::LocalRules(ring), Parametrisation::Indexed) => Rc::clone(ring),
            (PromisedScheme::LocalRules(_), Parametrisation::Natural) => return None,
        };
        let lasting = matches!(of, PromiseKind::Tolerance(_));
        Some(keeps(&distances, lasting, level, spread, most))
    }

    /// The value of a formula of a promise.
    fn number(&self, formula: &LocatedFormula, at: CellReading<'_>) -> Result<Rational, NoSound> {
        match self.evaluate(formula, at)? {
            Outcome::Value(value) => {
                value.as_rational().cloned().ok_or(NoSound::because(Reason::Irrational(value)))
            }
            outcome => Err(outcome.into()),
        }
    }

    fn integer(&self, formula: &LocatedFormula, at: CellReading<'_>) -> Result<i64, NoSound> {
        let value = self.number(formula, at)?;
        if !value.is_integer() {
            let message = format!("an integer is needed, and this is {value}");
            return Err(Diagnostic::new(&formula.source, formula.span.clone(), message).into());
        }
        let integer = value.numerator().within(MAX_INTEGER);
        integer.ok_or_else(|| {
            let cap = Cap::new("a level or an offset", MAX_INTEGER.unsigned_abs());
            NoSound::because(cap)
        })
    }
}

/// Whether all control data of spread `spread` are within `most` of their limit at a level and, if
/// the promise is `lasting`, at all later levels.
fn keeps(
    distances: &KnownDistances,
    lasting: bool,
    level: u32,
    spread: &Rational,
    most: &Rational,
) -> Kept {
    if spread.sign() <= 0 {
        return Kept::Open(Reason::Spread(spread.clone()));
    }
    let bound = (most / spread).into();
    let compared = if lasting {
        distances.compare_from(level, &bound)
    } else {
        distances.compare(level, &bound).map(|compared| compared.map(|found| (level, found)))
    };
    match compared {
        Ok(Comparison::Within) => Kept::Yes,
        Ok(Comparison::Exceeds((level, attained))) => {
            let (spread, most) = (spread.clone(), most.clone());
            let distance = &attained.value * &RealCyclotomic::from(spread.clone());
            Kept::No(Box::new(Broken { attained, spread, level, distance, most }))
        }
        Ok(Comparison::Undecided(_)) => Kept::Open(Reason::Search),
        Err(why) => Kept::Open(why),
    }
}
