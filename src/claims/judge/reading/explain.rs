//! The values of a table's cells under its readings, and which cells these explain.

use crate::claim::{Alternative, Printed};
use crate::evaluation::context::{CellReading, Outcome};
use crate::evaluation::settings::Settings;
use crate::exact::{Rational, RealCyclotomic};
use crate::finding::{Difference, Explanation, MAX_DIFFERENCES, Solved, Values};
use crate::judge::reading::consistent::DecimalRounding;
use crate::judge::reading::scale::{Scale, solve};
use crate::judge::reading::space::{Change, ReadingSpace};

impl ReadingSpace<'_> {
    /// The exact values of the printed cells, where the formula has one under the
    /// reading.
    pub(crate) fn values(&self, settings: &Settings) -> Values {
        let rows = self.printed.iter().enumerate().map(|(row, printed)| {
            let value = |(column, printed): (usize, Option<&Printed>)| {
                printed.and_then(|_| self.value(self.at(row, column, settings)))
            };
            printed.iter().copied().enumerate().map(value).collect()
        });
        rows.collect()
    }

    pub(crate) fn value(&self, at: CellReading<'_>) -> Option<RealCyclotomic> {
        match self.judge.evaluate(&self.judge.table.value, at) {
            Ok(Outcome::Value(value)) => Some(value),
            _ => None,
        }
    }

    /// The parameter that every value is proportional to: the one that is solved for, or,
    /// where every parameter is stated, a stated one.
    pub(crate) fn find_scale(&self) -> Option<Scale> {
        let stated = self.unknown.is_none();
        let from = if stated { &self.judge.given } else { &self.judge.assumed };
        if self.is_depth() || stated && !self.assume.is_empty() {
            return None;
        }
        let candidates = from.iter().filter(|(name, _)| stated || self.unknown == Some(name));
        let mut scales =
            candidates.map(|(name, base)| Scale { name: name.clone(), base: base.clone(), stated });
        let printed = Settings::default();
        let any = self.as_printed.iter().flatten().flatten().any(|value| value.sign() != 0);
        scales.find(|scale| {
            any && scale.base.sign() > 0 && self.is_scale(scale, &self.as_printed, &printed)
        })
    }

    /// Whether the values of a reading are proportional to the scale: its form shows it, and at two
    /// and three times the scale the values are two and three times as large.
    pub(crate) fn is_scale(&self, scale: &Scale, values: &Values, settings: &Settings) -> bool {
        self.is_proportional(&scale.name, settings)
            && [2, 3].map(Rational::from).iter().all(|times| {
                let settings = settings.with_parameter(&scale.name, &(&scale.base * times));
                let (scaled, times) = (self.values(&settings), RealCyclotomic::from(times.clone()));
                let mut pairs = values.iter().flatten().zip(scaled.iter().flatten());
                pairs.all(|pair| match pair {
                    (Some(once), Some(scaled)) => once * &times == *scaled,
                    (None, None) => true,
                    _ => false,
                })
            })
    }

    /// Which cells the printed definition explains.
    pub(crate) fn explained_as_printed(&self) -> Vec<Vec<bool>> {
        self.explained(&self.as_printed, DecimalRounding::Nearest)
    }

    /// Which printed numbers these values round to.
    pub(crate) fn explained(&self, values: &Values, rounding: DecimalRounding) -> Vec<Vec<bool>> {
        let rows = self.printed.iter().zip(values);
        let gives = |(printed, value): (Option<&Printed>, &Option<RealCyclotomic>)| {
            let cell = printed.zip(value.as_ref());
            cell.is_some_and(|(printed, value)| rounding.gives(&printed.decimal, value))
        };
        rows.map(|(printed, values)| printed.iter().copied().zip(values).map(gives).collect())
            .collect()
    }

    /// The roundings of decimals that go with a reading.
    pub(crate) fn roundings(&self, reading: &[Change]) -> Vec<DecimalRounding> {
        let one = self.is_depth() || reading.len() == MAX_DIFFERENCES;
        let all = DecimalRounding::ALL.iter().map(|(_, way)| *way);
        all.take(if one { 1 } else { DecimalRounding::ALL.len() }).collect()
    }

    /// The explanations by a reading. If its values are proportional to the scale, the scale is
    /// solved for. If the scale is stated, or cannot be solved for, there is also the explanation
    /// without another scale.
    pub(crate) fn explain(
        &self,
        reading: &[Change],
        rounding: DecimalRounding,
        values: &Values,
        proportional: &impl Fn(&Scale) -> bool,
    ) -> Vec<Explanation> {
        let Some(scale) = &self.scale else {
            return vec![self.explanation(reading, rounding, values.clone(), None)];
        };
        let solved = self.solve(scale, values, rounding);
        let solved = solved.filter(|solved| !scale.stated || solved.simplest != scale.base);
        let solved = solved.filter(|_| proportional(scale));
        let as_it_is = (scale.stated || solved.is_none()).then_some(None);
        let variants = as_it_is.into_iter().chain(solved.map(Some));
        variants.map(|solved| self.explanation(reading, rounding, values.clone(), solved)).collect()
    }

    fn explanation(
        &self,
        reading: &[Change],
        rounding: DecimalRounding,
        mut values: Values,
        solved: Option<Solved>,
    ) -> Explanation {
        let mut otherwise = None;
        if let (Some(solved), Some(scale)) = (&solved, &self.scale) {
            let factor = RealCyclotomic::from(&solved.simplest / &scale.base);
            for value in values.iter_mut().flatten().flatten() {
                *value = &*value * &factor;
            }
            otherwise = scale.stated.then(|| Difference::Scale {
                name: scale.name.clone(),
                value: solved.simplest.clone(),
                stated: scale.base.clone(),
            });
        }
        let explained = self.explained(&values, rounding);
        let changes = reading.iter().map(|change| self.difference(change));
        let differences = changes.chain(rounding.difference()).chain(otherwise).collect();
        Explanation { differences, solved: solved.into_iter().collect(), values, explained }
    }

    /// The differences of a reading from the printed text, without its rounding of decimals.
    pub(crate) fn differences(&self, reading: &[Change]) -> Vec<Difference> {
        reading.iter().map(|change| self.difference(change)).collect()
    }

    pub(crate) fn difference(&self, change: &Change) -> Difference {
        match change {
            Change::Way(choice, way) => Difference::Way(choice, way),
            Change::Definition(i) => {
                let alternatives = &self.judge.paper.alternatives;
                let Alternative { of, label, .. } = &alternatives[*i];
                let number = alternatives[..=*i].iter().filter(|other| other.of == *of).count();
                Difference::Alternative { of: of.clone(), number, label: label.clone() }
            }
            Change::Copied(source) => Difference::Copied(source.clone()),
        }
    }

    fn solve(&self, scale: &Scale, values: &Values, rounding: DecimalRounding) -> Option<Solved> {
        let cells = self.printed.iter().flatten().zip(values.iter().flatten());
        let cells: Vec<(&Printed, &RealCyclotomic)> =
            cells.filter_map(|(printed, value)| Some(((*printed)?, value.as_ref()?))).collect();
        let (simplest, between) = solve(&cells, &scale.base, rounding)?;
        Some(Solved { name: scale.name.clone(), between, simplest })
    }
}
