//! Schemes whose offset the claim file does not state.

use crate::bound::BetterOffset;
use crate::claim::{Paper, Promise};
use crate::diagnostic::Diagnostic;
use crate::evaluation::choices::OFFSET;
use crate::evaluation::context::At;
use crate::evaluation::library::Library;
use crate::evaluation::settings::Settings;
use crate::evaluation::table::Evaluator;
use crate::finding::{TableFinding, UnstatedOffset};
use std::collections::BTreeSet;

/// The schemes of tables, each once, that stand in the claim file without an offset, which is then 0, where another one
/// is better and the table depends on it: its value has σ at the scheme's own offset, or its promise compares polygon and
/// limit there.
pub(crate) fn unstated(
    paper: &Paper,
    tables: &[TableFinding<'_>],
) -> Result<Vec<UnstatedOffset>, Diagnostic> {
    let mut found: Vec<UnstatedOffset> = Vec::new();
    for finding in tables {
        let table = finding.table;
        let mut left: BTreeSet<&str> = paper.without_offset(table).collect();
        left.retain(|name| found.iter().all(|one| one.scheme.name != *name));
        if left.is_empty() {
            continue;
        }
        let library = Library::new(paper);
        let judge = Evaluator::new(paper, table, &library, &finding.values())?;
        let promised = match &table.promise {
            Some(Promise::Depth { offset, ring, .. } | Promise::Bound { offset, ring, .. }) => {
                offset.is_none() && ring.is_none()
            }
            None => false,
        };
        let (assume, settings) = (BTreeSet::new(), Settings::default());
        for (row, cells) in table.cells.iter().enumerate() {
            for column in 0..cells.len() {
                let at = At { row, column, assume: &assume, settings: &settings };
                let Ok(quantities) = judge.quantities(at)? else { continue };
                let own = || {
                    let asked = judge.evaluate(&table.value, at).is_ok();
                    let consulted = judge.rows.choices.get(OFFSET.key).cloned();
                    let consulted = consulted.or_else(|| settings.consulted().remove(OFFSET.key));
                    asked && consulted.is_some_and(|word| word == "own")
                };
                let Some(scheme) = &quantities.scheme else { continue };
                for (instance, constants) in scheme.instances.iter().zip(&scheme.constants) {
                    let better = left.contains(&instance.name[..]).then(|| constants.mask());
                    let better = better.and_then(BetterOffset::of);
                    if let Some(better) = better.filter(|_| promised || own()) {
                        left.remove(&instance.name[..]);
                        found.push(UnstatedOffset { scheme: instance.clone(), better });
                    }
                }
            }
        }
    }
    Ok(found)
}
