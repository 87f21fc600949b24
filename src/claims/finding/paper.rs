//! The findings of a paper.

use crate::claim::Paper;
use crate::finding::consistency::Contradiction;
use crate::finding::equation::EquationFinding;
use crate::finding::function::FunctionFinding;
use crate::finding::range::RangeFinding;
use crate::finding::smoothness::SmoothnessFinding;
use crate::finding::table::TableFinding;
use crate::finding::theorem::TheoremFinding;

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
}
