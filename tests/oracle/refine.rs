//! Exact refinement, against naive versions and laws.

use num_rational::{BigRational, Ratio};
use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::oracle::{
    Boundary, Control, MAX_REFINED_LEVEL, OracleError, SplitMix64, refine_grid, refine_polygon,
    refine_ring,
};
use subcert::scheme::{Rules, parse_local_rules, parse_scheme};

const NAMES: [&str; 6] = [
    "chaikin",
    "four-point:w=1/17",
    "quinary-three-point",
    "newton:j=1,n=3",
    "six-point:w=3/256",
    "b-spline:degree=1",
];

fn rules(name: &str) -> Rules {
    parse_scheme(name).expect("in the catalogue").masks()[0].rules().clone()
}

fn points() -> impl Strategy<Value = Vec<Rational>> {
    let value = (-1_000..1_000_i64, 1..50_i64).prop_map(|(p, q)| Rational::new(p, q));
    prop::collection::vec(value, 1..9)
}

fn boundary() -> impl Strategy<Value = Boundary> {
    prop_oneof![Just(Boundary::Closed), Just(Boundary::Open)]
}

/// Level by level, over fractions.
fn naive(rules: &Rules, points: &[Rational], level: u32, boundary: Boundary) -> Vec<Rational> {
    (0..level).fold(points.to_vec(), |points, _| match boundary {
        Boundary::Closed => rules.refine_closed(&points),
        Boundary::Open => rules.refine_open(&points),
    })
}

proptest! {
    #[test]
    fn as_level_by_level(
        name in prop::sample::select(NAMES.to_vec()),
        points in points(),
        level in 0..4_u32,
        boundary in boundary(),
    ) {
        let rules = rules(name);
        let expected = naive(&rules, &points, level, boundary);
        match refine_polygon(&rules, &points, level, boundary) {
            Ok(found) => prop_assert_eq!(found, expected),
            Err(OracleError::TooFew { .. }) => prop_assert!(expected.is_empty()),
            Err(other) => return Err(TestCaseError::fail(other.to_string())),
        }
    }

    /// p'_{ni+α, mj+β} = Σ a_{α,r} a'_{β,s} p_{i+o+r, j+o'+s}, from its definition.
    #[test]
    fn a_grid_by_its_double_sum(
        names in (prop::sample::select(NAMES.to_vec()), prop::sample::select(NAMES.to_vec())),
        (rows, columns) in (1..5_usize, 1..5_usize),
        seed in any::<u64>(),
    ) {
        let (first, second) = (rules(names.0), rules(names.1));
        let control = Control::seeded_grid(seed, rows, columns);
        let grid = control.values();
        let (found, width) =
            refine_grid([&first, &second], grid, columns, 1, Boundary::Closed).unwrap();
        prop_assert_eq!(width, columns * second.arity());
        let at = |index: usize, offset: i64, by: usize, count: usize| {
            let index = i64::try_from(index + by).unwrap() + offset;
            usize::try_from(index.rem_euclid(i64::try_from(count).unwrap())).unwrap()
        };
        for (place, value) in found.iter().enumerate() {
            let (row, column) = (place / width, place % width);
            let (i, alpha) = (row / first.arity(), row % first.arity());
            let (j, beta) = (column / second.arity(), column % second.arity());
            let mut sum = Rational::zero();
            for (r, a) in first.rows()[alpha].iter().enumerate() {
                for (s, b) in second.rows()[beta].iter().enumerate() {
                    let point = at(i, first.offset(), r, rows) * columns
                        + at(j, second.offset(), s, columns);
                    sum += &(a * b * &grid[point]);
                }
            }
            prop_assert_eq!(value, &sum);
        }
    }

    /// Refining a grid p_i·q_j is refining p and q.
    #[test]
    fn a_product_stays_a_product(p in points(), q in points(), boundary in boundary()) {
        let (first, second) = (rules("chaikin"), rules("newton:j=0,n=3"));
        let grid: Vec<Rational> = p.iter().flat_map(|x| q.iter().map(move |y| x * y)).collect();
        let refined = refine_grid([&first, &second], &grid, q.len(), 2, boundary);
        let fine = (refine_polygon(&first, &p, 2, boundary), refine_polygon(&second, &q, 2, boundary));
        match (refined, fine) {
            (Ok((found, width)), (Ok(p), Ok(q))) => {
                prop_assert_eq!(width, q.len());
                let expected: Vec<Rational> =
                    p.iter().flat_map(|x| q.iter().map(move |y| x * y)).collect();
                prop_assert_eq!(found, expected);
            }
            (Err(_), (p, q)) => prop_assert!(p.is_err() || q.is_err()),
            (Ok(_), _) => return Err(TestCaseError::fail("a grid without its sides")),
        }
    }

    #[test]
    fn a_drawn_control_stays_small(seed in any::<u64>(), count in 0..60_usize) {
        let control = Control::seeded_polygon(seed, count);
        prop_assert_eq!(control.values().len(), count);
        let hundred = Rational::from(100);
        prop_assert!(control.values().iter().all(|x| x.is_integer() && x.abs() <= hundred));
        let longer = Control::seeded_polygon(seed, count + 5);
        prop_assert_eq!(&longer.values()[..count], control.values());
    }
}

