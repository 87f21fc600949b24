//! Joint spectral radii against brute force, laws, and published sets.

use proptest::prelude::*;
use subcert::exact::{Enclosed as _, Rational, format::short};
use subcert::joint::{JointRadius, MatrixSet, Reduction, joint_radius};

type Matrix = Vec<Vec<Rational>>;

pub fn set(matrices: &[&[&[i64]]]) -> MatrixSet {
    let row = |row: &&[i64]| row.iter().map(|&x| Rational::from(x)).collect();
    let matrices = matrices.iter().map(|matrix| matrix.iter().map(row).collect()).collect();
    MatrixSet::new(matrices).expect("square matrices")
}

fn times(a: &Matrix, b: &Matrix) -> Matrix {
    let entry = |row: &Vec<Rational>, j: usize| row.iter().zip(b).map(|(x, r)| x * &r[j]).sum();
    a.iter().map(|row| (0..b.len()).map(|j| entry(row, j)).collect()).collect()
}

fn norm(matrix: &Matrix) -> Rational {
    let sum = |row: &Vec<Rational>| row.iter().map(Rational::abs).sum::<Rational>();
    matrix.iter().map(sum).max().expect("a row")
}

/// For l = 1, …, `longest`: (l, max ‖M_w‖, max |tr M_w|) over all words of length l. ‖M_w‖ ≥ ϱ^l, and
/// |tr M_w| ≤ dϱ^l.
fn brute_force(set: &MatrixSet, longest: i32) -> Vec<(i32, Rational, Rational)> {
    let mut products = vec![set.product(&[])];
    (1..=longest)
        .map(|l| {
            let longer =
                |p: &Matrix| set.matrices().iter().map(|m| times(p, m)).collect::<Vec<_>>();
            products = products.iter().flat_map(longer).collect();
            let trace = |p: &Matrix| (0..p.len()).map(|i| &p[i][i]).sum::<Rational>().abs();
            let largest = products.iter().map(norm).max().expect("a product");
            (l, largest, products.iter().map(trace).max().expect("a product"))
        })
        .collect()
}

/// The bounds contradict no product of up to `longest` factors.
fn agrees(set: &MatrixSet, radius: &JointRadius, longest: i32) -> Result<(), TestCaseError> {
    let Some(hull) = &radius.hull else {
        let last = brute_force(set, longest).pop().expect("a length");
        prop_assert!(last.1.is_zero());
        return Ok(());
    };
    let diagonal = radius.reduction.as_ref().map(Reduction::diagonal);
    prop_assert!(hull.proves(diagonal.as_ref().unwrap_or(set)));
    let size = Rational::from(set.size());
    let degree = i32::try_from(radius.degree).expect("short");
    for (l, norm, trace) in brute_force(set, longest) {
        // root ≤ ϱ^degree, so root^l ≤ max ‖M_w‖^degree; and |tr M_w| ≤ d·u^l.
        let root = radius.root.enclosure(0).lower().pow(l);
        prop_assert!(root <= norm.pow(degree), "{l}: the lower bound");
        prop_assert!(trace <= &size * hull.bound.pow(l), "{l}: the upper bound");
    }
    // The product itself, by its traces: |tr P^k| ≤ d·root^{k·len/degree}, where the bounds meet.
    if radius.bounded && radius.reduction.is_none() {
        let slack = Rational::new(1_000_001, 1_000_000);
        let upper = hull.bound.pow(degree);
        prop_assert!(upper <= radius.root.enclosure(0).upper() * slack);
    }
    Ok(())
}

#[test]
fn a_published_pair_is_attained_by_its_product() -> Result<(), TestCaseError> {
    // Ahmadi, Jungers, Parrilo and Roozbehani 2014: 3.917384715148.
    let pair = set(&[&[&[-1, -1], &[-4, 0]], &[&[3, 3], &[-2, 1]]]);
    let radius = joint_radius(&pair);
    assert!(radius.exact);
    assert_eq!((radius.product.clone(), radius.degree), (vec![0, 1], 2));
    let printed = Rational::new(3_917_384_715_148_i64, 1_000_000_000_000_i64).pow(2);
    let root = radius.root.enclosure(0);
    assert!((root.lower() - printed).abs() < Rational::new(1, 100_000_000_000_i64));
    assert_eq!(radius.root.minimal_polynomial().expect("short").to_string(), "x^2 - 13x - 36");
    agrees(&pair, &radius, 10)
}

#[test]
fn sets_that_are_known_by_hand() {
    // A shear and its transpose: the golden ratio, of the product's eigenvalue (3 + √5)/2.
    let radius = joint_radius(&set(&[&[&[1, 1], &[0, 1]], &[&[1, 0], &[1, 1]]]));
    assert!(radius.exact);
    assert_eq!(short(&radius.root, 9), "2.61803399");
    assert_eq!(radius.degree, 2);
    // Nilpotent together.
    let radius = joint_radius(&set(&[&[&[0, 1], &[0, 0]], &[&[0, 5], &[0, 0]]]));
    assert!(radius.hull.is_none() && radius.exact);
    // Nilpotent one by one: the product is diag(6, 0).
    let radius = joint_radius(&set(&[&[&[0, 2], &[0, 0]], &[&[0, 0], &[3, 0]]]));
    assert!(radius.exact);
    assert_eq!(radius.root.as_rational(), Some(&Rational::from(6)));
    // A rotation by a right angle, times 2: no real eigenvalue of a single factor.
    let radius = joint_radius(&set(&[&[&[0, 2], &[-2, 0]]]));
    let two = radius.root.as_rational().expect("rational").clone();
    assert_eq!(two, Rational::from(2).pow(i32::try_from(radius.degree).expect("short")));
}

