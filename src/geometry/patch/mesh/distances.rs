//! The distances of meshes and solids.

use super::model::Model;
use super::piece::LevelPiece;
use super::search::Search;
use crate::exact::{Rational, RealCyclotomic};
use crate::float::nearest;
use crate::mesh::{MeshError, MeshScheme, Point, PolygonMesh};
use crate::patch::distance::depth::{Distances, distances_of};
use crate::patch::distance::judge::{Exactly, Judge as _, Rounded};
use crate::patch::distance::surface::{Ball, PieceSearch, Surface, WIDTH};
use crate::patch::number::{Vector as _, combinations, mean};
use crate::patch::place::{FarPlace, Place, Verdict};
use crate::patch::shapes::scheme::PieceScheme;
use crate::patch::shapes::shape::UP;
use crate::solid::{HexMesh, SolidError};

/// The distances of a mesh from its limit surface:
///
/// D_k = sup |P^∞ − P^k|, k = 0, 1, …,
///
/// over the whole surface, Euclidean. P^k is the mesh of level k, bilinear on each quadrilateral
/// (Catmull–Clark; a face of level 0 with n vertices is n bilinear quarters), flat on each triangle
/// (Loop), bilinear on each quarter of a face at an inner vertex (Doo–Sabin). P^∞ is the limit at
/// the same parameters. Distances are in the unit of the coordinates.
///
/// Source: `proofs/THEOREMS.md`, 91 to 97.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::mesh::{MeshScheme, PolygonMesh};
/// use subcert::patch::MeshDistances;
///
/// let points = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]].map(|p| p.map(Rational::from));
/// let faces = vec![vec![0, 1, 2], vec![0, 3, 1], vec![0, 2, 3], vec![1, 3, 2]];
/// let mesh = PolygonMesh::new(points.to_vec(), faces)?;
/// let distances = MeshDistances::new(mesh, MeshScheme::Loop)?;
/// // The vertex (1, 1, 1) tends to a fifth of itself, 4√3/5 away.
/// let depth = distances.depth(&Rational::new(3, 2))?;
/// assert_eq!((depth.level, depth.too_few), (0, None));
/// assert!(depth.distance[0] <= 1.3857 && 1.3856 <= depth.distance[1]);
/// let depth = distances.depth(&Rational::new(1, 100))?;
/// assert_eq!(depth.too_few, Some(depth.level - 1));
/// # Ok::<(), subcert::mesh::MeshError>(())
/// ```
pub type MeshDistances = Distances<Model>;

impl Distances<Model> {
    /// The pieces of a mesh.
    ///
    /// # Errors
    /// When the scheme has no rules for a face or a vertex, the mesh of level 1 has too many points, or
    /// there is no limit surface.
    pub fn new(mesh: PolygonMesh<Rational>, scheme: MeshScheme) -> Result<Self, MeshError> {
        let model = Model::new(mesh, scheme)?;
        if model.roots.all.is_empty() {
            let reason = if scheme == MeshScheme::DooSabin {
                "no vertex is inside the mesh, and Doo–Sabin surfaces end at the faces around inner vertices; take \
                 catmull-clark"
            } else {
                "all faces are holes, or at a boundary with the rules `none`; take other rules at the boundary, `edge` or \
                 `corner`, or fewer holes"
            };
            return Err(MeshError::TooMuch { reason: format!("the surface is empty: {reason}") });
        }
        Ok(Distances::of(model))
    }

    /// The pieces of a solid, which Bajaj's scheme refines. P^k is trilinear on each hexahedron.
    ///
    /// Source: `proofs/THEOREMS.md`, 100 to 102.
    ///
    /// # Errors
    /// When the mesh of level 1 has too many points, or its cells meet in too many different ways.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::patch::MeshDistances;
    /// use subcert::solid::HexMesh;
    ///
    /// let corner = |k: usize| [k & 1, k >> 1 & 1, k >> 2].map(Rational::from);
    /// let cube = HexMesh::new((0..8).map(corner).collect(), &[[0, 1, 3, 2, 4, 5, 7, 6]])?;
    /// // The corner (0, 0, 0) tends to (2, 2, 2)/9, 2√3/9 = 0.3849… away.
    /// let depth = MeshDistances::of_solid(cube)?.depth(&Rational::new(2, 5))?;
    /// assert_eq!(depth.level, 0);
    /// assert!(depth.distance[0] <= 0.3850 && 0.3849 <= depth.distance[1]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_solid(mesh: HexMesh<Rational>) -> Result<Self, SolidError> {
        // A point of the limit of a solid is mostly inside the mesh: 0 says no less than is looked for.
        Ok(Distances::of(Model::of_solid(mesh)?).without_apart())
    }

    /// For each face of the control mesh an upper bound of the distance at this level and at all later
    /// ones, without a search: G_{k−1} N of its pieces of level 1 (`proofs/THEOREMS.md`, 92 and 94).
    /// [`depth`](Self::depth) begins with these bounds. They are attained on regular faces of
    /// paraboloids, and some ten times too great around irregular vertices.
    ///
    /// # Panics
    /// At level 0: the bounds begin with level 1.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::mesh::{MeshScheme, PolygonMesh};
    /// use subcert::patch::MeshDistances;
    ///
    /// let points = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]].map(|p| p.map(Rational::from));
    /// let faces = vec![vec![0, 1, 2], vec![0, 3, 1], vec![0, 2, 3], vec![1, 3, 2]];
    /// let distances =
    ///     MeshDistances::new(PolygonMesh::new(points.to_vec(), faces)?, MeshScheme::Loop)?;
    /// assert!(distances.guaranteed(4)[0] < distances.guaranteed(3)[0]);
    /// # Ok::<(), subcert::mesh::MeshError>(())
    /// ```
    #[must_use]
    pub fn guaranteed(&self, level: u32) -> Vec<f64> {
        assert!(level > 0, "the bounds of a mesh begin with level 1");
        let model = &self.model;
        let mut faces = vec![0.0_f64; model.source.face_count()];
        let scale = nearest(&model.scale);
        for (root, bound) in model.roots.all.iter().zip(model.bounds(level)) {
            faces[root.face] = faces[root.face].max(bound * scale * UP);
        }
        faces
    }
}

