//! Texture coordinates: values at the vertices of faces, which differ from face to face along
//! seams.

use super::error::MeshError;
use crate::exact::Rational;
use std::collections::HashMap;

/// Values of two coordinates or three, and which of them each vertex of each face has.
///
/// They are refined linearly on each face, which OpenSubdiv calls face-varying interpolation
/// `linear all`: a vertex of a face keeps its value, an edge of a face has the mean of its two ends,
/// and the middle of a face has the mean of all.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Texture {
    /// The values, u and v, or u, v and w.
    pub values: Vec<Vec<Rational>>,
    /// For each face the number of the value at each of its vertices.
    pub faces: Vec<Vec<usize>>,
}

/// Values under construction: each mean is made once.
struct Means {
    values: Vec<Vec<Rational>>,
    known: HashMap<[usize; 2], usize>,
}

impl Means {
    fn of(values: &[Vec<Rational>]) -> Means {
        Means { values: values.to_vec(), known: HashMap::new() }
    }

    /// The middle of two values.
    fn edge(&mut self, from: usize, to: usize) -> usize {
        let key = [from.min(to), from.max(to)];
        if let Some(&index) = self.known.get(&key) {
            return index;
        }
        let mean = self.mean(&key);
        self.known.insert(key, mean);
        mean
    }

    fn mean(&mut self, all: &[usize]) -> usize {
        let share = Rational::new(1, all.len());
        let length = self.values[all[0]].len();
        let sum =
            |x: usize| all.iter().fold(Rational::zero(), |sum, &one| &sum + &self.values[one][x]);
        let mean = (0..length).map(|x| &sum(x) * &share).collect();
        self.values.push(mean);
        self.values.len() - 1
    }
}

impl Texture {
    /// Checks that every vertex of every face has a value, and that all values have as many
    /// coordinates.
    pub(super) fn check(&self, faces: &[Vec<usize>]) -> Result<(), MeshError> {
        let wrong = |reason: &str| Err(MeshError::Attribute { reason: reason.to_owned() });
        let sizes = |faces: &[Vec<usize>]| faces.iter().map(Vec::len).collect::<Vec<usize>>();
        if sizes(&self.faces) != sizes(faces) {
            return wrong("texture coordinates are for other faces than those of the mesh");
        }
        if self.faces.iter().flatten().any(|value| *value >= self.values.len()) {
            return wrong("a texture coordinate does not exist");
        }
        let length = self.values.first().map_or(0, Vec::len);
        if self.values.iter().any(|value| value.len() != length) {
            return wrong("texture coordinates of two numbers and of three");
        }
        Ok(())
    }

    /// One level of Catmull–Clark: a quadrilateral at each vertex of each face.
    pub(super) fn quadrilaterals(&self) -> Texture {
        let mut means = Means::of(&self.values);
        let mut faces = Vec::new();
        for own in &self.faces {
            let (count, centre) = (own.len(), means.mean(own));
            let edges: Vec<usize> =
                (0..count).map(|i| means.edge(own[i], own[(i + 1) % count])).collect();
            faces.extend(
                (0..count).map(|i| vec![own[i], edges[i], centre, edges[(i + count - 1) % count]]),
            );
        }
        Texture { values: means.values, faces }
    }

    /// One level of Loop: four triangles for each.
    pub(super) fn triangles(&self) -> Texture {
        let mut means = Means::of(&self.values);
        let mut faces = Vec::new();
        for own in &self.faces {
            let edges: Vec<usize> = (0..3).map(|i| means.edge(own[i], own[(i + 1) % 3])).collect();
            faces.extend((0..3).map(|i| vec![own[i], edges[i], edges[(i + 2) % 3]]));
            faces.push(edges);
        }
        Texture { values: means.values, faces }
    }
}
