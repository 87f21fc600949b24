//! From points and faces with their places to a mesh.

use super::super::MAX_POINTS;
use super::super::point::Point;
use super::super::polygon::PolygonMesh;
use super::{MeshFile, Places};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::{Integer, Rational};
use std::ops::Range;
use std::sync::Arc;

/// The most binary digits of a numerator, and of the common denominator of all coordinates.
const MAX_BITS: u64 = 4_096;

/// The most vertices of all faces together.
const MAX_CORNERS: usize = 4 * MAX_POINTS;

/// The points and faces that have been read so far.
pub(crate) struct Parts {
    points: Vec<Point<Rational>>,
    faces: Vec<Vec<usize>>,
    places: Places,
    denominator: Integer,
    corners: usize,
}

impl Parts {
    pub(crate) fn new(source: &Arc<SourceText>, base: usize) -> Parts {
        let source = Arc::clone(source);
        let places = Places { source, points: Vec::new(), faces: Vec::new(), base };
        let (points, faces, denominator) = (Vec::new(), Vec::new(), Integer::one());
        Parts { points, faces, places, denominator, corners: 0 }
    }

    pub(crate) fn point_count(&self) -> usize {
        self.points.len()
    }

    pub(crate) fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// Adds a point.
    pub(crate) fn point(
        &mut self,
        point: Point<Rational>,
        place: Range<usize>,
    ) -> Result<(), Diagnostic> {
        if self.points.len() == MAX_POINTS {
            return Err(self.too_many(place, "points", MAX_POINTS));
        }
        for x in &point {
            self.denominator = self.denominator.lcm(&x.denominator());
            if x.numerator().bits().max(self.denominator.bits()) > MAX_BITS {
                let message = format!(
                    "with this point a numerator or the common denominator of the coordinates has \
                     more than {MAX_BITS} binary digits"
                );
                return Err(Diagnostic::new(&self.places.source, place, message)
                    .with_help("round the coordinates"));
            }
        }
        self.points.push(point);
        self.places.points.push(place);
        Ok(())
    }

    /// Adds a face.
    pub(crate) fn face(
        &mut self,
        vertices: Vec<usize>,
        place: Range<usize>,
    ) -> Result<(), Diagnostic> {
        self.corners += vertices.len();
        if self.corners > MAX_CORNERS {
            return Err(self.too_many(place, "vertices of faces", MAX_CORNERS));
        }
        self.faces.push(vertices);
        self.places.faces.push(place);
        Ok(())
    }

    fn too_many(&self, place: Range<usize>, what: &str, most: usize) -> Diagnostic {
        let message = format!("more than {most} {what}; take a smaller mesh");
        Diagnostic::new(&self.places.source, place, message)
    }

    /// Points and faces as they are, with their places.
    pub(crate) fn into_lists(self) -> (Vec<Point<Rational>>, Vec<Vec<usize>>, Places) {
        (self.points, self.faces, self.places)
    }

    /// The mesh of these points and faces; an error with its place if they are none.
    pub(crate) fn assemble(self) -> Result<MeshFile, Diagnostic> {
        match PolygonMesh::new(self.points, self.faces) {
            Ok(mesh) => Ok(MeshFile { mesh, places: self.places }),
            Err(error) => Err(self.places.diagnostic(&error)),
        }
    }
}
