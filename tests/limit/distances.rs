//! Distances from the limit: closed forms, and what polygons do.

use super::values::{convergent, limit};
use crate::common::{at, differences, int, largest, mask, polygon, r, refine};
use proptest::prelude::*;
use subcert::bound::{Constants, SoundBound};
use subcert::exact::{Enclosure, Rational};
use subcert::limit::{ControlPolygon, Distance, Distances, Limit, LimitError, TwoSidedDepth};
use subcert::scheme::{Mask, lagrange_mask};

fn distances(limit: &Limit) -> Distances {
    Distances::new(limit).unwrap_or_else(|error| panic!("{error}"))
}

fn of(scheme: &str) -> Distances {
    distances(&limit(&mask(scheme)))
}

/// The constant at this level, narrow, and attained where it says.
fn constant(
    distances: &Distances,
    level: u32,
    width: &Rational,
) -> Result<Distance, TestCaseError> {
    let constant =
        distances.constant(level, width).map_err(|e| TestCaseError::fail(e.to_string()))?;
    prop_assert!(constant.enclosure.width() <= *width);
    let error = distances.limit().error(level, &constant.parameter).unwrap();
    prop_assert_eq!(&error.norm(), constant.enclosure.lower());
    Ok(constant)
}

/// What is known of the constant at this level, as narrow as the cap on cells allows.
fn known(distances: &Distances, level: u32, width: &Rational) -> Enclosure {
    match distances.constant(level, width) {
        Ok(constant) => constant.enclosure,
        Err(LimitError::TooFine { reached, .. }) => *reached,
        Err(error) => panic!("{error}"),
    }
}

/// The greatest norm of P^∞ − P^k at i/count, i = 0, …, count.
fn greatest_norm(limit: &Limit, k: u32, count: i64) -> Rational {
    let norm = |i| limit.error(k, &r(i, count)).unwrap().norm();
    (0..=count).map(norm).max().unwrap()
}

/// |P^∞ − P^k| at every point of level m, from the polygon of that level alone.
fn sampled(limit: &Limit, points: &[Rational], k: u32, m: u32) -> Rational {
    let n = limit.mask().arity();
    let polygon = |level| (0..level).fold(points.to_vec(), |x, _| refine(limit.mask().rules(), &x));
    let (coarse, fine) = (polygon(k), polygon(m));
    let ratio = n.pow(m - k);
    let zero = limit.at(&Rational::zero()).unwrap();
    let distance = |i: usize| {
        let s = r(int(i % ratio), int(ratio));
        let near = at(&coarse, int(i / ratio)) * (Rational::one() - &s);
        let line = near + at(&coarse, int(i / ratio) + 1) * s;
        zero.apply(|j| at(&fine, int(i) + j).clone()) - line
    };
    largest(&(0..fine.len()).map(distance).collect::<Vec<_>>())
}

