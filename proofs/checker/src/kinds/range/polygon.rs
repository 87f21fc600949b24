//! Regions of the plane that linear inequalities bound, and their polygons.

#![warn(clippy::arithmetic_side_effects)]

use super::convex::{Linear, REGION, steps};
use crate::numbers::{Meter, Q, bits, int};
use crate::text::Stop;
use num_traits::{Signed as _, Zero as _};
use std::cmp::Ordering;

/// The most inequalities.
const MAX_PLANES: usize = 256;

/// The most lines that cut a region.
const MAX_LINES: usize = 32;

/// A point by its coordinates.
pub type Point = [Q; 2];

/// The points where linear functions are not positive, or with `true` negative.
pub struct Region<'m> {
    planes: Vec<(Linear, bool)>,
    meter: &'m Meter,
}

/// The middle of points.
pub fn middle(points: &[&Point]) -> Point {
    let count = Q::from_integer(points.len().into());
    [0, 1].map(|axis| points.iter().map(|point| &point[axis]).sum::<Q>() / &count)
}

/// The corners from the least one on.
fn from_least(mut corners: Vec<Point>) -> Vec<Point> {
    let least = (0..corners.len()).min_by(|i, j| corners[*i].cmp(&corners[*j]));
    corners.rotate_left(least.unwrap_or(0));
    corners
}

impl<'m> Region<'m> {
    /// A region that has a point.
    pub fn new(mut planes: Vec<(Linear, bool)>, meter: &'m Meter) -> Result<Region<'m>, Stop> {
        for (linear, strict) in &planes {
            // A number that is not below 0, or not at most 0, leaves no points.
            let of = linear.constant();
            if of.is_some_and(|c| c.is_positive() || *strict && c.is_zero()) {
                return Err(REGION);
            }
        }
        planes.retain(|(linear, _)| linear.constant().is_none());
        planes.sort();
        planes.dedup();
        if planes.len() > MAX_PLANES {
            return Err(Stop::Capped("the linear functions of a region"));
        }
        Ok(Region { planes, meter })
    }

    /// The value of a linear function.
    fn at(&self, Linear([a, b, c]): &Linear, [x, y]: &Point) -> Result<Q, Stop> {
        let longest = [a, b, c, x, y].into_iter().map(bits).max().unwrap_or(0);
        self.meter.spend(steps(longest))?;
        Ok(a * x + b * y + c)
    }

    /// Whether a point belongs to it.
    pub fn has(&self, point: &Point) -> Result<bool, Stop> {
        for (linear, strict) in &self.planes {
            let value = self.at(linear, point)?;
            if value.is_positive() || *strict && value.is_zero() {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The corners of its closure counterclockwise, from the least one on. It has to be bounded, and to have inner points.
    pub fn corners(&self) -> Result<Vec<Point>, Stop> {
        let beyond = self.beyond()?;
        let corner = |x: i64, y: i64| [&beyond * int(x), &beyond * int(y)];
        let mut corners = vec![corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
        for (linear, _) in &self.planes {
            corners = self.cut(linear, &corners)?;
        }
        // Of a segment, a point or nothing there are fewer.
        if corners.len() < 3 {
            return Err(REGION);
        }
        Ok(from_least(corners))
    }

    /// The convex polygons into which the lines where linear functions vanish cut a convex polygon.
    pub fn cells(
        &self,
        lines: impl Iterator<Item = Linear>,
        corners: Vec<Point>,
    ) -> Result<Vec<Vec<Point>>, Stop> {
        let mut lines: Vec<Linear> = lines.filter_map(|line| line.monic()).collect();
        lines.sort();
        lines.dedup();
        if lines.len() > MAX_LINES {
            return Err(Stop::Capped("the lines that cut a region"));
        }
        let mut cells = vec![corners];
        for line in lines {
            let mut parts = Vec::new();
            for cell in cells {
                for side in [line.clone(), line.negated()] {
                    parts.push(self.cut(&side, &cell)?);
                }
            }
            // What a line only touches has fewer corners on its other side.
            parts.retain(|part| part.len() >= 3);
            cells = parts;
        }
        Ok(cells.into_iter().map(from_least).collect())
    }

    /// A number that is greater than all coordinates of the points, which have to be bounded.
    fn beyond(&self) -> Result<Q, Stop> {
        // If a ray stays in a region of inequalities, one along the border of one of them does.
        for (Linear([a, b, _]), _) in &self.planes {
            for ray in [[-b, a.clone()], [b.clone(), -a]] {
                let mut stays = true;
                for (Linear([a, b, _]), _) in &self.planes {
                    let slope = self.at(&Linear([a.clone(), b.clone(), int(0)]), &ray)?;
                    if slope.is_positive() {
                        stays = false;
                        break;
                    }
                }
                if stays {
                    return Err(REGION);
                }
            }
        }
        if self.planes.is_empty() {
            return Err(REGION);
        }
        let mut most = int(0);
        for (place, (Linear([a, b, c]), _)) in self.planes.iter().enumerate() {
            for (other, _) in self.planes.iter().take(place) {
                let Linear([d, e, f]) = other;
                self.meter.spend(steps(
                    other.bits().max([a, b, c].map(bits).into_iter().max().unwrap_or(0)),
                ))?;
                let determinant = a * e - b * d;
                if determinant.is_zero() {
                    continue;
                }
                for top in [b * f - c * e, c * d - a * f] {
                    most = most.max((top / &determinant).abs());
                }
            }
        }
        Ok(most + int(1))
    }

    /// The part of a convex polygon where a linear function is not positive.
    fn cut(&self, linear: &Linear, corners: &[Point]) -> Result<Vec<Point>, Stop> {
        let values = corners.iter().map(|corner| self.at(linear, corner));
        let values = values.collect::<Result<Vec<Q>, Stop>>()?;
        let mut kept = Vec::new();
        let next = corners.iter().zip(&values).cycle().skip(1);
        for ((corner, value), (other, at_other)) in corners.iter().zip(&values).zip(next) {
            if !value.is_positive() {
                kept.push(corner.clone());
            }
            // A corner on the border is no new one.
            let signs = [value, at_other].map(|value| value.cmp(&Q::zero()));
            if let [Ordering::Less, Ordering::Greater] | [Ordering::Greater, Ordering::Less] = signs
            {
                let share = value / (value - at_other);
                let along = |axis: usize| &corner[axis] + (&other[axis] - &corner[axis]) * &share;
                kept.push([along(0), along(1)]);
            }
        }
        Ok(kept)
    }
}
