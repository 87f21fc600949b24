//! What `subcert range` writes.

use serde::Serialize;
pub use subcert::report::json::{Interval, RootNumber as Number};

/// Where in a parameter T_c < 1.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Range<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The scheme as it was given.
    pub scheme: &'a str,
    /// The parameter.
    pub parameter: &'a str,
    /// The sets for c = 1, 2, …
    pub levels: Vec<Level>,
    /// The union of these sets.
    pub union: Vec<Interval>,
}

/// Where T_c < 1.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Level {
    /// c.
    pub c: u32,
    /// The set.
    pub intervals: Vec<Interval>,
    /// T_c as a function of the parameter; null where it was not asked for.
    pub function: Option<Function>,
}

/// A piecewise polynomial function.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Function {
    /// Where one piece ends and the next begins.
    pub breaks: Vec<Number>,
    /// The polynomials, one more than there are breaks.
    pub pieces: Vec<String>,
}

/// Where in a parameter the limits are C^m.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SmoothRange<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The scheme as it was given.
    pub scheme: &'a str,
    /// The parameter.
    pub parameter: &'a str,
    /// m.
    pub smoothness: usize,
    /// There all limits are C^m.
    pub inside: Vec<Interval>,
    /// There not all limits are C^m, or the scheme diverges.
    pub outside: Vec<Interval>,
    /// Whether finitely many parameters of `outside` may be exceptions.
    pub but_finitely_many: bool,
    /// The length of what is in neither, a decimal that is rounded upwards; null where it is unbounded.
    pub gap: Option<String>,
    /// For c = 1, 2, … the part of `inside` where the differences contract in c levels.
    pub levels: Vec<Level>,
}

/// For which values of a parameter in rules around a vertex or on a face surfaces are C^1 there.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct VertexRange<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The scheme as it was given.
    pub scheme: &'a str,
    /// The parameter.
    pub parameter: &'a str,
    /// 1.
    pub smoothness: usize,
    /// What «C¹» means here.
    pub scope: &'static str,
    /// The valences.
    pub valences: Vec<VertexValence>,
}

/// One valence.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct VertexValence {
    /// The valence.
    pub valence: usize,
    /// There the surface is proved C^1.
    pub inside: Vec<Interval>,
    /// There it is refuted.
    pub outside: Vec<Interval>,
}

/// Where, in a plane of two parameters, the limits are C^m.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SmoothMap<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The scheme as it was given.
    pub scheme: &'a str,
    /// The two parameters.
    pub parameters: [&'a str; 2],
    /// m.
    pub smoothness: usize,
    /// The ends of the region, for both parameters.
    pub bounds: [[String; 2]; 2],
    /// The parts of the area.
    pub shares: Shares,
    /// Whether parameters outside may be exceptions: zeros of a polynomial.
    pub but_exceptions: bool,
    /// The boxes, which fill the region.
    pub boxes: Vec<MapBox>,
}

/// Parts of an area, which sum to 1.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Shares {
    /// Where all limits are C^m.
    pub inside: String,
    /// Where not all are, or the scheme diverges.
    pub outside: String,
    /// Where neither is shown.
    pub open: String,
}

/// A box of parameters.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MapBox {
    /// `inside`, `outside` or `open`.
    pub state: &'static str,
    /// The ends, for both parameters.
    pub sides: [[String; 2]; 2],
    /// The factors of the product that shows that the box is outside, counted from 0; absent elsewhere.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub product: Option<Vec<usize>>,
}
