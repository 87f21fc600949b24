//! The readings of one table, and the choices in which they may differ.

use crate::claim::{Cell, Printed};
use crate::evaluation::choices::{BEST_OFFSET, DECIMAL_ROUNDING, FAMILY, FORWARD, ORDER};
use crate::evaluation::context::CellReading;
use crate::evaluation::settings::Settings;
use crate::evaluation::table::Evaluator;
use crate::evaluation::{Choice, Copied, Effect, Way};
use crate::finding::{CellFinding, CellKind, MAX_DIFFERENCES, Values};
use crate::judge::reading::copied::sources;
use crate::judge::reading::scale::Scale;
use std::collections::BTreeSet;

/// The printed cells of this kind.
pub(crate) fn printed<'a>(
    judge: &Evaluator<'a>,
    findings: &[Vec<CellFinding>],
    kind: CellKind,
) -> PrintedCells<'a> {
    let cell = |(cell, finding): (&'a Cell, &CellFinding)| match cell {
        Cell::Printed(printed) if kind.holds(finding) => Some(printed),
        _ => None,
    };
    let rows = judge.table.cells.iter().zip(findings);
    rows.map(|(row, findings)| row.iter().zip(findings).map(cell).collect()).collect()
}

/// The most readings of one table.
const MAX_READINGS: usize = 4_096;

/// The most values of cells under all readings together; of a larger table, readings with fewer
/// differences are compared.
const MAX_VALUES: usize = 100_000;

/// The most differences from the printed text of a reading that takes a quantity from another
/// place; this quantity is one of them.
const MAX_WITH_COPIED: usize = 3;

/// The functions that take the order of masks.
const MASK_CONSTANTS: [&str; 3] = ["contraction", "norm", "tensor"];

/// The cells of a table; `None` where one is lost.
pub(crate) type PrintedCells<'a> = Vec<Vec<Option<&'a Printed>>>;

/// The unstated parameters that each cell needs, row by row.
pub(crate) type Needed = Vec<Vec<BTreeSet<String>>>;

/// The unstated parameters that cells with these findings need.
pub(crate) fn needed(findings: &[Vec<CellFinding>]) -> Needed {
    let names = |finding: &CellFinding| {
        let names = finding.assumed.iter().map(|(name, _)| name.clone());
        names.chain(finding.unknown.clone()).collect()
    };
    findings.iter().map(|row| row.iter().map(names).collect()).collect()
}

/// A difference of a reading from the printed text.
#[derive(Clone)]
pub(crate) enum Change {
    /// A choice, and its way.
    Way(&'static Choice, &'static Way),
    /// One of the claim file's alternatives, by its place.
    Definition(usize),
    /// A quantity from another place of the paper.
    Copied(Copied),
}

/// The part of the family that is searched.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Family {
    /// The readings that take nothing from another place of the paper.
    Plain,
    /// Also the readings that do, where the others leave cells unexplained.
    Whole,
    /// As the first; then as the second, if that leaves cells of the table unexplained.
    InTurn,
}

/// Whether a reading takes a quantity from another place of the paper.
pub(crate) fn takes_from_elsewhere(reading: &[Change]) -> bool {
    reading.iter().any(|change| matches!(change, Change::Copied(_)))
}

/// The readings of one table.
pub(crate) struct ReadingSpace<'s> {
    pub(crate) judge: &'s Evaluator<'s>,
    pub(crate) printed: &'s PrintedCells<'s>,
    /// The unstated parameters that some cell needs.
    pub(crate) assume: BTreeSet<String>,
    /// The unstated parameters that each cell needs, row by row.
    needed: Needed,
    /// The unstated parameter that is solved for, if there is one.
    pub(crate) unknown: Option<&'s str>,
    /// The values by the printed definition.
    pub(crate) as_printed: Values,
    /// The parameter to which the values are proportional, if there is one.
    pub(crate) scale: Option<Scale>,
    /// For each choice, the ways other than the printed one.
    pub(crate) changes: Vec<Vec<Change>>,
    /// The printed order of masks, if the value depends on one.
    order: Option<String>,
}

impl<'s> ReadingSpace<'s> {
    /// Whether a cell needs an unstated parameter.
    pub(crate) fn needs_name(&self, row: usize, column: usize, name: &str) -> bool {
        self.needed[row][column].contains(name)
    }

