//! The coefficients of repeated convolution, against products of sequences.

use proptest::prelude::*;
use subcert::bound::{Constants, power_norm};
use subcert::bound::{
    Operator, Order, Recursion, convolution_coefficient, convolution_window, sequence,
};
use subcert::exact::Rational;
use subcert::scheme::{Rules, parse_scheme};

/// t(z)·t(z^n)⋯t(z^{n^{c−1}}), multiplied out.
fn product(t: &[Rational], n: usize, c: u32) -> Vec<Rational> {
    let mut product = vec![Rational::one()];
    for level in 0..c {
        let step = n.pow(level);
        let mut next = vec![Rational::zero(); product.len() + step * (t.len() - 1)];
        for (i, a) in product.iter().enumerate() {
            for (j, b) in t.iter().enumerate() {
                next[i + step * j] += &(a * b);
            }
        }
        product = next;
    }
    product
}

proptest! {
    #![proptest_config(crate::common::cases(40))]

    /// E^c_{l,f} is the coefficient of z^{f − n^c l} in that product.
    #[test]
    fn by_recursion_and_by_products(
        n in 2_usize..4,
        width in 1_usize..4,
        entries in prop::collection::vec(-9_i64..10, 12),
        c in 1_u32..4,
        l in 0_i64..3,
        f in 0_i64..60,
    ) {
        let row = |k: usize| (0..width).map(|j| Rational::new(entries[k * width + j], 4)).collect();
        let rules: Rules = Rules::new((0..n).map(row).collect(), 0).unwrap();
        let t = sequence(&rules, Order::Forward);
        let expected = usize::try_from(f - i64::try_from(n.pow(c)).unwrap() * l).ok();
        let expected = expected.and_then(|at| product(&t, n, c).get(at).cloned());
        let found = convolution_coefficient(&t, n, c, l, f, Recursion::Derived);
        prop_assert_eq!(found, expected.unwrap_or_else(Rational::zero));
    }
}

proptest! {
    #![proptest_config(crate::common::cases(60))]

    /// The window by products against the definition term by term, by both recursions.
    #[test]
    fn a_window_holds_the_coefficients(
        entries in prop::collection::vec(-9_i64..10, 1..6),
        n in 2_usize..4,
        c in 1_u32..4,
        last in 0_usize..70,
        printed in any::<bool>(),
    ) {
        let t: Vec<Rational> = entries.iter().map(|&p| Rational::new(p, 4)).collect();
        let recursion = if printed { Recursion::Printed } else { Recursion::Derived };
        let window = convolution_window(&t, n, c, last, recursion);
        let classes = n.pow(c).min(last + 1);
        prop_assert_eq!(window.len(), classes);
        for (f, row) in (last + 1 - classes..).zip(&window) {
            prop_assert_eq!(row.len(), f / n.pow(c) + 1);
            for (l, found) in (0..).zip(row) {
                let f = i64::try_from(f).unwrap();
                prop_assert_eq!(found, &convolution_coefficient(&t, n, c, l, f, recursion));
            }
        }
    }
}

/// The largest sum of |E^c_{l,f}| over l is the norm of the c-th power, in both orders.
#[test]
fn the_supremum_is_the_constant() {
    for name in ["four-point", "ternary-four-point-approximating", "quinary-three-point"] {
        let scheme = parse_scheme(name).unwrap();
        let mask = scheme.masks()[0];
        let constants = Constants::new(mask.clone());
        for order in [Order::Adjoint, Order::Forward] {
            let t = sequence(constants.difference(), order);
            let n = mask.arity();
            let period = i64::try_from(n.pow(2)).unwrap();
            let reach = i64::try_from(t.len() * (n + 1)).unwrap();
            let sum = |f: i64| -> Rational {
                (0..=f / period)
                    .map(|l| convolution_coefficient(&t, n, 2, l, f, Recursion::Derived).abs())
                    .sum()
            };
            let largest = (reach..reach + period).map(sum).max().unwrap();
            assert_eq!(largest, constants.norm(Operator::Difference, 2, order).unwrap(), "{name}");
            assert_eq!(largest, power_norm(constants.difference(), 2, order).unwrap().value);
        }
    }
}

/// For c = 2 the printed recursion is the derived one; for c = 3 it is not.
#[test]
fn the_printed_recursion() {
    let scheme = parse_scheme("chaikin").unwrap();
    let t = sequence(&scheme.masks()[0].difference(), Order::Adjoint);
    let both = |c, f| {
        [Recursion::Derived, Recursion::Printed]
            .map(|recursion| convolution_coefficient(&t, 2, c, 0, f, recursion))
    };
    for f in 0..20 {
        let [derived, printed] = both(2, f);
        assert_eq!(derived, printed);
    }
    assert!((0..20).any(|f| both(3, f)[0] != both(3, f)[1]));
}
