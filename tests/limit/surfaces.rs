//! Distances of nets from tensor product surfaces: against refined nets, all integer nets
//! and closed forms.

use super::values::{convergent, limit};
use crate::common::{int, mask, polygon, r, refine};
use proptest::prelude::*;
use subcert::bound::Budget;
use subcert::exact::{Enclosure, Rational};
use subcert::limit::{
    Comparison, Distances, Functional, Limit, LimitError, Parametrisation, Spreads,
    SurfaceDistances, SurfaceError, SurfaceWitness, TwoSidedDepth,
};

/// A net that closes in both directions: rows i, columns j.
type Net = Vec<Vec<Rational>>;

fn net() -> impl Strategy<Value = Net> {
    (1_usize..5, 1_usize..5)
        .prop_flat_map(|(rows, columns)| prop::collection::vec(polygon(columns..columns + 1), rows))
}

fn transposed(net: &Net) -> Net {
    (0..net[0].len()).map(|j| net.iter().map(|row| row[j].clone()).collect()).collect()
}

/// Each row by `second`, then each column by `first`.
fn both(
    net: &Net,
    first: &dyn Fn(&[Rational]) -> Vec<Rational>,
    second: &dyn Fn(&[Rational]) -> Vec<Rational>,
) -> Net {
    let rows: Net = net.iter().map(|row| second(row)).collect();
    transposed(&transposed(&rows).iter().map(|column| first(column)).collect())
}

fn after(limit: &Limit, points: &[Rational], levels: u32) -> Vec<Rational> {
    (0..levels).fold(points.to_vec(), |points, _| refine(limit.mask().rules(), &points))
}

/// The limit at the points of level m.
fn limits(limit: &Limit, points: &[Rational], m: u32) -> Vec<Rational> {
    let fine = after(limit, points, m);
    let zero = limit.at(&Rational::zero()).unwrap();
    let value = |i: usize| zero.apply(|j| crate::common::at(&fine, int(i) + j).clone());
    (0..fine.len()).map(value).collect()
}

/// P^k at the points of level m.
fn lines(limit: &Limit, points: &[Rational], k: u32, m: u32) -> Vec<Rational> {
    let coarse = after(limit, points, k);
    let ratio = limit.mask().arity().pow(m - k);
    let value = |i: usize| {
        let s = r(int(i % ratio), int(ratio));
        let near = crate::common::at(&coarse, int(i / ratio)) * (Rational::one() - &s);
        near + crate::common::at(&coarse, int(i / ratio) + 1) * s
    };
    (0..coarse.len() * ratio).map(value).collect()
}

fn farthest(left: &Net, right: &Net) -> Rational {
    let pairs = left.iter().flatten().zip(right.iter().flatten());
    pairs.map(|(x, y)| (x - y).abs()).max().unwrap()
}

/// The largest difference along columns, whose index is i, and along rows.
fn spreads(net: &Net) -> [Rational; 2] {
    let along = |net: &Net| {
        let differences = net.iter().flat_map(|row| crate::common::differences(row));
        differences.map(|difference| difference.abs()).max().unwrap()
    };
    [along(&transposed(net)), along(net)]
}

/// The net keeps the spreads, and is as far from its limit as the witness says.
fn check(axes: [&Limit; 2], spreads: &[Rational; 2], witness: &SurfaceWitness) {
    let (rows, columns) = (int(witness.net.len()), int(witness.net[0].len()));
    let value = |i: i64, j: i64| {
        let row = usize::try_from((i - witness.first[0]).clamp(0, rows - 1)).unwrap();
        let column = usize::try_from((j - witness.first[1]).clamp(0, columns - 1)).unwrap();
        Rational::from(witness.net[row][column]) * &witness.unit
    };
    let [top, left] = witness.first;
    for i in top..top + rows {
        for j in left..left + columns {
            assert!((value(i, j) - value(i - 1, j)).abs() <= spreads[0]);
            assert!((value(i, j) - value(i, j - 1)).abs() <= spreads[1]);
        }
    }
    let [s, t] = &witness.parameters;
    let product =
        |one: &Functional, other: &Functional| one.apply(|i| other.apply(|j| value(i, j)));
    let limit = product(&axes[0].at(s).unwrap(), &axes[1].at(t).unwrap());
    let polygon = |axis: &Limit, t| axis.polygon_at(witness.level, t).unwrap();
    let bilinear = product(&polygon(axes[0], s), &polygon(axes[1], t));
    assert_eq!((limit - bilinear).abs(), witness.distance, "{witness:?}");
}

