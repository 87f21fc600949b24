//! Limit points of vertices, and the normals there.

mod catmull_clark;
mod circle;
mod dart;
mod doo_sabin;
mod loops;
mod missing;
mod normal;
mod sector;
mod settle;
mod vertex;
mod weights;
mod without;

pub use missing::NoNormal;
pub use normal::{Normal, Tangents};
pub use sector::Sector;
pub use vertex::LimitPoint;
pub(crate) use weights::limit_weights;
pub use without::without_normals;

use super::error::MeshError;
use super::field::{check_rules, check_tags};
use super::polygon::PolygonMesh;
use super::refine::refine_mesh;
use super::scheme::MeshScheme;
use crate::exact::RealCyclotomic;
use vertex::of_first;

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
    match scheme {
        MeshScheme::CatmullClark | MeshScheme::Bajaj => of_quadrilaterals(mesh, scheme),
        MeshScheme::DooSabin => doo_sabin::limits(mesh),
        MeshScheme::Loop | MeshScheme::LoopWarren => of_first(mesh, mesh.points().len(), scheme),
    }
}

/// The limits of the vertices by rules for quadrilaterals.
fn of_quadrilaterals(
    mesh: &PolygonMesh<RealCyclotomic>,
    scheme: MeshScheme,
) -> Result<Vec<Option<LimitPoint>>, MeshError> {
    let count = mesh.points().len();
    if mesh.faces().iter().all(|face| face.len() == 4) {
        return of_first(mesh, count, scheme);
    }
    // A refinement has quadrilaterals only, moves no limit, and keeps the numbers of the vertices.
    let mut limits = of_first(&refine_mesh(mesh, scheme, 1)?, count, scheme)?;
    // Its faces are parts of those of the mesh.
    let sizes = mesh.faces().iter().enumerate();
    let parents: Vec<usize> =
        sizes.flat_map(|(face, own)| std::iter::repeat_n(face, own.len())).collect();
    for sector in limits.iter_mut().flatten().flat_map(|limit| &mut limit.sectors) {
        sector.faces.iter_mut().for_each(|face| *face = parents[*face]);
    }
    Ok(limits)
}
