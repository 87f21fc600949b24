//! Rows times matrices, against sums of products.

use super::{our_ratio, ratio};
use proptest::prelude::*;
use subcert::exact::{Matrix, Rational, RealCyclotomic, Scalar};

/// α + β·cos(2πk/n) + γ·cos(2πl/n): few cosines, many coefficients where k or l is beyond
/// the basis, as half of them are for n = 105; small numbers as well as large ones.
fn number(n: u32) -> impl Strategy<Value = RealCyclotomic> {
    let small = (-9_i64..10, 1_i64..7).prop_map(|(p, q)| Rational::new(p, q));
    let coefficient = prop_oneof![4 => small, 1 => ratio().prop_map(|value| our_ratio(&value))];
    let cosine = move |k: u32| RealCyclotomic::cosine(&Rational::new(k, n)).expect("a small field");
    let term = (0..n, coefficient.clone(), any::<bool>());
    (coefficient, prop::collection::vec(term, 0..3)).prop_map(move |(plain, terms)| {
        let terms = terms.into_iter().filter(|(.., kept)| *kept);
        terms.fold(RealCyclotomic::from(plain), |sum, (k, factor, _)| {
            &sum + &(&cosine(k) * &RealCyclotomic::from(factor))
        })
    })
}

/// A row and a matrix, with numbers of few fields.
fn factors() -> impl Strategy<Value = (Vec<RealCyclotomic>, Vec<Vec<RealCyclotomic>>)> {
    let conductors =
        prop::sample::select(&[[5, 8], [12, 1], [105, 105], [7, 49], [20, 60], [1, 1]]);
    (conductors, 1_usize..5, 1_usize..5).prop_flat_map(|([m, n], height, width)| {
        let matrix = prop::collection::vec(prop::collection::vec(number(n), width), height);
        (prop::collection::vec(number(m), height), matrix)
    })
}

proptest! {
    #![proptest_config(crate::common::cases(200))]
    #[test]
    fn products_are_sums_of_products((row, rows) in factors()) {
        let matrix = Matrix::from_rows(rows.clone());
        let column = |b: usize| -> Vec<RealCyclotomic> {
            row.iter().zip(&rows).map(|(w, row)| w * &row[b]).collect()
        };
        let naive: Vec<_> = (0..rows[0].len()).map(|b| RealCyclotomic::total(&column(b))).collect();
        prop_assert_eq!(matrix.left_product(&row), naive);
        for (a, row) in rows.iter().enumerate() {
            prop_assert!(matrix.row(a).eq(row));
        }
        let x: Vec<RealCyclotomic> = rows[0].clone();
        let dot = |row: &Vec<RealCyclotomic>| {
            let terms: Vec<RealCyclotomic> = row.iter().zip(&x).map(|(m, x)| m * x).collect();
            RealCyclotomic::total(&terms)
        };
        prop_assert_eq!(matrix.product(&x), rows.iter().map(dot).collect::<Vec<_>>());
    }

    // Of the same numbers as rationals: the other way round, and without cosines.
    #[test]
    fn rationals_and_real_numbers_agree(
        rows in prop::collection::vec(prop::collection::vec(ratio(), 3), 3),
        row in prop::collection::vec(ratio(), 3),
    ) {
        let rows: Vec<Vec<Rational>> =
            rows.iter().map(|row| row.iter().map(our_ratio).collect()).collect();
        let row: Vec<Rational> = row.iter().map(our_ratio).collect();
        let matrix = Matrix::from_rows(rows);
        let real = |row: &[Rational]| row.iter().map(RealCyclotomic::from).collect::<Vec<_>>();
        let product = matrix.map(|x| RealCyclotomic::from(x)).left_product(&real(&row));
        prop_assert_eq!(product, real(&matrix.left_product(&row)));
    }
}

#[test]
fn equal_entries_have_one_name() {
    let cosine = |p, q| RealCyclotomic::cosine(&Rational::new(p, q)).expect("a small field");
    // cos(2π/10) = −cos(2π·3/5), in one field; cos(2π/6) = 1/2.
    let half = RealCyclotomic::from(Rational::new(1, 2));
    let rows = vec![
        vec![cosine(1, 10), -&cosine(3, 5), RealCyclotomic::from(0)],
        vec![cosine(1, 6), half.clone(), cosine(1, 5)],
    ];
    let matrix = Matrix::from_rows(rows);
    assert_eq!(matrix.names(), [[1, 1, 0], [2, 2, 3]]);
    assert_eq!(matrix.values(), [RealCyclotomic::from(0), cosine(1, 10), half, cosine(1, 5)]);
}
