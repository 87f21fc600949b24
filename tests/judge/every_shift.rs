//! Theorems in every shift of the parameter: the data against a naive refinement at many shifts, and
//! theorems whose answer is known.

use crate::common::claims::{judged, paper, theorem, without_tables};
use crate::common::r;
use subcert::audit::{EveryShift, Naturally, Refutation, Unshiftable};
use subcert::claim::{Quantity, embedded};
use subcert::exact::{Rational, RealCyclotomic};
use subcert::limit::{ExtremalPolygon, Overshoot, ProofOfGreatest};
use subcert::scheme::{Mask, parse_scheme};

/// The refutation of a theorem.
fn of(fields: &str) -> Refutation {
    let paper = paper(&theorem(fields));
    judged(&paper).theorems[0].refutation.clone().expect("it is refuted")
}

fn data(refutation: &Refutation) -> &Unshiftable {
    match &refutation.every_shift {
        Some(EveryShift::Refuted { data, .. }) => data,
        other => panic!("{other:?}"),
    }
}

/// Point i of a level, by the rules alone; the polygon is constant beyond its ends.
fn point(mask: &Mask, polygon: &ExtremalPolygon, level: u32, i: i64) -> Rational {
    if level == 0 {
        let last = polygon.points.len() - 1;
        let at = usize::try_from(i - polygon.first).unwrap_or(0).min(last);
        return Rational::from(polygon.points[at]);
    }
    let arity = i64::try_from(mask.arity()).unwrap();
    let row = &mask.rules().rows()[usize::try_from(i.rem_euclid(arity)).unwrap()];
    let start = i.div_euclid(arity) + mask.offset();
    (start..).zip(row).map(|(j, weight)| weight * point(mask, polygon, level - 1, j)).sum()
}

/// All points of a level that may differ from the ends, with the index of the first.
fn points(mask: &Mask, polygon: &ExtremalPolygon, level: u32) -> (i64, Vec<Rational>) {
    let n = i64::try_from(mask.arity()).unwrap();
    let reach = 3 * (i64::try_from(mask.width()).unwrap() + mask.offset().abs());
    let last = polygon.first + i64::try_from(polygon.points.len()).unwrap();
    let (mut first, mut known) = (
        polygon.first - reach,
        (polygon.first - reach..last + reach)
            .map(|i| point(mask, polygon, 0, i))
            .collect::<Vec<Rational>>(),
    );
    for _ in 0..level {
        let at = |i: i64| {
            let place = usize::try_from(i - first).unwrap_or(0).min(known.len() - 1);
            &known[place]
        };
        let end = first + i64::try_from(known.len()).unwrap();
        // What a shift of the labels moves out of the window is constant.
        let finer = (n * (first - reach)..n * (end + reach)).map(|i| {
            let row = &mask.rules().rows()[usize::try_from(i.rem_euclid(n)).unwrap()];
            let start = i.div_euclid(n) + mask.offset();
            (start..).zip(row).map(|(j, weight)| weight * at(j)).sum::<Rational>()
        });
        let finer: Vec<Rational> = finer.collect();
        (first, known) = (n * (first - reach), finer);
        // Cut the constant ends but for one point.
        let same =
            |list: &[Rational], end: &Rational| list.iter().take_while(|x| *x == end).count();
        let front = same(&known, &known[0].clone()).saturating_sub(1);
        let reversed: Vec<Rational> = known.iter().rev().cloned().collect();
        let back = same(&reversed, &reversed[0].clone()).saturating_sub(1);
        if front + back < known.len() {
            known = known[front..known.len() - back].to_vec();
            first += i64::try_from(front).unwrap();
        }
    }
    (first, known)
}

fn greatest(mask: &Mask, polygon: &ExtremalPolygon, level: u32) -> Rational {
    points(mask, polygon, level).1.into_iter().max().unwrap()
}

/// The masks of a case, at the offset of the theorem.
fn masks(case: &str, offset: Option<i64>) -> Vec<Mask> {
    let name = case.split(", ").next().unwrap();
    let scheme = parse_scheme(name).unwrap_or_else(|error| panic!("{name}: {error}"));
    let own = scheme.masks().into_iter();
    own.map(|mask| mask.with_offset(offset.unwrap_or(mask.offset()))).collect()
}

