//! Regions of two parameters that inequalities describe: convex polygons.

use crate::exact::{Rational, Scalar};
use crate::formula::Value;
use std::cmp::Ordering;
use std::fmt;

/// The most linear functions of which a side is the greatest.
const MAX_PIECES: usize = 64;

/// The function ax + by + c of two variables.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Linear([Rational; 3]);

impl Linear {
    fn combined(&self, other: &Linear, factor: i64) -> Linear {
        let factor = Rational::from(factor);
        let Linear([a, b, c]) = self;
        let Linear([d, e, f]) = other;
        Linear([a + d * &factor, b + e * &factor, c + f * factor])
    }

    fn scaled(&self, factor: &Rational) -> Linear {
        Linear(self.0.each_ref().map(|c| c * factor))
    }

    fn at(&self, [x, y]: [&Rational; 2]) -> Rational {
        let Linear([a, b, c]) = self;
        a * x + b * y + c
    }

    fn constant(&self) -> Option<&Rational> {
        let Linear([a, b, c]) = self;
        (a.is_zero() && b.is_zero()).then_some(c)
    }
}

/// The greatest of some linear functions of two variables, less the greatest of others.
#[derive(Clone, Debug, PartialEq)]
pub enum Pieces {
    /// That.
    Of {
        /// Those of which the greatest counts.
        more: Vec<Linear>,
        /// Those of which the greatest is subtracted.
        less: Vec<Linear>,
    },
    /// Anything else.
    Other,
}

impl Pieces {
    /// The first variable, or the second.
    #[must_use]
    pub fn variable(second: bool) -> Pieces {
        let one = |is: bool| Rational::from(i64::from(is));
        Pieces::linear(Linear([one(!second), one(second), Rational::zero()]))
    }

    fn linear(only: Linear) -> Pieces {
        Pieces::Of { more: vec![only], less: vec![Linear([0, 0, 0].map(Rational::from))] }
    }

    fn of(more: Vec<Linear>, less: Vec<Linear>) -> Pieces {
        let distinct = |all: Vec<Linear>| {
            all.into_iter().fold(Vec::new(), |mut kept, one| {
                if !kept.contains(&one) {
                    kept.push(one);
                }
                kept
            })
        };
        let (more, less) = (distinct(more), distinct(less));
        if more.len() > MAX_PIECES || less.len() > MAX_PIECES {
            return Pieces::Other;
        }
        // What is subtracted is 0 if it is one function.
        match &less[..] {
            [only] => Pieces::Of {
                more: more.iter().map(|piece| piece.combined(only, -1)).collect(),
                less: vec![only.combined(only, -1)],
            },
            _ => Pieces::Of { more, less },
        }
    }

    /// The linear functions of which this is the greatest, if it is that.
    #[must_use]
    pub fn convex(&self) -> Option<&[Linear]> {
        match self {
            Pieces::Of { more, less } if less.len() == 1 => Some(more),
            _ => None,
        }
    }

    fn as_linear(&self) -> Option<&Linear> {
        self.convex().and_then(|more| if let [only] = more { Some(only) } else { None })
    }
}

/// All sums of one of each.
fn sums(left: &[Linear], right: &[Linear]) -> Vec<Linear> {
    left.iter().flat_map(|a| right.iter().map(move |b| a.combined(b, 1))).collect()
}

impl fmt::Display for Pieces {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.as_rational() {
            Some(value) => value.fmt(f),
            None => f.write_str("an expression in the two variables"),
        }
    }
}

impl Scalar for Pieces {
    fn from_rational(value: &Rational) -> Pieces {
        Pieces::linear(Linear([Rational::zero(), Rational::zero(), value.clone()]))
    }

    fn plus(&self, other: &Pieces) -> Pieces {
        let (Pieces::Of { more, less }, Pieces::Of { more: others, less: minus }) = (self, other)
        else {
            return Pieces::Other;
        };
        Pieces::of(sums(more, others), sums(less, minus))
    }

    fn minus(&self, other: &Pieces) -> Pieces {
        match other {
            Pieces::Of { more, less } => {
                self.plus(&Pieces::Of { more: less.clone(), less: more.clone() })
            }
            Pieces::Other => Pieces::Other,
        }
    }

