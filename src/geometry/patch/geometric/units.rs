//! The units of a polygon mesh.

use super::super::number::combinations;
use super::super::place::Verdict;
use super::patch::{FaceSurface, Patch};
use super::pieces::{Hull, Pieces, Unit, Units};
use super::scene::Scene;
use crate::mesh::{Connectivity, MeshError, MeshScheme, Point, PolygonMesh, Stencils, step_with};
use crate::patch::distance::judge::{Judge as _, Points as _, Rounded};
use crate::patch::distance::surface::PieceSearch as _;
use crate::patch::mesh::piece::LevelPiece;
use crate::patch::mesh::roots::{Root, Roots, corners};
use crate::patch::mesh::search::Search;
use crate::patch::shapes::library::Shapes;

/// How many pieces are looked at for the distance of a unit at equal parameters.
const UNIT_STEPS: u64 = 400;

/// The pieces of a mesh, with the parts of its faces that have the same parameters.
pub(super) struct MeshUnits<'a> {
    shapes: &'a Shapes,
    roots: Roots,
    refined: Vec<Point<f64>>,
    /// Whether the mesh on a unit is that of 91.
    plain: Vec<bool>,
    judge: Rounded,
}

/// The pieces of a mesh before it is a scene: making them needs all shapes, which then are only read.
pub(super) struct Stage {
    mesh: PolygonMesh<f64>,
    refined: Vec<Point<f64>>,
    roots: Roots,
}

impl Stage {
    pub(super) fn new(
        mesh: PolygonMesh<f64>,
        scheme: MeshScheme,
        stencils: &Stencils<f64>,
        shapes: &mut Shapes,
    ) -> Result<Stage, MeshError> {
        let next = step_with(&mesh, scheme, stencils)?;
        let roots = Roots::of(scheme, mesh.connectivity(), &next, shapes)?;
        Ok(Stage { refined: next.points().to_vec(), roots, mesh })
    }

    pub(super) fn scene(
        self,
        scheme: MeshScheme,
        surface: FaceSurface,
        shapes: &Shapes,
        judge: Rounded,
    ) -> Scene<MeshUnits<'_>> {
        let Stage { mesh, refined, roots } = self;
        let connectivity = mesh.connectivity();
        let rows = corners::<f64>(scheme, connectivity);
        let triangles = scheme.is_triangular();
        let of = |root: &Root| {
            let face = &mesh.faces()[root.face];
            let points: Vec<Point<f64>> = face.iter().map(|&v| mesh.points()[v]).collect();
            let base = combinations(&rows[&face.len()][root.part], &points);
            let bilinear = surface.is_bilinear(face.len());
            let corners = corner_numbers(connectivity, root.face, root.part, triangles);
            let patches = Patch::between(&base, bilinear);
            (Unit { patches, base, corners }, bilinear || triangles)
        };
        let (units, plain) = roots.all.iter().map(of).unzip();
        // At the highest level of pieces that are made here.
        let slack = 4.0 * judge.slack(32);
        Scene::new(MeshUnits { shapes, roots, refined, plain, judge }, units, slack)
    }
}

/// The numbers of the corners of a part of a face, in the order of `Roots`: of the vertices, then the edges, then the
/// faces.
fn corner_numbers(
    connectivity: &Connectivity,
    face: usize,
    part: usize,
    triangles: bool,
) -> Vec<usize> {
    let vertices = &connectivity.faces()[face];
    let n = vertices.len();
    let edge = |i: usize| connectivity.point_count() + connectivity.face_edges(face)[i % n];
    if triangles && part == 3 {
        return vec![edge(0), edge(1), edge(2)];
    }
    let (vertex, next, before) = (vertices[part], edge(part), edge(part + n - 1));
    if triangles {
        return vec![vertex, next, before];
    }
    let centre = connectivity.point_count() + connectivity.edges().len() + face;
    vec![vertex, next, centre, before]
}

/// Where a piece is: in the hull of its Bézier coefficients if it is regular (93), of the points of its neighbourhood
/// otherwise.
pub(super) fn hull(cell: &LevelPiece<Point<f64>>, shapes: &Shapes) -> Hull {
    let rules = Point::<f64>::rules(shapes.get(cell.shape));
    let (points, limits) = if let Some((bezier, _)) = &rules.regular {
        let hull: Vec<Point<f64>> = combinations(bezier.iter().map(|(row, _)| row), &cell.points);
        let at_corner = bezier.iter().map(|(_, plain)| plain.len() == 1);
        let limits = hull.iter().zip(at_corner).filter(|(_, corner)| *corner);
        let mut limits: Vec<Point<f64>> = limits.map(|(point, _)| *point).collect();
        if limits.len() == 4 {
            // Row by row in `Bezier`, in turn here.
            limits.swap(1, 2);
            limits.swap(2, 3);
        }
        (hull, limits)
    } else {
        (cell.points.clone(), combinations(&rules.limits, &cell.points))
    };
    Hull { points, extra: 0.0, limits, level: cell.level }
}

impl Pieces for MeshUnits<'_> {
    type Piece = LevelPiece<Point<f64>>;

    fn hull(&self, piece: &Self::Piece) -> Hull {
        hull(piece, self.shapes)
    }

    fn parts(&self, piece: &Self::Piece) -> Vec<Self::Piece> {
        piece.parts(self.shapes, false)
    }
}

impl Units for MeshUnits<'_> {
    fn piece(&self, number: usize) -> Self::Piece {
        self.roots.cell(self.root(number), self.shapes, &self.refined)
    }

    fn is_near_by_parameter(&self, number: usize, unit: &Unit) -> bool {
        let mut search = self.search(0);
        self.plain[number] && matches!(search.examine(self.based(number, unit)), Verdict::Within)
    }

    fn moved(&self, number: usize, unit: &Unit) -> f64 {
        let (mut best, mut place) = (0.0, None);
        let upper = self.search(0).measure(self.based(number, unit), 0.2, &mut best, &mut place);
        upper.max(best)
    }

    fn tolerance(&self) -> f64 {
        self.judge.tolerance()
    }
}

impl MeshUnits<'_> {
    /// The face of the mesh of the level, and which part of it, that a unit is.
    pub(super) fn root(&self, number: usize) -> &Root {
        &self.roots.all[number]
    }

    fn search(&self, later: u32) -> Search<'_, Point<f64>, Rounded> {
        Search::new(self.shapes, &self.judge, later, UNIT_STEPS)
    }

    /// The piece of the limit of a unit, with the mesh that it is compared with.
    fn based(&self, number: usize, unit: &Unit) -> LevelPiece<Point<f64>> {
        LevelPiece { base: Some(unit.base.clone()), ..self.piece(number) }
    }

    /// Whether limit and mesh are near by parameter for a mesh that is so many levels later, at least one. `regular`: only
    /// of regular pieces.
    pub(super) fn is_near_later(&self, number: usize, later: u32, regular: bool) -> bool {
        let cell = self.piece(number);
        if regular && !self.shapes.get(cell.shape).is_regular() {
            return false;
        }
        matches!(self.search(later).examine(cell), Verdict::Within)
    }
}
