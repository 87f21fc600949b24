//! The distance of control polygons from their limits as sets of points, against dense samples.

use crate::common::r;
use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::limit::{Limit, natural_shift};
use subcert::patch::{CurveDepth, CurveSets, SetKind};
use subcert::scheme::{Mask, parse_scheme};

/// One list for each coordinate.
type Coordinates = Vec<Vec<Rational>>;

fn mask(scheme: &str) -> Mask {
    parse_scheme(scheme).expect("a scheme").masks()[0].clone()
}

fn sets(mask: &Mask, points: &Coordinates, closed: bool) -> CurveSets {
    CurveSets::new(&Limit::new(mask).expect("it converges"), points, closed).expect("enough points")
}

fn depth(scheme: &str, points: &Coordinates, closed: bool, tolerance: &Rational) -> CurveDepth {
    sets(&mask(scheme), points, closed).depth(tolerance).expect("few levels")
}

fn square() -> Coordinates {
    [[0, 4, 4, 0], [0, 0, 4, 4]].map(|own| own.map(Rational::from).to_vec()).to_vec()
}

/// The corner of a quadratic B-spline curve of a square with sides of length 4 is at (1/2, 1/2), that of the cubic
/// one at (2/3, 2/3): the distances are √2/2 and 2√2/3. A polygon of the four-point scheme on a line is in its limit.
#[test]
fn distances_by_hand() {
    for (scheme, above, below) in [
        ("chaikin", r(70_711, 100_000), r(70_710, 100_000)),
        ("b-spline:degree=3", r(94_281, 100_000), r(94_280, 100_000)),
    ] {
        let enough = depth(scheme, &square(), true, &above);
        assert_eq!((enough.level, enough.too_few), (Some(0), None), "{scheme}");
        let more = depth(scheme, &square(), true, &below);
        assert_eq!((more.level, more.too_few), (Some(1), Some(0)), "{scheme}");
        let place = more.beyond.expect("a point that is far");
        assert_eq!(place.from, SetKind::Mesh);
        let error = (place.distance - nearest(&above)).abs();
        assert!(error < 2e-5 && place.point.iter().all(|x| *x == 0.0 || (*x - 4.0).abs() < 1e-12));
    }
    let line = vec![(0..9).map(Rational::from).collect(), vec![r(1, 3); 9]];
    let on_line = depth("four-point", &line, false, &r(1, 100_000));
    assert_eq!((on_line.level, on_line.too_few), (Some(0), None));
}

/// Absolute coefficients of a rule add up to 2, and those of its powers to a bounded number: rounding of points of late
/// levels stays small.
#[test]
fn rounding_does_not_grow_with_the_level() {
    let own = [[0, 4, 5, 3, 1, -1], [0, 0, 2, 4, 3, 2]].map(|own| own.map(Rational::from).to_vec());
    for (tolerance, level) in [(r(1, 10), 5), (r(1, 1_000), 13)] {
        let found = depth("wavelet-9-3", &own.to_vec(), true, &tolerance);
        assert_eq!((found.level, found.too_few), (Some(level), Some(level - 1)), "{tolerance}");
    }
}

/// Points and natural parameters of a level, refined naively.
struct Naive {
    points: Vec<[f64; 3]>,
    parameters: Vec<f64>,
}

impl Naive {
    fn new(mask: &Mask, control: &Coordinates, closed: bool, level: u32) -> Naive {
        let rules = mask.rules().map(nearest);
        let mut own: Vec<Vec<f64>> =
            control.iter().map(|own| own.iter().map(nearest).collect()).collect();
        let (mut first, arity) = (0, i64::try_from(mask.arity()).expect("small"));
        if !closed {
            // On what is compared, nothing depends on points beyond the ends.
            first = -12;
            for own in &mut own {
                let (start, end) = (own[0], own[own.len() - 1]);
                *own = [vec![start; 12], own.clone(), vec![end; 12]].concat();
            }
        }
        let mut scale = 1.0;
        for _ in 0..level {
            let refined = |own: &Vec<f64>| {
                if closed { rules.refine_closed(own) } else { rules.refine_open(own) }
            };
            own = own.iter().map(refined).collect();
            let start = rules.open_range(0).start;
            first = if closed { 0 } else { arity * (first - mask.offset()) + start };
            scale *= f64::from(u32::try_from(arity).expect("small"));
        }
        let shift = nearest(&natural_shift(mask).shift);
        let point = |i: usize| [own[0][i], own[1][i], own[2][i]];
        let at = |i: usize| {
            let index = first + i64::try_from(i).expect("few points");
            (f64::from(i32::try_from(index).expect("small")) + shift) / scale
        };
        let count = own[0].len();
        let mut points: Vec<[f64; 3]> = (0..count).map(point).collect();
        if closed {
            points.push(points[0]);
        }
        Naive { parameters: (0..points.len()).map(at).collect(), points }
    }

