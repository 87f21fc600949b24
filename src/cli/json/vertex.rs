//! What `subcert smoothness` writes of rules around a vertex or on a face.

use serde::Serialize;
use subcert::report::json::VertexForm;

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
    pub valences: Vec<VertexForm>,
}
