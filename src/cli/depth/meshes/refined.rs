//! Refined meshes, nets and solids with the distances of their points from where these go, for pictures.

use subcert::exact::{Enclosed, Rational, RealCyclotomic};
use subcert::float::nearest;
use subcert::mesh::{MeshScheme, PolygonMesh, limit_points, refine_mesh};
use subcert::net::{Net, NetScheme, net_limits, refine_net};
use subcert::scheme::Mask;
use subcert::solid::{HexMesh, refine_solid, solid_limit_points};

/// The most faces; as many are drawn in colour.
const MAX_FACES: usize = 3_000;

/// The most cells of a solid.
const MAX_CELLS: usize = 12_000;

/// The most levels.
const MAX_LEVEL: u32 = 5;

/// Faces of a level, with the distances at their corners.
pub(super) struct Refined {
    pub(super) level: u32,
    pub(super) points: Vec<[f64; 3]>,
    pub(super) faces: Vec<Vec<usize>>,
    /// For each face the greatest distance of a corner from its limit.
    pub(super) values: Vec<f64>,
}

impl Refined {
    /// The mesh of the last level up to `depth` that has not too many faces; `None` where even level 0 has.
    pub(super) fn of_mesh(
        mesh: &PolygonMesh<Rational>,
        scheme: MeshScheme,
        depth: u32,
    ) -> Option<Refined> {
        let corners = mesh.faces().iter().map(Vec::len).sum::<usize>();
        let level = level(mesh.faces().len(), corners.max(1), 4, depth, MAX_FACES)?;
        let control = mesh.map(|x| RealCyclotomic::from(x.clone()));
        let refined = refine_mesh(&control, scheme, level).ok()?;
        let limits = limit_points(&refined, scheme).ok()?.into_iter();
        let limits: Vec<_> = limits.map(|limit| Some(rounded(&limit?.position))).collect();
        let points = refined.points().iter().map(rounded).collect();
        Some(Refined::new(level, points, refined.faces().to_vec(), &limits))
    }

    /// The same of a net.
    pub(super) fn of_net(net: &Net, scheme: &NetScheme, depth: u32) -> Option<Refined> {
        let factor = scheme.masks().iter().map(Mask::arity).product::<usize>();
        let count = net.faces().iter().product::<usize>();
        let level = level(count, count.max(1) * factor, factor, depth, MAX_FACES)?;
        let refined = refine_net(net, scheme, level).ok()?;
        let limits = net_limits(&refined, scheme).ok()?.into_iter();
        let limits: Vec<_> = limits.map(|limit| Some(rounded(&limit?))).collect();
        let mesh = refined.mesh().ok()?;
        let points = mesh.points().iter().map(rounded).collect();
        Some(Refined::new(level, points, mesh.faces().to_vec(), &limits))
    }

    /// The boundary of a solid.
    pub(super) fn of_solid(mesh: &HexMesh<Rational>, depth: u32) -> Option<Refined> {
        let (cells, faces) = (mesh.cells().len(), mesh.boundary_faces().len());
        let by_faces = level(faces, 4 * faces.max(1), 4, depth, MAX_FACES)?;
        let level = by_faces.min(level(cells, 8 * cells.max(1), 8, depth, MAX_CELLS)?);
        let refined = refine_solid(mesh, level).ok()?;
        let limits = solid_limit_points(&refined);
        let limits: Vec<_> = limits.iter().map(|limit| Some(rounded(limit))).collect();
        let faces = refined.boundary_faces().iter().map(|face| face.to_vec()).collect();
        Some(Refined::new(level, refined.points().iter().map(rounded).collect(), faces, &limits))
    }

    fn new(
        level: u32,
        points: Vec<[f64; 3]>,
        faces: Vec<Vec<usize>>,
        limits: &[Option<[f64; 3]>],
    ) -> Refined {
        let apart = |(point, limit): (&[f64; 3], &Option<[f64; 3]>)| {
            let differences = limit.iter().flat_map(|limit| point.iter().zip(limit));
            differences.fold(0.0_f64, |sum, (x, y)| sum.hypot(x - y))
        };
        let distances: Vec<f64> = points.iter().zip(limits).map(apart).collect();
        let greatest = |face: &Vec<usize>| face.iter().map(|i| distances[*i]).fold(0.0, f64::max);
        let values = faces.iter().map(greatest).collect();
        Refined { level, points, faces, values }
    }
}

/// The last level up to `depth` with at most `most` faces: there are `first` at level 1, and `factor` times as many at
/// each later one.
fn level(count: usize, first: usize, factor: usize, depth: u32, most: usize) -> Option<u32> {
    let mut next = first;
    let (mut level, depth) = (0, depth.min(MAX_LEVEL));
    while level < depth && next <= most {
        level += 1;
        next = next.saturating_mul(factor.max(2));
    }
    (count <= most).then_some(level)
}

/// A point in f64.
pub(super) fn rounded<S: Enclosed>(point: &[S; 3]) -> [f64; 3] {
    point.each_ref().map(|x| nearest(&x))
}
