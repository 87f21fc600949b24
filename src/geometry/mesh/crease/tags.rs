//! What a mesh says of its edges, vertices and faces besides their points.

use super::super::connectivity::Connectivity;
use super::super::error::MeshError;
use super::super::star::Star;
use super::sharpness::Sharpness;
use crate::exact::Rational;
use std::collections::{BTreeMap, BTreeSet};

/// What the surface does at the boundary of the mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Boundary {
    /// Faces at the boundary are holes, but where all boundary edges at a vertex are infinitely sharp
    /// by themselves: the surface ends before the boundary.
    None,
    /// The cubic B-spline of the boundary polygon, which rounds corners.
    #[default]
    Edge,
    /// The same, with a corner at each vertex of one face.
    Corner,
}

impl Boundary {
    /// All ways, each with its name.
    pub const NAMES: [(Boundary, &str); 3] =
        [(Boundary::None, "none"), (Boundary::Edge, "edge"), (Boundary::Corner, "corner")];

    /// The name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Boundary::None => "none",
            Boundary::Edge => "edge",
            Boundary::Corner => "corner",
        }
    }
}

/// How the sharpness of an edge falls from one level to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Creasing {
    /// By 1.
    #[default]
    Uniform,
    /// At each end, to 3/4 of its own and 1/4 of the mean of the other sharp edges there, less 1. Only
    /// edges of finite sharpness count.
    Chaikin,
}

impl Creasing {
    /// The name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Creasing::Uniform => "uniform",
            Creasing::Chaikin => "chaikin",
        }
    }
}

/// Sharp edges and vertices, holes, and the rules at the boundary.
///
/// Edges at the boundary are infinitely sharp, whatever is said of them. A vertex is sharp by
/// itself, or by three sharp edges or more: it is a corner.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::mesh::{Connectivity, Sharpness, Tags};
///
/// let two = Connectivity::new(4, vec![vec![0, 1, 2], vec![0, 2, 3]])?;
/// let mut tags = Tags::default();
/// tags.crease(&two, [2, 0], Sharpness::new(&Rational::new(3, 2)))?;
/// assert_eq!(tags.edge(&two, 2).map(|sharp| sharp.to_string()), Some("3/2".to_owned()));
/// assert!(tags.crease(&two, [1, 3], None).is_err());
/// # Ok::<(), subcert::mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tags {
    /// The rules at the boundary.
    pub boundary: Boundary,
    /// How sharpness falls.
    pub creasing: Creasing,
    edges: BTreeMap<usize, Sharpness>,
    vertices: BTreeMap<usize, Sharpness>,
    holes: BTreeSet<usize>,
    others: BTreeMap<usize, Vec<Rational>>,
}

/// The sharpness of all boundary edges.
static AT_BOUNDARY: Sharpness = Sharpness::Infinite;

