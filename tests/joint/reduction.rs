//! Sets that have common invariant subspaces, and sets of multiples of one matrix.

use super::radius::set;
use proptest::prelude::*;
use subcert::certificate::radius_certificate;
use subcert::exact::{Rational, format::short, parse_rational};
use subcert::joint::{JointRadius, MatrixSet, joint_radius, joint_radius_below};
use subcert::stop::Stop;
use subcert_check::check_radius;

/// What the checker takes for proven: an upper bound, and a lower one of a power.
fn certified(set: &MatrixSet, radius: &JointRadius) -> (Rational, Option<(Rational, usize)>) {
    let text = radius_certificate(set, radius).expect("it is not 0");
    let found = check_radius(&text);
    let found = found.unwrap_or_else(|rejection| panic!("{rejection:?}:\n{text}"));
    let own = |x: &dyn ToString| parse_rational(&x.to_string()).expect("a fraction");
    (own(&found.at_most), found.at_least.map(|(bound, degree)| (own(&bound), degree)))
}

/// A goal between 80/100 and 200/100 of the upper bound: what is said is so, and what is proven is certified.
fn goals(set: &MatrixSet, known: &JointRadius) {
    for percent in [80, 99, 101, 120, 200] {
        let goal = known.upper() * Rational::new(percent, 100);
        let found = joint_radius_below(set, &goal, &Stop::default());
        match found.is_below(&goal) {
            Some(true) => {
                assert!(goal > *known.root_enclosure().lower(), "{goal}, {set:?}");
                if found.hull.is_some() {
                    assert!(certified(set, &found).0 < goal, "{goal}, {set:?}");
                }
            }
            Some(false) => assert!(goal <= known.upper(), "{goal}, {set:?}"),
            None => assert!(percent < 120 || !known.exact, "{goal}, {set:?}"),
        }
    }
}

/// The radius is this number, exactly and in a certificate.
fn is(matrices: &[&[&[i64]]], number: i64) -> JointRadius {
    let set = set(matrices);
    let (radius, number) = (joint_radius(&set), Rational::from(number));
    assert!(radius.exact, "{matrices:?}");
    let enclosure = radius.root_enclosure();
    assert_eq!((enclosure.lower(), &radius.upper()), (&number, &number), "{matrices:?}");
    assert_eq!(certified(&set, &radius).0, number, "{matrices:?}");
    goals(&set, &radius);
    radius
}

#[test]
fn bounds_that_are_equal_meet() {
    assert!(is(&[&[&[0, -1], &[1, 0]]], 1).bounded);
    assert!(is(&[&[&[0, -2], &[2, 0]], &[&[1, 0], &[0, -1]]], 2).bounded);
    // The group of the six symmetries of a triangle, of which all products have the same rate. These are the differences
    // of the scheme `[1, 0, 0, 1]`.
    assert!(is(&[&[&[-2, 0], &[2, 2]], &[&[2, 2], &[0, -2]]], 2).bounded);
}

#[test]
fn triangular_sets_have_the_radius_of_their_diagonal() {
    assert!(!is(&[&[&[1, 1], &[0, 1]]], 1).bounded);
    // From below, from above, and where the rows and columns of both are mixed.
    is(&[&[&[2, 0], &[7, -3]], &[&[-3, 0], &[1, 3]]], 3);
    is(&[&[&[1, 0, 5], &[9, 2, 8], &[0, 0, -2]], &[&[2, 0, 1], &[4, 1, 1], &[0, 0, 2]]], 2);
    // The invariant row (1, 1) is an eigenrow, and no unit row or column generates a subspace.
    is(&[&[&[-2, -3], &[3, 4]], &[&[-4, -5], &[5, 6]]], 1);
    // One block alone has the radius, by an extremal hull: the products are then bounded, though the set is reduced.
    let radius = joint_radius(&set(&[&[&[3, 0, 0], &[1, 0, 1], &[1, 0, 0]]]));
    assert!(radius.exact && radius.bounded);
}

#[test]
fn blocks_with_one_irrational_radius_are_certified_from_both_sides() {
    // The golden ratio twice, coupled: the characteristic polynomial has no sign that shows it, and that of a block does.
    let set = set(&[
        &[&[1, 1, 1, 0], &[0, 1, 0, 1], &[0, 0, 1, 1], &[0, 0, 0, 1]],
        &[&[1, 0, 2, 0], &[1, 1, 0, 3], &[0, 0, 1, 0], &[0, 0, 1, 1]],
    ]);
    let radius = joint_radius(&set);
    assert!(radius.exact && !radius.bounded);
    assert_eq!((short(&radius.root, 9), radius.degree), ("2.61803399".to_owned(), 2));
    let (at_most, at_least) = certified(&set, &radius);
    let (at_least, degree) = at_least.expect("a product");
    let excess = at_most.pow(2) / at_least;
    assert!(degree == 2 && excess < Rational::new(1_000_001, 1_000_000), "{excess}");
}

