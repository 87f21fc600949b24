//! Open polygons at equal parameters: one domain for all levels, by the definitions of limit and polygon.

use crate::common::{int, r};
use subcert::exact::Rational;
use subcert::limit::{
    ControlPolygon, Distances, Limit, LimitError, Parametrisation, Window, determined,
};
use subcert::scheme::{AnyScheme, Mask, Scheme, catalogue, parse_any_scheme};

/// Every curve of the catalogue that is shown to converge.
fn curves() -> impl Iterator<Item = (String, Limit)> {
    let entries = catalogue().iter().filter(|entry| !entry.is_ring());
    entries.filter_map(|entry| {
        let name = entry.references().remove(0);
        let Ok(AnyScheme::Uniform(Scheme::Curve(mask))) = parse_any_scheme(&name) else {
            return None;
        };
        Some((name, Limit::new(&mask).ok()?))
    })
}

/// The polygon of level k at t, from the rules; `None` where a point that is not given has a weight.
fn polygon(
    mask: &Mask,
    points: &[Rational],
    k: u32,
    t: &Rational,
    s: &Rational,
) -> Option<Rational> {
    fn point(mask: &Mask, points: &[Rational], k: u32, i: i64) -> Option<Rational> {
        if k == 0 {
            return points.get(usize::try_from(i).ok()?).cloned();
        }
        let n = int(mask.arity());
        let row = &mask.rules().rows()[usize::try_from(i.rem_euclid(n)).expect("a residue")];
        (i.div_euclid(n) + mask.offset()..)
            .zip(row)
            .filter(|(_, a)| !a.is_zero())
            .try_fold(Rational::zero(), |sum, (j, a)| {
                Some(sum + a * point(mask, points, k - 1, j)?)
            })
    }
    let u = t * Rational::from(mask.arity()).pow(k.cast_signed()) - s;
    let (i, part) = (u.floor().to_i64().expect("small"), u.fract());
    let first = (Rational::one() - &part) * point(mask, points, k, i)?;
    let second = if part.is_zero() { part } else { part * point(mask, points, k, i + 1)? };
    Some(first + second)
}

/// P^∞(t), if the points determine it.
fn value(limit: &Limit, points: &[Rational], t: &Rational) -> Option<Rational> {
    let weights = limit.at(t).expect("its digits repeat");
    let (first, last) = weights.support()?;
    (first >= 0 && last < int(points.len()))
        .then(|| weights.apply(|i| points[usize::try_from(i).expect("it is not negative")].clone()))
}

/// |P^∞ − P^k| at t.
fn error(
    limit: &Limit,
    points: &[Rational],
    k: u32,
    t: &Rational,
    s: &Rational,
) -> Option<Rational> {
    let level = polygon(limit.mask(), points, k, t, s)?;
    Some((value(limit, points, t)? - level).abs())
}

/// Whether the points determine the limit and the polygons of the first levels there.
fn is_known(limit: &Limit, points: &[Rational], t: &Rational, s: &Rational) -> bool {
    (0..=2).all(|k| error(limit, points, k, t, s).is_some())
}

/// Whether they do so at two neighbouring sevenths.
fn has_part(limit: &Limit, points: &[Rational], s: &Rational) -> bool {
    let known: Vec<bool> = (-140..140).map(|j| is_known(limit, points, &r(j, 7), s)).collect();
    known.windows(2).any(|pair| pair[0] && pair[1])
}

/// The window by its definition: the points of the polygon on a cell, and all that those of the next level in the windows
/// of its parts are made of.
fn window(mask: &Mask, s: &Rational) -> [i64; 2] {
    let whole = |x: Rational| x.floor().to_i64().expect("small");
    let n = int(mask.arity());
    let mut ends = [whole(-s), -whole(s - Rational::one())];
    loop {
        let mut wider = ends;
        for row in ends[0]..ends[1] + n {
            let rule = &mask.rules().rows()[usize::try_from(row.rem_euclid(n)).expect("a residue")];
            for (j, entry) in (row.div_euclid(n) + mask.offset()..).zip(rule) {
                if !entry.is_zero() {
                    wider = [wider[0].min(j), wider[1].max(j)];
                }
            }
        }
        if wider == ends {
            return ends;
        }
        ends = wider;
    }
}

/// For every curve of the catalogue and for shifts near and far.
#[test]
fn windows_are_those_of_the_definition() {
    let mut seen = 0;
    for (name, limit) in curves() {
        for shift in [r(0, 1), r(-1, 2), r(2, 3), r(-9, 4), r(5, 1), r(13, 5)] {
            let own = window(limit.mask(), &shift);
            let found = Window::of(limit.mask(), &shift).expect("narrow");
            assert_eq!([found.first, found.last], own, "{name}, {shift}");
            seen += 1;
        }
    }
    assert!(seen > 200, "{seen}");
}

