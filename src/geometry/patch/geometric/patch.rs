//! Flat and bilinear parts of a mesh.

use super::super::number::{Vector as _, mean, squared};
use crate::mesh::Point;

/// What a face with more than three vertices is, where these are not in one plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum FaceSurface {
    /// A quadrilateral is bilinear between its vertices, and a face with five or more is a fan of
    /// triangles from its centroid.
    #[default]
    Bilinear,
    /// Every face with four vertices or more is a fan of triangles from its centroid.
    Fan,
}

impl FaceSurface {
    /// The name, as the command line has it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            FaceSurface::Bilinear => "bilinear",
            FaceSurface::Fan => "fan",
        }
    }

    /// Whether a face with so many vertices is bilinear.
    pub(super) fn is_bilinear(self, vertices: usize) -> bool {
        self == FaceSurface::Bilinear && vertices == 4
    }
}

pub(super) fn dot(p: &Point<f64>, q: &Point<f64>) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

pub(super) fn cross(p: &Point<f64>, q: &Point<f64>) -> Point<f64> {
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

pub(super) fn length(p: &Point<f64>) -> f64 {
    dot(p, p).sqrt()
}

/// The vector of length 1; `None` for that of length 0.
pub(super) fn unit(p: &Point<f64>) -> Option<Point<f64>> {
    let length = length(p);
    (length > 0.0).then(|| p.map(|x| x / length))
}

/// A ball around these points: their mean, and the greatest distance from it.
pub(super) fn ball(points: &[Point<f64>]) -> (Point<f64>, f64) {
    let centre = mean(points);
    let square = points.iter().map(|x| squared(x, &centre)).fold(0.0, f64::max);
    (centre, square.sqrt())
}

/// A part of a mesh: bilinear between four corners a, b, c, d in turn, or the flat triangle a, b, c
/// with d = c.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Patch {
    pub(super) corners: [Point<f64>; 4],
    flat: bool,
}

impl Patch {
    pub(super) fn triangle(a: Point<f64>, b: Point<f64>, c: Point<f64>) -> Patch {
        Patch { corners: [a, b, c, c], flat: true }
    }

    /// The patches between the corners of a part of a face: three, or four in turn, the third of which
    /// is the centroid.
    pub(crate) fn between(corners: &[Point<f64>], bilinear: bool) -> Vec<Patch> {
        match corners {
            [a, b, c, d] if bilinear => vec![Patch { corners: [*a, *b, *c, *d], flat: false }],
            [a, b, c, d] => vec![Patch::triangle(*a, *b, *c), Patch::triangle(*a, *c, *d)],
            [a, b, c] => vec![Patch::triangle(*a, *b, *c)],
            _ => Vec::new(),
        }
    }

    /// The corners without repetition.
    pub(super) fn corners(&self) -> &[Point<f64>] {
        &self.corners[..if self.flat { 3 } else { 4 }]
    }

    /// Four parts, of half the parameters.
    pub(super) fn parts(&self) -> [Patch; 4] {
        let [a, b, c, d] = self.corners;
        let half = |p: &Point<f64>, q: &Point<f64>| [0, 1, 2].map(|i| f64::midpoint(p[i], q[i]));
        let (ab, bc) = (half(&a, &b), half(&b, &c));
        if self.flat {
            let ca = half(&c, &a);
            return [(a, ab, ca), (ab, b, bc), (ca, bc, c), (bc, ca, ab)]
                .map(|(p, q, r)| Patch::triangle(p, q, r));
        }
        let (cd, da) = (half(&c, &d), half(&d, &a));
        let middle = half(&ab, &cd);
        let part = |corners| Patch { corners, flat: false };
        [[a, ab, middle, da], [ab, b, bc, middle], [middle, bc, c, cd], [da, middle, cd, d]]
            .map(part)
    }

    /// A normal of length 1, across both diagonals.
    pub(super) fn normal(&self) -> Option<Point<f64>> {
        let [a, b, c, d] = &self.corners;
        let other = if self.flat { c.minus(b) } else { d.minus(b) };
        unit(&cross(&c.minus(a), &other))
    }

    /// How far the hull of the corners may be from the patch: |a − b + c − d|/4 where it is bilinear.
    pub(super) fn warp(&self) -> f64 {
        if self.flat {
            return 0.0;
        }
        let [a, b, c, d] = &self.corners;
        length(&[0, 1, 2].map(|i| a[i] - b[i] + c[i] - d[i])) / 4.0
    }

    /// A point of the hull of the corners that is near `point`: the nearest one of the triangles a, b, c and
    /// a, c, d.
    pub(super) fn near(&self, point: &Point<f64>) -> Point<f64> {
        let [a, b, c, d] = &self.corners;
        let first = nearest_of_triangle(point, [a, b, c]);
        if self.flat {
            return first;
        }
        let second = nearest_of_triangle(point, [a, c, d]);
        if squared(&first, point) <= squared(&second, point) { first } else { second }
    }
}

/// The point of a triangle that is nearest to a point (Ericson 2005, Real-time collision detection,
/// 5.1.5). Nothing rests on it but how sharp bounds are.
fn nearest_of_triangle(p: &Point<f64>, [a, b, c]: [&Point<f64>; 3]) -> Point<f64> {
    let (ab, ac) = (b.minus(a), c.minus(a));
    let along = |from: &Point<f64>, way: &Point<f64>, t: f64| from.plus_times(way, &t);
    let (ap, bp, cp) = (p.minus(a), p.minus(b), p.minus(c));
    let (d1, d2) = (dot(&ab, &ap), dot(&ac, &ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return *a;
    }
    let (d3, d4) = (dot(&ab, &bp), dot(&ac, &bp));
    if d3 >= 0.0 && d4 <= d3 {
        return *b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return along(a, &ab, d1 / (d1 - d3));
    }
    let (d5, d6) = (dot(&ab, &cp), dot(&ac, &cp));
    if d6 >= 0.0 && d5 <= d6 {
        return *c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return along(a, &ac, d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return along(b, &c.minus(b), (d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let sum = va + vb + vc;
    if sum <= 0.0 {
        return *a;
    }
    let point = along(a, &ab, vb / sum);
    along(&point, &ac, vc / sum)
}
