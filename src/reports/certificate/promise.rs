//! Promises: control data that break them, each with a name, and bounds that keep them.

use super::block::{Block, closed};
use super::witness::{attained, list};
use crate::audit::{Attained, Broken, Control, Later, Place, PromiseEvidence};
use crate::exact::RealCyclotomic;

/// Writes the lines about the promises of a table, row by row; `printed` gives the depth that
/// a cell prints, if it prints one.
pub(super) fn lines(
    block: &mut Block,
    evidence: &[Vec<Option<PromiseEvidence<'_>>>],
    printed: impl Fn(usize, usize) -> Option<u32>,
) {
    let mut witnesses: Vec<(&Control, &Place)> = Vec::new();
    for evidence in evidence.iter().flatten().flatten() {
        let (broken, weights) = match evidence {
            PromiseEvidence::Broken(broken, weights) => (vec![*broken], &weights[..]),
            PromiseEvidence::BrokenNaturally(broken, natural) => (vec![*broken, *natural], &[][..]),
            _ => continue,
        };
        for Broken { attained: found, .. } in broken {
            let Attained { control, place, .. } = found;
            if !witnesses.contains(&(control, place)) {
                witnesses.push((control, place));
                block.line(format!("witness {}", witnesses.len()));
                attained(block, found, weights);
            }
        }
    }
    let broken = |Broken { attained, level, distance, most, .. }: &Broken, printed: Option<u32>| {
        let of = (&attained.control, &attained.place);
        let name = witnesses.iter().position(|known| *known == of).map_or(0, |i| i + 1);
        let later = printed.filter(|printed| level > printed);
        let later = later.map_or_else(String::new, |_| format!(" level {level}"));
        format!("{name} {} {most}{later}", closed(distance))
    };
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
                Some(PromiseEvidence::Broken(found, _)) => {
                    block.line(format!("broken {place} {}", broken(found, printed(row, column))));
                }
                Some(PromiseEvidence::BrokenNaturally(found, natural)) => {
                    let printed = printed(row, column);
                    block.line(format!("broken {place} {}", broken(found, printed)));
                    block.line(format!("naturally {place} {}", broken(natural, printed)));
                }
            }
        }
    }
}

/// `L M c` of a line `kept`.
pub(super) fn later(Later { later, levels, block }: &Later) -> String {
    format!("{later} {levels} {block}")
}

/// Writes a line `flow` for each of these flows along the edges of a ring.
pub(super) fn flows(block: &mut Block, flows: &[Vec<RealCyclotomic>]) {
    for flow in flows {
        block.line(format!("flow {}", list(flow)));
    }
}
