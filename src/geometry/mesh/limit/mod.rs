//! Limit points of vertices, and the normals there.

mod catmull_clark;
mod dart;
mod doo_sabin;
mod loops;
mod normal;
mod sector;
mod settle;
mod weights;

pub use normal::{Normal, Tangents};
pub use sector::Sector;
pub(crate) use weights::limit_weights;
use weights::{dart_edge, position, settled_weights, sharp_weights};

use super::crease::VertexMask;
use super::error::MeshError;
use super::field::{check_field, check_rules, check_tags, inner_valences};
use super::point::{Point, combination};
use super::polygon::PolygonMesh;
use super::scheme::MeshScheme;
use super::star::Star;
use super::stencil::Stencils;
use crate::exact::{Rational, RealCyclotomic};

/// The limit of a vertex of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitPoint {
    /// The point that the vertex tends to.
    pub position: Point<RealCyclotomic>,
    /// The normal there. `None` at a vertex of several sectors or of none whose tangents are known, and
    /// where the tangents that give the normal are parallel.
    pub normal: Option<Normal>,
    /// The sectors between sharp edges at a vertex on a crease, at a corner or at the boundary, with
    /// their tangents; none where the surface is smooth.
    pub sectors: Vec<Sector>,
}

/// The limit point of every vertex of a mesh.
///
/// | scheme | inner vertex of valence n | boundary |
/// |---|---|---|
/// | Catmull–Clark | (n² v + 4 Σ e_i + Σ f_i)/(n(n + 5)), after one refinement where a face at v is no quadrilateral | (1, 4, 1)/6 of the boundary polygon |
/// | Bajaj's boundary | (v + (Σ e_i + Σ f_i/4)/n)·4/9, likewise | likewise |
/// | Doo–Sabin | the mean of the new points of v in its n faces | `None`: the surface does not reach it |
/// | Loop | (1 − nω) v + ω Σ e_i, ω = 1/(n + 3/(8β)) | (1, 4, 1)/6 of the boundary polygon |
///
/// On a crease it is (1, 4, 1)/6 of the crease, at a corner the vertex itself, and where one sharp
/// edge ends the left eigenvector for 1 of the rules there. Around a sharpness that falls, the mesh is
/// refined until it has fallen.
///
/// These weights are left eigenvectors of the rules in the catalogue for the eigenvalue 1. Normals
/// are cross products of two tangents, given by left eigenvectors for the next eigenvalue; see
/// `docs/meshes.md`.
///
/// # Errors
/// As [`refine_mesh`](super::refine_mesh) for one level.
///
/// # Panics
/// Never.
///
/// ```
/// use subcert::exact::{Rational, RealCyclotomic};
/// use subcert::mesh::{MeshScheme, PolygonMesh, limit_points};
///
/// // A tetrahedron: ω = 1/(3 + 2), and the other three points sum to −v.
/// let points = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]];
/// let points = points.map(|point| point.map(RealCyclotomic::from)).to_vec();
/// let faces = vec![vec![0, 1, 2], vec![0, 3, 1], vec![0, 2, 3], vec![1, 3, 2]];
/// let mesh = PolygonMesh::new(points, faces)?;
/// let limit = limit_points(&mesh, MeshScheme::Loop)?;
/// let x = &limit[0].as_ref().unwrap().position[0];
/// assert_eq!(*x, Rational::new(1, 5).into());
/// # Ok::<(), subcert::mesh::MeshError>(())
/// ```
pub fn limit_points(
    mesh: &PolygonMesh<RealCyclotomic>,
    scheme: MeshScheme,
) -> Result<Vec<Option<LimitPoint>>, MeshError> {
    check_rules(mesh.connectivity(), scheme)?;
    check_tags(mesh, scheme)?;
    check_field(mesh.connectivity(), mesh.points(), scheme, true, mesh.points().len())?;
    match scheme {
        MeshScheme::CatmullClark | MeshScheme::Bajaj => catmull_clark::limits(mesh, scheme),
        MeshScheme::DooSabin => doo_sabin::limits(mesh),
        MeshScheme::Loop | MeshScheme::LoopWarren => of_first(mesh, mesh.points().len(), scheme),
    }
}

/// The limits of the first vertices of a mesh of triangles or of quadrilaterals.
fn of_first(
    mesh: &PolygonMesh<RealCyclotomic>,
    count: usize,
    scheme: MeshScheme,
) -> Result<Vec<Option<LimitPoint>>, MeshError> {
    let valences = inner_valences(mesh.connectivity()).filter(|(vertex, _)| *vertex < count);
    let stencils = Stencils::new(scheme, valences.map(|(_, n)| n));
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
    if !settle::falls(mesh, vertex, &star) {
        let mask = mesh.tags().vertex_mask(mesh.connectivity(), vertex, &star);
        return Ok(settled_limit(mesh, vertex, &star, &mask, (scheme, stencils)));
    }
    let (part, at) = settle::settled(mesh, vertex, scheme)?;
    let own = part.connectivity().star(at);
    let mask = part.tags().vertex_mask(part.connectivity(), at, &own);
    let mut limit = settled_limit(&part, at, &own, &mask, (scheme, stencils));
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

/// The limit of a vertex whose sharp edges are infinitely sharp.
fn settled_limit(
    mesh: &PolygonMesh<RealCyclotomic>,
    vertex: usize,
    star: &Star,
    mask: &VertexMask,
    (scheme, stencils): (MeshScheme, &Stencils),
) -> LimitPoint {
    if *mask != VertexMask::Smooth {
        return sharp_limit(mesh, vertex, star, mask, !scheme.is_triangular());
    }
    let (position, normal) = if dart_edge(mesh, star).is_some() {
        let weights = settled_weights(mesh, vertex, star, mask, scheme, stencils);
        (position(mesh, &weights), None)
    } else if scheme.is_triangular() {
        loops::smooth(mesh, vertex, star, stencils)
    } else {
        catmull_clark::smooth(mesh, vertex, star, stencils)
    };
    LimitPoint { position, normal, sectors: Vec::new() }
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
    let sectors = sector::sectors(mesh, vertex, star, mask, quadrilaterals);
    let normal = match &sectors[..] {
        [one] => one.tangents.as_ref().and_then(Tangents::normal),
        _ => None,
    };
    LimitPoint { position, normal, sectors }
}

/// Σ cos(2πi/n) x_i and Σ cos(2π(i − 1)/n) x_i over n points around a vertex or a face.
///
/// Their cross product is sin(2π/n) times that of the sums with cosines and with sines.
fn circular(points: &[&Point<RealCyclotomic>]) -> [Point<RealCyclotomic>; 2] {
    let cosines: Vec<RealCyclotomic> = (0..points.len()).map(|i| cosine(i, points.len())).collect();
    [0, 1].map(|start| {
        let turned = (0..points.len()).map(|i| &cosines[(i + points.len() - start) % points.len()]);
        combination(turned.zip(points.iter().copied()))
    })
}

/// cos(2πi/n), for an n whose field has been checked.
fn cosine(i: usize, n: usize) -> RealCyclotomic {
    RealCyclotomic::cosine(&Rational::new(i, n)).expect("a valence within the cap")
}
