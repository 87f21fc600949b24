//! What the cells of a table need: how many of them each way of a choice explains at
//! most, whatever else differs.

use crate::evaluation::Effect;
use crate::evaluation::choices::FAMILY;
use crate::finding::{Explanation, Need};
use crate::judge::reading::space::{Change, Space};
use std::collections::BTreeMap;

/// What a definition or a tolerance as printed is called.
const AS_PRINTED: &str = "as printed";

impl Space<'_> {
    /// For each choice that the values depend on, what its ways explain.
    pub(crate) fn needs(&self, explanations: &[Explanation]) -> Vec<Need> {
        let choices = self.printed_ways();
        let mut needs: Vec<Need> = Vec::new();
        for (choice, printed) in choices {
            let mut ways = BTreeMap::new();
            for explanation in explanations {
                let differs = explanation.differences.iter().find(|other| other.choice == choice);
                let way = differs.map_or(printed.as_str(), |other| other.says.as_str());
                let most = ways.entry(way.to_owned()).or_insert(0);
                *most = explanation.count().max(*most);
            }
            needs.push(Need { choice, ways });
        }
        needs
    }

    /// The choices that readings differ in, with what is printed.
    fn printed_ways(&self) -> Vec<(String, String)> {
        let mut printed = Vec::new();
        for ways in &self.changes {
            match ways.first() {
                Some(Change::Word(choice, ..)) => {
                    let differs = |word: &str| {
                        ways.iter().any(|way| matches!(way, Change::Word(_, w, _) if *w == word))
                    };
                    let way = choice.ways.iter().find(|way| !differs(way.word));
                    let says = way.map_or(AS_PRINTED, |way| way.says);
                    printed.push((choice.name.to_owned(), says.to_owned()));
                }
                Some(Change::Definition(i)) => {
                    let name = self.judge.paper.alternatives[*i].of.clone();
                    printed.push((name, AS_PRINTED.to_owned()));
                }
                Some(Change::Sibling(_)) | None => {}
            }
        }
        let decimal = FAMILY.iter().find(|choice| choice.effect == Effect::Decimal);
        if let Some(choice) = decimal.filter(|_| !self.is_depth()) {
            printed.push((choice.name.to_owned(), choice.ways[0].says.to_owned()));
        }
        printed
    }
}
