//! What `subcert depth --mesh` writes.

use serde::Serialize;

/// The depth of one mesh.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Report<'a> {
    /// The version of this form.
    pub schema: u32,
    /// The scheme.
    pub scheme: &'a str,
    /// The name of the file.
    pub mesh: &'a str,
    /// The tolerance ε.
    pub tolerance: String,
    /// How distances are measured: `parametric`.
    pub measure: &'static str,
    /// The least level found to be sufficient, with all later ones; null with `--a-priori`.
    pub level: Option<u32>,
    /// Why the search ended early, so that lower levels may be open.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ended: Option<&'a str>,
    /// The greatest level that is certainly not sufficient.
    pub too_few: Option<u32>,
    /// The distance at `level`.
    pub distance: Option<Bounds>,
    /// The one-sided Hausdorff distance at `level`, of the limit from the mesh; null of a solid.
    pub hausdorff: Option<AtLeast>,
    /// Where `distance` is greatest.
    pub worst_face: Option<Place>,
    /// Where the limit is beyond the tolerance at `too_few`.
    pub too_far: Option<Place>,
    /// How many pieces were looked at exactly.
    pub exact_pieces: Option<usize>,
    /// What the longest edge and the valences guarantee.
    pub a_priori: APriori,
    /// What a paper's formula promises; null where there is none.
    pub formula: Option<Formula>,
}

/// A lower and an upper bound.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Bounds {
    /// At least this.
    pub lower: String,
    /// At most this.
    pub upper: String,
}

/// A lower bound.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct AtLeast {
    /// At least this.
    pub lower: String,
}

/// A place on a mesh and on its limit.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Place {
    /// The face of the control mesh, from 0; of a solid, the cell.
    pub face: usize,
    /// Of a net, the row and the column of that face.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cell: Option<[usize; 2]>,
    /// The vertex of that face that it is near.
    pub vertex: Option<usize>,
    /// The face of the level.
    pub level_face: Option<String>,
    /// The point of the mesh of the level.
    pub on_mesh: [String; 3],
    /// The point of the limit at the same parameter.
    pub on_limit: [String; 3],
}

/// What the longest edge and the valences guarantee.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct APriori {
    /// The level.
    pub level: u32,
    /// The length of the longest edge.
    pub longest_edge: String,
    /// The factor by which edges shrink.
    pub ratio: String,
}

/// What a paper's formula promises.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Formula {
    /// The paper.
    pub paper: &'static str,
    /// The level; null where it promises nothing.
    pub level: Option<u32>,
    /// `too few`, `enough`, `more than needed` or `open`; null with `--a-priori`.
    pub verdict: Option<&'static str>,
}
