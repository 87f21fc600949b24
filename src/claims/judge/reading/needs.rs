//! The needs of a table's cells: how many cells each way of a choice explains at most, whatever
//! else differs.

use crate::evaluation::Effect;
use crate::evaluation::choices::FAMILY;
use crate::finding::{Difference, Explanation, WayCounts};
use crate::judge::reading::space::{Change, ReadingSpace};
use std::collections::BTreeMap;

/// A choice or a definition, and the way that is printed: `None` for a definition or a tolerance.
type Printed = (String, Option<Difference>);

impl ReadingSpace<'_> {
    /// For each choice that the values depend on, what its ways explain.
    pub(crate) fn needs(&self, explanations: &[Explanation]) -> Vec<WayCounts> {
        let choices = self.printed_ways();
        let mut needs: Vec<WayCounts> = Vec::new();
        for (about, printed) in choices {
            let mut ways = BTreeMap::new();
            for explanation in explanations {
                let differs = explanation.differences.iter().find(|other| other.about() == about);
                let way = differs.cloned().or_else(|| printed.clone());
                let most = ways.entry(way).or_insert(0);
                *most = explanation.count().max(*most);
            }
            needs.push(WayCounts { about, ways });
        }
        needs
    }

    /// The choices that readings differ in, with what is printed.
    fn printed_ways(&self) -> Vec<Printed> {
        let mut printed = Vec::new();
        for ways in &self.changes {
            match ways.first() {
                Some(Change::Way(choice, _)) => {
                    let differs = |word: &str| {
                        ways.iter().any(|way| matches!(way, Change::Way(_, w) if w.word == word))
                    };
                    let way = choice.ways.iter().find(|way| !differs(way.word));
                    let way = way.map(|way| Difference::Way(choice, way));
                    printed.push((choice.name.to_owned(), way));
                }
                Some(Change::Definition(i)) => {
                    printed.push((self.judge.paper.alternatives[*i].of.clone(), None));
                }
                Some(Change::Copied(_)) | None => {}
            }
        }
        let decimal = FAMILY.iter().copied().find(|choice| choice.effect == Effect::Decimal);
        if let Some(choice) = decimal.filter(|_| !self.is_depth()) {
            let way = Difference::Way(choice, &choice.ways[0]);
            printed.push((choice.name.to_owned(), Some(way)));
        }
        printed
    }
}
