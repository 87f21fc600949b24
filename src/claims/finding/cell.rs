//! The finding about a table cell.

use crate::cap::Cap;
use crate::exact::{Rational, RealCyclotomic};
use crate::finding::kernel::KernelProof;
use crate::finding::promise::Kept;
use crate::finding::reading::{Difference, Explanation, Solved, differs};
use crate::finding::reason::Reason;
use crate::verdict::Word;
use std::fmt;

/// The verdict on a printed number.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The correctly rounded value of the printed definition.
    Confirmed,
    /// The exact value of the printed definition, rounded differently in the last
    /// place.
    Rounding(Direction),
    /// One local slip away from the exact value.
    Misprint(Slip),
    /// The value of the printed definition, or of the reading that [`CellFinding::as_read`] names,
    /// at values of parameters that the paper does not state and that were recovered from its
    /// numbers.
    Reproduced,
    /// Not the value of the printed definition, but that of another reading, which
    /// [`CellFinding::as_read`] names.
    OtherReading,
    /// None of these.
    Refuted,
    /// Something that it needs is absent.
    NotCheckable(Missing),
}

impl Verdict {
    /// The word for it.
    #[must_use]
    pub fn word(&self) -> Word {
        match self {
            Verdict::Confirmed => Word::Confirmed,
            Verdict::Reproduced => Word::Reproduced,
            Verdict::Rounding(_) => Word::Rounding,
            Verdict::Misprint(_) => Word::Misprint,
            Verdict::OtherReading => Word::OtherReading,
            Verdict::Refuted => Word::Refuted,
            Verdict::NotCheckable(_) => Word::NotCheckable,
        }
    }
}

/// How a printed number was rounded, when not to the nearest (a depth: not up).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Direction {
    /// A decimal cut towards zero.
    Cut,
    /// A decimal rounded away from zero.
    Away,
    /// A depth rounded down: one level short.
    DepthDown,
    /// A depth rounded to the nearest integer.
    DepthNearest,
}

impl fmt::Display for Direction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Direction::Cut => "cut, not rounded",
            Direction::Away => "rounded away from zero",
            Direction::DepthDown => "rounded down: one level short",
            Direction::DepthNearest => "rounded to the nearest level",
        })
    }
}

/// A slip of the pen that leads from the exact value to the printed one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Slip {
    /// One digit is wrong; its place is counted from 1 among the significant digits.
    Digit {
        /// Which digit.
        position: usize,
        /// The printed text.
        printed: char,
        /// The right digit.
        correct: char,
    },
    /// Two neighbouring digits are exchanged; this is the place of the first, counted from 1.
    Swap(usize),
    /// The decimal point is this many places too far to the right.
    Exponent(i32),
    /// The sign is wrong.
    Sign,
    /// The number is that of the cell this many rows down and columns to the right.
    Neighbour(i32, i32),
    /// The number is exchanged with that of the cell this many rows down and columns to the right.
    Exchanged(i32, i32),
}

impl fmt::Display for Slip {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Slip::Digit { position, printed, correct } => {
                write!(f, "digit {position} is {printed}, and should be {correct}")
            }
            Slip::Swap(position) => {
                write!(f, "digits {position} and {} are exchanged", position + 1)
            }
            Slip::Exponent(places) => {
                let large = if *places > 0 { "large" } else { "small" };
                write!(f, "too {large} by the factor 10^{}", places.unsigned_abs())
            }
            Slip::Sign => f.write_str("the sign is wrong"),
            Slip::Neighbour(rows, columns) => f.write_str(match (rows, columns) {
                (_, 1..) => "this is the value of the next column",
                (_, ..=-1) => "this is the value of the column before",
                (1.., _) => "this is the value of the next row",
                _ => "this is the value of the row before",
            }),
            Slip::Exchanged(rows, columns) => f.write_str(match (rows, columns) {
                (_, 1..) => "exchanged with the next column",
                (_, ..=-1) => "exchanged with the column before",
                (1.., _) => "exchanged with the next row",
                _ => "exchanged with the row before",
            }),
        }
    }
}

/// Why a number cannot be checked.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Missing {
    /// The source at hand has lost the cell.
    Cell,
    /// Nothing is printed in the cell.
    Number,
    /// The paper does not state these parameters.
    Parameters(Vec<String>),
    /// The value is beyond a cap of this program.
    Capacity(Cap),
    /// The value under a reading, which may explain the number, is beyond a cap.
    Reading(Cap),
}

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Missing::Cell => f.write_str("the cell is lost"),
            Missing::Number => f.write_str("nothing is printed there"),
            Missing::Parameters(names) => {
                write!(f, "the paper does not state {}", names.join(", "))
            }
            Missing::Capacity(cap) => cap.fmt(f),
            Missing::Reading(cap) => write!(f, "a reading may explain it; {cap}"),
        }
    }
}

/// Parameters that the paper does not state, with the values that were assumed or recovered for
/// them.
pub type Assumed = Vec<(String, Rational)>;

/// The sound value of a bound or depth, whatever the verdict is.
#[derive(Clone, Debug, PartialEq)]
pub enum Sound {
    /// A depth.
    Depth {
        /// The least level at which the sound bound meets the tolerance.
        level: u32,
        /// The block length c of that bound.
        block: u32,
    },
    /// Of a ring: the least level, exactly, from which on all levels meet the tolerance.
    Least(u32),
    /// An upper bound of the distance.
    Bound(Rational),
    /// No sound value, and why.
    None(Reason),
}

