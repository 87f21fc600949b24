//! The finding about a claim of smoothness.

use super::judgement::{Harm, Judgement};
use crate::cap::Cap;
use crate::characteristic::{Family, Vertex, VertexRange};
use crate::claim::SmoothnessClaim;
use crate::evaluation::Limits;
use crate::exact::{IntervalSet, Rational};
use crate::finding::cell::Direction;
use crate::finding::reason::Reason;
use crate::lattice::{LatticeRange, LatticeSmoothness};
use crate::scheme::LatticeMask;
use crate::smoothness::{Hoelder, RegionProof, SmoothRange, Smoothness};
use crate::verdict::Word;

/// The finding about a claim of smoothness.
#[derive(Clone, Debug)]
pub struct SmoothnessFinding<'a> {
    /// `key:claim`.
    pub id: String,
    /// The claim.
    pub claim: &'a SmoothnessClaim,
    /// The verdict.
    pub verdict: SmoothnessVerdict,
    /// What is known of the limits.
    pub known: KnownLimits,
}

/// The verdict of a claim of smoothness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SmoothnessVerdict {
    /// It is proved.
    Confirmed,
    /// A printed decimal is cut, or rounded away from zero.
    Rounding(Direction),
    /// A printed range is right up to the rounding of its ends.
    RoundedEnds,
    /// It is wrong.
    Refuted,
    /// Neither is shown.
    Open,
    /// The paper lacks something, or the rules are beyond a cap.
    NotCheckable,
}

impl SmoothnessVerdict {
    /// The verdict of a claim that says all of these, each true, false or not decided.
    #[must_use]
    pub fn of_all(parts: &[Option<bool>]) -> SmoothnessVerdict {
        if parts.contains(&Some(false)) {
            SmoothnessVerdict::Refuted
        } else if parts.contains(&None) {
            SmoothnessVerdict::Open
        } else {
            SmoothnessVerdict::Confirmed
        }
    }

    /// The word for it.
    #[must_use]
    pub fn word(self) -> Word {
        match self {
            SmoothnessVerdict::Confirmed => Word::Confirmed,
            SmoothnessVerdict::Rounding(_) | SmoothnessVerdict::RoundedEnds => Word::Rounding,
            SmoothnessVerdict::Refuted => Word::Refuted,
            SmoothnessVerdict::Open => Word::Open,
            SmoothnessVerdict::NotCheckable => Word::NotCheckable,
        }
    }
}

impl SmoothnessFinding<'_> {
    pub(crate) fn judgement(&self) -> Judgement<'_> {
        let cap = if let KnownLimits::BeyondCap(cap) = &self.known { Some(cap) } else { None };
        Judgement { word: Some(self.verdict.word()), cap, harm: Harm::Refuted }
    }
}

/// What is known of the limits that a claim is about.
#[derive(Clone, Debug)]
pub enum KnownLimits {
    /// The limits of one mask.
    Limits(Box<Limits>),
    /// The limits of one mask on Z^d.
    Lattice(Box<LatticeLimits>),
    /// The limits for all values of a parameter.
    Range(Box<RangeOfLimits>),
    /// The limits for values of two parameters.
    Region(Box<RegionOfLimits>),
    /// The surfaces at a vertex or on a face.
    Vertices(Box<Vertices>),
    /// The surfaces there for all values of a parameter, at each valence.
    VertexRanges(Vec<RangeAtValence>),
    /// The paper lacks something, as the claim says.
    Absent,
    /// The cap that the rules are beyond.
    Capped(Reason),
    /// Nothing: a value that the claim needs is beyond a cap.
    BeyondCap(Cap),
}

/// A mask on Z^d, and what is proved of its limits.
#[derive(Clone, Debug)]
pub struct LatticeLimits {
    /// The mask.
    pub mask: LatticeMask,
    /// What is proved.
    pub smoothness: LatticeSmoothness,
}

/// What is proved of the limits of one mask, of any kind.
#[derive(Clone, Copy, Debug)]
pub struct Proven<'k> {
    /// All limits are C^m for this m.
    pub continuity: Option<usize>,
    /// Not all limits are C^m for this m.
    pub continuity_fails: Option<usize>,
    /// The Hölder exponent.
    pub hoelder: Option<&'k Hoelder>,
}

impl<'k> Proven<'k> {
    /// Whether all limits are C^m, where that is decided.
    #[must_use]
    pub fn is_continuous(&self, m: usize) -> Option<bool> {
        if self.continuity.is_some_and(|proved| m <= proved) {
            return Some(true);
        }
        self.continuity_fails.is_some_and(|fails| fails <= m).then_some(false)
    }

