//! The limit of a vertex between triangles or quadrilaterals.

use super::super::crease::VertexMask;
use super::super::error::MeshError;
use super::super::field::{Conductor, check_limits, inner_valences};
use super::super::point::Point;
use super::super::polygon::PolygonMesh;
use super::super::scheme::MeshScheme;
use super::super::star::Star;
use super::super::stencil::Stencils;
use super::missing::NoNormal;
use super::normal::Normal;
use super::sector::{Sector, sectors};
use super::settle::{falls, settled};
use super::weights::{dart_edge, position, settled_weights, sharp_weights};
use super::{catmull_clark, loops};
use crate::exact::RealCyclotomic;

/// The limit of a vertex of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitPoint {
    /// The point that the vertex tends to.
    pub position: Point<RealCyclotomic>,
    /// The normal there, or why there is none.
    pub normal: Result<Normal, NoNormal>,
    /// The sectors between sharp edges at a vertex on a crease, at a corner or at the boundary, with
    /// their tangents; none where the surface is smooth.
    pub sectors: Vec<Sector>,
}

/// The limits of the first vertices of a mesh of triangles or of quadrilaterals.
pub(super) fn of_first(
    mesh: &PolygonMesh<RealCyclotomic>,
    count: usize,
    scheme: MeshScheme,
) -> Result<Vec<Option<LimitPoint>>, MeshError> {
    let valences = inner_valences(mesh.connectivity()).filter(|(vertex, _)| *vertex < count);
    let stencils = Stencils::new(scheme, valences.map(|(_, n)| n));
    check_limits((0..count).filter_map(|vertex| {
        let star = mesh.connectivity().star(vertex);
        let smooth = !falls(mesh, vertex, &star) && !star.boundary;
        smooth.then(|| (vertex, conductor(mesh, vertex, &star, &VertexMask::Smooth)))
    }))?;
    let limit = |vertex| at_vertex(mesh, vertex, scheme, &stencils).map(Some);
    (0..count).map(limit).collect()
}

/// The limit of a vertex, after refinement around it where a sharpness falls there.
fn at_vertex(
    mesh: &PolygonMesh<RealCyclotomic>,
    vertex: usize,
    scheme: MeshScheme,
    stencils: &Stencils,
) -> Result<LimitPoint, MeshError> {
    let star = mesh.connectivity().star(vertex);
    if !falls(mesh, vertex, &star) {
        let mask = mesh.tags().vertex_mask(mesh.connectivity(), vertex, &star);
        return settled_limit(mesh, vertex, &star, &mask, (scheme, stencils), vertex);
    }
    let (part, at) = settled(mesh, vertex, scheme)?;
    let own = part.connectivity().star(at);
    let mask = part.tags().vertex_mask(part.connectivity(), at, &own);
    let mut limit = settled_limit(&part, at, &own, &mask, (scheme, stencils), vertex)?;
    // The faces of a part have other numbers. Its star begins at another face where all is smooth.
    let ends: Vec<usize> = own.faces.clone();
    for sector in &mut limit.sectors {
        for face in &mut sector.faces {
            let place = ends.iter().position(|end| end == face).unwrap_or(0);
            *face = star.faces[place % star.faces.len()];
        }
    }
    Ok(limit)
}

/// The field of the points that the limit of a vertex depends on; where it is smooth, also of the cosines of its valence.
/// Tangents of [`sectors`] look after their fields themselves.
fn conductor(
    mesh: &PolygonMesh<RealCyclotomic>,
    vertex: usize,
    star: &Star,
    mask: &VertexMask,
) -> Conductor {
    let points = mesh.points();
    let own = [&points[vertex]];
    match mask {
        VertexMask::Corner => Conductor::around(None, own),
        VertexMask::Crease(ends) => {
            Conductor::around(None, own.into_iter().chain(ends.map(|end| &points[end])))
        }
        VertexMask::Smooth => {
            let around = star.faces.iter().flat_map(|&face| &mesh.faces()[face]);
            Conductor::around(Some(star.valence()), around.map(|&point| &points[point]))
        }
    }
}

/// The limit of a vertex whose sharp edges are infinitely sharp. Errors call it `known_as`.
fn settled_limit(
    mesh: &PolygonMesh<RealCyclotomic>,
    vertex: usize,
    star: &Star,
    mask: &VertexMask,
    (scheme, stencils): (MeshScheme, &Stencils),
    known_as: usize,
) -> Result<LimitPoint, MeshError> {
    check_limits([(known_as, conductor(mesh, vertex, star, mask))])?;
    if *mask != VertexMask::Smooth {
        return Ok(sharp_limit(mesh, vertex, star, mask, !scheme.is_triangular()));
    }
    let (position, normal) = if dart_edge(mesh, star).is_some() {
        let weights = settled_weights(mesh, vertex, star, mask, scheme, stencils);
        (position(mesh, &weights), Err(NoNormal::CreaseEnd))
    } else {
        let (position, normal) = if scheme.is_triangular() {
            loops::smooth(mesh, vertex, star, stencils)
        } else {
            catmull_clark::smooth(mesh, vertex, star, stencils)
        };
        (position, normal.ok_or(NoNormal::Parallel))
    };
    Ok(LimitPoint { position, normal, sectors: Vec::new() })
}

/// The position and the sectors of a vertex that is not smooth.
fn sharp_limit(
    mesh: &PolygonMesh<RealCyclotomic>,
    vertex: usize,
    star: &Star,
    mask: &VertexMask,
    quadrilaterals: bool,
) -> LimitPoint {
    let position = position(mesh, &sharp_weights(vertex, mask));
    let sectors = sectors(mesh, vertex, star, mask, quadrilaterals);
    let normal = match &sectors[..] {
        [] => Err(NoNormal::Corner),
        [one] => one.normal(),
        _ => Err(NoNormal::Sectors),
    };
    LimitPoint { position, normal, sectors }
}