    fn times(&self, other: &Pieces) -> Pieces {
        let (factor, pieces) = match (self.as_rational(), other.as_rational()) {
            (Some(factor), _) => (factor, other),
            (_, Some(factor)) => (factor, self),
            _ => return Pieces::Other,
        };
        let Pieces::Of { more, less } = pieces else { return Pieces::Other };
        let scaled = |all: &[Linear]| all.iter().map(|one| one.scaled(&factor.abs())).collect();
        let (more, less) = if factor.sign() < 0 { (less, more) } else { (more, less) };
        Pieces::of(scaled(more), scaled(less))
    }
}

impl Value for Pieces {
    fn as_rational(&self) -> Option<Rational> {
        self.as_linear()?.constant().cloned()
    }

    fn size(&self) -> u64 {
        let Pieces::Of { more, less } = self else { return 0 };
        more.iter().chain(less).flat_map(|one| &one.0).map(Rational::bits).sum()
    }

    fn product_size(&self, other: &Pieces) -> u64 {
        self.size().saturating_add(other.size()).saturating_mul(MAX_PIECES as u64)
    }

    fn quotient(&self, divisor: &Pieces) -> Option<Pieces> {
        Some(self.times(&Pieces::from_rational(&divisor.as_rational()?.recip())))
    }

    fn absolute(&self) -> Option<Pieces> {
        self.larger(&Pieces::zero().minus(self))
    }

    /// max(u − v, u' − v') = max(u + v', u' + v) − (v + v').
    fn larger(&self, other: &Pieces) -> Option<Pieces> {
        let (Pieces::Of { more, less }, Pieces::Of { more: others, less: minus }) = (self, other)
        else {
            return Some(Pieces::Other);
        };
        let all = sums(more, minus).into_iter().chain(sums(others, less)).collect();
        Some(Pieces::of(all, sums(less, minus)))
    }
}

/// The points where linear functions are negative, or negative or 0.
#[derive(Clone, Debug, Default)]
pub struct HalfPlanes {
    /// Each function, and whether it must be negative.
    all: Vec<(Linear, bool)>,
}

/// Why points are no convex polygon.
#[derive(Clone, Copy, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum NoPolygon {
    /// They go on for ever, or too many lines bound them.
    #[error("the region is not bounded, or bounded by too many lines")]
    Unbounded,
    /// They have no inner points.
    #[error("the region has no inner points")]
    Flat,
}

impl HalfPlanes {
    /// Adds the points where the greatest of these functions is negative, or also those where it is 0.
    pub fn add(&mut self, pieces: &[Linear], strict: bool) {
        self.all.extend(pieces.iter().map(|piece| (piece.clone(), strict)));
    }

    /// Whether a point is one of them.
    #[must_use]
    pub fn contain(&self, point: [&Rational; 2]) -> bool {
        self.all.iter().all(|(function, strict)| {
            let sign = function.at(point).sign();
            sign < 0 || sign == 0 && !strict
        })
    }

    /// The corners of the polygon of these points and of those on its sides, counterclockwise, the least first.
    ///
    /// # Errors
    /// When the points are no polygon with inner points.
    ///
    /// ```
    /// use subcert::exact::Rational;
    /// use subcert::formula::{HalfPlanes, Parameters, Pieces, evaluate, parse};
    ///
    /// // |x| + |y| < 1
    /// let names = [("x", Pieces::variable(false)), ("y", Pieces::variable(true))];
    /// let value = evaluate(&parse("abs(x) + abs(y) - 1")?, &Parameters::from(names))?;
    /// let mut square = HalfPlanes::default();
    /// square.add(value.convex().expect("a convex function"), true);
    /// assert_eq!(square.corners()?.len(), 4);
    /// assert!(!square.contain([&Rational::one(), &Rational::zero()]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn corners(&self) -> Result<Vec<[Rational; 2]>, NoPolygon> {
        let inside = |point: [&Rational; 2]| {
            self.all.iter().all(|(function, _)| function.at(point).sign() <= 0)
        };
        if self.all.iter().any(|(function, strict)| {
            function.constant().is_some_and(|c| c.sign() > 0 || *strict && c.is_zero())
        }) {
            return Err(NoPolygon::Flat);
        }
        let lines: Vec<&Linear> = self.all.iter().map(|(function, _)| function).collect();
        let lines: Vec<&Linear> =
            lines.into_iter().filter(|line| line.constant().is_none()).collect();
        // A direction in which the points go on for ever is that of one of the lines.
        let endless = lines.iter().any(|Linear([a, b, _])| {
            let turned = [[b.clone(), -a], [-b, a.clone()]];
            turned
                .iter()
                .any(|[x, y]| lines.iter().all(|Linear([d, e, _])| (d * x + e * y).sign() <= 0))
        });
        if lines.is_empty() || endless || lines.len() > MAX_PIECES {
            return Err(NoPolygon::Unbounded);
        }
        let mut points = Vec::new();
        for (i, first) in lines.iter().enumerate() {
            for second in &lines[..i] {
                points.extend(meeting(first, second).filter(|[x, y]| inside([x, y])));
            }
        }
        let corners = hull(points);
        if corners.len() < 3 { Err(NoPolygon::Flat) } else { Ok(corners) }
    }
}

