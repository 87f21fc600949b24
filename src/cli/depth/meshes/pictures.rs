//! What pages of meshes, nets and solids show: distances as colours, and against the level.

use super::refined::{Refined, rounded};
use super::subject::Subject;
use std::collections::BTreeSet;
use subcert::exact::{Rational, format::short};
use subcert::float::{exact, shortest};
use subcert::mesh::PolygonMesh;
use subcert::patch::MeshDepth;
use subcert::report::html::{ColouredFaces, LevelLine, Levels, Picture};
use subcert::solid::HexMesh;

/// The most faces of a mesh whose distance is found at every level up to the depth.
const MAX_FACES: usize = 5_000;

/// The distances at points are shown where they are no less than such a part of the greatest one.
const LITTLE: f64 = 2.0;

/// A mesh of fewer faces is not drawn besides its refinement.
const FEW: usize = 24;

/// The most levels, of which the last is the depth.
const MAX_LEVELS: u32 = 12;

/// Faces with the bounds of their distances.
pub(super) struct Pieces {
    points: Vec<[f64; 3]>,
    faces: Vec<Vec<usize>>,
    /// Upper bounds.
    values: Vec<f64>,
    /// How many faces or cells there are.
    count: usize,
    note: &'static str,
}

impl Pieces {
    /// The faces of a mesh or a net.
    pub(super) fn of_mesh(mesh: &PolygonMesh<Rational>, bounds: Vec<[f64; 2]>) -> Pieces {
        Pieces {
            points: mesh.points().iter().map(rounded).collect(),
            faces: mesh.faces().to_vec(),
            count: bounds.len(),
            values: bounds.into_iter().map(|[_, upper]| upper).collect(),
            note: "",
        }
    }

    /// The faces of the boundary of a solid, each with the distance of its cell.
    pub(super) fn of_solid(mesh: &HexMesh<Rational>, bounds: &[[f64; 2]]) -> Pieces {
        let points: Vec<[f64; 3]> = mesh.points().iter().map(rounded).collect();
        let mut around = vec![Vec::new(); points.len()];
        for (cell, corners) in mesh.cells().iter().enumerate() {
            for corner in corners {
                around[*corner].push(cell);
            }
        }
        let faces = mesh.boundary_faces();
        // The one cell that has all corners of the face.
        let of = |face: &[usize; 4]| {
            let mut cells: BTreeSet<usize> = around[face[0]].iter().copied().collect();
            for corner in &face[1..] {
                cells.retain(|cell| around[*corner].contains(cell));
            }
            cells.first().and_then(|cell| bounds.get(*cell)).map_or(0.0, |[_, upper]| *upper)
        };
        Pieces {
            values: faces.iter().map(of).collect(),
            faces: faces.iter().map(|face| face.to_vec()).collect(),
            points,
            count: bounds.len(),
            note: "Each face of the boundary has the colour of its cell; cells inside are not seen.",
        }
    }
}

/// What is drawn of a depth.
pub(super) struct Drawn<'d> {
    pub(super) subject: &'d Subject<'d>,
    pub(super) depth: &'d MeshDepth,
    /// A level with the distances at its points.
    pub(super) refined: Option<Refined>,
}

impl Drawn<'_> {
    /// The refined mesh, by the distances of its points; `None` where these say little of the distances between them,
    /// which are at least and at most those of `bounds`.
    fn refined(&self, refined: &Refined, bounds: [f64; 2]) -> Option<Picture> {
        let Refined { level, points, faces, values } = refined;
        let greatest = values.iter().copied().fold(0.0, f64::max);
        if greatest * LITTLE < bounds[0] {
            return None;
        }
        let worst = self.depth.worst.as_ref().filter(|_| *level == self.depth.level);
        let most = exact(bounds[1]).map_or_else(|| shortest(bounds[1]), |most| short(&most, 3));
        Picture::of_faces(&ColouredFaces {
            name: &format!("{}, level {level}", self.subject.name),
            values_are: "greatest distance of the corners from where they go".to_owned(),
            points,
            faces,
            values,
            place: worst.map(|place| place.on_mesh),
            note: &format!("Between the corners it may be greater, and is at most {most}."),
        })
    }

    /// The pictures; `distance` gives the bounds at a level.
    pub(super) fn pictures(
        &self,
        pieces: &Pieces,
        distance: impl Fn(u32) -> [f64; 2],
    ) -> Vec<Picture> {
        let level = self.depth.level;
        let faces = ColouredFaces {
            name: &self.subject.name,
            values_are: format!("upper bound of the distance from the limit at level {level}"),
            points: &pieces.points,
            faces: &pieces.faces,
            values: &pieces.values,
            place: self.depth.worst.as_ref().map(|place| place.on_mesh),
            note: pieces.note,
        };
        // Of great meshes, and below many levels, only the last levels.
        let first = if pieces.count > MAX_FACES { level } else { level.saturating_sub(MAX_LEVELS) };
        let found = |at: u32| if at == level { self.depth.distance } else { distance(at) };
        let line = LevelLine {
            name: "distance".to_owned(),
            values: (first..=level).map(|at| (at, found(at)[1])).collect(),
            met: Some(level),
            is_constant: false,
        };
        let (tolerance, promised) = (&self.subject.tolerance, self.subject.promises());
        let levels = Levels { tolerance, lines: vec![line], promised };
        let refined = self.refined.as_ref();
        let refined = refined.and_then(|refined| self.refined(refined, found(refined.level)));
        let coarse = refined.is_none() || faces.faces.len() >= FEW;
        let faces = if coarse { Picture::of_faces(&faces) } else { None };
        refined.into_iter().chain(faces).chain(Picture::of_levels(&levels)).collect()
    }
}
