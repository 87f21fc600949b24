//! Limits and distances of rings: against refined rings, all integer rings, closed forms
//! and spectra.

use crate::common::{any_ring, int, r, rational, ring};
use proptest::prelude::*;
use subcert::exact::{Rational, RealCyclotomic, Scalar as _};
use subcert::limit::{
    Comparison, LocalDepth, LocalDistances, LocalLimit, LocalLimitError, LocalWitness,
};
use subcert::scheme::{LocalRules, Orbit};

/// Rings with some negative weights of which the differences contract.
fn convergent(most: usize) -> impl Strategy<Value = LocalLimit<Rational>> {
    any_ring(most).prop_filter_map("no contraction", |ring| {
        let even = r(1, int(ring.point_count()));
        let mix = |x: &Rational| x * r(1, 12) + &even * r(11, 12);
        let points = 0..ring.point_count();
        let rows = points.map(|a| ring.weights().row(a).map(mix).collect()).collect();
        let ring = LocalRules::new(ring.orbits().to_vec(), rows, ring.edges().to_vec()).unwrap();
        LocalLimit::new(&ring).ok()
    })
}

fn refined(ring: &LocalRules<Rational>, points: &[Rational], levels: u32) -> Vec<Rational> {
    (0..levels).fold(points.to_vec(), |points, _| ring.refine(&points))
}

fn spread(ring: &LocalRules<Rational>, points: &[Rational]) -> Rational {
    let differences = ring.edges().iter().map(|&(a, b)| (&points[a] - &points[b]).abs());
    differences.max().unwrap()
}

/// max |x_a − limit|.
fn farthest(points: &[Rational], limit: &Rational) -> Rational {
    points.iter().map(|x| (x - limit).abs()).max().unwrap()
}

fn integers(heights: &[i64]) -> Vec<Rational> {
    heights.iter().map(|&height| Rational::from(height)).collect()
}

/// The greatest distance from the limit after `levels` of all integer rings of spread 1 that
/// are 0 at the first point.
fn brute(limit: &LocalLimit<Rational>, levels: u32) -> Rational {
    let count = limit.ring().point_count();
    let most = int(count) - 1;
    let choices = (2 * most + 1).pow(u32::try_from(most).unwrap());
    let heights = (0..choices).map(|mut code| {
        let digit = |_| {
            let digit = code % (2 * most + 1) - most;
            code /= 2 * most + 1;
            digit
        };
        [0].into_iter().chain((1..count).map(digit)).collect::<Vec<i64>>()
    });
    let distance = |heights: Vec<i64>| {
        let points = integers(&heights);
        farthest(&refined(limit.ring(), &points, levels), &limit.of(&points))
    };
    let near = |(a, b): &(usize, usize), h: &[i64]| (h[*a] - h[*b]).abs() <= 1;
    heights.filter(|h| limit.ring().edges().iter().all(|e| near(e, h))).map(distance).max().unwrap()
}

/// A witness is of spread 1, and as far from its limit as it says.
fn check(limit: &LocalLimit<Rational>, witness: &LocalWitness<Rational>) {
    let points = integers(&witness.ring);
    assert!(spread(limit.ring(), &points) <= Rational::one());
    let moved = refined(limit.ring(), &points, witness.level);
    assert_eq!((&moved[witness.point] - limit.of(&points)).abs(), witness.distance);
}

