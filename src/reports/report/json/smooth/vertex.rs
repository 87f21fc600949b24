//! What is known of surfaces at a vertex or on a face, as JSON.

use crate::audit::Vertices;
use crate::characteristic::{Refutation, RingPoint, Verdict, Vertex};
use crate::report::json::exact::Exact;
use crate::report::smooth::vertex::{exponent_ends, least, verdict_name, verdict_reason};
use serde::Serialize;

/// What is known of the valences that a claim is about.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct VerticesForm {
    /// Whether it is proved for all valences from 3 on at once.
    pub all_valences: bool,
    /// Single valences.
    pub valences: Vec<VertexForm>,
}

/// One valence.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct VertexForm {
    /// The valence.
    pub valence: usize,
    /// `proved`, `refuted`, `fails` (a hypothesis) or `open`.
    pub verdict: &'static str,
    /// The reason in words.
    pub reason: String,
    /// λ, where it is real, alone of its modulus after 1, and of two blocks k and n − k or of block 0; or null.
    pub subdominant: Option<Exact>,
    /// k, or null.
    pub block: Option<usize>,
    /// Whether the eigenvalues are in order for C¹, as far as the points show it.
    pub in_order: bool,
    /// Whether the rules are those of the regular part at its regular valence, so that the surface is C².
    pub regular: bool,
    /// The most bisections of a piece; of a proof only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bisections: Option<usize>,
    /// A decimal that is not above J on the ring; of a proof only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub least_jacobian: Option<String>,
    /// Points of the ring: next to the least Bernstein coefficient, or with J > 0 and J < 0.
    pub points: Vec<[String; 2]>,
    /// Two decimals around the Hölder exponent of the first derivatives; of a proof only.
    pub hoelder: Option<[String; 2]>,
    /// Whether the exponent itself is one, as no Jordan block lowers it; null where that is not decided, or nothing is proved.
    pub attained: Option<bool>,
    /// `bounded`, `vanishing`, `growing` (unbounded, by a Jordan block), `unbounded`, or null.
    pub curvature: Option<&'static str>,
    /// The blocks that decide the last two.
    pub blocks: Vec<usize>,
    /// Of a proof: the greatest modulus of block 0 but 1, and what the curvature of elliptic shapes does; or null.
    pub elliptic: Option<ShapeForm>,
    /// Of a proof and n ≥ 4: the same of the blocks 2 and n − 2, of hyperbolic shapes; or null.
    pub hyperbolic: Option<ShapeForm>,
}

/// The eigenvalue of shapes.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ShapeForm {
    /// Its modulus.
    pub modulus: Exact,
    /// `bounded`, `vanishing`, `growing` or `unbounded`.
    pub curvature: &'static str,
}

impl VerticesForm {
    pub(crate) fn of(found: &Vertices) -> VerticesForm {
        let valences = found.vertices.iter().map(VertexForm::of).collect();
        VerticesForm { all_valences: found.all.is_some(), valences }
    }
}

impl VertexForm {
    /// The JSON form of what is known.
    #[must_use]
    pub fn of(vertex: &Vertex) -> VertexForm {
        let texts = |point: &RingPoint| point.at.each_ref().map(ToString::to_string);
        let (bisections, points) = match &vertex.verdict {
            Verdict::Proved { bisections, near, .. } => (Some(*bisections), vec![texts(near)]),
            Verdict::Refuted(Refutation::Folds { points, .. }) => {
                (None, points.iter().map(texts).collect())
            }
            _ => (None, Vec::new()),
        };
        let exponent = vertex.exponent.as_ref();
        let shape = |which: usize| {
            let (modulus, curvature) = exponent?.shapes[which].as_ref()?;
            Some(ShapeForm { modulus: Exact::of(modulus), curvature: curvature.name() })
        };
        VertexForm {
            valence: vertex.spectrum.order,
            verdict: match &vertex.verdict {
                Verdict::Fails(_) => "fails",
                other => verdict_name(other),
            },
            reason: verdict_reason(&vertex.verdict),
            subdominant: vertex.second.as_ref().map(|second| Exact::of(&second.value)),
            block: vertex.second.as_ref().map(|second| second.block),
            in_order: vertex.hypothesis.is_none(),
            regular: vertex.regular,
            bisections,
            least_jacobian: least(vertex),
            points,
            hoelder: exponent.map(exponent_ends),
            attained: exponent.and_then(|found| found.attained),
            curvature: exponent.map(|found| found.curvature.name()),
            blocks: exponent.map(|found| found.blocks.clone()).unwrap_or_default(),
            elliptic: shape(0),
            hyperbolic: shape(1),
        }
    }
}