    /// The polygon between two parameters.
    fn between(self, range: Option<[f64; 2]>) -> Vec<[f64; 3]> {
        let Some([low, high]) = range else { return self.points };
        let on = |t: f64| {
            let i = self.parameters.windows(2).position(|pair| pair[0] <= t && t <= pair[1]);
            let i = i.expect("the polygon has it");
            let share = (t - self.parameters[i]) / (self.parameters[i + 1] - self.parameters[i]);
            let (x, y) = (self.points[i], self.points[i + 1]);
            [0, 1, 2].map(|j| x[j] + share * (y[j] - x[j]))
        };
        let within = self.points.iter().zip(&self.parameters);
        let within = within.filter(|(_, t)| low < **t && **t < high).map(|(point, _)| *point);
        std::iter::once(on(low)).chain(within).chain([on(high)]).collect()
    }
}

/// The greatest distance of the points of one chain, each segment cut in `parts`, from another chain.
fn one_sided(from: &[[f64; 3]], parts: u32, to: &[[f64; 3]]) -> f64 {
    let dot = |x: [f64; 3], y: [f64; 3]| x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    let plus =
        |x: [f64; 3], t: f64, y: [f64; 3]| [x[0] + t * y[0], x[1] + t * y[1], x[2] + t * y[2]];
    let mut greatest = 0.0_f64;
    for pair in from.windows(2) {
        let way = plus(pair[1], -1.0, pair[0]);
        for part in 0..=parts {
            let point = plus(pair[0], f64::from(part) / f64::from(parts), way);
            let mut least = f64::INFINITY;
            for other in to.windows(2) {
                let (way, off) = (plus(other[1], -1.0, other[0]), plus(point, -1.0, other[0]));
                let square = dot(way, way);
                let t = if square > 0.0 { (dot(off, way) / square).clamp(0.0, 1.0) } else { 0.0 };
                let off = plus(off, -t, way);
                least = least.min(dot(off, off));
            }
            greatest = greatest.max(least);
        }
    }
    greatest.sqrt()
}

/// The Hausdorff distance of a level, nearly: `more` levels stand for the limit, and each segment is cut in `parts`.
fn dense(
    mask: &Mask,
    points: &Coordinates,
    sets: (bool, Option<[f64; 2]>),
    at: (u32, u32, u32),
) -> f64 {
    let ((closed, range), (level, more, parts)) = (sets, at);
    let chain = |level| Naive::new(mask, points, closed, level).between(range);
    let (polygon, limit) = (chain(level), chain(level + more));
    one_sided(&limit, 1, &polygon).max(one_sided(&polygon, parts, &limit))
}

