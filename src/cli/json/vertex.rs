//! What `subcert smoothness` writes of rules around a vertex or on a face.

use serde::Serialize;
use subcert::report::json::Exact;

/// One valence or several.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Vertices<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The scheme as it was given.
    pub scheme: &'a str,
    /// What «C¹» means here.
    pub scope: &'static str,
    /// Whether the surface is proved C¹ at all valences from 3 on; absent unless asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub all_valences: Option<bool>,
    /// The valences.
    pub valences: Vec<Vertex>,
}

/// One valence.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Vertex {
    /// The valence.
    pub valence: usize,
    /// `proved`, `refuted`, `fails` (a hypothesis) or `open`.
    pub verdict: &'static str,
    /// The reason in words.
    pub reason: String,
    /// λ, where it is double, from the blocks 1 and n − 1, and above all that follow; or null.
    pub subdominant: Option<Exact>,
    /// The most bisections of a piece; of a proof only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bisections: Option<usize>,
    /// A decimal that is not above J on the ring; of a proof only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub least_jacobian: Option<String>,
    /// Points of the ring: of the least Bernstein coefficient, or with J > 0 and J < 0.
    pub points: Vec<[String; 2]>,
    /// Two decimals around the Hölder exponent of the first derivatives; of a proof only.
    pub hoelder: Option<[String; 2]>,
    /// `bounded`, `vanishing`, `unbounded`, or null.
    pub curvature: Option<&'static str>,
    /// The blocks that decide the last two.
    pub blocks: Vec<usize>,
}
