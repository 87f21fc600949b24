//! A piece of a surface with the faces around it.

use super::ring::{Corner, Corners, Ring};
use crate::exact::Rational;
use crate::mesh::{Connectivity, Creasing, Sharpness, Tags};
use crate::patch::number::index;
use std::collections::BTreeMap;

/// A piece of the surface of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Piece {
    /// A face.
    Face(usize),
    /// The quarters of the faces around an inner vertex, one of which is the first.
    Vertex(usize, usize),
}

/// A piece with all faces that share a vertex with it and that its limit depends on, unfolded: faces that meet only far
/// away from the piece do not meet here, and faces beyond an infinitely sharp crease are left out, so that the crease is
/// a boundary (`proofs/THEOREMS.md`, 169).
pub(crate) struct Neighbourhood {
    /// The numbers of the points in the mesh. Those of the piece come first: the vertices of the
    /// face, or the vertex.
    pub(crate) points: Vec<usize>,
    /// The faces on these points; the first one is the piece, or the first around the vertex.
    pub(crate) faces: Vec<Vec<usize>>,
    /// What is sharp besides the boundary.
    pub(crate) sharp: Sharp,
    /// What the shape depends on: boundary, order, the numbers of vertices of the faces, and what is sharp.
    pub(crate) key: Vec<u32>,
}

/// What is sharp at the vertices of a piece besides the boundary of its neighbourhood, by the numbers there.
#[derive(Default)]
pub(crate) struct Sharp {
    creasing: Creasing,
    points: Vec<(usize, Sharpness)>,
    edges: Vec<([usize; 2], Sharpness)>,
    /// Where sharpness falls by Chaikin's rule, that of the other edges at the other end of an edge.
    others: Vec<(usize, Vec<Rational>)>,
}

impl Sharp {
    /// The same as tags of the neighbourhood.
    ///
    /// # Panics
    /// Never: its edges are edges there.
    pub(super) fn tags(&self, connectivity: &Connectivity) -> Tags {
        let mut tags = Tags::default();
        tags.creasing = self.creasing;
        for (point, sharp) in &self.points {
            tags.corner(connectivity, *point, Some(sharp.clone())).expect("a vertex");
        }
        for (ends, sharp) in &self.edges {
            tags.crease(connectivity, *ends, Some(sharp.clone())).expect("an edge");
        }
        for (point, others) in &self.others {
            tags.set_others(*point, others.clone());
        }
        tags
    }
}

/// What is known of a face that is met around a vertex: its place in the list, and which of its
/// vertices this is.
type Met = (usize, usize);

struct Unfolding<'a> {
    connectivity: &'a Connectivity,
    tags: &'a Tags,
    /// The faces, and the number of the first of their corners.
    slots: Vec<(usize, usize)>,
    /// Which corners are one point.
    parents: Vec<usize>,
    /// Sharp vertices by a corner, and sharp edges by the corners at their ends.
    sharp_points: Vec<(usize, Sharpness)>,
    sharp_edges: Vec<([usize; 2], usize)>,
}

