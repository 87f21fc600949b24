//! Certificates of depths: what the program finds is certified, and nothing that is false.

use crate::common::r;
use crate::net::{bumpy, scheme as net_scheme};
use proptest::prelude::*;
use subcert::certificate::{DepthDirection, DepthFar, depth_certificate};
use subcert::exact::Rational;
use subcert::limit::Limit;
use subcert::net::Closed;
use subcert::patch::{CurveSets, NetDistances, SetKind};
use subcert::scheme::parse_scheme;
use subcert_check::{Depth, check_depth};

fn points(all: &[[i64; 2]]) -> Vec<Vec<Rational>> {
    all.iter().map(|point| point.map(Rational::from).to_vec()).collect()
}

/// The certificate of a polygon, and the level.
fn of_polygon(
    scheme: &str,
    points: &[Vec<Rational>],
    closed: bool,
    tolerance: &Rational,
) -> (String, u32) {
    let scheme = parse_scheme(scheme).expect("a scheme");
    let mask = scheme.masks()[0];
    let limit = Limit::new(mask).expect("it converges");
    let coordinate = |c: usize| points.iter().map(|point| point[c].clone()).collect();
    let coordinates: Vec<Vec<Rational>> = (0..points[0].len()).map(coordinate).collect();
    let mut sets = CurveSets::new(&limit, &coordinates, closed).expect("enough points");
    let found = sets.depth(tolerance).expect("few levels");
    let range = sets.range().cloned();
    let direction = DepthDirection { mask, count: points.len(), range };
    let far = |(level, place): (u32, &subcert::patch::CurvePlace)| DepthFar {
        level,
        of_limit: place.from == SetKind::Limit,
        parameters: vec![place.parameter.clone()],
    };
    let far: Vec<DepthFar> = found.places().map(far).collect();
    let text = depth_certificate(tolerance, &[direction], points, found.level, &far);
    (text, found.level.expect("a level"))
}

/// That it is the least level.
fn least(level: u32) -> Depth {
    Depth { enough: Some(level), too_few: (0..level).collect() }
}

#[test]
fn depths_of_polygons_are_certified() {
    let ring = points(&[[0, 0], [5, 1], [4, 5], [-1, 3]]);
    let mut zigzag = vec![[0, 0], [1, 3], [2, -1], [4, 2], [5, 0], [7, 4], [8, 1], [9, 1]];
    zigzag.extend([[10, 3], [11, 0], [13, 2], [14, 5]]);
    let zigzag = points(&zigzag);
    for (scheme, tolerance) in [
        ("chaikin", r(1, 50)),
        ("b-spline:degree=3", r(1, 7)),
        ("four-point:w=1/16", r(1, 100)),
        ("six-point:w=3/256", r(1, 30)),
        ("ternary-four-point:mu=1/11", r(1, 100)),
        ("dual-four-point", r(1, 20)),
        ("ternary-b-spline:degree=2", r(1, 60)),
    ] {
        for (points, closed) in [(&ring, true), (&zigzag, false)] {
            let (text, level) = of_polygon(scheme, points, closed, &tolerance);
            let found = check_depth(&text);
            let found = found.unwrap_or_else(|why| panic!("{scheme}, {closed}: {why:?}\n{text}"));
            assert_eq!(found, least(level), "{scheme}, {closed}");
            assert!(level > 0, "{scheme}");
        }
    }
}

#[test]
fn depths_of_nets_are_certified() {
    let torus = Closed { u: true, v: true };
    let mut all = 0;
    for (net, scheme, tolerance) in [
        (bumpy(5, 5, Closed::default()), "bicubic", r(1, 3)),
        (bumpy(4, 5, torus), "chaikin", r(1, 4)),
        (bumpy(6, 6, Closed { u: true, v: false }), "four-point:w=1/16", r(1, 2)),
    ] {
        let scheme = net_scheme(scheme);
        let distances = NetDistances::new(net.clone(), &scheme).expect("a small net");
        let found = distances.geometric_depth(&tolerance).expect("few levels");
        let directions = scheme.masks().iter().zip(net.sizes()).zip(distances.ranges());
        let directions: Vec<DepthDirection<'_>> = directions
            .map(|((mask, count), range)| DepthDirection { mask, count, range })
            .collect();
        let far: Vec<DepthFar> = found
            .places()
            .map(|(level, place)| DepthFar {
                level,
                of_limit: place.from == SetKind::Limit,
                parameters: place.parameters.clone().expect("a net").to_vec(),
            })
            .collect();
        let points: Vec<Vec<Rational>> = net.points().iter().map(|x| x.to_vec()).collect();
        let level = found.level.expect("a level");
        let text = depth_certificate(&tolerance, &directions, &points, found.level, &far);
        let checked = check_depth(&text).unwrap_or_else(|why| panic!("{why:?}\n{text}"));
        let few = found.too_few.map_or(0, |level| level + 1);
        assert_eq!(checked, Depth { enough: found.level, too_few: (0..few).collect() });
        let wrong = text.replace(&format!("enough {level}"), &format!("enough {}", level - 1));
        assert!(few < level || check_depth(&wrong).is_err());
        all += few;
    }
    assert!(all > 3, "{all}");
}