proptest! {
    #![proptest_config(crate::common::cases(24))]

    #[test]
    fn no_polygon_is_farther(
        limit in convergent(4, 4), points in polygon(2..7), k in 0_u32..3,
    ) {
        let distances = distances(&limit);
        let width = r(1, 200);
        let constant = constant(&distances, k, &width)?.enclosure;
        let sound = SoundBound::curve(&Constants::new(limit.mask().clone()), 1).unwrap();
        prop_assert!(constant.upper() <= &sound.levels(k).unwrap()[k as usize]);
        let spread = largest(&differences(&points));
        let own = distances.of_polygon(&ControlPolygon::closed(&points), k, &width).unwrap();
        let m = k + if limit.mask().arity() == 2 { 4 } else { 2 };
        let seen = sampled(&limit, &points, k, m);
        prop_assert!(seen <= constant.upper() * &spread);
        prop_assert!(seen <= *own.enclosure.upper());
        prop_assert!(*own.enclosure.lower() <= constant.upper() * &spread);
        // The value at the parameter it names, by the functional.
        let error = limit.error(k, &own.parameter).unwrap();
        let differences = differences(&points);
        let value = error.apply(|i| at(&differences, i).clone()).abs();
        prop_assert_eq!(&value, own.enclosure.lower());
    }

    // The norm of every error functional is a lower bound, of narrow enclosures too, and
    // its level does not meet a tolerance that is a little less.
    #[test]
    fn no_functional_is_greater(limit in convergent(4, 4), k in 0_u32..4) {
        let distances = distances(&limit).with_cells(2_000);
        let n = int(limit.mask().arity());
        let count = n.pow((200_u64).ilog(n.cast_unsigned()).max(k));
        let seen = greatest_norm(&limit, k, count);
        prop_assert!(seen <= *known(&distances, k, &r(1, 1_000_000)).upper());
        if let Ok(depth) = distances.depth(&Rational::one(), &(&seen * r(999, 1000))) {
            prop_assert!(depth.upper != k, "{depth:?} at {seen}");
        }
    }

    #[test]
    fn wide_and_narrow_meet(limit in convergent(3, 4), k in 0_u32..3) {
        let distances = distances(&limit);
        let wide = constant(&distances, k, &r(1, 10))?.enclosure;
        let narrow = constant(&distances, k, &r(1, 500))?.enclosure;
        prop_assert!(wide.lower() <= narrow.upper() && narrow.lower() <= wide.upper());
    }

    // An open polygon has those cells of the closed one that do not go round its end.
    #[test]
    fn open_polygons_are_pieces_of_closed_ones(
        limit in convergent(3, 3), points in polygon(8..14), k in 0_u32..2,
    ) {
        let distances = distances(&limit);
        let width = r(1, 100);
        let closed = distances.of_polygon(&ControlPolygon::closed(&points), k, &width).unwrap();
        match distances.of_polygon(&ControlPolygon::open(&points), k, &width) {
            Ok(open) => {
                prop_assert!(open.enclosure.lower() <= closed.enclosure.upper());
                let last = r(int(points.len()) - 1, 1);
                prop_assert!(Rational::zero() <= open.parameter && open.parameter <= last);
                // Three rounds hold all cells of the closed one.
                let thrice = [points.as_slice(); 3].concat();
                let thrice = distances.of_polygon(&ControlPolygon::open(&thrice), k, &width);
                let (thrice, closed) = (thrice.unwrap().enclosure, closed.enclosure);
                prop_assert!(thrice.lower() <= closed.upper() && closed.lower() <= thrice.upper());
            }
            Err(error) => prop_assert!(matches!(error, LimitError::TooFew { .. }), "{}", error),
        }
    }

    #[test]
    fn depths_are_least(limit in convergent(3, 4), digits in 1_u32..3) {
        let distances = distances(&limit).with_cells(10_000);
        let tolerance = Rational::power_of_ten(-digits.cast_signed());
        let depth = distances.depth(&Rational::one(), &tolerance).unwrap();
        let sound = SoundBound::curve(&Constants::new(limit.mask().clone()), 1).unwrap();
        let least_sound = sound.depth(&Rational::one(), &tolerance).unwrap().level;
        prop_assert!(depth.lower <= depth.upper && depth.upper <= least_sound);
        for k in 0..depth.lower {
            prop_assert!(*known(&distances, k, &r(1, 1000)).upper() > tolerance);
        }
        prop_assert!(*known(&distances, depth.upper, &r(1, 1000)).lower() <= tolerance);
    }
}

fn exactly(value: Rational) -> Enclosure {
    Enclosure::exact(value)
}

// P^∞ on [0, 1] is x_0 + Δ_0/2 + tΔ_0 + t²(Δ_1 − Δ_0)/2, at offset 0: the distance is
// (1 − t²)/2·Δ_0 + t²/2·Δ_1, of norm 1/2 for every t, and Δ^k halves with each level.
#[test]
fn chaikin_by_hand() {
    let distances = of("chaikin");
    for k in 0..12 {
        let half = r(1, 2 << k);
        let constant = distances.constant(k, &r(1, 10)).unwrap();
        assert_eq!(constant.enclosure, exactly(half.clone()), "level {k}");
        // A tie: C_k·3 is the tolerance.
        let depth = distances.depth(&r(3, 1), &(half * r(3, 1))).unwrap();
        assert_eq!(depth, TwoSidedDepth { lower: k, upper: k });
    }
}

// Δ_i = i, and Δ^k_{2^k i} = i/2^k: at the right end, t = 7, the distance is 7/2^{k+1}, and
// less elsewhere. A little less is not enough.
#[test]
fn chaikin_of_a_parabola() {
    let distances = of("chaikin");
    let points: Vec<Rational> = (0..9).map(|i| r(i * (i - 1) / 2, 1)).collect();
    let polygon = ControlPolygon::open(&points);
    for k in 0..9 {
        let greatest = r(7, 2 << k);
        let found = distances.of_polygon(&polygon, k, &r(1, 10_000_000)).unwrap();
        assert!(found.enclosure.contains(&greatest), "level {k}");
        let depth = distances.depth_of_polygon(&polygon, &(greatest * r(999, 1000))).unwrap();
        assert_eq!(depth, TwoSidedDepth { lower: k + 1, upper: k + 1 });
    }
}

// At its points the cubic B-spline is (x_{−1} + 4x_0 + x_1)/6, off by a sixth of the
// second difference, which the scheme averages and divides by 4 at each level. That is
// the greatest distance: 1/3 where Δ_{−1} = −1, Δ_0 = 1.
#[test]
fn cubic_b_spline_by_hand() {
    let distances = of("b-spline:degree=3");
    for k in 0..8 {
        let constant = distances.constant(k, &r(1, 100_000)).unwrap();
        assert_eq!(constant.enclosure, exactly(r(1, 3 << (2 * k))));
    }
    // A tie again, and a little less.
    let depth = distances.depth(&r(3, 1), &r(1, 64)).unwrap();
    assert_eq!(depth, TwoSidedDepth { lower: 3, upper: 3 });
    let depth = distances.depth(&r(3, 1), &r(1, 65)).unwrap();
    assert_eq!(depth, TwoSidedDepth { lower: 4, upper: 4 });
}

