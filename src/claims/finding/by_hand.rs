//! The computation that checks a refutation with paper and pencil.

use crate::exact::{Rational, RealCyclotomic};
use crate::finding::witness::Refiner;
use crate::limit::{Combination, LimitWeights};
use crate::scheme::LocalRules;

/// The computation behind the data that refute a theorem with points at i/n^k, in the order in which
/// one would check it.
#[derive(Clone, Debug, PartialEq)]
pub struct ByHand {
    /// What refines the data.
    pub refiner: Refiner,
    /// What puts the points with which a step of a ring is compared, if not themselves.
    pub interpolant: Option<LocalRules>,
    /// The constants in the bound.
    pub constants: Vec<HandConstant>,
    /// The bound with all numbers put in.
    pub bound: String,
    /// For a distance of a curve, c and T_c < 1, which show that its polygons converge.
    pub contraction: Option<(u32, Rational)>,
    /// For a distance of a curve, the weights that give its limit values.
    pub weights: Option<LimitWeights>,
    /// The refined points of a curve that the computation needs, by level, from level 1 on.
    pub refined: Vec<(u32, Vec<(i64, Rational)>)>,
    /// For a curve, the two values whose difference is bounded.
    pub sides: Option<[Combination; 2]>,
    /// What is left out, if anything is.
    pub left_out: Option<LeftOut>,
}

/// A constant in a bound.
#[derive(Clone, Debug, PartialEq)]
pub struct HandConstant {
    /// Its name, or the call of a function.
    pub name: String,
    /// The formula that it stands for.
    pub formula: String,
    /// Its value.
    pub value: RealCyclotomic,
    /// A confirmed cell of the paper that prints the constant, if there is one.
    pub cell: Option<HandCell>,
}

/// A confirmed cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HandCell {
    /// Its id.
    pub id: String,
    /// Where it stands.
    pub locus: String,
    /// The printed text.
    pub printed: String,
}

/// What is left out because it would be too long.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeftOut {
    /// The refined points of a net, and its limit.
    Net,
    /// The refined points of a ring.
    Ring,
    /// The refined points of a curve: there are too many, or its limit is at none of them.
    Points,
}

impl LeftOut {
    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            LeftOut::Net => "net",
            LeftOut::Ring => "ring",
            LeftOut::Points => "points",
        }
    }
}
