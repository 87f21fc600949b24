//! What `subcert constants` writes.

use super::offset::BetterOffset;
use serde::Serialize;
use subcert::report::json::Exact;

/// The constants of a mask, or of a tensor product of two.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Constants<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The scheme as it was given.
    pub scheme: &'a str,
    /// The masks.
    pub directions: Vec<Direction<'a>>,
    /// The tensor product; null of a curve.
    pub surface: Option<Surface>,
    /// The better offsets of files that state none; missing where there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub better_offsets: Vec<BetterOffset<'a>>,
}

/// The constants of a mask.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Direction<'a> {
    /// How many rules there are.
    pub arity: usize,
    /// How many coefficients a rule has.
    pub width: usize,
    /// The offset of the indices.
    pub offset: i64,
    /// The mask, rule by rule.
    pub mask: Vec<Vec<String>>,
    /// The difference mask.
    pub difference: Vec<Vec<String>>,
    /// δ = T_1.
    pub delta: Delta,
    /// σ at several offsets.
    pub displacement: Vec<Displacement<'a>>,
    /// Whether the mask takes lines to lines, with some shift of the parameter.
    pub keeps_lines: bool,
    /// T_c and Λ_c for c = 1, 2, …
    pub levels: Vec<Level>,
}

/// δ.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Delta {
    /// The value; its fields stand here.
    #[serde(flatten)]
    pub value: Exact,
    /// Whether it is less than 1.
    pub holds: bool,
}

/// σ at one offset.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Displacement<'a> {
    /// The value; its fields stand here.
    #[serde(flatten)]
    pub value: Exact,
    /// The name of this σ.
    pub name: &'a str,
}

/// The constants for blocks of c levels; null where they are beyond reach.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Level {
    /// c.
    pub c: usize,
    /// T_c.
    pub contraction: Option<Exact>,
    /// Λ_c.
    pub norm: Option<Exact>,
    /// Both with the masks read forwards; its fields stand here, and are missing where they were not asked for.
    #[serde(flatten)]
    pub forward: Option<Forward>,
}

/// The constants for blocks of c levels with the masks read forwards; null where they are beyond reach.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Forward {
    /// T_c.
    pub contraction_forward: Option<Exact>,
    /// Λ_c.
    pub norm_forward: Option<Exact>,
}

/// The constants of a tensor product.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Surface {
    /// The factor σ of the surface.
    pub factor: Exact,
    /// δ = T_1·Λ_1.
    pub delta: Delta,
    /// T_c·Λ_c for c = 1, 2, …
    pub constants: Vec<Exact>,
}

/// The constants of a ring.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LocalConstants<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The scheme as it was given.
    pub scheme: &'a str,
    /// The kinds of points.
    pub orbits: Vec<Orbit<'a>>,
    /// The edges: pairs of points.
    pub edges: &'a [(usize, usize)],
    /// The weights of each point.
    pub weights: Vec<Vec<String>>,
    /// δ = T_1.
    pub delta: Option<Delta>,
    /// σ.
    pub displacement: LocalDisplacement<'a>,
    /// T_c and Λ_c for c = 1, 2, …
    pub levels: Vec<LocalLevel<'a>>,
}

/// Points of a ring that are alike.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Orbit<'a> {
    /// What they are called.
    pub name: &'a str,
    /// How many they are.
    pub count: usize,
}

/// σ of a ring.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LocalDisplacement<'a> {
    /// The value; its fields stand here.
    #[serde(flatten)]
    pub value: Exact,
    /// The point that attains it.
    pub point: usize,
    /// A control ring that attains it.
    pub heights: &'a [i64],
}

/// The constants of a ring for blocks of c levels.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LocalLevel<'a> {
    /// c.
    pub c: u32,
    /// T_c.
    pub contraction: Exact,
    /// The edge that attains it.
    pub edge: (usize, usize),
    /// A control ring that attains it.
    pub heights: &'a [i64],
    /// Λ_c.
    pub norm: Exact,
}