proptest! {
    #![proptest_config(crate::common::cases(64))]

    #[test]
    fn no_ring_is_farther(
        (limit, points) in convergent(6).prop_flat_map(|limit| {
            let count = limit.ring().point_count();
            (Just(limit), prop::collection::vec(rational(), count))
        })
    ) {
        let distances = LocalDistances::new(limit.clone());
        let at = limit.of(&points);
        prop_assert_eq!(limit.of(&limit.ring().refine(&points)), at.clone());
        let beta = spread(limit.ring(), &points);
        // Far down all points are at the limit.
        let block = u32::try_from(limit.contraction().len() - 1).unwrap();
        let ratio = limit.contraction().last().unwrap().clone();
        let late = refined(limit.ring(), &points, 6 * block);
        let first = distances.constant(0).unwrap().distance;
        prop_assert!(farthest(&late, &at) <= ratio.pow(6) * first * &beta);
        for k in 0..4 {
            let worst = distances.constant(k).unwrap();
            check(&limit, &worst);
            let now = refined(limit.ring(), &points, k);
            prop_assert!(farthest(&now, &at) <= &worst.distance * &beta);
            let later = distances.constant(k + block).unwrap();
            prop_assert!(later.distance <= &ratio * &worst.distance);
            let step = distances.step(k).unwrap();
            let next = limit.ring().refine(&now);
            let moved = now.iter().zip(&next).map(|(old, new)| (new - old).abs());
            prop_assert!(moved.max().unwrap() <= &step.distance * &beta);
            let own = refined(limit.ring(), &integers(&step.ring), k);
            let next = limit.ring().refine(&own);
            prop_assert_eq!((&next[step.point] - &own[step.point]).abs(), step.distance);
            let points = (0..limit.ring().point_count())
                .map(|a| distances.at_point(a, k).unwrap().distance);
            prop_assert_eq!(points.max().unwrap(), worst.distance);
        }
    }

    #[test]
    fn all_integer_rings(limit in convergent(5), k in 0_u32..3) {
        let distances = LocalDistances::new(limit.clone());
        prop_assert_eq!(distances.constant(k).unwrap().distance, brute(&limit, k));
    }

    // Level by level.
    #[test]
    fn depths_are_least(limit in convergent(5), digits in 1_i32..3) {
        let distances = LocalDistances::new(limit.clone());
        let tolerance = Rational::power_of_ten(-digits);
        // Slow ones may need more than the 128 levels that are searched.
        let contraction = limit.contraction();
        prop_assume!(contraction.len() <= 6 && *contraction.last().unwrap() < r(3, 4));
        let found = distances.depth(&r(3, 1), &(&tolerance * r(3, 1))).unwrap();
        let late = found.settled + 5;
        let meets: Vec<bool> =
            (0..late).map(|k| distances.constant(k).unwrap().distance <= tolerance).collect();
        let level = meets.iter().position(|&meets| meets).unwrap();
        let settled = meets.iter().rposition(|&meets| !meets).map_or(0, |k| k + 1);
        prop_assert_eq!((found.level as usize, found.settled as usize), (level, settled));
    }

    // A bound A q^k that is the constant itself at one level.
    #[test]
    fn geometric_bounds(limit in convergent(4), k in 0_u32..4, quotient in 2_i64..20) {
        let distances = LocalDistances::new(limit.clone());
        let ratio = r(quotient, 21);
        let factor = distances.constant(k).unwrap().distance * ratio.pow(-k.cast_signed());
        let levels = |last| {
            (0..=last).map(|k: u32| (distances.constant(k).unwrap(), &factor * ratio.pow(k.cast_signed())))
        };
        match distances.geometric(&factor, &ratio, 12).unwrap() {
            Some(Comparison::Exceeds(witness)) => {
                check(&limit, &witness);
                let first = levels(12).find(|(worst, bound)| worst.distance > *bound).unwrap().0;
                prop_assert_eq!(witness, first);
            }
            Some(Comparison::Within) => {
                prop_assert!(levels(20).all(|(worst, bound)| worst.distance <= bound));
            }
            other => prop_assert!(other.is_none() && levels(12).all(|(w, b)| w.distance <= b)),
        }
    }
}

// Δ' = (2Δ_1, Δ_0/8) on a path that starts at its limit x_0: C_{k+2} = C_k/4, C_0 = 2 by
// |Δ_0 + Δ_1| and C_1 = 17/8 by |2Δ_1 + Δ_0/8|, so that C_1 is above C_0.
#[test]
fn a_distance_that_rises() {
    let rows =
        [[r(1, 1), r(0, 1), r(0, 1)], [r(1, 1), r(-2, 1), r(2, 1)], [r(7, 8), r(-15, 8), r(2, 1)]];
    let orbit = Orbit { name: "end".to_owned(), count: 3 };
    let path =
        LocalRules::new(vec![orbit], rows.map(|row| row.to_vec()).to_vec(), vec![(0, 1), (1, 2)]);
    let distances = LocalDistances::new(LocalLimit::new(&path.unwrap()).unwrap());
    let found = [0, 1, 2, 3].map(|k| distances.constant(k).unwrap().distance);
    assert_eq!(found, [r(2, 1), r(17, 8), r(1, 2), r(17, 32)]);
    let depth = |tolerance: Rational| distances.depth(&r(1, 1), &tolerance).unwrap();
    assert_eq!(depth(r(2, 1)), LocalDepth { level: 0, settled: 2 });
    assert_eq!(depth(r(17, 8)), LocalDepth { level: 0, settled: 0 });
    assert_eq!(depth(r(51, 100)), LocalDepth { level: 2, settled: 4 });
}

