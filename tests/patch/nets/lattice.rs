//! How far nets are from the limits of masks on Z².

use super::{depth, distances};
use crate::common::r;
use crate::net::{CLOSED, bumpy, heights, nets, scheme};
use proptest::prelude::*;
use std::collections::HashMap;
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::lattice::{Between, limit_values, natural_shift};
use subcert::net::Net;
use subcert::patch::LatticeNetDistances;
use subcert::scheme::{LatticeMask, parse_lattice};

fn mask(text: &str) -> LatticeMask {
    parse_lattice(text).expect("a mask")
}

/// Another way: the limit at points of a later level by the limit stencil, in f64, of a net that is closed in both directions.
struct Naive<'a> {
    net: &'a Net,
    matrix: [[f64; 2]; 2],
    rule: Vec<([i64; 2], f64)>,
    limit: Vec<([i64; 2], f64)>,
    shift: [f64; 2],
    points: HashMap<(u32, [i64; 2]), [f64; 3]>,
    mask: &'a LatticeMask,
}

impl<'a> Naive<'a> {
    fn new(net: &'a Net, mask: &'a LatticeMask) -> Naive<'a> {
        let f64s = |(at, c): (&[i64; 3], &Rational)| ([at[0], at[1]], nearest(c));
        let rows: Vec<&[i64]> = mask.dilation().rows().collect();
        #[allow(clippy::cast_precision_loss)] // Small integers.
        let matrix = [0, 1].map(|i| [0, 1].map(|j| rows[i][j] as f64));
        let limit = limit_values(mask, 0).expect("few").expect("convergent");
        let shift = natural_shift(mask);
        Naive {
            net,
            matrix,
            rule: mask.coefficients().iter().map(f64s).collect(),
            limit: limit.iter().map(f64s).collect(),
            shift: [nearest(&shift[0]), nearest(&shift[1])],
            points: HashMap::new(),
            mask,
        }
    }

    fn point(&mut self, level: u32, at: [i64; 2]) -> [f64; 3] {
        if level == 0 {
            let [rows, columns] = self.net.sizes().map(|n| i64::try_from(n).expect("small"));
            let place = at[0].rem_euclid(rows) * columns + at[1].rem_euclid(columns);
            let point = &self.net.points()[usize::try_from(place).expect("positive")];
            return [0, 1, 2].map(|c| nearest(&point[c]));
        }
        if let Some(known) = self.points.get(&(level, at)) {
            return *known;
        }
        let mut sum = [0.0; 3];
        for ([i, j], c) in self.rule.clone() {
            let Some(before) = self.mask.dilation().divided([at[0] - i, at[1] - j, 0]) else {
                continue;
            };
            let point = self.point(level - 1, [before[0], before[1]]);
            sum = [0, 1, 2].map(|k| sum[k] + c * point[k]);
        }
        self.points.insert((level, at), sum);
        sum
    }

    fn limit(&mut self, level: u32, at: [i64; 2]) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for ([i, j], c) in self.limit.clone() {
            let point = self.point(level, [at[0] - i, at[1] - j]);
            sum = [0, 1, 2].map(|k| sum[k] + c * point[k]);
        }
        sum
    }

    /// The net of a level at a place, linear on triangles with sides (1, 1) or (1, −1), or linear in each coordinate.
    fn net(&mut self, level: u32, [x, y]: [f64; 2], between: Between) -> [f64; 3] {
        let [i, j] = [x.floor(), y.floor()];
        let (u, v) = (x - i, y - j);
        #[allow(clippy::cast_possible_truncation)] // Small integers.
        let (i, j) = (i as i64, j as i64);
        let weights = match between {
            Between::Boxes => [(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v],
            Between::Triangles if u > v => [1.0 - u, u - v, 0.0, v],
            Between::Triangles => [1.0 - v, 0.0, v - u, u],
            Between::OtherTriangles if u + v < 1.0 => [1.0 - u - v, u, v, 0.0],
            Between::OtherTriangles => [0.0, 1.0 - v, 1.0 - u, u + v - 1.0],
        };
        let corners = [[i, j], [i + 1, j], [i, j + 1], [i + 1, j + 1]];
        let points = corners.map(|at| self.point(level, at));
        [0, 1, 2].map(|c| (0..4).map(|k| weights[k] * points[k][c]).sum())
    }

    /// The greatest distance of level `level` from the limit, at the points of so many levels later that are near the first points of the net.
    fn apart(&mut self, level: u32, later: u32, between: Between) -> f64 {
        let mut most = 0.0_f64;
        let side = 3 * 2_i64.pow(level + later);
        for (i, j) in (-side..2 * side).flat_map(|i| (-side..2 * side).map(move |j| (i, j))) {
            let limit = self.limit(level + later, [i, j]);
            #[allow(clippy::cast_precision_loss)] // Small integers.
            let mut place = [i as f64, j as f64];
            let [[a, b], [c, d]] = self.matrix;
            for _ in 0..later {
                let scale = 1.0 / (a * d - b * c);
                place =
                    [(d * place[0] - b * place[1]) * scale, (a * place[1] - c * place[0]) * scale];
            }
            let on_net =
                self.net(level, [place[0] - self.shift[0], place[1] - self.shift[1]], between);
            let apart = [0, 1, 2].map(|c| limit[c] - on_net[c]);
            most = most.max(super::length(apart));
        }
        most
    }
}