/// The point on both lines, if there is one.
fn meeting(first: &Linear, second: &Linear) -> Option<[Rational; 2]> {
    let (Linear([a, b, c]), Linear([d, e, f])) = (first, second);
    let determinant = a * e - b * d;
    (!determinant.is_zero())
        .then(|| [(b * f - c * e) / &determinant, (c * d - a * f) / &determinant])
}

/// The corners of the convex hull, counterclockwise, the least first; fewer than three if all points are on a line.
fn hull(mut points: Vec<[Rational; 2]>) -> Vec<[Rational; 2]> {
    points.sort();
    points.dedup();
    // The lower side, and the upper one from the other end.
    let side = |points: &mut dyn Iterator<Item = &[Rational; 2]>| {
        let mut side: Vec<[Rational; 2]> = Vec::new();
        for point in points {
            while let [.., a, b] = &side[..]
                && turn(a, b, point) != Ordering::Greater
            {
                side.pop();
            }
            side.push(point.clone());
        }
        side.pop();
        side
    };
    let mut corners = side(&mut points.iter());
    corners.extend(side(&mut points.iter().rev()));
    corners
}

/// `Greater` where a, b, c turn to the left.
fn turn(a: &[Rational; 2], b: &[Rational; 2], c: &[Rational; 2]) -> Ordering {
    let area = (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0]);
    area.sign().cmp(&0)
}

#[cfg(test)]
mod tests {
    use super::{HalfPlanes, Pieces};
    use crate::exact::{Rational, Scalar as _};
    use crate::formula::{Parameters, Value as _, evaluate, parse};

    /// The points where this is negative.
    fn below(formulas: &[&str]) -> HalfPlanes {
        let mut planes = HalfPlanes::default();
        for text in formulas {
            let names = [("x", Pieces::variable(false)), ("y", Pieces::variable(true))];
            let scope = Parameters::from(names);
            let value = evaluate(&parse(text).expect("a formula"), &scope).expect("a value");
            planes.add(value.convex().expect("a convex function"), true);
        }
        planes
    }

    #[test]
    fn absolute_values_bound_a_square() {
        let corners = below(&["abs(x) + abs(y) - 1/2"]).corners().expect("a square");
        let half = Rational::new(1, 2);
        let expected =
            [[-&half, 0.into()], [0.into(), -&half], [half.clone(), 0.into()], [0.into(), half]];
        assert_eq!(corners, expected);
    }

    #[test]
    fn regions_without_area_or_end_are_refused() {
        for formulas in [&["x"][..], &["x", "-x", "y - 1", "-y"], &["x - 1", "-x", "y - x"], &["1"]]
        {
            assert!(below(formulas).corners().is_err(), "{formulas:?}");
        }
    }

    #[test]
    fn least_values_are_concave() {
        let (x, y) = (Pieces::variable(false), Pieces::variable(true));
        let least = x.plus(&y).minus(&x.larger(&y).expect("a value"));
        assert!(least.convex().is_none());
        assert_eq!(Pieces::zero().minus(&least).convex().map(<[_]>::len), Some(2));
    }
}
