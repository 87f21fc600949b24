//! The control polygon whose depth is asked for.

use subcert::exact::Rational;
use subcert::limit::ControlPolygon;
use subcert::patch::relative_tolerance;

/// A control polygon of points.
pub(super) struct Points {
    /// One polygon of numbers for each coordinate.
    pub(super) coordinates: Vec<ControlPolygon>,
    /// Its points: all x, then all y, and so on.
    pub(super) numbers: Vec<Vec<Rational>>,
    /// How many points there are.
    pub(super) count: usize,
    pub(super) closed: bool,
    /// What is to be told of the file.
    pub(super) notes: Vec<String>,
}

impl Points {
    /// The polygon of these coordinates: all x, then all y, and so on.
    pub(super) fn new(coordinates: &[Vec<Rational>], closed: bool, notes: Vec<String>) -> Points {
        let polygon = |points: &Vec<Rational>| {
            if closed { ControlPolygon::closed(points) } else { ControlPolygon::open(points) }
        };
        let count = coordinates.first().map_or(0, Vec::len);
        let numbers = coordinates.to_vec();
        Points {
            coordinates: coordinates.iter().map(polygon).collect(),
            numbers,
            count,
            closed,
            notes,
        }
    }

    /// The largest difference of neighbouring points in any coordinate.
    pub(super) fn spread(&self) -> Rational {
        self.coordinates.iter().map(ControlPolygon::spread).max().unwrap_or_else(Rational::zero)
    }

    /// This part of the diagonal of the box around the points.
    pub(super) fn share_of_diagonal(&self, share: &Rational) -> Option<Rational> {
        let point = |i: usize| self.numbers.iter().map(|own| own[i].clone()).collect();
        let points: Vec<Vec<Rational>> = (0..self.count).map(point).collect();
        relative_tolerance(&points, share)
    }
}
