//! Values and shapes over any ordered field, against those of rational masks.

use proptest::prelude::*;
use subcert::exact::{Rational, RealCyclotomic};
use subcert::limit::Limit;
use subcert::scheme::{Mask, parse_scheme};
use subcert::smoothness::{
    Kept, LimitValues, Shape, Symbol, basic, is_contractive, is_shape_kept, shape_kept,
};

/// Masks (1 + z)^order·b(z) with the sum 2.
fn mask() -> impl Strategy<Value = Option<Mask>> {
    (1_usize..4, proptest::collection::vec(-2_i64..4, 1..4), -4_i64..3).prop_map(
        |(order, inner, shift)| {
            let sum: i64 = inner.iter().sum();
            let terms: Vec<String> =
                inner.iter().enumerate().map(|(k, c)| format!("({c})*z^{k}")).collect();
            let factors = vec!["(1 + z)"; order].join("*");
            let scale = format!("(2^{order}*({sum}))");
            let text = format!("z^{shift}*2*{factors}*({})/{scale}", terms.join(" + "));
            (sum != 0)
                .then(|| parse_scheme(&text).ok()?.masks().first().map(|mask| (*mask).clone()))?
        },
    )
}

proptest! {
    #[test]
    fn values_are_those_of_the_limit(mask in mask(), p in -30_i64..31, k in 0_u32..4) {
        let Some(mask) = mask else { return Ok(()) };
        prop_assume!(is_contractive(&mask, 256));
        let limit = Limit::new(&mask).expect("it converges");
        let symbol = Symbol::of(&mask);
        let values = LimitValues::new(&symbol).expect("unique values");
        let x = Rational::new(p, 2_i64.pow(k));
        prop_assert_eq!(values.at(&x), Some(basic(&limit, &x).expect("a short mask")), "at {}", x);
        // Over another field the same.
        let numbers = mask.map(|c| RealCyclotomic::from(c.clone()));
        let others = LimitValues::new(&Symbol::of(&numbers)).expect("unique values");
        prop_assert_eq!(others.at(&x).and_then(|value| value.as_rational().cloned()), values.at(&x));
        for shape in [Shape::Positive, Shape::Monotone, Shape::Convex] {
            let kept = shape_kept(&limit, shape).expect("a short mask");
            match is_shape_kept(&symbol, &values, shape) {
                Some(true) => prop_assert!(matches!(kept, Kept::Always { .. }), "{kept:?}"),
                Some(false) => prop_assert!(matches!(kept, Kept::NotAlways { .. }), "{kept:?}"),
                None => {}
            }
        }
    }
}
