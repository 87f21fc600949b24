//! The steps that a claim costs.

use crate::text::Stop;
use std::cell::Cell;

/// The most steps of one claim. Nodes of formulas and terms of sums are steps; a product costs
/// as many as `Value::cost` says.
const MAX_STEPS: u64 = 20_000_000;

/// A count of steps with a cap, so that the check of every claim ends.
pub struct Meter {
    spent: Cell<u64>,
    most: u64,
}

impl Default for Meter {
    fn default() -> Meter {
        Meter::up_to(MAX_STEPS)
    }
}

impl Meter {
    /// A count with a cap of its own.
    pub fn up_to(most: u64) -> Meter {
        Meter { spent: Cell::new(0), most }
    }

    /// Counts steps.
    pub fn spend(&self, steps: u64) -> Result<(), Stop> {
        self.spent.set(self.spent.get().saturating_add(steps));
        if self.spent.get() > self.most {
            Err(Stop::Capped("the steps of a claim"))
        } else {
            Ok(())
        }
    }

    /// Starts again at 0, for the next claim.
    pub fn restart(&self) {
        self.spent.set(0);
    }
}

/// The steps of adding a product of fractions to a third, which have so many binary digits together. Multiplication, division and
/// common divisors are quadratic.
pub fn product_steps(bits: u64) -> u64 {
    let blocks = bits / 256;
    (1 + bits / 128).saturating_add(blocks.saturating_mul(blocks))
}
