//! What pages of meshes, nets and solids show: distances as colours, and against the level.

use std::collections::BTreeSet;
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::mesh::PolygonMesh;
use subcert::patch::MeshDepth;
use subcert::report::html::{ColouredFaces, LevelLine, Levels, Picture};
use subcert::solid::HexMesh;

/// The most faces of a mesh whose distance is found at every level up to the depth.
const MAX_FACES: usize = 5_000;

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
            corners.iter().for_each(|corner| around[*corner].push(cell));
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

fn rounded(point: &[Rational; 3]) -> [f64; 3] {
    point.each_ref().map(nearest)
}

/// What is drawn of a depth.
pub(super) struct Drawn<'d> {
    pub(super) name: &'d str,
    pub(super) tolerance: &'d Rational,
    pub(super) depth: &'d MeshDepth,
}

impl Drawn<'_> {
    /// The pictures; `distance` gives the bounds at a level.
    pub(super) fn pictures(
        &self,
        pieces: &Pieces,
        promised: Vec<(u32, String)>,
        distance: impl Fn(u32) -> [f64; 2],
    ) -> Vec<Picture> {
        let level = self.depth.level;
        let faces = ColouredFaces {
            name: self.name,
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
            name: "distance at most".to_owned(),
            values: (first..=level).map(|at| (at, found(at)[1])).collect(),
            met: Some(level),
            is_constant: false,
        };
        let levels = Levels { tolerance: self.tolerance, lines: vec![line], promised };
        Picture::of_faces(&faces).into_iter().chain(Picture::of_levels(&levels)).collect()
    }
}