    /// What is proved of the limits of a mask of curves.
    #[must_use]
    pub fn of_curve(found: &'k Smoothness) -> Proven<'k> {
        let Smoothness { continuity, continuity_fails, hoelder, .. } = found;
        Proven {
            continuity: *continuity,
            continuity_fails: *continuity_fails,
            hoelder: hoelder.as_ref(),
        }
    }

    /// What is proved of the limits of a mask on Z^d.
    #[must_use]
    pub fn of_lattice(found: &'k LatticeSmoothness) -> Proven<'k> {
        let order = |m: Option<u32>| m.and_then(|m| usize::try_from(m).ok());
        Proven {
            continuity: order(found.continuity),
            continuity_fails: order(found.continuity_fails),
            hoelder: found.hoelder.as_ref(),
        }
    }
}

impl KnownLimits {
    /// What is proved of the limits, where they are those of one mask.
    #[must_use]
    pub fn proven(&self) -> Option<Proven<'_>> {
        match self {
            KnownLimits::Limits(limits) => Some(Proven::of_curve(&limits.smoothness)),
            KnownLimits::Lattice(limits) => Some(Proven::of_lattice(&limits.smoothness)),
            _ => None,
        }
    }

    /// Whether both are of one and the same mask.
    #[must_use]
    pub fn is_of_mask_of(&self, other: &KnownLimits) -> bool {
        match (self, other) {
            (KnownLimits::Limits(one), KnownLimits::Limits(other)) => one.mask == other.mask,
            (KnownLimits::Lattice(one), KnownLimits::Lattice(other)) => {
                one.mask.dilation() == other.mask.dilation()
                    && one.mask.coefficients() == other.mask.coefficients()
            }
            _ => false,
        }
    }
}

/// What is known of the surfaces at a vertex or on a face.
#[derive(Clone, Debug)]
pub struct Vertices {
    /// The regular part, if they are proved C¹ at all valences from 3 on (`proofs/THEOREMS.md`, 133 and 135).
    pub all: Option<Family>,
    /// What is known at single valences. Where the claim is about all and refuted, the first that refutes it stands
    /// last.
    pub vertices: Vec<Vertex>,
}

/// What is proved of the limits for the values of a parameter.
#[derive(Clone, Debug)]
pub struct RangeOfLimits {
    /// The sets inside and outside; `None` where the sum rules that C^m needs hold at single values only.
    pub sets: Option<SmoothSets>,
    /// The printed interval.
    pub printed: IntervalSet,
    /// Values of the printed interval that are in neither set, and where the paper says that there are no
    /// other values, such values beyond it.
    pub undecided: IntervalSet,
    /// A value that refutes the claim.
    pub witness: Option<Witness>,
    /// The contraction that proves it in the whole printed interval.
    pub contraction: Option<Contraction>,
}

/// Where in a parameter the limits of one mask are C^m, and where not.
#[derive(Clone, Debug)]
pub enum SmoothSets {
    /// Of a mask of curves.
    Curve(Box<SmoothRange>),
    /// Of a mask on Z^d.
    Lattice(Box<LatticeRange>),
}

impl SmoothSets {
    /// There all limits are C^m.
    #[must_use]
    pub fn inside(&self) -> &IntervalSet {
        match self {
            SmoothSets::Curve(range) => &range.inside,
            SmoothSets::Lattice(range) => &range.inside,
        }
    }

    /// There not all limits are C^m, or the scheme diverges.
    #[must_use]
    pub fn outside(&self) -> &IntervalSet {
        match self {
            SmoothSets::Curve(range) => &range.outside,
            SmoothSets::Lattice(range) => &range.outside,
        }
    }

    /// Whether finitely many values outside may be exceptions.
    #[must_use]
    pub fn but_finitely_many(&self) -> bool {
        match self {
            SmoothSets::Curve(range) => range.but_finitely_many,
            SmoothSets::Lattice(range) => range.but_finitely_many,
        }
    }
}

/// What is proved of the limits for the values of two parameters.
#[derive(Clone, Debug)]
pub struct RegionOfLimits {
    /// What proves that all limits are C^m in the whole region.
    pub proof: Option<RegionProof>,
    /// The corners of the polygon, counterclockwise.
    pub corners: Vec<[Rational; 2]>,
    /// A point that refutes the claim.
    pub witness: Option<Witness<[Rational; 2]>>,
    /// The points that were tried.
    pub tried: usize,
}

/// What is proved of surfaces at a vertex or on a face for the values of a parameter.
#[derive(Clone, Debug)]
pub struct RangeAtValence {
    /// Where they are C¹, and where not, and the valence.
    pub range: VertexRange,
    /// As [`RangeOfLimits::undecided`].
    pub undecided: IntervalSet,
    /// A value that refutes the claim.
    pub witness: Option<VertexWitness>,
}

/// A value of the parameter that refutes a printed range of rules.
#[derive(Clone, Debug)]
pub struct VertexWitness {
    /// The value.
    pub at: Rational,
    /// As [`Witness::inside`].
    pub inside: bool,
    /// What is known of the surface at this value.
    pub vertex: Vertex,
}

/// The norm of so many levels of the differences of a derived scheme, which proves C^m where it is below 1.
#[derive(Clone, Debug)]
pub struct Contraction {
    /// The number of levels.
    pub levels: u32,
    /// As [`SmoothRange::reduction`].
    pub reduction: Vec<Vec<Rational>>,
    /// Where the norm is below 1.
    pub below: IntervalSet,
    /// Where it is above 1.
    pub above: IntervalSet,
}

/// A value of the parameter, or of two, that refutes a printed range.
#[derive(Clone, Debug)]
pub struct Witness<P = Rational> {
    /// The value.
    pub at: P,
    /// Whether it is in the printed range; then the limits are not all C^m there. Otherwise they are, and
    /// the paper says that they are not.
    pub inside: bool,
    /// The limits of the mask at this value.
    pub limits: KnownLimits,
}
