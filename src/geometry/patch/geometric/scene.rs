//! A mesh of a level, or a part of it, with its pieces of the limit.

use super::super::cell::Cell;
use super::super::judge::{Judge, Rounded};
use super::super::kind::Kind;
use super::super::number::Vector as _;
use super::super::number::combinations;
use super::super::roots::{Roots, corners};
use super::super::search::{Search, Verdict};
use super::super::shapes::Shapes;
use super::depth::SetKind;
use super::node::Nodes;
use super::patch::{FaceSurface, Patch, length};
use super::shadow::Segment;
use crate::mesh::{Connectivity, MeshError, MeshScheme, Point, PolygonMesh, Stencils, step_with};
use std::collections::HashMap;
use std::sync::OnceLock;

/// How many pieces are looked at for the distance of a unit at equal parameters.
const UNIT_STEPS: u64 = 400;

/// A part of a face of the mesh, together with the part of the limit that has the same parameters: a quarter
/// of a quadrilateral at a vertex, a quarter of a triangle.
pub(super) struct Unit {
    /// The face of the mesh of the level, and which part of it.
    pub(super) face: usize,
    pub(super) part: usize,
    pub(super) patches: Vec<Patch>,
    /// Whether the mesh on it is that of 91.
    plain: bool,
    base: Vec<Point<f64>>,
    /// The numbers of the corners: of the vertices, then the edges, then the faces.
    corners: Vec<usize>,
}

/// The mesh with its units.
pub(super) struct Scene<'a> {
    pub(super) shapes: &'a Shapes,
    kind: Kind,
    roots: Roots,
    refined: Vec<Point<f64>>,
    pub(super) units: Vec<Unit>,
    /// The units at each corner.
    at_corner: HashMap<usize, Vec<usize>>,
    pub(super) judge: Rounded,
    /// How far lengths may be off.
    pub(super) slack: f64,
    moved: Vec<OnceLock<f64>>,
}

/// Units with the boundary of what they make up.
pub(super) struct Ring {
    pub(super) units: Vec<usize>,
    pub(super) boundary: Vec<Segment>,
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
        let roots = Roots::of(scheme, mesh.connectivity(), next.connectivity(), shapes);
        Ok(Stage { refined: next.points().to_vec(), roots, mesh })
    }

    pub(super) fn scene(
        self,
        scheme: MeshScheme,
        surface: FaceSurface,
        shapes: &Shapes,
        judge: Rounded,
    ) -> Scene<'_> {
        let Stage { mesh, refined, roots } = self;
        let connectivity = mesh.connectivity();
        let rows = corners::<f64>(scheme, connectivity);
        let triangles = Kind::Surface(scheme).is_triangular();
        let units: Vec<Unit> = roots
            .all
            .iter()
            .map(|root| {
                let face = &mesh.faces()[root.face];
                let points: Vec<Point<f64>> = face.iter().map(|&v| mesh.points()[v]).collect();
                let base = combinations(&rows[&face.len()][root.part], &points);
                let bilinear = surface.is_bilinear(face.len());
                let corners = corner_numbers(connectivity, root.face, root.part, triangles);
                let patches = Patch::between(&base, bilinear);
                let (face, part) = (root.face, root.part);
                Unit { face, part, patches, plain: bilinear || triangles, base, corners }
            })
            .collect();
        let mut at_corner: HashMap<usize, Vec<usize>> = HashMap::new();
        for (number, unit) in units.iter().enumerate() {
            for &corner in &unit.corners {
                at_corner.entry(corner).or_default().push(number);
            }
        }
        // At the highest level of pieces that are made here.
        let slack = 4.0 * judge.slack(32);
        let moved = units.iter().map(|_| OnceLock::new()).collect();
        let kind = Kind::Surface(scheme);
        Scene { shapes, kind, roots, refined, units, at_corner, judge, slack, moved }
    }
}

/// The numbers of the corners of a part of a face, in the order of `Roots`.
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

