//! Readings of tables: what they differ in, and what they explain.

use crate::cap::Cap;
use crate::evaluation::{Choice, Copied, Way};
use crate::exact::{Rational, RealCyclotomic};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// The exact values of the cells of a table, by row.
pub(crate) type Values = Vec<Vec<Option<RealCyclotomic>>>;

/// A row or a column, counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Line {
    /// A row.
    Row(usize),
    /// A column.
    Column(usize),
}

impl Line {
    pub(crate) fn holds(self, row: usize, column: usize) -> bool {
        match self {
            Line::Row(place) => place == row,
            Line::Column(place) => place == column,
        }
    }
}

/// The reading of the cells of a row or column that no reading of the whole table
/// explains.
#[derive(Clone, Debug)]
pub struct LineReading {
    /// The row or column.
    pub line: Line,
    /// How many of its cells the reading of the whole table leaves unexplained.
    pub cells: usize,
    /// Where the values stand that are printed in it: (0, 0) in place, (0, 1) in the
    /// next column, (1, 0) in the next row.
    pub shift: (i32, i32),
    /// How many readings were compared, over all rows and columns, as [`Search::tried`](super::Search::tried)
    /// counts them.
    pub tried: usize,
    /// The reading, of equally good ones the first.
    pub best: Explanation,
    /// An upper bound of how many readings would explain as many cells by luck.
    pub chance: Rational,
    /// How many cells each way of each choice explains.
    pub needs: Vec<WayCounts>,
}

/// A choice, and how many cells each of its ways explains at most.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WayCounts {
    /// The choice, or the definition.
    pub about: String,
    /// Each way, with the number of cells that some reading with it explains; `None` is a definition,
    /// or a tolerance, as printed.
    pub ways: BTreeMap<Option<Difference>, usize>,
}

impl WayCounts {
    /// How many cells the best way explains.
    #[must_use]
    pub fn most(&self) -> usize {
        self.ways.values().copied().max().unwrap_or(0)
    }

    /// The ways that explain as many cells as the best one, but for `lost` at most.
    #[must_use]
    pub fn suitable(&self, lost: usize) -> Vec<Option<&Difference>> {
        let least = self.most().saturating_sub(lost);
        let suits = self.ways.iter().filter(|(_, count)| **count >= least);
        suits.map(|(way, _)| way.as_ref()).collect()
    }
}

/// A parameter that the paper does not state, with the values that the printed numbers allow.
#[derive(Clone, Debug, PartialEq)]
pub struct Solved {
    /// Its name.
    pub name: String,
    /// The ends, up to about 2^−60, of the interval of values with which every explained cell is
    /// consistent.
    pub between: (Rational, Rational),
    /// The plainest number among them.
    pub simplest: Rational,
}

/// The most differences from the printed text that a reading may have.
pub const MAX_DIFFERENCES: usize = 4;

/// The name, in the list of what readings differ in, of quantities from another place of a paper.
pub(crate) const COPIED: &str = "a quantity from another place of the paper";

/// A respect in which a reading differs from the printed text.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Difference {
    /// A choice is made in this way.
    Way(&'static Choice, &'static Way),
    /// An alternative stands for a definition.
    Alternative {
        /// The definition.
        of: String,
        /// The number of the alternative among those of this definition, from 1.
        number: usize,
        /// What the claim file calls it.
        label: String,
    },
    /// A quantity is taken from another place of the paper.
    Copied(Copied),
    /// A stated parameter has another value.
    Scale {
        /// The parameter.
        name: String,
        /// Its value.
        value: Rational,
        /// The value that is stated.
        stated: Rational,
    },
}

impl Difference {
    /// Whether it is a quantity from another place of the paper.
    #[must_use]
    pub fn is_copied(&self) -> bool {
        matches!(self, Difference::Copied(_))
    }

    /// Whether it may bring a constant that fits by luck: all do but the ways of choices, which are few, and the same for
    /// every paper.
    pub(crate) fn brings_constants(&self) -> bool {
        match self {
            Difference::Way(..) => false,
            Difference::Alternative { .. } | Difference::Copied(_) | Difference::Scale { .. } => {
                true
            }
        }
    }

    /// The name of the choice, the definition or the parameter; all quantities from another place
    /// have one name.
    #[must_use]
    pub fn about(&self) -> &str {
        match self {
            Difference::Way(choice, _) => choice.name,
            Difference::Alternative { of: name, .. } | Difference::Scale { name, .. } => name,
            Difference::Copied(_) => COPIED,
        }
    }

    /// The value of the parameter, where the difference is one.
    #[must_use]
    pub fn value(&self) -> Option<&Rational> {
        match self {
            Difference::Scale { value, .. } => Some(value),
            Difference::Way(..) | Difference::Alternative { .. } | Difference::Copied(_) => None,
        }
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Difference::Way(_, way) => f.write_str(way.says),
            Difference::Alternative { label, .. } => f.write_str(label),
            Difference::Copied(Copied::Printed { of, locus, .. }) => {
                write!(f, "{of} as {locus} prints it")
            }
            Difference::Copied(Copied::Parameter { of, name, value }) => {
                write!(f, "{of} at {name} = {value}")
            }
            Difference::Copied(Copied::Scheme { of, scheme, .. }) => write!(f, "{of} of {scheme}"),
            Difference::Copied(Copied::Tolerance { header, .. }) => {
                f.write_str("tolerances at which a whole number of levels is needed")?;
                let at = if header.is_empty() { "" } else { " at " };
                write!(f, "{at}{header}, rounded to what is printed")
            }
            Difference::Copied(Copied::Numbers { first }) => numbered(f, *first),
            Difference::Scale { name, value, stated } => {
                write!(f, "{name} = {value}, where {stated} is stated")
            }
        }
    }
}

