//! The winding number of the outer curve of a ring around the image of the vertex or of the centre of the face.

use super::ball::Ball;
use super::net::{Lattice, Net, Point, ratio};
use super::pieces::Piece;
use crate::exact::{Rational, Scalar as _};

/// The most bisections of a part of the curve.
const MAX_BISECTIONS: usize = 16;

/// The winding number of the outer curve of a net of block k, n > 2k; `None` where the curve is not shown to avoid
/// the origin.
///
/// On a sector the argument changes by 2πk/n + 2πm, where m counts how often the curve crosses the ray opposite to
/// a point between its ends: the number is k + nm. A part of the curve with all its Bézier points in an open half-plane
/// crosses the ray as the line between its ends does.
pub(super) fn winding(net: &Net<Ball>, pieces: &[Piece<Ball>], k: usize, n: usize) -> Option<i64> {
    let parts = parts(net, pieces);
    let first = parts.first()?.first()?;
    let middle = {
        // 5z + 3ωz: the line through it has no corner of a piece by symmetry.
        let [p, q] = first;
        let of = |n: i64, x: &Ball| x.times(&ratio(n, 1));
        let turned = p.plus(&net.cosine.plus(&net.cosine).times(q));
        [of(5, p).minus(&of(3, q)), of(5, q).plus(&of(3, &turned))]
    };
    let mut crossings = 0;
    for part in parts {
        crossings += crossed(&net.cosine, &middle, part, MAX_BISECTIONS)?;
    }
    let (k, n) = (i64::try_from(k).ok()?, i64::try_from(n).ok()?);
    Some(k + n * crossings)
}

/// The Bézier points of the outer curve of sector 0, from its beginning to its end.
fn parts(net: &Net<Ball>, pieces: &[Piece<Ball>]) -> Vec<Vec<Point<Ball>>> {
    let mut parts = Vec::new();
    let at = |piece: &Piece<Ball>, i: usize, j: usize| {
        piece.coordinates.each_ref().map(|form| form.rows[i][j].clone())
    };
    let last = 2 * net.start - 1;
    for piece in pieces {
        let (d, e) = piece.coordinates[0].degrees;
        if net.lattice == Lattice::Triangle {
            if piece.direction == 1 && piece.corner.0 + piece.corner.1 == last {
                parts.push((0..=d).map(|j| at(piece, d - j, j)).collect());
            }
            continue;
        }
        if piece.corner.0 == last {
            parts.push((0..=e).map(|j| at(piece, d, j)).collect());
        }
        if piece.corner.1 == last {
            parts.push((0..=d).rev().map(|i| at(piece, i, e)).collect());
        }
    }
    parts
}

/// The real part of the product of a point with the conjugate of another.
fn dot(cosine: &Ball, [p, q]: &Point<Ball>, [s, t]: &Point<Ball>) -> Ball {
    p.times(s).plus(&q.times(t)).plus(&cosine.times(&p.times(t).plus(&q.times(s))))
}

/// How often a part crosses the ray opposite to `middle` counterclockwise, less how often clockwise.
fn crossed(
    cosine: &Ball,
    middle: &Point<Ball>,
    part: Vec<Point<Ball>>,
    left: usize,
) -> Option<i64> {
    let [first, .., last] = &part[..] else { return Some(0) };
    let towards = [first[0].plus(&last[0]), first[1].plus(&last[1])];
    if part.iter().all(|point| dot(cosine, &towards, point).sign() == Some(1)) {
        let side = |[p, q]: &Point<Ball>| middle[0].times(q).minus(&middle[1].times(p));
        let (before, after) = (side(first), side(last));
        let signs = [before.sign()?, after.sign()?];
        if signs[0] == 0 || signs[1] == 0 {
            return None;
        }
        if signs[0] == signs[1] {
            return Some(0);
        }
        // Where the line between the ends meets the line through `middle`, up to a positive factor.
        let meet = [0, 1].map(|i| first[i].times(&after).minus(&last[i].times(&before)));
        let ahead = dot(cosine, middle, &meet).sign()? * signs[1];
        return Some(if ahead > 0 { 0 } else { i64::from(signs[0]) });
    }
    if left == 0 {
        return None;
    }
    let half = Ball::from_rational(&Rational::new(1, 2));
    let (mut rest, mut low, mut high) = (part, Vec::new(), Vec::new());
    while let (Some(first), Some(last)) = (rest.first(), rest.last()) {
        low.push(first.clone());
        high.push(last.clone());
        let between =
            |pair: &[Point<Ball>]| [0, 1].map(|i| pair[0][i].plus(&pair[1][i]).times(&half));
        rest = rest.windows(2).map(between).collect();
    }
    high.reverse();
    Some(crossed(cosine, middle, low, left - 1)? + crossed(cosine, middle, high, left - 1)?)
}