#[test]
fn one_matrix_has_its_spectral_radius() {
    // The companion matrix of x^3 − x^2 + 2x − 1 leads with a pair of eigenvalues, whose product is the reciprocal of the third:
    // a root of x^3 − 2x^2 + x − 1. And multiples of it.
    let matrix: &[&[i64]] = &[&[0, 1, 0], &[0, 0, 1], &[1, -2, 1]];
    let double: &[&[i64]] = &[&[0, -2, 0], &[0, 0, -2], &[-2, 4, -2]];
    let zero: &[&[i64]] = &[&[0, 0, 0], &[0, 0, 0], &[0, 0, 0]];
    for (matrices, product, square) in
        [(vec![matrix], vec![0], "1.75487767"), (vec![matrix, zero, double], vec![2], "7.01951066")]
    {
        let radius = joint_radius(&set(&matrices));
        assert!(radius.exact && !radius.bounded);
        assert_eq!((radius.product, radius.degree), (product, 2));
        assert_eq!(short(&radius.root, 9), square);
    }
}

fn matrix(size: usize) -> impl Strategy<Value = Vec<Vec<i64>>> {
    proptest::collection::vec(proptest::collection::vec(-3_i64..=3, size), size)
}

/// Where all products of some length are 0, and where the entries are below all places of enclosures.
#[test]
fn goals_of_extreme_sets() {
    let nilpotent = set(&[&[&[0, 1], &[0, 0]]]);
    let found = joint_radius_below(&nilpotent, &Rational::one(), &Stop::default());
    assert!(found.hull.is_none() && found.is_below(&Rational::one()) == Some(true));
    assert!(radius_certificate(&nilpotent, &found).is_none());
    let tiny = |rows: [[i64; 2]; 2]| {
        let entry = |x: i64| Rational::from(x) * Rational::from(10).pow(-300);
        rows.map(|row| row.map(entry).to_vec()).to_vec()
    };
    let pair = MatrixSet::new(vec![tiny([[1, 2], [1, 1]]), tiny([[1, 0], [1, 1]])]);
    let radius = joint_radius(&pair.expect("square"));
    assert!(radius.upper().sign() > 0);
}

proptest! {
    #![proptest_config(crate::common::cases(12))]

    /// The bounds of a block triangular pair and of its blocks contradict each other nowhere, and are certified.
    #[test]
    fn block_triangular_pairs_agree_with_their_blocks(
        first in [matrix(2), matrix(2)],
        second in [matrix(2), matrix(2)],
        beside in [matrix(2), matrix(2)],
    ) {
        let rational = |m: &Vec<Vec<i64>>| -> Vec<Vec<Rational>> {
            m.iter().map(|row| row.iter().map(|&x| Rational::from(x)).collect()).collect()
        };
        // Rows and columns 0, 2 are those of the first block.
        let whole = |i: usize| -> Vec<Vec<Rational>> {
            let entry = |r: usize, c: usize| match (r % 2, c % 2) {
                (0, 0) => first[i][r / 2][c / 2],
                (1, 1) => second[i][r / 2][c / 2],
                (1, 0) => beside[i][r / 2][c / 2],
                _ => 0,
            };
            (0..4).map(|r| (0..4).map(|c| Rational::from(entry(r, c))).collect()).collect()
        };
        let set = |all: Vec<Vec<Vec<Rational>>>| MatrixSet::new(all).expect("square");
        let pair = set(vec![whole(0), whole(1)]);
        let radius = joint_radius(&pair);
        let blocks = [&first, &second].map(|b| joint_radius(&set(b.iter().map(rational).collect())));
        let (low, high) = (radius.root_enclosure(), radius.upper());
        for block in &blocks {
            prop_assert!(block.root_enclosure().lower() <= &high);
        }
        let most = blocks.iter().map(JointRadius::upper).max().expect("two");
        prop_assert!(low.lower() <= &most);
        if radius.hull.is_some() {
            prop_assert!(certified(&pair, &radius).0 >= *low.lower());
            goals(&pair, &radius);
        }
    }
}