/// Checks the greatest values of the data, and on a curve the distance itself at many shifts.
fn check(case: &str, offset: Option<i64>, data: &Unshiftable) {
    let Unshiftable { quantity, level, overshoot, bound } = data;
    let Overshoot { polygons, greatest: found, later, shown } = overshoot;
    let masks = masks(case, offset);
    assert_eq!(masks.len(), polygons.len());
    for polygon in polygons {
        let spread = polygon.points.windows(2).map(|pair| (pair[1] - pair[0]).abs()).max();
        assert_eq!(spread, Some(1), "{case}");
    }
    let sum = |level: u32| -> Rational {
        masks.iter().zip(polygons).map(|(mask, polygon)| greatest(mask, polygon, level)).sum()
    };
    assert_eq!(*found, sum(*level), "{case}");
    // The limit is as near as 1/1000 to the points some levels later, in all these cases.
    let deep = level + if masks[0].arity() == 2 { 5 } else { 3 };
    let near = r(1, 1000);
    match shown {
        ProofOfGreatest::Points => assert_eq!(*later, sum(level + 1), "{case}"),
        ProofOfGreatest::AtMost(levels) => {
            assert!(*later >= sum(deep) - &near && found > later, "{case}");
            assert_eq!(levels.len(), masks.len());
        }
        ProofOfGreatest::AtLeast(places) => {
            assert!(*later <= sum(deep) + &near && found < later, "{case}");
            assert_eq!(places.len(), masks.len());
        }
    }
    assert!(RealCyclotomic::from(overshoot.gap()) > *bound, "{case}");
    let [mask] = &masks[..] else { return };
    // |P^∞ − P^k_s| at many shifts, or the step, at the points of the later level.
    let n = Rational::from(mask.arity());
    let after = if *quantity == Quantity::Step { level + 1 } else { deep };
    let (first, fine) = points(mask, &polygons[0], after);
    let (start, coarse) = points(mask, &polygons[0], *level);
    let scale = n.pow((after - level).cast_signed());
    let polygon = |u: &Rational| {
        let part = u.fract();
        let i = u.floor().to_i64().unwrap() - start;
        let at = |i: i64| &coarse[usize::try_from(i).unwrap_or(0).min(coarse.len() - 1)];
        (Rational::one() - &part) * at(i) + part * at(i + 1)
    };
    let refined = |u: &Rational| {
        let part = u.fract();
        let i = u.floor().to_i64().unwrap() - first;
        let at = |i: i64| &fine[usize::try_from(i).unwrap_or(0).min(fine.len() - 1)];
        (Rational::one() - &part) * at(i) + part * at(i + 1)
    };
    for shift in -12..=12 {
        let shift = r(shift, 4);
        // x^k_i at i + s, and the finer points at (j + s')/n^m, s' the natural shift of limits.
        let own = match quantity {
            Quantity::Step => shift.clone(),
            _ => subcert::limit::natural_shift(mask).shift,
        };
        let distances = (first..).zip(&fine).map(|(j, x)| {
            let u = (Rational::from(j) + &own) / &scale - &shift;
            (x - &polygon(&u)).abs()
        });
        let nodes = (start..).zip(&coarse).map(|(i, x)| {
            let v = (Rational::from(i) + &shift) * &scale - &own;
            (x - &refined(&v)).abs()
        });
        let most = distances.chain(nodes).max().unwrap() + &near;
        assert!(RealCyclotomic::from(most) > *bound, "{case} at {shift}");
    }
}

