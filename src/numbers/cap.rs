//! Caps: what this program does not compute.

use std::borrow::Cow;
use std::fmt;

/// A cap that a value is beyond: the value is not computed, so that nothing is known of it.
///
/// ```
/// let cap = subcert_numbers::cap::Cap::new("the power", 500_000);
/// assert_eq!(cap.to_string(), "the power is too large; at most 500000");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Cap {
    /// What is too large.
    pub what: Cow<'static, str>,
    /// The greatest number that is computed.
    pub most: u64,
}

impl Cap {
    /// At most `most` of `what`.
    #[must_use]
    pub fn new(what: impl Into<Cow<'static, str>>, most: u64) -> Cap {
        Cap { what: what.into(), most }
    }
}

impl fmt::Display for Cap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is too large; at most {}", self.what, self.most)
    }
}