#[test]
fn a_rotation_by_an_irrational_angle_has_a_radius_but_no_extremal_hull() {
    // (3 + 4i)/5 as a matrix, times 5: the radius is 5.
    let radius = joint_radius(&set(&[&[&[3, -4], &[4, 3]]]));
    assert!(radius.exact && !radius.bounded);
    assert_eq!((radius.root.as_rational(), radius.degree), (Some(&Rational::from(25)), 2));
    let bound = radius.hull.expect("a hull").bound;
    assert!(bound >= Rational::from(5) && bound < Rational::new(501, 100), "{bound}");
}

#[test]
fn conjugate_eigenvalues_that_lead_have_near_bounds() {
    // The first matrix alone has the radius of the pair, by two conjugate eigenvalues. Their rows turn, so that no
    // hull of few rows is extremal, and many bases of the hulls have coefficients of 0.
    let pair = set(&[
        &[&[-1, -2, 0, 3], &[1, -3, 2, -2], &[3, -2, -3, -2], &[-2, 3, 2, 2]],
        &[&[-1, -1, -1, -2], &[-1, 2, 0, 1], &[2, 3, 1, 0], &[2, -1, -2, -3]],
    ]);
    let radius = joint_radius(&pair);
    assert_eq!((radius.product.clone(), radius.degree), (vec![0], 2));
    let lower = radius.root.enclosure(0).lower().clone();
    let excess = radius.hull.expect("a hull").bound.pow(2) / lower;
    assert!(excess < Rational::new(100_001, 100_000), "{excess}");
}

#[test]
fn conjugate_eigenvalues_of_large_matrices_lead() {
    // The companion matrix of (x² + x + 4)(x^10 + x + 1), whose pair of modulus 2 leads, and a matrix of small norm.
    let coefficients = [4, 5, 2, 1, 0, 0, 0, 0, 0, 0, 4, 1];
    let entry = |i: usize, j: usize| {
        let last = if j == 11 { -coefficients[i] } else { 0 };
        Rational::from(last + i64::from(i == j + 1))
    };
    let companion: Matrix = (0..12).map(|i| (0..12).map(|j| entry(i, j)).collect()).collect();
    let small = vec![vec![Rational::new(1, 100); 12]; 12];
    let set = MatrixSet::new(vec![companion, small]).expect("square matrices");
    let radius = joint_radius(&set);
    let shown = radius.eigenvalue(&set).expect("a lower bound");
    let count = i32::try_from(shown.product.len()).expect("short");
    assert!(shown.at_least > Rational::new(19_999, 10_000).pow(count), "{shown:?}");
    let text = subcert::certificate::radius_certificate(&set, &radius).expect("not nilpotent");
    let found = subcert_check::check_radius(&text).expect("a valid certificate");
    assert_eq!(found.at_least.map(|(_, degree)| degree), Some(shown.product.len()));
    // With a greater number it is none.
    let line = |q: &Rational| format!("eigenvalue modulus {q}");
    let wrong = text.replace(&line(&shown.at_least), &line(&Rational::new(21, 10).pow(count)));
    assert_ne!(wrong, text);
    assert!(subcert_check::check_radius(&wrong).is_err());
}

fn matrices(count: usize, size: usize) -> impl Strategy<Value = MatrixSet> {
    let entry = (-4_i64..=4, 1_i64..=3).prop_map(|(p, q)| Rational::new(p, q));
    let row = proptest::collection::vec(entry, size);
    let matrix = proptest::collection::vec(row, size);
    proptest::collection::vec(matrix, count).prop_map(|m| MatrixSet::new(m).expect("square"))
}

proptest! {
    #![proptest_config(crate::common::cases(24))]

    #[test]
    fn random_pairs_agree_with_brute_force(set in matrices(2, 2)) {
        agrees(&set, &joint_radius(&set), 11)?;
    }

    #[test]
    fn random_triples_agree_with_brute_force(set in matrices(3, 3)) {
        agrees(&set, &joint_radius(&set), 6)?;
    }

    #[test]
    fn transposed_matrices_have_the_same_radius(set in matrices(2, 2)) {
        let transpose = |m: &Matrix| -> Matrix {
            (0..m.len()).map(|j| m.iter().map(|row| row[j].clone()).collect()).collect()
        };
        let other = MatrixSet::new(set.matrices().iter().map(transpose).collect()).expect("square");
        let (a, b) = (joint_radius(&set), joint_radius(&other));
        let bounds = |radius: &JointRadius| radius.hull.as_ref().map(|hull| hull.bound.clone());
        prop_assert_eq!(a.hull.is_some(), b.hull.is_some());
        if let (Some(upper), Some(other)) = (bounds(&a), bounds(&b)) {
            let power = |radius: &JointRadius| i32::try_from(radius.degree).expect("short");
            prop_assert!(a.root.enclosure(0).lower() <= &other.pow(power(&a)));
            prop_assert!(b.root.enclosure(0).lower() <= &upper.pow(power(&b)));
        }
    }
}
