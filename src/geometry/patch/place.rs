//! Places where a mesh is far from its limit, and whether there is one.

use crate::mesh::Point;

/// Where a mesh is far from its limit.
#[derive(Clone, Debug, PartialEq)]
pub struct FarPlace {
    /// The face of the control mesh; of a solid, the cell.
    pub face: usize,
    /// The vertex of that face whose part it is on; `None` for the middle triangle of a triangle.
    pub vertex: Option<usize>,
    /// The face of the level; `None` at level 0, where it is that of the control mesh, and for Doo and
    /// Sabin, and of a solid.
    pub level_face: Option<u128>,
    /// The point of the mesh of the level, to f64.
    pub on_mesh: Point<f64>,
    /// The point of the limit surface at the same parameter, to f64.
    pub on_limit: Point<f64>,
}

/// A place in a piece where the limit is far away.
#[derive(Clone, Debug)]
pub(crate) struct Place<A, V> {
    /// The level of the piece.
    pub(crate) level: u32,
    /// Where in the root it is.
    pub(crate) at: A,
    pub(crate) limit: V,
    pub(crate) polygon: V,
}

/// Whether a piece is within the tolerance.
pub(crate) enum Verdict<P> {
    Within,
    Beyond(P),
    /// Too near to call, or too much work.
    Open,
}

impl<P> Verdict<P> {
    /// The same with the place in other terms.
    pub(crate) fn map<Q>(self, map: impl Fn(P) -> Q) -> Verdict<Q> {
        match self {
            Verdict::Within => Verdict::Within,
            Verdict::Beyond(place) => Verdict::Beyond(map(place)),
            Verdict::Open => Verdict::Open,
        }
    }
}
