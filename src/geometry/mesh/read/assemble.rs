//! From points and faces with their places to a mesh.

use super::super::MAX_POINTS;
use super::super::connectivity::Connectivity;
use super::super::crease::{Sharpness, Tags};
use super::super::error::MeshError;
use super::super::point::Point;
use super::super::polygon::PolygonMesh;
use super::super::texture::Texture;
use super::file::{MeshFile, Places};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::{Integer, Rational};
use std::ops::Range;
use std::sync::Arc;

/// The most binary digits of a numerator, and of the common denominator of all coordinates.
const MAX_BITS: u64 = 4_096;

/// The common denominator of all coordinates that have been read.
pub(crate) struct Denominator(Integer);

impl Denominator {
    pub(crate) fn new() -> Denominator {
        Denominator(Integer::one())
    }

    /// Takes in a point, which stands at a place.
    pub(crate) fn take(
        &mut self,
        point: &Point<Rational>,
        source: &Arc<SourceText>,
        place: &Range<usize>,
    ) -> Result<(), Diagnostic> {
        for x in point {
            self.0 = self.0.lcm(&x.denominator());
            if x.numerator().bits().max(self.0.bits()) > MAX_BITS {
                let message = format!(
                    "with this point a numerator or the common denominator of the coordinates has \
                     more than {MAX_BITS} binary digits"
                );
                return Err(Diagnostic::new(source, place.clone(), message)
                    .with_help("round the coordinates"));
            }
        }
        Ok(())
    }
}

/// The most vertices of all faces together.
pub(super) const MAX_CORNERS: usize = 4 * MAX_POINTS;

/// The points and faces that have been read so far.
pub(crate) struct Parts {
    pub(super) points: Vec<Point<Rational>>,
    pub(super) faces: Vec<Vec<usize>>,
    pub(super) places: Places,
    denominator: Denominator,
    corners: usize,
    /// What the file says besides points and faces.
    pub(crate) extras: Extras,
}

/// What a file says of a mesh besides points and faces.
#[derive(Default)]
pub(crate) struct Extras {
    pub(crate) tags: Vec<(Tag, Range<usize>)>,
    /// The rules at the boundary and of creasing; the tags come later.
    pub(crate) rules: Tags,
    /// Values of texture coordinates, and their places.
    pub(crate) texture: Vec<(Vec<Rational>, Range<usize>)>,
    /// For each face the values of its vertices, if it has some.
    pub(crate) textured: Vec<Option<Vec<usize>>>,
    /// How many triangles of strips have a vertex twice.
    pub(crate) joints: usize,
    /// The subdivision scheme that the file names.
    pub(crate) scheme: Option<String>,
    /// What a reader of the file should know.
    pub(crate) notes: Vec<String>,
}

/// A tag, by numbers from 0.
pub(crate) enum Tag {
    Crease([usize; 2], Option<Sharpness>),
    Corner(usize, Option<Sharpness>),
    Hole(usize),
}

impl Tag {
    fn put(&self, tags: &mut Tags, connectivity: &Connectivity) -> Result<(), MeshError> {
        match self {
            Tag::Crease(ends, sharp) => tags.crease(connectivity, *ends, sharp.clone()),
            Tag::Corner(vertex, sharp) => tags.corner(connectivity, *vertex, sharp.clone()),
            Tag::Hole(face) => tags.hole(connectivity, *face),
        }
    }
}

