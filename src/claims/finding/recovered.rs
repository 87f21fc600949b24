//! Parameters that a paper does not state, with the values that its printed numbers give.

use crate::exact::Rational;
use std::collections::BTreeMap;

/// The value of a parameter that the paper does not state, recovered from printed numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Recovered {
    /// The plainest value with which a reading gives most cells.
    pub value: Rational,
    /// Where it comes from.
    pub from: RecoveredFrom,
}

impl Recovered {
    /// Whether the table's own numbers give it.
    pub(crate) fn is_own(&self) -> bool {
        !matches!(self.from, RecoveredFrom::Table { .. })
    }
}

/// Values of parameters that the paper does not state, with which a reading gives most cells of a
/// table, though so few that it may be luck.
#[derive(Clone, Debug, PartialEq)]
pub struct Fitting {
    /// The values, by name.
    pub values: BTreeMap<String, Recovered>,
    /// How many cells the reading gives there.
    pub cells: usize,
}

/// The values of recovered parameters.
pub(crate) fn values(recovered: &BTreeMap<String, Recovered>) -> BTreeMap<String, Rational> {
    recovered.iter().map(|(name, recovered)| (name.clone(), recovered.value.clone())).collect()
}

/// Where the value of a parameter comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RecoveredFrom {
    /// From the numbers of the table itself: the ends, up to about 2^−60, of the interval of values
    /// with which they are consistent.
    Solved(Rational, Rational),
    /// Another table of the paper, which was solved for it.
    Table {
        /// Its id.
        id: String,
        /// Its locus.
        locus: String,
    },
    /// It is one of the simplest numbers, which were tried in turn.
    Tried,
}
