//! Loop.

use super::super::crease::VertexMask;
use super::super::field::inner_valences;
use super::super::point::{combination, sum};
use super::super::polygon::PolygonMesh;
use super::super::scheme::MeshScheme;
use super::super::star::Star;
use super::super::stencil::Stencils;
use super::weights::{dart_edge, position, settled_weights, triangular};
use super::{LimitPoint, Normal, circular, sharp_limit};
use crate::exact::RealCyclotomic;

/// Limits of the vertices of a mesh.
pub(super) struct Limits {
    scheme: MeshScheme,
    stencils: Stencils,
}

impl Limits {
    pub(super) fn new(mesh: &PolygonMesh<RealCyclotomic>, scheme: MeshScheme) -> Limits {
        let valences = inner_valences(mesh.connectivity()).map(|(_, n)| n);
        Limits { scheme, stencils: Stencils::new(scheme, valences) }
    }

    /// The limit of a vertex whose sharp edges are infinitely sharp.
    pub(super) fn limit(
        &self,
        mesh: &PolygonMesh<RealCyclotomic>,
        vertex: usize,
        star: &Star,
        mask: &VertexMask,
    ) -> LimitPoint {
        if *mask != VertexMask::Smooth {
            return sharp_limit(mesh, vertex, star, mask, false);
        }
        let point = &mesh.points()[vertex];
        let around: Vec<_> = star.neighbours.iter().map(|&v| &mesh.points()[v]).collect();
        let n = star.valence();
        let beta = &self.stencils.of(n)[1];
        if dart_edge(mesh, star).is_some() {
            let weights = settled_weights(mesh, vertex, star, mask, self.scheme, &self.stencils);
            let position = position(mesh, &weights);
            return LimitPoint { position, normal: None, sectors: Vec::new() };
        }
        let weights = triangular(n, beta);
        let position = combination(weights.iter().zip([point, &sum(around.iter().copied())]));
        LimitPoint { position, normal: Normal::of(&circular(&around)), sectors: Vec::new() }
    }
}