proptest! {
    #![proptest_config(crate::common::cases(12))]

    #[test]
    fn no_net_is_farther(
        first in convergent(2, 3), second in convergent(3, 3), net in net(), k in 0_u32..2,
    ) {
        let spread = spreads(&net);
        prop_assume!(spread.iter().all(|spread| spread.sign() > 0));
        let distances = SurfaceDistances::new(&first, &second).unwrap();
        let given = Spreads::new(&spread[0], &spread[1]).unwrap();
        let (found, witness) = distances.constant(k, &(&spread[0] / r(100, 1)), &given).unwrap();
        check([&first, &second], &spread, &witness);
        prop_assert_eq!(found.lower(), &witness.distance);
        let m = k + 2;
        let surface = both(&net, &|x| limits(&first, x, m), &|x| limits(&second, x, m));
        let bilinear = both(&net, &|x| lines(&first, x, k, m), &|x| lines(&second, x, k, m));
        let seen = farthest(&surface, &bilinear);
        prop_assert!(seen <= *found.upper(), "{} {:?}", seen, found);
        // No net is farther at one of the parameters than the norm there.
        let arities = [first.mask().arity(), second.mask().arity()];
        let corner = distances.at(k, &arities.map(|n| r(1, int(n))), &given).unwrap();
        check([&first, &second], &spread, &corner);
        prop_assert!(corner.distance <= *found.upper());
        let [i, j] = arities.map(|n| n.pow(m - 1));
        prop_assert!((&surface[i][j] - &bilinear[i][j]).abs() <= corner.distance);
        // By the constants of the curves, from below.
        let curve = |limit: &Limit| Distances::new(limit).unwrap().constant(k, &r(1, 1000)).unwrap();
        let sum = curve(&first).enclosure.lower() * &spread[0]
            + curve(&second).enclosure.lower() * &spread[1];
        prop_assert!(sum <= found.upper() * r(1001, 1000));
    }

    // A bound above what is known holds, one below does not.
    #[test]
    fn comparisons(first in convergent(2, 3), second in convergent(2, 3), k in 0_u32..3) {
        let distances = SurfaceDistances::new(&first, &second).unwrap();
        let ones = Spreads::one();
        let (found, _) = distances.constant(k, &r(1, 1000), &ones).unwrap();
        let greater = found.upper() * r(1001, 1000) + r(1, 1_000_000);
        prop_assert_eq!(distances.compare(k, &greater, &ones).unwrap(), Comparison::Within);
        let less = found.lower() * r(99, 100) - r(1, 1_000_000);
        match distances.compare(k, &less, &ones).unwrap() {
            Comparison::Exceeds(witness) => {
                check([&first, &second], &[r(1, 1), r(1, 1)], &witness);
                prop_assert!(witness.distance > less);
            }
            other => prop_assert!(false, "{:?} of {:?}", other, found),
        }
    }

    // All integer nets on the window of a functional.
    #[test]
    fn the_norm_at_a_parameter(
        first in convergent(2, 2), second in convergent(2, 2), costs in (1_i64..3, 1_i64..3),
        places in (0_i64..3, 0_i64..3),
    ) {
        let distances = SurfaceDistances::new(&first, &second).unwrap();
        let spreads = Spreads::new(&r(costs.0, 5), &r(costs.1, 5)).unwrap();
        let parameters = [r(places.0, 2), r(places.1, 2)];
        let found = distances.at(0, &parameters, &spreads).unwrap();
        let (rows, columns) = (found.net.len(), found.net[0].len());
        prop_assume!(rows * columns <= 9);
        let pair = |limit: &Limit, t: &Rational| [limit.at(t).unwrap(), limit.polygon_at(0, t).unwrap()];
        let (s, t) = (pair(&first, &parameters[0]), pair(&second, &parameters[1]));
        let w: Vec<Rational> = (0..rows * columns).map(|at| {
            let (i, j) = (found.first[0] + int(at / columns), found.first[1] + int(at % columns));
            s[0].coefficient(i) * t[0].coefficient(j) - s[1].coefficient(i) * t[1].coefficient(j)
        }).collect();
        let most = brute(&w, columns, costs, &mut Vec::new());
        prop_assert_eq!(found.distance, most / r(5, 1));
    }
}

