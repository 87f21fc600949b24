//! Which faces, edges and vertices of a mesh meet.

use super::MAX_POINTS;
use super::error::MeshError;
use super::star::Star;
use crate::grouped::Grouped;

/// The room for the edges of a vertex that most have.
const USUAL: usize = 8;

/// An edge.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edge {
    /// Its ends, in the order in which its first face has them.
    pub ends: [usize; 2],
    /// Its first face, and which edge of that face it is: from vertex i to vertex i + 1.
    pub face: (usize, usize),
    /// Its other face, and which edge of that face it is; `None` at the boundary.
    pub other: Option<(usize, usize)>,
}

/// The faces of a mesh on the points 0, …, n−1, and what follows from them: an oriented
/// surface, with or without boundary, in one piece or several.
///
/// ```
/// use subcert::mesh::Connectivity;
///
/// // Two triangles of a square.
/// let square = Connectivity::new(4, vec![vec![0, 1, 2], vec![0, 2, 3]])?;
/// assert_eq!(square.edges().len(), 5);
/// let star = square.star(0);
/// assert_eq!((star.neighbours, star.faces, star.boundary), (vec![1, 2, 3], vec![0, 1], true));
/// assert!(Connectivity::new(4, vec![vec![0, 1, 2], vec![0, 3, 2], vec![0, 2, 1]]).is_err());
/// # Ok::<(), subcert::mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Connectivity {
    faces: Vec<Vec<usize>>,
    edges: Vec<Edge>,
    /// The edge from vertex i to vertex i + 1, for each face and i.
    face_edges: Vec<Vec<usize>>,
    /// For each point the first face of its fan, and which vertex of this face the point is.
    starts: Vec<(usize, usize)>,
}

impl Connectivity {
    /// The surface of these faces, each with its vertices counter-clockwise.
    ///
    /// # Errors
    /// When there is no face, or there are more than [`MAX_POINTS`] points; when a face is
    /// degenerate or has a vertex that does not exist; when an edge has three faces, or two of
    /// opposite orientation; when the faces of a vertex are not one disc or one fan; when a
    /// point is in no face.
    pub fn new(points: usize, faces: Vec<Vec<usize>>) -> Result<Connectivity, MeshError> {
        if points > MAX_POINTS {
            return Err(MeshError::TooManyPoints { points });
        }
        if faces.is_empty() {
            return Err(MeshError::Empty);
        }
        for (face, vertices) in faces.iter().enumerate() {
            check_face(face, vertices, points)?;
        }
        let (edges, face_edges) = edges(points, &faces)?;
        let starts = vec![(usize::MAX, 0); points];
        let mut connectivity = Connectivity { faces, edges, face_edges, starts };
        connectivity.find_starts()?;
        Ok(connectivity)
    }

    /// The faces, each with its vertices counter-clockwise.
    #[must_use]
    pub fn faces(&self) -> &[Vec<usize>] {
        &self.faces
    }

    /// The edges, in the order in which the faces have them first.
    #[must_use]
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// The edges of a face: edge i is from its vertex i to its vertex i + 1.
    ///
    /// # Panics
    /// When there is no such face.
    #[must_use]
    pub fn face_edges(&self, face: usize) -> &[usize] {
        &self.face_edges[face]
    }

    /// The number of points.
    #[must_use]
    pub fn point_count(&self) -> usize {
        self.starts.len()
    }

    /// The number of vertices of all faces together.
    #[must_use]
    pub fn corner_count(&self) -> usize {
        self.faces.iter().map(Vec::len).sum()
    }

    /// The faces around a point, counter-clockwise.
    ///
    /// # Panics
    /// When there is no such point.
    #[must_use]
    pub fn star(&self, point: usize) -> Star {
        let start = self.starts[point];
        let room = || Vec::with_capacity(USUAL);
        let mut star = Star {
            neighbours: room(),
            edges: room(),
            faces: room(),
            corners: room(),
            boundary: false,
        };
        let mut at = start;
        loop {
            let (face, corner) = at;
            let vertices = &self.faces[face];
            star.neighbours.push(vertices[(corner + 1) % vertices.len()]);
            star.edges.push(self.face_edges[face][corner]);
            star.faces.push(face);
            star.corners.push(corner);
            match self.next(at) {
                Some(next) if next == start => return star,
                Some(next) => at = next,
                None => {
                    let before = (corner + vertices.len() - 1) % vertices.len();
                    star.neighbours.push(vertices[before]);
                    star.edges.push(self.face_edges[face][before]);
                    star.boundary = true;
                    return star;
                }
            }
        }
    }

    /// The next face around a vertex of a face, counter-clockwise, and which of its vertices that is.
    pub(crate) fn next(&self, (face, corner): (usize, usize)) -> Option<(usize, usize)> {
        let count = self.faces[face].len();
        self.across(face, (corner + count - 1) % count)
    }

    /// The next face clockwise.
    fn before(&self, (face, corner): (usize, usize)) -> Option<(usize, usize)> {
        let (other, edge) = self.across(face, corner)?;
        Some((other, (edge + 1) % self.faces[other].len()))
    }

    /// The other face at edge i of a face, and which edge of that face it is.
    fn across(&self, face: usize, i: usize) -> Option<(usize, usize)> {
        let edge = &self.edges[self.face_edges[face][i]];
        if edge.face == (face, i) { edge.other } else { Some(edge.face) }
    }

