//! What a certificate of a joint spectral radius, embedded in a block, shows of the limits of a mask.

use crate::claims::Paper;
use crate::formulas::Scope;
use crate::functions::exponent::{Bound, LogSum};
use crate::numbers::{Q, Value};
use crate::radius::{Radius, check_mask, has_independent_shifts};
use crate::schemes::Scheme;
use crate::text::{
    Block, Checked, RadiusReason, RadiusRejection, Reason, Rejection, Stop, Toml, words,
};

/// What is shown of the limits of a mask.
pub struct CurveProof {
    radius: Radius,
    mask: Vec<Vec<Q>>,
}

/// Checks `SCHEME` and the lines of a radius, and makes known what they show.
pub fn check<'a>(paper: &'a Paper<'a>, said: &str, block: &mut Block<'_>) -> Checked<()> {
    let [reference] = words(said, "SCHEME")?;
    let schemes = paper.library.resolve(reference, &paper.library.closed())?;
    let [scheme] = &schemes[..] else { return Err(Reason::Single.into()) };
    let shown = CurveProof::read(paper, rational(scheme)?, block)?;
    paper.library.limits.show(&scheme.mask, shown.radius);
    Ok(())
}

/// The rational mask of a scheme.
fn rational(scheme: &Scheme) -> Result<Vec<Vec<Q>>, Stop> {
    let mask = Value::rationals(&scheme.mask);
    mask.ok_or(Stop::Undefined("a coefficient of the mask is irrational"))
}

/// The mask of the claim's scheme, in this scope.
pub fn mask(paper: &Paper<'_>, claim: &Toml, scope: &Scope<'_>) -> Checked<Vec<Vec<Q>>> {
    let reference = claim.text("scheme").ok_or(Reason::Single)?;
    let schemes = paper.library.resolve(reference, scope)?;
    let [scheme] = &schemes[..] else { return Err(Reason::Single.into()) };
    Ok(rational(scheme)?)
}

/// The same reason of a block.
pub fn rejected(RadiusRejection { line, reason }: RadiusRejection) -> Rejection {
    let reason = match reason {
        RadiusReason::Stopped(stop) => Reason::Stopped(stop),
        reason => Reason::Radius(reason),
    };
    Rejection { line, reason }
}

impl CurveProof {
    /// Reads the lines from `order` to `end` and checks them.
    pub fn read(
        paper: &Paper<'_>,
        mask: Vec<Vec<Q>>,
        block: &mut Block<'_>,
    ) -> Checked<CurveProof> {
        let mut lines = Vec::new();
        block.look();
        let first = block.at;
        while let Some(line) = block.peek() {
            block.any()?;
            if line.text == "end" {
                let meter = paper.library.meter;
                let radius = check_mask(&mask, first, &lines, line.number, meter);
                let radius = radius.map_err(rejected)?;
                return Ok(CurveProof { radius, mask });
            }
            lines.push(line);
        }
        Err(Reason::Malformed("the end of the radius").into())
    }

    /// Whether the scheme converges.
    pub fn converges(&self) -> bool {
        self.radius.continuous.is_some()
    }

    /// Whether all limits are C^m.
    pub fn continuous(&self, m: usize) -> bool {
        self.radius.continuous.is_some_and(|shown| m <= shown)
    }

    /// Whether not all limits are C^m.
    pub fn not_continuous(&self, m: usize) -> bool {
        self.radius.not_continuous.is_some_and(|shown| shown <= m)
    }

    /// Whether the exponent is at least this number; with `strictly`, greater.
    pub fn at_least(&self, value: &LogSum, strictly: bool) -> Checked<bool> {
        let Some(order) = self.radius.order.filter(|_| self.radius.continuous.is_some()) else {
            return Ok(false);
        };
        let bound =
            Bound { order, arity: self.mask.len(), radius: &self.radius.at_most, degree: 1 };
        let found = bound.compare(value)?;
        Ok(if strictly { found.is_gt() } else { found.is_ge() })
    }

    /// Whether the exponent is at most this number; with `strictly`, less.
    pub fn at_most(&self, value: &LogSum, strictly: bool) -> Checked<bool> {
        let (Some(order), Some((radius, degree))) = (self.radius.order, &self.radius.at_least)
        else {
            return Ok(false);
        };
        if !self.converges() || !has_independent_shifts(&self.mask)? {
            return Ok(false);
        }
        let found =
            Bound { order, arity: self.mask.len(), radius, degree: *degree }.compare(value)?;
        Ok(if strictly { found.is_lt() } else { found.is_le() })
    }
}
