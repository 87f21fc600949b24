//! ‖Rᶜ‖_∞ by three other ways.

use crate::common::{int, largest, mask, r, rows, rules};
use proptest::prelude::*;
use std::collections::BTreeMap;
use subcert::bound::{
    ClassCap, MAX_WORK, Order, PowerNorm, joint_norm, power_norm, power_norm_generic,
    walked_joint_norm, walked_norm,
};
use subcert::exact::{Integer, Rational};
use subcert::scheme::Rules;

const ORDERS: [Order; 2] = [Order::Adjoint, Order::Forward];

/// t(z)·t(z^n)⋯t(z^{n^{c−1}}), coefficient after coefficient.
fn sequence(rules: &Rules, levels: u32, order: Order) -> Vec<Rational> {
    let (n, width) = (rules.arity(), rules.width());
    let entry = |at: usize| {
        let (u, beta) = (at / n, at % n);
        let column = if order == Order::Adjoint { width - 1 - u } else { u };
        rules.rows()[beta][column].clone()
    };
    let t: Vec<Rational> = (0..n * width).map(entry).collect();
    let mut product = vec![Rational::one()];
    for level in 0..levels {
        let step = n.pow(level);
        let mut next = vec![Rational::zero(); product.len() + step * (t.len() - 1)];
        for (i, x) in product.iter().enumerate() {
            for (j, y) in t.iter().enumerate() {
                next[i + step * j] += &(x * y);
            }
        }
        product = next;
    }
    product
}

/// Σ|coefficients| over each residue class mod n^c.
fn class_sums(rules: &Rules, levels: u32, order: Order) -> Vec<Rational> {
    let mut sums = vec![Rational::zero(); rules.arity().pow(levels)];
    let classes = sums.len();
    for (at, coefficient) in sequence(rules, levels, order).iter().enumerate() {
        sums[at % classes] += &coefficient.abs();
    }
    sums
}

/// Row r of the power Rᶜ, from the definition of R: index and entry.
pub fn row(rules: &Rules, levels: u32, class: impl Into<Integer>) -> BTreeMap<i64, Rational> {
    let n = int(rules.arity());
    let mut row = BTreeMap::from([(class.into().to_i64().unwrap(), Rational::one())]);
    for _ in 0..levels {
        let mut coarse = BTreeMap::new();
        for (index, entry) in row {
            let (i, rule) = (index.div_euclid(n), usize::try_from(index.rem_euclid(n)).unwrap());
            for (j, coefficient) in (rules.offset()..).zip(&rules.rows()[rule]) {
                *coarse.entry(i + j).or_insert_with(Rational::zero) += &(&entry * coefficient);
            }
        }
        row = coarse;
    }
    row
}

fn index(class: &Integer) -> usize {
    usize::try_from(class.to_i64().unwrap()).unwrap()
}

fn row_sum(row: &BTreeMap<i64, Rational>) -> Rational {
    row.values().map(Rational::abs).sum()
}

/// The most levels with at most so many classes.
fn levels(arity: usize, classes: usize) -> u32 {
    classes.ilog(arity)
}

/// Rules that forward and adjoint tell apart, and a number of levels.
fn rules_and_levels() -> impl Strategy<Value = (Rules, u32)> {
    rules(5, 6).prop_flat_map(|rules| {
        let most = levels(rules.arity(), 130);
        (Just(rules), 0..=most)
    })
}