    /// Finds the first face of each point, and checks that its fan has all faces of the point.
    fn find_starts(&mut self) -> Result<(), MeshError> {
        let mut counts = vec![0_usize; self.starts.len()];
        for (face, vertices) in self.faces.iter().enumerate() {
            for (corner, &point) in vertices.iter().enumerate() {
                counts[point] += 1;
                if self.starts[point].0 == usize::MAX {
                    self.starts[point] = (face, corner);
                }
            }
        }
        for (point, count) in counts.into_iter().enumerate() {
            if count == 0 {
                return Err(MeshError::Isolated { point });
            }
            let first = self.starts[point];
            let mut at = first;
            while let Some(before) = self.before(at) {
                at = before;
                if at == first {
                    break;
                }
            }
            self.starts[point] = at;
            let fan =
                std::iter::successors(Some(at), |met| self.next(*met).filter(|next| *next != at));
            if fan.count() != count {
                return Err(self.loose_face(point, &self.star(point)));
            }
        }
        Ok(())
    }

    /// A face at the point that is not in the star.
    fn loose_face(&self, point: usize, star: &Star) -> MeshError {
        let loose = |face: &usize| self.faces[*face].contains(&point) && !star.faces.contains(face);
        let face = (0..self.faces.len()).find(loose).unwrap_or(0);
        MeshError::NonManifoldVertex { point, face }
    }
}

fn check_face(face: usize, vertices: &[usize], points: usize) -> Result<(), MeshError> {
    if vertices.len() < 3 {
        return Err(MeshError::FewVertices { face, count: vertices.len() });
    }
    if let Some(&point) = vertices.iter().find(|point| **point >= points) {
        return Err(MeshError::NoPoint { face, point, count: points });
    }
    // Triangles, of which meshes have most, need no list.
    let twice = if let [a, b, c] = vertices {
        [(a, b), (b, c), (a, c)].into_iter().find(|(x, y)| x == y).map(|(x, _)| *x)
    } else {
        let mut sorted = vertices.to_vec();
        sorted.sort_unstable();
        sorted.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
    };
    twice.map_or(Ok(()), |point| Err(MeshError::Twice { face, point }))
}

/// All edges, and for each face its edges.
fn edges(points: usize, faces: &[Vec<usize>]) -> Result<(Vec<Edge>, Vec<Vec<usize>>), MeshError> {
    let first = first_meetings(points, faces);
    let mut edges: Vec<Edge> = Vec::with_capacity(first.len() / 2 + 1);
    let mut numbers = vec![0; first.len()];
    let mut face_edges = Vec::with_capacity(faces.len());
    let mut half = 0;
    for (face, vertices) in faces.iter().enumerate() {
        let mut own = Vec::with_capacity(vertices.len());
        for (i, &from) in vertices.iter().enumerate() {
            let to = vertices[(i + 1) % vertices.len()];
            if first[half] == half {
                numbers[half] = edges.len();
                edges.push(Edge { ends: [from, to], face: (face, i), other: None });
            } else {
                let (ends, edge) = ([from, to], &mut edges[numbers[first[half]]]);
                let first = edge.face.0;
                let met = [Some(first), edge.other.map(|(other, _)| other)];
                if edge.other.is_some() || edge.ends == ends {
                    let same = |other: &usize| same_face(&faces[*other], vertices);
                    if let Some(first) = met.into_iter().flatten().find(same) {
                        return Err(MeshError::SameFace { face, first });
                    }
                }
                if edge.other.is_some() {
                    return Err(MeshError::NonManifoldEdge { ends, face, first });
                }
                if edge.ends == ends {
                    return Err(MeshError::Orientation { ends, face, first });
                }
                edge.other = Some((face, i));
            }
            own.push(numbers[first[half]]);
            half += 1;
        }
        face_edges.push(own);
    }
    Ok((edges, face_edges))
}

/// Whether two faces have the same vertices in the same order around, or in the opposite one.
fn same_face(one: &[usize], other: &[usize]) -> bool {
    let count = one.len();
    let start = other.iter().position(|vertex| Some(vertex) == one.first());
    let Some(start) = start.filter(|_| other.len() == count) else { return false };
    let same = |step: usize| (0..count).all(|i| one[i] == other[(start + step * i) % count]);
    same(1) || same(count - 1)
}

/// For each edge of each face, in this order, which of them has the same ends and is met first.
fn first_meetings(points: usize, faces: &[Vec<usize>]) -> Vec<usize> {
    let halves = faces.iter().flat_map(|face| {
        let next = face.iter().cycle().skip(1);
        face.iter().zip(next).map(|(&x, &y)| (x.min(y), x.max(y)))
    });
    // Each edge at its lesser end.
    let halves = halves.enumerate().map(|(half, (low, high))| (low, (high, half)));
    let mut grouped = Grouped::new(points, halves);
    let mut first = vec![0; grouped.len()];
    grouped.each_mut(|own| {
        own.sort_unstable();
        let mut met = (usize::MAX, 0);
        for &(high, half) in &*own {
            if high != met.0 {
                met = (high, half);
            }
            first[half] = met.1;
        }
    });
    first
}
