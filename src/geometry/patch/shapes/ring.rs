//! Which faces around the vertices of a face its limit depends on.

use crate::mesh::{Connectivity, Sharpness, Star, Tags, VertexMask};

/// Faces around a vertex in turn: all of them, or those between two sharp edges.
pub(super) struct Ring {
    /// The first one in the star.
    pub(super) start: usize,
    /// The place of the face itself, from the first one on.
    pub(super) position: usize,
    pub(crate) count: usize,
    /// Whether the first and the last one do not meet.
    pub(super) open: bool,
}

impl Ring {
    /// The faces, and which vertex of each the vertex is.
    pub(crate) fn faces<'a>(
        &self,
        star: &'a Star,
    ) -> impl Iterator<Item = (usize, usize)> + use<'a> {
        let (start, total) = (self.start, star.faces.len());
        (0..self.count).map(move |r| {
            let at = (start + r) % total;
            (star.faces[at], star.corners[at])
        })
    }
}

/// A vertex of a face.
pub(super) struct Corner {
    pub(super) vertex: usize,
    pub(super) star: Star,
    /// The place of the face in the star.
    own: usize,
    /// The infinitely sharp edges, where none at the vertex has a finite sharpness, nor the vertex itself.
    sharp: Option<Vec<usize>>,
    /// Whether the vertex stays where it is.
    pub(super) stays: bool,
}

impl Corner {
    fn new(connectivity: &Connectivity, tags: &Tags, face: usize, i: usize) -> Corner {
        let vertex = connectivity.faces()[face][i];
        let star = connectivity.star(vertex);
        let own = (0..star.faces.len())
            .find(|&r| star.faces[r] == face && star.corners[r] == i)
            .unwrap_or(0);
        if tags.is_plain() {
            let sharp = star.boundary.then(|| vec![0, star.faces.len()]);
            return Corner { vertex, star, own, sharp, stays: false };
        }
        let all: Vec<Option<&Sharpness>> =
            star.edges.iter().map(|&edge| tags.edge(connectivity, edge)).collect();
        let is_finite =
            |sharp: Option<&Sharpness>| sharp.is_some_and(|sharp| sharp.finite().is_some());
        let falls =
            all.iter().any(|sharp| is_finite(*sharp)) || is_finite(tags.vertex(vertex, &star));
        let sharp = (0..all.len()).filter(|&i| all[i].is_some());
        let sharp = (!falls).then(|| sharp.collect());
        let stays = tags.vertex_mask(connectivity, vertex, &star) == VertexMask::Corner;
        Corner { vertex, star, own, sharp, stays }
    }

    /// The faces between the sharp edges around the face, where the ring is cut there; else all.
    pub(super) fn ring(&self, is_cut: bool) -> Ring {
        let count = self.star.faces.len();
        let Some(sharp) = self.sharp.as_ref().filter(|_| is_cut) else {
            let (start, position) = if self.star.boundary { (0, self.own) } else { (self.own, 0) };
            return Ring { start, position, count, open: self.star.boundary };
        };
        let first = sharp.iter().rev().find(|place| **place <= self.own);
        let last = sharp.iter().find(|place| **place > self.own);
        let start = first.or(sharp.last()).copied().unwrap_or(0);
        let end = last.or(sharp.first()).copied().unwrap_or(0);
        let (to_own, to_end) = (self.own + count - start, end + count - start);
        // At the boundary both ends are places of the star, and nothing wraps around.
        let total = if end > start { end - start } else { to_end };
        Ring { start, position: to_own % count, count: total, open: true }
    }
}

/// The vertices of a face.
pub(super) struct Corners {
    pub(crate) all: Vec<Corner>,
    /// Whether only the faces between two sharp edges count at a vertex: two or more of its edges are infinitely sharp,
    /// nothing falls there, and the same holds at the other end of a sharp edge of the face.
    pub(super) is_cut: Vec<bool>,
}

impl Corners {
    pub(crate) fn new(connectivity: &Connectivity, tags: &Tags, face: usize) -> Corners {
        let count = connectivity.faces()[face].len();
        let all: Vec<Corner> =
            (0..count).map(|i| Corner::new(connectivity, tags, face, i)).collect();
        let cut = |corner: &Corner| corner.sharp.as_ref().is_some_and(|sharp| sharp.len() >= 2);
        let mut is_cut: Vec<bool> = all.iter().map(cut).collect();
        if tags.has_sharp() {
            let edges = connectivity.face_edges(face);
            let inner = |&i: &usize| {
                connectivity.edges()[edges[i]].other.is_some()
                    && tags.edge(connectivity, edges[i]).is_some()
            };
            let creases: Vec<usize> = (0..count).filter(inner).collect();
            // A crease that is not cut at one end is not cut at the other one.
            for _ in 0..count {
                for &i in &creases {
                    let next = (i + 1) % count;
                    let both = is_cut[i] && is_cut[next];
                    (is_cut[i], is_cut[next]) = (both, both);
                }
            }
        }
        Corners { all, is_cut }
    }
}
