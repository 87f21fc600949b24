//! What each face of a mesh needs, by the distance of sets of points.

use super::faces::{FaceRow, without_holes};
use super::refined::rounded;
use super::subject::searched;
use crate::cli::arguments::{DepthArguments, FacesArgument};
use crate::cli::console::output::Failure;
use std::sync::Arc;
use subcert::exact::Rational;
use subcert::float::upper;
use subcert::mesh::{MeshError, MeshScheme, PolygonMesh};
use subcert::patch::{FaceDepth, FaceSurface, GeometricDepth, MeshDistances, MeshWork};
use subcert::report::html::{ColouredFaces, Picture};

/// How many faces come from one face: at level 1, and at each level after it.
#[derive(Clone, Copy)]
pub(super) enum Growth {
    /// Four, at every level.
    Triangles,
    /// One for each corner, then four.
    Corners,
    /// A product of arities, at every level.
    Arities(usize),
}

impl Growth {
    fn of(scheme: MeshScheme) -> Growth {
        match scheme {
            MeshScheme::Loop | MeshScheme::LoopWarren => Growth::Triangles,
            _ => Growth::Corners,
        }
    }

    fn count(self, face: &[usize], level: u32) -> f64 {
        let [first, later] = match self {
            Growth::Triangles => [4, 4],
            Growth::Corners => [face.len(), 4],
            Growth::Arities(product) => [product; 2],
        }
        .map(|count| f64::from(u32::try_from(count).unwrap_or(u32::MAX)));
        let more = i32::try_from(level).unwrap_or(i32::MAX) - 1;
        if level == 0 { 1.0 } else { first * later.powi(more) }
    }
}

/// What each face needs, and its distance at the level found.
pub(super) struct Faces {
    depths: Vec<FaceDepth>,
    /// Lower and upper bounds at the level.
    distances: Vec<[f64; 2]>,
}

impl Faces {
    pub(super) fn new(
        mut depths: Vec<FaceDepth>,
        mut distances: Vec<[f64; 2]>,
        level: u32,
        tolerance: &Rational,
    ) -> Faces {
        // The level is sufficient for all, also where the search of single faces ended early.
        for bounds in &mut distances {
            bounds[1] = bounds[1].min(upper(tolerance));
        }
        for depth in depths.iter_mut().filter(|depth| depth.level > level) {
            (depth.level, depth.is_least) = (level, false);
        }
        Faces { depths, distances }
    }

    /// The rows of `--per-face`.
    pub(super) fn rows(&self, level: u32) -> Vec<FaceRow> {
        let row = |(depth, bounds): (&FaceDepth, &[f64; 2])| FaceRow {
            level,
            bounds: *bounds,
            own: Some((depth.level, depth.is_least)),
        };
        self.depths.iter().zip(&self.distances).map(row).collect()
    }

    /// The picture of the distances.
    pub(super) fn picture(
        &self,
        name: &str,
        mesh: &PolygonMesh<Rational>,
        level: u32,
    ) -> Option<Picture> {
        let points: Vec<[f64; 3]> = mesh.points().iter().map(rounded).collect();
        let values: Vec<f64> = self.distances.iter().map(|[_, upper]| *upper).collect();
        Picture::of_faces(&ColouredFaces {
            name,
            values_are: format!("upper bound of the Hausdorff distance at level {level}"),
            points: &points,
            faces: mesh.faces(),
            values: &values,
            place: None,
            note: "Bounds are the tolerance, or a half, a quarter or an eighth of it.",
        })
    }

    /// How many faces but holes there are at one level for all, and where each face has its own.
    pub(super) fn counts(
        &self,
        mesh: &PolygonMesh<Rational>,
        growth: Growth,
        level: u32,
    ) -> [f64; 2] {
        without_holes(mesh, &self.depths).fold([0.0; 2], |[all, each], (_, own, vertices)| {
            [all + growth.count(vertices, level), each + growth.count(vertices, own.level)]
        })
    }
}

/// What a search finds of a mesh or a net.
pub(super) struct Search {
    /// What its faces are.
    pub(super) surface: FaceSurface,
    pub(super) growth: Growth,
    pub(super) found: GeometricDepth,
    pub(super) faces: Option<Faces>,
}

impl Search {
    /// With the reason why it was stopped, if it ended for that.
    pub(super) fn ended(mut self, stopped: Option<String>) -> Search {
        self.found.ended = self.found.ended.map(|why| stopped.unwrap_or(why));
        self
    }

    pub(super) fn of(
        mesh: &PolygonMesh<Rational>,
        scheme: MeshScheme,
        tolerance: &Rational,
        arguments: &DepthArguments,
        refused: impl Fn(MeshError) -> Failure,
    ) -> Result<Search, Failure> {
        let work = Arc::<MeshWork>::default();
        let surface = match arguments.faces {
            FacesArgument::Bilinear => FaceSurface::Bilinear,
            FacesArgument::Fan => FaceSurface::Fan,
        };
        let search = || {
            let distances = MeshDistances::new(mesh.clone(), scheme)?.with_work(Arc::clone(&work));
            let found = distances.geometric_depth(tolerance, surface)?;
            let faces = match found.level.filter(|_| asks_for_faces(arguments)) {
                None => None,
                Some(level) => {
                    let depths = distances.geometric_faces(tolerance, surface)?;
                    let bounds = distances.geometric_distances(level, tolerance, surface)?;
                    Some(Faces::new(depths, bounds, level, tolerance))
                }
            };
            Ok(Search { surface, growth: Growth::of(scheme), found, faces })
        };
        let (found, stopped) = searched(&work, arguments, || search().map_err(refused))?;
        Ok(found.ended(stopped))
    }
}

/// Whether the distances of all faces are needed.
pub(super) fn asks_for_faces(arguments: &DepthArguments) -> bool {
    arguments.per_face.is_some() || arguments.output.is_page()
}
