//! A mesh as the search sees it: its pieces, in f64 and exactly.

use super::levels::{Levels, Source, solid, surface};
use super::piece::LevelPiece;
use super::roots::{Root, Roots};
use crate::exact::{Rational, RealCyclotomic};
use crate::float::nearest;
use crate::mesh::{
    MeshError, MeshScheme, Point, PolygonMesh, Stencils, check_rules, check_tags, step_with,
    weighted_valences,
};
use crate::patch::distance::judge::{Points, Rounded};
use crate::patch::hexes::hex_roots;
use crate::patch::number::Row;
use crate::patch::range::scale;
use crate::patch::shapes::library::Shapes;
use crate::patch::shapes::rules::parts_of_face;
use crate::patch::shapes::scheme::PieceScheme;
use crate::patch::threads::in_threads;
use crate::solid::{HexMesh, MAX_POINTS, SolidError};
use std::sync::OnceLock;

/// A mesh or a solid as pieces.
pub struct Model {
    pub(crate) shapes: Shapes,
    pub(crate) roots: Roots,
    pub(crate) source: Source,
    /// In f64: moved so that the first point is the origin, and multiplied by 2^−e.
    rounded: Levels<Point<f64>>,
    /// `None` where exact numbers are too much work.
    exact: OnceLock<Option<Levels<Point<RealCyclotomic>>>>,
    /// 2^e.
    pub(crate) scale: Rational,
    /// The greatest coordinate, and the most weights of a row.
    size: f64,
    terms: usize,
    /// The sizes of the pieces of level 1.
    pub(super) sizes: Vec<f64>,
    /// The corners of the parts of a bilinear or flat piece.
    pub(super) quarters: Vec<Vec<Row<f64>>>,
}

impl Model {
    pub(crate) fn new(
        control: PolygonMesh<Rational>,
        scheme: MeshScheme,
    ) -> Result<Model, MeshError> {
        check_tags(&control, scheme)?;
        let connectivity = control.connectivity();
        check_rules(connectivity, scheme)?;
        let stencils = Stencils::new(scheme, weighted_valences(connectivity, scheme));
        let scale = scale::<MeshError>(control.points())?;
        let mesh = control.with_points(moved(control.points(), &scale));
        let next = step_with(&mesh, scheme, &stencils.map(nearest))?;
        let mut shapes = Shapes::new(PieceScheme::Surface(scheme));
        let roots = Roots::of(scheme, connectivity, &next, &mut shapes)?;
        let rounded = surface(&mesh, scheme, next.points().to_vec());
        let faces = connectivity.faces().iter().map(Vec::len).max().unwrap_or(0);
        let valence = (0..connectivity.point_count()).map(|v| connectivity.star(v).valence());
        // A blend of two rules has a few operations more.
        let blends = if control.tags().has_sharp() { 8 } else { 0 };
        let terms = 2 * valence.max().unwrap_or(0) + 2 * faces + blends;
        let size = size(mesh.points());
        let source = Source::Surface { mesh: control, scheme, stencils };
        Ok(Model::of(shapes, roots, source, rounded, (scale, size, terms)))
    }

    /// # Errors
    /// When there would be too many points, there are too many shapes, or f64 has no such coordinates.
    pub(super) fn of_solid(control: HexMesh<Rational>) -> Result<Model, SolidError> {
        let complex = control.complex();
        let (edges, faces) = (complex.edges.len(), complex.faces.len());
        let points = complex.points + edges + faces + complex.cells.len();
        if points > MAX_POINTS {
            return Err(SolidError::TooManyPoints { points });
        }
        let mut shapes = Shapes::new(PieceScheme::Solid);
        let roots = hex_roots(complex, &mut shapes)?;
        let scale = scale::<SolidError>(control.points())?;
        let moved = moved(control.points(), &scale);
        let rounded = solid(complex, &moved);
        let mut counts = vec![0_usize; complex.points];
        complex.cells.iter().flatten().for_each(|&point| counts[point] += 1);
        // A vertex is a mean of the edges, faces and cells around it, fewer than four for each cell.
        let terms = 4 * counts.into_iter().max().unwrap_or(0) + 32;
        let size = size(&moved);
        let source = Source::Solid(control);
        Ok(Model::of(shapes, roots, source, rounded, (scale, size, terms)))
    }

    fn of(
        shapes: Shapes,
        roots: Roots,
        source: Source,
        rounded: Levels<Point<f64>>,
        (scale, size, terms): (Rational, f64, usize),
    ) -> Model {
        let terms = terms.max(shapes.longest());
        let (exact, sizes) = (OnceLock::new(), Vec::new());
        let quarters = parts_of_face(if shapes.scheme.is_triangular() { 3 } else { 4 });
        let mut model =
            Model { shapes, roots, source, rounded, exact, scale, size, terms, sizes, quarters };
        let judge = model.rounded_judge_after(&Rational::one(), 0);
        model.sizes = in_threads(&model.roots.all, |root| {
            model.rounded_cell(root, 1).size(&model.shapes, &judge)
        });
        model
    }

    /// Lengths in f64, for the points of the levels after that many, counted from 0 again: the slack of level ℓ is at least
    /// that of level ℓ + `level`.
    pub(crate) fn rounded_judge_after(&self, tolerance: &Rational, level: u32) -> Rounded {
        let size = self.size * f64::from(level + 1);
        Rounded::new(&(tolerance / &self.scale), size, self.terms)
    }

    /// The points of a control mesh in f64: moved and scaled.
    pub(crate) fn control(&self) -> Vec<Point<f64>> {
        moved(self.source.points(), &self.scale)
    }

    /// How many vertices the face of a piece has.
    pub(crate) fn face_size(&self, root: &Root) -> usize {
        match &self.source {
            Source::Surface { mesh, .. } => mesh.faces()[root.face].len(),
            Source::Solid(_) => 0,
        }
    }

    fn cell<V: Points>(&self, root: &Root, level: u32, points: &Levels<V>) -> LevelPiece<V> {
        let cell = self.roots.cell(root, &self.shapes, &points.refined);
        if level > 0 {
            return cell;
        }
        LevelPiece { base: Some(points.start(root, &self.roots, &self.source)), ..cell }
    }

    /// A piece in f64, for the polygons of a level.
    pub(crate) fn rounded_cell(&self, root: &Root, level: u32) -> LevelPiece<Point<f64>> {
        self.cell(root, level, &self.rounded)
    }

    /// The same exactly; `None` where exact numbers are too much work.
    pub(super) fn exact_cell(
        &self,
        root: &Root,
        level: u32,
    ) -> Option<LevelPiece<Point<RealCyclotomic>>> {
        let levels = self.exact.get_or_init(|| self.source.exact(self.rounded.refined.len()));
        Some(self.cell(root, level, levels.as_ref()?))
    }
}

/// The points in f64, the first one as the origin, in units of the scale.
pub(crate) fn moved(points: &[Point<Rational>], scale: &Rational) -> Vec<Point<f64>> {
    let origin = &points[0];
    let moved =
        |point: &Point<Rational>| [0, 1, 2].map(|i| nearest(&(&(&point[i] - &origin[i]) / scale)));
    points.iter().map(moved).collect()
}

/// The greatest coordinate.
fn size(points: &[Point<f64>]) -> f64 {
    points.iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()))
}