// At its points the curve is known from the values of the B-spline at its knots.
#[test]
fn b_splines_at_level_0() {
    assert_eq!(of("b-spline:degree=1").constant(0, &r(1, 9)).unwrap().enclosure, exactly(r(0, 1)));
    // (x_{−1} + 11x_0 + 11x_1 + x_2)/24 − x_0 = −Δ_{−1}/24 + Δ_0/2 + Δ_1/24.
    let quartic = of("b-spline:degree=4").constant(0, &r(1, 100_000)).unwrap();
    assert_eq!(quartic.enclosure, exactly(r(7, 12)));
    // ((x_{−2} + x_2) + 26(x_{−1} + x_1) − 54x_0)/120 = (Δ_1 + 27Δ_0 − 27Δ_{−1} − Δ_{−2})/120.
    let quintic = of("b-spline:degree=5").constant(0, &r(1, 100_000)).unwrap();
    assert_eq!(quintic.enclosure, exactly(r(56, 120)));
}

// Against the norms at all parameters i/n^{k+m}, and a tolerance a little below them.
#[test]
fn named_schemes_against_all_parameters() {
    let lagrange = lagrange_mask(1, 5).unwrap();
    for (mask, k, m) in [
        (mask("four-point"), 0, 9),
        (mask("four-point"), 2, 7),
        (mask("six-point:w=3/256"), 1, 7),
        (mask("ternary-four-point:mu=1/11"), 1, 5),
        (mask("quinary-three-point"), 1, 3),
        (lagrange, 1, 3),
    ] {
        let limit = limit(&mask);
        let width = r(1, 1_000_000);
        let distances = distances(&limit);
        let constant = constant(&distances, k, &width).unwrap().enclosure;
        let n = int(mask.arity());
        let seen = greatest_norm(&limit, k, n.pow(k + m));
        assert!(seen <= *constant.upper());
        assert!(constant.lower() - &seen <= r(1, 300), "{mask:?}: {seen}, {constant:?}");
        let depth = distances.depth(&Rational::one(), &(seen * r(99_999, 100_000))).unwrap();
        assert!(depth.lower > k, "{mask:?}: {depth:?}");
    }
}

#[test]
fn polygons_by_hand() {
    // At the corner the curve is at 4; one level later the points there are 3, 4.5, 3.
    let distances = of("b-spline:degree=3");
    let corner = [0, 0, 0, 6, 0, 0, 0].map(Rational::from);
    let open = distances.of_polygon(&ControlPolygon::open(&corner), 0, &r(1, 1000)).unwrap();
    assert_eq!((open.enclosure, open.parameter), (exactly(r(2, 1)), r(3, 1)));
    let depth = distances.depth_of_polygon(&ControlPolygon::open(&corner), &r(1, 2)).unwrap();
    assert_eq!(depth, TwoSidedDepth { lower: 1, upper: 1 });
    let line: Vec<Rational> = (0..9).map(Rational::from).collect();
    let straight = distances.of_polygon(&ControlPolygon::open(&line), 3, &r(1, 1000)).unwrap();
    assert_eq!(straight.enclosure, exactly(Rational::zero()));
    assert_eq!(ControlPolygon::open(&corner).spread(), r(6, 1));
    for short in [ControlPolygon::open(&corner[..3]), ControlPolygon::closed(&[])] {
        let error = distances.of_polygon(&short, 0, &r(1, 9)).unwrap_err();
        assert!(matches!(error, LimitError::TooFew { .. }), "{error}");
    }
    let point = ControlPolygon::closed(&[r(7, 1)]);
    let still = distances.of_polygon(&point, 2, &r(1, 9)).unwrap();
    assert_eq!(still.enclosure, exactly(Rational::zero()));
}

#[test]
fn questions_without_an_answer() {
    let distances = of("four-point");
    assert_eq!(distances.constant(129, &r(1, 2)), Err(LimitError::Level(129)));
    for (spread, tolerance) in [(r(0, 1), r(1, 2)), (r(1, 2), r(-1, 2))] {
        let error = distances.depth(&spread, &tolerance).unwrap_err();
        assert!(matches!(error, LimitError::NotPositive { .. }), "{error}");
    }
    assert!(distances.constant(0, &Rational::zero()).is_err());
    let few = of("four-point").with_cells(10);
    let Err(LimitError::TooFine { cells: 10, reached }) = few.constant(0, &r(1, 1 << 40)) else {
        panic!("a narrow interval out of ten cells")
    };
    let constant = distances.constant(0, &r(1, 1 << 20)).unwrap().enclosure;
    assert!(reached.lower() <= constant.upper() && constant.lower() <= reached.upper());
    assert!(distances.constant(0, &r(1, 1 << 40)).is_ok());
    let slow = of("four-point").depth(&r(1, 1), &Rational::from(2).pow(-300));
    assert_eq!(slow, Err(LimitError::TooDeep));
    // The four-point scheme at offset −200 compares points far from each other.
    let far: Mask = mask("four-point").with_offset(-200);
    assert!(matches!(Distances::new(&limit(&far)).err(), Some(LimitError::Window(_))));
}
