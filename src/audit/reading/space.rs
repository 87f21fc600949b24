//! The readings of one table: what they may change, and what they give.

use super::choice::{Choice, Effect};
use super::choices::{DECIMAL_ROUNDING, FAMILY};
use super::consistent::DecimalRounding;
use super::scale::{Solved, is_simple, simplest, solve};
use super::search::{Difference, Explanation, MAX_DIFFERENCES};
use super::settings::Settings;
use crate::audit::finding::CellFinding;
use crate::audit::table::{At, Judge, Outcome};
use crate::claim::{Printed, Promise};
use crate::exact::{Rational, RealCyclotomic};
use std::collections::BTreeSet;

/// The most readings of one table.
const MAX_READINGS: usize = 4_096;

/// The cells of a table; `None` where one is lost.
pub(super) type PrintedCells<'a> = Vec<Vec<Option<&'a Printed>>>;

/// The exact values of the cells.
pub(super) type Values = Vec<Vec<Option<RealCyclotomic>>>;

/// A way of a choice other than the printed one.
#[derive(Clone)]
pub(super) enum Change {
    /// A choice, its word and what that says.
    Word(&'static Choice, &'static str, &'static str),
    /// One of the claim file's alternatives, by its place.
    Definition(usize),
}

/// A parameter that the values of a table are proportional to.
struct Scale {
    name: String,
    /// Its stated or assumed value.
    base: Rational,
    stated: bool,
}

/// The readings of one table.
pub(super) struct Space<'s> {
    judge: &'s Judge<'s>,
    printed: &'s PrintedCells<'s>,
    /// The parameters that have to be assumed.
    assume: BTreeSet<String>,
    /// The parameter that the values are proportional to.
    scale: Option<Scale>,
    /// For each choice, the ways other than the printed one.
    changes: Vec<Vec<Change>>,
}

