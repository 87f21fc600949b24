//! The header of reference values.

use serde::Serialize;

/// What was computed, and by which program. Numbers that may be long are strings.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Header {
    /// `subcert` and its version.
    pub program: String,
    /// The scheme, as in the request.
    pub scheme: String,
    /// The shape of each mask: one for a curve, two for a tensor product.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub masks: Vec<MaskShape>,
    /// The shape of a ring.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ring: Option<LocalShape>,
    /// The greatest c of T_c and Λ_c.
    pub max_block: u32,
    /// The number of refinements of the control polygon.
    pub level: u32,
    /// `closed` or `open`; `None` for a ring.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub boundary: Option<&'static str>,
    /// The seed of [`Control::seeded_polygon`](super::Control::seeded_polygon); `None` when the control was given.
    pub seed: Option<String>,
    /// For each direction, the index that the scheme gives to the first refined
    /// value. Closed: 0. Open: s_{k+1} = n(s_k − o) from s_0 = 0.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub first_index: Vec<String>,
    /// What is to be told of the control, by whoever read it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// How the columns were rounded.
    pub columns: &'static str,
}

/// The arity n, the width N and the offset o of a mask.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MaskShape {
    /// The arity n.
    pub arity: usize,
    /// The width N.
    pub width: usize,
    /// The offset o.
    pub offset: i64,
}

/// The points and edges of a ring.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LocalShape {
    /// The name of every point, in the order of their numbers.
    pub points: Vec<String>,
    /// The edges, as pairs of point numbers.
    pub edges: Vec<(usize, usize)>,
}

/// The version of the JSON format.
pub(super) const SCHEMA: u32 = 1;

/// How the columns of [`Value`](super::Value) are rounded.
pub(super) const COLUMNS: &str = "exact: p/q or a sum of cosines; decimal: 17 significant digits, \
                                  nearest, half to even; f64: nearest, half to even, as the \
                                  shortest decimal that reads back; hex: the same f64";

/// The name and version of this program.
pub(super) fn program() -> String {
    format!("subcert {}", env!("CARGO_PKG_VERSION"))
}
