//! A summary of the cells of a paper's tables.

use crate::audit::{Cause, CellOutcome, CellSummary};
use serde::Serialize;

/// How many cells are in each standing, and why.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Summary {
    /// How many cells there are.
    pub count: usize,
    /// The cells, grouped by their outcomes.
    pub groups: Vec<Group>,
}

/// Cells of one outcome.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Group {
    /// How many they are.
    pub count: usize,
    /// Their outcome; its fields stand here.
    #[serde(flatten)]
    pub outcome: Outcome,
    /// Their outcome if the values put in for what the paper does not state were stated.
    pub if_assumed: Option<Outcome>,
}

/// The outcome of a cell.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Outcome {
    /// `confirmed`, `reproduced`, `explained`, `misprinted`, `refuted` or `not checkable`.
    pub standing: &'static str,
    /// The cause, in words.
    pub cause: Option<String>,
}

impl Summary {
    pub(super) fn of(summary: &CellSummary) -> Summary {
        let groups = summary.groups.iter().map(|group| Group {
            count: group.count,
            outcome: Outcome::of(&group.outcome),
            if_assumed: group.if_assumed.as_ref().map(Outcome::of),
        });
        Summary { count: summary.cells(), groups: groups.collect() }
    }
}

impl Outcome {
    fn of(outcome: &CellOutcome) -> Outcome {
        Outcome {
            standing: outcome.standing.name(),
            cause: outcome.cause.as_ref().map(Cause::to_string),
        }
    }
}