impl Tags {
    /// Whether nothing is said: no sharp edge or vertex, no hole, and a boundary of
    /// [`Boundary::Edge`].
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.boundary == Boundary::Edge && !self.has_sharp() && self.holes.is_empty()
    }

    /// Whether an edge or a vertex is sharp by itself.
    #[must_use]
    pub fn has_sharp(&self) -> bool {
        !self.edges.is_empty() || !self.vertices.is_empty()
    }

    /// Gives the edge between two vertices a sharpness; `None` makes it smooth.
    ///
    /// # Errors
    /// When there is no such vertex, or no such edge.
    pub fn crease(
        &mut self,
        connectivity: &Connectivity,
        ends: [usize; 2],
        sharpness: Option<Sharpness>,
    ) -> Result<(), MeshError> {
        let count = connectivity.point_count();
        if let Some(&vertex) = ends.iter().find(|end| **end >= count) {
            return Err(MeshError::NoVertex { vertex, count });
        }
        let star = connectivity.star(ends[0]);
        let place = star.neighbours.iter().position(|end| *end == ends[1]);
        let place = place.ok_or(MeshError::NoEdge { ends })?;
        self.set_edge(star.edges[place], sharpness);
        Ok(())
    }

    pub(crate) fn set_edge(&mut self, edge: usize, sharpness: Option<Sharpness>) {
        set(&mut self.edges, edge, sharpness);
    }

    /// Gives a vertex a sharpness; `None` makes it smooth.
    ///
    /// # Errors
    /// When there is no such vertex.
    pub fn corner(
        &mut self,
        connectivity: &Connectivity,
        vertex: usize,
        sharpness: Option<Sharpness>,
    ) -> Result<(), MeshError> {
        if vertex >= connectivity.point_count() {
            return Err(MeshError::NoVertex { vertex, count: connectivity.point_count() });
        }
        set(&mut self.vertices, vertex, sharpness);
        Ok(())
    }

    /// Makes a face a hole: it is refined, but is no part of the surface.
    ///
    /// # Errors
    /// When there is no such face.
    pub fn hole(&mut self, connectivity: &Connectivity, face: usize) -> Result<(), MeshError> {
        if face >= connectivity.faces().len() {
            return Err(MeshError::NoFace { face, count: connectivity.faces().len() });
        }
        self.holes.insert(face);
        Ok(())
    }

    /// The sharpness of an edge.
    ///
    /// # Panics
    /// When there is no such edge.
    #[must_use]
    pub fn edge(&self, connectivity: &Connectivity, edge: usize) -> Option<&Sharpness> {
        if connectivity.edges()[edge].other.is_none() {
            Some(&AT_BOUNDARY)
        } else {
            self.edges.get(&edge)
        }
    }

    /// The sharpness of a vertex with these faces: its own, or infinite at the only vertex of a face
    /// at a boundary of [`Boundary::Corner`].
    #[must_use]
    pub fn vertex(&self, vertex: usize, star: &Star) -> Option<&Sharpness> {
        if self.boundary == Boundary::Corner && star.boundary && star.faces.len() == 1 {
            Some(&AT_BOUNDARY)
        } else {
            self.vertices.get(&vertex)
        }
    }

    /// The edges of a sharpness of their own, by number.
    #[must_use]
    pub fn edges(&self) -> &BTreeMap<usize, Sharpness> {
        &self.edges
    }

    /// The vertices of a sharpness of their own.
    #[must_use]
    pub fn vertices(&self) -> &BTreeMap<usize, Sharpness> {
        &self.vertices
    }

    /// The faces that are holes: those that are said to be, and with [`Boundary::None`] those at a
    /// boundary vertex some boundary edge of which is not infinitely sharp by itself.
    #[must_use]
    pub fn holes(&self, connectivity: &Connectivity) -> BTreeSet<usize> {
        let faces = 0..connectivity.faces().len();
        faces.filter(|face| self.is_hole(connectivity, *face)).collect()
    }

    /// Whether a face is a hole.
    pub(crate) fn is_hole(&self, connectivity: &Connectivity, face: usize) -> bool {
        let opens = |&vertex: &usize| {
            let star = connectivity.star(vertex);
            let ends = [star.edges[0], star.edges[star.edges.len() - 1]];
            let own = |edge: &usize| self.edges.get(edge) == Some(&Sharpness::Infinite);
            star.boundary && !ends.iter().all(own)
        };
        let vertices = &connectivity.faces()[face];
        self.holes.contains(&face)
            || (self.boundary == Boundary::None && vertices.iter().any(opens))
    }

    /// Gives a vertex at the boundary of a part of a mesh the finite sharpness of the edges at it that the part does not
    /// have: Chaikin's rule takes the mean of all. It is not handed down to the next level.
    pub(crate) fn set_others(&mut self, vertex: usize, others: Vec<Rational>) {
        self.others.insert(vertex, others);
    }

    /// The finite sharpness of edges at a vertex that the mesh does not have.
    pub(crate) fn others(&self, vertex: usize) -> &[Rational] {
        self.others.get(&vertex).map_or(&[], Vec::as_slice)
    }

    /// The sharpness that each edge at a vertex has at the next level, next to that vertex.
    #[must_use]
    pub fn children(&self, connectivity: &Connectivity, star: &Star) -> Vec<Option<Sharpness>> {
        let own: Vec<_> = star.edges.iter().map(|&edge| self.edge(connectivity, edge)).collect();
        let vertex = connectivity.faces()[star.faces[0]][star.corners[0]];
        let others = self.others(vertex);
        let finite =
            || own.iter().filter_map(|sharp| sharp.and_then(Sharpness::finite)).chain(others);
        let count = finite().count();
        if self.creasing == Creasing::Uniform || count < 2 {
            return own.into_iter().map(|sharp| sharp.and_then(Sharpness::lowered)).collect();
        }
        let sum = finite().fold(Rational::zero(), |sum, one| &sum + one);
        let quarter = Rational::new(1, 4);
        let lowered = |sharp: &Sharpness| match sharp.finite() {
            None => Some(Sharpness::Infinite),
            Some(one) => {
                let others = &(&sum - one) / &Rational::from(count - 1);
                let mean = &(&(&Rational::from(3) * one) + &others) * &quarter;
                Sharpness::new(&(&mean - &Rational::one()))
            }
        };
        own.into_iter().map(|sharp| sharp.and_then(lowered)).collect()
    }
}

fn set(map: &mut BTreeMap<usize, Sharpness>, key: usize, sharpness: Option<Sharpness>) {
    match sharpness {
        Some(sharpness) => {
            map.insert(key, sharpness);
        }
        None => {
            map.remove(&key);
        }
    }
}
