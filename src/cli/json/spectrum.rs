//! What `subcert spectrum` writes.

use serde::Serialize;
use subcert::report::json::Exact;

/// The spectrum of a ring and its stencils.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Spectrum<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The scheme as it was given.
    pub scheme: &'a str,
    /// The order n of the rotation.
    pub valence: usize,
    /// The orbits of the ring of the stencils.
    pub orbits: Vec<Orbit<'a>>,
    /// The orbits of the ring whose eigenvalues these are.
    pub neighbourhood: Vec<Orbit<'a>>,
    /// All eigenvalues, in descending order of the absolute value.
    pub eigenvalues: Vec<Eigenvalue>,
    /// The conditions on them.
    pub conditions: Conditions,
    /// The weights of the points in their limit; null where 1 is no simple eigenvalue.
    pub limit: Option<Vec<Weight>>,
    /// The weights of the points in two tangents, whose cross product in this order is a normal; null
    /// without a subdominant eigenvalue.
    pub tangents: Option<[Vec<Weight>; 2]>,
}

/// The rules between two sharp edges at a vertex.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Sector<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The scheme as it was given.
    pub scheme: &'a str,
    /// The number F of faces.
    pub faces: usize,
    /// Whether the vertex is a corner.
    pub corner: bool,
    /// The points: the edges 0 and F are sharp.
    pub orbits: Vec<Orbit<'a>>,
    /// All eigenvalues, in descending order; block 0 is the vertex with the two sharp edges.
    pub eigenvalues: Vec<Eigenvalue>,
    /// The weights of the points in the limit of the vertex.
    pub limit: Vec<Weight>,
    /// The weights of the points in the tangent along the crease; at a corner in both tangents along the sharp edges.
    pub along: Vec<Vec<Weight>>,
    /// What goes into the sector; null for one face at a corner.
    pub across: Option<Across>,
}

/// The greatest eigenvalue λ of block 1; for one face on a crease that of the crease.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Across {
    /// λ.
    pub eigenvalue: Exact,
    /// λ compared with 1/2, the eigenvalue of the tangents along sharp edges: `below`, `equal` or `above`.
    pub comparison: &'static str,
    /// Whether block 2 has an eigenvalue above 1/2, too: on a crease, normals of generic data then have no limit.
    pub second_above: bool,
    /// The weights of the points in the tangent across; null where λ has a Jordan block with that 1/2.
    pub weights: Option<Vec<Weight>>,
}

/// The points of one kind.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Orbit<'a> {
    /// Their name.
    pub name: &'a str,
    /// Their number.
    pub count: usize,
}

/// An eigenvalue.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Eigenvalue {
    /// The value; the real part of a pair of complex eigenvalues.
    #[serde(flatten)]
    pub value: Exact,
    /// The positive imaginary part y of a pair x ± iy; absent for a real eigenvalue.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub imaginary: Option<Exact>,
    /// The algebraic multiplicity, of each of a pair.
    pub multiplicity: usize,
    /// The Fourier blocks, each as often as it has the eigenvalue.
    pub block: Vec<usize>,
}

/// What the literature asks of the eigenvalues: necessary conditions only. C¹ also needs a regular and
/// injective characteristic map, which `smoothness` decides.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Conditions {
    /// Whether 1 is simple, and all others are below 1 in absolute value.
    pub simple_one: bool,
    /// λ, if it is positive, double, from the blocks 1 and n − 1, and above all that follow; or null.
    pub subdominant: Option<Exact>,
    /// λ².
    pub square: Option<Exact>,
    /// The greatest absolute value μ after λ.
    pub next: Option<Exact>,
    /// `bounded` where μ = λ² without a Jordan block, `growing` with one, `vanishing` where μ is less, `unbounded` where it is
    /// greater.
    pub curvature: Option<&'static str>,
}

/// The weight of a point.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Weight {
    /// The point, such as `edge[3]`.
    pub point: String,
    /// The weight.
    #[serde(flatten)]
    pub weight: Exact,
}