#[test]
fn what_survives_every_shift_in_the_papers() {
    let mut counts = [0; 3];
    for found in embedded() {
        let paper = without_tables(found.key);
        let audit = judged(&paper);
        for theorem in &audit.theorems {
            let Some(refutation) = &theorem.refutation else { continue };
            match &refutation.every_shift {
                Some(EveryShift::Refuted { case, data, .. }) => {
                    check(case, theorem.theorem.tried.offset, data);
                    // What no shift mends is false at the natural parameters too.
                    assert!(matches!(refutation.natural, Some(Naturally::Refuted { .. })));
                    counts[0] += 1;
                }
                Some(EveryShift::Holds) => {
                    assert_eq!(refutation.natural, Some(Naturally::Holds), "{}", theorem.id);
                    counts[1] += 1;
                }
                Some(EveryShift::Open) => panic!("{}", theorem.id),
                None => counts[2] += 1,
            }
        }
    }
    // Theorems 4, 5 and 6 of 2020; 7, 8, 9 and Lemma 6.1 of 2019; and the rings.
    assert_eq!(counts, [3, 4, 8]);
}

#[test]
fn a_polygon_above_its_limit() {
    // The cubic B-spline of −|i| is 1/3 below its vertex, which is the constant C_0.
    let fields = "scheme = 'b-spline:degree=3'\nbounds = 'distance'\nby = 'beta/4'\nfrom = '0'";
    let found = of(fields);
    let data = data(&found);
    assert_eq!(found.natural, None);
    assert!(matches!(data.overshoot.shown, ProofOfGreatest::AtMost(_)));
    assert!(data.overshoot.gap() <= r(1, 3) && data.overshoot.gap() > r(1, 4));
    check("b-spline:degree=3", None, data);
    // No data have more than 1/3.
    let fields = fields.replace("beta/4", "beta/3 - beta/10000");
    assert_eq!(of(&fields).every_shift, Some(EveryShift::Open));
}

#[test]
fn a_limit_above_its_polygon() {
    let fields = "scheme = 'four-point:w=1/16'\nbounds = 'distance'\nby = 'beta/9'\nfrom = '0'";
    let found = of(fields);
    assert!(matches!(data(&found).overshoot.shown, ProofOfGreatest::AtLeast(_)));
    check("four-point:w=1/16", None, data(&found));
}

#[test]
fn a_label_shift_alone() {
    // Chaikin's scheme is 1/2 off with points at i/n^k, and 1/4 at i − 1/2.
    let chaikin =
        |by: &str| of(&format!("scheme = 'chaikin'\nbounds = 'distance'\nby = '{by}'\nfrom = '0'"));
    assert_eq!(chaikin("beta/4/2^k").every_shift, Some(EveryShift::Holds));
    check("chaikin", None, data(&chaikin("beta/5/4^k")));
}

#[test]
fn steps_depths_and_nets() {
    let step = of("scheme = 'chaikin'\nbounds = 'step'\nby = 'beta/5'\nfrom = '0'");
    assert_eq!(data(&step).overshoot.shown, ProofOfGreatest::Points);
    check("chaikin", None, data(&step));
    // New points lie on the old polygon there: only an old corner is off.
    assert_eq!(step.natural, Some(Naturally::AsInEveryShift));
    let held = of("scheme = 'chaikin'\nbounds = 'step'\nby = '3*beta/10/3^k'\nfrom = '0'");
    assert_eq!(held.every_shift, Some(EveryShift::Holds));
    let depth = of("scheme = 'chaikin'\nbounds = 'depth'\nby = 'levels(1/2, 6*epsilon/beta)'");
    check("chaikin", None, data(&depth));
    let net =
        "scheme = 'chaikin x b-spline:degree=3'\nbounds = 'distance'\nby = 'beta/2'\nfrom = '0'";
    check("chaikin x b-spline:degree=3", None, data(&of(net)));
    let net = "scheme = 'chaikin x chaikin'\nbounds = 'step'\nby = '3*beta/5/3^k'\nfrom = '0'";
    assert_eq!(of(net).every_shift, Some(EveryShift::Holds));
}

#[test]
fn where_there_is_no_parameter() {
    let difference = of("scheme = 'chaikin'\nbounds = 'difference'\nby = 'beta/3^k'\nfrom = '0'");
    assert_eq!((difference.every_shift, difference.natural), (None, None));
    let ring = of("scheme = 'doo-sabin:n=5'\nbounds = 'distance'\nby = 'beta/4^k'\nfrom = '1'");
    assert_eq!((ring.every_shift, ring.natural), (None, None));
}
