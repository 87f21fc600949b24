//! The parts of a surface between the sharp edges at a vertex, and their tangents.

use super::super::crease::VertexMask;
use super::super::point::{Point, combination, difference, sum};
use super::super::polygon::PolygonMesh;
use super::super::star::Star;
use super::circle::cosine;
use super::missing::NoNormal;
use super::normal::{Normal, Tangents};
use crate::exact::{Rational, Real, RealCyclotomic, Scalar, common_conductor};

/// The most faces between two sharp edges that tangents are computed for.
const MAX_SECTOR: usize = 32;

/// The part of the surface at a vertex that lies between two sharp edges, or between the two ends of the
/// boundary.
#[derive(Clone, Debug, PartialEq)]
pub struct Sector {
    /// Its faces, counter-clockwise.
    pub faces: Vec<usize>,
    /// Two tangents of its limit: along the crease, towards its first edge, and across it, into the
    /// sector; at a corner along both edges. None where the refined points tend to no plane, and
    /// beyond 32 faces or in too large a field.
    pub tangents: Result<Tangents, NoNormal>,
}

impl Sector {
    /// The normal of its two tangents, or why there is none.
    ///
    /// # Errors
    /// When there are no tangents, or they are parallel.
    pub fn normal(&self) -> Result<Normal, NoNormal> {
        self.tangents.as_ref().map_err(|reason| *reason)?.normal().ok_or(NoNormal::Parallel)
    }
}

/// A number p + q√d, d known from elsewhere.
#[derive(Clone)]
struct Rooted {
    plain: RealCyclotomic,
    rooted: RealCyclotomic,
}

impl Rooted {
    fn plus(&self, other: &Rooted) -> Rooted {
        Rooted { plain: self.plain.plus(&other.plain), rooted: self.rooted.plus(&other.rooted) }
    }

    fn times(&self, other: &Rooted, d: &RealCyclotomic) -> Rooted {
        let both = self.rooted.times(&other.rooted).times(d);
        let plain = self.plain.times(&other.plain).plus(&both);
        let rooted = self.plain.times(&other.rooted).plus(&self.rooted.times(&other.plain));
        Rooted { plain, rooted }
    }

    /// 1/(p + q√d) = (p − q√d)/(p² − q²d).
    fn recip(&self, d: &RealCyclotomic) -> Rooted {
        let norm = self.plain.times(&self.plain).minus(&self.rooted.times(&self.rooted).times(d));
        let rooted = RealCyclotomic::zero().minus(&self.rooted);
        Rooted { plain: self.plain.over(&norm), rooted: rooted.over(&norm) }
    }

    fn number(value: RealCyclotomic) -> Rooted {
        Rooted { plain: value, rooted: RealCyclotomic::zero() }
    }
}

/// The points of a sector: e_0, …, e_k, and for Catmull–Clark the opposite vertices f_0, …, f_{k−1}.
struct SectorPoints<'a> {
    vertex: &'a Point<RealCyclotomic>,
    edges: Vec<&'a Point<RealCyclotomic>>,
    faces: Vec<&'a Point<RealCyclotomic>>,
}

fn whole(value: i64) -> RealCyclotomic {
    RealCyclotomic::from(value)
}

/// The sectors of a vertex on a crease or at a corner whose sharp edges are infinitely sharp.
/// `quadrilaterals` says whether the scheme is Catmull–Clark.
pub(super) fn sectors(
    mesh: &PolygonMesh<RealCyclotomic>,
    vertex: usize,
    star: &Star,
    mask: &VertexMask,
    quadrilaterals: bool,
) -> Vec<Sector> {
    let sharp = |place: &usize| mesh.tags().edge(mesh.connectivity(), star.edges[*place]).is_some();
    let sharp: Vec<usize> = (0..star.edges.len()).filter(sharp).collect();
    let n = star.faces.len();
    let ends = sharp.iter().zip(sharp.iter().skip(1)).map(|(&from, &to)| (from, to));
    let around = sharp.first().zip(sharp.last()).filter(|(a, b)| !star.boundary && a != b);
    let ends = ends.chain(around.map(|(&first, &last)| (last, first + n)));
    let points = mesh.points();
    let sector = |(from, to): (usize, usize)| {
        let count = to - from;
        let neighbour = |i: usize| &points[star.neighbours[i % star.neighbours.len()]];
        let opposite = |i: usize| {
            let face = &mesh.faces()[star.faces[i % n]];
            &points[face[(star.corners[i % n] + 2) % face.len()]]
        };
        let around = SectorPoints {
            vertex: &points[vertex],
            edges: (from..=to).map(neighbour).collect(),
            faces: (from..to).map(opposite).collect(),
        };
        let tangents = if count > MAX_SECTOR || !around.has_field() {
            Err(NoNormal::TooLarge)
        } else if *mask == VertexMask::Corner {
            around.at_corner(quadrilaterals).ok_or(NoNormal::Corner)
        } else {
            Ok(around.on_crease(quadrilaterals))
        };
        Sector { faces: (from..to).map(|i| star.faces[i % n]).collect(), tangents }
    };
    ends.map(sector).collect()
}