#[test]
fn bounds_are_around_samples() {
    let net = bumpy(4, 4, CLOSED[3]);
    let cases = [
        ("loop-regular", Between::Triangles),
        ("butterfly-regular:w=1/16", Between::Triangles),
        ("chaikin x b-spline:degree=3", Between::Boxes),
        ("sqrt3-regular", Between::OtherTriangles),
        ("quincunx-box-spline", Between::Triangles),
    ];
    for (name, between) in cases {
        let mask = mask(name);
        let distances = LatticeNetDistances::new(&net, &mask).expect(name);
        let mut naive = Naive::new(&net, &mask);
        for level in 0..2 {
            let sampled = naive.apart(level, 2, between);
            let [least, most] = distances.distance(level);
            assert!(
                least <= most && sampled <= most * (1.0 + 1e-9),
                "{name}, level {level}: {sampled} {most}"
            );
            // The greatest distance is near some of the samples.
            assert!(least <= sampled * 1.25, "{name}, level {level}: {least} {sampled}");
            assert!(most <= sampled * 1.5, "{name}, level {level}: {most} {sampled}");
        }
    }
}

proptest! {
    #![proptest_config(crate::common::cases(6))]

    /// The bounds of products are around those of the fast path, and so are the depths.
    #[test]
    fn products_are_as_those_of_curves(net in nets(6, 6), which in 0_usize..3) {
        let name = ["b-spline:degree=3", "chaikin x b-spline:degree=3", "four-point:w=1/16 x chaikin"][which];
        let typed = if which == 0 { "b-spline:degree=3 x b-spline:degree=3" } else { name };
        let tolerance = r(1, 2);
        let expected = depth(&net, &scheme(name), &tolerance);
        let other = distances(&net, &scheme(name)).without_apart();
        let found = LatticeNetDistances::new(&net, &mask(typed)).expect("a net");
        let depth = found.depth(&tolerance).expect("a depth");
        prop_assert!(depth.too_few.is_none_or(|few| few < expected.level));
        prop_assert!(expected.too_few.is_none_or(|few| few < depth.level));
        for level in 0..3 {
            let ([a, b], [c, d]) = (found.distance(level), other.distance(level));
            prop_assert!(a <= d && c <= b, "{level}: {a} {b}, {c} {d}");
        }
    }
}

/// x² − xy + y² is as much above its interpolants as Loop's limit is above its points.
#[test]
fn a_paraboloid_by_thirds() {
    let height = |i: usize, j: usize| {
        let [x, y] = [i, j].map(|n| Rational::from(i64::try_from(n).expect("small")));
        &x * &x - &x * &y + &y * &y
    };
    let net = heights(7, 7, height);
    let distances = LatticeNetDistances::new(&net, &mask("loop-regular")).expect("a net");
    for level in 0..4 {
        let [least, most] = distances.distance(level);
        let exact = 0.5 / f64::from(1 << (2 * level));
        assert!(least <= exact && exact <= most, "{level}: {least} {most}");
        assert!((exact - least) < 1e-9, "{least} is attained at a point");
    }
    let depth = distances.depth(&r(1, 128)).expect("a depth");
    assert_eq!(depth.too_few, Some(2));
    let worst = distances.depth(&r(1, 100)).expect("a depth").worst.expect("it is above 0");
    let apart = [0, 1, 2].map(|c| worst.on_mesh[c] - worst.on_limit[c]);
    assert!((super::length(apart) - 1.0 / 128.0).abs() < 1e-3);
}

