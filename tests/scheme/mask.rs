//! Rules and masks.

use crate::common::{affine, int, polygon, r, refine, rules};
use proptest::prelude::*;
use subcert::exact::{Polynomial, Rational};
use subcert::scheme::{MAX_ARITY, MAX_WIDTH, Mask, MaskError, Rules, RulesError};

proptest! {
    #[test]
    fn refining_is_the_definition(rules in rules(6, 8), points in polygon(1..12)) {
        let closed = rules.refine_closed(&points);
        prop_assert_eq!(&closed, &refine(&rules, &points));
        // The open polygon has the values of the closed one where no point with a weight is
        // beyond its ends, from the first index on after which there is no other to its last one.
        let open = rules.refine_open(&points);
        let (n, count) = (int(rules.arity()), int(points.len()));
        let is_there = |index: i64| {
            let row = &rules.rows()[usize::try_from(index.rem_euclid(n)).unwrap()];
            let places = (index.div_euclid(n)..).zip(row).filter(|(_, entry)| **entry != Rational::zero());
            let zeros = places.clone().next().is_none();
            (!zeros || (0..count).contains(&index.div_euclid(n))) && places.clone().all(|(place, _)| (0..count).contains(&place))
        };
        let found = rules.open_range(points.len());
        prop_assert_eq!(open.len(), found.clone().count());
        prop_assert!(found.clone().all(is_there));
        prop_assert!(found.is_empty() || !is_there(found.start - 1) && !is_there(found.end));
        for (index, value) in found.zip(&open) {
            let i = (index.div_euclid(n) - rules.offset()).rem_euclid(count);
            prop_assert_eq!(value, &closed[usize::try_from(n * i + index.rem_euclid(n)).unwrap()]);
        }
    }

    #[test]
    fn reversed_twice_and_shifted(rules in rules(5, 6), points in polygon(2..8), shift in -4_i64..5) {
        prop_assert_eq!(rules.reversed().reversed(), rules.clone());
        // Another offset turns the refined polygon by n places for each unit.
        let turned = rules.with_offset(rules.offset() + shift).refine_closed(&points);
        let mut refined = rules.refine_closed(&points);
        let places = (shift * int(rules.arity())).rem_euclid(int(refined.len()));
        refined.rotate_left(usize::try_from(places).unwrap());
        prop_assert_eq!(turned, refined);
    }

    // A mask is refused exactly when a rule does not sum to 1, at the first such rule.
    #[test]
    fn masks_are_affine(mask in affine(5, 6), at in any::<prop::sample::Index>(), excess in -3_i64..4) {
        let mut rows = mask.rules().rows().to_vec();
        let rule = at.index(rows.len());
        rows[rule][0] += &r(excess, 7);
        let result = Mask::new(rows, mask.offset());
        if excess == 0 {
            prop_assert_eq!(result, Ok(mask));
        } else {
            let sum = (Rational::one() + r(excess, 7)).to_string();
            prop_assert_eq!(result, Err(MaskError::NotAffine { rule, sum, excess: r(excess, 7).to_string() }));
        }
    }
}

#[test]
fn shapes() {
    let rows = |lengths: &[usize]| lengths.iter().map(|&n| vec![r(1, 1); n]).collect::<Vec<_>>();
    let refusal = |lengths: &[usize]| Rules::new(rows(lengths), 0).unwrap_err();
    assert_eq!(refusal(&[]), RulesError::Arity(0));
    assert_eq!(refusal(&[1]), RulesError::Arity(1));
    assert_eq!(refusal(&[1; MAX_ARITY + 1]), RulesError::Arity(MAX_ARITY + 1));
    assert_eq!(refusal(&[0, 0]), RulesError::Width(0));
    assert_eq!(refusal(&[MAX_WIDTH + 1; 2]), RulesError::Width(MAX_WIDTH + 1));
    assert_eq!(refusal(&[2, 2, 3]), RulesError::Ragged { rule: 2, found: 3, expected: 2 });
    assert!(Rules::new(rows(&[MAX_WIDTH; MAX_ARITY]), 0).is_ok());
    assert!(Mask::new(rows(&[1, 1]), 0).is_ok());
}

#[test]
fn symbolic_sums_are_identities() {
    let (one, w) = (Polynomial::constant(r(1, 1)), Polynomial::variable("w"));
    let row = vec![&one - &w, w.clone()];
    assert!(Mask::new(vec![row.clone(), row.clone()], 0).is_ok());
    let error = Mask::new(vec![row, vec![one, w]], 0).unwrap_err();
    assert_eq!(
        error.to_string(),
        "rule 1 sums to 1 + w, not to 1: its excess is w; the coefficients of every rule must sum to 1; rules are counted from 0"
    );
}
