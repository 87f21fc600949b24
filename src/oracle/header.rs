//! What reference values say of themselves.

use serde::Serialize;

/// What was computed, and by what. Numbers that may be long are texts.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Header {
    /// `subcert` and its version.
    pub program: String,
    /// The scheme, as it was asked for.
    pub scheme: String,
    /// The shape of each mask: one for a curve, two for a tensor product.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub masks: Vec<MaskShape>,
    /// The shape of a ring.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ring: Option<LocalShape>,
    /// The greatest c of T_c and Λ_c.
    pub max_block: u32,
    /// How often the control polygon was refined.
    pub level: u32,
    /// `closed` or `open`; a ring has no boundary.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub boundary: Option<&'static str>,
    /// The seed of [`Control::seeded_polygon`](super::Control::seeded_polygon); `None` when the control was given.
    pub seed: Option<String>,
    /// For each direction, the index that the scheme gives to the first refined
    /// value. Closed: 0. Open: s_{k+1} = n(s_k − o) from s_0 = 0.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub first_index: Vec<String>,
    /// How the columns were rounded.
    pub columns: &'static str,
}

/// n, N and o of a mask.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct MaskShape {
    /// n.
    pub arity: usize,
    /// N.
    pub width: usize,
    /// o.
    pub offset: i64,
}

/// The points and edges of a ring.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct LocalShape {
    /// The name of every point, in the order of their numbers.
    pub points: Vec<String>,
    /// The edges, as pairs of numbers of points.
    pub edges: Vec<(usize, usize)>,
}

/// The version of the form in JSON.
pub(super) const SCHEMA: u32 = 1;

/// How the columns of [`Value`](super::Value) are rounded.
pub(super) const COLUMNS: &str = "exact: p/q or a sum of cosines; decimal: 17 significant digits, \
                                  nearest, half to even; f64: nearest, half to even, as the \
                                  shortest decimal that reads back; hex: the same f64";

/// What writes the values.
pub(super) fn program() -> String {
    format!("subcert {}", env!("CARGO_PKG_VERSION"))
}