/// Says that the points are numbered from this one on.
pub(super) fn numbered(f: &mut fmt::Formatter<'_>, first: usize) -> fmt::Result {
    write!(f, "the scheme's points and rows numbered from the {} on", ordinal(first))
}

/// The name of a row that is counted from 0.
fn ordinal(place: usize) -> String {
    match place + 1 {
        1 => "first".to_owned(),
        2 => "second".to_owned(),
        3 => "third".to_owned(),
        other => format!("{other}th"),
    }
}

/// A reading that explains cells of a table.
#[derive(Clone, Debug)]
pub struct Explanation {
    /// Its differences from the printed text.
    pub differences: Vec<Difference>,
    /// The parameters that were solved for.
    pub solved: Vec<Solved>,
    /// The exact value of each cell, row by row, where there is one.
    pub values: Vec<Vec<Option<RealCyclotomic>>>,
    /// Which printed cells it explains.
    pub explained: Vec<Vec<bool>>,
}

impl Explanation {
    /// How many cells it explains.
    #[must_use]
    pub fn count(&self) -> usize {
        self.explained.iter().flatten().filter(|explained| **explained).count()
    }

    /// How it differs from the printed text, in words.
    #[must_use]
    pub fn differs(&self) -> String {
        differs(&self.differences, &self.solved)
    }

    /// Whether a constant of this reading may fit by luck.
    pub(crate) fn brings_constants(&self) -> bool {
        self.differences.iter().any(Difference::brings_constants)
    }

    /// The rank of a reading: by the number of cells that it explains, then those that keep every number that the
    /// paper states, then by the fewest differences.
    pub(crate) fn rank(&self) -> (usize, bool, Reverse<usize>) {
        let stated = self.differences.iter().all(|difference| difference.value().is_none());
        (self.count(), stated, Reverse(self.differences.len()))
    }
}

impl Search {
    /// How many cells are explained by the reading that was found; as printed, if none was found.
    pub(crate) fn explained(&self) -> usize {
        self.best.first().map_or(self.as_printed, Explanation::count)
    }

    /// Whether a reading that was found takes a quantity from another place of the paper.
    pub fn takes_from_elsewhere(&self) -> bool {
        let found = self.best.first().into_iter().chain(self.lines.iter().map(|line| &line.best));
        found.flat_map(|reading| &reading.differences).any(Difference::is_copied)
    }
}

/// What a search has found.
#[derive(Clone, Debug)]
pub struct Search {
    /// How many readings were compared; every simple scale counts as one. Readings that take a
    /// quantity from another place are compared only where the others leave cells unexplained.
    pub tried: usize,
    /// The choices, definitions and quantities in which the readings differ.
    pub choices: Vec<String>,
    /// In how many of these a reading may differ: [`MAX_DIFFERENCES`], or fewer where there would be too many readings.
    pub max_differences: usize,
    /// Whether readings were compared that take a quantity from another place of the paper, since
    /// the others leave cells unexplained.
    pub elsewhere: bool,
    /// How many cells are printed.
    pub cells: usize,
    /// How many cells the printed definition explains.
    pub as_printed: usize,
    /// How many cells the best readings explain, even if only by luck.
    pub most: usize,
    /// The readings that explain most cells, with the fewest differences; empty if they may be
    /// luck. For cells whose parameters are all stated, it is also empty if no reading explains
    /// more than the printed definition. For cells with recovered parameters, the printed
    /// definition is a reading like the others.
    pub best: Vec<Explanation>,
    /// An upper bound of how many readings would explain as many cells by luck.
    pub chance: Rational,
    /// The readings of rows and columns for the cells that `best` leaves.
    pub lines: Vec<LineReading>,
    /// The values that were not computed; `None` where all were.
    pub uncomputed: Option<Uncomputed>,
}

/// The values of cells under readings that were not computed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Uncomputed {
    /// The cap that the first is beyond.
    pub cap: Cap,
    /// The rows and columns of the cells, counted from 0.
    pub cells: BTreeSet<(usize, usize)>,
    /// Whether a reading with such values may explain more cells than the one that was taken.
    pub overtakes: bool,
}

impl Uncomputed {
    /// Whether they leave open that a cell is refuted.
    #[must_use]
    pub fn leaves_open(&self, cell: (usize, usize)) -> bool {
        self.overtakes || self.cells.contains(&cell)
    }
}

/// How a reading differs from the printed text, in words.
pub(super) fn differs(differences: &[Difference], solved: &[Solved]) -> String {
    let unsaid = solved
        .iter()
        .filter(|solved| differences.iter().all(|difference| difference.about() != solved.name));
    let unsaid = unsaid.map(|solved| format!("{} = {}", solved.name, solved.simplest));
    let differences = differences.iter().map(Difference::to_string);
    differences.chain(unsaid).collect::<Vec<String>>().join("; ")
}
