//! Intervals: what holds of the numbers in them.

use proptest::prelude::*;
use subcert::exact::{Enclosed, Enclosure, Rational, format};

fn rational() -> impl Strategy<Value = Rational> {
    (-60_i64..61, 1_i64..12).prop_map(|(p, q)| Rational::new(p, q))
}

/// An interval and a number in it, often an end.
fn interval() -> impl Strategy<Value = (Enclosure, Rational)> {
    (rational(), rational(), 0_i64..5).prop_map(|(a, b, t)| {
        let (lower, upper) = if a <= b { (a, b) } else { (b, a) };
        let inside = &lower + (&upper - &lower) * Rational::new(t, 4);
        (Enclosure::new(lower, upper), inside)
    })
}

proptest! {
    #[test]
    fn operations_hold_what_they_must_and_no_more((x, a) in interval(), (y, b) in interval()) {
        prop_assert!((&x + &y).contains(&(&a + &b)));
        prop_assert!((&x - &y).contains(&(&a - &b)));
        prop_assert!((&x * &y).contains(&(&a * &b)));
        prop_assert!((-&x).contains(&-&a));
        // Both ends are reached, at corners.
        let corners = |f: fn(&Rational, &Rational) -> Rational| {
            let mut values: Vec<Rational> = [x.lower(), x.upper()]
                .into_iter()
                .flat_map(|a| [f(a, y.lower()), f(a, y.upper())])
                .collect();
            values.sort();
            Enclosure::new(values[0].clone(), values[3].clone())
        };
        prop_assert_eq!(&x + &y, corners(|a, b| a + b));
        prop_assert_eq!(&x - &y, corners(|a, b| a - b));
        prop_assert_eq!(&x * &y, corners(|a, b| a * b));
        prop_assert_eq!((&x - &y).width(), x.width() + y.width());
        match x.sign() {
            Some(sign) => prop_assert_eq!(a.sign(), sign),
            None => prop_assert!(x.contains(&Rational::zero())),
        }
    }

    #[test]
    fn a_rational_number_encloses_itself(a in rational(), level in 0_u32..40) {
        prop_assert_eq!(a.enclosure(level), Enclosure::exact(a.clone()));
        prop_assert_eq!(format::fixed(&&a, 3), format::fixed(&a, 3));
    }
}

#[test]
#[should_panic(expected = "an interval from 1 down to 0")]
fn an_interval_runs_upwards() {
    let _ = Enclosure::new(Rational::one(), Rational::zero());
}
