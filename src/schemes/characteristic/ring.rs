//! The characteristic ring: its Jacobian, and the half-plane of its outer curve.

use super::ball::Ball;
use super::bernstein::Form;
use super::net::{Lattice, Net};
use super::pieces::{Piece, pieces};
use super::sign::{Part, Place, boxes, signs};
use crate::exact::{Rational, Scalar};

/// A point of the ring: on the lattice of the refined points of sector 0.
#[derive(Clone, Debug, PartialEq)]
pub struct RingPoint {
    /// Its two coordinates.
    pub at: Place,
}

/// What the signs of polynomials on the ring say.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Ring {
    /// J has this sign on all of the closed ring, with this many bisections.
    OneSign { sign: i8, bisections: usize },
    /// J > 0 at the first point and J < 0 at the second.
    Folded { points: [RingPoint; 2] },
    /// The sign of J is not decided.
    Undecided,
}

/// A part of a piece on which all Bernstein coefficients of J have one sign.
#[derive(Clone, Debug, PartialEq)]
pub struct RingBox {
    /// The piece of sector 0, from 0 on.
    pub piece: usize,
    /// The bisections that lead to the part: 0 and 1 are the first and the second half.
    pub path: String,
    /// A lower bound of the absolute values of the coefficients.
    pub least: Rational,
    /// Whether they are positive.
    pub positive: bool,
}

/// The parts of all pieces; empty where a piece has no such parts.
pub(super) fn all_boxes(pieces: &[Piece<Ball>]) -> Vec<RingBox> {
    let mut all = Vec::new();
    for (place, piece) in pieces.iter().enumerate() {
        let parts = boxes(&jacobian(piece));
        if parts.is_empty() {
            return Vec::new();
        }
        all.extend(parts.into_iter().map(|Part { path, least, positive, .. }| RingBox {
            piece: place,
            path,
            least,
            positive,
        }));
    }
    all
}

/// J = det D(p, q) of a piece.
pub(super) fn jacobian<R: Scalar>(piece: &Piece<R>) -> Form<R> {
    let [p, q] = &piece.coordinates;
    p.along_u().times(&q.along_v()).minus(&p.along_v().times(&q.along_u()))
}

/// The pieces of the ring of an eigenvector.
pub(super) fn ring_pieces<R: Scalar>(net: &Net<R>, value: &R) -> Vec<Piece<R>> {
    pieces(&net.refined(value))
}

/// The sign of J on the pieces.
pub(super) fn examined<R: Scalar>(pieces: &[Piece<R>], sign: &impl Fn(&R) -> Option<i8>) -> Ring {
    let first = pieces.first().map(jacobian);
    let corner =
        first.and_then(|form| form.corners().into_iter().find_map(|x| sign(x).filter(|s| *s != 0)));
    // Where J is negative at a corner, it is tried whether it is so everywhere.
    let side = corner.unwrap_or(1);
    let turned = |x: &R| sign(x).map(|found| found * side);
    let mut witnesses: [Option<RingPoint>; 2] = [None, None];
    let (mut all, mut most) = (true, 0);
    for piece in pieces {
        let found = signs(&jacobian(piece), &turned);
        all &= found.positive;
        most = most.max(found.bisections);
        for (known, place) in witnesses.iter_mut().zip(found.witnesses) {
            if known.is_none() {
                *known = place.map(|place| on_ring(piece, &place));
            }
        }
    }
    match witnesses {
        [Some(one), Some(other)] => {
            Ring::Folded { points: if side == 1 { [one, other] } else { [other, one] } }
        }
        _ if all => Ring::OneSign { sign: side, bisections: most },
        _ => Ring::Undecided,
    }
}

/// The place on the lattice of the refined points: the vertex, or the centre of the face, is the origin.
pub(super) fn on_ring<R>(piece: &Piece<R>, [u, v]: &Place) -> RingPoint {
    let side = Rational::from(i64::from(piece.direction));
    let along = |corner: i32, t: &Rational| Rational::from(i64::from(corner)) + &(&side * t);
    RingPoint { at: [along(piece.corner.0, u), along(piece.corner.1, v)] }
}

/// Whether p + q (around a face: p + cq) has one sign on the outer curve of sector 0, and is not 0 there: it is a
/// multiple of the real part of (p + qω)/e^{iπ/n}, or of p + qω.
pub(super) fn in_half_plane<R: Scalar>(
    net: &Net<R>,
    pieces: &[Piece<R>],
    sign: &impl Fn(&R) -> Option<i8>,
) -> bool {
    let curve = outer_curve(net, pieces);
    [1, -1].iter().any(|side| curve.iter().all(|x| sign(x) == Some(*side)))
}

/// The Bézier coefficients of the linear form of the half-plane on the outer curve of sector 0.
pub(super) fn outer_curve<R: Scalar>(net: &Net<R>, pieces: &[Piece<R>]) -> Vec<R> {
    let linear = |p: &R, q: &R| match net.lattice {
        Lattice::Dual => p.plus(&net.cosine.times(q)),
        _ => p.plus(q),
    };
    let mut coefficients = Vec::new();
    let last = 2 * net.start - 1;
    for piece in pieces {
        let [p, q] = &piece.coordinates;
        let (d, e) = p.degrees;
        let mut add = |i: usize, j: usize| coefficients.push(linear(&p.rows[i][j], &q.rows[i][j]));
        if net.lattice == Lattice::Triangle {
            // The outer sides are opposite to the first corners of upright triangles.
            if piece.direction == 1 && piece.corner.0 + piece.corner.1 == last {
                (0..=d).for_each(|i| add(i, d - i));
            }
            continue;
        }
        if piece.corner.0 == last {
            (0..=e).for_each(|j| add(d, j));
        }
        if piece.corner.1 == last {
            (0..=d).for_each(|i| add(i, e));
        }
    }
    coefficients
}
