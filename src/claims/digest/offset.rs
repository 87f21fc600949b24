//! Schemes whose offset the claim file does not state.

use crate::bound::BetterOffset;
use crate::claim::{Paper, Promise};
use crate::diagnostic::Diagnostic;
use crate::evaluation::choices::OFFSET;
use crate::evaluation::context::CellReading;
use crate::evaluation::library::Library;
use crate::evaluation::quantity::Quantities;
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
        let rows = table.cells.iter().enumerate();
        for (row, column) in rows.flat_map(|(row, cells)| (0..cells.len()).map(move |c| (row, c))) {
            if left.is_empty() {
                break;
            }
            let at = CellReading { row, column, assume: &assume, settings: &settings };
            let Ok(Quantities { scheme: Some(scheme), .. }) = judge.quantities(at)? else {
                continue;
            };
            if !promised && !takes_own_offset(&judge, at) {
                continue;
            }
            for (instance, constants) in scheme.instances.iter().zip(scheme.constants.iter()) {
                if left.contains(&instance.name[..])
                    && let Some(better) = BetterOffset::of(constants.mask())
                {
                    left.remove(&instance.name[..]);
                    found.push(UnstatedOffset { scheme: instance.clone(), better });
                }
            }
        }
    }
    Ok(found)
}

/// Whether the value of a cell as printed has σ at the scheme's own offset.
fn takes_own_offset(judge: &Evaluator<'_>, at: CellReading<'_>) -> bool {
    let has_value = judge.evaluate(&judge.table.value, at).is_ok();
    let word = judge.rows.choices.get(OFFSET.key).cloned();
    let word = word.or_else(|| at.settings.consulted().remove(OFFSET.key));
    has_value && word.is_some_and(|word| word == "own")
}
