//! Values of the Jacobian, in the scale in which the first point of the net has the length 1.

use super::ball::Ball;
use super::net::{Lattice, Net, ratio};
use super::pieces::Piece;
use super::ring::{RingPoint, jacobian, on_ring, ring_pieces};
use super::sign::{Place, boxes};
use crate::exact::{Enclosure, Rational, Scalar as _};

/// The square of the length of the first point.
pub(super) fn unit(net: &Net<Ball>) -> Enclosure {
    let first = if net.lattice == Lattice::Dual { (0, 0) } else { (1, 0) };
    let [p, q] = &net.points[&first];
    let square = p
        .times(p)
        .plus(&q.times(q))
        .plus(&ratio::<Ball>(2, 1).times(&net.cosine).times(&p.times(q)));
    if square.is_apart() { square.enclosure() } else { Enclosure::exact(Rational::one()) }
}

/// A lower bound of a positive J: the least coefficient of the parts into which [`boxes`] divides the pieces, and a
/// corner of the part that has it.
pub(super) fn least(net: &Net<Ball>, value: &Ball) -> (Rational, RingPoint) {
    let pieces = ring_pieces(net, value);
    let all = pieces
        .iter()
        .flat_map(|piece| boxes(&jacobian(piece)).into_iter().map(move |part| (piece, part)));
    let (piece, part) = all.min_by(|(_, a), (_, b)| a.least.cmp(&b.least)).expect("three pieces");
    (part.least / unit(net).upper().clone(), on_ring(piece, &part.near))
}

/// The piece with a point of the ring, and its place there.
pub(super) fn located<'p>(
    pieces: &'p [Piece<Ball>],
    point: &RingPoint,
) -> Option<(&'p Piece<Ball>, Place)> {
    let one = Rational::one();
    let inside = |x: &Rational| x.sign() >= 0 && *x <= one;
    pieces.iter().find_map(|piece| {
        let side = Rational::from(i64::from(piece.direction));
        let along = |corner: i32, x: &Rational| (x - &Rational::from(i64::from(corner))) * &side;
        let [u, v] = [along(piece.corner.0, &point.at[0]), along(piece.corner.1, &point.at[1])];
        let within = inside(&u) && inside(&v) && (!piece.coordinates[0].triangle || &u + &v <= one);
        within.then_some((piece, [u, v]))
    })
}

/// J at a point of the ring.
pub(super) fn jacobian_at(net: &Net<Ball>, value: &Ball, point: &RingPoint) -> Enclosure {
    let ball = |x: &Rational| Ball::from_rational(x);
    let pieces = ring_pieces(net, value);
    let (piece, [u, v]) = located(&pieces, point).expect("a point of the ring");
    let w = Rational::one() - &u - &v;
    let one = Rational::one();
    let found = jacobian(piece).value(&[&ball(&u), &ball(&v), &ball(&w), &ball(&one)]);
    let unit = unit(net);
    let ends = [found.lower(), found.upper()];
    let quotients = ends.map(|x| [&x / unit.lower(), &x / unit.upper()]).concat();
    let low = quotients.iter().min().expect("four numbers").clone();
    let high = quotients.iter().max().expect("four numbers").clone();
    Enclosure::new(low, high)
}
