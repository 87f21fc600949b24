//! The reasons for which a certificate is rejected. There is one for each side condition of
//! the format.

use std::fmt;

/// A value, a count or words that a certificate says or that the checker found. If it is long, its
/// beginning and its end are displayed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Text(pub String);

impl From<String> for Text {
    fn from(text: String) -> Text {
        Text(text)
    }
}

impl fmt::Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text: Vec<char> = self.0.chars().collect();
        let part = |range: std::ops::Range<usize>| text[range].iter().collect::<String>();
        match text.len() {
            0 => f.write_str("nothing"),
            1..65 => f.write_str(&self.0),
            all => write!(f, "{}…{} ({all} characters)", part(0..40), part(all - 20..all)),
        }
    }
}

/// Declares reasons, each with its fields and with the message that shows them.
macro_rules! reasons {
    ($(#[$doc:meta])* $type:ident: $($name:ident $(($($of:ident: $as:ty),+))? $text:literal)*) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, Eq)]
        pub enum $type { $(#[doc = concat!("«", $text, "»")] $name $(($($as),+))?),* }

        impl fmt::Display for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    $($type::$name $(($($of),+))? => write!(f, $text),)*
                }
            }
        }
    };
}

reasons! {
    /// The reason for which a formula has no value.
    Stop:
    Unstated(name: String) "the paper does not state the parameter {name}"
    Undefined(why: &'static str) "the definition has no value here: {why}"
    Capped(cap: &'static str) "this is beyond a cap of the checker: {cap}"
    Wrong(why: String) "the formula is wrong: {why}"
    OtherRoot "the formula is wrong: such a root is for relations between numbers"
    Family(what: &'static str) "the rules of families do not give this for all values of the index: {what}"
    Integers(what: &'static str) "the rules of functions of an integer do not give this: {what}"
    Undecided(what: &'static str) "enclosures of so many digits do not decide {what}"
}

reasons! {
    /// A side condition that does not hold. Of two fields, the first is what the certificate says.
    Reason:
    Version(said: Text) "the first line is `{said}`, and not `subcert-certificate 4`"
    Paper(said: Text, key: Text) "the second line is `{said}`, and not `paper {key}`"
    Project(said: Text, key: Text) "the second line is `{said}`, and not `project {key}`"
    Malformed(what: &'static str) "the line does not have the form that is expected: {what}"
    LongLine "the line, or the certificate, is too long"
    AfterFooter "the certificate goes on after its footer"
    Truncated "the footer is missing: the certificate is cut off"
    Count(said: Text, found: Text) "the footer says {said}, and the number of blocks is {found}"
    NoSuchClaim "the claim file has no such claim"
    Field(name: String) "the claim has an unknown field: {name}"
    Twice "this claim is certified twice"
    Restated(said: Text, found: Text) "the certificate says `{said}`, and the claim file says `{found}`"
    NoValue(why: String) "this is no closed formula: {why}"
    Value(said: Text, found: Text) "the certificate says {said}, and it is {found}"
    Stopped(why: Stop) "the formula has no value: {why}"
    Cell "the table has no such cell here; the cells are listed row by row"
    CellsMissing "cells of the table are missing"
    Printed(said: Text, found: Text) "the certificate says `{said}`, and the claim file prints `{found}`"
    Lost "a lost cell has a verdict, or a printed cell is called lost"
    Assumed(said: Text, found: Text) "the assumptions do not fit: the certificate says {said}, and it is {found}"
    NotRecovered "the cell is not reproduced: its parameters are stated, or not recovered, or the reading does not give it as it stands"
    Recovered(name: String) "the paper states this parameter, or it has a value already: {name}"
    GivesFew "the reading gives fewer than half of the cells that it is about"
    Undetermined(name: String) "the numbers that tell the value of {name} may give it by chance"
    NotGiven(name: String, value: Text, table: String) "the numbers of {table} do not give {name} = {value}"
    NotNearest(printed: Text, value: Text) "the printed {printed} is not the correctly rounded value of {value}"
    Nearest(printed: Text, value: Text) "the printed {printed} is a rounded value of {value}"
    NotRounded(printed: Text, value: Text) "the printed {printed} is not {value} under this rounding"
    Depth "depths have roundings of their own, and no slips"
    NotThisSlip(said: Text, found: Text) "the certificate says `{said}`, and the slips from the value are: {found}"
    FewDigits(printed: Text) "the printed {printed} has too few digits for a slip"
    Slip(slip: Text) "the printed number is a slip away from the value: {slip}"
    NoReading "no reading is given"
    NotInFamily(what: String) "the family has no such choice, way, alternative or parameter: {what}"
    Differences "the reading has too many differences"
    NotExplained(printed: Text, value: Text) "the reading gives {value}, and not the printed {printed}"
    Explained(printed: Text, value: Text) "the reading gives {value}, which is printed as {printed}"
    NoFamily "a cell is refuted, and the family is not given"
    Member "this is no member of the family, or it is listed twice, or one is missing"
    Scale(said: Text, found: Text) "the certificate says {said}, and all values are proportional to {found}"
    Explains(said: Text, found: Text) "the certificate says {said}, and the numbers of explained cells are {found}"
    NotBest(said: usize, found: usize) "the certificate says that the best reading explains {said} cells, and this one explains {found}"
    Luck "unrelated numbers would fit a reading equally well by chance"
    NotLuck "a reading of the family is better than luck"
    NoCase "the indices have no values"
    Cases(said: Text, found: Text) "the certificate says {said}, and the number of cases is {found}"
    Differ(case: String, difference: Text) "what is claimed is false in a case that is not listed: ({case}); the difference of the sides is {difference}"
    NotFalse(case: String) "what is claimed is true in this case: ({case})"
    NotAll "the rule does not show every case"
    Case "there is no such case here; they are listed in order"
    Difference(said: Text, found: Text) "the certificate says {said}, and the difference of the sides is {found}"
    Bounds(case: String) "the difference of the sides is not shown to be between these numbers: ({case})"
    NoDifference "the two sides do not differ"
    NotStated(at: Text) "the claim does not state that the two sides are equal at {at}, whatever its rounded ends stand for"
    Verdict(said: Text, found: Text) "the certificate says {said}, and the verdict is {found}"
    Breaks "the breaks do not increase"
    Signs(said: Text, found: Text) "the certificate says {said}, and the signs are {found}"
    Ends(said: Text, found: Text) "the certificate says `{said}`, and the claim file prints `{found}`"
    ExactEnd(said: Text, found: Text) "the certificate says {said}, and the exact end is {found}"
    Relation(said: Text, found: Text) "the certificate says {said}, and the printed end is {found}"
    Class(said: Text, found: Text) "the certificate says {said}, and the sum of this residue class is {found}"
    Powers "the norms of the powers are not shown to be at most this"
    NotLargest "another residue class has a larger sum"
    NoPromise "the table promises nothing, or has no scheme"
    NoContraction "the constant of the block is not below 1"
    TooLarge(bound: Text, claimed: Text) "the bound is {bound}, above the {claimed} that is claimed"
    Open "the claim is open"
    OpenNumber "a number is open"
    NoStatement "THEOREMS.md has no such statement"
    Premise(id: String) "the proof uses a claim that is not shown to hold: {id}"
    NotListed(name: String) "the claim lists another parameter here, or other values of it: {name}"
    Supposed(value: Text, below: Text) "the theorem supposes that {value} is below {below}"
    Taken "two witnesses have this name"
    NoWitness "no witness has this name"
    Promises "each printed cell has a line about its promise, row by row"
    Flow(carried: Text, needed: Text) "the flow carries {carried} to a point that needs {needed}"
    Weights "these are not the weights of the limit"
    Level "the theorem is not stated for this level, or it is beyond the cap"
    Single "the claim does not speak of one scheme alone"
    Lattice(what: &'static str) "this is not so of the mask on Z^d: {what}"
    Growth(said: Text, found: Text) "the certificate says {said}, and the growth of the bound is {found}"
    Contraction(factor: Text, claimed: Text) "the differences fall by {factor}, and the bound falls by {claimed}"
    NoLines "the scheme does not take lines to lines"
    Grows "a weight is negative: one level shows nothing of the later ones"
    NoLimit "the scheme is not shown to converge"
    NegativeSpread "the spread of the data is negative"
    Negative "the bound is negative: it presupposes something that does not hold"
    Radius(why: RadiusReason) "the certificate of the radius: {why}"
    NotShown "the radius does not show this verdict"
    Said(said: Text, found: Text) "the certificate says {said}, and it is {found}"
    Vertex(what: &'static str) "this is not shown: {what}"
    NoRefutation(at: Text) "the value {at} does not refute this range"
    Uncovered "the condition is not shown in the whole printed range"
    NoLiteral(said: Text, what: &'static str) "`{said}` is no number in the language of the table: expected is {what}"
    NotRight(number: Text, verdict: Text) "by the reading the number {number} is {verdict}"
    NoNeed "a number is open, or none is wrong and better by the reading, which explains nothing"
    Form(what: String) "the file does not have the form of a file of theorems: {what}"
    Stated(said: Text, found: Text) "the theorem says {said}, and by the claim file it is {found}"
    TwiceStated(line: usize) "the theorem in line {line} says the same of the same place; a finding is stated once"
    OtherFile "another file of these has the theorems about this claim; each claim has one file"
    NotAsked "the value of the cell does not use this constant"
    NotLeast(level: i64) "the depth {level} is not the least that the constants of the proof give"
    NoValueGiven(name: String) "no valid certificate gives a value of {name}"
    Valueless(why: Stop) "what is compared has no value for some real numbers, so that the claim is open: {why}"
    NotViolated(value: Text, bound: Text) "the value is {value}, which does not violate the bound {bound}"
}

reasons! {
    /// A side condition of a certificate of a joint spectral radius that does not hold.
    RadiusReason:
    Version "the first line is not `subcert-radius 1`"
    Malformed(what: &'static str) "the line does not have the form that is expected: {what}"
    Truncated "the certificate is cut off: `end`, `at-most` or `unit` is missing"
    AfterEnd "the certificate goes on after its end, or it is too long"
    Order "this line stands twice, or after lines that have to follow it"
    Field "the polynomial of the field has a multiple root, or not just one root between the two numbers"
    Rule "the rules differ in length, or one does not sum to 1"
    SumRules "the sum rules do not hold up to this order"
    NotGreatest "the sum rules hold beyond this order"
    Size "the matrices or rows are not of one size, or beyond a cap"
    Inverse "the second matrix is not the inverse of the basis"
    Triangular "in this basis an entry to the right of a block is not 0"
    NoSuch "there is no such matrix or row"
    NoEigenvalue(bound: Text) "no such eigenvalue of this product is shown to reach {bound}"
    Outside(cost: Text, bound: Text) "the coefficients and the remainder sum to {cost}, which is more than {bound}"
    ImagesMissing "images of rows are missing"
    TooMany "there are more images than rows and matrices"
    NoMask "smoothness is that of a mask, and matrices are given"
    NotBelow "the upper bound of the radius does not show this"
    NotAbove "the lower bound of the radius does not show this"
    NotConvergent "the scheme is not shown to converge"
    Dependent "the shifts of the limit function may be linearly dependent"
    Stopped(why: Stop) "{why}"
}

reasons! {
    /// A side condition of a certificate of a depth that does not hold.
    DepthReason:
    Version "the first line is not `subcert-depth 1`"
    Malformed(what: &'static str) "the line does not have the form that is expected: {what}"
    Truncated "the certificate is cut off: `end` is missing"
    AfterEnd "the certificate goes on after its end"
    Order "this line stands twice, or after lines that have to follow it"
    Empty "the certificate says nothing of any level"
    Rule "a rule does not sum to 1"
    NoLines "the scheme does not take lines to lines, so that points have no natural parameters"
    NotConvergent "the differences are not shown to fall"
    Range "the given points determine the sets in another range"
    Outside "the parameters are not in the range"
    Twice "this level is said to be too few twice"
    NotFar "the point is not shown to be farther than the tolerance from the other set"
    Stopped(why: Stop) "{why}"
}

/// A reason to refuse a certificate, and the line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rejection<R = Reason> {
    /// The line, counted from 1. It is 0 until the line is known.
    pub line: usize,
    /// The reason.
    pub reason: R,
}

/// A reason to refuse a certificate of a joint spectral radius, and the line.
pub type RadiusRejection = Rejection<RadiusReason>;

/// A reason to refuse a certificate of a depth, and the line.
pub type DepthRejection = Rejection<DepthReason>;

impl<R> From<R> for Rejection<R> {
    fn from(reason: R) -> Rejection<R> {
        Rejection { line: 0, reason }
    }
}

macro_rules! stopped {
    ($($reason:ident: $($open:pat)?,)*) => {$(
        impl From<Stop> for Rejection<$reason> {
            fn from(stop: Stop) -> Rejection<$reason> {
                $reason::Stopped(stop).into()
            }
        }

        impl Rejection<$reason> {
            /// Whether the certificate may be right: what it says is beyond a cap, too near to call, or left open.
            /// Otherwise it is wrong.
            #[must_use]
            pub fn given_up(&self) -> bool {
                matches!(self.reason, $reason::Stopped(Stop::Capped(_) | Stop::Undecided(_) | Stop::Family(_) | Stop::Integers(_)))
                    $(|| matches!(self.reason, $open))?
            }
        }
    )*};
}

stopped! {
    Reason: Reason::Open | Reason::OpenNumber | Reason::Premise(_) | Reason::Field(_) | Reason::Valueless(_),
    RadiusReason:,
    DepthReason:,
}

/// The result of a check.
pub type Checked<T, R = Reason> = Result<T, Rejection<R>>;

/// The result of a check of a joint spectral radius.
pub type RadiusChecked<T> = Checked<T, RadiusReason>;

/// The result of a check of a depth.
pub type DepthChecked<T> = Checked<T, DepthReason>;

/// A result whose rejection gets a line.
pub trait At {
    /// The same at this line, if the rejection has no line of its own.
    #[must_use]
    fn at(self, line: usize) -> Self;
}

impl<T, R> At for Checked<T, R> {
    fn at(self, line: usize) -> Checked<T, R> {
        self.map_err(|mut rejection| {
            rejection.line = if rejection.line == 0 { line } else { rejection.line };
            rejection
        })
    }
}

/// A reason that compares what the certificate says with what the checker found.
pub type Compared = fn(Text, Text) -> Reason;

/// Checks a side condition.
pub fn require<R>(holds: bool, otherwise: R) -> Checked<(), R> {
    if holds { Ok(()) } else { Err(otherwise.into()) }
}

/// Checks a side condition on two values or texts. The rejection shows both.
pub fn compare<A, B>(holds: bool, said: &A, found: &B, otherwise: Compared) -> Checked<()>
where
    A: fmt::Display + ?Sized,
    B: fmt::Display + ?Sized,
{
    if holds {
        Ok(())
    } else {
        Err(otherwise(Text(said.to_string()), Text(found.to_string())).into())
    }
}

/// Checks that two texts are the same.
pub fn agree(said: &str, found: &str, otherwise: Compared) -> Checked<()> {
    compare(said == found, said, found, otherwise)
}
