//! Norms by extreme rows against the walk over all rows, and against branch and bound.

use super::row_bounds::{power_row, size};
use crate::common::{affine, r, rules};
use proptest::prelude::*;
use subcert::bound::{Budget, Order, PowerSearch, walked_norm};
use subcert::exact::{Integer, Rational};
use subcert::scheme::{Mask, Rules};

/// All norms up to `most` levels are those of the walk, and the classes attain them.
fn agree(rules: &Rules, most: u32) -> Result<(), TestCaseError> {
    for order in [Order::Adjoint, Order::Forward] {
        let mut search = PowerSearch::new(rules, order);
        for c in 1..=most {
            let walked = walked_norm(rules, c, order).unwrap();
            let Some(found) = search.extreme_rows(c) else {
                // Only zeros: no row is the longest by any margin. Or all rows are extreme.
                prop_assert!(walked.value.is_zero() || c > 5, "c = {}", c);
                break;
            };
            prop_assert_eq!(&found.value, &walked.value, "c = {}", c);
            prop_assert!(found.class >= walked.class);
            prop_assert_eq!(size(&row(rules, order, c, &found.class)), found.value, "c = {}", c);
        }
    }
    Ok(())
}

fn row(rules: &Rules, order: Order, c: u32, class: &Integer) -> super::row_bounds::Row {
    let rules = if order == Order::Forward { rules.reversed() } else { rules.clone() };
    power_row(&rules, &r(1, 1), c, class)
}

fn levels(rules: &Rules, classes: usize) -> u32 {
    classes.ilog(rules.arity())
}

/// The masks of the benchmark.
fn rough() -> Vec<Mask> {
    let number = |q: i64| move |x: &str| Rational::new(x.parse::<i64>().unwrap(), q);
    let mask = |line: &str| {
        let (q, rows) = line.split_once(':').unwrap();
        let number = number(q.parse().unwrap());
        let rows = rows.split(';').map(|row| row.split_whitespace().map(&number).collect());
        Mask::new(rows.collect(), 0).unwrap()
    };
    include_str!("../../benches/rough/masks.txt").lines().map(mask).collect()
}

proptest! {
    #![proptest_config(crate::common::cases(64))]

    #[test]
    fn differences_of_random_masks(mask in affine(5, 6)) {
        let rules = mask.difference();
        agree(&rules, levels(&rules, 3000))?;
    }

    // Many of these have equal rows, zeros and rows that cancel.
    #[test]
    fn any_rules(rules in rules(5, 5)) {
        agree(&rules, levels(&rules, 3000))?;
    }
}

proptest! {
    #![proptest_config(crate::common::cases(24))]

    // More classes than are visited one by one: the tree, with bounds of single entries of the rows below a
    // node, and extreme rows where it is large.
    #[test]
    fn both_together(mask in affine(4, 6)) {
        for rules in [mask.difference(), mask.rules().clone()] {
            let mut search = PowerSearch::new(&rules, Order::Adjoint).with_extreme_rows();
            let c = levels(&rules, 4096) + 1;
            for c in c..=c + 1 {
                let walked = walked_norm(&rules, c, Order::Adjoint).unwrap();
                prop_assert_eq!(search.norm(c).unwrap().value, walked.value, "c = {}", c);
            }
        }
    }
}

// x'_{3i} = x_i and two points on the line through x_i and x_{i+1}: the differences are multiplied by 4/5, −1/2
// and 7/10, each in one of three thirds.
#[test]
fn points_on_lines_in_closed_form() {
    let rows = [[r(1, 1), r(0, 1)], [r(1, 5), r(4, 5)], [r(7, 10), r(3, 10)]].map(Vec::from);
    let difference = Mask::new(rows.to_vec(), 0).unwrap().difference();
    let mut search = PowerSearch::new(&difference, Order::Adjoint);
    for c in [1_u32, 2, 17, 256] {
        let found = search.extreme_rows(c).expect("one row of each level is extreme");
        assert_eq!(found.value, r(4, 5).pow(c.cast_signed()), "c = {c}");
        assert!(found.class.is_zero());
    }
}

// Every sixth mask of the benchmark: rows of all shapes, to 40 levels, where no walk comes.
#[test]
fn rough_masks_by_both_searches_and_submultiplicative() {
    let (mut compared, mut found) = (0, 0);
    for mask in rough().iter().step_by(6) {
        let difference = mask.difference();
        let mut search = PowerSearch::new(&difference, Order::Adjoint);
        let budget = Budget::new(3_000_000);
        let mut tree = PowerSearch::new(&difference, Order::Adjoint).with_budget(budget);
        let norms: Vec<Rational> =
            (1..=40).map_while(|c| Some(search.extreme_rows(c)?.value)).collect();
        let norm = |c: usize| &norms[c - 1];
        for a in 1..norms.len() {
            for b in 1..=norms.len() - a {
                assert!(*norm(a + b) <= norm(a) * norm(b), "{a} and {b} levels");
            }
        }
        found += norms.len();
        for c in [12, 24, 40].into_iter().filter(|&c| c as usize <= norms.len()) {
            let Some(by_tree) = tree.search(c) else { break };
            assert_eq!(by_tree.norm.value, *norm(c as usize), "c = {c}");
            compared += 1;
        }
    }
    // Neither search may have given up too often.
    assert!(found >= 640 && compared >= 10, "{found} norms, {compared} compared");
}

#[test]
fn a_budget_ends_the_search() {
    let rough = rough();
    let rules = rough[11].difference();
    let budget = Budget::new(100_000);
    let search = || PowerSearch::new(&rules, Order::Adjoint);
    assert!(search().with_budget(budget.clone()).extreme_rows(64).is_none());
    let stopped = Budget::unlimited();
    stopped.stop();
    assert!(search().with_budget(stopped).extreme_rows(8).is_none());
    assert!(search().extreme_rows(0).is_none());
    assert!(search().extreme_rows(257).is_none());
}

// Coefficients that f64 does not hold: branch and bound is left.
#[test]
fn coefficients_beyond_f64() {
    let large = Rational::new(i64::MAX, 1) / Rational::from(2).pow(64);
    let rules = Rules::new(vec![vec![large.clone()], vec![r(1, 3)]], 0).unwrap();
    assert!(PowerSearch::new(&rules, Order::Adjoint).extreme_rows(3).is_none());
    let norm = PowerSearch::new(&rules, Order::Adjoint).with_extreme_rows().norm(30).unwrap();
    assert_eq!(norm.value, large.pow(30));
}
