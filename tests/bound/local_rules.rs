//! The constants of rings: against rings refined by hand, closed forms, and spectra.

use crate::common::{any_ring, mask, r, rational, ring};
use proptest::prelude::*;
use subcert::bound::{LocalConstants, LocalWork, MAX_LOCAL_WORK, transport};
use subcert::exact::{Rational, RealCyclotomic, Scalar as _};
use subcert::scheme::{LocalRules, parse_local_rules};

const LEVELS: u32 = 3;

/// max |x_a − x_b| over the edges.
fn spread(ring: &LocalRules<Rational>, points: &[Rational]) -> Rational {
    let differences = ring.edges().iter().map(|&(a, b)| (&points[a] - &points[b]).abs());
    differences.max().expect("a ring has edges")
}

fn refined(ring: &LocalRules<Rational>, points: &[Rational], levels: u32) -> Vec<Rational> {
    (0..levels).fold(points.to_vec(), |points, _| ring.refine(&points))
}

fn integers(heights: &[i64]) -> Vec<Rational> {
    heights.iter().map(|&height| Rational::from(height)).collect()
}

fn largest(values: &[Rational]) -> Rational {
    values.iter().map(Rational::abs).max().expect("a value")
}

proptest! {
    #![proptest_config(crate::common::cases(64))]
    // No ring does worse, and one of integers is as bad.
    #[test]
    fn the_constants_are_the_least_bounds(
        (ring, points) in any_ring(6).prop_flat_map(|ring| {
            let count = ring.point_count();
            (Just(ring), prop::collection::vec(rational(), count))
        })
    ) {
        let constants = LocalConstants::new(&ring, LEVELS).unwrap();
        let before = spread(&ring, &points);
        for c in 1..=LEVELS {
            let (edge, found) = constants.contraction(c).unwrap();
            let after = refined(&ring, &points, c);
            prop_assert!(spread(&ring, &after) <= &found.value * &before);
            prop_assert!(largest(&after) <= &constants.levels[c as usize - 1].norm * largest(&points));
            let worst = integers(&found.heights);
            prop_assert!(spread(&ring, &worst) <= Rational::one());
            let after = refined(&ring, &worst, c);
            prop_assert_eq!((&after[edge.0] - &after[edge.1]).abs(), found.value.clone());
            for d in 1..=LEVELS - c {
                let value = |c| &constants.contraction(c).unwrap().1.value;
                prop_assert!(*value(c + d) <= value(c) * value(d));
            }
        }
        let (point, found) = constants.displacement();
        let moved = |points: &[Rational]| -> Vec<Rational> {
            ring.refine(points).iter().zip(points).map(|(new, old)| new - old).collect()
        };
        prop_assert!(largest(&moved(&points)) <= &found.value * &before);
        prop_assert_eq!(moved(&integers(&found.heights))[*point].clone(), found.value.clone());
    }
}

/// All edges and points give what those up to the rotation give.
#[test]
fn representatives_are_enough() {
    for scheme in ["doo-sabin:n=7", "bajaj:N=5", "catmull-clark:N=6"] {
        let ring = ring(scheme);
        let chosen = ring.representatives();
        assert_eq!(chosen.points.len(), ring.orbits().len(), "{scheme}");
        assert_eq!(chosen.edges.len() * ring.orbits().last().unwrap().count, ring.edges().len());
        let constants = LocalConstants::new(&ring, 1).unwrap();
        let row = |a: usize| ring.weights().row(a);
        let norm = |(a, b): &(usize, usize)| {
            let w: Vec<_> = row(*a).zip(row(*b)).map(|(x, y)| x - y).collect();
            transport(&w, ring.edges()).unwrap().value
        };
        let greatest = ring.edges().iter().map(norm).max();
        assert_eq!(greatest.as_ref(), Some(&constants.contraction(1).unwrap().1.value), "{scheme}");
    }
}

fn first_constant(scheme: &str) -> RealCyclotomic {
    LocalConstants::new(&ring(scheme), 1).unwrap().contraction(1).unwrap().1.value.clone()
}

// x'_vertex − x'_edge[0] of the ring with 0 at the vertex, −1 at edge[0] and its two
// neighbours, −2 at the faces between these, 1 at the other edge points, 2 at the faces
// between those and 0 at the two remaining faces: the worst from N = 4 on. At N = 3 an
// edge between an edge point and a face loses more.
#[test]
fn contraction_around_a_vertex() {
    for n in 3..=16_i64 {
        let [bajaj, catmull_clark] = match n {
            3 => [r(1, 2), r(1, 2)],
            _ => [r(5, 4) - r(3, n), r(3, 4) + r(2 * (n - 6), n * n)],
        };
        assert_eq!(first_constant(&format!("bajaj:N={n}")), bajaj.clone().into(), "{n}");
        assert_eq!(first_constant(&format!("catmull-clark:N={n}")), catmull_clark.into(), "{n}");
        // The 3/4 of Mustafa, Hashmi and Akhtar 2007 holds up to N = 6; from N = 12 on one
        // level does not even contract.
        assert_eq!(bajaj <= r(3, 4), n <= 6);
        assert_eq!(bajaj < r(1, 1), n < 12);
    }
}

