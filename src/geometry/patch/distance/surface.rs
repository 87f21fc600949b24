//! What is compared with its limit: a mesh, a solid or a net as pieces, in f64 and exactly.

use super::judge::Rounded;
use crate::exact::Rational;
use crate::float::nearest;
use crate::mesh::{MeshError, Point};
use crate::net::NetError;
use crate::patch::place::{FarPlace, Place, Verdict};
use crate::solid::SolidError;

/// How wide the enclosure of the distance is for most surfaces, relative to it.
pub(crate) const WIDTH: f64 = 1e-3;

/// A surface, or a solid, as pieces that can be divided. In f64, points are moved so that the first one is the
/// origin, and divided by a power of two.
pub(crate) trait Surface: Sync {
    type Error: TooMuch;
    /// A piece with its points in f64.
    type Cell;
    /// In what part of a piece a place is.
    type At: Send;
    /// The level of the pieces that all others are parts of, the roots.
    const FIRST: u32;
    /// How many pieces are looked at in one root.
    const STEPS: u64;

    fn root_count(&self) -> usize;

    /// How many faces, or cells of a solid, the control mesh has.
    fn face_count(&self) -> usize;

    /// The first point of the control mesh, and the power of two.
    fn frame(&self) -> (&Point<Rational>, &Rational);

    /// The highest level that is compared with the limit, and the highest one of pieces.
    fn most_levels(&self) -> [u32; 2];

    /// For each root a bound of the distance at a level and all later ones.
    fn bounds(&self, level: u32) -> impl Iterator<Item = f64>;

    /// Lengths in f64.
    fn rounded_judge(&self, tolerance: &Rational) -> Rounded;

    /// A root, for the mesh of a level.
    fn root(&self, root: usize, level: u32) -> Self::Cell;

    /// A search that looks at so many pieces, for the mesh of a level.
    fn search<'a>(
        &'a self,
        judge: &'a Rounded,
        level: u32,
        steps: u64,
    ) -> impl PieceSearch<Self::Cell, Place<Self::At, Point<f64>>>;

    /// Whether a root is exactly within the tolerance; `None` where exact numbers are too much work. The steps that the
    /// search takes are those that it is given less those that it leaves.
    fn examine_exactly(
        &self,
        root: usize,
        level: u32,
        tolerance: &Rational,
        steps: &mut u64,
    ) -> Option<Verdict<FarPlace>>;

    /// A place in a root in the numbers of the control mesh and of a level, with the points of mesh and limit there.
    fn numbered<V>(
        &self,
        root: usize,
        level: u32,
        place: &Place<Self::At, V>,
        points: [Point<f64>; 2],
    ) -> FarPlace;

    /// The parts of a root whose distances are those of faces, each with the faces that it is on.
    fn on_faces(&self, root: usize, level: u32) -> Vec<(Vec<usize>, Self::Cell)>;

    /// Where the mesh of a level is on a piece.
    fn ball(&self, cell: &Self::Cell, judge: &Rounded, level: u32) -> Ball;

    /// The same of a root.
    fn root_ball(&self, cell: &Self::Cell, judge: &Rounded, level: u32) -> Ball {
        self.ball(cell, judge, level)
    }

    /// Pieces with the same part of the mesh of a level, which show better where it is.
    fn finer(&self, cell: Self::Cell, level: u32) -> Vec<Self::Cell>;

    /// How wide the enclosure of the distance is, relative to it.
    fn width(&self) -> f64 {
        WIDTH
    }

    /// The roots with a greater bound than this for a level, the greatest first.
    fn above(&self, level: u32, threshold: f64) -> Vec<(f64, usize)> {
        let bounds = self.bounds(level).zip(0..);
        let mut above: Vec<(f64, usize)> = bounds.filter(|(bound, _)| *bound > threshold).collect();
        above.sort_by(|left, right| right.0.total_cmp(&left.0));
        above
    }

    /// A point in f64 as it is in the file.
    fn as_given(&self, point: &Point<f64>) -> Point<f64> {
        let (origin, scale) = self.frame();
        [0, 1, 2].map(|i| point[i] * nearest(scale) + nearest(&origin[i]))
    }

    /// A place in f64, as the mesh is in the file.
    fn far_place(&self, root: usize, level: u32, place: &Place<Self::At, Point<f64>>) -> FarPlace {
        let points = [&place.polygon, &place.limit].map(|point| self.as_given(point));
        self.numbered(root, level, place, points)
    }
}

/// A search in one piece after another, for the mesh of one level.
pub(crate) trait PieceSearch<C, P> {
    /// How many pieces may still be looked at.
    fn left(&self) -> u64;

    /// Whether a piece is within the tolerance.
    fn examine(&mut self, piece: C) -> Verdict<P>;

    /// The distance on a piece where it exceeds `best`, which is raised to the greatest lower bound
    /// found; the result is an upper bound, at most `best`·(1 + `width`) where the steps allow.
    fn measure(&mut self, piece: C, width: f64, best: &mut f64, place: &mut Option<P>) -> f64;
}

/// A ball around the mesh on a piece of a level.
pub(crate) struct Ball {
    pub(crate) centre: Point<f64>,
    pub(crate) radius: f64,
    pub(crate) level: u32,
    /// Whether the centre is surely on the mesh.
    pub(crate) on_mesh: bool,
}

/// Errors that say what is beyond a cap.
pub(crate) trait TooMuch: std::fmt::Display {
    fn too_much(reason: String) -> Self;
}

impl TooMuch for MeshError {
    fn too_much(reason: String) -> MeshError {
        MeshError::TooMuch { reason }
    }
}

impl TooMuch for NetError {
    fn too_much(reason: String) -> NetError {
        NetError::TooMuch(reason)
    }
}

impl TooMuch for SolidError {
    fn too_much(reason: String) -> SolidError {
        SolidError::TooMuch { reason }
    }
}

/// Refuses a tolerance that is not positive.
pub(crate) fn positive<E: TooMuch>(tolerance: &Rational) -> Result<(), E> {
    if tolerance.sign() > 0 {
        return Ok(());
    }
    Err(E::too_much(format!("the tolerance must be positive, and is {tolerance}")))
}