/// A mirrored square lattice has the limits of the unmirrored one; turned ones keep their faces on closed nets, also where squares of a level lie on two of them.
#[test]
fn other_dilations_see_all_faces() {
    let spike = heights(12, 12, |i, j| r(if (i, j) == (2, 2) { 8 } else { 0 }, 1));
    for matrix in ["[[2,0],[0,2]]", "[[-2,0],[0,2]]", "[[0,2],[2,0]]", "[[0,2],[-2,0]]"] {
        let mask = mask(&format!("(1+x)^3*(1+y)^3/16:dilation={matrix}"));
        let distances = LatticeNetDistances::new(&spike, &mask).expect(matrix);
        assert_eq!(distances.compared(), 81, "{matrix}");
        assert_eq!(distances.depth(&r(1, 10)).expect(matrix).too_few, Some(2), "{matrix}");
    }
    // Two steps of a quincunx lattice are 2I.
    let quincunx = LatticeNetDistances::new(&spike, &mask("quincunx-five-point")).expect("a net");
    assert_eq!(quincunx.compared(), 81);
    // Far from their faces squares belong to two of them, and the greatest distance is there.
    let rows = [-5, -1, 0, -7];
    let points = (0..12).map(|k| [0, 0, rows[k / 3]].map(Rational::from)).collect();
    let net = Net::new(points, 3, CLOSED[3]).expect("a net");
    let symbol = "(1+x+x^2+x^3+x^4)^2*(x+1/4*x^2-1/4*x^3-1/2*x^4+1/2*x^5)*(1+y)^2/10";
    for matrix in ["[[-5,0],[0,2]]", "[[-5,0],[1,2]]"] {
        let mask = mask(&format!("{symbol}:dilation={matrix}"));
        let distances = LatticeNetDistances::new(&net, &mask).expect(matrix);
        let [least, most] = distances.distance(2);
        let of_faces = distances.faces(2).into_iter().map(|[least, _]| least).fold(0.0, f64::max);
        assert!(
            least <= most && of_faces <= most * (1.0 + 1e-9),
            "{matrix}: {least} {most} {of_faces}"
        );
        let depth = distances.depth(&r(27, 1000)).expect(matrix);
        assert!(depth.distance[0] <= depth.distance[1], "{matrix}: {:?}", depth.distance);
    }
}

/// Where all is linear, nothing is apart, whatever the unit.
#[test]
fn what_is_linear_is_its_own_limit() {
    let huge = Rational::from(2).pow(800);
    let net =
        heights(6, 6, |i, j| &huge * &Rational::from(i64::try_from(2 * i + 3 * j).expect("small")));
    for name in ["loop-regular", "butterfly-regular:w=1/16", "zwart-powell"] {
        let distances = LatticeNetDistances::new(&net, &mask(name)).expect(name);
        let depth = distances.depth(&r(1, 1_000_000)).expect(name);
        assert_eq!((depth.level, depth.distance[0].to_bits()), (0, 0), "{name}");
    }
}

#[test]
fn what_has_no_distance_is_refused() {
    let net = bumpy(6, 6, CLOSED[3]);
    let error = |net: &Net, text: &str| match LatticeNetDistances::new(net, &mask(text)) {
        Ok(_) => panic!("{text} has a distance"),
        Err(error) => error.to_string(),
    };
    assert!(error(&net, "trilinear").contains("three variables"));
    assert!(error(&net, "butterfly-regular:w=4").contains("not shown to contract"));
    assert!(error(&bumpy(3, 6, CLOSED[0]), "loop-regular").contains("3 rows"));
    let distances = LatticeNetDistances::new(&net, &mask("loop-regular")).expect("a net");
    for tolerance in [r(0, 1), r(-1, 2)] {
        assert!(distances.depth(&tolerance).is_err());
        assert!(distances.a_priori(&tolerance).is_err());
    }
}