/// Whether the mask is the same from both sides.
fn is_symmetric(mask: &Mask) -> bool {
    let n = int(mask.arity());
    let rows = (0_i64..).zip(mask.rules().rows());
    let all = rows.flat_map(|(alpha, row)| {
        (mask.offset()..)
            .zip(row)
            .map(move |(j, a)| (alpha - n * j, a))
            .filter(|(_, a)| !a.is_zero())
    });
    let mut all: Vec<(i64, &Rational)> = all.collect();
    all.sort_by_key(|(j, _)| *j);
    let sum = all[0].0 + all[all.len() - 1].0;
    all.iter().zip(all.iter().rev()).all(|(x, y)| x.0 + y.0 == sum && x.1 == y.1)
}

/// For every curve of the catalogue: as many points are needed as determine a part of the limit; all of the domain is
/// determined, and nothing beyond it; the distance is attained in the domain, no sample of it is farther, and the reversed
/// points are as far where the scheme is symmetric.
#[test]
fn all_curves_of_the_catalogue() {
    let all = [3, -1, 4, 1, -5, 9, 2, -6, 5, 3, 5, -8, 9, 7, 9, 3].map(Rational::from);
    let (width, mut seen, mut shifted, mut turned, mut cut) = (r(1, 50), 0, 0, 0, 0);
    for (name, limit) in curves() {
        for parametrisation in [Parametrisation::Indexed, Parametrisation::Natural] {
            let s = parametrisation.shift(limit.mask());
            if parametrisation == Parametrisation::Natural && s.is_zero() {
                continue;
            }
            let turns =
                s == Parametrisation::Natural.shift(limit.mask()) && is_symmetric(limit.mask());
            let Ok(distances) = Distances::placed(&limit, parametrisation) else { continue };
            let few = distances.of_polygon(&ControlPolygon::open(&all[..1]), 0, &width);
            let Err(LimitError::TooFew { needed: least }) = few else { panic!("{name}: {few:?}") };
            if least >= all.len() {
                continue;
            }
            let few = distances.of_polygon(&ControlPolygon::open(&all[..least - 1]), 0, &width);
            assert_eq!(few, Err(LimitError::TooFew { needed: least }), "{name}");
            assert!(!has_part(&limit, &all[..least - 1], &s), "{name}");
            let points = &all[..=least];
            let [from, to] = determined(limit.mask(), &s, points.len()).expect("enough points");
            for beyond in [&from - r(1, 7), &to + r(1, 7)] {
                assert!(!is_known(&limit, points, &beyond, &s), "{name}: {beyond}");
            }
            let open = ControlPolygon::open(points);
            for k in [0, 2] {
                let found = match distances.of_polygon(&open, k, &width) {
                    Ok(found) => found,
                    Err(LimitError::TooFine { .. }) => continue,
                    Err(error) => panic!("{name}: {error}"),
                };
                let t = &found.parameter;
                assert!(from <= *t && *t <= to, "{name}, {k}: {t}");
                let there = error(&limit, points, k, t, &s).expect("it is determined there");
                assert_eq!(there, *found.enclosure.lower(), "{name}, {k}");
                for j in 0..=24 {
                    let t = &from + (&to - &from) * r(j, 24);
                    let sample = error(&limit, points, k, &t, &s).expect("determined");
                    assert!(sample <= *found.enclosure.upper(), "{name}, {k}: {sample} at {t}");
                }
                if turns {
                    let back: Vec<Rational> = points.iter().rev().cloned().collect();
                    let back = distances.of_polygon(&ControlPolygon::open(&back), k, &width);
                    let back = back.expect("as the other").enclosure;
                    let (x, y) = (&found.enclosure, &back);
                    assert!(x.lower() <= y.upper() && y.lower() <= x.upper(), "{name}, {k}");
                    turned += 1;
                }
                shifted += u32::from(!s.is_integer());
                cut += u32::from(!from.is_integer());
                seen += 1;
            }
        }
    }
    let counts = [seen, shifted, turned, cut];
    assert!(counts.iter().zip([60, 20, 20, 5]).all(|(x, least)| *x > least), "{counts:?}");
}

/// A dual scheme far from its limit at an end: the points 1000, 0, …, 0. The distances are those of dense samples of
/// refined polygons between the parameters 2 and 12.
#[test]
fn far_at_an_end() {
    let limit = Limit::new(&crate::common::mask("dual-four-point:w=1/128")).expect("a limit");
    let distances = Distances::natural(&limit).expect("distances");
    let mut points = vec![Rational::zero(); 16];
    points[0] = Rational::from(1000);
    for _ in 0..2 {
        let open = ControlPolygon::open(&points);
        for (k, expected) in [(0, 26_042), (1, 26_042), (2, 7_731), (3, 2_009), (4, 507)] {
            let found = distances.of_polygon(&open, k, &r(1, 1_000_000)).expect("few cells");
            let off = (found.enclosure.upper() - r(expected, 10_000)).abs();
            assert!(off < r(1, 10_000), "{k}: {:?}", found.enclosure);
        }
        let depth = distances.depth_of_polygon(&open, &r(135, 100)).expect("few levels");
        assert_eq!((depth.lower, depth.upper), (2, 2));
        points.reverse();
    }
}
