//! Whether a printed bound or depth keeps its promise.

use crate::exact::{Rational, RealCyclotomic};
use crate::finding::reason::Reason;
use crate::finding::witness::Attained;
use std::ops::Add;

/// Whether a printed number keeps its promise for all control data.
#[derive(Clone, Debug, PartialEq)]
pub enum Kept {
    /// It does.
    Yes,
    /// It does not for these data.
    No(Box<Broken>),
    /// Not decided, and why.
    Open(Reason),
}

/// Control data for which a printed number does not keep its promise.
#[derive(Clone, Debug, PartialEq)]
pub struct Broken {
    /// Data of spread 1, and the place where they are too far from their limit.
    pub attained: Attained,
    /// β; the data that break the promise are those of spread 1 times β.
    pub spread: Rational,
    /// k.
    pub level: u32,
    /// The distance of the data times β from their limit at that place and level.
    pub distance: RealCyclotomic,
    /// The promised bound of this distance.
    pub most: Rational,
}

/// How many printed bounds and depths keep their promise for every control polygon.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PromiseCounts {
    /// They do.
    pub kept: usize,
    /// They do not.
    pub broken: usize,
    /// Not decided.
    pub open: usize,
}

impl PromiseCounts {
    /// All of them.
    #[must_use]
    pub fn all(&self) -> usize {
        self.kept + self.broken + self.open
    }
}

impl Add for PromiseCounts {
    type Output = PromiseCounts;
    fn add(self, other: PromiseCounts) -> PromiseCounts {
        PromiseCounts {
            kept: self.kept + other.kept,
            broken: self.broken + other.broken,
            open: self.open + other.open,
        }
    }
}