/// By hand: the corners of a square are √2/2 from the curve of Chaikin's scheme, and no point is farther.
#[test]
fn a_square_is_as_far_as_its_corners() {
    let square = points(&[[0, 0], [2, 0], [2, 2], [0, 2]]);
    let scheme = parse_scheme("chaikin").expect("a scheme");
    let says = |tolerance: Rational, enough: Option<u32>, few: &[&str]| {
        let direction = DepthDirection { mask: scheme.masks()[0], count: 4, range: None };
        let text = depth_certificate(&tolerance, &[direction], &square, enough, &[]);
        let mut lines: Vec<String> = few.iter().map(|line| format!("too-few 0 {line}")).collect();
        lines.push("end\n".to_owned());
        check_depth(&text.replace("end\n", &lines.join("\n")))
    };
    // The corner is a quarter of the diagonal of the square, √2/2·1/2.
    assert!(says(r(3536, 10_000), Some(0), &[]).is_ok());
    assert!(says(r(3535, 10_000), Some(0), &[]).is_err());
    assert!(says(r(3535, 10_000), None, &["polygon 1/2"]).is_ok());
    assert!(says(r(3536, 10_000), None, &["polygon 1/2"]).is_err());
    assert!(says(r(3535, 10_000), None, &["limit 1/2"]).is_err());
}

/// The polygon from 0 to 10 and back is a part of its limit, which reaches beyond both ends: the new point between the
/// two at 10 is 9/16·20 = 11.25, and the greatest value of the limit at i/2^10 is 11.250318…, at 1517/1024.
#[test]
fn a_limit_may_be_far_from_a_polygon_that_it_holds() {
    let line = points(&[[0, 0], [10, 0], [10, 0], [0, 0]]);
    let scheme = parse_scheme("four-point:w=1/16").expect("a scheme");
    let says = |tolerance: Rational, enough: Option<u32>, far: &[DepthFar]| {
        let direction = DepthDirection { mask: scheme.masks()[0], count: 4, range: None };
        check_depth(&depth_certificate(&tolerance, &[direction], &line, enough, far))
    };
    let at = |of_limit, parameter| [DepthFar { level: 0, of_limit, parameters: vec![parameter] }];
    let (less, more) = (r(12_503, 10_000), r(12_504, 10_000));
    assert!(says(more.clone(), Some(0), &[]).is_ok());
    assert!(says(less.clone(), Some(0), &[]).is_err());
    assert!(says(less.clone(), None, &at(true, r(1_517, 1_024))).is_ok());
    assert!(says(less.clone(), None, &at(true, r(3, 2))).is_err());
    assert!(says(less, None, &at(false, r(3, 2))).is_err());
    assert!(says(more, None, &at(true, r(1_517, 1_024))).is_err());
}