/// The greatest Σ w P over integer nets with differences of at most `costs`, P = 0 first.
fn brute(w: &[Rational], columns: usize, costs: (i64, i64), net: &mut Vec<i64>) -> Rational {
    let at = net.len();
    if at == w.len() {
        return w.iter().zip(net.iter()).map(|(w, &p)| w * Rational::from(p)).sum();
    }
    let above = at.checked_sub(columns).map(|above| (net[above] - costs.0, net[above] + costs.0));
    let before =
        (!at.is_multiple_of(columns)).then(|| (net[at - 1] - costs.1, net[at - 1] + costs.1));
    let range = match (above, before) {
        (Some(one), Some(other)) => (one.0.max(other.0), one.1.min(other.1)),
        (one, other) => one.or(other).unwrap_or((0, 0)),
    };
    let value = |height| {
        net.push(height);
        let value = brute(w, columns, costs, net);
        net.pop();
        value
    };
    (range.0..=range.1).map(value).max().unwrap_or_else(|| r(-1_000_000, 1))
}

fn of(scheme: &str) -> SurfaceDistances {
    let limit = limit(&mask(scheme));
    SurfaceDistances::new(&limit, &limit).unwrap()
}

// C¹_k is 2^−k/2 for the quadratic B-spline, 4^−k/3 for the cubic one.
#[test]
fn b_splines_by_hand() {
    let spreads = Spreads::new(&r(3, 10), &r(1, 5)).unwrap();
    for (scheme, curve, base) in [("chaikin", r(1, 2), 2), ("b-spline:degree=3", r(1, 3), 4)] {
        let distances = of(scheme);
        for k in 0..6 {
            let wanted = &curve * r(1, 2) * Rational::from(base).pow(-k);
            let level = k.cast_unsigned();
            let (found, witness) = distances.constant(level, &r(1, 10), &spreads).unwrap();
            assert_eq!(found, Enclosure::exact(wanted.clone()), "{scheme}, {k}");
            let curve = limit(&mask(scheme));
            check([&curve, &curve], &[r(3, 10), r(1, 5)], &witness);
            // A tie.
            let within = distances.compare(level, &wanted, &spreads).unwrap();
            assert_eq!(within, Comparison::Within);
            let depth = distances.depth(&spreads, &wanted).unwrap();
            assert_eq!(depth, TwoSidedDepth { lower: level, upper: level });
        }
    }
    // At a point of the net: (16, 4, 1)/36 against 1, that is 5/9 of the four neighbours and
    // the corners: 16/36 + 4·2/36 = 2/3.
    let distances = of("b-spline:degree=3");
    let zero = [Rational::zero(), Rational::zero()];
    let found = distances.at(0, &zero, &Spreads::one()).unwrap();
    assert_eq!(found.distance, r(2, 3));
    assert_eq!(
        found.net,
        [[0, 1, 0], [1, 2, 1], [0, 1, 0]].map(|row| row.map(|x: i64| 2 - x).to_vec())
    );
}