proptest! {
    #[test]
    fn norms_are_those_of_the_explicit_sequence((rules, c) in rules_and_levels()) {
        for order in ORDERS {
            let sums = class_sums(&rules, c, order);
            prop_assert_eq!(power_norm(&rules, c, order).unwrap().value, largest(&sums));
        }
    }

    // The rows of the matrix power, and the row that is named.
    #[test]
    fn norms_are_those_of_the_matrix_power((rules, c) in rules_and_levels()) {
        let norm = power_norm(&rules, c, Order::Adjoint).unwrap();
        let classes = (rules.arity() as u64).pow(c);
        let sums: Vec<Rational> = (0..classes).map(|class| row_sum(&row(&rules, c, class))).collect();
        prop_assert_eq!(&norm.value, &largest(&sums));
        prop_assert_eq!(sums.get(index(&norm.class)), Some(&norm.value));
        // In the forward order the row is one of the rules read backwards.
        let forward = power_norm(&rules, c, Order::Forward).unwrap();
        prop_assert_eq!(row_sum(&row(&rules.reversed(), c, forward.class.clone())), forward.value);
    }

    // A closed polygon of ±1 with the signs of that row is refined to the norm,
    // and no polygon of ±1 exceeds it.
    #[test]
    fn the_norm_is_attained(
        (rules, c) in rules_and_levels(), signs in prop::collection::vec(any::<bool>(), 1..9),
    ) {
        let PowerNorm { value, class } = power_norm(&rules, c, Order::Adjoint).unwrap();
        let row = row(&rules, c, class.clone());
        let (first, last) = (*row.keys().next().unwrap(), *row.keys().last().unwrap());
        let count = last - first + 1;
        let sign = |i: i64| {
            // The point that stands at the index ≡ i of the row.
            let index = first + (i - first).rem_euclid(count);
            let negative = row.get(&index).is_some_and(|entry| entry.sign() < 0);
            r(if negative { -1 } else { 1 }, 1)
        };
        let refine = |points: Vec<Rational>| (0..c).fold(points, |points, _| rules.refine_closed(&points));
        let refined = refine((0..count).map(sign).collect());
        prop_assert_eq!(&refined[index(&class) % refined.len()], &value);
        let other = signs.iter().map(|&sign| r(if sign { 1 } else { -1 }, 1)).collect();
        prop_assert!(largest(&refine(other)) <= value);
    }

    #[test]
    fn norms_do_not_depend_on_the_offset((rules, c) in rules_and_levels(), offset in -1000_i64..1000) {
        for order in ORDERS {
            let moved = power_norm(&rules.with_offset(offset), c, order).unwrap();
            prop_assert_eq!(moved.value, power_norm(&rules, c, order).unwrap().value);
        }
    }

    #[test]
    fn norms_are_submultiplicative_and_homogeneous(rules in rules(4, 5), factor in -5_i64..5) {
        let most = levels(rules.arity(), 260);
        for order in ORDERS {
            let norms: Vec<Rational> = (0..=most).map(|c| power_norm(&rules, c, order).unwrap().value).collect();
            prop_assert_eq!(&norms[0], &Rational::one());
            let rows: Vec<Rational> = rules.rows().iter().map(|row| row.iter().map(Rational::abs).sum()).collect();
            prop_assert_eq!(&norms[1], &largest(&rows));
            for c in 0..norms.len() {
                for d in 0..norms.len() - c {
                    prop_assert!(norms[c + d] <= &norms[c] * &norms[d]);
                }
            }
            let scaled = rules.map(|entry| entry * r(factor, 3));
            let norm = power_norm(&scaled, most, order).unwrap().value;
            prop_assert_eq!(norm, &norms[most as usize] * r(factor, 3).abs().pow(most.cast_signed()));
        }
    }

    // Numerators of up to 80 bits: below and above what 128-bit integers hold.
    #[test]
    fn wide_and_narrow_integers_agree_with_fractions(
        small in rows(2, 3), bits in 1_u32..80, c in 1_u32..5, offset in -3_i64..3,
    ) {
        let wide = Rational::from(2).pow(bits.cast_signed()) - Rational::one();
        let rows = small.iter().map(|row| row.iter().map(|x| x * &wide + r(1, 3)).collect()).collect();
        let rules = Rules::new(rows, offset).unwrap();
        for order in ORDERS {
            let value = power_norm(&rules, c, order).unwrap().value;
            prop_assert_eq!(&power_norm_generic(&rules, c, order).unwrap(), &value);
            prop_assert_eq!(largest(&class_sums(&rules, c, order)), value);
        }
    }

    #[test]
    fn joint_norms_take_one_supremum(
        (first, c) in rules_and_levels(), other in rows(5, 6), offset in -3_i64..3,
    ) {
        let cut = other[..first.arity()].iter().map(|row| row[..first.width()].to_vec()).collect();
        let second = Rules::new(cut, offset).unwrap();
        for order in ORDERS {
            let joint = joint_norm(&first, &second, c, order).unwrap();
            let sums = class_sums(&first, c, order).into_iter().zip(class_sums(&second, c, order));
            prop_assert_eq!(&joint.value, &sums.map(|(x, y)| x * y).max().unwrap());
            let norm = |rules| power_norm(rules, c, order).unwrap().value;
            prop_assert!(joint.value <= norm(&first) * norm(&second));
            // Its row, at offset 0, and read backwards in the forward order.
            let at = |rules: &Rules| {
                let read = if order == Order::Forward { rules.reversed() } else { rules.clone() };
                row_sum(&row(&read.with_offset(0), c, joint.class.clone()))
            };
            prop_assert_eq!(at(&first) * at(&second), joint.value);
        }
    }
}

