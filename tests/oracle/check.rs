//! Checks and assertions: what passes, what does not, and what is said.

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::float::{nearest, ulp, ulps_between};
use subcert::oracle::{Mismatch, check_slice_within_ulps, check_within, check_within_ulps};
use subcert::{assert_slice_within_ulps, assert_within, assert_within_ulps};

fn third() -> Rational {
    Rational::new(1, 3)
}

#[test]
fn the_limit_itself_is_within() {
    assert!(check_within_ulps(1.0 + f64::EPSILON, &Rational::one(), 1.0).is_ok());
    assert!(check_within_ulps(1.0 + f64::EPSILON, &Rational::one(), 1.0_f64.next_down()).is_err());
    assert!(check_within_ulps(0.25, &Rational::new(1, 4), 0.0).is_ok());
    assert!(check_within_ulps(1.0 / 3.0, &third(), 0.0).is_err());
    assert!(check_within_ulps(1.0 / 3.0, &third(), 0.5).is_ok());
    let tenth = Rational::new(1, 10);
    assert!(check_within(1.0 / 3.0, &third(), &Rational::power_of_ten(-16)).is_ok());
    assert!(check_within(0.75, &(Rational::new(3, 4) + &tenth), &tenth).is_ok());
    assert!(check_within(0.75, &(Rational::new(76, 100) + &tenth), &tenth).is_err());
}

#[test]
fn what_is_not_a_number_is_never_within() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(check_within_ulps(value, &third(), 1e300).is_err());
        assert!(check_within_ulps(value, &third(), f64::INFINITY).is_err());
        assert!(check_within(value, &third(), &Rational::power_of_ten(300)).is_err());
    }
    assert!(check_within_ulps(-1e300, &third(), f64::INFINITY).is_ok());
    let beyond = Rational::power_of_ten(400);
    assert!(check_within_ulps(f64::INFINITY, &beyond, f64::INFINITY).is_err());
}

#[test]
fn what_a_mismatch_says() {
    let error = check_within_ulps(0.37, &Rational::new(3, 8), 2.0).unwrap_err();
    assert_eq!(
        error.to_string(),
        "an f64 is not within 2 ulps of its exact value\n  exact        3/8\n  decimal      \
         3.7500000000000000e-1\n  nearest f64  0.375 (0x1.8p-2)\n  found f64    0.37 \
         (0x1.7ae147ae147aep-2)\n  distance     9.007e13 ulps"
    );
    let error = check_within_ulps(f64::NAN, &third(), 2.0).unwrap_err().to_string();
    assert!(error.contains("found f64    NaN (nan)\n  distance     none: it is not finite"));
    let long = Rational::from(7).pow(-400);
    let error = check_within(1.0, &long, &third()).unwrap_err().to_string();
    assert!(error.contains("not within 1/3 of"), "{error}");
    assert!(error.contains("p/q of 340 digits"), "{error}");
}

#[test]
fn slices_report_the_first_and_the_worst() {
    let exact = [1, 2, 3, 4, 5].map(Rational::from);
    let mut values = [1.0, 2.0, 3.0, 4.0, 5.0];
    assert!(check_slice_within_ulps(&values, &exact, 0.0).is_ok());
    values[1] = 2.0_f64.next_up();
    values[3] = 4.1;
    let Err(Mismatch::Slice { wrong, total, first, worst, .. }) =
        check_slice_within_ulps(&values, &exact, 0.5)
    else {
        panic!("two values are off")
    };
    assert_eq!((wrong, total, first.index, worst.index), (2, 5, Some(1), Some(3)));
    values[2] = f64::INFINITY;
    values[4] = 1e300;
    let Err(Mismatch::Slice { wrong, worst, .. }) = check_slice_within_ulps(&values, &exact, 0.5)
    else {
        panic!("four values are off")
    };
    assert_eq!((wrong, worst.index), (4, Some(2)));
    let error = check_slice_within_ulps(&values[..4], &exact, 0.5).unwrap_err();
    assert_eq!(error, Mismatch::Length { values: 4, exact: 5 });
}

