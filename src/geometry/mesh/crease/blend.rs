//! Which rule makes the new point of an edge or of a vertex.

use super::super::connectivity::Connectivity;
use super::super::star::Star;
use super::sharpness::Sharpness;
use super::tags::{Creasing, Tags};
use crate::exact::Rational;

/// A rule for the new point of a vertex v.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum VertexMask {
    /// The rule of the scheme for an inner vertex: with no sharp edge, or one (a dart).
    Smooth,
    /// (1, 6, 1)/8 of v and the other ends of its two sharp edges: the cubic B-spline.
    Crease([usize; 2]),
    /// v stays where it is.
    Corner,
}

/// The rule of a vertex: w times one mask and 1 − w times another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VertexBlend {
    /// The mask by the sharpness now.
    pub now: VertexMask,
    /// The mask by the sharpness at the next level, and 1 − w, if the two masks differ.
    pub next: Option<(VertexMask, Rational)>,
}

impl Tags {
    /// The mask of a vertex by its own sharpness and that of its edges, in the order of the star.
    fn mask<'a>(
        own: Option<&Sharpness>,
        edges: impl Iterator<Item = Option<&'a Sharpness>>,
        star: &Star,
    ) -> VertexMask {
        let sharp: Vec<usize> =
            edges.zip(&star.neighbours).filter_map(|(edge, end)| edge.map(|_| *end)).collect();
        match (own, &sharp[..]) {
            (None, [] | [_]) => VertexMask::Smooth,
            (None, [first, second]) => VertexMask::Crease([*first, *second]),
            _ => VertexMask::Corner,
        }
    }

    /// The mask of a vertex by the sharpness at this level.
    #[must_use]
    pub fn vertex_mask(
        &self,
        connectivity: &Connectivity,
        vertex: usize,
        star: &Star,
    ) -> VertexMask {
        let edges = star.edges.iter().map(|&edge| self.edge(connectivity, edge));
        Tags::mask(self.vertex(vertex, star), edges, star)
    }

    /// How the new point of a vertex is made.
    ///
    /// DeRose, Kass and Truong 1998, as OpenSubdiv does it (`Sdc::Scheme::ComputeVertexVertexMask`):
    /// the mask at this level and the mask at the next are blended where they differ. The first
    /// has the weight w: the mean of the numbers that fall to 0 now, of edges and of the vertex, and 1
    /// at most.
    #[must_use]
    pub fn vertex_blend(
        &self,
        connectivity: &Connectivity,
        vertex: usize,
        star: &Star,
    ) -> VertexBlend {
        if !self.has_sharp() && !star.boundary {
            return VertexBlend { now: VertexMask::Smooth, next: None };
        }
        let now = self.vertex_mask(connectivity, vertex, star);
        if now == VertexMask::Smooth || !self.has_sharp() {
            return VertexBlend { now, next: None };
        }
        let own = self.vertex(vertex, star);
        let lowered = own.and_then(Sharpness::lowered);
        let edges = self.children(connectivity, star);
        let next = Tags::mask(lowered.as_ref(), edges.iter().map(Option::as_ref), star);
        if next == now {
            return VertexBlend { now, next: None };
        }
        let before = star.edges.iter().map(|&edge| self.edge(connectivity, edge)).chain([own]);
        let after = edges.iter().chain([&lowered]);
        let falls = before.zip(after).filter(|(_, after)| after.is_none());
        let falling: Vec<&Rational> =
            falls.filter_map(|(before, _)| before.and_then(Sharpness::finite)).collect();
        let sum = falling.iter().fold(Rational::zero(), |sum, one| &sum + *one);
        let weight = &sum / &Rational::from(falling.len().max(1));
        let rest = &Rational::one() - &weight;
        let next = (rest.sign() > 0).then_some((next, rest));
        VertexBlend { now, next }
    }

    /// The weight of the midpoint in the new point of an edge; the rest is the rule of the scheme for
    /// inner edges. It is 0 for a smooth edge; 1 where both halves are sharp at the next level; else the
    /// sharpness, and 1 at most.
    ///
    /// # Panics
    /// When there is no such edge.
    #[must_use]
    pub fn edge_weight(&self, connectivity: &Connectivity, edge: usize) -> Rational {
        let one = Rational::one();
        let Some(sharp) = self.edge(connectivity, edge) else { return Rational::zero() };
        let Some(own) = sharp.finite().filter(|own| **own < one) else { return one };
        if self.creasing == Creasing::Uniform {
            return own.clone();
        }
        let stays = |end: usize| {
            let star = connectivity.star(end);
            let place = star.edges.iter().position(|other| *other == edge);
            let children = self.children(connectivity, &star);
            place.is_some_and(|place| children[place].is_some())
        };
        if connectivity.edges()[edge].ends.into_iter().all(stays) { one } else { own.clone() }
    }
}
