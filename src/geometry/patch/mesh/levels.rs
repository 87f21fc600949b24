//! The points of the control mesh and of level 1.

use super::roots::{Corners, Root, Roots, corners};
use crate::exact::{Rational, RealCyclotomic};
use crate::mesh::{MeshScheme, Point, PolygonMesh, Stencils, check_common_field, step_with};
use crate::patch::number::{Number, Vector, combinations};
use crate::solid::{Complex, HexMesh, check_bits, refined_points, split_points};

/// The points of level 1, and what the control mesh has at the corners of pieces of level 1.
pub(crate) struct Levels<V: Vector> {
    pub(crate) refined: Vec<V>,
    start: Start<V>,
}

enum Start<V: Vector> {
    /// The vertices of a surface, and the corners of the parts of its faces.
    Faces { control: Vec<V>, corners: Corners<V::Weight> },
    /// Of a solid, for each point of level 1 the point of the control mesh with its parameters.
    Split(Vec<V>),
}

impl<V: Vector> Levels<V> {
    /// What the control mesh has at the corners of a piece.
    pub(super) fn start(&self, root: &Root, roots: &Roots, faces: &Source) -> Vec<V> {
        match (&self.start, faces) {
            (Start::Faces { control, corners }, Source::Surface { mesh, .. }) => {
                let face = &mesh.faces()[root.face];
                let points: Vec<V> = face.iter().map(|&vertex| control[vertex].clone()).collect();
                combinations(&corners[&face.len()][root.part], &points)
            }
            (Start::Split(points), _) => {
                let numbers = roots.first_points(root, 8).iter();
                numbers.map(|&point| points[point as usize].clone()).collect()
            }
            (Start::Faces { .. }, Source::Solid(_)) => Vec::new(),
        }
    }
}

/// What the pieces come from.
pub(crate) enum Source {
    Surface { mesh: PolygonMesh<Rational>, scheme: MeshScheme, stencils: Stencils },
    Solid(HexMesh<Rational>),
}

impl Source {
    pub(crate) fn points(&self) -> &[Point<Rational>] {
        match self {
            Source::Surface { mesh, .. } => mesh.points(),
            Source::Solid(mesh) => mesh.points(),
        }
    }

    /// How many faces there are; of a solid, cells.
    pub(super) fn face_count(&self) -> usize {
        match self {
            Source::Surface { mesh, .. } => mesh.faces().len(),
            Source::Solid(mesh) => mesh.complex().cells.len(),
        }
    }

    /// The vertex whose part of a face or cell a piece is.
    pub(super) fn vertex(&self, root: &Root) -> Option<usize> {
        match self {
            Source::Surface { mesh, .. } => mesh.faces()[root.face].get(root.part).copied(),
            Source::Solid(mesh) => Some(mesh.complex().cells[root.face][root.part]),
        }
    }

    /// The first of the faces of level 1 that a face becomes; `None` for Doo and Sabin, and of a solid.
    pub(crate) fn first_part(&self, face: usize) -> Option<usize> {
        match self {
            Source::Surface { scheme: MeshScheme::DooSabin, .. } | Source::Solid(_) => None,
            Source::Surface { mesh, scheme, .. } if scheme.is_bicubic() => {
                Some(mesh.faces()[..face].iter().map(Vec::len).sum())
            }
            Source::Surface { .. } => Some(4 * face),
        }
    }

    /// The exact points; `None` where there would be too many, or too long ones.
    pub(crate) fn exact(&self, count: usize) -> Option<Levels<Point<RealCyclotomic>>> {
        match self {
            Source::Surface { mesh, scheme, stencils, .. } => {
                let mesh = mesh.map(|x| RealCyclotomic::from(x.clone()));
                let (control, points) = (mesh.connectivity(), mesh.points());
                check_common_field(control, points, *scheme, count).ok()?;
                let refined = step_with(&mesh, *scheme, stencils).ok()?;
                Some(surface(&mesh, *scheme, refined.points().to_vec()))
            }
            Source::Solid(mesh) => {
                check_bits(mesh).ok()?;
                let points = mesh.map(|x| RealCyclotomic::from(x.clone()));
                Some(solid(mesh.complex(), points.points()))
            }
        }
    }
}

/// The points of a surface and those of its refinement.
pub(crate) fn surface<S: Number>(
    mesh: &PolygonMesh<S>,
    scheme: MeshScheme,
    refined: Vec<Point<S>>,
) -> Levels<Point<S>> {
    let corners = corners(scheme, mesh.connectivity());
    Levels { refined, start: Start::Faces { control: mesh.points().to_vec(), corners } }
}

/// The points of a solid.
pub(super) fn solid<S: Number>(complex: &Complex, points: &[Point<S>]) -> Levels<Point<S>> {
    let refined = refined_points(complex, points);
    let [edges, faces, cells] = split_points(complex, points);
    let split = points.iter().cloned().chain(edges).chain(faces).chain(cells).collect();
    Levels { refined, start: Start::Split(split) }
}