impl Parts {
    pub(crate) fn new(source: &Arc<SourceText>, base: usize) -> Parts {
        let source = Arc::clone(source);
        let places = Places { source, points: Vec::new(), faces: Vec::new(), base };
        let (points, faces, denominator) = (Vec::new(), Vec::new(), Denominator::new());
        Parts { points, faces, places, denominator, corners: 0, extras: Extras::default() }
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
        self.denominator.take(&point, &self.places.source, &place)?;
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

    /// Adds the triangles of a strip, which are turned in turn so that all are seen from the same side. A triangle that has
    /// a vertex twice only joins parts of the strip.
    pub(crate) fn strip(
        &mut self,
        vertices: &[usize],
        place: &Range<usize>,
    ) -> Result<(), Diagnostic> {
        for (i, triangle) in vertices.windows(3).enumerate() {
            let [a, b, c] = [triangle[0], triangle[1], triangle[2]];
            if a == b || b == c || a == c {
                self.extras.joints += 1;
            } else {
                self.face(if i % 2 == 0 { vec![a, b, c] } else { vec![b, a, c] }, place.clone())?;
            }
        }
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
    pub(crate) fn assemble(mut self) -> Result<MeshFile, Diagnostic> {
        let mut extras = std::mem::take(&mut self.extras);
        let isolated =
            if self.faces.is_empty() { Vec::new() } else { self.take_isolated(&mut extras) };
        let Parts { points, faces, places, .. } = self;
        let mesh = PolygonMesh::new(points, faces).map_err(|error| places.diagnostic(&error))?;
        let texture = extras.texture(&mesh, &places)?;
        let mut tags = std::mem::take(&mut extras.rules);
        for (tag, place) in &extras.tags {
            tag.put(&mut tags, mesh.connectivity()).map_err(|error| {
                // Tags count from 0, whatever the file calls its first point.
                let diagnostic = Diagnostic::new(&places.source, place.clone(), error.message(0));
                match error.help() {
                    Some(help) => diagnostic.with_help(help),
                    None => diagnostic,
                }
            })?;
        }
        let mesh = mesh.with_tags(tags).with_isolated(isolated).with_texture(texture);
        let mesh = mesh.map_err(|error| places.diagnostic(&error))?;
        if extras.joints > 0 {
            let count = extras.joints;
            let note = format!(
                "{count} triangles of strips have a vertex twice and are dropped: they join strips"
            );
            extras.notes.push(note);
        }
        Ok(MeshFile { mesh, places, notes: extras.notes, scheme: extras.scheme })
    }

    /// Takes out the points that no face has, with a note.
    fn take_isolated(&mut self, extras: &mut Extras) -> Vec<Point<Rational>> {
        let mut used = vec![false; self.points.len()];
        for point in self.faces.iter().flatten() {
            if let Some(used) = used.get_mut(*point) {
                *used = true;
            }
        }
        let loose: Vec<usize> = (0..used.len()).filter(|point| !used[*point]).collect();
        let Some(&first) = loose.first() else { return Vec::new() };
        // A vertex that does not exist is an error of its own, and its number must stay.
        if self.faces.iter().flatten().any(|point| *point >= used.len()) {
            return Vec::new();
        }
        let line = self.places.line(first);
        let base = self.places.base;
        let first = first + base;
        extras.notes.push(match loose.len() {
            1 => format!(
                "point {first} (line {line}) is a vertex of no face and gets no number; the points after \
                 it move up; points are counted from {base}"
            ),
            count => format!(
                "{count} points are vertices of no face and get no number, the first of them point \
                 {first} (line {line}); the points after them move up; points are counted from {base}"
            ),
        });
        let mut next = 0;
        let numbers: Vec<Option<usize>> = used
            .iter()
            .map(|used| {
                next += usize::from(*used);
                used.then(|| next - 1)
            })
            .collect();
        let number = |point: usize| numbers.get(point).copied().flatten().unwrap_or(usize::MAX);
        self.faces.iter_mut().flatten().for_each(|point| *point = number(*point));
        for (tag, _) in &mut extras.tags {
            match tag {
                Tag::Crease(ends, _) => *ends = ends.map(number),
                Tag::Corner(vertex, _) => *vertex = number(*vertex),
                Tag::Hole(_) => {}
            }
        }
        let isolated = loose.iter().map(|&point| self.points[point].clone()).collect();
        let mut keep = used.iter();
        self.points.retain(|_| keep.next() == Some(&true));
        let mut keep = used.iter();
        self.places.points.retain(|_| keep.next() == Some(&true));
        isolated
    }
}

impl Extras {
    /// The texture coordinates: of all faces, or of none.
    fn texture(
        &mut self,
        mesh: &PolygonMesh<Rational>,
        places: &Places,
    ) -> Result<Option<Texture>, Diagnostic> {
        let values = std::mem::take(&mut self.texture);
        let textured = std::mem::take(&mut self.textured);
        if textured.iter().all(Option::is_none) {
            if !values.is_empty() {
                let count = values.len();
                self.notes
                    .push(format!("{count} texture coordinates that no face has are dropped"));
            }
            return Ok(None);
        }
        let wrong = |face: usize, message: String, help: &str| {
            let place = places.faces[face].clone();
            Diagnostic::new(&places.source, place, message).with_help(help)
        };
        let mut faces = Vec::with_capacity(textured.len());
        for (face, own) in textured.into_iter().enumerate() {
            let Some(own) = own else {
                let help = "give texture coordinates to all faces, or to none";
                return Err(wrong(
                    face,
                    "a face without texture coordinates, which others have".to_owned(),
                    help,
                ));
            };
            if let Some(value) = own.iter().find(|value| **value >= values.len()) {
                let message = format!(
                    "texture coordinate {} does not exist: there are {}",
                    value + places.base,
                    values.len()
                );
                return Err(wrong(face, message, "is the file cut off, or is the number wrong?"));
            }
            faces.push(own);
        }
        let lengths = values.first().map(|(value, _)| value.len());
        if let Some((_, place)) = values.iter().find(|(value, _)| Some(value.len()) != lengths) {
            let message = "this texture coordinate has more or fewer numbers than the first";
            return Err(Diagnostic::new(&places.source, place.clone(), message)
                .with_help("write all of them with two numbers, or all with three"));
        }
        debug_assert_eq!(faces.len(), mesh.faces().len());
        let values = values.into_iter().map(|(value, _)| value).collect();
        Ok(Some(Texture { values, faces }))
    }
}
