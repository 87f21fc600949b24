//! Trying a theorem on one case.

use crate::cap::Cap;
use crate::claim::{Paper, Quantity, Statement, Theorem};
use crate::diagnostic::Diagnostic;
use crate::evaluation::settings::Settings;
use crate::exact::{Enclosed, Rational, RealCyclotomic, Scalar, comparable};
use crate::finding::{Correction, Levels, Outcome, Reason, Violation};
use crate::formula::LocatedFormula;
use crate::judge::theorem::case::Case;
use crate::judge::theorem::correction::settings;
use crate::judge::theorem::evaluate::{LEVEL, TOLERANCE};
use crate::judge::theorem::growth::{Growth, growth};
use crate::judge::theorem::setting::Setting;
use crate::judge::theorem::simplest::slightly_less;
use crate::limit::{Comparison, Parametrisation};

/// A theorem with corrections, to be tried.
pub(crate) struct Trial<'a> {
    pub(crate) paper: &'a Paper,
    pub(crate) theorem: &'a Theorem,
    pub(crate) corrections: &'a [&'a Correction],
    /// Where the points of a level are.
    pub(crate) parametrisation: Parametrisation,
}

impl Trial<'_> {
    fn corrected(&self, by: &Correction) -> bool {
        self.corrections.contains(&by)
    }

    /// The setting with the points where they are in this trial.
    pub(crate) fn placed<'s>(&self, setting: &'s dyn Setting) -> &'s dyn Setting {
        match self.parametrisation {
            Parametrisation::Indexed => setting,
            Parametrisation::Natural => setting.natural().unwrap_or(setting),
        }
    }

    pub(crate) fn of(&self, case: &Case<'_>) -> Result<Outcome, Diagnostic> {
        let Some(setting) = &case.setting else {
            let cap = case.beyond.clone().map(Reason::Cap);
            return Ok(Outcome::Unknown(cap.unwrap_or(Reason::NoLimits)));
        };
        if self.theorem.tried.natural && !case.has_natural_parameters() {
            return Ok(Outcome::Unknown(Reason::NoNaturalParameters));
        }
        let setting = self.placed(&**setting);
        let centred = self.corrected(&Correction::Centred).then(|| setting.centred()).flatten();
        let setting = centred.unwrap_or(setting);
        let settings = settings(self.paper, self.theorem, self.corrections);
        if let Some((value, below)) = &self.theorem.tried.supposes {
            let (value, below) =
                (case.evaluate(value, &[], &settings)?, case.evaluate(below, &[], &settings)?);
            match (value, below) {
                (Ok(value), Ok(below)) if comparable(&value, &below) && value < below => {}
                (Ok(_), Ok(_)) => return Ok(Outcome::Outside(Reason::Hypothesis)),
                (Err(why), _) | (_, Err(why)) => return Ok(Outcome::Unknown(why)),
            }
        }
        let block = match &self.theorem.tried.block {
            None => 1,
            Some(block) => match Self::block(case, block, &settings)? {
                Ok(block) => block,
                Err(why) => return Ok(Outcome::Unknown(why)),
            },
        };
        let settings = self.prepared(case, settings);
        let bound = Bound { trial: self, case, setting, settings: &settings, block };
        match &self.theorem.statement {
            Statement::Bound { quantity, by, from } => bound.of_quantity(*quantity, by, *from),
            Statement::Depth(by) => bound.of_depth(by),
            Statement::Other(_) => Ok(Outcome::Unknown(Reason::NoBound)),
        }
    }

    fn prepared(&self, case: &Case<'_>, settings: Settings) -> Settings {
        match &self.theorem.statement {
            Statement::Bound { by, .. } | Statement::Depth(by) => case.prepared(by, settings),
            Statement::Other(_) => settings,
        }
    }

    /// The proof that the bound as printed holds at all levels in a case; `None` if there is none
    /// of this form.
    pub(crate) fn levels(&self, case: &Case<'_>) -> Result<Option<Levels>, Diagnostic> {
        let Some(setting) = case.setting.as_deref() else { return Ok(None) };
        let settings = &self.prepared(case, Settings::default());
        match &self.theorem.statement {
            Statement::Bound { quantity, by, from } => {
                Bound { trial: self, case, setting, settings, block: 1 }
                    .levels(*quantity, by, *from)
            }
            _ => Ok(None),
        }
    }

    fn block(
        case: &Case<'_>,
        block: &LocatedFormula,
        settings: &Settings,
    ) -> Result<Result<u32, Reason>, Diagnostic> {
        let value = match case.evaluate(block, &[], settings)? {
            Ok(value) => value,
            Err(why) => return Ok(Err(why)),
        };
        let integer = value.as_rational().filter(|value| value.is_integer() && value.sign() > 0);
        let integer = integer.ok_or_else(|| {
            let message = "a constant belongs to an integer number of levels, 1 or more";
            Diagnostic::new(&block.source, block.span.clone(), message)
        })?;
        let levels = integer.numerator().to_i64().and_then(|levels| u32::try_from(levels).ok());
        let beyond = || Cap::new("the number of levels of a constant", u32::MAX.into()).into();
        Ok(levels.ok_or_else(beyond))
    }
}