// Rows (1/2, a, b, b, a) and (a, 1/2, a, b, b) with a = 3/20 + c/10, b = 1/10 − c/10,
// c = cos 72°, on the ring 1, 0, 0, 1, 2: 1/2 + a − 2b.
#[test]
fn contraction_of_a_pentagon() {
    let c = RealCyclotomic::cosine(&r(1, 5)).unwrap();
    let wanted = &RealCyclotomic::from(r(9, 20)) + &(&RealCyclotomic::from(r(3, 10)) * &c);
    assert_eq!(first_constant("doo-sabin:n=5"), wanted);
}

// M takes cos(2πjm/n) to λ_m times itself, λ_m = 1, 1/2 for m = ±1, 1/4 otherwise.
#[test]
fn spectrum_of_doo_sabin() {
    for n in [3_i64, 4, 5, 7, 12, 30] {
        let face = ring(&format!("doo-sabin:n={n}"));
        for m in 0..=n / 2 {
            let wave: Vec<RealCyclotomic> =
                (0..n).map(|j| RealCyclotomic::cosine(&r(j * m, n)).unwrap()).collect();
            let eigenvalue = RealCyclotomic::from(match m {
                0 => r(1, 1),
                1 => r(1, 2),
                _ => r(1, 4),
            });
            let wanted: Vec<_> = wave.iter().map(|x| x.times(&eigenvalue)).collect();
            assert_eq!(face.refine(&wave), wanted, "{m} of {n}");
        }
    }
}

// The row of M^c is 1/n + 2^−c w + 4^−c (e_0 − 1/n − w), w_j = (2/n)cos(2πj/n): T_c is the
// least Σ_i |s_i − λ| for the sums s_i along the cycle of the difference of two of them, with
// λ their median.
#[test]
fn large_faces_by_the_spectrum() {
    for n in [105_i64, 128, 210] {
        let found = LocalConstants::new(&ring(&format!("doo-sabin:n={n}")), 3).unwrap();
        for c in 1..=3 {
            let [half, quarter] = [2, 4].map(|d| Rational::from(d).pow(-c));
            let row = |j: i64| {
                let cosine = RealCyclotomic::cosine(&r(j, n)).unwrap();
                let wave = &cosine * &RealCyclotomic::from((&half - &quarter) * r(2, n));
                let unit = if j == 0 { quarter.clone() } else { Rational::zero() };
                &wave + &RealCyclotomic::from(unit)
            };
            let mut sums: Vec<RealCyclotomic> = (0..n)
                .scan(RealCyclotomic::from(0), |sum, j| {
                    *sum = &*sum + &(&row(j) - &row((j + n - 1) % n));
                    Some(sum.clone())
                })
                .collect();
            sums.sort();
            let median = sums[sums.len() / 2].clone();
            let off: Vec<_> = sums.iter().map(|s| (s - &median).abs()).collect();
            let level = &found.levels[usize::try_from(c - 1).unwrap()];
            assert_eq!(level.contraction().1.value, RealCyclotomic::total(&off), "{n}, {c}");
            assert_eq!(level.norm, RealCyclotomic::from(1), "a mean, {n}, {c}");
        }
    }
}

// A vertex of valence 4 is regular: its ring is the 3×3 grid of the bicubic B-spline.
#[test]
fn valence_four_is_bicubic() {
    let cubic = mask("b-spline:degree=3");
    let [even, odd] = cubic.rules().rows() else { panic!("binary") };
    // The weights of x_{−1}, x_0, x_1 in the new points left of 0, at 0 and right of 0.
    let zero = Rational::zero();
    let right = vec![zero.clone(), odd[1].clone(), odd[2].clone()];
    let left = vec![odd[1].clone(), odd[2].clone(), zero];
    let rows = [left, even.clone(), right];
    // Around the grid: edge[i] and, between it and edge[i + 1], face[i].
    let places = [(1, 1), (2, 1), (1, 2), (0, 1), (1, 0), (2, 2), (0, 2), (0, 0), (2, 0)];
    for scheme in ["catmull-clark:N=4", "bajaj:N=4"] {
        let ring = ring(scheme);
        for (a, (x, y)) in places.into_iter().enumerate() {
            let wanted: Vec<RealCyclotomic> = places
                .iter()
                .map(|&(s, t): &(usize, usize)| {
                    let (x, y): (usize, usize) = (x, y);
                    (&rows[x][s] * &rows[y][t]).into()
                })
                .collect();
            assert!(ring.weights().row(a).eq(&wanted), "{scheme}");
        }
    }
}

#[test]
fn too_much_work_is_refused() {
    let ring = ring("doo-sabin:n=97");
    let Err(error) = LocalConstants::new(&ring, 1_000) else { panic!("too much") };
    assert!(
        matches!(error, LocalWork { points: 97, levels: 1_000, work } if work > MAX_LOCAL_WORK)
    );
    assert!(LocalWork::check(&ring, 2, 2).is_ok());
}

/// The bounds of Doo and Sabin's scheme by the longest edge suppose it.
#[test]
fn one_level_of_doo_and_sabin_contracts_below_three_quarters() {
    for n in 3..=40 {
        let ring = parse_local_rules(&format!("doo-sabin:n={n}")).expect("a ring");
        let constants = LocalConstants::new(&ring, 1).expect("small");
        let (_, found) = constants.contraction(1).expect("a constant");
        assert!(found.value < RealCyclotomic::from(Rational::new(3, 4)), "{n}: {}", found.value);
    }
}
