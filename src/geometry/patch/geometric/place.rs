//! How many levels are needed, and where a point of one set is far from the other.

use crate::exact::Rational;
use crate::mesh::Point;

/// One of the two sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SetKind {
    /// The mesh of the level.
    Mesh,
    /// The limit surface.
    Limit,
}

impl SetKind {
    /// `mesh` or `limit`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            SetKind::Mesh => "mesh",
            SetKind::Limit => "limit",
        }
    }
}

/// Whether a part of a set is near the other set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Nearness<F> {
    Near,
    /// With a point that shows it.
    Far(F),
    Open,
}

impl<F> Nearness<F> {
    /// That of all these parts together, up to the first that is far.
    pub(crate) fn all(parts: impl IntoIterator<Item = Self>) -> Self {
        let mut all = Nearness::Near;
        for part in parts {
            match part {
                Nearness::Near => {}
                Nearness::Open => all = Nearness::Open,
                far @ Nearness::Far(_) => return far,
            }
        }
        all
    }

    /// Adds what is known of one more part; `place` makes a point of this kind of one of the other.
    pub(crate) fn add<G>(&mut self, part: &Nearness<G>, place: impl FnOnce(&G) -> F) {
        match (part, &self) {
            (Nearness::Far(far), Nearness::Near | Nearness::Open) => {
                *self = Nearness::Far(place(far));
            }
            (Nearness::Open, Nearness::Near) => *self = Nearness::Open,
            _ => {}
        }
    }
}

/// A point of one set that is far from all of the other.
#[derive(Clone, Debug, PartialEq)]
pub struct GeometricPlace {
    /// The face of the control mesh.
    pub face: usize,
    /// Natural parameters at which, or near which, a net or its limit has the point; `None` of polygon meshes.
    pub parameters: Option<[Rational; 2]>,
    /// The vertex of that face that it is near to, where that is known.
    pub vertex: Option<usize>,
    /// The face of the level; `None` at level 0 and for Doo and Sabin.
    pub level_face: Option<u128>,
    /// The set that has the point.
    pub from: SetKind,
    /// The point, to f64.
    pub point: Point<f64>,
    /// A point of the other set that is near, to f64; no bound rests on it.
    pub other: Point<f64>,
    /// A lower bound of the distance of the point from the other set.
    pub distance: f64,
}

/// How many levels a mesh, or a control polygon, needs as a set of points.
#[derive(Clone, Debug, PartialEq)]
pub struct GeometricDepth<P = GeometricPlace> {
    /// The least level that was found to be sufficient; `None` where the search ended before it found one.
    pub level: Option<u32>,
    /// The greatest level that is certainly not sufficient, with all levels below it; `None` where even
    /// level 0 may be.
    pub too_few: Option<u32>,
    /// Why the search ended early, in words: it was stopped, or met a cap.
    pub ended: Option<String>,
    /// A point that shows that `too_few` is not sufficient.
    pub beyond: Option<P>,
    /// The same for the levels below it, from level 0 on.
    pub before: Vec<P>,
}

impl<P> GeometricDepth<P> {
    /// What is known of the levels that were looked at: points that show that they are not sufficient, from level 0 on.
    pub(crate) fn new(level: u32, places: Vec<P>) -> GeometricDepth<P> {
        GeometricDepth::of(Some(level), None, places)
    }

    /// The same of a search that ended early, with a level that is sufficient, if one is known.
    pub(crate) fn ended(
        level: Option<u32>,
        why: impl Into<String>,
        places: Vec<P>,
    ) -> GeometricDepth<P> {
        GeometricDepth::of(level, Some(why.into()), places)
    }

    fn of(level: Option<u32>, ended: Option<String>, mut places: Vec<P>) -> GeometricDepth<P> {
        let beyond = places.pop();
        let too_few = beyond.as_ref().map(|_| u32::try_from(places.len()).unwrap_or(u32::MAX));
        GeometricDepth { level, too_few, ended, beyond, before: places }
    }

    /// For each level that is certainly not sufficient, from 0 on, a point that shows it.
    pub fn places(&self) -> impl Iterator<Item = (u32, &P)> {
        (0..).zip(self.before.iter().chain(&self.beyond))
    }
}

/// What one face of the control mesh needs.
#[derive(Clone, Debug, PartialEq)]
pub struct FaceDepth {
    /// The least level that was found to be sufficient for its part of the mesh and its part of the limit.
    pub level: u32,
    /// Whether all levels below certainly are not.
    pub is_least: bool,
    /// The last distance that was found to be too great, and its level: a lower bound.
    pub too_far: Option<(u32, f64)>,
}
