//! The schemes, and the eigenvectors of blocks 1 and 0 on their wider rings.

use super::net::{Lattice, Net, Point, ratio};
use crate::exact::Scalar;
use crate::scheme::catalogue;
use std::collections::BTreeMap;

/// A regular part with the rules next to the vertex or face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Bicubic B-splines around a vertex, as Catmull–Clark.
    Bicubic,
    /// Quartic box splines around a vertex, as Loop.
    BoxSpline,
    /// Biquadratic B-splines around a face, as Doo–Sabin.
    Biquadratic,
}

impl Family {
    /// The family of a ring with these orbits: their names declare the regular part.
    #[must_use]
    pub fn of_orbits(names: &[&str]) -> Option<Family> {
        match names {
            ["vertex", "edge", "face"] => Some(Family::Bicubic),
            ["vertex", "edge"] => Some(Family::BoxSpline),
            ["face"] => Some(Family::Biquadratic),
            _ => None,
        }
    }

    /// Its name: `bicubic`, `box-spline` or `biquadratic`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Family::Bicubic => "bicubic",
            Family::BoxSpline => "box-spline",
            Family::Biquadratic => "biquadratic",
        }
    }

    /// The family of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Family> {
        let all = [Family::Bicubic, Family::BoxSpline, Family::Biquadratic];
        all.into_iter().find(|family| family.name() == name)
    }

    /// The scheme of the catalogue that is the model of this regular part.
    ///
    /// # Panics
    /// Never: the catalogue has a model of each.
    #[must_use]
    pub fn scheme(self) -> &'static str {
        let model = catalogue().iter().find(|one| one.facts.model.as_deref() == Some(self.name()));
        &model.expect("a model in the catalogue").name
    }

    /// The valence at which the surfaces are those of the regular part, if these are C²: bicubic splines, and quartic box splines.
    #[must_use]
    pub fn smooth_valence(self) -> Option<usize> {
        match self {
            Family::Bicubic => Some(4),
            Family::BoxSpline => Some(6),
            Family::Biquadratic => None,
        }
    }

    /// The pieces of the ring, in words.
    #[must_use]
    pub fn pieces(self) -> &'static str {
        match self {
            Family::Bicubic => "3 bicubic pieces in each sector",
            Family::BoxSpline => "3 quartic box-spline pieces in each sector",
            Family::Biquadratic => "3 biquadratic pieces in each sector",
        }
    }

    pub(super) fn lattice(self) -> Lattice {
        match self {
            Family::Bicubic => Lattice::Primal,
            Family::BoxSpline => Lattice::Triangle,
            Family::Biquadratic => Lattice::Dual,
        }
    }

    /// The net of an eigenvector with these values at the vertex, at an edge point, and at a face point of the
    /// sector divided by 1 + ω; around a face, at its point. The eigenvalue is none of the points around it.
    /// They are multiplied by a polynomial in it.
    pub(super) fn net<R: Scalar>(self, cosine: &R, value: &R, inner: &[R; 3]) -> Net<R> {
        let [vertex, edge, _] = inner;
        let points = match self {
            Family::Bicubic => bicubic(cosine, value, inner),
            Family::BoxSpline => box_spline(cosine, value, &[vertex.clone(), edge.clone()]),
            Family::Biquadratic => biquadratic(cosine, value),
        };
        Net { lattice: self.lattice(), cosine: cosine.clone(), points, start: 1 }
    }

    /// The eigenvector of block 1 for its eigenvalue λ by the rules of the scheme of the catalogue, times a
    /// polynomial in λ that is positive for λ > 1/4.
    pub(super) fn eigenvector<R: Scalar>(self, cosine: &R, value: &R) -> Net<R> {
        let one = || ratio::<R>(1, 1);
        let edge = match self {
            Family::Bicubic => ratio::<R>(4, 1).times(value).minus(&one()),
            _ => one(),
        };
        self.net(cosine, value, &[R::zero(), edge, one()])
    }
}

type Points<R> = BTreeMap<(i32, i32), Point<R>>;