distances_of!(Model, MeshError);

/// The roots are the pieces of level 1.
impl Surface for Model {
    type Error = MeshError;
    type Cell = LevelPiece<Point<f64>>;
    type At = u128;
    const FIRST: u32 = 1;
    const STEPS: u64 = 100_000;

    fn root_count(&self) -> usize {
        self.roots.all.len()
    }

    fn face_count(&self) -> usize {
        self.source.face_count()
    }

    fn frame(&self) -> (&Point<Rational>, &Rational) {
        (&self.source.points()[0], &self.scale)
    }

    fn most_levels(&self) -> [u32; 2] {
        [u32::MAX; 2]
    }

    /// Of level 0 there is none.
    fn bounds(&self, level: u32) -> impl Iterator<Item = f64> {
        let later = level.checked_sub(1);
        let roots = self.roots.all.iter().zip(&self.sizes);
        roots.map(move |(root, size)| {
            later.map_or(f64::INFINITY, |later| self.shapes.get(root.shape).bound(*size, later))
        })
    }

    fn rounded_judge(&self, tolerance: &Rational) -> Rounded {
        self.rounded_judge_after(tolerance, 0)
    }

    fn root(&self, root: usize, level: u32) -> Self::Cell {
        self.rounded_cell(&self.roots.all[root], level)
    }

    fn search<'a>(
        &'a self,
        judge: &'a Rounded,
        level: u32,
        steps: u64,
    ) -> impl PieceSearch<Self::Cell, Place<u128, Point<f64>>> {
        Search::new(&self.shapes, judge, level, steps)
    }

    fn examine_exactly(
        &self,
        root: usize,
        level: u32,
        tolerance: &Rational,
        steps: &mut u64,
    ) -> Option<Verdict<FarPlace>> {
        let cell = self.exact_cell(&self.roots.all[root], level)?;
        let judge = Exactly::<RealCyclotomic>::new(tolerance);
        let mut search = Search::new(&self.shapes, &judge, level, *steps);
        let verdict = search.examine(cell);
        *steps = search.left();
        Some(verdict.map(|place| {
            let points = [&place.polygon, &place.limit];
            let points = points.map(|point| point.each_ref().map(nearest));
            self.numbered(root, level, &place, points)
        }))
    }

    fn numbered<V>(
        &self,
        root: usize,
        level: u32,
        place: &Place<u128, V>,
        [on_mesh, on_limit]: [Point<f64>; 2],
    ) -> FarPlace {
        let root = &self.roots.all[root];
        let first = (level > 0).then(|| self.source.first_part(root.face)).flatten();
        let level_face = first.map(|first| {
            // The path of the piece of that level, which the place may be a part of.
            let path = place.at >> (2 * (place.level.max(level) - level));
            (((first + root.part) as u128) << (2 * (level - 1))) + path
        });
        let vertex = self.source.vertex(root);
        FarPlace { face: root.face, vertex, level_face, on_mesh, on_limit }
    }

    fn on_faces(&self, root: usize, level: u32) -> Vec<(Vec<usize>, Self::Cell)> {
        vec![(vec![self.roots.all[root].face], self.root(root, level))]
    }

    fn ball(&self, cell: &Self::Cell, judge: &Rounded, _: u32) -> Ball {
        let centre = mean(cell.of_mesh());
        ball(cell, judge, centre)
    }

    fn root_ball(&self, cell: &Self::Cell, judge: &Rounded, _: u32) -> Ball {
        ball(cell, judge, cell.of_mesh()[0])
    }

    fn finer(&self, cell: Self::Cell, level: u32) -> Vec<Self::Cell> {
        if let Some(base) = &cell.base {
            // Of a bilinear or flat piece no points are needed but its corners.
            let part = |rows| LevelPiece {
                level: cell.level + 1,
                points: Vec::new(),
                base: Some(combinations(rows, base)),
                ..cell
            };
            return self.quarters.iter().map(part).collect();
        }
        if cell.level < level {
            return cell.parts(&self.shapes, false);
        }
        cell.begun(&self.shapes).map_or_else(|| cell.parts(&self.shapes, true), |begun| vec![begun])
    }

    /// Irregular edges of solids have many pieces.
    fn width(&self) -> f64 {
        if self.shapes.scheme == PieceScheme::Solid { 0.02 } else { WIDTH }
    }
}

/// A ball around the points that the mesh of a level is in the hull of.
fn ball(cell: &LevelPiece<Point<f64>>, judge: &Rounded, centre: Point<f64>) -> Ball {
    let ways = cell.of_mesh().iter().map(|x| x.minus(&centre));
    let radius = judge.greatest(ways, cell.level);
    // The mean of the corners is a point of the mesh.
    Ball { centre, radius, level: cell.level, on_mesh: cell.base.is_some() }
}
