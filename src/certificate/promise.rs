//! Promises: control data that break them, each named once, and bounds that keep them.

use super::block::{Block, closed};
use super::witness::{attained, list};
use crate::audit::{Attained, Broken, Control, Later, Place, PromiseEvidence};
use crate::exact::RealCyclotomic;

/// The lines about the promises of a table, row by row.
pub(super) fn lines(block: &mut Block, evidence: &[Vec<Option<PromiseEvidence<'_>>>]) {
    let mut witnesses: Vec<(&Control, &Place)> = Vec::new();
    for evidence in evidence.iter().flatten().flatten() {
        if let PromiseEvidence::Broken(Broken { attained: found, .. }, weights) = evidence {
            let Attained { control, place, .. } = found;
            if !witnesses.contains(&(control, place)) {
                witnesses.push((control, place));
                block.line(format!("witness {}", witnesses.len()));
                attained(block, found, weights);
            }
        }
    }
    for (row, evidence) in evidence.iter().enumerate() {
        for (column, evidence) in evidence.iter().enumerate() {
            let place = format!("{} {}", row + 1, column + 1);
            match evidence {
                None => {}
                Some(PromiseEvidence::Undecided) => block.line(format!("undecided {place}")),
                Some(PromiseEvidence::Kept(kept)) => {
                    block.line(format!("kept {place} {}", later(kept)));
                }
                Some(PromiseEvidence::KeptByFlows(weights, flows)) => {
                    block.line(format!("kept {place}"));
                    block.line(format!("weights {}", list(weights)));
                    self::flows(block, flows);
                }
                Some(PromiseEvidence::Broken(
                    Broken { attained: found, distance, most, .. },
                    _,
                )) => {
                    let of = (&found.control, &found.place);
                    let name = witnesses.iter().position(|known| *known == of).map_or(0, |i| i + 1);
                    block.line(format!("broken {place} {name} {} {most}", closed(distance)));
                }
            }
        }
    }
}

/// `L M c`.
pub(super) fn later(Later { later, levels, block }: &Later) -> String {
    format!("{later} {levels} {block}")
}

/// The lines of flows along the edges of a ring.
pub(super) fn flows(block: &mut Block, flows: &[Vec<RealCyclotomic>]) {
    for flow in flows {
        block.line(format!("flow {}", list(flow)));
    }
}
