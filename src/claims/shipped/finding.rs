//! What the audit says of shipped constants.

use super::claim::{Project, ShippedClaim};
use super::number::Settled as _;
use crate::cap::Cap;
use crate::exact::{Rational, RealExpression};
use crate::verdict::Word;

/// The findings of a project.
#[derive(Clone, Debug)]
pub struct ProjectAudit<'a> {
    /// The project.
    pub project: &'a Project,
    /// One finding for each table, in the order of the claim file.
    pub findings: Vec<ShippedFinding<'a>>,
}

/// The finding of a table.
#[derive(Clone, Debug)]
pub struct ShippedFinding<'a> {
    /// `key:id`.
    pub id: String,
    /// The table.
    pub claim: &'a ShippedClaim,
    /// Its numbers, in order.
    pub cells: Vec<ShippedCell>,
    /// How the table came about, where it is not what it is said to equal.
    pub reading: Option<Reading>,
    /// The worst that is said of a number, or that a reading explains the table.
    pub outcome: Outcome,
    /// The place of the number with the greatest error, if a number has one.
    pub farthest: Option<usize>,
    /// Lines whose sums are not as exact.
    pub sums: Option<BrokenSums>,
    /// Equal values that are shipped differently.
    pub equals: Option<SplitEquals>,
}

impl ShippedFinding<'_> {
    /// Whether every number is the nearest of its type.
    #[must_use]
    pub fn is_right(&self) -> bool {
        self.outcome == Outcome::Nearest
    }

    /// Whether the table has this outcome, or a number in it where no reading explains the table.
    #[must_use]
    pub fn has(&self, outcome: Outcome) -> bool {
        if self.reading.is_some() {
            return outcome == Outcome::Otherwise;
        }
        self.count(|verdict| verdict.outcome() == outcome) > 0
    }

    /// Whether a number is at most `tolerance` from its exact value, if that is decided.
    #[must_use]
    pub fn is_within(&self, place: usize, tolerance: &Rational) -> Option<bool> {
        let exact = self.cells[place].exact.as_ref().ok()?;
        exact.is_near(&self.claim.numbers[place].held, tolerance)
    }

    /// How many numbers have a verdict for which `is` holds.
    #[must_use]
    pub fn count(&self, is: impl Fn(Verdict) -> bool) -> usize {
        self.cells.iter().filter(|cell| is(cell.verdict)).count()
    }
}

/// A number, and what is said of it.
#[derive(Clone)]
pub struct ShippedCell {
    /// The exact value, or the cap that it is beyond.
    pub exact: Result<RealExpression, Cap>,
    /// The verdict.
    pub verdict: Verdict,
    /// |held − exact|: 0 where these are equal, else right to 20 digits; `None` where that is not decided, or beyond a cap.
    pub error: Option<Rational>,
}

impl std::fmt::Debug for ShippedCell {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match &self.exact {
            Ok(exact) => write!(f, "{exact}: {:?}", self.verdict),
            Err(cap) => write!(f, "{cap}: {:?}", self.verdict),
        }
    }
}

/// What is said of a number x, which is written as w and held as h. The first that applies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// h is the nearest to x of its type.
    Nearest,
    /// w is x, rounded to the digits that are written, which are so many.
    Rounded(usize),
    /// w is x, cut to the digits that are written, which are so many.
    Cut(usize),
    /// h is so many numbers of its type away from the nearest one.
    Ulps(u64),
    /// w differs from the right digits as by a slip in typing.
    Misprint(Misprint),
    /// So many leading digits agree.
    Refuted(u32),
    /// It was not decided within the caps, or the value is beyond one.
    Open,
}

impl Verdict {
    /// Whether the number is as exact as its digits or its type allow, up to a few last places.
    #[must_use]
    pub fn is_accepted(self) -> bool {
        match self {
            Verdict::Nearest | Verdict::Rounded(_) | Verdict::Cut(_) => true,
            Verdict::Ulps(units) => units <= 4,
            _ => false,
        }
    }

    /// The outcome of a table of which this is the worst verdict.
    #[must_use]
    pub fn outcome(self) -> Outcome {
        match self {
            Verdict::Nearest => Outcome::Nearest,
            Verdict::Rounded(_) | Verdict::Cut(_) => Outcome::Cut,
            Verdict::Ulps(_) => Outcome::Ulps,
            Verdict::Misprint(_) => Outcome::Misprint,
            Verdict::Refuted(_) => Outcome::Refuted,
            Verdict::Open => Outcome::Open,
        }
    }
}

/// A slip in typing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Misprint {
    /// The sign is wrong.
    Sign,
    /// The point stands in the wrong place.
    Point,
    /// One digit is wrong.
    Digit,
    /// Two neighbouring digits are exchanged.
    Exchanged,
    /// A digit is missing.
    Dropped,
}

impl Misprint {
    /// Its name, as in certificates.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Misprint::Sign => "sign",
            Misprint::Point => "point",
            Misprint::Digit => "digit",
            Misprint::Exchanged => "exchanged",
            Misprint::Dropped => "dropped",
        }
    }
}

/// How a table came about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reading {
    /// It follows the other convention of this number, from 0.
    Convention(usize),
    /// A definition was rounded before it was used.
    Early(String, Early),
}

/// How a definition was rounded before it was used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Early {
    /// To so many digits after the point.
    Places(u32),
    /// Cut after so many digits after the point.
    Cut(u32),
    /// To the nearest f32.
    Single,
}

/// What is said of a table; from the best to the worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outcome {
    /// Every number is the nearest of its type.
    Nearest,
    /// Some are rounded or cut to the digits that are written.
    Cut,
    /// Some are units in the last place away from the nearest one.
    Ulps,
    /// A reading explains the table.
    Otherwise,
    /// Some were not decided.
    Open,
    /// Some are misprints.
    Misprint,
    /// Some are wrong.
    Refuted,
}

impl Outcome {
    /// All, from the best to the worst.
    pub const ALL: [Outcome; 7] = [
        Outcome::Nearest,
        Outcome::Cut,
        Outcome::Ulps,
        Outcome::Otherwise,
        Outcome::Open,
        Outcome::Misprint,
        Outcome::Refuted,
    ];

    /// The word for it, as in `--deny` and in certificates.
    #[must_use]
    pub fn word(self) -> Word {
        match self {
            Outcome::Nearest => Word::Nearest,
            Outcome::Cut => Word::Cut,
            Outcome::Ulps => Word::Ulps,
            Outcome::Otherwise => Word::Otherwise,
            Outcome::Open => Word::Open,
            Outcome::Misprint => Word::Misprint,
            Outcome::Refuted => Word::Refuted,
        }
    }
}

/// Lines along the last index that all have one exact sum, but not as shipped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BrokenSums {
    /// The exact sum.
    pub exact: Rational,
    /// The place of the first number of the line that is farthest from it.
    pub first: usize,
    /// The sum of the numbers held there.
    pub held: Rational,
    /// The greatest distance of a sum of the nearest numbers of the type.
    pub nearest: Rational,
    /// How many lines are farther from it.
    pub lines: usize,
}

/// Numbers of one exact absolute value of which different ones are shipped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SplitEquals {
    /// How many such values there are.
    pub values: usize,
    /// Two places with one of them.
    pub pair: [usize; 2],
}
