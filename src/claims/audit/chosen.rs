//! The claims of a paper that are judged.

use crate::claim::{Paper, Table};
use crate::judge::kind::Judge as _;
use std::collections::BTreeSet;

/// The ids of the claims that are judged; `None` for all claims.
pub(super) struct Chosen(Option<BTreeSet<String>>);

impl Chosen {
    pub(super) fn all() -> Chosen {
        Chosen(None)
    }

    /// A claim, and the claims that its finding needs: of a theorem, those on which it rests,
    /// directly or through other theorems; of a table, those that are judged with it or have an
    /// open parameter in common with it. The cells of a table of smoothness are claims of their own.
    pub(super) fn claim(paper: &Paper, id: &str) -> Chosen {
        let mut ids: BTreeSet<&str> = BTreeSet::new();
        let mut waiting = vec![id];
        while let Some(id) = waiting.pop() {
            if !ids.insert(id) {
                continue;
            }
            for theorem in paper.theorems.iter().filter(|theorem| theorem.id == id) {
                waiting.extend(theorem.rests.iter().map(String::as_str));
                let by_hand = theorem.by_hand.iter().flat_map(|hand| &hand.uses);
                waiting.extend(by_hand.map(String::as_str));
            }
        }
        let cells = paper.smoothness.iter().filter(|claim| claim.is_cell_of(id));
        ids.extend(cells.map(|claim| &claim.id[..]));
        let groups = Table::groups(&paper.tables);
        loop {
            let before = ids.len();
            let chosen = |table: &&Table| ids.contains(&table.id[..]);
            let open: BTreeSet<&str> = paper.tables.iter().filter(chosen).flat_map(open).collect();
            for group in &groups {
                let lends = |table: &Table| self::open(table).any(|name| open.contains(name));
                if group.iter().any(|table| ids.contains(&table.id[..]) || lends(table)) {
                    ids.extend(group.iter().map(|table| &table.id[..]));
                }
            }
            if ids.len() == before {
                return Chosen(Some(ids.into_iter().map(str::to_owned).collect()));
            }
        }
    }

    pub(super) fn has(&self, id: &str) -> bool {
        self.0.as_ref().is_none_or(|ids| ids.contains(id))
    }
}

/// The parameters of a table that have no value in the paper or the claim file.
fn open(table: &Table) -> impl Iterator<Item = &str> {
    let unstated = table.unstated.iter().filter(|(_, assumed)| assumed.is_none());
    unstated.map(|(name, _)| name.as_str())
}