/// vertex V, edge E and face F(1 + ω); times (x − 1/16)(x − 1/8)(x − 1/32)(x − 1/64).
fn bicubic<R: Scalar>(cosine: &R, value: &R, [vertex, edge, face]: &[R; 3]) -> Points<R> {
    let less = |p, q| value.minus(&ratio(p, q));
    let of = |p, q, x: &R| x.times(&ratio(p, q));
    let (m, k) = (less(1, 16), less(1, 64));
    let d = less(1, 8).times(&less(1, 32));
    // left = (p + qω)/(x − 1/16), without its part of outer in p.
    let p = of(1, 16, vertex).plus(&of(3, 8, edge)).plus(&of(3, 8, face));
    let q = of(1, 16, edge).plus(&of(3, 8, face));
    let near = of(3, 32, vertex)
        .plus(&of(9, 16, edge))
        .plus(&of(1, 32, &cosine.times(edge)))
        .plus(&of(3, 16, &face.plus(&cosine.times(face))));
    let outer = m.times(&near).plus(&of(1, 32, &p.plus(&cosine.times(&q))));
    let [p, q] = [d.times(&p).plus(&of(1, 16, &outer)), d.times(&q)];
    let s = m.times(&d);
    let corner = of(1, 128, vertex)
        .plus(&of(3, 32, edge))
        .plus(&of(9, 16, face))
        .times(&s)
        .plus(&of(1, 64, &m.times(&outer)))
        .plus(&of(3, 32, &p.plus(&q)));
    let s = s.times(&k);
    let zero = R::zero();
    [
        ((0, 0), [vertex.times(&s), zero.clone()]),
        ((1, 0), [edge.times(&s), zero.clone()]),
        ((1, 1), [face.times(&s), face.times(&s)]),
        ((2, 0), [m.times(&k).times(&outer), zero]),
        ((2, 1), [k.times(&p), k.times(&q)]),
        ((1, 2), [k.times(&q), k.times(&p)]),
        ((2, 2), [corner.clone(), corner]),
    ]
    .into()
}

/// vertex V and edge E; times (x − 1/8)(x − 1/16).
fn box_spline<R: Scalar>(cosine: &R, value: &R, [vertex, edge]: &[R; 2]) -> Points<R> {
    let less = |p, q| value.minus(&ratio(p, q));
    let of = |p, q, x: &R| x.times(&ratio(p, q));
    let s = less(1, 8).times(&less(1, 16));
    let corner = of(1, 16, vertex).plus(&of(3, 8, edge));
    let near = of(1, 16, vertex).plus(&of(5, 8, edge)).plus(&of(1, 8, &cosine.times(edge)));
    let outer = less(1, 8).times(&near).plus(&of(1, 8, &corner.plus(&cosine.times(&corner))));
    let corner = less(1, 16).times(&corner);
    let zero = R::zero();
    [
        ((0, 0), [vertex.times(&s), zero.clone()]),
        ((1, 0), [edge.times(&s), zero.clone()]),
        ((2, 0), [outer, zero]),
        ((1, 1), [corner.clone(), corner]),
    ]
    .into()
}

/// face 1; times (x − 1/4)(x − 1/8)(x − 1/16).
fn biquadratic<R: Scalar>(cosine: &R, value: &R) -> Points<R> {
    let less = |p, q| value.minus(&ratio(p, q));
    let of = |p, q, x: &R| x.times(&ratio(p, q));
    let k = less(1, 16);
    let d = less(1, 4).times(&less(1, 8));
    let p = of(9, 16, &less(3, 16)).plus(&ratio(3, 256));
    let q = of(3, 16, &less(3, 16)).plus(&ratio(9, 256));
    let corner = of(9, 16, &d).plus(&of(3, 8, &p.plus(&cosine.times(&q))));
    let zero = R::zero();
    let (p, q) = (k.times(&p), k.times(&q));
    [
        ((0, 0), [d.times(&k), zero.clone()]),
        ((0, 1), [p.clone(), q.clone()]),
        // right of the sector before: the mirror image of left, p + q/ω.
        ((1, 0), [p.plus(&ratio::<R>(2, 1).times(&cosine.times(&q))), zero.minus(&q)]),
        ((1, 1), [corner, zero]),
    ]
    .into()
}