#[test]
fn nothing_else_is_accepted() {
    let ring = points(&[[0, 0], [5, 1], [4, 5], [-1, 3]]);
    let zigzag = points(&[[0, 0], [1, 3], [2, -1], [4, 2], [5, 0], [7, 4], [8, 1]]);
    let (closed, level) = of_polygon("chaikin", &ring, true, &r(1, 50));
    let (open, _) = of_polygon("four-point:w=1/16", &zigzag, false, &r(1, 100));
    let last = format!("too-few {}", level - 1);
    let replaced = |text: &str, from: &str, to: &str| {
        assert!(text.contains(from), "{from} in\n{text}");
        text.replacen(from, to, 1)
    };
    let wrong = [
        replaced(&closed, "subcert-depth 1", "subcert-depth 2"),
        replaced(&closed, "tolerance 1/50", "tolerance 1/5000"),
        replaced(&closed, "tolerance 1/50", "tolerance -1/50"),
        replaced(&closed, "tolerance 1/50", "tolerance 0"),
        replaced(&closed, "tolerance 1/50\n", ""),
        replaced(&closed, "tolerance 1/50", "tolerance 1/50\ntolerance 1/50"),
        replaced(&closed, &format!("enough {level}"), &format!("enough {}", level - 1)),
        replaced(&closed, &format!("enough {level}"), "enough 25"),
        replaced(&closed, &last, &format!("too-few {level}")),
        replaced(&closed, "end\n", &format!("too-few {level} polygon 1/2\nend\n")),
        replaced(&closed, "too-few 0", "too-few 1"),
        replaced(&closed, "too-few 0 polygon", "too-few 0 mesh"),
        replaced(&closed, "too-few 0 polygon ", "too-few 0 polygon 1/7 "),
        replaced(&closed, "end\n", ""),
        replaced(&closed, "end\n", "end\npoint 0 0\n"),
        replaced(&closed, "direction 0 4 closed", "direction 0 5 closed"),
        replaced(&closed, "direction 0 4 closed", "direction 0 4 0 4"),
        replaced(&closed, "direction 0 4 closed", "direction 0 4"),
        replaced(&closed, "rule 3/4 1/4", "rule 3/4 1/3"),
        replaced(&closed, "rule 3/4 1/4", "rule 3/4 1/4 0"),
        replaced(&closed, "rule 3/4 1/4\nrule 1/4 3/4", "rule 1 0\nrule 1 0"),
        replaced(&closed, "rule 3/4 1/4\nrule 1/4 3/4", "rule 3 -2\nrule 5/2 -3/2"),
        replaced(&closed, "rule 3/4 1/4\n", ""),
        replaced(&closed, "point 0 0", "point 0 0 0"),
        replaced(&closed, "point 0 0", "point 0 zero"),
        replaced(&closed, "point 5 1", "point 50000000 1"),
        replaced(&open, "direction -1 7 2 4", "direction -1 7 1 4"),
        replaced(&open, "direction -1 7 2 4", "direction -1 7 5/2 4"),
        replaced(&open, "direction -1 7 2 4", "direction -1 7 2 3"),
        replaced(&open, "direction -1 7 2 4", "direction -1 7 2 5"),
        replaced(&open, "direction -1 7 2 4", "direction -1 7 4 2"),
        replaced(&open, "direction -1 7 2 4", "direction 0 7 2 4"),
        replaced(&open, "too-few 0 polygon ", "too-few 0 polygon -"),
    ];
    for (i, text) in wrong.iter().enumerate() {
        assert!(check_depth(text).is_err(), "{i}: {:?}\n{text}", check_depth(text));
    }
}

/// Without half a piece at each end, a level less would do.
#[test]
fn an_open_polygon_is_looked_at_wherever_it_determines_the_limit() {
    let bend = points(&[[0, 0], [1, 0], [1, 8], [1, 16]]);
    let (text, level) = of_polygon("chaikin", &bend, false, &r(1, 100));
    assert_eq!((level, check_depth(&text)), (4, Ok(least(4))));
    let less = text.replace("direction 0 4 0 2", "direction 0 4 1/2 3/2");
    let less = less.split("enough").next().expect("the data").to_owned() + "enough 3\nend\n";
    let why = check_depth(&less).expect_err("another range").reason.to_string();
    assert!(why.contains("in another range"), "{why}");
}

proptest! {
    #![proptest_config(crate::common::cases(12))]

    /// A tolerance that is enough at a level is not too small for it, with any witness.
    #[test]
    fn no_level_is_enough_and_too_few(
        coordinates in prop::collection::vec([-9_i64..9, -9_i64..9], 4..7),
        tolerance in 1_i64..60,
        level in 0_u32..4,
        at in 0_i64..64,
    ) {
        let points = points(&coordinates);
        let scheme = parse_scheme("four-point:w=1/16").expect("a scheme");
        let direction = DepthDirection { mask: scheme.masks()[0], count: points.len(), range: None };
        let directions = [direction];
        let tolerance = r(tolerance, 40);
        let enough = depth_certificate(&tolerance, &directions, &points, Some(level), &[]);
        let at = Rational::new(at, 64) * Rational::from(points.len());
        for of_limit in [true, false] {
            let far = [DepthFar { level, of_limit, parameters: vec![at.clone()] }];
            let few = depth_certificate(&tolerance, &directions, &points, None, &far);
            prop_assert!(check_depth(&enough).is_err() || check_depth(&few).is_err(), "{}", few);
        }
    }
}
