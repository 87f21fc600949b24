//! Promises: control data that break them, each named once, and bounds that keep them.

use super::block::{Block, closed};
use super::witness::{list, net, polygon, ring};
use crate::audit::{Broken, ControlData, Later, PromiseEvidence};
use crate::exact::RealCyclotomic;

/// The lines about the promises of a table, row by row.
pub(super) fn lines(block: &mut Block, evidence: &[Vec<Option<PromiseEvidence<'_>>>]) {
    let mut witnesses: Vec<&ControlData> = Vec::new();
    for evidence in evidence.iter().flatten().flatten() {
        if let PromiseEvidence::Broken(Broken { data, .. }, weights) = evidence
            && !witnesses.contains(&data)
        {
            witnesses.push(data);
            block.line(format!("witness {}", witnesses.len()));
            witness(block, data, weights);
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
                Some(PromiseEvidence::Broken(Broken { data, distance, most, .. }, _)) => {
                    let name =
                        witnesses.iter().position(|known| *known == data).map_or(0, |i| i + 1);
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

/// The lines of data and their place. Data that are all 0 were found where the distance is 0 whatever
/// they are: others, which have a spread, take their place.
fn witness(block: &mut Block, data: &ControlData, weights: &[RealCyclotomic]) {
    let flat = |points: &[i64]| points.iter().all(|x| *x == 0);
    match data {
        ControlData::Polygon(points, t) => {
            let mut points = points.clone();
            if flat(&points.points) {
                points.points.push(1);
            }
            polygon(block, &points);
            block.line(format!("at {t}"));
        }
        ControlData::Net(rows, first, parameters) => {
            let mut rows = rows.clone();
            if flat(&rows.concat()) {
                for row in &mut rows {
                    row.push(1);
                }
            }
            net(block, *first, &rows, false);
            block.line(format!("at {}", list(parameters)));
        }
        ControlData::Ring(points, name) => {
            let mut points = points.clone();
            if flat(&points) {
                points[0] = 1;
            }
            ring(block, &points, weights);
            block.line(format!("at {name}"));
        }
    }
}
