//! Hölder exponents, as JSON.

use crate::report::smooth::limits::decimals;
use crate::smoothness::Hoelder;
use serde::Serialize;

/// The Hölder exponent.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HoelderForm {
    /// A decimal that is not above it.
    pub lower: String,
    /// A decimal that is not below it.
    pub upper: String,
    /// A formula; null where it is not known exactly.
    pub exact: Option<String>,
    /// Whether it is attained; null where that is open.
    pub attained: Option<bool>,
}

impl HoelderForm {
    /// The form of an exponent.
    #[must_use]
    pub fn of(hoelder: &Hoelder) -> HoelderForm {
        let [lower, upper] = decimals(hoelder);
        let exact = hoelder.formula.as_ref().map(ToString::to_string);
        HoelderForm { lower, upper, exact, attained: hoelder.attained }
    }
}
