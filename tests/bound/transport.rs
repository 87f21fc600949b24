//! ‖w‖_* against all integer heights, also at costs of edges, and against its closed form
//! on a cycle.

use crate::common::{mesh, r, rational};
use proptest::prelude::*;
use subcert::bound::{Transport, transport, transport_at_costs};
use subcert::exact::{Rational, Real, RealCyclotomic, Scalar};

/// The greatest Σ w_a P_a over integer heights with P_0 = 0 and differences of at most the
/// costs of the edges, chosen point by point. Every point has an edge to an earlier one.
fn brute(
    w: &[Rational],
    edges: &[(usize, usize)],
    costs: &[u32],
    heights: &mut Vec<i64>,
) -> Rational {
    let point = heights.len();
    if point == w.len() {
        return w.iter().zip(heights.iter()).map(|(w, &p)| w * Rational::from(p)).sum();
    }
    let ends = edges.iter().zip(costs).flat_map(|(&(a, b), &cost)| [(a, b, cost), (b, a, cost)]);
    let before: Vec<(i64, i64)> = ends
        .filter(|&(a, b, _)| b == point && a < point)
        .map(|(a, _, cost)| (heights[a] - i64::from(cost), heights[a] + i64::from(cost)))
        .collect();
    let low = before.iter().map(|range| range.0).max().unwrap();
    let high = before.iter().map(|range| range.1).min().unwrap();
    let mut best: Option<Rational> = None;
    for height in low..=high {
        heights.push(height);
        let value = brute(w, edges, costs, heights);
        heights.pop();
        best = Some(best.map_or(value.clone(), |best| best.max(value)));
    }
    best.unwrap_or_else(|| Rational::from(-1_000_000))
}

/// Flow and heights each prove a bound on the norm; together, its value.
fn check<S: Real + Ord + std::fmt::Debug>(w: &[S], edges: &[(usize, usize)], found: &Transport<S>) {
    check_at_costs(w, edges, &vec![1; edges.len()], found);
}

fn check_at_costs<S: Real + Ord + std::fmt::Debug>(
    w: &[S],
    edges: &[(usize, usize)],
    costs: &[u32],
    found: &Transport<S>,
) {
    let Transport { value, flow, heights } = found;
    let mut divergence = vec![S::zero(); w.len()];
    let mut total = S::zero();
    for ((&(a, b), f), &cost) in edges.iter().zip(flow).zip(costs) {
        divergence[a] = divergence[a].plus(f);
        divergence[b] = divergence[b].minus(f);
        total = total.plus(&f.magnitude().times(&S::from_rational(&Rational::from(cost))));
        assert!((heights[a] - heights[b]).abs() <= i64::from(cost), "{heights:?}");
    }
    assert_eq!(divergence, w);
    assert_eq!(total, *value);
    let term = |(w, &p): (&S, &i64)| w.times(&S::from_rational(&Rational::from(p)));
    let terms: Vec<S> = w.iter().zip(heights).map(term).collect();
    assert_eq!(S::total(&terms), *value);
    assert_eq!(heights.iter().min(), Some(&0));
}

fn cosine(p: i64, q: i64) -> RealCyclotomic {
    RealCyclotomic::cosine(&r(p, q)).unwrap()
}

