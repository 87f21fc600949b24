//! What `subcert certify` writes.

use serde::Serialize;

/// The f64 path of a scheme against the exact one.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Certification<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The scheme as it was given.
    pub scheme: &'a str,
    /// The constants.
    pub quantities: Vec<Quantity<'a>>,
    /// The depths by the formula; missing of a ring, for which there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub depths: Option<Vec<Depth>>,
    /// The greatest block length for which an error bound is proven in advance.
    pub bounded_up_to_block: u32,
}

/// A constant in f64.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Quantity<'a> {
    /// Which constant.
    pub name: &'a str,
    /// Its value in f64.
    #[serde(rename = "f64")]
    pub float: String,
    /// Its exact value.
    pub exact: String,
    /// That value as a decimal.
    pub decimal: String,
    /// The difference of the two; null where f64 has no number.
    pub error: Option<String>,
    /// That difference in units in the last place.
    pub ulps: Option<String>,
    /// The bound of the error that is proven in advance.
    pub bound: Option<String>,
    /// Whether the error is within the bound.
    pub encloses: Option<bool>,
    /// The error as a part of the bound.
    pub tightness: Option<String>,
}

/// The least k with σβC^k/(1 − C) ≤ ε, C = T_c, in f64 and exactly: a depth by a formula, not the
/// exact depth that `subcert depth` gives.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Depth {
    /// The block length c.
    pub block: u32,
    /// The tolerance.
    pub tolerance: String,
    /// The formula with logarithms, before it is rounded up.
    pub logarithm: String,
    /// The k that f64 gives.
    #[serde(rename = "f64")]
    pub float: Option<u32>,
    /// The k, exactly.
    pub exact: Option<u32>,
    /// Why there is no k.
    pub note: Option<String>,
    /// Whether the two agree.
    pub agree: Option<bool>,
    /// How clearly k is decided.
    pub margin: Option<Margin>,
}

/// How clearly k is decided: the bound at k and at k − 1, as parts of the tolerance.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Margin {
    /// The bound at k divided by the tolerance: at most 1.
    pub at: String,
    /// The bound at k − 1 divided by the tolerance: more than 1.
    pub before: Option<String>,
}
