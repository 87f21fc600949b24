//! Broken promises as sets of points, against dense samples.

use crate::common::papers::audit_of;
use subcert::audit::{Control, Kept};
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::report::to_the_eye;
use subcert::scheme::{Mask, parse_scheme};

type P = [f64; 2];

/// The points of the next level that all old ones are known for.
fn refined(mask: &Mask, points: &[P]) -> Vec<P> {
    let rules = mask.rules();
    let count = i64::try_from(points.len()).expect("few");
    let mut all = Vec::new();
    for i in -40..count + 40 {
        for rule in rules.rows() {
            let terms = (i + rules.offset()..).zip(rule).filter(|(_, x)| !x.is_zero());
            let terms: Vec<(i64, f64)> = terms.map(|(j, x)| (j, nearest(x))).collect();
            if terms.iter().all(|(j, _)| (0..count).contains(j)) {
                let at = |c: usize| -> f64 {
                    terms
                        .iter()
                        .map(|(j, x)| x * points[usize::try_from(*j).expect("known")][c])
                        .sum()
                };
                all.push([at(0), at(1)]);
            }
        }
    }
    all
}

/// The distance of a point from a chain.
fn distance(p: P, chain: &[P]) -> f64 {
    let to = |pair: &[P]| {
        let (u, v) = (pair[0], pair[1]);
        let way = [v[0] - u[0], v[1] - u[1]];
        let square = way[0] * way[0] + way[1] * way[1];
        let t = (way[0] * (p[0] - u[0]) + way[1] * (p[1] - u[1])) / square;
        let t = t.clamp(0.0, 1.0);
        (u[0] + t * way[0] - p[0]).hypot(u[1] + t * way[1] - p[1])
    };
    chain.windows(2).map(to).fold(f64::INFINITY, f64::min)
}

#[test]
fn what_breaks_by_parameter_may_be_kept_as_a_set() {
    let audit = audit_of("mustafa2020-nary");
    let table = audit.tables.iter().find(|finding| finding.table.id == "table-6");
    let finding = table.expect("a table");
    let scheme = parse_scheme("ternary-four-point-approximating").expect("a scheme");
    let mask = scheme.masks()[0];
    let mut seen = [0; 2];
    for at in [(1, 0), (2, 0), (3, 0)] {
        let eye = to_the_eye(audit.paper, finding, at).expect("formulas").expect("it is broken");
        let Some(Kept::No(broken)) = &finding.cells[at.0][at.1].kept else {
            panic!("it is broken")
        };
        let Control::Polygon(polygon) = &broken.attained.control else { panic!("a polygon") };
        let last = i64::try_from(polygon.points.len()).expect("few") - 1;
        let spread = nearest(&broken.spread);
        let point = |i: i64| {
            let value = polygon.points[usize::try_from(i.clamp(0, last)).expect("an index")];
            [i, value].map(|x| nearest(&Rational::from(x)) * spread)
        };
        let mut levels = vec![(-9..=last + 9).map(point).collect::<Vec<P>>()];
        for _ in 0..broken.level + 4 {
            levels.push(refined(mask, &levels[levels.len() - 1]));
        }
        let (own, fine) = (&levels[broken.level as usize], &levels[levels.len() - 1]);
        // Away from the ends.
        let middle =
            |p: &&P| (-2.0 * spread..nearest(&Rational::from(last + 2)) * spread).contains(&p[0]);
        let there = fine.iter().filter(middle).map(|p| distance(*p, own));
        let back = own.iter().filter(middle).map(|p| distance(*p, fine));
        let sampled = there.chain(back).fold(0.0, f64::max);
        let broken_by_samples = sampled > nearest(&broken.most);
        assert_eq!(eye.broken, Some(broken_by_samples), "{at:?}: {sampled}, {eye:?}");
        seen[usize::from(broken_by_samples)] += 1;
    }
    assert!(seen.iter().all(|count| *count > 0), "{seen:?}");
}