proptest! {
    #![proptest_config(crate::common::cases(200))]
    #[test]
    fn no_integer_heights_are_worth_more(
        (edges, w) in mesh(7).prop_flat_map(|(count, edges)| {
            (Just(edges), prop::collection::vec(rational(), count))
        })
    ) {
        let mut w = w;
        let rest: Rational = w.iter().sum();
        w[0] = &w[0] - rest;
        let found = transport(&w, &edges).unwrap();
        check(&w, &edges, &found);
        let costs = vec![1; edges.len()];
        prop_assert_eq!(found.value, brute(&w, &edges, &costs, &mut vec![0]));
    }

    // Times 1 + cos(2π/n): heights of the same problem, and of least and greatest numbers.
    #[test]
    fn irrational_numbers_have_the_heights_of_rational_ones(
        (edges, w, costs) in mesh(24).prop_flat_map(|(count, edges)| {
            let costs = prop::collection::vec(0_u32..4, edges.len());
            (Just(edges), prop::collection::vec(rational(), count), costs)
        }),
        n in 5_u32..40,
    ) {
        let mut w = w;
        let rest: Rational = w.iter().sum();
        w[0] = &w[0] - rest;
        let factor = &RealCyclotomic::cosine(&r(1, n.into())).unwrap() + &RealCyclotomic::from(1);
        let scaled: Vec<_> = w.iter().map(|w| &RealCyclotomic::from(w) * &factor).collect();
        let found = transport_at_costs(&w, &edges, &costs).unwrap();
        let irrational = transport_at_costs(&scaled, &edges, &costs).unwrap();
        check_at_costs(&scaled, &edges, &costs, &irrational);
        prop_assert_eq!(irrational.value, &RealCyclotomic::from(found.value) * &factor);
        prop_assert_eq!(irrational.heights, found.heights);
    }

    // Differences far below the digits that are kept of rounded numbers.
    #[test]
    fn numbers_that_round_to_the_same(
        (edges, w, small) in mesh(12).prop_flat_map(|(count, edges)| {
            let numbers = || prop::collection::vec(rational(), count);
            (Just(edges), numbers(), numbers())
        }),
        bits in 40_i32..140,
    ) {
        let (large, tiny) = (cosine(1, 5), Rational::from(2).pow(-bits));
        let term = |(w, small): (&Rational, &Rational)| {
            let (w, small) = (RealCyclotomic::from(w), RealCyclotomic::from(small * &tiny));
            &(&w * &large) + &small
        };
        let mut w: Vec<RealCyclotomic> = w.iter().zip(&small).map(term).collect();
        w[0] = &w[0] - &RealCyclotomic::total(&w);
        check(&w, &edges, &transport(&w, &edges).unwrap());
    }

    // Costs from 0 on: what is joined for nothing is of one height.
    #[test]
    fn no_integer_heights_are_worth_more_at_costs(
        (edges, w, costs) in mesh(6).prop_flat_map(|(count, edges)| {
            let costs = prop::collection::vec(0_u32..4, edges.len());
            (Just(edges), prop::collection::vec(rational(), count), costs)
        })
    ) {
        let mut w = w;
        let rest: Rational = w.iter().sum();
        w[0] = &w[0] - rest;
        let found = transport_at_costs(&w, &edges, &costs).unwrap();
        check_at_costs(&w, &edges, &costs, &found);
        prop_assert_eq!(found.value, brute(&w, &edges, &costs, &mut vec![0]));
    }

    // Flow λ more around the cycle: Σ|w_0 + … + w_i − λ|, least at a median.
    #[test]
    fn on_a_cycle_by_a_median(mut w in prop::collection::vec(rational(), 3..14)) {
        let rest: Rational = w.iter().sum();
        w[0] = &w[0] - rest;
        let count = w.len();
        let edges: Vec<_> = (0..count).map(|i| (i, (i + 1) % count)).collect();
        let mut sum = Rational::zero();
        let mut sums: Vec<Rational> = w.iter().map(|w| { sum += w; sum.clone() }).collect();
        sums.sort();
        let median = sums[count / 2].clone();
        let least: Rational = sums.iter().map(|sum| (sum - &median).abs()).sum();
        let found = transport(&w, &edges).unwrap();
        check(&w, &edges, &found);
        prop_assert_eq!(found.value, least);
    }
}

#[test]
fn irrational_amounts() {
    let n = 11_i64;
    let w: Vec<RealCyclotomic> =
        (0..n).map(|j| RealCyclotomic::cosine(&r(j * j + 1, n)).unwrap()).collect();
    let mean = &RealCyclotomic::total(&w) * &r(1, n).into();
    let w: Vec<RealCyclotomic> = w.iter().map(|w| w - &mean).collect();
    let edges: Vec<(usize, usize)> =
        (0..11).flat_map(|i| [(i, (i + 1) % 11), (i, (i + 4) % 11)]).collect();
    check(&w, &edges, &transport(&w, &edges).unwrap());
}

#[test]
fn without_a_balance_there_is_no_norm() {
    let w = [1, 1, -1, -1].map(Rational::from);
    assert!(transport(&w, &[(0, 1), (2, 3)]).is_none());
    assert!(transport(&w[..3], &[(0, 1), (1, 2)]).is_none());
    let apart = transport(&w, &[(0, 2), (3, 1)]).unwrap();
    check(&w, &[(0, 2), (3, 1)], &apart);
    assert_eq!(apart.value, Rational::from(2));
}
