//! Branch and bound against the walk over all rows.

use super::row_bounds::{power_row, size};
use crate::common::{affine, mask, r, rules};
use proptest::prelude::*;
use subcert::bound::{
    JointSearch, Order, PowerSearch, joint_norm, power_norm, power_norm_generic, walked_joint_norm,
    walked_norm,
};
use subcert::exact::{Integer, Rational};
use subcert::scheme::{Rules, lagrange_mask};

const ORDERS: [Order; 2] = [Order::Adjoint, Order::Forward];

/// The most levels with at most so many classes.
fn levels(rules: &Rules, classes: usize) -> u32 {
    classes.ilog(rules.arity())
}

/// Coefficients over denominators of up to 64 bits.
fn wide(arity: usize, width: usize) -> impl Strategy<Value = Rules> {
    let entry = (any::<i64>(), 1..=u64::MAX).prop_map(|(p, q)| Rational::new(p, q));
    (2..=arity, 1..=width, -3_i64..4).prop_flat_map(move |(arity, width, offset)| {
        let rows = prop::collection::vec(prop::collection::vec(entry.clone(), width), arity);
        rows.prop_map(move |rows| Rules::new(rows, offset).unwrap())
    })
}

/// The value and the least row of the walk, for every c up to `most`.
fn agree(rules: &Rules, most: u32) -> Result<(), TestCaseError> {
    for order in ORDERS {
        let mut search = PowerSearch::new(rules, order);
        for c in 0..=most {
            let found = search.search(c).expect("the work suffices").norm;
            prop_assert_eq!(&found, &walked_norm(rules, c, order).unwrap(), "c = {}", c);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(crate::common::cases(96))]

    // Difference masks: those of Lagrange's schemes keep lines, those of random masks do not.
    #[test]
    fn difference_masks(mask in affine(6, 10)) {
        let rules = mask.difference();
        agree(&rules, levels(&rules, 300))?;
        // The rows of the mask itself sum to 1.
        agree(mask.rules(), levels(&rules, 300))?;
    }

    #[test]
    fn any_rules(rules in rules(6, 10)) {
        agree(&rules, levels(&rules, 300))?;
    }

    // Beyond 128 bits, and beyond what words hold.
    #[test]
    fn large_denominators(rules in wide(4, 4)) {
        agree(&rules, levels(&rules, 70))?;
        let most = levels(&rules, 20);
        let norm = power_norm(&rules, most, Order::Adjoint).unwrap();
        prop_assert_eq!(norm.value, power_norm_generic(&rules, most, Order::Adjoint).unwrap());
    }

    #[test]
    fn joint_suprema(mask in affine(4, 6)) {
        let difference = mask.difference();
        let most = levels(&difference, 2000);
        for order in ORDERS {
            for c in most - 1..=most {
                let joint = joint_norm(&difference, mask.rules(), c, order).unwrap();
                let read = |rules: &Rules| match order {
                    Order::Adjoint => rules.with_offset(0),
                    Order::Forward => rules.reversed().with_offset(0),
                };
                let (first, second) = (read(&difference), read(mask.rules()));
                let walked = walked_joint_norm(&first, &second, c, Order::Adjoint).unwrap();
                prop_assert_eq!(joint, walked);
            }
        }
    }

    // Every width of integers: a factor of 2^-bits in one mask that is an average of two.
    #[test]
    fn every_width(bits in 1_u32..120, numerator in 1_i64..1000) {
        let weight = Rational::from(numerator) / Rational::from(2).pow(bits.cast_signed() + 10);
        let [first, second] = ["four-point", "b-spline:degree=5"].map(mask);
        let rows = first.rules().rows().iter().zip(second.rules().rows()).map(|(x, y)| {
            let pad = |row: &Vec<Rational>| {
                let mut row = row.clone();
                row.resize(4, Rational::zero());
                row
            };
            let mixed = pad(x).into_iter().zip(pad(y));
            mixed.map(|(x, y)| &x + (y - &x) * &weight).collect()
        });
        let mixed = Rules::new(rows.collect(), 0).unwrap();
        agree(&mixed, 9)?;
    }
}

// Interpolating, for several arities: lines are kept, and more.
#[test]
fn lagrange_schemes() {
    for (points, arity, most) in
        [(1, 2, 12), (2, 2, 12), (1, 3, 8), (2, 3, 7), (1, 4, 6), (1, 6, 5)]
    {
        let mask = lagrange_mask(points, arity).unwrap();
        agree(&mask.difference(), most).unwrap();
        agree(mask.rules(), most).unwrap();
    }
}

// The differences of the four-point scheme: 2^c·T_c = (4 − 4^{−c})/3.
#[test]
fn the_four_point_scheme_in_closed_form() {
    let mut search = PowerSearch::new(&mask("four-point").difference(), Order::Adjoint);
    for c in [1, 2, 3, 10, 17, 64, 100] {
        let found = search.search(c).unwrap();
        let scaled = (Rational::from(4) - Rational::from(4).pow(-c.cast_signed())) / r(3, 1);
        assert_eq!(found.norm.value, scaled * r(1, 2).pow(c.cast_signed()), "c = {c}");
        assert!(found.nodes < 20 * u64::from(c) + 20, "{} nodes for c = {c}", found.nodes);
    }
}

// 5^c·T_c of the quinary three-point scheme is 6·(7/5)^c − 5: it grows, so that every T_m is needed.
#[test]
fn growing_norms_in_closed_form() {
    let mut search = PowerSearch::new(&mask("quinary-three-point").difference(), Order::Adjoint);
    for c in [1, 5, 40, 41, 17, 64] {
        let found = search.search(c).unwrap();
        let scaled = r(6, 1) * r(7, 5).pow(c.cast_signed()) - r(5, 1);
        assert_eq!(found.norm.value, scaled * r(1, 5).pow(c.cast_signed()), "c = {c}");
    }
}

// Long searches, which find greater rows again and again.
#[test]
fn a_quarter_of_a_million_rows() {
    for (scheme, c) in
        [("four-point", 18), ("quaternary-four-point:mu=0", 9), ("six-point:w=3/256", 17)]
    {
        let mask = mask(scheme);
        let difference = mask.difference();
        let joint = joint_norm(&difference, mask.rules(), c - 2, Order::Adjoint).unwrap();
        let [first, second] = [&difference, mask.rules()].map(|rules| rules.with_offset(0));
        let walked = walked_joint_norm(&first, &second, c - 2, Order::Adjoint).unwrap();
        assert_eq!(joint, walked, "{scheme}");
        for rules in [&difference, mask.rules()] {
            for order in ORDERS {
                let found = PowerSearch::new(rules, order).search(c).expect("the work suffices");
                assert_eq!(found.norm, walked_norm(rules, c, order).unwrap(), "{scheme}");
            }
        }
    }
}

// Their product has its maximum where one norm grows and the other falls. For the four-point scheme
// the sums of E = 2D are nowhere smooth, and greater rows are found again and again.
#[test]
fn joint_suprema_of_many_levels() {
    for (scheme, c, most) in [
        ("four-point", 64, 1000),
        ("four-point", 256, 4000),
        ("ternary-four-point:mu=1/11", 64, 400),
    ] {
        let mask = mask(scheme);
        let difference = mask.difference();
        let joint = JointSearch::new(&difference, mask.rules(), Order::Adjoint).search(c).unwrap();
        assert!(joint.nodes < most, "{scheme}, c = {c}: {} nodes", joint.nodes);
        let joint = joint.norm;
        let norm = |rules: &Rules| power_norm(rules, c, Order::Adjoint).unwrap().value;
        assert!(joint.value <= norm(&difference) * norm(mask.rules()));
        let row =
            |rules: &Rules| size(&power_row(&rules.with_offset(0), &r(1, 1), c, &joint.class));
        assert_eq!(joint.value, row(&difference) * row(mask.rules()));
        // The neighbours are not greater.
        let [difference, mask] = [&difference, mask.rules()].map(|rules| rules.with_offset(0));
        for step in [-2, -1, 1, 2] {
            let class = &joint.class + Integer::from(step);
            let row = |rules: &Rules| size(&power_row(rules, &r(1, 1), c, &class));
            assert!(row(&difference) * row(&mask) <= joint.value);
        }
    }
}

// Rows that are read forwards: the lines of a node do not show which of its parts is greatest.
#[test]
fn forward_norms_of_many_levels() {
    for (scheme, c, most) in [("four-point", 64, 10_000), ("quinary-three-point", 40, 10_000)] {
        for rules in [mask(scheme).difference(), mask(scheme).rules().clone()] {
            let found = PowerSearch::new(&rules, Order::Forward).search(c).unwrap();
            assert!(found.nodes < most, "{scheme}: {} nodes", found.nodes);
            let rules = rules.reversed();
            assert_eq!(size(&power_row(&rules, &r(1, 1), c, &found.norm.class)), found.norm.value);
        }
    }
}

// All rows of a B-spline scheme have the same sum: the least is named.
#[test]
fn ties_go_to_the_least_row() {
    for degree in 1..6 {
        let rules = mask(&format!("b-spline:degree={degree}")).difference();
        let norm = power_norm(&rules, 40, Order::Adjoint).unwrap();
        assert_eq!((norm.value, norm.class), (r(1, 2).pow(40), Integer::zero()));
    }
}