#[test]
fn assertions_take_what_users_have() {
    let exact = vec![third(), Rational::one()];
    let values = [1.0 / 3.0, 1.0];
    assert_within_ulps!(values[0], &exact[0], 1.0);
    assert_within_ulps!(values[0], exact[0], 1.0, "rule {}", 3);
    assert_slice_within_ulps!(values, exact, 0.5);
    assert_slice_within_ulps!(&values[..], &exact, 0.5, "all of {}", "them");
    assert_within!(values[0], third(), &Rational::power_of_ten(-15));
}

#[test]
fn assertions_take_numbers_of_other_crates() {
    let exact = [BigRational::new(1.into(), 3.into()), BigRational::from(BigInt::from(1))];
    let values = [1.0 / 3.0, 1.0];
    assert_within_ulps!(values[0], &exact[0], 0.5);
    assert_within_ulps!(values[1], BigInt::from(1), 0.0);
    assert_within_ulps!(0.5, Ratio::new(1_i64, 2), 0.0, "a half");
    assert_slice_within_ulps!(values, exact, 0.5);
    assert_within!(values[0], exact[0], Ratio::new(1, 1_000_000_000_000_000_i64));
    assert!(check_within_ulps(0.3, &exact[0], 1.0).is_err());
    assert!(check_within(0.3, &exact[0], &Ratio::new(1_i64, 31)).is_err());
}

#[test]
#[should_panic(
    expected = "rule 3: an f64 is not within 1 ulps of its exact value\n  exact        1/3"
)]
fn an_assertion_that_fails() {
    assert_within_ulps!(0.3, third(), 1.0, "rule {}", 3);
}

#[test]
#[should_panic(
    expected = "1 of 2 f64 are not within 1 ulps of their exact values\nthe first:\n  at index     1"
)]
fn a_slice_assertion_that_fails() {
    assert_slice_within_ulps!([1.0 / 3.0, 0.3], [third(), third()], 1.0);
}

#[test]
#[should_panic(expected = "an f64 is not within 1/10 of its exact value")]
fn an_absolute_assertion_that_fails() {
    assert_within!(0.1, third(), Rational::new(1, 10));
}

#[test]
#[should_panic(expected = "a tolerance in ulps must be 0 or more, and is -1")]
fn a_negative_tolerance_is_misuse() {
    let _ = check_within_ulps(1.0, &Rational::one(), -1.0);
}

#[test]
#[should_panic(expected = "a tolerance in ulps must be 0 or more, and is NaN")]
fn a_tolerance_that_is_not_a_number_is_misuse() {
    let _ = check_slice_within_ulps::<Rational>(&[], &[], f64::NAN);
}

#[test]
#[should_panic(expected = "a tolerance must not be negative, and is -1/3")]
fn a_negative_absolute_tolerance_is_misuse() {
    let _ = check_within(1.0, &Rational::one(), &-third());
}

proptest! {
    /// The check is the comparison of |value − exact| with so many units.
    #[test]
    fn as_its_definition(p in -1_000..1_000_i64, q in 1..1_000_i64, steps in 0..8_u32, ulps in 0.0..9.0_f64) {
        let exact = Rational::new(p, q);
        let near = nearest(&exact);
        let value = (0..steps).fold(near, |value, _| value.next_up());
        let distance = (subcert::float::exact(value).unwrap() - &exact).abs();
        let allowed = subcert::float::exact(ulps).unwrap() * ulp(near).unwrap();
        prop_assert_eq!(check_within_ulps(value, &exact, ulps).is_ok(), distance <= allowed);
        prop_assert_eq!(check_within(value, &exact, &allowed).is_ok(), distance <= allowed);
        prop_assert!(ulps_between(near, &exact).unwrap() <= Rational::new(1, 2));
    }
}