struct Bound<'t> {
    trial: &'t Trial<'t>,
    case: &'t Case<'t>,
    setting: &'t dyn Setting,
    settings: &'t Settings,
    /// c.
    block: u32,
}

impl Bound<'_> {
    /// The factor of the bound for the levels within a block: T_0 + … + T_{c−1}, with T_0 = 1, if
    /// `AllSteps` corrects a distance, the greatest of these if `Greatest` corrects another
    /// quantity, and 1 otherwise.
    fn contribution(&self, quantity: Quantity) -> Result<RealCyclotomic, Reason> {
        let one = RealCyclotomic::from(Rational::one());
        let within = [Correction::AllSteps, Correction::Greatest];
        if !within.iter().any(|by| self.trial.corrected(by)) {
            return Ok(one);
        }
        let levels =
            (0..self.block).map(|j| if j == 0 { Ok(one.clone()) } else { self.setting.factor(j) });
        let levels = levels.collect::<Result<Vec<RealCyclotomic>, Reason>>()?;
        Ok(match quantity {
            Quantity::Distance => RealCyclotomic::total(&levels),
            _ => levels.into_iter().max().unwrap_or(one),
        })
    }

    /// How many levels count as one level of the printed formula.
    fn stretch(&self) -> u32 {
        if self.trial.corrected(&Correction::Block) { self.block } else { 1 }
    }

    fn of_quantity(
        &self,
        quantity: Quantity,
        by: &LocatedFormula,
        from: u32,
    ) -> Result<Outcome, Diagnostic> {
        if !self.case.is_linear(by, from)? {
            let message = "this bound is not proportional to the spread beta";
            return Err(Diagnostic::new(&by.source, by.span.clone(), message)
                .with_help("a larger polygon has a larger distance: give a multiple of `beta`"));
        }
        let contribution = match self.contribution(quantity) {
            Ok(contribution) => contribution,
            Err(why) => return Ok(Outcome::Unknown(why)),
        };
        let (mut shown, mut gap) = (None, None);
        for level in from..from.saturating_add(self.setting.levels()) {
            let names = [(LEVEL, Rational::from(level / self.stretch()))];
            let bound = match self.case.evaluate(by, &names, self.settings)? {
                Ok(bound) => bound.times(&contribution),
                Err(why) => return Ok(Outcome::Unknown(why)),
            };
            if bound.sign() < 0 {
                return Ok(Outcome::Unknown(Reason::NegativeBound(level)));
            }
            match self.setting.compare(quantity, level, &bound) {
                Ok(Comparison::Within) if gap.is_none() => shown = Some(level),
                Ok(Comparison::Within) => {}
                Ok(Comparison::Exceeds(attained)) => {
                    let violation = Violation { quantity, level, attained, bound };
                    return Ok(Outcome::Refuted(Box::new(violation)));
                }
                Ok(Comparison::Undecided(_)) => {
                    gap = gap.or(Some(Reason::Undecided(level)));
                }
                Err(why) => {
                    gap = gap.or(Some(why));
                    break;
                }
            }
        }
        let Some(last) = shown else {
            return Ok(Outcome::Unknown(gap.unwrap_or(Reason::Unsaid)));
        };
        let proved = self.all_levels(by, last - from + 1)?;
        Ok(proved.map_or(Outcome::UpTo(last), |_| Outcome::Proved))
    }

    /// The growth of a bound, and a number j of its periods with T_c ≤ ratio^j, where c ≤ `levels`
    /// is the number of levels of j periods. The bound then holds at all levels if it holds at its
    /// first c. `None` if there is no such j.
    ///
    /// Source: `proofs/THEOREMS.md`, 40.
    fn all_levels(
        &self,
        by: &LocatedFormula,
        levels: u32,
    ) -> Result<Option<(Growth, u32)>, Diagnostic> {
        let growth = growth(self.case, by, self.settings)?.filter(|growth| growth.spreads == 1);
        let Some(growth) = growth else { return Ok(None) };
        for times in 1.. {
            let period = growth.period * self.stretch() * times;
            if period > levels {
                return Ok(None);
            }
            let Ok(factor) = self.setting.factor(period) else { return Ok(None) };
            let ratio = growth.power(times);
            if comparable(&factor, &ratio) && factor <= ratio {
                return Ok(Some((growth, times)));
            }
        }
        Ok(None)
    }

    /// The proof that a bound holds at all levels.
    fn levels(
        &self,
        quantity: Quantity,
        by: &LocatedFormula,
        from: u32,
    ) -> Result<Option<Levels>, Diagnostic> {
        let all = self.all_levels(by, self.setting.levels())?;
        let Some((Growth { period, ratio, .. }, times)) = all else { return Ok(None) };
        let mut bounds = Vec::new();
        for level in from..from.saturating_add(period * times) {
            let names = [(LEVEL, Rational::from(level))];
            let Ok(bound) = self.case.evaluate(by, &names, self.settings)? else { return Ok(None) };
            bounds.push((level, bound));
        }
        let evidence = self.setting.evidence(quantity, &bounds);
        Ok(Some(Levels { period, ratio, times, evidence }))
    }

    /// Looks for a tolerance that the depth does not meet. It is taken slightly below an attained
    /// distance, and is simple; the greater the tolerance, the fewer levels the formula asks for.
    fn of_depth(&self, by: &LocatedFormula) -> Result<Outcome, Diagnostic> {
        let quantity = Quantity::Distance;
        let contribution = match self.contribution(quantity) {
            Ok(contribution) => contribution,
            Err(why) => return Ok(Outcome::Unknown(why)),
        };
        let (mut shown, mut negative) = (None, false);
        for level in 0..self.setting.levels() {
            for parts in PARTS {
                let supremum = match self.setting.supremum(quantity, level, parts) {
                    Ok(supremum) => supremum,
                    Err(why) if shown.is_none() => return Ok(Outcome::Unknown(why)),
                    Err(_) => {
                        return Ok(shown.map_or(Outcome::Unknown(Reason::Unsaid), Outcome::UpTo));
                    }
                };
                let Some(tolerance) = slightly_less(&supremum.lower) else { break };
                match self.asked(by, &tolerance, &contribution, level)? {
                    Err(why) => return Ok(Outcome::Unknown(why)),
                    Ok(Asked::Reached) => {
                        let bound = RealCyclotomic::from(tolerance);
                        if let Ok(Comparison::Exceeds(attained)) =
                            self.setting.compare(quantity, level, &bound)
                        {
                            let violation = Violation { quantity, level, attained, bound };
                            return Ok(Outcome::Refuted(Box::new(violation)));
                        }
                    }
                    Ok(Asked::Negative) => negative = true,
                    Ok(Asked::More) => {}
                }
                // If the formula does not promise even a tolerance above the supremum at this
                // level, it promises none below the supremum.
                let above = supremum.upper.map(|upper| upper.enclosure(0).upper().clone());
                let possible = match above {
                    Some(above) => self.asked(by, &above, &contribution, level)?,
                    None => Ok(Asked::Reached),
                };
                if possible != Ok(Asked::Reached) {
                    break;
                }
            }
            shown = Some(level);
        }
        if negative {
            return Ok(Outcome::Unknown(Reason::NegativeDepth));
        }
        Ok(shown.map_or_else(|| Outcome::Unknown(Reason::NoDistance), Outcome::UpTo))
    }

    /// Whether the formula says that this level is deep enough for the tolerance.
    fn asked(
        &self,
        by: &LocatedFormula,
        tolerance: &Rational,
        contribution: &RealCyclotomic,
        level: u32,
    ) -> Result<Result<Asked, Reason>, Diagnostic> {
        let asked = &RealCyclotomic::from(tolerance.clone()) / contribution;
        let Some(asked) = asked.as_rational().cloned().or_else(|| slightly_less(&asked)) else {
            return Ok(Ok(Asked::More));
        };
        let depth = self.case.evaluate(by, &[(TOLERANCE, asked)], self.settings)?;
        Ok(depth.map(|depth| {
            let levels = depth.times(&RealCyclotomic::from(self.stretch()));
            if levels.sign() < 0 {
                Asked::Negative
            } else if levels <= RealCyclotomic::from(level) {
                Asked::Reached
            } else {
                Asked::More
            }
        }))
    }
}

/// The number of levels that a formula asks for, against a level.
#[derive(PartialEq, Eq)]
enum Asked {
    /// It asks for this level or an earlier one.
    Reached,
    /// It asks for more levels.
    More,
    /// A negative number presupposes something that does not hold, such as a constant below 1.
    Negative,
}

/// The precisions of the enclosures of a distance below which a tolerance is sought, as parts of
/// it, tried one after the other.
const PARTS: [u32; 3] = [4, 32, 256];
