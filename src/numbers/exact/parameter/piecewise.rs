//! Continuous piecewise polynomial functions of one real variable.

use crate::exact::{IntervalSet, Rational, RationalPolynomial, RealAlgebraic};
use std::fmt;

/// A continuous piecewise polynomial function of one real variable over Q, in normal
/// form: two values are equal exactly when the functions agree everywhere.
///
/// Sums, products, |·|, max and min stay in this class. The pieces join at real
/// algebraic numbers.
///
/// ```
/// use subcert::exact::{PiecewisePolynomial, Rational};
///
/// // δ(a) = 2|a − 1/3| + |2a − 1|, and where it is below 1.
/// let a = PiecewisePolynomial::variable();
/// let constant = |p, q| PiecewisePolynomial::constant(Rational::new(p, q));
/// let first = a.minus(&constant(1, 3)).magnitude();
/// let second = a.plus(&a).minus(&constant(1, 1)).magnitude();
/// let delta = first.plus(&first).plus(&second);
/// assert_eq!(delta.at(&Rational::new(1, 4)), Rational::new(2, 3));
/// assert_eq!(delta.below(&Rational::one()).describe("a"), "1/6 < a < 2/3");
///
/// let square = delta.times(&delta);
/// assert_eq!(square.below(&Rational::one()), delta.below(&Rational::one()));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PiecewisePolynomial {
    /// The points where one polynomial ends and another begins, in increasing order.
    breaks: Vec<RealAlgebraic>,
    /// The polynomials between the breaks, from left to right. Neighbours differ as
    /// polynomials and agree at the break between them.
    pieces: Vec<RationalPolynomial>,
}

impl From<RationalPolynomial> for PiecewisePolynomial {
    fn from(polynomial: RationalPolynomial) -> PiecewisePolynomial {
        PiecewisePolynomial { breaks: Vec::new(), pieces: vec![polynomial] }
    }
}

impl PiecewisePolynomial {
    /// The constant function `value`.
    #[must_use]
    pub fn constant(value: Rational) -> PiecewisePolynomial {
        RationalPolynomial::constant(value).into()
    }

    /// The function x ↦ x.
    #[must_use]
    pub fn variable() -> PiecewisePolynomial {
        RationalPolynomial::variable().into()
    }

    /// Σ_j |p_j|.
    #[must_use]
    pub fn sum_of_magnitudes(polynomials: &[RationalPolynomial]) -> PiecewisePolynomial {
        let not_constant = polynomials.iter().filter(|p| p.degree().unwrap_or(0) > 0);
        let roots = not_constant.flat_map(|p| RealAlgebraic::roots_of(p.numerator()));
        PiecewisePolynomial::assemble(sorted(roots.collect()), |x| signed_sum(polynomials, x))
    }

    /// A function that equals Σ_j |p_j| from `low` to `high`. Outside this interval its
    /// first and last pieces are continued, so all its breaks lie between `low` and
    /// `high`.
    ///
    /// ```
    /// use subcert::exact::{PiecewisePolynomial, Rational, RationalPolynomial};
    ///
    /// let x = [RationalPolynomial::variable()];
    /// let one = Rational::one();
    /// let sum = PiecewisePolynomial::sum_of_magnitudes_on(&x, &-&one, &-&one);
    /// assert_eq!(sum.at(&one), -one);
    /// ```
    #[must_use]
    pub fn sum_of_magnitudes_on(
        polynomials: &[RationalPolynomial],
        low: &Rational,
        high: &Rational,
    ) -> PiecewisePolynomial {
        let near = polynomials
            .iter()
            .map(RationalPolynomial::numerator)
            .filter(|p| p.degree().unwrap_or(0) > 0 && p.may_vanish_between(low, high));
        let roots = near
            .flat_map(|p| RealAlgebraic::roots_between(p, Some(low.clone()), Some(high.clone())));
        let ends = [low, high].map(|end| RealAlgebraic::from(end.clone()));
        let inside = |root: &RealAlgebraic| !ends.contains(root);
        let breaks = sorted(roots.filter(inside).collect());
        let points: Vec<&RealAlgebraic> =
            [&ends[0]].into_iter().chain(&breaks).chain([&ends[1]]).collect();
        let sample = |pair: &[&RealAlgebraic]| {
            if pair[0] < pair[1] { pair[0].rational_below(pair[1]) } else { low.clone() }
        };
        let samples = points.windows(2).map(sample).collect();
        PiecewisePolynomial::assemble_at(breaks, samples, |x| signed_sum(polynomials, x))
    }

