//! The characteristic ring: its Jacobian, and the half-plane of its outer curve.

use super::bernstein::Form;
use super::family::Family;
use super::net::{Lattice, Net};
use super::pieces::{Piece, pieces};
use super::sign::{Place, signs};
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
    /// J > 0 on all of the closed ring, with this many bisections, and the outer curve is in the half-plane.
    Regular { bisections: usize },
    /// J > 0 at the first point and J < 0 at the second.
    Folded { points: [RingPoint; 2] },
    /// The sign of J is not decided.
    Undecided,
    /// J > 0, but the outer curve of a sector is not shown to be in a half-plane.
    NoHalfPlane,
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

pub(super) fn examined<R: Scalar>(
    family: Family,
    cosine: &R,
    value: &R,
    sign: &impl Fn(&R) -> Option<i8>,
) -> Ring {
    let net = family.eigenvector(cosine, value);
    let pieces = ring_pieces(&net, value);
    let mut witnesses: [Option<RingPoint>; 2] = [None, None];
    let (mut all, mut most) = (true, 0);
    for piece in &pieces {
        let found = signs(&jacobian(piece), sign);
        all &= found.positive;
        most = most.max(found.bisections);
        for (known, place) in witnesses.iter_mut().zip(found.witnesses) {
            if known.is_none() {
                *known = place.map(|place| on_ring(piece, &place));
            }
        }
    }
    match witnesses {
        [Some(positive), Some(negative)] => Ring::Folded { points: [positive, negative] },
        _ if !all => Ring::Undecided,
        _ if !in_half_plane(&net, &pieces, sign) => Ring::NoHalfPlane,
        _ => Ring::Regular { bisections: most },
    }
}

/// The place on the lattice of the refined points: the vertex, or the centre of the face, is the origin.
fn on_ring<R>(piece: &Piece<R>, [u, v]: &Place) -> RingPoint {
    let side = Rational::from(i64::from(piece.direction));
    let along = |corner: i32, t: &Rational| Rational::from(i64::from(corner)) + &(&side * t);
    RingPoint { at: [along(piece.corner.0, u), along(piece.corner.1, v)] }
}

/// Whether p + q (around a face: p + cq) is positive on the outer curve of sector 0: a multiple of the real
/// part of (p + qω)/e^{iπ/n}, or of p + qω.
pub(super) fn in_half_plane<R: Scalar>(
    net: &Net<R>,
    pieces: &[Piece<R>],
    sign: &impl Fn(&R) -> Option<i8>,
) -> bool {
    outer_curve(net, pieces).iter().all(|x| sign(x) == Some(1))
}

/// The Bézier coefficients of the linear form of the half-plane on the outer curve of sector 0.
pub(super) fn outer_curve<R: Scalar>(net: &Net<R>, pieces: &[Piece<R>]) -> Vec<R> {
    let linear = |p: &R, q: &R| match net.lattice {
        Lattice::Dual => p.plus(&net.cosine.times(q)),
        _ => p.plus(q),
    };
    let mut coefficients = Vec::new();
    for piece in pieces {
        let [p, q] = &piece.coordinates;
        let (d, e) = p.degrees;
        let mut add = |i: usize, j: usize| coefficients.push(linear(&p.rows[i][j], &q.rows[i][j]));
        if net.lattice == Lattice::Triangle {
            // The outer sides are opposite to the first corners; the middle triangle has none.
            if piece.direction == 1 {
                (0..=d).for_each(|i| add(i, d - i));
            }
            continue;
        }
        if piece.corner.0 == 1 {
            (0..=e).for_each(|j| add(d, j));
        }
        if piece.corner.1 == 1 {
            (0..=d).for_each(|i| add(i, e));
        }
    }
    coefficients
}
