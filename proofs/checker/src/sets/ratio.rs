//! Parameters, and indices that need not be whole, in small fractions.

use crate::numbers::{Q, capped as within};
use crate::text::{DepthChecked as Checked, Stop};
use num_integer::Integer as _;

/// A parameter, or an index that need not be whole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ratio {
    pub top: i128,
    pub bottom: i128,
}

/// What is beyond a cap.
pub fn capped<T>(what: &'static str) -> Checked<T> {
    Err(Stop::Capped(what).into())
}

impl Ratio {
    pub fn of(x: &Q) -> Checked<Ratio> {
        match (within(x.numer(), (1 << 48) - 1), within(x.denom(), (1 << 24) - 1)) {
            (Some(top), Some(bottom)) => Ok(Ratio { top: top.into(), bottom: bottom.into() }),
            _ => capped("the size of parameters"),
        }
    }

    pub fn floor(self) -> i64 {
        i64::try_from(self.top.div_euclid(self.bottom)).unwrap_or(i64::MAX)
    }

    /// self·factor + sign·other, in lowest terms.
    pub fn times_plus(self, factor: i128, sign: i128, other: Ratio) -> Checked<Ratio> {
        let first = self.top.checked_mul(factor).and_then(|x| x.checked_mul(other.bottom));
        let second = other.top.checked_mul(sign * self.bottom);
        let top = first.zip(second).and_then(|(x, y)| x.checked_add(y));
        let (Some(top), Some(bottom)) = (top, self.bottom.checked_mul(other.bottom)) else {
            return capped("the size of parameters");
        };
        let common = top.gcd(&bottom).max(1);
        let (top, bottom) = (top / common, bottom / common);
        // So that comparisons have room.
        if within(top, (1 << 62) - 1).is_some() && bottom < 1 << 46 {
            Ok(Ratio { top, bottom })
        } else {
            capped("the size of parameters")
        }
    }
}

pub fn less(x: Ratio, y: Ratio) -> bool {
    x.top * y.bottom < y.top * x.bottom
}