    /// The function that is `piece(x)` near x, for every x other than the `breaks`.
    /// Neighbouring pieces must agree at the break between them.
    fn assemble(
        breaks: Vec<RealAlgebraic>,
        piece: impl Fn(&Rational) -> RationalPolynomial,
    ) -> PiecewisePolynomial {
        let samples = RealAlgebraic::rationals_between(&breaks);
        PiecewisePolynomial::assemble_at(breaks, samples, piece)
    }

    /// As `assemble`, with `samples` that hold one number inside each cell between the
    /// breaks.
    fn assemble_at(
        breaks: Vec<RealAlgebraic>,
        samples: Vec<Rational>,
        piece: impl Fn(&Rational) -> RationalPolynomial,
    ) -> PiecewisePolynomial {
        let mut samples = samples.into_iter();
        let first = samples.next().expect("there is a cell more than there are points");
        let mut function = PiecewisePolynomial::from(piece(&first));
        for (point, sample) in breaks.into_iter().zip(samples) {
            let next = piece(&sample);
            if function.pieces.last() != Some(&next) {
                function.breaks.push(point);
                function.pieces.push(next);
            }
        }
        function
    }

    /// The polynomial near x; at a break, the polynomial on the right.
    fn piece(&self, x: &Rational) -> &RationalPolynomial {
        &self.pieces[self.breaks.partition_point(|point| point.cmp_rational(x).is_le())]
    }

    /// The breaks of both functions, in increasing order.
    fn common_breaks(&self, other: &PiecewisePolynomial) -> Vec<RealAlgebraic> {
        sorted(self.breaks.iter().chain(&other.breaks).cloned().collect())
    }

    /// The points where one polynomial ends and another begins, in increasing order.
    #[must_use]
    pub fn breakpoints(&self) -> &[RealAlgebraic] {
        &self.breaks
    }

    /// The polynomials, from left to right; one more than there are breaks.
    #[must_use]
    pub fn pieces(&self) -> &[RationalPolynomial] {
        &self.pieces
    }

    /// The value at x.
    #[must_use]
    pub fn at(&self, x: &Rational) -> Rational {
        self.piece(x).value_at(x)
    }

    /// The value of a constant function; `None` for any other.
    #[must_use]
    pub fn as_constant(&self) -> Option<Rational> {
        match &self.pieces[..] {
            [piece] => piece.as_constant(),
            _ => None,
        }
    }

    /// The number of pieces.
    #[must_use]
    pub fn piece_count(&self) -> usize {
        self.pieces.len()
    }