/// A cell under another reading than the printed one.
#[derive(Clone, Debug, PartialEq)]
pub struct AsRead {
    /// How the reading differs from the printed text.
    pub differences: Vec<Difference>,
    /// The parameters that were solved for.
    pub solved: Vec<Solved>,
    /// The rounding of this cell, where it is not that of the reading.
    pub rounded: Option<Direction>,
    /// The value of the cell under the reading.
    pub value: RealCyclotomic,
}

impl AsRead {
    /// Whether the cell is read by this reading.
    #[must_use]
    pub fn is(&self, reading: &Explanation) -> bool {
        self.differences == reading.differences && self.solved == reading.solved
    }

    /// How the reading differs from the printed text, in words.
    #[must_use]
    pub fn differs(&self) -> String {
        let differs = differs(&self.differences, &self.solved);
        self.rounded.map_or(differs.clone(), |direction| format!("{differs}; {direction}"))
    }
}

/// The finding about a table cell.
#[derive(Clone, Debug, PartialEq)]
pub struct CellFinding {
    /// `key:table:row:column`, with row and column counted from 1.
    pub id: String,
    /// Table, row and column in words.
    pub locus: String,
    /// The cell as printed; `None` when it is lost.
    pub printed: Option<String>,
    /// Why the number that was read is not the printed text, where they differ.
    pub note: Option<String>,
    /// The verdict.
    pub verdict: Verdict,
    /// The value of the printed definition, if it has one.
    pub exact: Option<RealCyclotomic>,
    /// The reading that explains the cell, or from whose value the cell is one slip away.
    pub as_read: Option<AsRead>,
    /// Why the printed definition has no value here, where it has none.
    pub undefined: Option<String>,
    /// The values, assumed or recovered, of parameters that the paper does not state and at which
    /// `exact` and `sound` were computed; empty when all are stated.
    pub assumed: Assumed,
    /// A parameter that the value needs and that has no known value.
    pub unknown: Option<String>,
    /// The verdict if the assumed values were stated; `None` where all values are stated, or the
    /// cell is reproduced.
    pub verdict_if_assumed: Option<Verdict>,
    /// The sound value, for a bound or a depth.
    pub sound: Option<Sound>,
    /// Whether the printed number is at least the value of the printed formula, of a depth rounded
    /// up.
    pub kept_by_formula: Option<bool>,
    /// Whether the printed number is at least the sound value, so that it keeps its promise.
    pub kept_by_sound: Option<bool>,
    /// Whether the printed number keeps its promise for all control data.
    pub kept: Option<Kept>,
    /// For curves and nets, if it is not shown to keep its promise with the points at i/n^k:
    /// whether it does with each point at its natural parameter.
    pub kept_naturally: Option<Kept>,
    /// The natural parameters of the points then, along each direction; empty without such a result.
    pub natural: Vec<PointsAt>,
    /// What Coq's kernel accepts of this, for papers that are part of the program.
    pub by_kernel: Vec<KernelProof>,
}

/// The points of level k along a direction stand at the parameters (i + s)/n^k.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PointsAt {
    /// n.
    pub arity: usize,
    /// s.
    pub shift: Rational,
}

impl CellFinding {
    /// Whether nothing is printed in the cell.
    #[must_use]
    pub fn is_blank(&self) -> bool {
        self.verdict == Verdict::NotCheckable(Missing::Number)
    }

    /// What is printed; `lost`, or a dash where nothing is.
    #[must_use]
    pub fn shown(&self) -> &str {
        self.printed.as_deref().unwrap_or(if self.is_blank() { "—" } else { "lost" })
    }

    /// Whether the printed number keeps its promise, by the exact distances or by the
    /// sound bound; `None` where there is none, or neither shows it.
    #[must_use]
    pub fn keeps_promise(&self) -> Option<bool> {
        match &self.kept {
            Some(Kept::Yes) => Some(true),
            Some(Kept::No(_)) => Some(false),
            Some(Kept::Open(_)) | None => self.kept_by_sound.filter(|kept| *kept),
        }
    }

    /// Whether every parameter that its value needs is stated.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.assumed.is_empty() && self.unknown.is_none()
    }

    /// The kind of cells of the table with which this cell is read.
    #[must_use]
    pub fn kind(&self) -> CellKind {
        if self.is_plain() { CellKind::Plain } else { CellKind::Assumed }
    }

    /// Whether the cell makes a promise and it is not known whether it keeps the promise.
    #[must_use]
    pub fn may_break_promise(&self) -> bool {
        self.printed.is_some() && self.sound.is_some() && self.keeps_promise().is_none()
    }
}

/// A kind of cells of a table. Cells of different kinds are read separately.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellKind {
    /// The cells whose value as printed needs no assumption.
    Plain,
    /// The cells whose value as printed needs assumed or recovered parameters.
    Assumed,
}

impl CellKind {
    pub(crate) fn holds(self, finding: &CellFinding) -> bool {
        finding.kind() == self
    }

    /// The kinds of the printed cells of a table.
    pub(crate) fn of(findings: &[Vec<CellFinding>]) -> Vec<CellKind> {
        let printed = || findings.iter().flatten().filter(|finding| finding.printed.is_some());
        let kinds = [CellKind::Plain, CellKind::Assumed].into_iter();
        kinds.filter(|kind| printed().any(|finding| kind.holds(finding))).collect()
    }
}
