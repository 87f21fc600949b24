//! The difference mask.

use crate::common::{affine, differences, mask, polygon, r, refine};
use proptest::prelude::*;
use subcert::exact::{Polynomial, Rational};
use subcert::scheme::find;

proptest! {
    // Δ(Sx) = D(Δx), on data; and D at the mask's own offset.
    #[test]
    fn differences_of_refined_polygons(mask in affine(6, 8), points in polygon(1..12)) {
        let refined = refine(mask.rules(), &points);
        let rules = mask.difference();
        prop_assert_eq!(rules.offset(), mask.offset());
        prop_assert_eq!(differences(&refined), refine(&rules, &differences(&points)));
    }

    // Each column of D sums to the first rule's coefficient: Δ' over one period
    // telescopes.
    #[test]
    fn columns_telescope(mask in affine(6, 8)) {
        let rules = mask.difference();
        for (j, coefficient) in mask.rules().rows()[0].iter().enumerate() {
            let column: Rational = rules.rows().iter().map(|row| &row[j]).sum();
            prop_assert_eq!(&column, coefficient);
        }
    }
}

#[test]
fn printed_difference_masks() {
    // Mustafa et al. 2020, Example 13, the quinary scheme.
    let rows = mask("quinary-three-point").difference();
    let over_25 = [[4, 1, 0], [3, 2, 0], [2, 3, 0], [1, 4, 0], [-3, 11, -3]];
    assert_eq!(rows.rows(), over_25.map(|row| row.map(|p| r(p, 25)).to_vec()));
}

// For the six-point scheme with a symbol w, by hand.
#[test]
fn symbolic_difference_mask() {
    let symbols = [("w".to_owned(), Polynomial::variable("w"))].into();
    let mask = find("six-point").unwrap().mask(&symbols).unwrap();
    let rules = mask.difference();
    let printed = rules.rows()[0].iter().map(ToString::to_string);
    assert_eq!(printed.collect::<Vec<_>>(), ["-w", "1/16 + 2*w", "1/2", "-1/16 - 2*w", "w", "0"]);
}