    /// The greatest degree of a piece.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.pieces.iter().filter_map(RationalPolynomial::degree).max().unwrap_or(0)
    }

    /// The number of binary digits of all breaks and coefficients together.
    #[must_use]
    pub fn bits(&self) -> u64 {
        let breaks = self.breaks.iter().map(RealAlgebraic::bits).sum::<u64>();
        breaks + self.pieces.iter().map(RationalPolynomial::bits).sum::<u64>()
    }

    /// self + other.
    #[must_use]
    pub fn plus(&self, other: &PiecewisePolynomial) -> PiecewisePolynomial {
        PiecewisePolynomial::assemble(self.common_breaks(other), |x| {
            self.piece(x).plus(other.piece(x))
        })
    }

    /// self − other.
    #[must_use]
    pub fn minus(&self, other: &PiecewisePolynomial) -> PiecewisePolynomial {
        PiecewisePolynomial::assemble(self.common_breaks(other), |x| {
            self.piece(x).minus(other.piece(x))
        })
    }

    /// self · other.
    #[must_use]
    pub fn times(&self, other: &PiecewisePolynomial) -> PiecewisePolynomial {
        PiecewisePolynomial::assemble(self.common_breaks(other), |x| {
            self.piece(x).times(other.piece(x))
        })
    }

    /// factor · self.
    #[must_use]
    pub fn scaled(&self, factor: &Rational) -> PiecewisePolynomial {
        self.times(&PiecewisePolynomial::constant(factor.clone()))
    }

    /// |self|.
    #[must_use]
    pub fn magnitude(&self) -> PiecewisePolynomial {
        let points = self.breaks.iter().cloned().chain(self.zeros());
        PiecewisePolynomial::assemble(sorted(points.collect()), |x| {
            let piece = self.piece(x);
            if piece.sign_at(x) < 0 { piece.negated() } else { piece.clone() }
        })
    }

    /// The greater of the two at every point.
    #[must_use]
    pub fn greater(&self, other: &PiecewisePolynomial) -> PiecewisePolynomial {
        let difference = self.minus(other);
        let mut points = self.common_breaks(other);
        points.extend(difference.zeros());
        PiecewisePolynomial::assemble(sorted(points), |x| {
            let larger = if difference.piece(x).sign_at(x) < 0 { other } else { self };
            larger.piece(x).clone()
        })
    }

    /// The lesser of the two at every point.
    #[must_use]
    pub fn lesser(&self, other: &PiecewisePolynomial) -> PiecewisePolynomial {
        self.plus(other).minus(&self.greater(other))
    }

    /// The zeros of the pieces that are not constant.
    fn zeros(&self) -> Vec<RealAlgebraic> {
        let mut zeros = Vec::new();
        for (place, piece) in self.pieces.iter().enumerate() {
            if piece.degree().unwrap_or(0) == 0 {
                continue;
            }
            let low = place.checked_sub(1).map(|below| &self.breaks[below]);
            let high = self.breaks.get(place);
            let roots = RealAlgebraic::roots_between(
                piece.numerator(),
                low.map(|low| low.bounds().0),
                high.map(|high| high.bounds().1),
            );
            zeros.extend(roots.into_iter().filter(|root| {
                low.is_none_or(|low| low <= root) && high.is_none_or(|high| root <= high)
            }));
        }
        zeros
    }

    /// The set of all x at which `keep` accepts the sign −1, 0 or 1 of the value.
    fn with_sign(&self, keep: impl Fn(i8) -> bool) -> IntervalSet {
        let zeros = sorted(self.zeros());
        let points = sorted(self.breaks.iter().chain(&zeros).cloned().collect());
        // The sign is constant between two neighbouring points. At a point that is not a
        // zero it is the sign on both sides.
        let samples = RealAlgebraic::rationals_between(&points);
        let signs: Vec<i8> = samples.iter().map(|x| self.piece(x).sign_at(x)).collect();
        let mut cells = Vec::with_capacity(2 * points.len() + 1);
        for (i, sign) in signs.iter().enumerate() {
            cells.push(keep(*sign));
            cells.extend(points.get(i).map(|point| {
                let zero = signs[i] != signs[i + 1] || zeros.binary_search(point).is_ok();
                keep(if zero { 0 } else { *sign })
            }));
        }
        IntervalSet::of_cells(&points, &cells)
    }

    /// The set of the x with f(x) < bound; open, since f is continuous.
    #[must_use]
    pub fn below(&self, bound: &Rational) -> IntervalSet {
        self.minus(&PiecewisePolynomial::constant(bound.clone())).with_sign(|sign| sign < 0)
    }

    /// The set of the x with f(x) ≤ bound.
    #[must_use]
    pub fn at_most(&self, bound: &Rational) -> IntervalSet {
        self.minus(&PiecewisePolynomial::constant(bound.clone())).with_sign(|sign| sign <= 0)
    }

    /// The set of the x with f(x) > g(x), where g is `other`.
    #[must_use]
    pub fn exceeds(&self, other: &PiecewisePolynomial) -> IntervalSet {
        self.minus(other).with_sign(|sign| sign > 0)
    }

    /// The set of the x with f(x) ≠ g(x), where g is `other`; empty exactly when the
    /// two are equal.
    #[must_use]
    pub fn differs(&self, other: &PiecewisePolynomial) -> IntervalSet {
        self.minus(other).with_sign(|sign| sign != 0)
    }

    /// The pieces as conditions on `variable`:
    /// `-a for a <= 0, a for a >= 0`.
    #[must_use]
    pub fn describe(&self, variable: &str) -> String {
        let piece = |(place, piece): (usize, &RationalPolynomial)| {
            let piece = piece.describe(variable);
            let low = place.checked_sub(1).map(|below| &self.breaks[below]);
            match (low, self.breaks.get(place)) {
                (None, None) => piece,
                (None, Some(high)) => format!("{piece} for {variable} <= {high}"),
                (Some(low), None) => format!("{piece} for {variable} >= {low}"),
                (Some(low), Some(high)) => format!("{piece} for {low} <= {variable} <= {high}"),
            }
        };
        self.pieces.iter().enumerate().map(piece).collect::<Vec<String>>().join(", ")
    }
}

/// [`PiecewisePolynomial::describe`] with the variable `x`.
impl fmt::Display for PiecewisePolynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&self.describe("x"))
    }
}

/// Σ_j ±p_j with the signs of the p_j at x.
fn signed_sum(polynomials: &[RationalPolynomial], x: &Rational) -> RationalPolynomial {
    let zero = RationalPolynomial::constant(Rational::zero());
    polynomials.iter().fold(
        zero,
        |sum, p| {
            if p.sign_at(x) < 0 { sum.minus(p) } else { sum.plus(p) }
        },
    )
}

fn sorted(mut points: Vec<RealAlgebraic>) -> Vec<RealAlgebraic> {
    points.sort();
    points.dedup();
    points
}
