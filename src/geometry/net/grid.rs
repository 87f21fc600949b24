//! Grids of points.

use super::error::NetError;
use crate::exact::Rational;
use crate::mesh::{MAX_POINTS, MeshError, Point, PolygonMesh};

/// Which directions of a net are closed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Closed {
    /// From row to row: the last row is followed by the first.
    pub u: bool,
    /// Along the rows: the last point of a row is followed by its first.
    pub v: bool,
}

impl Closed {
    /// The directions as a pair.
    #[must_use]
    pub fn both(self) -> [bool; 2] {
        [self.u, self.v]
    }

    /// `none`, `u`, `v` or `uv`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match (self.u, self.v) {
            (false, false) => "none",
            (true, false) => "u",
            (false, true) => "v",
            (true, true) => "uv",
        }
    }

    /// The directions of this name.
    #[must_use]
    pub fn parse(text: &str) -> Option<Closed> {
        let pairs = [false, true].into_iter().flat_map(|u| [false, true].map(|v| Closed { u, v }));
        pairs.into_iter().find(|closed| closed.name() == text)
    }
}

/// A net x_{i,j}, i = 0, …, rows − 1, j = 0, …, columns − 1. The direction u is that of i, from row
/// to row, and v that of j.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::net::{Closed, Net};
///
/// let point = |k: i64| [k % 2, k / 2, 0].map(Rational::from);
/// let net = Net::new((0..4).map(point).collect(), 2, Closed::default())?;
/// assert_eq!((net.rows(), net.columns(), net.faces()), (2, 2, [1, 1]));
/// # Ok::<(), subcert::net::NetError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Net<S = Rational> {
    points: Vec<Point<S>>,
    columns: usize,
    closed: Closed,
}

impl<S> Net<S> {
    /// The net of these points, row by row.
    ///
    /// # Errors
    /// When the last row is not whole, a direction has fewer than 2 points, or 3 where it is
    /// closed, or there are more than [`MAX_POINTS`] points.
    pub fn new(points: Vec<Point<S>>, columns: usize, closed: Closed) -> Result<Net<S>, NetError> {
        if columns == 0 || !points.len().is_multiple_of(columns) {
            return Err(NetError::Ragged { points: points.len(), columns });
        }
        let sizes = [points.len() / columns, columns];
        for (direction, (found, closed)) in sizes.into_iter().zip(closed.both()).enumerate() {
            let needed = if closed { 3 } else { 2 };
            if found < needed {
                return Err(NetError::Small { direction, found, needed, closed });
            }
        }
        if points.len() > MAX_POINTS {
            return Err(NetError::TooManyPoints(points.len()));
        }
        Ok(Net { points, columns, closed })
    }

    /// The points, row by row.
    #[must_use]
    pub fn points(&self) -> &[Point<S>] {
        &self.points
    }

    /// How many rows there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.points.len() / self.columns
    }

    /// How many points a row has.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Both, the rows first.
    #[must_use]
    pub fn sizes(&self) -> [usize; 2] {
        [self.rows(), self.columns]
    }

    /// Which directions are closed.
    #[must_use]
    pub fn closed(&self) -> Closed {
        self.closed
    }

    /// How many faces there are from row to row, and along a row. Face number i·(those along a row)
    /// + j has the corners x_{i,j}, x_{i,j+1}, x_{i+1,j+1}, x_{i+1,j}.
    #[must_use]
    pub fn faces(&self) -> [usize; 2] {
        let [u, v] = self.closed.both().map(usize::from);
        [self.rows() - 1 + u, self.columns - 1 + v]
    }

    /// The point x_{i,j}, where indices of a closed direction are taken modulo its size; `None` where there is none.
    pub(crate) fn at(&self, i: i64, j: i64) -> Option<&Point<S>> {
        let place = |index: i64, size: usize, closed: bool| {
            let count = i64::try_from(size).ok()?;
            let index = if closed { index.rem_euclid(count) } else { index };
            usize::try_from(index).ok().filter(|index| *index < size)
        };
        let i = place(i, self.rows(), self.closed.u)?;
        let j = place(j, self.columns, self.closed.v)?;
        self.points.get(i * self.columns + j)
    }

    /// The same net with coordinates of another kind.
    #[must_use]
    pub fn map<T>(&self, mut map: impl FnMut(&S) -> T) -> Net<T> {
        let points = self.points.iter().map(|point| point.each_ref().map(&mut map)).collect();
        Net { points, columns: self.columns, closed: self.closed }
    }
}

impl Net<Rational> {
    /// The net as a mesh of quadrilaterals, which are counter-clockwise where rows go up and columns
    /// to the right.
    ///
    /// # Errors
    /// Never, as a net is a surface.
    pub fn mesh(&self) -> Result<PolygonMesh<Rational>, MeshError> {
        let points = self.points.clone();
        let [rows, columns] = self.sizes();
        let [up, along] = self.faces();
        let corner = |i: usize, j: usize| i % rows * columns + j % columns;
        let face = |i: usize, j: usize| {
            vec![corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)]
        };
        let faces = (0..up).flat_map(|i| (0..along).map(move |j| face(i, j)));
        PolygonMesh::new(points, faces.collect())
    }
}
