//! The findings of a paper.

use crate::bound::BetterOffset;
use crate::claim::Paper;
use crate::finding::consistency::Contradiction;
use crate::finding::equation::EquationFinding;
use crate::finding::function::FunctionFinding;
use crate::finding::range::RangeFinding;
use crate::finding::smoothness::SmoothnessFinding;
use crate::finding::table::TableFinding;
use crate::finding::theorem::TheoremFinding;
use crate::scheme::Instance;

/// The verdicts of a paper's claims.
#[derive(Clone, Debug)]
pub struct PaperAudit<'a> {
    /// The paper.
    pub paper: &'a Paper,
    /// Its tables, cell by cell.
    pub tables: Vec<TableFinding<'a>>,
    /// Its equations.
    pub equations: Vec<EquationFinding<'a>>,
    /// Its closed forms in a free parameter.
    pub functions: Vec<FunctionFinding<'a>>,
    /// Its ranges of a free parameter.
    pub ranges: Vec<RangeFinding<'a>>,
    /// What it says of the smoothness of limits.
    pub smoothness: Vec<SmoothnessFinding<'a>>,
    /// Its theorems.
    pub theorems: Vec<TheoremFinding<'a>>,
    /// Where its tables need different readings or values of a parameter.
    pub contradictions: Vec<Contradiction>,
    /// The schemes of its tables whose offset the claim file does not state, where another one than 0 is better.
    pub unstated_offsets: Vec<UnstatedOffset>,
}

/// A scheme whose offset the claim file does not state, with a better one than 0.
#[derive(Clone, Debug, PartialEq)]
pub struct UnstatedOffset {
    /// The scheme, with the parameters of the first cell whose scheme it is.
    pub scheme: Instance,
    /// The better offset of its mask.
    pub better: BetterOffset,
}
