//! Lines of constant parameters on the ring, for pictures.

use super::ball::Ball;
use super::bernstein::Form;
use super::jacobian::located;
use super::pieces::Piece;
use super::ring::RingPoint;
use crate::exact::{Rational, Scalar as _};

/// A line of a constant parameter on sector 0, by points p + qω, ω = e^{2πik/n}, as pairs p and q.
#[derive(Clone, Debug)]
pub struct RingLine {
    /// Whether it is the side of a piece.
    pub side: bool,
    /// Its points.
    pub points: Vec<[Rational; 2]>,
}

/// How many strips a piece is cut into, and how many points a line has beside the first.
const STRIPS: i64 = 4;
const STEPS: i64 = 12;

/// p and q of a piece at (u, v).
fn image(piece: &Piece<Ball>, u: &Rational, v: &Rational) -> [Rational; 2] {
    let ball = |x: &Rational| Ball::from_rational(x);
    let rest = Rational::one() - u - v;
    let at = [ball(u), ball(v), ball(&rest), ball(&Rational::one())];
    let [first, second, third, one] = &at;
    let value = |form: &Form<Ball>| form.value(&[first, second, third, one]).lower();
    piece.coordinates.each_ref().map(value)
}

/// The lines of all pieces of sector 0.
pub(super) fn lines(pieces: &[Piece<Ball>]) -> Vec<RingLine> {
    let mut lines = Vec::new();
    for piece in pieces {
        let triangle = piece.coordinates[0].triangle;
        for strip in 0..=STRIPS {
            let fixed = Rational::new(strip, STRIPS);
            let length = if triangle { Rational::one() - &fixed } else { Rational::one() };
            let side = strip == 0 || (strip == STRIPS && !triangle);
            let along = |step: i64| &length * &Rational::new(step, STEPS);
            let mut add = |side: bool, at: &dyn Fn(i64) -> [Rational; 2]| {
                let points = (0..=STEPS).map(|step| {
                    let [u, v] = at(step);
                    image(piece, &u, &v)
                });
                lines.push(RingLine { side, points: points.collect() });
            };
            add(side, &|step| [fixed.clone(), along(step)]);
            add(side, &|step| [along(step), fixed.clone()]);
            if triangle {
                // u + v is constant.
                let sum = Rational::one() - &fixed;
                add(strip == 0, &|step| {
                    let u = &sum * &Rational::new(step, STEPS);
                    [u.clone(), &sum - &u]
                });
            }
        }
    }
    lines
}

/// Where a point of the ring is mapped to.
pub(super) fn mapped(pieces: &[Piece<Ball>], point: &RingPoint) -> Option<[Rational; 2]> {
    let (piece, [u, v]) = located(pieces, point)?;
    Some(image(piece, &u, &v))
}
