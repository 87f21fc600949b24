//! Continuous piecewise linear functions of one real variable.

use super::{IntervalSet, Polynomial, Rational};
use std::fmt;

/// A continuous piecewise linear function of one real variable over Q, in normal
/// form: two are equal exactly when they agree everywhere.
///
/// Sums, rational multiples, |·|, max and min stay in this class; a product does
/// only in the cases that [`PiecewiseLinear::times`] names.
///
/// ```
/// use subcert::exact::{PiecewiseLinear, Rational};
///
/// // δ(a) = 2|a − 1/3| + |2a − 1|, and where it is below 1.
/// let a = PiecewiseLinear::variable();
/// let constant = |p, q| PiecewiseLinear::constant(Rational::new(p, q));
/// let first = a.minus(&constant(1, 3)).magnitude();
/// let second = a.plus(&a).minus(&constant(1, 1)).magnitude();
/// let delta = first.plus(&first).plus(&second);
/// assert_eq!(delta.at(&Rational::new(1, 4)), Rational::new(2, 3));
/// assert_eq!(delta.below(&Rational::one()).describe("a"), "1/6 < a < 2/3");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PiecewiseLinear {
    /// Where the slope changes, in rising order.
    breaks: Vec<Rational>,
    /// The line on each side of each break, neighbours different, equal at the
    /// break between them.
    lines: Vec<Line>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct Line {
    slope: Rational,
    intercept: Rational,
}

impl Line {
    fn at(&self, x: &Rational) -> Rational {
        &self.slope * x + &self.intercept
    }
}

impl PiecewiseLinear {
    /// The constant function `value`.
    #[must_use]
    pub fn constant(value: Rational) -> PiecewiseLinear {
        let line = Line { slope: Rational::zero(), intercept: value };
        PiecewiseLinear { breaks: Vec::new(), lines: vec![line] }
    }

    /// The function x ↦ x.
    #[must_use]
    pub fn variable() -> PiecewiseLinear {
        let line = Line { slope: Rational::one(), intercept: Rational::zero() };
        PiecewiseLinear { breaks: Vec::new(), lines: vec![line] }
    }

    /// The function that is `line(x)` near x, for x off the points `breaks`. The
    /// lines have to agree at these points.
    fn assemble(breaks: Vec<Rational>, line: impl Fn(&Rational) -> Line) -> PiecewiseLinear {
        let mut samples = samples(&breaks).into_iter();
        let first = samples.next().expect("there is a cell more than there are points");
        let mut function = PiecewiseLinear { breaks: Vec::new(), lines: vec![line(&first)] };
        for (point, sample) in breaks.into_iter().zip(samples) {
            let next = line(&sample);
            if function.lines.last() != Some(&next) {
                function.breaks.push(point);
                function.lines.push(next);
            }
        }
        function
    }

    /// The line near x; at a break, the one on its right.
    fn line(&self, x: &Rational) -> &Line {
        &self.lines[self.breaks.partition_point(|point| point <= x)]
    }

    /// The breaks of both.
    fn common_breaks(&self, other: &PiecewiseLinear) -> Vec<Rational> {
        sorted(self.breaks.iter().chain(&other.breaks).cloned().collect())
    }

    /// The points where the slope changes, in rising order.
    #[must_use]
    pub fn breakpoints(&self) -> &[Rational] {
        &self.breaks
    }

    /// The value at x.
    #[must_use]
    pub fn at(&self, x: &Rational) -> Rational {
        self.line(x).at(x)
    }

    /// The value of a constant function; `None` for any other.
    #[must_use]
    pub fn as_constant(&self) -> Option<Rational> {
        match &self.lines[..] {
            [line] if line.slope.is_zero() => Some(line.intercept.clone()),
            _ => None,
        }
    }

    /// The number of linear pieces.
    #[must_use]
    pub fn piece_count(&self) -> usize {
        self.lines.len()
    }

    /// The number of binary digits of all breaks and coefficients together.
    #[must_use]
    pub fn bits(&self) -> u64 {
        let lines = self.lines.iter().flat_map(|line| [&line.slope, &line.intercept]);
        lines.chain(&self.breaks).map(Rational::bits).sum()
    }

    /// self + other.
    #[must_use]
    pub fn plus(&self, other: &PiecewiseLinear) -> PiecewiseLinear {
        PiecewiseLinear::assemble(self.common_breaks(other), |x| {
            let (left, right) = (self.line(x), other.line(x));
            Line {
                slope: &left.slope + &right.slope,
                intercept: &left.intercept + &right.intercept,
            }
        })
    }

    /// self − other.
    #[must_use]
    pub fn minus(&self, other: &PiecewiseLinear) -> PiecewiseLinear {
        self.plus(&other.scaled(&-Rational::one()))
    }

    /// factor · self.
    #[must_use]
    pub fn scaled(&self, factor: &Rational) -> PiecewiseLinear {
        PiecewiseLinear::assemble(self.breaks.clone(), |x| {
            let line = self.line(x);
            Line { slope: &line.slope * factor, intercept: &line.intercept * factor }
        })
    }