// 2·60 bits and more: the third power no longer fits in 128 bits.
#[test]
fn numbers_beyond_128_bits() {
    let p = (1_i64 << 61) - 1;
    let rules = Rules::new(vec![vec![r(p, 1), r(-1, p)], vec![r(1, 7), r(p, 3)]], 1).unwrap();
    for c in 0..7 {
        for order in ORDERS {
            let norm = power_norm(&rules, c, order).unwrap();
            assert_eq!(norm.value, largest(&class_sums(&rules, c, order)));
            assert_eq!(norm.value, power_norm_generic(&rules, c, order).unwrap());
        }
    }
    // The squares next to 2^126, 2^127 and 2^128, of which only the first fits.
    for (root, more) in [(1 << 63, 0), (13_043_817_825_332_782_212_i128, 1), (1 << 64, 0)] {
        let power = Rational::from(root + more);
        let rows = vec![vec![power.clone()], vec![Rational::zero()]];
        let norm = power_norm(&Rules::new(rows, 0).unwrap(), 2, Order::Adjoint).unwrap();
        assert_eq!(norm.value, power.pow(2));
    }
}

#[test]
fn rules_that_are_0() {
    let (zero, chaikin) = (Rules::new(vec![vec![r(0, 1); 2]; 2], 0).unwrap(), mask("chaikin"));
    for order in ORDERS {
        let nothing = Ok(PowerNorm { value: r(0, 1), class: Integer::zero() });
        assert_eq!(power_norm(&zero, 3, order), nothing);
        assert_eq!(joint_norm(&zero, chaikin.rules(), 3, order), nothing);
        assert_eq!(power_norm(&zero, 0, order).unwrap().value, r(1, 1));
    }
}

#[test]
fn the_caps() {
    let rules = mask("chaikin").difference();
    let cap = ClassCap { arity: 2, levels: 257, work: MAX_WORK };
    assert_eq!(power_norm(&rules, 257, Order::Adjoint), Err(cap));
    assert_eq!(joint_norm(&rules, &rules, 257, Order::Forward), Err(cap));
    assert!(cap.to_string().contains("2^257 row sums is out of reach"));
    let cap = ClassCap { arity: 2, levels: 25, work: MAX_WORK };
    assert_eq!(walked_norm(&rules, 25, Order::Adjoint), Err(cap));
    assert_eq!(walked_joint_norm(&rules, &rules, 25, Order::Adjoint), Err(cap));
    assert_eq!(power_norm_generic(&rules, 25, Order::Forward), Err(cap));
    assert_eq!(power_norm(&rules, 256, Order::Adjoint).unwrap().value, r(1, 2).pow(256));
}
