//! Why a certificate is rejected: one reason for each side condition of FORMAT.md.

use crate::value::Stop;
use std::fmt;

/// A side condition that does not hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// The first line names no version, or not this one.
    Version,
    /// The second line names no paper, or not that of the claim file.
    Paper,
    /// A line is not what may stand there.
    Malformed(&'static str),
    /// A line is longer than the cap.
    LongLine,
    /// Something follows the footer.
    AfterFooter,
    /// The footer is missing.
    Truncated,
    /// The footer counts another number of blocks.
    Count,
    /// The claim file has no claim of this kind and id.
    NoSuchClaim,
    /// The claim has a field that this version does not know.
    Field(String),
    /// A claim is certified twice.
    Twice,
    /// What the certificate restates is not what the claim file says.
    Restated(&'static str),
    /// A value is no closed formula.
    NoValue(String),
    /// The value of the claim's formula is another one.
    Value,
    /// The claim's formula has no value, and why.
    Stopped(Stop),
    /// There is no such cell, or the cells are not listed in order.
    Cell,
    /// Cells of the table are missing.
    CellsMissing,
    /// The printed text of the cell is another one.
    Printed,
    /// The cell is lost, and judged; or it is printed, and called lost.
    Lost,
    /// The parameters that have to be assumed are others.
    Assumed,
    /// The printed number is not the correctly rounded value.
    NotNearest,
    /// The printed number is the correctly rounded value.
    Nearest,
    /// The printed number is not the value rounded in this direction.
    NotRounded,
    /// Depths are rounded up, down or to the nearest, and no other number is.
    Depth,
    /// The printed number is not this slip away from the value.
    NotThisSlip,
    /// The printed number has too few digits for a slip.
    FewDigits,
    /// The printed number is a slip away from the value.
    Slip,
    /// A cell is read otherwise, and no reading is given.
    NoReading,
    /// There is no such choice, way, alternative or parameter in the family.
    NotInFamily(String),
    /// The reading has more differences than the family allows.
    Differences,
    /// The reading does not give the printed number.
    NotExplained,
    /// The reading gives the printed number.
    Explained,
    /// A cell is refuted, and the family is not given.
    NoFamily,
    /// The members of the family are others, or in another order.
    Member,
    /// The scale of the values is another parameter.
    Scale,
    /// A member explains another number of cells.
    Explains,
    /// Another member explains more cells than the reading, or the printed text does.
    NotBest,
    /// Luck would find a reading as good.
    Luck,
    /// Another reading is better than luck.
    NotLuck,
    /// The number of cases is another one.
    Cases,
    /// The two sides differ in a case that is not listed.
    Differ(String),
    /// A listed case does not exist, or the cases are not in order.
    Case,
    /// The difference of the two sides is another one.
    Difference,
    /// The difference is 0.
    NoDifference,
    /// No case is listed, but the verdict is `fails`; or the other way round.
    Verdict,
    /// Breaks do not increase.
    Breaks,
    /// The signs are others.
    Signs,
    /// An end of the range is missing, or is not printed.
    Ends,
    /// The exact end is another one.
    ExactEnd,
    /// The relation of the printed end to the exact one is another one.
    Relation,
    /// The residue class does not attain the constant.
    Class,
    /// A residue class has a larger sum.
    NotLargest,
    /// The table promises nothing, or its cells have no scheme.
    NoPromise,
    /// The constant of a block of levels is not below 1.
    NoContraction,
    /// The bound is above the tolerance.
    TooLarge,
    /// The theorem is open.
    Open,
    /// The statement that is cited does not exist.
    NoStatement,
    /// A claim that a cited proof uses is not shown to hold.
    Premise(String),
    /// A parameter has no value, or one that the claim does not list.
    NotListed,
    /// What the theorem supposes does not hold.
    Supposed,
    /// Two witnesses have one name.
    Taken,
    /// No witness has this name.
    NoWitness,
    /// A cell has no line about its promise, or the lines are not in order.
    Promises,
    /// The weights are not those of the limit of a ring.
    Weights,
    /// The theorem is not stated for this level, or it is beyond the cap.
    Level,
    /// The scheme is not shown to converge.
    NoLimit,
    /// The bound is negative: it presupposes something that does not hold.
    Negative,
    /// The bound is not violated.
    NotViolated,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = match self {
            Reason::Version => "the first line is not `subcert-certificate 1`",
            Reason::Paper => "the second line is not `paper` and the key of the claim file",
            Reason::Malformed(expected) => return write!(f, "expected {expected}"),
            Reason::LongLine => "the line is too long",
            Reason::AfterFooter => "something follows the footer",
            Reason::Truncated => "the footer is missing: the certificate is cut off",
            Reason::Count => "the footer counts another number of blocks",
            Reason::NoSuchClaim => "the claim file has no such claim",
            Reason::Field(name) => return write!(f, "the claim has an unknown field `{name}`"),
            Reason::Twice => "this claim is certified twice",
            Reason::Restated(what) => return write!(f, "`{what}` is not what the claim file says"),
            Reason::NoValue(why) => return write!(f, "no value: {why}"),
            Reason::Value => "the value is another one",
            Reason::Stopped(Stop::Unstated(name)) => return write!(f, "`{name}` is not stated"),
            Reason::Stopped(Stop::Undefined(why)) => return write!(f, "undefined: {why}"),
            Reason::Stopped(Stop::Capped(cap)) => return write!(f, "beyond the cap on {cap}"),
            Reason::Stopped(Stop::Split(at)) => return write!(f, "a sign changes at {at}"),
            Reason::Stopped(Stop::Wrong(why)) => return write!(f, "the formula is wrong: {why}"),
            Reason::Cell => "there is no such cell here; they are listed row by row",
            Reason::CellsMissing => "cells of the table are missing",
            Reason::Printed => "the cell is printed otherwise",
            Reason::Lost => "a lost cell has no verdict, and a printed one is not lost",
            Reason::Assumed => "other parameters have to be assumed",
            Reason::NotNearest => "the printed number is not the correctly rounded value",
            Reason::Nearest => "the printed number is the correctly rounded value",
            Reason::NotRounded => "the printed number is not the value rounded so",
            Reason::Depth => "depths have roundings of their own, and no slips",
            Reason::NotThisSlip => "the printed number is not this slip away from the value",
            Reason::FewDigits => "the printed number has too few digits for a slip",
            Reason::Slip => "the printed number is a slip away from the value",
            Reason::NoReading => "no reading is given",
            Reason::NotInFamily(what) => return write!(f, "`{what}` is not in the family"),
            Reason::Differences => "the reading has too many differences",
            Reason::NotExplained => "the reading does not give the printed number",
            Reason::Explained => "the reading gives the printed number",
            Reason::NoFamily => "the family is not given",
            Reason::Member => {
                "this is no member of the family, or it is listed twice, or one is missing"
            }
            Reason::Scale => "the parameter that all values are proportional to is another one",
            Reason::Explains => "the member explains another number of cells",
            Reason::NotBest => "another member of the family explains more cells",
            Reason::Luck => "luck would find a reading as good",
            Reason::NotLuck => "a reading of the family is better than luck",
            Reason::Cases => "the number of cases is another one",
            Reason::Differ(case) => return write!(f, "the sides differ at `{case}`, not listed"),
            Reason::Case => "there is no such case here; they are listed in order",
            Reason::Difference => "the difference of the sides is another one",
            Reason::NoDifference => "the difference is 0",
            Reason::Verdict => "the verdict does not follow",
            Reason::Breaks => "the breaks do not increase",
            Reason::Signs => "the signs are others",
            Reason::Ends => "the ends are not those that are printed",
            Reason::ExactEnd => "the exact end is another one",
            Reason::Relation => "the printed end is not so related to the exact one",
            Reason::Class => "this residue class does not attain the constant",
            Reason::NotLargest => "another residue class has a larger sum",
            Reason::NoPromise => "the table promises nothing, or has no scheme",
            Reason::NoContraction => "the constant of the block is not below 1",
            Reason::TooLarge => "the bound is above the tolerance",
            Reason::Open => "the theorem is open",
            Reason::NoStatement => "THEOREMS.md has no such statement",
            Reason::Premise(id) => return write!(f, "the proof uses `{id}`, not shown to hold"),
            Reason::NotListed => "the claim lists another parameter here, or other values of it",
            Reason::Supposed => "what the theorem supposes does not hold",
            Reason::Taken => "two witnesses have this name",
            Reason::NoWitness => "no witness has this name",
            Reason::Promises => "each printed cell has a line about its promise, row by row",
            Reason::Weights => "these are not the weights of the limit",
            Reason::Level => "the theorem is not stated for this level, or it is beyond the cap",
            Reason::NoLimit => "the scheme is not shown to converge",
            Reason::Negative => "the bound is negative, and presupposes what does not hold",
            Reason::NotViolated => "the bound is not violated",
        };
        f.write_str(text)
    }
}

/// A reason, and the line of the certificate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rejection {
    /// The line, counted from 1.
    pub line: usize,
    /// The reason.
    pub reason: Reason,
}

impl Rejection {
    /// Whether the claim was left open, not shown to be wrong.
    #[must_use]
    pub fn given_up(&self) -> bool {
        matches!(
            self.reason,
            Reason::Open | Reason::Premise(_) | Reason::Field(_) | Reason::Stopped(Stop::Capped(_))
        )
    }
}

/// What a check gives.
pub type Checked<T> = Result<T, Rejection>;