    /// The unstated parameters that the printed cells need which need this one.
    pub(crate) fn needed_with(&self, name: &str) -> BTreeSet<String> {
        let cells = self.needed.iter().flatten().zip(self.printed.iter().flatten());
        let cells = cells.filter(|(names, printed)| printed.is_some() && names.contains(name));
        cells.flat_map(|(names, _)| names).cloned().collect()
    }

    pub(crate) fn new(
        judge: &'s Evaluator<'s>,
        needed: Needed,
        printed: &'s PrintedCells<'s>,
        unknown: Option<&'s str>,
    ) -> Option<ReadingSpace<'s>> {
        let of_printed = needed.iter().flatten().zip(printed.iter().flatten());
        let of_printed = of_printed.filter(|(_, printed)| printed.is_some());
        let assume = of_printed.flat_map(|(names, _)| names).cloned().collect();
        let settings = Settings::default();
        let (as_printed, scale, changes) = (Values::new(), None, Vec::new());
        let mut space = ReadingSpace {
            judge,
            printed,
            assume,
            needed,
            unknown,
            as_printed,
            scale,
            changes,
            order: None,
        };
        space.as_printed = space.values(&settings);
        let mut consulted = settings.consulted();
        consulted.extend(judge.rows.choices.clone());
        space.order = consulted.get(ORDER.key).cloned();
        // The best offset is a reading of masks that stand in the file without one.
        let unstated = judge.paper.without_offset(judge.table).next().is_some();
        for choice in FAMILY {
            let ways = choice.ways.iter();
            let ways: Vec<Change> = match choice.effect {
                Effect::Option { .. } => match consulted.get(choice.key) {
                    None => continue,
                    Some(printed) => ways
                        .filter(|way| way.word != printed)
                        .filter(|way| way.word != BEST_OFFSET || unstated)
                        .map(|way| Change::Way(choice, way))
                        .collect(),
                },
                Effect::Header if judge.has_tolerance_headers() => {
                    ways.skip(1).map(|way| Change::Way(choice, way)).collect()
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

    /// A cell under a reading; the parameters that its value as printed needs are assumed.
    pub(crate) fn at<'n>(
        &'n self,
        row: usize,
        column: usize,
        settings: &'n Settings,
    ) -> CellReading<'n> {
        CellReading { row, column, assume: &self.needed[row][column], settings }
    }

    pub(crate) fn is_depth(&self) -> bool {
        self.judge.is_depth()
    }

    /// The names of the choices, definitions and roundings in which the readings may differ.
    pub(crate) fn names(&self) -> Vec<String> {
        let name = |ways: &Vec<Change>| match ways.first()? {
            Change::Way(choice, _) => Some(choice.name.to_owned()),
            Change::Definition(i) => Some(self.judge.paper.alternatives[*i].of.clone()),
            Change::Copied(_) => None,
        };
        let mut names: Vec<String> = self.changes.iter().filter_map(name).collect();
        if !self.is_depth() {
            names.push(DECIMAL_ROUNDING.name.to_owned());
        }
        names
    }

    /// The most differences of a reading: [`MAX_DIFFERENCES`], or as many as keep the number of readings within
    /// bounds.
    pub(crate) fn most_differences(&self) -> usize {
        // How many readings have so many differences.
        let mut counts = [0_usize; MAX_DIFFERENCES + 1];
        counts[0] = 1;
        for ways in &self.changes {
            for differences in (1..counts.len()).rev() {
                let longer = counts[differences - 1].saturating_mul(ways.len());
                counts[differences] = counts[differences].saturating_add(longer);
            }
        }
        let all = counts.iter().scan(0_usize, |all, count| {
            *all = all.saturating_add(*count);
            Some(*all)
        });
        all.take_while(|all| *all <= self.most_readings()).count().saturating_sub(1)
    }

    /// Every combination of at most [`most_differences`](Self::most_differences) changes, those with fewer changes
    /// first; the printed text is the first.
    pub(crate) fn readings(&self) -> Vec<Vec<Change>> {
        let most = self.most_differences();
        let mut readings = vec![Vec::new()];
        for ways in &self.changes {
            let longer: Vec<Vec<Change>> = readings
                .iter()
                .filter(|reading| reading.len() < most)
                .flat_map(|reading| {
                    ways.iter().map(|way| [reading.clone(), vec![way.clone()]].concat())
                })
                .collect();
            readings.extend(longer);
        }
        readings.sort_by_key(Vec::len);
        readings
    }

    /// Every combination of one quantity from another place of the paper and fewer than
    /// [`MAX_WITH_COPIED`] other changes. A tolerance that was computed is not combined with
    /// another rounding of tolerances, and other numbers of the points only with masks that are read
    /// forwards. Empty if there are too many readings.
    pub(crate) fn copied_readings(&self) -> Vec<Vec<Change>> {
        let others = self.readings();
        let numbers = (1..self.arity()).map(|first| Copied::Numbers { first });
        let is_tolerance = |change: &Change| matches!(change, Change::Way(choice, _) if choice.effect == Effect::Header);
        let mut readings = Vec::new();
        for source in sources(self.judge).into_iter().chain(numbers) {
            let fits = |other: &&Vec<Change>| {
                other.len() < MAX_WITH_COPIED
                    && match source {
                        Copied::Tolerance { .. } => !other.iter().any(is_tolerance),
                        Copied::Numbers { .. } => self.is_forward(other),
                        _ => true,
                    }
            };
            let copied = Change::Copied(source.clone());
            let with = |other: &Vec<Change>| [other.clone(), vec![copied.clone()]].concat();
            readings.extend(others.iter().filter(fits).map(with));
        }
        readings.sort_by_key(Vec::len);
        let all = others.len() + readings.len();
        if all > self.most_readings() { Vec::new() } else { readings }
    }

    /// As [`copied_readings`](Self::copied_readings), those with other numbers of the points only.
    pub(crate) fn numbered_readings(&self) -> Vec<Vec<Change>> {
        let mut readings = self.copied_readings();
        let numbers = |change: &Change| matches!(change, Change::Copied(Copied::Numbers { .. }));
        readings.retain(|reading| reading.iter().any(numbers));
        readings
    }

    /// Whether masks are read forwards under a reading.
    fn is_forward(&self, reading: &[Change]) -> bool {
        let order = reading.iter().find_map(|change| match change {
            Change::Way(choice, way) if choice.key == ORDER.key => Some(way.word),
            _ => None,
        });
        order.or(self.order.as_deref()) == Some(FORWARD)
    }

    /// The greatest arity of the schemes of the printed cells, if the value leads to constants of
    /// masks that have an order; otherwise 0.
    fn arity(&self) -> usize {
        let (table, paper) = (self.judge.table, self.judge.paper);
        let led = paper.definitions_in(&table.value).into_values();
        let mut formulas = [&table.value].into_iter().chain(led);
        let calls = |name: &&str| MASK_CONSTANTS.contains(name);
        if self.order.is_none() || !formulas.any(|one| one.expr.functions().iter().any(calls)) {
            return 0;
        }
        let settings = Settings::default();
        let of = |row: usize, column: usize| {
            self.printed[row][column]?;
            let quantities = self.judge.quantities(self.at(row, column, &settings)).ok()?.ok()?;
            let constants = quantities.scheme?.constants;
            constants.iter().map(|axis| axis.mask().arity()).max()
        };
        let cells = (0..self.printed.len())
            .flat_map(|row| (0..self.printed[row].len()).map(move |column| (row, column)));
        cells.filter_map(|(row, column)| of(row, column)).max().unwrap_or(0)
    }

    /// The most readings that are compared.
    fn most_readings(&self) -> usize {
        let cells = self.printed.iter().map(Vec::len).sum::<usize>().max(1);
        MAX_READINGS.min(MAX_VALUES / cells).max(1)
    }

    pub(crate) fn settings(&self, reading: &[Change]) -> Settings {
        let words = reading.iter().filter_map(|change| match change {
            Change::Way(choice, way) => Some((choice.key, way.word)),
            Change::Definition(_) | Change::Copied(_) => None,
        });
        let mut settings = Settings::new(words.collect());
        let paper = self.judge.paper;
        for change in reading {
            match change {
                Change::Definition(i) => {
                    settings.replace(&paper.definitions, *i, &paper.alternatives[*i]);
                }
                Change::Copied(Copied::Numbers { first }) => settings.first = *first,
                Change::Copied(source) => settings.copied = Some(source.clone()),
                Change::Way(..) => {}
            }
        }
        settings
    }
}