    /// self · other, when that is piecewise linear: when between any two
    /// neighbouring breaks of the two, one of them is constant. `None` otherwise.
    #[must_use]
    pub fn times(&self, other: &PiecewiseLinear) -> Option<PiecewiseLinear> {
        let breaks = self.common_breaks(other);
        let flat = |x: &Rational| self.line(x).slope.is_zero() || other.line(x).slope.is_zero();
        if !samples(&breaks).iter().all(flat) {
            return None;
        }
        Some(PiecewiseLinear::assemble(breaks, |x| {
            let (left, right) = (self.line(x), other.line(x));
            Line {
                slope: &left.slope * &right.intercept + &left.intercept * &right.slope,
                intercept: &left.intercept * &right.intercept,
            }
        }))
    }

    /// |self|.
    #[must_use]
    pub fn magnitude(&self) -> PiecewiseLinear {
        self.greater(&self.scaled(&-Rational::one()))
    }

    /// The greater of the two at every point.
    #[must_use]
    pub fn greater(&self, other: &PiecewiseLinear) -> PiecewiseLinear {
        let difference = self.minus(other);
        let mut points = self.common_breaks(other);
        points.extend(difference.zeros());
        PiecewiseLinear::assemble(sorted(points), |x| {
            let larger = if difference.at(x).sign() < 0 { other } else { self };
            larger.line(x).clone()
        })
    }

    /// The lesser of the two at every point.
    #[must_use]
    pub fn lesser(&self, other: &PiecewiseLinear) -> PiecewiseLinear {
        self.plus(other).minus(&self.greater(other))
    }

    /// The zeros of the pieces that are not constant.
    fn zeros(&self) -> Vec<Rational> {
        let zero = |(piece, line): (usize, &Line)| {
            if line.slope.is_zero() {
                return None;
            }
            let zero = -&line.intercept / &line.slope;
            let right_of_low = piece == 0 || self.breaks[piece - 1] <= zero;
            let left_of_high = self.breaks.get(piece).is_none_or(|high| zero <= *high);
            (right_of_low && left_of_high).then_some(zero)
        };
        self.lines.iter().enumerate().filter_map(zero).collect()
    }

    /// The set of the x where the sign of the value, −1, 0 or 1, is one that `keep`
    /// wants.
    fn with_sign(&self, keep: impl Fn(i8) -> bool) -> IntervalSet {
        let mut points = self.breaks.clone();
        points.extend(self.zeros());
        let points = sorted(points);
        // Between two of these points the sign does not change.
        let mut cells = Vec::with_capacity(2 * points.len() + 1);
        for (i, sample) in samples(&points).iter().enumerate() {
            cells.push(keep(self.at(sample).sign()));
            cells.extend(points.get(i).map(|point| keep(self.at(point).sign())));
        }
        IntervalSet::of_cells(&points, &cells)
    }

    /// The set of the x with f(x) < bound; open, since f is continuous.
    #[must_use]
    pub fn below(&self, bound: &Rational) -> IntervalSet {
        self.minus(&PiecewiseLinear::constant(bound.clone())).with_sign(|sign| sign < 0)
    }

    /// The set of the x with f(x) ≤ bound.
    #[must_use]
    pub fn at_most(&self, bound: &Rational) -> IntervalSet {
        self.minus(&PiecewiseLinear::constant(bound.clone())).with_sign(|sign| sign <= 0)
    }

    /// The set of the x with f(x) > g(x), where g is `other`.
    #[must_use]
    pub fn exceeds(&self, other: &PiecewiseLinear) -> IntervalSet {
        self.minus(other).with_sign(|sign| sign > 0)
    }

    /// The set of the x with f(x) ≠ g(x), where g is `other`; empty exactly when the
    /// two are equal.
    #[must_use]
    pub fn differs(&self, other: &PiecewiseLinear) -> IntervalSet {
        self.minus(other).with_sign(|sign| sign != 0)
    }

    /// The pieces as conditions on `variable`:
    /// `-a for a <= 0, a for a >= 0`.
    #[must_use]
    pub fn describe(&self, variable: &str) -> String {
        let x = Polynomial::variable(variable);
        let piece = |(piece, line): (usize, &Line)| {
            let slope = Polynomial::constant(line.slope.clone());
            let line = &(&slope * &x) + &Polynomial::constant(line.intercept.clone());
            let low = piece.checked_sub(1).map(|below| &self.breaks[below]);
            match (low, self.breaks.get(piece)) {
                (None, None) => line.to_string(),
                (None, Some(high)) => format!("{line} for {variable} <= {high}"),
                (Some(low), None) => format!("{line} for {variable} >= {low}"),
                (Some(low), Some(high)) => format!("{line} for {low} <= {variable} <= {high}"),
            }
        };
        self.lines.iter().enumerate().map(piece).collect::<Vec<String>>().join(", ")
    }
}

/// [`PiecewiseLinear::describe`] with the variable `x`.
impl fmt::Display for PiecewiseLinear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.describe("x"))
    }
}

fn sorted(mut points: Vec<Rational>) -> Vec<Rational> {
    points.sort();
    points.dedup();
    points
}

/// A number before the first of the points, one between each two neighbours, and
/// one after the last.
fn samples(points: &[Rational]) -> Vec<Rational> {
    let (Some(first), Some(last)) = (points.first(), points.last()) else {
        return vec![Rational::zero()];
    };
    let between = points.windows(2).map(|pair| (&pair[0] + &pair[1]) / Rational::from(2));
    let outer = [first - Rational::one(), last + Rational::one()];
    let [before, after] = outer;
    std::iter::once(before).chain(between).chain([after]).collect()
}
