//! The steps that a claim costs.

use crate::reject::Stop;
use std::cell::Cell;

/// The most steps of one claim. Nodes of formulas and terms of sums are steps; a product costs
/// as many as `Value::cost` says.
const MAX_STEPS: u64 = 20_000_000;

/// A count of steps with a cap, so that the check of every claim ends.
#[derive(Default)]
pub struct Meter(Cell<u64>);

impl Meter {
    /// Counts steps.
    pub fn spend(&self, steps: u64) -> Result<(), Stop> {
        self.0.set(self.0.get().saturating_add(steps));
        if self.0.get() > MAX_STEPS { Err(Stop::Capped("the steps of a claim")) } else { Ok(()) }
    }

    /// Starts again at 0, for the next claim.
    pub fn restart(&self) {
        self.0.set(0);
    }
}
