//! Limit points of vertices, and the normals there.

mod catmull_clark;
mod doo_sabin;
mod loops;
mod normal;

pub(crate) use loops::limit_weights as loop_limit_weights;
pub use normal::Normal;

use super::error::MeshError;
use super::field::{check_field, check_rules};
use super::point::{Point, combination};
use super::polygon::PolygonMesh;
use super::scheme::MeshScheme;
use crate::exact::{Rational, RealCyclotomic};

/// The limit of a vertex of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitPoint {
    /// The point that the vertex tends to.
    pub position: Point<RealCyclotomic>,
    /// The normal there. `None` at a boundary vertex that is not regular, and where the tangents that
    /// give the normal are parallel.
    pub normal: Option<Normal>,
}

/// The limit point of every vertex of a mesh.
///
/// | scheme | inner vertex of valence n | boundary |
/// |---|---|---|
/// | Catmull–Clark | (n² v + 4 Σ e_i + Σ f_i)/(n(n + 5)), after one refinement where a face at v is no quadrilateral | (1, 4, 1)/6 of the boundary polygon |
/// | Doo–Sabin | the mean of the new points of v in its n faces | `None`: the surface does not reach it |
/// | Loop | (1 − nω) v + ω Σ e_i, ω = 1/(n + 3/(8β)) | (1, 4, 1)/6 of the boundary polygon |
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
    check_field(mesh.connectivity(), mesh.points(), scheme, true, mesh.points().len())?;
    match scheme {
        MeshScheme::CatmullClark => catmull_clark::limits(mesh),
        MeshScheme::DooSabin => doo_sabin::limits(mesh),
        MeshScheme::Loop | MeshScheme::LoopWarren => Ok(loops::limits(mesh, scheme)),
    }
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

/// (1, 4, 1)/6 of a vertex and its neighbours at the boundary.
fn boundary_limit(
    mesh: &PolygonMesh<RealCyclotomic>,
    vertex: usize,
    ends: [usize; 2],
) -> Point<RealCyclotomic> {
    let [four, one] = [4, 1].map(|p| RealCyclotomic::from(Rational::new(p, 6)));
    let [p, q] = ends.map(|end| &mesh.points()[end]);
    combination([(&four, &mesh.points()[vertex]), (&one, p), (&one, q)])
}
