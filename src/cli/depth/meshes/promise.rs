//! What edges and formulas of papers promise of the depth of a mesh, a net or a solid.

use crate::cli::console::quantity::{Float, written};
use crate::cli::depth::numbers::levels;
use serde::Serialize;
use subcert::patch;

/// What the longest edge and the valences guarantee.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct APriori {
    /// The level.
    pub(super) level: u32,
    /// The length of the longest edge.
    pub(super) longest_edge: Float,
    /// The factor by which edges shrink.
    ratio: Float,
}

impl From<patch::APriori> for APriori {
    fn from(patch::APriori { level, longest_edge, ratio }: patch::APriori) -> APriori {
        APriori { level, longest_edge: Float(longest_edge), ratio: Float(ratio) }
    }
}

/// What a paper's formula promises.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct Formula {
    /// The paper.
    paper: &'static str,
    /// The level; null where it promises nothing.
    pub(super) level: Option<u32>,
    /// `too few`, `enough`, `more than needed` or `open`; null with `--a-priori`.
    verdict: Option<Promise>,
}

impl Formula {
    pub(super) fn new(paper: &'static str, level: Option<u32>) -> Formula {
        Formula { paper, level, verdict: None }
    }

    /// Compares the promise with the greatest level that is not sufficient, and one that is.
    pub(super) fn compared(self, too_few: Option<u32>, sufficient: Option<u32>) -> Formula {
        let compared = |level| match (too_few, sufficient) {
            (Some(few), _) if level <= few => Promise::TooFew,
            (_, Some(found)) if level > found => Promise::TooMany,
            (_, Some(found)) if level == found => Promise::Enough,
            _ => Promise::Open,
        };
        Formula { verdict: self.level.map(compared), ..self }
    }

    /// Its name, and what it promises of `subject`.
    pub(super) fn fact(&self, subject: &str) -> (String, String) {
        let text = match (self.level, self.verdict) {
            (None, _) => format!("nothing: its constant is not below 1 for this {subject}"),
            (Some(level), None) => levels(level),
            (Some(level), Some(verdict)) => format!("{}: {}", levels(level), verdict.name()),
        };
        (format!("formula of {}", self.paper), text)
    }
}

/// A promised number of levels, compared with what is known.
#[derive(Clone, Copy)]
enum Promise {
    TooFew,
    Enough,
    TooMany,
    Open,
}

impl Promise {
    fn name(self) -> &'static str {
        match self {
            Promise::TooFew => "too few",
            Promise::Enough => "enough",
            Promise::TooMany => "more than needed",
            Promise::Open => "open",
        }
    }
}

written!(promise: Promise => String, promise.name());
