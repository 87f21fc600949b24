//! The verdict of a number (proofs/format/shipped.md). It is that of every point of an
//! enclosure of the exact value.

use super::decided::{Ends, decided, is_rounded, within};
use super::literal::Shipped;
use super::number::Written;
use super::rounding::{Type, ten};
use super::slip::slip;
use crate::numbers::{Q, int};
use crate::text::{Outcome, Stop};
use num_traits::{Signed, Zero};
use std::fmt;

/// The most numbers of the type between the number and the nearest one.
const MAX_STEPS: u64 = 100;

/// The most digits that are counted as agreeing.
const MAX_AGREEING: usize = 60;

/// The most steps of a number that is right under a reading.
const RIGHT_STEPS: u64 = 4;

/// What is said of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It is the nearest of the type.
    Nearest,
    /// It is the exact value rounded to its digits.
    Rounded(usize),
    /// It is the exact value cut after its digits.
    Cut(usize),
    /// It is so many numbers of the type away from the nearest one.
    Ulps(u64),
    /// It was mistyped in this way.
    Misprint(&'static str),
    /// It is another number, which agrees in so many digits.
    Refuted(usize),
    /// The certificate leaves it open.
    Open,
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let outcome = self.outcome();
        match self {
            Verdict::Nearest | Verdict::Open => write!(f, "{outcome}"),
            Verdict::Rounded(digits) => write!(f, "rounded {digits}"),
            Verdict::Cut(digits) => write!(f, "cut {digits}"),
            Verdict::Ulps(steps) => write!(f, "{outcome} {steps}"),
            Verdict::Misprint(kind) => write!(f, "{outcome} {kind}"),
            Verdict::Refuted(digits) => write!(f, "{outcome} {digits}"),
        }
    }
}

impl Verdict {
    /// The outcome of a claim whose worst number this is.
    pub fn outcome(self) -> Outcome {
        match self {
            Verdict::Nearest => Outcome::Nearest,
            Verdict::Rounded(_) | Verdict::Cut(_) => Outcome::Cut,
            Verdict::Ulps(_) => Outcome::Ulps,
            Verdict::Open => Outcome::Open,
            Verdict::Misprint(_) => Outcome::Misprint,
            Verdict::Refuted(_) => Outcome::Refuted,
        }
    }

    /// Whether the number is right under a reading.
    pub fn is_right(self) -> bool {
        match self {
            Verdict::Ulps(steps) => steps <= RIGHT_STEPS,
            other => other.outcome() <= Outcome::Cut,
        }
    }
}

/// The verdict of a number of this type with the exact value x.
pub fn verdict(x: &Ends, number: &Shipped, of: Type) -> Result<Verdict, Stop> {
    if let Some(held) = &number.held {
        let (low, high) = of.cell(held);
        if within(x, &low, &high, "which number of the type is nearest")? {
            return Ok(Verdict::Nearest);
        }
    }
    if let Some(written) = &number.written {
        if written.digits >= 2 && is_rounded(x, written)? {
            return Ok(Verdict::Rounded(written.digits));
        }
        if written.digits >= 3 && is_cut(x, written)? {
            return Ok(Verdict::Cut(written.digits));
        }
    }
    if let Some(held) = &number.held {
        let steps = [&x.0, &x.1].map(|end| of.steps(end, held));
        if steps[0] != steps[1] {
            return Err(Stop::Undecided("how many numbers of the type lie between"));
        }
        if let Some(steps) = steps[0].filter(|steps| (1..=MAX_STEPS).contains(steps)) {
            return Ok(Verdict::Ulps(steps));
        }
    }
    if let Some(written) = &number.written
        && let Some(kind) = slip(x, written, number.turned(of), of)?
    {
        return Ok(Verdict::Misprint(kind));
    }
    Ok(Verdict::Refuted(match &number.held {
        Some(held) => agreeing(x, held)?,
        None => 0,
    }))
}

/// Whether w is x without its further digits: 0 ≤ |x| − |w| < 10^−places, with the same sign.
fn is_cut(x: &Ends, written: &Written) -> Result<bool, Stop> {
    let unit = ten(-written.places);
    // The range of x without its far end, for w > 0.
    let (near, far) =
        if written.value.is_negative() { (-&x.1, -&x.0) } else { (x.0.clone(), x.1.clone()) };
    let least = written.value.abs();
    let most = &least + unit;
    decided(
        !least.is_zero() && least <= near && far < most,
        least.is_zero() || far < least || most <= near,
        "whether the number is cut",
    )
}

/// The greatest a with |h − x| ≤ |x|·10^−a/2, at least 0.
fn agreeing(x: &Ends, held: &Q) -> Result<usize, Stop> {
    let what = "how many digits agree";
    // |h − x| − |x|/(2·10^a) ≤ 0 between two numbers of the sign of h.
    let agrees = |a: usize| {
        let part = ten(-i64::try_from(a).unwrap_or(0)) / int(2);
        let ends = [held / (int(1) + &part), held / (int(1) - part)];
        let [one, other] = &ends;
        let (low, high) = if one < other { (one, other) } else { (other, one) };
        within(x, low, high, what)
    };
    if held.is_zero() {
        return Ok(0);
    }
    let mut a = 0;
    while a < MAX_AGREEING && agrees(a + 1)? {
        a += 1;
    }
    Ok(a)
}