impl SectorPoints<'_> {
    /// Whether the points and cos(π/k) are in one field that is not too large.
    fn has_field(&self) -> bool {
        let points = self.edges.iter().chain(&self.faces).copied().chain([self.vertex]);
        let sine = u32::try_from(2 * self.faces.len()).unwrap_or(u32::MAX);
        let conductors = points.flatten().map(RealCyclotomic::conductor);
        let mut common = Ok(sine);
        for conductor in conductors.filter(|conductor| *conductor > 1) {
            common = common.and_then(|common| common_conductor(common, conductor));
        }
        common.is_ok()
    }

    /// At a corner the vertex stays, and each sharp edge is halved: e_0 − v and e_k − v are tangents for
    /// 1/2. They decide where all other eigenvalues are smaller: for one quadrilateral, and for
    /// one or two triangles. For more faces, inner edges are multiplied by (4 + A)/16 or 3/8 + cos(π/k)/4,
    /// which is 1/2 or more.
    fn at_corner(&self, quadrilaterals: bool) -> Option<Tangents> {
        let k = self.faces.len();
        let most = if quadrilaterals { 1 } else { 2 };
        let side = |i: usize| difference(self.edges[i], self.vertex);
        (k <= most).then(|| Tangents::plain([side(0), side(k)]))
    }

    fn on_crease(&self, quadrilaterals: bool) -> Tangents {
        let k = self.faces.len();
        let ends = sum([self.edges[0], self.edges[k]]);
        let along = difference(self.edges[0], self.edges[k]);
        if k == 1 {
            // For Catmull–Clark, 1/4 has a Jordan block, and this is what its powers tend to.
            let twice = sum([self.vertex, self.vertex]);
            return Tangents::plain([along, difference(&ends, &twice)]);
        }
        let c = cosine(1, 2 * k);
        let sines = sines(k, &c);
        let inner = combination(sines.iter().zip(&self.edges).map(|(u, e)| (u, *e)));
        // Σ sin(πi/k)/sin(π/k).
        let total = whole(1).over(&whole(1).minus(&c));
        if !quadrilaterals {
            let [a, b] = loop_weights(&c, &total);
            let across = combination([(&a, self.vertex), (&b, &ends), (&whole(1), &inner)]);
            return Tangents::plain([along, across]);
        }
        let pairs: Vec<RealCyclotomic> = (0..k).map(|i| sines[i].plus(&sines[i + 1])).collect();
        let faces = combination(pairs.iter().zip(&self.faces).map(|(u, f)| (u, *f)));
        let radicand = c.plus(&whole(1)).times(&c.plus(&whole(9)));
        // √d = 3 for k = 2.
        let factor = if k == 2 {
            Rooted::number(whole(4))
        } else {
            Rooted { plain: c.plus(&whole(1)), rooted: whole(1) }
        };
        let [a, b] = catmull_clark_weights(&factor, &total, &radicand);
        let one = whole(1);
        let part = |a: &RealCyclotomic, b: &RealCyclotomic, factor: &RealCyclotomic| {
            combination([(a, self.vertex), (b, &ends), (factor, &inner)])
        };
        let plain = part(&a.plain, &b.plain, &factor.plain);
        let plain = combination([(&one, &plain), (&one, &faces)]);
        if k == 2 {
            return Tangents::plain([along, plain]);
        }
        let zero = difference(self.vertex, self.vertex);
        let rooted = part(&a.rooted, &b.rooted, &factor.rooted);
        Tangents::with_root([along, plain], [zero, rooted], radicand)
    }
}

/// sin(πi/k)/sin(π/k) for i = 0, …, k, with c = cos(π/k).
fn sines(k: usize, c: &RealCyclotomic) -> Vec<RealCyclotomic> {
    let mut sines = vec![whole(0), whole(1)];
    for i in 2..=k {
        let next = c.times(&sines[i - 1]).times(&whole(2)).minus(&sines[i - 2]);
        sines.push(next);
    }
    sines
}

/// Loop: the weights a of v, and b of e_0 and e_k, that go with Σ sin(πi/k) e_i in a left eigenvector for
/// λ = 3/8 + c/4. Its columns v and e_0 are
/// (λ − 3/4) a − b = 3/8 Σ sin(πi/k) and (λ − 1/2) b − a/8 = sin(π/k)/8.
fn loop_weights(c: &RealCyclotomic, total: &RealCyclotomic) -> [RealCyclotomic; 2] {
    let part = |p: i64, q: i64| RealCyclotomic::from(Rational::new(p, q));
    let left = c.times(c).times(&part(1, 2)).minus(c).minus(&part(5, 8));
    let right = total.times(&part(3, 8)).plus(&c.times(&part(1, 4))).minus(&part(3, 8));
    let b = right.over(&left);
    let a = c.times(&whole(2)).minus(&whole(1)).times(&b).minus(&whole(1));
    [a, b]
}

/// Catmull–Clark: the same with A Σ sin(πi/k) e_i + Σ (sin(πi/k) + sin(π(i + 1)/k)) f_i and
/// λ = (4 + A)/16. Its columns v and e_0 are
/// (λ − 3/4) a − b = (3A/8 + 1/2) Σ sin(πi/k) and (λ − 1/2) b − a/8 = λ sin(π/k), so that
/// b = (4S(3A + 4) + (A + 4)(A − 8))/(A(A − 12)) and a = ((A − 4) b − (A + 4))/2.
fn catmull_clark_weights(
    factor: &Rooted,
    total: &RealCyclotomic,
    d: &RealCyclotomic,
) -> [Rooted; 2] {
    let number = |value: i64| Rooted::number(whole(value));
    let add = |value: i64| factor.plus(&number(value));
    let four_s = Rooted::number(total.times(&whole(4)));
    let three = factor.times(&number(3), d).plus(&number(4));
    let above = four_s.times(&three, d).plus(&add(4).times(&add(-8), d));
    let below = factor.times(&add(-12), d);
    let b = above.times(&below.recip(d), d);
    let twice = add(-4).times(&b, d).plus(&add(4).times(&number(-1), d));
    let half = Rooted::number(RealCyclotomic::from(Rational::new(1, 2)));
    [twice.times(&half, d), b]
}
