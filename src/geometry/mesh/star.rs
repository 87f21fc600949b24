//! The faces around a vertex.

/// The faces around a vertex v, counter-clockwise.
///
/// Inside the surface face i lies between the neighbours i and i + 1, counted modulo n, and
/// there are n of both. At the boundary there are n faces and n + 1 neighbours, the first and the
/// last of which are the ends of the two boundary edges at v.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Star {
    /// The other ends of the edges at v.
    pub neighbours: Vec<usize>,
    /// The edges at v.
    pub edges: Vec<usize>,
    /// The faces.
    pub faces: Vec<usize>,
    /// Which vertex of each face v is.
    pub corners: Vec<usize>,
    /// Whether v is at the boundary.
    pub boundary: bool,
}

impl Star {
    /// The number of edges at v.
    #[must_use]
    pub fn valence(&self) -> usize {
        self.edges.len()
    }

    /// The other ends of the two boundary edges at v: the first and the last neighbour.
    ///
    /// # Panics
    /// Never: a face at v has two edges there.
    pub(super) fn boundary_neighbours(&self) -> [usize; 2] {
        [self.neighbours[0], self.neighbours[self.neighbours.len() - 1]]
    }
}