fn cosine(p: i64, q: i64) -> RealCyclotomic {
    RealCyclotomic::cosine(&r(p, q)).unwrap()
}

fn distances(scheme: &str) -> LocalDistances {
    LocalDistances::new(LocalLimit::new(&ring(scheme)).unwrap_or_else(|e| panic!("{scheme}: {e}")))
}

// M^k − 11ᵀ/n has the rows 2^−k c + 4^−k (e_0 − 1/n − c), c_j = (2/n)cos(2πj/n): the
// eigenvalues 1/2 for the first harmonic and 1/4 for all others.
#[test]
fn powers_of_doo_sabin_by_the_spectrum() {
    for n in (3..=64).chain([128, 210, 385, 499]) {
        let face = ring(&format!("doo-sabin:n={n}"));
        let mean = r(1, n);
        let row = |k: i32| -> Vec<RealCyclotomic> {
            let entry = |j: i64| {
                let wave = cosine(j, n).times(&r(2, n).into());
                let unit = r(i64::from(j == 0), 1) - &mean;
                let [half, quarter] =
                    [2, 4].map(|d| RealCyclotomic::from(Rational::from(d).pow(-k)));
                let fast = RealCyclotomic::from(unit).minus(&wave).times(&quarter);
                wave.times(&half).plus(&fast).plus(&RealCyclotomic::from(&mean))
            };
            (0..n).map(entry).collect()
        };
        for k in 0..3 {
            assert_eq!(face.pull_back(&row(k)), row(k + 1), "n = {n}, k = {k}");
        }
    }
}

// C_k = 4^−k ⌊n²/4⌋/n + (2^−k − 4^−k) 2 sin²(mπ/n)/(n sin²(π/n)), m = ⌊n/2⌋.
#[test]
fn constants_of_doo_sabin() {
    for n in (3..=12_i64).chain([101, 105]) {
        let distances = distances(&format!("doo-sabin:n={n}"));
        let mean = vec![r(1, n).into(); usize::try_from(n).unwrap()];
        assert_eq!(distances.limit().weights(), mean, "the centroid");
        let one = RealCyclotomic::from(1);
        let slow = one.minus(&cosine(n / 2, n)).times(&r(2, n).into());
        let slow = &slow / &one.minus(&cosine(1, n));
        for k in 0..4 {
            let [half, quarter] = [2, 4].map(|d| RealCyclotomic::from(Rational::from(d).pow(-k)));
            let wanted =
                quarter.times(&r(n * n / 4, n).into()).plus(&half.minus(&quarter).times(&slow));
            let found = distances.constant(k.cast_unsigned()).unwrap();
            assert_eq!(found.distance, wanted, "n = {n}, k = {k}");
        }
    }
}

// (4, 4, 1)/9 at the vertex, shared out among the edges and among the faces; and Catmull
// and Clark's (N, 4, 1)/(N + 5), the latter as Halstead, Kass and DeRose 1993 have it.
#[test]
fn limits_around_a_vertex() {
    for n in 3..=12_i64 {
        let count = usize::try_from(n).unwrap();
        for (scheme, [vertex, edge, face]) in [
            ("bajaj", [r(4, 9), r(4, 9 * n), r(1, 9 * n)]),
            ("catmull-clark", [r(n, n + 5), r(4, n * (n + 5)), r(1, n * (n + 5))]),
        ] {
            let limit = LocalLimit::new(&ring(&format!("{scheme}:N={n}"))).unwrap();
            let wanted = [vec![vertex], vec![edge; count], vec![face; count]].concat();
            let wanted: Vec<RealCyclotomic> = wanted.into_iter().map(Into::into).collect();
            assert_eq!(limit.weights(), wanted, "{scheme}, N = {n}");
        }
    }
}

