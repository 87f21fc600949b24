//! What `subcert depth --mesh` writes of the distance of sets.

use super::mesh_depth::{APriori, Formula};
use serde::Serialize;

/// The depth of one mesh or net.
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
    /// The share of the diagonal that it was asked for as; null without `--relative`.
    pub relative: Option<String>,
    /// How distances are measured: `hausdorff`.
    pub measure: &'static str,
    /// What faces are: `bilinear` or `fan`.
    pub faces: &'static str,
    /// The least level found to be sufficient; null where the search ended before it found one.
    pub level: Option<u32>,
    /// Why the search ended early: it was stopped, or met a cap.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ended: Option<&'a str>,
    /// The greatest level that is certainly not sufficient, with all below it.
    pub too_few: Option<u32>,
    /// A point that shows that `too_few` is not sufficient.
    pub too_far: Option<Place>,
    /// How many faces adaptive refinement has; null without `--per-face`.
    pub adaptive: Option<Adaptive>,
    /// What the longest edge and the valences guarantee, by equal parameters.
    pub a_priori: APriori,
    /// What a paper's formula promises; null where there is none.
    pub formula: Option<Formula>,
    /// The file that `--certificate` wrote, of a net; or null.
    pub certificate: Option<String>,
}

/// A point of one set that is far from the other.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Place {
    /// The face of the control mesh or net, from 0.
    pub face: usize,
    /// For a net, the row and the column of that face.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cell: Option<[usize; 2]>,
    /// For the boundary of a solid, the cell of that face.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub solid_cell: Option<usize>,
    /// The vertex of that face that it is near; of a solid, as the file numbers it.
    pub vertex: Option<usize>,
    /// The face of the level.
    pub level_face: Option<String>,
    /// `mesh`, which a net is too, or `limit`.
    pub from: &'static str,
    /// The point.
    pub point: [String; 3],
    /// A point of the other set that is near.
    pub other: [String; 3],
    /// The point is at least so far from the other set.
    pub distance: String,
}

/// Numbers of faces, those that join levels not counted.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Adaptive {
    /// At one level for all.
    pub uniform: String,
    /// Where each face has its own level.
    pub adaptive: String,
}