impl Scene<'_> {
    /// The piece of the limit of a unit.
    pub(super) fn cell(&self, unit: usize) -> Cell<Point<f64>> {
        self.roots.cell(&self.roots.all[unit], self.shapes, &self.refined)
    }

    fn based(&self, unit: usize) -> Cell<Point<f64>> {
        Cell { base: Some(self.units[unit].base.clone()), ..self.cell(unit) }
    }

    /// Whether mesh and limit are within the tolerance on a unit, point by point at equal parameters.
    pub(super) fn is_near_by_parameter(&self, unit: usize) -> bool {
        if !self.units[unit].plain {
            return false;
        }
        let mut search = Search::new(self.shapes, self.kind, &self.judge, 0, UNIT_STEPS);
        matches!(search.examine(self.based(unit)), Verdict::Within)
    }

    /// The same for a mesh that is so many levels later, at least one. `regular`: only of regular pieces.
    pub(super) fn is_near_later(&self, unit: usize, later: u32, regular: bool) -> bool {
        let cell = self.cell(unit);
        if regular && !self.shapes.get(cell.shape).is_regular() {
            return false;
        }
        let mut search = Search::new(self.shapes, self.kind, &self.judge, later, UNIT_STEPS);
        matches!(search.examine(cell), Verdict::Within)
    }

    /// How far the limit is at most from the mesh of 91, on a unit at equal parameters.
    fn moved(&self, unit: usize) -> f64 {
        *self.moved[unit].get_or_init(|| {
            let mut search = Search::new(self.shapes, self.kind, &self.judge, 0, UNIT_STEPS);
            let (mut best, mut place) = (0.0, None);
            let upper = search.measure(self.based(unit), 0.2, &mut best, &mut place);
            upper.max(best)
        })
    }

    /// The units that are so many steps away, from corner to corner.
    pub(super) fn ring(&self, unit: usize, steps: usize) -> Ring {
        let mut units = vec![unit];
        let mut begin = 0;
        for _ in 0..steps {
            let end = units.len();
            for at in begin..end {
                for corner in &self.units[units[at]].corners {
                    for &other in &self.at_corner[corner] {
                        if !units.contains(&other) {
                            units.push(other);
                        }
                    }
                }
            }
            begin = end;
        }
        // A segment between two of them is met once in each direction.
        let mut segments: HashMap<[usize; 2], Segment> = HashMap::new();
        for &unit in &units {
            let Unit { corners, base, .. } = &self.units[unit];
            for i in 0..corners.len() {
                let next = (i + 1) % corners.len();
                let key = [corners[i], corners[next]];
                if segments.remove(&[key[1], key[0]]).is_none() {
                    let ends = [base[i], base[next]];
                    let moved = self.moved(unit) + self.slack;
                    segments.insert(key, Segment { ends, moved });
                }
            }
        }
        let mut boundary: Vec<([usize; 2], Segment)> = segments.into_iter().collect();
        boundary.sort_by_key(|(key, _)| *key);
        Ring { units, boundary: boundary.into_iter().map(|(_, segment)| segment).collect() }
    }

    /// A f64 that is at most the tolerance.
    pub(super) fn tolerance(&self) -> f64 {
        Judge::<Point<f64>>::tolerance(&self.judge)
    }
}

impl Scene<'_> {
    /// The points of a unit that are tried first: limits at its corners, corners of its mesh.
    pub(super) fn unit_points(&self, unit: usize) -> Vec<(Point<f64>, SetKind)> {
        let mut nodes = Nodes::new(self.shapes);
        let node = nodes.add(self.cell(unit));
        let limits = nodes.get(node).limits.iter().map(|point| (*point, SetKind::Limit));
        let corners = self.units[unit].base.iter().map(|point| (*point, SetKind::Mesh));
        limits.chain(corners).collect()
    }

    /// A point of the other set that is near, among a few of the unit.
    pub(super) fn near(&self, unit: usize, point: &Point<f64>, from: SetKind) -> Point<f64> {
        let distance = |other: &Point<f64>| length(&other.minus(point));
        let others: Vec<Point<f64>> = match from {
            SetKind::Limit => self.units[unit].patches.iter().map(|x| x.near(point)).collect(),
            SetKind::Mesh => {
                let points = self.unit_points(unit).into_iter();
                points.filter(|(_, of)| *of == SetKind::Limit).map(|(point, _)| point).collect()
            }
        };
        let nearest = others.into_iter().min_by(|x, y| distance(x).total_cmp(&distance(y)));
        nearest.unwrap_or(*point)
    }
}