// The vertex is 4/9 of its distance from the mean of the edge points and 1/9 of that from the
// mean of the face points away from its limit: 4/9 + 2/9.
#[test]
fn distances_around_a_vertex() {
    for n in 3..=9 {
        let distances = distances(&format!("bajaj:N={n}"));
        let vertex = distances.at_point(0, 0).unwrap();
        assert_eq!(vertex.distance, r(2, 3).into(), "N = {n}");
        let mut heights = vec![2];
        heights.extend(vec![1; n]);
        heights.extend(vec![0; n]);
        assert_eq!(vertex.ring, heights);
    }
}

#[test]
fn from_the_bilinear_interpolant() {
    // (7) and (8) of Mustafa, Hashmi and Akhtar 2007: the vertex stays, edge points are
    // midpoints, face points centroids, which they are after the step, too.
    let n = 5_usize;
    let (half, quarter) = (r(1, 2), r(1, 4));
    let count = 2 * n + 1;
    let row = |entries: &[(usize, &Rational)]| {
        let mut row = vec![RealCyclotomic::from(0); count];
        for (at, value) in entries {
            row[*at] = RealCyclotomic::from(*value);
        }
        row
    };
    let edge = |i: usize| row(&[(0, &half), (1 + i, &half)]);
    let face = |i: usize| {
        row(&[(0, &quarter), (1 + i, &quarter), (1 + (i + 1) % n, &quarter), (1 + n + i, &quarter)])
    };
    let rows = [row(&[(0, &Rational::one())])].into_iter();
    let rows = rows.chain((0..n).map(edge)).chain((0..n).map(face)).collect();
    let bajaj = ring("bajaj:N=5");
    let bilinear = LocalRules::new(bajaj.orbits().to_vec(), rows, bajaj.edges().to_vec()).unwrap();
    let distances = LocalDistances::new(LocalLimit::new(&bajaj).unwrap());
    // (13) is sharp: 7/16 + 1/16 of the vertex, and (17) gives less for edge points.
    let step = distances.step_from(&bilinear, 0).unwrap();
    assert_eq!((step.point, step.distance), (0, r(1, 2).into()));
    assert_eq!(distances.step_from(&bajaj, 3).unwrap().distance, RealCyclotomic::from(0));
}

fn two_points(weights: [[i64; 2]; 2]) -> Result<LocalLimit<Rational>, LocalLimitError> {
    let orbit = Orbit { name: "end".to_owned(), count: 2 };
    let rows = weights.map(|row| row.map(Rational::from).to_vec()).to_vec();
    LocalLimit::new(&LocalRules::new(vec![orbit], rows, vec![(0, 1)]).unwrap())
}

#[test]
fn rings_without_a_limit() {
    assert_eq!(
        two_points([[1, 0], [0, 1]]),
        Err(LocalLimitError::NotShown { blocks: 32, least: "1".to_owned() })
    );
    assert_eq!(two_points([[2, -1], [1, 0]]), Err(LocalLimitError::NoLimit));
    // They change places for ever, or run apart.
    let error = two_points([[0, 1], [1, 0]]).unwrap_err();
    assert!(error.to_string().starts_with("the points of the ring are not shown"), "{error}");
    assert!(matches!(two_points([[2, -1], [-1, 2]]), Err(LocalLimitError::NotShown { .. })));
    // Eigenvalues 1 and 0.
    assert!(two_points([[1, 0], [1, 0]]).is_ok());
}

#[test]
fn questions_without_an_answer() {
    let distances = distances("doo-sabin:n=5");
    assert_eq!(distances.constant(129), Err(LocalLimitError::Level(129)));
    for (spread, tolerance) in [(r(0, 1), r(1, 2)), (r(1, 2), r(-1, 2))] {
        let error = distances.depth(&spread, &tolerance).unwrap_err();
        assert!(matches!(error, LocalLimitError::NotPositive { .. }), "{error}");
    }
    let deep = distances.depth(&r(1, 1), &r(2, 1).pow(-200));
    assert_eq!(deep, Err(LocalLimitError::TooDeep));
    assert_eq!(distances.depth(&r(1, 1), &r(9, 1)), Ok(LocalDepth { level: 0, settled: 0 }));
}