// Where coefficients are negative a surface is farther than the sum of two curves.
#[test]
fn four_points() {
    let curve = limit(&mask("four-point"));
    let distances = of("four-point");
    let ones = Spreads::one();
    let constant = Distances::new(&curve).unwrap().constant(1, &r(1, 10_000)).unwrap();
    let (found, witness) = distances.constant(1, &r(1, 10_000), &ones).unwrap();
    check([&curve, &curve], &[r(1, 1), r(1, 1)], &witness);
    assert!(*found.lower() > constant.enclosure.upper() * r(21, 10), "{found:?}");
    assert!(*found.upper() < constant.enclosure.lower() * r(24, 10), "{found:?}");
    let middle = (found.lower() + found.upper()) / r(2, 1);
    let Comparison::Undecided(known) = distances.compare(1, &middle, &ones).unwrap() else {
        panic!("{found:?}");
    };
    assert!(known.contains(&middle));
    let depth = distances.depth(&ones, &r(1, 100)).unwrap();
    assert_eq!(depth, TwoSidedDepth { lower: 4, upper: 4 });
}

#[test]
fn questions_without_an_answer() {
    let distances = of("chaikin");
    for (first, second) in [(r(0, 1), r(1, 1)), (r(1, 1), r(-1, 1)), (r(1, 1), r(1, 1 << 32))] {
        let error = Spreads::new(&first, &second).unwrap_err();
        assert!(matches!(error, SurfaceError::Spreads { .. }), "{error}");
    }
    let ones = Spreads::one();
    let level = SurfaceError::Limit(LimitError::Level(129));
    assert_eq!(distances.compare(129, &r(1, 2), &ones), Err(level.clone()));
    assert_eq!(distances.at(129, &[r(1, 2), r(1, 2)], &ones), Err(level));
    let error = distances.at(0, &[r(1, 2), r(1, 101)], &ones).unwrap_err();
    assert!(matches!(error, SurfaceError::Limit(LimitError::Parameter { .. })), "{error}");
    assert!(distances.depth(&ones, &Rational::zero()).is_err());
    assert!(distances.constant(0, &Rational::zero(), &ones).is_err());
    let tiny = Rational::from(2).pow(-200);
    assert_eq!(distances.depth(&ones, &tiny), Err(SurfaceError::Limit(LimitError::TooDeep)));
    assert_eq!(
        distances.compare(0, &r(-1, 1), &ones).map(|c| matches!(c, Comparison::Exceeds(_))),
        Ok(true)
    );
    // 21 and 21 points.
    let wide = of("b-spline:degree=21").at(0, &[r(0, 1), r(0, 1)], &ones);
    assert_eq!(wide, Err(SurfaceError::Net(441)));
}

/// In the natural parametrisation: without negative coefficients the constant is the sum of those
/// of the curves; with them, no sampled value is above it.
#[test]
fn natural_constants_of_surfaces() {
    let natural = |first: &str, second: &str| {
        let [first, second] = [first, second].map(|scheme| limit(&mask(scheme)));
        SurfaceDistances::placed(&first, &second, Parametrisation::Natural, &Budget::unlimited())
            .unwrap()
    };
    let ones = Spreads::one();
    let chaikin = natural("chaikin", "chaikin");
    for k in 0..4 {
        let (enclosure, _) = chaikin.constant(k, &r(1, 100_000), &ones).unwrap();
        let expected = r(2, 1) * r(1, 4).pow(k.cast_signed() + 1);
        assert!(enclosure.contains(&expected), "{k}: {enclosure:?}");
    }
    let depth = chaikin.depth(&ones, &r(1, 1000)).unwrap();
    assert_eq!((depth.lower, depth.upper), (5, 5));
    let mixed = natural("ternary-four-point-approximating", "ternary-four-point-approximating");
    for k in 0..3 {
        let (enclosure, witness) = mixed.constant(k, &r(1, 1_000), &ones).unwrap();
        assert_eq!(*enclosure.lower(), witness.distance);
        for (i, j) in [(0, 0), (1, 0), (3, 2), (4, 7)] {
            let at = [r(i, 12), r(j, 12)];
            let found = mixed.at(k, &at, &ones).unwrap();
            assert!(found.distance <= *enclosure.upper(), "{k} {at:?}");
        }
    }
}