/// From the reference implementation in C, as Rosetta Code lists it.
#[test]
fn split_mix_64() {
    let expected = [
        6_457_827_717_110_365_317,
        3_203_168_211_198_807_973,
        9_817_491_932_198_370_423,
        4_593_380_528_125_082_431,
        16_408_922_859_458_223_821,
    ];
    assert_eq!(SplitMix64::new(1_234_567).take(5).collect::<Vec<u64>>(), expected);
}

#[test]
fn points_of_other_crates_are_refined() {
    let rules = rules("four-point:w=1/17");
    let ours = [(1, 3), (-2, 7), (5, 1), (4, 9)].map(|(p, q)| Rational::new(p, q));
    let big = ours.clone().map(BigRational::from);
    let small = ours.clone().map(|x| Ratio::<i64>::try_from(x).expect("small"));
    let wanted = refine_polygon(&rules, &ours, 2, Boundary::Closed);
    assert_eq!(refine_polygon(&rules, &big, 2, Boundary::Closed), wanted);
    assert_eq!(refine_polygon(&rules, &small, 2, Boundary::Closed), wanted);
    let net = refine_grid([&rules, &rules], &ours, 2, 2, Boundary::Closed);
    assert_eq!(refine_grid([&rules, &rules], &big, 2, 2, Boundary::Closed), net);
    assert_eq!(Control::polygon(big.to_vec()), Control::polygon(ours.to_vec()));
    assert_eq!(Control::grid(small.to_vec(), 2), Control::grid(ours.to_vec(), 2));
    let ring = parse_local_rules("doo-sabin:n=4").expect("in the catalogue");
    assert_eq!(refine_ring(&ring, &big, 3), refine_ring(&ring, &ours, 3));
}

#[test]
fn what_is_refused() {
    let rules = rules("four-point");
    let points = [0, 1, 2, 3].map(Rational::from);
    let closed = |points: &[Rational], level| {
        refine_polygon(&rules, points, level, Boundary::Closed).unwrap_err()
    };
    assert_eq!(closed(&[], 1), OracleError::Empty);
    assert_eq!(closed(&points, 18), OracleError::TooMany);
    assert_eq!(closed(&points, MAX_REFINED_LEVEL + 1), OracleError::Level(MAX_REFINED_LEVEL + 1));
    let drawn = Control::seeded_polygon(0, usize::MAX);
    assert_eq!(closed(drawn.values(), 0), OracleError::TooMany);
    // The common denominator is nearly as long as all of them together.
    let long: Vec<Rational> = (1_i64..1_000).map(|i| Rational::new(1, (1 << 60) + i)).collect();
    assert!(matches!(closed(&long, 7), OracleError::TooLong { count: 127_872, bits: 40_000.. }));
    // Four points leave the three from x_1 to x_2, these the middle one, and that nothing.
    assert_eq!(
        refine_polygon(&rules, &points, 3, Boundary::Open).unwrap_err(),
        OracleError::TooFew { level: 2, count: 1, width: 4 }
    );
    let grid = |columns, level| {
        refine_grid([&rules, &rules], &points, columns, level, Boundary::Closed).unwrap_err()
    };
    assert_eq!(grid(3, 1), OracleError::Ragged { count: 4, columns: 3 });
    assert_eq!(grid(0, 1), OracleError::Ragged { count: 4, columns: 0 });
    assert_eq!(grid(2, 9), OracleError::TooMany);
    assert_eq!(Control::grid(points.to_vec(), 3), None);
    assert_eq!(Control::grid(points.to_vec(), 0), None);
    let drawn = Control::seeded_grid(0, usize::MAX, 3);
    let refused = refine_grid([&rules, &rules], drawn.values(), 3, 0, Boundary::Closed);
    assert_eq!(refused.unwrap_err(), OracleError::TooMany);
}

/// An open polygon of 2N − 2 points keeps its length for as long as one likes.
#[test]
fn the_highest_level() {
    let chaikin = rules("chaikin");
    let ends = [0, 1].map(Rational::from);
    let refined = refine_polygon(&chaikin, &ends, MAX_REFINED_LEVEL, Boundary::Open).unwrap();
    // The point 1/4 + (1/4)/2 + (1/4)/4 + … = 1/2 is approached.
    let least = Rational::new(1, 2) * (Rational::one() - Rational::from(2).pow(-64));
    assert_eq!(refined[0], least);
    assert_eq!(refined.len(), 2);
}