proptest! {
    #![proptest_config(crate::common::cases(20))]

    /// Tolerances above and below the sampled distance of a level: far from it, where a few points show what is far, and so
    /// near that only all of them do.
    #[test]
    fn the_least_level_is_that_of_dense_samples(
        number in 0..6_usize,
        control in proptest::collection::vec([-9_i64..10, -9_i64..10, -4_i64..5], 8),
        closed in any::<bool>(),
        level in 0..4_u32,
    ) {
        let scheme =
            ["chaikin", "b-spline:degree=3", "dual-four-point", "four-point", "four-point", "four-point"][number];
        let mask = mask(scheme);
        let points: Coordinates =
            (0..3).map(|j| control.iter().map(|point| Rational::from(point[j])).collect()).collect();
        let mut own = sets(&mask, &points, closed);
        let range = own.range().map(|range| range.each_ref().map(nearest));
        let (percents, more, parts, margin) = match (scheme, level) {
            // Where the curve goes through all points, the farthest ones are in between.
            ("four-point", 0) => ([99.9, 100.1], 9, 16, 5e-4),
            (_, 0 | 1) => ([99.7, 100.3], 7, 32, 2e-3),
            _ => ([90.0, 110.0], 5, 8, 0.05),
        };
        let sampled: Vec<f64> =
            (0..=level).map(|level| dense(&mask, &points, (closed, range), (level, more, parts))).collect();
        prop_assume!(sampled[level as usize] > 1e-2);
        for percent in percents {
            let tolerance = sampled[level as usize] * percent / 100.0;
            if sampled.iter().any(|distance| (distance / tolerance - 1.0).abs() < margin) {
                continue;
            }
            let exact = subcert::float::exact(tolerance).expect("finite");
            let depth = own.depth(&exact).expect("few levels");
            let found = depth.level.expect("few levels");
            match sampled.iter().position(|distance| *distance <= tolerance) {
                Some(level) => prop_assert_eq!(found as usize, level, "{} {:?}", scheme, sampled),
                None => prop_assert!(found > level),
            }
            prop_assert_eq!(depth.too_few, found.checked_sub(1));
            if let Some((few, place)) = depth.too_few.zip(depth.beyond) {
                prop_assert!(place.distance >= tolerance * 0.999_999);
                if let Some(sampled) = sampled.get(few as usize) {
                    prop_assert!(place.distance <= sampled * (1.0 + margin));
                }
            }
        }
    }

    /// A similarity, other names of the coordinates, and coordinates that are 0 change nothing.
    #[test]
    fn similar_polygons_need_the_same(
        control in proptest::collection::vec([-9_i64..10, -9_i64..10], 5..9),
        scale in 1_i64..50,
        shift in -1000_i64..1000,
    ) {
        let [x, y] = [0, 1].map(|j| control.iter().map(|point| Rational::from(point[j])).collect::<Vec<_>>());
        prop_assume!(x.iter().any(|other| *other != x[0]));
        let moved = |own: &Vec<Rational>| -> Vec<Rational> {
            own.iter().map(|x| (x + &Rational::from(shift)) * r(scale, 7)).collect()
        };
        let tolerance = r(1, 20);
        let there = vec![moved(&y), vec![r(5, 3); x.len()], moved(&x)];
        let here = depth("chaikin", &vec![x, y], true, &tolerance);
        let there = depth("chaikin", &there, true, &(&tolerance * &r(scale, 7)));
        prop_assert_eq!((here.level, here.too_few), (there.level, there.too_few));
    }
}

#[test]
fn what_cannot_be_answered_is_refused() {
    let mut own = sets(&mask("chaikin"), &square(), true);
    for (tolerance, part) in [
        (r(0, 1), "must be positive"),
        (r(-1, 2), "must be positive"),
        (r(1, 1 << 30), "at least 2^-20"),
    ] {
        let error = own.depth(&tolerance).expect_err("refused").to_string();
        assert!(error.contains(part), "{error}");
    }
    let two: Coordinates = square().into_iter().map(|own| own[..2].to_vec()).collect();
    let limit = Limit::new(&mask("b-spline:degree=3")).expect("it converges");
    assert!(CurveSets::new(&limit, &two, false).is_err());
    let rough = CurveSets::new(
        &Limit::new(&mask("[2, 5, 6, 3]/8")).expect("it converges"),
        &square(),
        true,
    );
    assert!(rough.is_err_and(|error| error.to_string().contains("lines to lines")));
    let huge =
        vec![vec![r(0, 1), Rational::from(10).pow(400), r(0, 1)], vec![r(0, 1), r(0, 1), r(1, 1)]];
    let chaikin = Limit::new(&mask("chaikin")).expect("it converges");
    assert!(
        CurveSets::new(&chaikin, &huge, true)
            .is_err_and(|error| error.to_string().contains("another unit"))
    );
    // All points are one: so is the limit.
    let point = vec![vec![r(1, 3); 5], vec![r(2, 3); 5]];
    assert_eq!(depth("chaikin", &point, true, &r(1, 1000)).level, Some(0));
}
