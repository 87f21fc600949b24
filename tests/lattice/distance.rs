//! Distances of nets from limits, and values of limits.

use super::examples::{BUTTERFLY, QUINCUNX, TRIANGLES};
use super::laws::refined;
use crate::common::{cases, r};
use proptest::prelude::*;
use std::collections::BTreeMap;
use subcert::exact::Rational;
use subcert::lattice::{
    Functional, LatticeConstants, LatticeDistance, limit_values, natural_shift,
};
use subcert::scheme::{LatticeMask, Point, difference, parse_lattice, sum};

fn read(text: &str) -> LatticeMask {
    parse_lattice(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn distance(mask: &LatticeMask, shift: &[Rational]) -> LatticeDistance {
    let mut all = LatticeConstants::new(mask);
    let mut constants = vec![Rational::one()];
    for _ in 0..4 {
        all.advance().expect("few");
        constants.push(all.contraction().expect("few").value);
    }
    LatticeDistance::of(mask, shift, constants).expect("few places").expect("in the plane")
}

/// Lower ends of C_0, C_1, C_2 at the natural places, and upper ends that are at most so many times as large.
#[test]
fn known_distances() {
    for (text, lower, times) in [
        (
            format!("(1+x)^2*(1+y)^2*(1+x*y)^2/16{TRIANGLES}"),
            [r(1, 2), r(1, 8), r(1, 32)],
            r(11, 10),
        ),
        ("(1+x)^4*(1+y)^4/64".to_owned(), [r(2, 3), r(1, 6), r(1, 24)], r(11, 10)),
        ("(1+x)*(1+y)*(1+x*y)*(1+x/y)/4".to_owned(), [r(1, 2), r(1, 8), r(1, 32)], r(3, 2)),
        (
            format!("{BUTTERFLY}:w=1/16,{}", &TRIANGLES[1..]),
            [r(17, 64), r(61, 512), r(13, 256)],
            r(2, 1),
        ),
    ] {
        let mask = read(&text);
        let found = distance(&mask, &natural_shift(&mask));
        assert!(
            found.lower[..3].iter().zip(&lower).all(|(x, y)| x >= y),
            "{text}: {:?}",
            &found.lower[..3]
        );
        for (k, low) in (0..).zip(&found.lower[..3]) {
            let high = found.upper(k).expect("it contracts");
            assert!(*low <= high && high <= low * &times, "{text}: C_{k} from {low} to {high}");
        }
    }
}

/// A scheme that diverges has no distances.
#[test]
fn without_limits() {
    let mask = read("(1+x)*(1+y)*(1+x*y)/2*(1+3*(x-1)*(y-1))");
    let mut all = LatticeConstants::new(&mask);
    all.advance().expect("few");
    let constants = vec![Rational::one(), all.contraction().expect("few").value];
    let zero = [Rational::zero(), Rational::zero()];
    assert!(LatticeDistance::of(&mask, &zero, constants).expect("few places").is_none());
}

/// φ(α) at the points M^{−k}α sums to m^k, fulfils its equation, and is the product of its factors.
#[test]
fn values_of_limits() {
    for text in [
        format!("{BUTTERFLY}:w=1/16,{}", &TRIANGLES[1..]),
        format!("1+(x+1/x+y+1/y)/4{QUINCUNX}"),
        "(1+x)^2*(1+y)^3/8:dilation=[[2,0],[0,2]]".to_owned(),
    ] {
        let mask = read(&text);
        let values = |level| limit_values(&mask, level).expect("few").expect("it converges");
        let mut classes = 1_i64;
        for level in 0..3 {
            let (coarse, fine) = (values(level), values(level + 1));
            assert_eq!(
                coarse.values().cloned().sum::<Rational>(),
                Rational::from(classes),
                "{text}"
            );
            classes *= i64::try_from(mask.dilation().class_count()).expect("few");
            // φ(M^{−k−1}α) = Σ a(γ)φ(M^{−k}(α − M^kγ)).
            for (alpha, value) in &fine {
                let moved = |gamma: &Point| {
                    (0..level).fold(*gamma, |point, _| mask.dilation().times(point))
                };
                let terms = mask.coefficients().iter().filter_map(|(gamma, c)| {
                    Some(c * coarse.get(&difference(*alpha, moved(gamma)))?)
                });
                assert_eq!(terms.sum::<Rational>(), *value, "{text} at {alpha:?}");
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(24))]

    /// Data of zeros and ones have spread 1 along any edges: at the points of each level they are no farther from their limit than the bounds say.
    #[test]
    fn nets_of_zeros_and_ones_are_within_the_bounds(
        net in prop::collection::btree_set((-2_i64..3, -2_i64..3), 1..14),
        which in 0_usize..4,
    ) {
        let texts = [
            format!("(1+x)^2*(1+y)^2*(1+x*y)^2/(16*x^2*y^2){TRIANGLES}"),
            format!("{BUTTERFLY}:w=1/16,{}", &TRIANGLES[1..]),
            format!("1+(x+1/x+y+1/y)/4{QUINCUNX}"),
            "(1+x)^4*(1+y)^3/(32*x^2*y)".to_owned(),
        ];
        let mask = read(&texts[which]);
        let found = distance(&mask, &[Rational::zero(), Rational::zero()]);
        let phi = limit_values(&mask, 0).expect("few").expect("it converges");
        let mut net: Functional<Rational> =
            net.into_iter().map(|(x, y)| ([x, y, 0], Rational::one())).collect();
        for k in 0..3 {
            let most = found.upper(k).expect("it contracts");
            let mut limit: Functional<Rational> = BTreeMap::new();
            for (place, p) in &net {
                for (beta, value) in &phi {
                    *limit.entry(sum(*place, *beta)).or_insert_with(Rational::zero) += &(p * value);
                }
            }
            for (place, value) in &limit {
                let own = net.get(place).cloned().unwrap_or_else(Rational::zero);
                prop_assert!((value - &own).abs() <= most, "{} at {place:?} of level {k}", texts[which]);
            }
            net = refined(&mask, &net);
        }
    }
}
