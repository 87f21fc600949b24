//! Linear systems, against the solution they were made from.

use proptest::prelude::*;
use subcert::exact::{Rational, solve};

fn rational() -> impl Strategy<Value = Rational> {
    (-9_i64..10, 1_i64..7).prop_map(|(p, q)| Rational::new(p, q))
}

/// A square matrix of small rationals, many of them 0, and a vector.
fn system() -> impl Strategy<Value = (Vec<Vec<Rational>>, Vec<Rational>)> {
    let entry = prop_oneof![Just(Rational::zero()), rational()];
    (1_usize..7).prop_flat_map(move |n| {
        let row = prop::collection::vec(entry.clone(), n);
        (prop::collection::vec(row, n), prop::collection::vec(rational(), n))
    })
}

fn product(matrix: &[Vec<Rational>], x: &[Rational]) -> Vec<Rational> {
    matrix.iter().map(|row| row.iter().zip(x).map(|(a, b)| a * b).sum()).collect()
}

fn augmented(matrix: &[Vec<Rational>], y: &[Rational]) -> Vec<Vec<Rational>> {
    let row =
        |(row, y): (&Vec<Rational>, &Rational)| [row.as_slice(), std::slice::from_ref(y)].concat();
    matrix.iter().zip(y).map(row).collect()
}

/// By expansion along the first row.
fn determinant(matrix: &[Vec<Rational>]) -> Rational {
    let Some((first, rest)) = matrix.split_first() else { return Rational::one() };
    let minor = |at: usize| -> Vec<Vec<Rational>> {
        let cut = |row: &Vec<Rational>| [&row[..at], &row[at + 1..]].concat();
        rest.iter().map(cut).collect()
    };
    let term = |(at, x): (usize, &Rational)| {
        let signed = if at % 2 == 0 { x.clone() } else { -x };
        if x.is_zero() { signed } else { signed * determinant(&minor(at)) }
    };
    first.iter().enumerate().map(term).sum()
}

proptest! {
    #[test]
    fn the_only_solution((matrix, x) in system()) {
        let solution = solve(&augmented(&matrix, &product(&matrix, &x)));
        let regular = !determinant(&matrix).is_zero();
        prop_assert_eq!(solution, regular.then_some(x));
    }
}