impl<'s> Space<'s> {
    pub(super) fn new(
        judge: &'s Judge<'s>,
        findings: &[Vec<CellFinding>],
        printed: &'s PrintedCells<'s>,
    ) -> Option<Space<'s>> {
        let all = findings.iter().flatten().filter(|finding| finding.printed.is_some());
        let assume: BTreeSet<String> =
            all.flat_map(|finding| finding.assumed.iter().map(|(name, _)| name.clone())).collect();
        let settings = Settings::default();
        let mut space = Space { judge, printed, assume, scale: None, changes: Vec::new() };
        space.all_values(&settings);
        let mut consulted = settings.consulted();
        consulted.extend(judge.rows.choices.clone());
        for choice in FAMILY {
            let ways = choice.ways.iter();
            let ways: Vec<Change> = match choice.effect {
                Effect::Option { .. } => match consulted.get(choice.name) {
                    None => continue,
                    Some(printed) => ways
                        .filter(|way| way.word != printed)
                        .map(|way| Change::Word(choice, way.word, way.says))
                        .collect(),
                },
                Effect::Header if judge.has_tolerance_headers() => {
                    ways.skip(1).map(|way| Change::Word(choice, way.word, way.says)).collect()
                }
                // The roundings of decimals are compared on the same values.
                Effect::Header | Effect::Decimal => continue,
            };
            space.changes.push(ways);
        }
        let alternatives = &judge.paper.alternatives;
        let used = judge.paper.definitions_in(&judge.table.value);
        let names: BTreeSet<&String> = alternatives.iter().map(|other| &other.of).collect();
        for name in names.into_iter().filter(|name| used.contains_key(name.as_str())) {
            let ways = (0..alternatives.len()).filter(|&i| alternatives[i].of == *name);
            space.changes.push(ways.map(Change::Definition).collect());
        }
        space.scale = space.find_scale();
        printed.iter().flatten().any(Option::is_some).then_some(space)
    }

    pub(super) fn is_depth(&self) -> bool {
        matches!(self.judge.table.promise, Some(Promise::Depth { .. }))
    }

    /// The names of what the readings differ in.
    pub(super) fn names(&self) -> Vec<String> {
        let name = |ways: &Vec<Change>| match ways.first()? {
            Change::Word(choice, ..) => Some(choice.name.to_owned()),
            Change::Definition(i) => Some(self.judge.paper.alternatives[*i].of.clone()),
        };
        let mut names: Vec<String> = self.changes.iter().filter_map(name).collect();
        if !self.is_depth() {
            names.push(DECIMAL_ROUNDING.name.to_owned());
        }
        names
    }

    /// Every combination of at most [`MAX_DIFFERENCES`] changes, the printed text
    /// first.
    pub(super) fn readings(&self) -> Vec<Vec<Change>> {
        let mut readings = vec![Vec::new()];
        for ways in &self.changes {
            let longer: Vec<Vec<Change>> = readings
                .iter()
                .filter(|reading| reading.len() < MAX_DIFFERENCES)
                .flat_map(|reading| {
                    ways.iter().map(|way| [reading.clone(), vec![way.clone()]].concat())
                })
                .collect();
            readings.extend(longer);
        }
        readings.sort_by_key(Vec::len);
        readings.truncate(MAX_READINGS);
        readings
    }

    pub(super) fn settings(&self, reading: &[Change]) -> Settings {
        let words = reading.iter().filter_map(|change| match change {
            Change::Word(choice, word, _) => Some((choice.name, *word)),
            Change::Definition(_) => None,
        });
        let mut settings = Settings::new(words.collect());
        let Judge { paper, .. } = self.judge;
        for change in reading {
            if let Change::Definition(i) = change {
                settings.replace(&paper.definitions, *i, &paper.alternatives[*i]);
            }
        }
        settings
    }

    /// The exact values of the printed cells, where the formula has one under the
    /// reading; `None` when it is clear that fewer than `least` cells are explained.
    pub(super) fn values(&self, settings: &Settings, least: usize) -> Option<Values> {
        let mut possible = self.printed.iter().flatten().flatten().count();
        let mut values = Vec::with_capacity(self.printed.len());
        for (row, printed) in self.printed.iter().enumerate() {
            let mut row_values = Vec::with_capacity(printed.len());
            for (column, printed) in printed.iter().enumerate() {
                let at = At { row, column, assume: &self.assume, settings };
                let value = printed.and_then(|_| self.value(at));
                let Some(printed) = printed else {
                    row_values.push(None);
                    continue;
                };
                let gives = |value: &RealCyclotomic| {
                    let mut all = DecimalRounding::ALL.iter();
                    all.any(|(_, way)| way.gives(&printed.decimal, value))
                };
                // With a scale to be solved for, nothing is known yet.
                if self.scale.is_none() && !value.as_ref().is_some_and(gives) {
                    possible -= 1;
                }
                if possible < least {
                    return None;
                }
                row_values.push(value);
            }
            values.push(row_values);
        }
        Some(values)
    }

    /// How many cells a reading has to explain at least to be as good as another.
    pub(super) fn least(&self, best: &Explanation, reading: &[Change]) -> usize {
        best.count() + usize::from(reading.len() > best.differences.len())
    }

    fn value(&self, at: At<'_>) -> Option<RealCyclotomic> {
        match self.judge.evaluate(&self.judge.table.value, at) {
            Ok(Outcome::Value(value)) => Some(value),
            _ => None,
        }
    }

    /// The parameter that every value is proportional to: the only assumed one, or,
    /// where nothing is assumed, a stated one.
    fn find_scale(&self) -> Option<Scale> {
        let Judge { given, assumed, .. } = self.judge;
        let (stated, from) = if self.assume.is_empty() { (true, given) } else { (false, assumed) };
        if self.is_depth() || self.assume.len() > 1 {
            return None;
        }
        let candidates = from.iter().filter(|(name, _)| stated || self.assume.contains(*name));
        let mut scales =
            candidates.map(|(name, base)| Scale { name: name.clone(), base: base.clone(), stated });
        scales.find(|scale| self.is_scale(scale))
    }

    fn is_scale(&self, scale: &Scale) -> bool {
        if scale.base.is_zero() {
            return false;
        }
        let mut double = Settings::default();
        double.parameters.insert(scale.name.clone(), &scale.base + &scale.base);
        let (once, twice) = (self.all_values(&Settings::default()), self.all_values(&double));
        let pairs = once.iter().flatten().zip(twice.iter().flatten());
        pairs.into_iter().all(|(once, twice)| match (once, twice) {
            (Some(once), Some(twice)) => &(once + once) == twice,
            (None, None) => true,
            _ => false,
        })
    }

    /// How many cells the printed definition explains.
    pub(super) fn as_printed(&self) -> usize {
        let values = self.all_values(&Settings::default());
        let pairs = self.printed.iter().flatten().zip(values.iter().flatten());
        let gives = |(printed, value): (&Option<&Printed>, &Option<RealCyclotomic>)| {
            let (Some(printed), Some(value)) = (printed, value) else { return false };
            DecimalRounding::Nearest.gives(&printed.decimal, value)
        };
        pairs.filter(|pair| gives(*pair)).count()
    }

    fn all_values(&self, settings: &Settings) -> Values {
        self.values(settings, 0).unwrap_or_default()
    }

    /// The roundings of decimals that go with a reading.
    pub(super) fn roundings(&self, reading: &[Change]) -> Vec<DecimalRounding> {
        let one = self.is_depth() || reading.len() == MAX_DIFFERENCES;
        let all = DecimalRounding::ALL.iter().map(|(_, way)| *way);
        all.take(if one { 1 } else { DecimalRounding::ALL.len() }).collect()
    }

    /// What a reading explains: with the scale solved for, where there is one, and,
    /// where it is stated, also as it is stated.
    pub(super) fn explain(
        &self,
        reading: &[Change],
        rounding: DecimalRounding,
        values: &Values,
    ) -> Vec<Explanation> {
        let Some(scale) = &self.scale else {
            return vec![self.explanation(reading, rounding, values.clone(), None)];
        };
        let solved = self.solve(scale, values, rounding);
        let solved = solved.filter(|solved| !scale.stated || solved.simplest != scale.base);
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
            otherwise = scale.stated.then(|| Difference {
                choice: scale.name.clone(),
                says: format!(
                    "{} = {}, where {} is stated",
                    scale.name, solved.simplest, scale.base
                ),
            });
        }
        let explained = self.printed.iter().zip(&values).map(|(printed, values)| {
            let pairs = printed.iter().zip(values);
            let gives = |(printed, value): (&Option<&Printed>, &Option<RealCyclotomic>)| {
                let (Some(printed), Some(value)) = (printed, value) else { return false };
                rounding.gives(&printed.decimal, value)
            };
            pairs.map(gives).collect()
        });
        let explained = explained.collect();
        let changes = reading.iter().map(|change| self.difference(change));
        let differences = changes.chain(rounding.difference()).chain(otherwise).collect();
        Explanation { differences, solved: solved.into_iter().collect(), values, explained }
    }

    fn difference(&self, change: &Change) -> Difference {
        let (choice, says) = match change {
            Change::Word(choice, _, says) => (choice.name, *says),
            Change::Definition(i) => {
                let other = &self.judge.paper.alternatives[*i];
                (other.of.as_str(), other.label.as_str())
            }
        };
        Difference { choice: choice.to_owned(), says: says.to_owned() }
    }

    fn solve(&self, scale: &Scale, values: &Values, rounding: DecimalRounding) -> Option<Solved> {
        let cells = self.printed.iter().flatten().zip(values.iter().flatten());
        let cells: Vec<(&Printed, &RealCyclotomic)> =
            cells.filter_map(|(printed, value)| Some(((*printed)?, value.as_ref()?))).collect();
        let (low, high) = solve(&cells, rounding)?;
        if scale.base.sign() < 0 {
            return None;
        }
        let between = (low * &scale.base, high * &scale.base);
        let simplest = simplest(&between.0, &between.1, rounding);
        let chosen = is_simple(&simplest);
        chosen.then(|| Solved { name: scale.name.clone(), between, simplest })
    }
}
