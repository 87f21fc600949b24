//! A piece of a surface with the faces around it.

use crate::mesh::{Connectivity, Star};

/// A piece of the surface of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Piece {
    /// A face.
    Face(usize),
    /// The quarters of the faces around an inner vertex, one of which is the first.
    Vertex(usize, usize),
}

/// A piece with all faces that share a vertex with it, unfolded: faces that meet only far away
/// from the piece do not meet here.
pub(super) struct Neighbourhood {
    /// The numbers of the points in the mesh. Those of the piece come first: the vertices of the
    /// face, or the vertex.
    pub(super) points: Vec<usize>,
    /// The faces on these points; the first one is the piece, or the first around the vertex.
    pub(super) faces: Vec<Vec<usize>>,
    /// What the shape depends on: boundary, order, and the numbers of vertices of the faces.
    pub(super) key: Vec<u32>,
}

/// What is known of a face that is met around a vertex: its place in the list, and which of its
/// vertices this is.
type Met = (usize, usize);

struct Unfolding<'a> {
    connectivity: &'a Connectivity,
    /// The faces, and the number of the first of their corners.
    slots: Vec<(usize, usize)>,
    /// Which corners are one point.
    parents: Vec<usize>,
}

impl Neighbourhood {
    pub(super) fn of(connectivity: &Connectivity, piece: Piece) -> Neighbourhood {
        let mut unfolding = Unfolding { connectivity, slots: Vec::new(), parents: Vec::new() };
        let mut key = Vec::new();
        let rings = match piece {
            Piece::Face(face) => unfolding.around_face(face, &mut key),
            Piece::Vertex(vertex, first) => vec![unfolding.around_vertex(vertex, first, &mut key)],
        };
        unfolding.numbered(piece, &rings, key)
    }
}

impl Unfolding<'_> {
    fn add(&mut self, face: usize) -> usize {
        let first = self.parents.len();
        self.parents.extend(first..first + self.connectivity.faces()[face].len());
        self.slots.push((face, first));
        self.slots.len() - 1
    }

    /// The corner of a face, `turn` places after the given one.
    fn corner(&self, (slot, corner): Met, turn: usize) -> usize {
        let (face, first) = self.slots[slot];
        first + (corner + turn) % self.connectivity.faces()[face].len()
    }

    fn before(&self, met: Met) -> usize {
        self.corner(met, self.connectivity.faces()[self.slots[met.0].0].len() - 1)
    }

    fn root(&self, mut corner: usize) -> usize {
        while self.parents[corner] != corner {
            corner = self.parents[corner];
        }
        corner
    }

    fn join(&mut self, left: usize, right: usize) {
        let (left, right) = (self.root(left), self.root(right));
        self.parents[left.max(right)] = left.min(right);
    }

    /// Makes the faces of a ring share the vertex, and neighbours an edge.
    fn glue(&mut self, ring: &[Met], closed: bool) {
        for (i, &met) in ring.iter().enumerate() {
            self.join(self.corner(ring[0], 0), self.corner(met, 0));
            let next = match ring.get(i + 1) {
                Some(&next) => next,
                None if closed => ring[0],
                None => break,
            };
            self.join(self.before(met), self.corner(next, 1));
        }
    }

    fn describe(&self, ring: &[Met], boundary: bool, position: usize, key: &mut Vec<u32>) {
        let number = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        key.extend([u32::from(boundary), number(position), number(ring.len())]);
        key.extend(
            ring.iter()
                .map(|&(slot, _)| number(self.connectivity.faces()[self.slots[slot].0].len())),
        );
    }

    fn around_vertex(&mut self, vertex: usize, first: usize, key: &mut Vec<u32>) -> Vec<Met> {
        let star = self.connectivity.star(vertex);
        let start = star.faces.iter().position(|&face| face == first).unwrap_or(0);
        let ring: Vec<Met> =
            turned(&star, start).map(|(face, corner)| (self.add(face), corner)).collect();
        self.glue(&ring, true);
        self.describe(&ring, false, 0, key);
        ring
    }

    fn around_face(&mut self, face: usize, key: &mut Vec<u32>) -> Vec<Vec<Met>> {
        let cell = self.add(face);
        let vertices = &self.connectivity.faces()[face];
        let count = vertices.len();
        // The faces at the edges of the face, which two of its vertices have.
        let mut sides: Vec<Option<usize>> = vec![None; count];
        let mut rings = Vec::with_capacity(count);
        for (i, &vertex) in vertices.iter().enumerate() {
            let star = self.connectivity.star(vertex);
            let own = (0..star.faces.len())
                .find(|&r| star.faces[r] == face && star.corners[r] == i)
                .unwrap_or(0);
            let (start, position) = if star.boundary { (0, own) } else { (own, 0) };
            let total = star.faces.len();
            let mut ring = Vec::with_capacity(total);
            for (r, (other, corner)) in turned(&star, start).enumerate() {
                let after = r == position + 1;
                let before = if star.boundary { r + 1 == position } else { r + 1 == total };
                let slot = if r == position {
                    cell
                } else if after {
                    let side = (i + count - 1) % count;
                    self.side(&mut sides, side, other)
                } else if before {
                    self.side(&mut sides, i, other)
                } else {
                    self.add(other)
                };
                ring.push((slot, corner));
            }
            self.glue(&ring, !star.boundary);
            self.describe(&ring, star.boundary, position, key);
            // From the face itself on, so that equal shapes have equal numbers.
            ring.rotate_left(position);
            rings.push(ring);
        }
        rings
    }

    fn side(&mut self, sides: &mut [Option<usize>], side: usize, face: usize) -> usize {
        let known = sides[side];
        let slot = known.unwrap_or_else(|| self.add(face));
        sides[side] = Some(slot);
        slot
    }

    fn numbered(self, piece: Piece, rings: &[Vec<Met>], key: Vec<u32>) -> Neighbourhood {
        let mut numbers = vec![usize::MAX; self.parents.len()];
        let mut points = Vec::new();
        let mut number = |slot: usize, k: usize| {
            let (face, first) = self.slots[slot];
            let root = self.root(first + k);
            if numbers[root] == usize::MAX {
                numbers[root] = points.len();
                points.push(self.connectivity.faces()[face][k]);
            }
            numbers[root]
        };
        if let Piece::Face(face) = piece {
            for k in 0..self.connectivity.faces()[face].len() {
                number(0, k);
            }
        }
        for &(slot, corner) in rings.iter().flatten() {
            let count = self.connectivity.faces()[self.slots[slot].0].len();
            for turn in 0..count {
                number(slot, (corner + turn) % count);
            }
        }
        let mut order: Vec<Met> = Vec::new();
        for &met in rings.iter().flatten() {
            if order.iter().all(|known| known.0 != met.0) {
                order.push(met);
            }
        }
        let mut faces = Vec::with_capacity(order.len());
        for (slot, corner) in order {
            let count = self.connectivity.faces()[self.slots[slot].0].len();
            faces.push((0..count).map(|turn| number(slot, (corner + turn) % count)).collect());
        }
        Neighbourhood { points, faces, key }
    }
}

/// The faces around a vertex and its corner in them, from one of them on.
fn turned(star: &Star, start: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
    let count = star.faces.len();
    (0..count).map(move |r| {
        let at = (start + r) % count;
        (star.faces[at], star.corners[at])
    })
}
