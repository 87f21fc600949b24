//! The finding about a theorem.

use super::judgement::{Harm, Judgement};
use crate::claim::Theorem;
use crate::evaluation::{Choice, Way};
use crate::exact::{Rational, RealCyclotomic};
use crate::finding::kernel::KernelProof;
use crate::finding::levels::Levels;
use crate::finding::reading::numbered;
use crate::finding::reason::Reason;
use crate::finding::witness::{Supremum, Unshiftable, Violation};
use crate::verdict::Word;
use std::fmt;

/// How a reader may try to save a theorem that is refuted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Correction {
    /// A sound way of a choice that the formula depends on.
    Way(&'static Choice, &'static Way),
    /// One of the claim file's alternatives for a definition.
    Alternative {
        /// Its place among them.
        place: usize,
        /// What the claim file calls it.
        label: String,
    },
    /// One of the theorem's own corrections.
    Rewriting {
        /// Its place among them.
        place: usize,
        /// What the claim file says of it.
        label: String,
    },
    /// The bound takes one power of the constant for each block of levels.
    Block,
    /// For a distance, the bound sums the steps of all levels of a block.
    AllSteps,
    /// For a step or a difference, the bound takes the greatest factor of the levels of a block.
    Greatest,
    /// Polygon and limit are compared at the offset that serves the scheme best.
    Centred,
    /// The points, and so the rows of a mask that is read forwards, are numbered from another one
    /// on ([`Rules::numbered_from`](crate::scheme::Rules::numbered_from)).
    Numbers {
        /// The number of the point that becomes number 0, from 1.
        first: usize,
    },
}

impl fmt::Display for Correction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Correction::Way(_, way) => way.says,
            Correction::Alternative { label, .. } | Correction::Rewriting { label, .. } => label,
            Correction::Block => {
                "a power of the constant for each block of levels, not for each level"
            }
            Correction::AllSteps => "the steps of all levels of a block, not of one",
            Correction::Greatest => "the greatest of the levels of a block",
            Correction::Centred => "polygon and limit compared at the best offset",
            Correction::Numbers { first } => return numbered(f, *first),
        })
    }
}

/// The finding about a theorem.
#[derive(Clone, Debug)]
pub struct TheoremFinding<'a> {
    /// `key:theorem`.
    pub id: String,
    /// The theorem.
    pub theorem: &'a Theorem,
    /// The verdict.
    pub verdict: TheoremVerdict,
    /// The reason of the verdict, in words; `None` for an open theorem.
    pub proof: Option<String>,
    /// Of a theorem about a single scheme that is proved without a proof by hand, the levels that
    /// prove it.
    pub levels: Option<Levels>,
    /// Of a refuted theorem, the simplest data that refute it.
    pub refutation: Option<Refutation>,
    /// The cases on which it was tried.
    pub cases: Vec<CaseFinding>,
    /// Of a refuted theorem, how a reader may try to save it.
    pub corrections: Vec<Correction>,
    /// The smallest sets of corrections with which nothing refutes it.
    pub repairs: Vec<Repair>,
    /// The claims that do not hold and that it rests on, at once or through other
    /// theorems. It may be true in spite of them; its proof does not show it.
    pub failing: Vec<FailingPremise<'a>>,
    /// What Coq's kernel accepts of this, for papers that are part of the program.
    pub by_kernel: Vec<KernelProof>,
}

/// The verdict of a theorem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TheoremVerdict {
    /// It is true.
    Proved,
    /// It is false.
    Refuted,
    /// Neither is known.
    Open,
}

impl TheoremVerdict {
    /// The word for it.
    #[must_use]
    pub fn word(self) -> Word {
        match self {
            TheoremVerdict::Proved => Word::Proved,
            TheoremVerdict::Refuted => Word::Refuted,
            TheoremVerdict::Open => Word::Open,
        }
    }
}

impl TheoremFinding<'_> {
    pub(crate) fn judgement(&self) -> Judgement<'_> {
        Judgement { word: Some(self.verdict.word()), cap: None, harm: Harm::Refuted }
    }
}

/// A case, and the outcome of trying the theorem there.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseFinding {
    /// The scheme and the values.
    pub label: String,
    /// The outcome.
    pub outcome: Outcome,
}

/// A case in which a theorem is false.
#[derive(Clone, Debug, PartialEq)]
pub struct Refutation {
    /// The scheme and the values, in a few words.
    pub case: String,
    /// The scheme, as the claim refers to it.
    pub scheme: String,
    /// The values of the names that the theorem leaves open.
    pub values: Vec<(String, Rational)>,
    /// Of a distance of a ring, the weights of its limit.
    pub limit: Vec<RealCyclotomic>,
    /// The data.
    pub violation: Violation,
    /// The supremum over all control data, at this level.
    pub supremum: Option<Supremum>,
    /// The sound block bound of the distance, at this level.
    pub sound: Option<RealCyclotomic>,
    /// The result with each point at its natural parameter; `None` for differences, and where the
    /// points of all cases are at their natural parameters already, as those of rings.
    pub natural: Option<Naturally>,
    /// The result in every shift of the parameter; `None` for differences, and for rings, which
    /// have no parameter.
    pub every_shift: Option<EveryShift>,
}

/// Whether a theorem is refuted in every shift s of the parameter: with x^k_i at (i + s)/n^k for
/// every real number s, and for nets for every pair of such numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum EveryShift {
    /// It is refuted, by the same data in all shifts.
    Refuted {
        /// The scheme and the values, in a few words.
        case: String,
        /// The scheme, as the claim refers to it.
        scheme: String,
        /// The values of the names that the theorem leaves open.
        values: Vec<(String, Rational)>,
        /// The data.
        data: Box<Unshiftable>,
    },
    /// It is not refuted: with the points at their natural parameters, it holds at the levels that
    /// were looked at.
    Holds,
    /// Neither is known.
    Open,
}

/// The result for a refuted theorem with each point at its natural parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum Naturally {
    /// It is refuted there too.
    Refuted {
        /// The scheme and the values, in a few words.
        case: String,
        /// The scheme, as the claim refers to it.
        scheme: String,
        /// The values of the names that the theorem leaves open.
        values: Vec<(String, Rational)>,
        /// The data.
        violation: Box<Violation>,
        /// Whether certificates can express it.
        certifiable: bool,
    },
    /// It is refuted there by the data that refute it in every shift; no other data are known.
    AsInEveryShift,
    /// No case exceeds the bound: it holds at the levels that were looked at.
    Holds,
    /// Neither is known.
    Open,
}

/// Corrections with which nothing refutes a theorem.
#[derive(Clone, Debug, PartialEq)]
pub struct Repair {
    /// The places of the corrections.
    pub corrections: Vec<usize>,
    /// Whether it is then proved in every case that it speaks of.
    pub proved: bool,
}

/// A claim that a theorem rests on, and that does not hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FailingPremise<'a> {
    /// Its id within the paper.
    pub id: &'a str,
    /// Where it stands.
    pub locus: &'a str,
}

/// The outcome of a trial.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// The bound is exceeded.
    Refuted(Box<Violation>),
    /// It holds at every level.
    Proved,
    /// The bound holds at the levels up to this one, and no later level is shown to exceed it.
    UpTo(u32),
    /// Nothing is known, for this reason.
    Unknown(Reason),
    /// The theorem does not speak of this case, for this reason.
    Outside(Reason),
}
