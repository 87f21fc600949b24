//! The finding about a table.

use super::judgement::{Harm, Judgement};
use crate::claim::Table;
use crate::exact::Rational;
use crate::finding::cell::{CellFinding, CellKind};
use crate::finding::promise::{Kept, PromiseCounts};
use crate::finding::reading::{Search, WayCounts};
use crate::finding::recovered::{Fitting, Recovered, values};
use std::collections::BTreeMap;

impl TableFinding<'_> {
    /// The cells that claim something, row by row: all but those in which nothing is printed.
    pub fn claiming(&self) -> impl Iterator<Item = &CellFinding> + Clone {
        self.cells.iter().flatten().filter(|cell| !cell.is_blank())
    }

    /// How many of its printed bounds and depths keep their promise.
    #[must_use]
    pub fn promise_counts(&self) -> PromiseCounts {
        let mut counts = PromiseCounts::default();
        for kept in self.cells.iter().flatten().filter_map(|cell| cell.kept.as_ref()) {
            *match kept {
                Kept::Yes => &mut counts.kept,
                Kept::No(_) => &mut counts.broken,
                Kept::Open(_) => &mut counts.open,
            } += 1;
        }
        counts
    }
}

/// The finding about a table.
#[derive(Clone, Debug)]
pub struct TableFinding<'a> {
    /// The table.
    pub table: &'a Table,
    /// Its cells, row by row.
    pub cells: Vec<Vec<CellFinding>>,
    /// The search for the reading by which the table was computed; `None` if every cell is as
    /// printed. It is about the cells that need no assumptions or, if there are none, about all
    /// cells.
    pub search: Option<Search>,
    /// Where some cells need assumptions and others do not, the search for the reading of the cells
    /// that do.
    pub assumed_search: Option<Search>,
    /// How many cells each way of each choice explains.
    pub needs: Vec<WayCounts>,
    /// The parameters that the paper does not state and that were recovered, by name.
    pub recovered: BTreeMap<String, Recovered>,
    /// Where nothing was recovered, the values that fit best, if some fit.
    pub fitting: Option<Fitting>,
}

impl TableFinding<'_> {
    /// The values of the parameters that were recovered.
    pub(crate) fn values(&self) -> BTreeMap<String, Rational> {
        values(&self.recovered)
    }

    /// The kinds of its printed cells.
    #[must_use]
    pub fn kinds(&self) -> Vec<CellKind> {
        CellKind::of(&self.cells)
    }

    /// The search for the reading of the cells of a kind.
    #[must_use]
    pub fn search_of(&self, kind: CellKind) -> Option<&Search> {
        match (kind, &self.kinds()[..]) {
            (CellKind::Assumed, [CellKind::Plain, CellKind::Assumed]) => {
                self.assumed_search.as_ref()
            }
            (kind, [first, ..]) if kind == *first => self.search.as_ref(),
            _ => None,
        }
    }

    /// The searches for readings.
    pub fn searches(&self) -> impl Iterator<Item = &Search> {
        self.search.iter().chain(&self.assumed_search)
    }
}

impl TableFinding<'_> {
    #[expect(clippy::unused_self, reason = "every kind has one")]
    pub(crate) fn judgement(&self) -> Judgement<'_> {
        Judgement { word: None, cap: None, harm: Harm::Number }
    }
}
