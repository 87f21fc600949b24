//! Findings as statements about numbers, which the Coq library of `proofs/coq` covers.

use crate::bound::Operator;
use crate::exact::Rational;
use crate::scheme::{Mask, Rules};
use crate::verdict::Word;

/// What Coq's kernel accepts of a finding about a cell or a theorem.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum KernelProof {
    /// The exact value of a cell.
    Value,
    /// A constant that the value of a cell rests on.
    Constant,
    /// The sound bound or depth of a cell.
    Sound,
    /// That a cell does not keep its promise.
    Broken,
    /// That it does not at natural parameters.
    BrokenNaturally,
    /// That data refute a theorem.
    Refuted,
    /// That they do at natural parameters.
    RefutedNaturally,
}

impl KernelProof {
    /// Every kind.
    pub const ALL: [KernelProof; 7] = [
        KernelProof::Value,
        KernelProof::Constant,
        KernelProof::Sound,
        KernelProof::Broken,
        KernelProof::BrokenNaturally,
        KernelProof::Refuted,
        KernelProof::RefutedNaturally,
    ];

    /// The kind's name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            KernelProof::Value => "value",
            KernelProof::Constant => "constant",
            KernelProof::Sound => "sound",
            KernelProof::Broken => Word::Broken.name(),
            KernelProof::BrokenNaturally => "broken-naturally",
            KernelProof::Refuted => Word::Refuted.name(),
            KernelProof::RefutedNaturally => "refuted-naturally",
        }
    }
}

/// A finding as a statement about numbers.
#[derive(Clone, Debug)]
pub struct KernelFinding {
    /// `table` or `theorem`.
    pub kind: &'static str,
    /// The id of the claim within its paper.
    pub claim: String,
    /// The values of parameters that the paper does not state, the same for all findings of a claim.
    pub assumed: Vec<(String, Rational)>,
    /// Where it stands in the paper, and what is printed there.
    pub place: String,
    /// What the statement says of this.
    pub about: String,
    /// What is true.
    pub statement: KernelStatement,
}

/// A statement about a scheme and numbers.
#[derive(Clone, Debug)]
pub enum KernelStatement {
    /// T_c of a mask, or Λ_c.
    Constant {
        /// The mask.
        mask: Mask,
        /// Whether it is T_c or Λ_c.
        operator: Operator,
        /// If the rules are read from their other end, the rules that are read so.
        backwards: Option<Rules>,
        /// c.
        levels: u32,
        /// The constant.
        value: Rational,
    },
    /// The distance of level k to all later levels is at most the bound times the spread, for points at i/n^k.
    Distance {
        /// The mask.
        mask: Mask,
        /// k.
        level: u32,
        /// The bound.
        bound: Rational,
        /// M and c.
        block: (usize, u32),
    },
    /// From level k on, polygons of a spread keep a tolerance, for points at i/n^k.
    Depth {
        /// The mask.
        mask: Mask,
        /// k.
        level: u32,
        /// The spread.
        spread: Rational,
        /// The tolerance.
        tolerance: Rational,
        /// M and c.
        block: (usize, u32),
    },
    /// Data of spread 1 exceed a bound.
    Exceeds {
        /// The mask.
        mask: Mask,
        /// τ: the points of level k are at (i + τ)/n^k.
        shift: Rational,
        /// k.
        level: u32,
        /// The index of the first point.
        first: i64,
        /// The points.
        points: Vec<i64>,
        /// Where.
        excess: Excess,
        /// The bound.
        bound: Rational,
    },
    /// A net x_{i,j} = a_i + b_j of spread 1 exceeds a bound.
    Net {
        /// The masks of both indices.
        masks: [Mask; 2],
        /// τ for both indices.
        shifts: [Rational; 2],
        /// k.
        level: u32,
        /// a and b, with the indices of their first points.
        polygons: [(i64, Vec<i64>); 2],
        /// The place in both directions.
        excess: [Excess; 2],
        /// The bound.
        bound: Rational,
    },
    /// A ring of rational weights exceeds a bound.
    Ring {
        /// The weights, row by row.
        weights: Vec<Vec<Rational>>,
        /// The edges.
        edges: Vec<(usize, usize)>,
        /// k.
        level: u32,
        /// The points.
        points: Vec<i64>,
        /// Where.
        excess: RingExcess,
        /// The bound.
        bound: Rational,
    },
}

/// A quantity of a curve that exceeds a bound, and its place.
#[derive(Clone, Debug)]
pub enum Excess {
    /// x^k_{i+1} − x^k_i at this i.
    Difference(i64),
    /// P^{k+1} − P^k at this t.
    Step(Rational),
    /// P^m − P^k at this t, for all m from a level on.
    Distance {
        /// t.
        place: Rational,
        /// The level.
        later: u32,
        /// A bound of the distance of this level to all later ones.
        tail: Rational,
        /// M and c that show the bound.
        block: (usize, u32),
    },
}

/// A quantity of a ring that exceeds a bound, and its place.
#[derive(Clone, Debug)]
pub enum RingExcess {
    /// The difference of two points.
    Difference(usize, usize),
    /// The step of a point to the next level, from where these weights put it.
    Step(usize, Vec<Vec<Rational>>),
    /// The distance of a point to the limit of the ring, with the weights of the limit.
    Distance(usize, Vec<Rational>),
}
