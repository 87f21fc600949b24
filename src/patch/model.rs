//! A mesh as the search sees it: its pieces, in f64 and exactly.

use super::cell::Cell;
use super::judge::{Points, Rounded};
use super::number::Vector;
use super::roots::{Corners, Root, Roots, corners, refined};
use super::shapes::Shapes;
use super::threads::in_threads;
use crate::exact::{Rational, RealCyclotomic};
use crate::float::nearest;
use crate::mesh::{
    MeshError, MeshScheme, Point, PolygonMesh, Stencils, check_field, check_rules,
    weighted_valences,
};
use std::sync::OnceLock;

/// The points of the control mesh and of level 1.
pub(super) struct Levels<V: Vector> {
    control: Vec<V>,
    refined: Vec<V>,
    /// The corners of the parts of the control faces.
    corners: Corners<V::Weight>,
}

/// A mesh as pieces.
pub(super) struct Model {
    pub(super) scheme: MeshScheme,
    pub(super) shapes: Shapes,
    pub(super) roots: Roots,
    pub(super) control: PolygonMesh<Rational>,
    /// In f64: moved so that the first point is the origin, and multiplied by 2^−e.
    rounded: Levels<Point<f64>>,
    /// `None` where exact numbers are too much work.
    exact: OnceLock<Option<Levels<Point<RealCyclotomic>>>>,
    stencils: Stencils,
    /// 2^e.
    pub(super) scale: Rational,
    /// The greatest coordinate, and the most weights of a row.
    size: f64,
    terms: usize,
    /// The sizes of the pieces of level 1.
    sizes: Vec<f64>,
}

impl Model {
    pub(super) fn new(
        control: PolygonMesh<Rational>,
        scheme: MeshScheme,
    ) -> Result<Model, MeshError> {
        let connectivity = control.connectivity();
        check_rules(connectivity, scheme)?;
        let stencils = Stencils::new(scheme, weighted_valences(connectivity, scheme));
        let scale = scale(control.points());
        let origin = &control.points()[0];
        let moved: Vec<Point<f64>> = control
            .points()
            .iter()
            .map(|point| [0, 1, 2].map(|i| nearest(&(&(&point[i] - &origin[i]) / &scale))))
            .collect();
        let size = moved.iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()));
        let mesh = control.with_points(moved);
        let next = crate::mesh::step_with(&mesh, scheme, &stencils.map(nearest))?;
        let mut shapes = Shapes::new(scheme);
        let roots = Roots::of(scheme, connectivity, next.connectivity(), &mut shapes);
        let (control_points, refined) = (mesh.points().to_vec(), next.points().to_vec());
        let corners = corners(scheme, connectivity);
        let rounded = Levels { control: control_points, refined, corners };
        let exact = OnceLock::new();
        let faces = connectivity.faces().iter().map(Vec::len).max().unwrap_or(0);
        let valence = (0..connectivity.point_count()).map(|v| connectivity.star(v).valence());
        let terms = shapes.longest().max(2 * valence.max().unwrap_or(0) + 2 * faces);
        let sizes = Vec::new();
        let mut model = Model {
            scheme,
            shapes,
            roots,
            control,
            rounded,
            exact,
            stencils,
            scale,
            size,
            terms,
            sizes,
        };
        let judge = model.rounded_judge(&Rational::one());
        model.sizes = in_threads(&model.roots.all, |root| {
            model.rounded_cell(root, 1).size(&model.shapes, &judge)
        });
        Ok(model)
    }

    /// The bound of each piece of level 1 for a level from 1 on, and all later ones.
    pub(super) fn bounds(&self, level: u32) -> impl Iterator<Item = f64> + '_ {
        let bound =
            move |(root, size): (&Root, &f64)| self.shapes.get(root.shape).bound(*size, level - 1);
        self.roots.all.iter().zip(&self.sizes).map(bound)
    }

    /// The pieces of level 1 with a greater bound than this, the greatest first; for level 0, all.
    pub(super) fn above(&self, level: u32, threshold: f64) -> Vec<(f64, &Root)> {
        let bounds: Vec<f64> = match level {
            0 => vec![f64::INFINITY; self.roots.all.len()],
            _ => self.bounds(level).collect(),
        };
        let pieces = bounds.into_iter().zip(&self.roots.all);
        let mut above: Vec<(f64, &Root)> = pieces.filter(|(bound, _)| *bound > threshold).collect();
        above.sort_by(|left, right| right.0.total_cmp(&left.0));
        above
    }

    /// Lengths in f64.
    pub(super) fn rounded_judge(&self, tolerance: &Rational) -> Rounded {
        Rounded::new(&(tolerance / &self.scale), self.size, self.terms)
    }

    fn cell<V: Points>(&self, root: &Root, level: u32, points: &Levels<V>) -> Cell<V> {
        let (shapes, refined) = (&self.shapes, &points.refined);
        if level == 0 {
            let control = (self.control.connectivity(), &points.control[..]);
            self.roots.begun(root, shapes, refined, control, &points.corners)
        } else {
            self.roots.cell(root, shapes, refined)
        }
    }

    /// A piece in f64, for the polygons of a level.
    pub(super) fn rounded_cell(&self, root: &Root, level: u32) -> Cell<Point<f64>> {
        self.cell(root, level, &self.rounded)
    }

    /// The same exactly; `None` where exact numbers are too much work.
    pub(super) fn exact_cell(
        &self,
        root: &Root,
        level: u32,
    ) -> Option<Cell<Point<RealCyclotomic>>> {
        let levels = self.exact.get_or_init(|| {
            let mesh = self.control.map(|x| RealCyclotomic::from(x.clone()));
            let (control, count) = (mesh.connectivity(), self.rounded.refined.len());
            check_field(control, mesh.points(), self.scheme, false, count).ok()?;
            let refined = refined(&mesh, self.scheme, &self.stencils).ok()?;
            let corners = corners(self.scheme, control);
            Some(Levels { control: mesh.points().to_vec(), refined, corners })
        });
        Some(self.cell(root, level, levels.as_ref()?))
    }

    /// A point in f64 as it is in the file.
    pub(super) fn place(&self, point: &Point<f64>) -> Point<f64> {
        let scale = nearest(&self.scale);
        let origin = &self.control.points()[0];
        [0, 1, 2].map(|i| point[i] * scale + nearest(&origin[i]))
    }
}

/// The power of two that is just above all differences of coordinates from those of the first
/// point.
pub(super) fn scale(points: &[Point<Rational>]) -> Rational {
    let bits = |x: &Rational| {
        let [p, q] = [x.numerator(), x.denominator()];
        i64::try_from(p.bits()).unwrap_or(i64::MAX) - i64::try_from(q.bits()).unwrap_or(0) + 1
    };
    let origin = &points[0];
    let differences = points.iter().flat_map(|point| (0..3).map(|i| &point[i] - &origin[i]));
    let greatest = differences.filter(|x| !x.is_zero()).map(|x| bits(&x)).max().unwrap_or(0);
    Rational::from(2).pow(i32::try_from(greatest).unwrap_or(0))
}