impl Neighbourhood {
    pub(crate) fn of(connectivity: &Connectivity, tags: &Tags, piece: Piece) -> Neighbourhood {
        let mut unfolding = Unfolding {
            connectivity,
            tags,
            slots: Vec::new(),
            parents: Vec::new(),
            sharp_points: Vec::new(),
            sharp_edges: Vec::new(),
        };
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

    fn describe(&self, ring: &[Met], open: bool, position: usize, key: &mut Vec<u32>) {
        key.extend([u32::from(open), index(position), index(ring.len())]);
        key.extend(
            ring.iter()
                .map(|&(slot, _)| index(self.connectivity.faces()[self.slots[slot].0].len())),
        );
    }

    fn around_vertex(&mut self, vertex: usize, first: usize, key: &mut Vec<u32>) -> Vec<Met> {
        let star = self.connectivity.star(vertex);
        let start = star.faces.iter().position(|&face| face == first).unwrap_or(0);
        let ring = Ring { start, position: 0, count: star.faces.len(), open: false };
        let ring: Vec<Met> =
            ring.faces(&star).map(|(face, corner)| (self.add(face), corner)).collect();
        self.glue(&ring, true);
        self.describe(&ring, false, 0, key);
        ring
    }

    fn around_face(&mut self, face: usize, key: &mut Vec<u32>) -> Vec<Vec<Met>> {
        let cell = self.add(face);
        let corners = Corners::new(self.connectivity, self.tags, face);
        let count = corners.all.len();
        // The faces at the edges of the face, which two of its vertices have.
        let mut sides: Vec<Option<usize>> = vec![None; count];
        let mut rings = Vec::with_capacity(count);
        for (i, corner) in corners.all.iter().enumerate() {
            let around = corner.ring(corners.is_cut[i]);
            let (position, total) = (around.position, around.count);
            let mut ring = Vec::with_capacity(total);
            for (r, (other, at)) in around.faces(&corner.star).enumerate() {
                let after = r == position + 1;
                let before = if around.open { r + 1 == position } else { r + 1 == total };
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
                ring.push((slot, at));
            }
            self.glue(&ring, !around.open);
            self.describe(&ring, around.open, position, key);
            self.note_sharp(corner, corners.is_cut[i], &ring, &around, key);
            // From the face itself on, so that equal shapes have equal numbers.
            ring.rotate_left(position);
            rings.push(ring);
        }
        rings
    }

    /// Notes what is sharp at a vertex besides the boundary of its ring.
    fn note_sharp(
        &mut self,
        corner: &Corner,
        is_cut: bool,
        ring: &[Met],
        around: &Ring,
        key: &mut Vec<u32>,
    ) {
        if self.tags.is_plain() {
            return;
        }
        let own = if is_cut {
            corner.stays.then_some(Sharpness::Infinite)
        } else {
            self.tags.vertex(corner.vertex, &corner.star).cloned()
        };
        encode(own.as_ref(), key);
        self.sharp_points.extend(own.map(|own| (self.corner(ring[0], 0), own)));
        if is_cut {
            return;
        }
        // Edge r is before face r; what is first in an open ring is the boundary of the mesh.
        for (r, &met) in ring.iter().enumerate().skip(usize::from(around.open)) {
            let place = (around.start + r) % corner.star.edges.len();
            let edge = corner.star.edges[place];
            let sharp = self.tags.edge(self.connectivity, edge);
            encode(sharp, key);
            let Some(sharp) = sharp else { continue };
            self.sharp_edges.push(([self.corner(met, 0), self.corner(met, 1)], edge));
            if self.tags.creasing == Creasing::Chaikin && sharp.finite().is_some() {
                let mut others = self.finite_at(corner.star.neighbours[place], &[edge]);
                others.sort();
                key.push(index(others.len()));
                for other in others {
                    encode(Some(&Sharpness::Finite(other)), key);
                }
            }
        }
    }

    /// The finite sharpness of the edges at a vertex other than these.
    fn finite_at(&self, vertex: usize, except: &[usize]) -> Vec<Rational> {
        let star = self.connectivity.star(vertex);
        let edges = star.edges.iter().filter(|edge| !except.contains(edge));
        let own = edges.filter_map(|&edge| self.tags.edge(self.connectivity, edge)?.finite());
        own.chain(self.tags.others(vertex)).cloned().collect()
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
        let sharp = self.numbered_sharp(piece, &points, |corner| numbers[self.root(corner)]);
        Neighbourhood { points, faces, sharp, key }
    }

    fn numbered_sharp(
        &self,
        piece: Piece,
        points: &[usize],
        number: impl Fn(usize) -> usize,
    ) -> Sharp {
        let mut sharp = Sharp { creasing: self.tags.creasing, ..Sharp::default() };
        sharp.points =
            self.sharp_points.iter().map(|(at, own)| (number(*at), own.clone())).collect();
        // The edges at a vertex that is not one of the piece.
        let mut outside: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        let inside = match piece {
            Piece::Face(face) => self.connectivity.faces()[face].len(),
            Piece::Vertex(..) => 1,
        };
        for (ends, edge) in &self.sharp_edges {
            let ends = ends.map(&number);
            let Some(own) = self.tags.edge(self.connectivity, *edge) else { continue };
            if self.tags.creasing == Creasing::Chaikin && own.finite().is_some() {
                for end in ends.into_iter().filter(|end| *end >= inside) {
                    outside.entry(end).or_default().push(*edge);
                }
            }
            sharp.edges.push((ends, own.clone()));
        }
        let others =
            outside.into_iter().map(|(end, edges)| (end, self.finite_at(points[end], &edges)));
        sharp.others = others.collect();
        sharp
    }
}

/// A sharpness as part of a key.
fn encode(sharp: Option<&Sharpness>, key: &mut Vec<u32>) {
    match sharp {
        None => key.push(0),
        Some(Sharpness::Infinite) => key.push(1),
        Some(Sharpness::Finite(value)) => {
            let digits = value.to_string();
            key.extend([2, index(digits.len())]);
            key.extend(digits.bytes().map(u32::from));
        }
    }
}
