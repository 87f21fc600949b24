//! Why a certificate is rejected: one reason for each side condition of FORMAT.md.

use std::fmt;

/// Declares reasons, each with the text that it is reported by.
macro_rules! reasons {
    ($(#[$doc:meta])* $type:ident: $($name:ident $(($of:ident: $as:ty))? $text:literal)*) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, Eq)]
        pub enum $type { $(#[doc = $text] $name $(($as))?),* }

        impl fmt::Display for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    $($type::$name $(($of))? => {
                        f.write_str($text)?;
                        $(write!(f, ": {}", $of)?;)?
                    })*
                }
                Ok(())
            }
        }
    };
}

reasons! {
    /// Why a formula has no value.
    Stop:
    Unstated(name: String) "the paper does not state this parameter"
    Undefined(why: &'static str) "the definition has no value here"
    Capped(cap: &'static str) "beyond a cap of this program"
    Wrong(why: String) "the formula is wrong"
}

reasons! {
    /// A side condition that does not hold.
    Reason:
    Version "the first line is not `subcert-certificate 2`"
    Paper "the second line is not `paper` and the key of the claim file"
    Malformed(what: &'static str) "expected"
    LongLine "the line, or the certificate, is too long"
    AfterFooter "something follows the footer"
    Truncated "the footer is missing: the certificate is cut off"
    Count "the footer counts another number of blocks"
    NoSuchClaim "the claim file has no such claim"
    Field(name: String) "the claim has an unknown field"
    Twice "this claim is certified twice"
    Restated(what: &'static str) "this is not what the claim file says"
    NoValue(why: String) "no closed formula"
    Value "the value is another one"
    Stopped(why: Stop) "the formula has no value"
    Cell "there is no such cell here; they are listed row by row"
    CellsMissing "cells of the table are missing"
    Printed "the cell is printed otherwise"
    Lost "a lost cell has no verdict, and a printed one is not lost"
    Assumed "other parameters have to be assumed"
    NotNearest "the printed number is not the correctly rounded value"
    Nearest "the printed number is the correctly rounded value"
    NotRounded "the printed number is not the value rounded so"
    Depth "depths have roundings of their own, and no slips"
    NotThisSlip "the printed number is not this slip away from the value"
    FewDigits "the printed number has too few digits for a slip"
    Slip "the printed number is a slip away from the value"
    NoReading "no reading is given"
    NotInFamily(what: String) "the family has no such choice, way, alternative or parameter"
    Differences "the reading has too many differences"
    NotExplained "the reading does not give the printed number"
    Explained "the reading gives the printed number"
    NoFamily "a cell is refuted, and the family is not given"
    Member "this is no member of the family, or it is listed twice, or one is missing"
    Scale "the parameter that all values are proportional to is another one"
    Explains "the member explains another number of cells"
    NotBest "another member of the family explains more cells"
    Luck "luck would find a reading as good"
    NotLuck "a reading of the family is better than luck"
    NoCase "the indices have no values"
    Cases "the number of cases is another one"
    Differ(case: String) "the sides differ in a case that is not listed"
    Case "there is no such case here; they are listed in order"
    Difference "the difference of the sides is another one"
    NoDifference "the difference is 0"
    Verdict "the verdict does not follow"
    Breaks "the breaks do not increase"
    Signs "the signs are others"
    Ends "the ends are not those that are printed"
    ExactEnd "the exact end is another one"
    Relation "the printed end is not so related to the exact one"
    Class "this residue class does not attain the constant"
    Powers "the norms of the powers are not shown to be at most this"
    NotLargest "another residue class has a larger sum"
    NoPromise "the table promises nothing, or has no scheme"
    NoContraction "the constant of the block is not below 1"
    TooLarge "the bound is above what is claimed"
    Open "the theorem is open"
    NoStatement "THEOREMS.md has no such statement"
    Premise(id: String) "the proof uses a claim that is not shown to hold"
    NotListed "the claim lists another parameter here, or other values of it"
    Supposed "what the theorem supposes does not hold"
    Taken "two witnesses have this name"
    NoWitness "no witness has this name"
    Promises "each printed cell has a line about its promise, row by row"
    Flow "the flow carries something else"
    Weights "these are not the weights of the limit"
    Level "the theorem is not stated for this level, or it is beyond the cap"
    Single "the claim does not speak of one scheme alone"
    Growth "the bound grows otherwise, or is not proportional to the spread"
    Contraction "the differences do not fall as fast as the bound"
    NoLimit "the scheme is not shown to converge"
    NegativeSpread "the spread of the data is negative"
    Negative "the bound is negative: it presupposes something that does not hold"
    NotViolated "the bound is not violated"
}

/// A reason, and the line of the certificate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rejection {
    /// The line, counted from 1; 0 while it is the line at hand.
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

    /// At this line, if it has none of its own.
    pub(crate) fn at(mut self, line: usize) -> Rejection {
        self.line = if self.line == 0 { line } else { self.line };
        self
    }
}

impl From<Reason> for Rejection {
    fn from(reason: Reason) -> Rejection {
        Rejection { line: 0, reason }
    }
}

impl From<Stop> for Rejection {
    fn from(stop: Stop) -> Rejection {
        Reason::Stopped(stop).into()
    }
}

/// What a check gives.
pub type Checked<T> = Result<T, Rejection>;

/// Makes sure of a side condition.
pub fn require(holds: bool, otherwise: Reason) -> Checked<()> {
    if holds { Ok(()) } else { Err(otherwise.into()) }
}
