//! Characteristic polynomials against expansion, and numbers of a field against their decimals.

use proptest::prelude::*;
use subcert::exact::{
    Enclosed as _, FieldElement, IntegerPolynomial, Rational, Real as _, RealAlgebraic,
    Scalar as _, characteristic_polynomial, natural_logarithm, symmetric_square_polynomial,
};

type Matrix = Vec<Vec<Rational>>;

fn matrix(size: usize) -> impl Strategy<Value = Matrix> {
    let entry = (-5_i64..=5, 1_i64..=4).prop_map(|(p, q)| Rational::new(p, q));
    prop::collection::vec(prop::collection::vec(entry, size), size)
}

/// By expansion along the first row.
fn determinant(matrix: &[Vec<Rational>]) -> Rational {
    let Some((first, rest)) = matrix.split_first() else { return Rational::one() };
    let minor = |at: usize| -> Matrix {
        rest.iter().map(|row| [&row[..at], &row[at + 1..]].concat()).collect()
    };
    let term = |(at, x): (usize, &Rational)| {
        let value = x * determinant(&minor(at));
        if at.is_multiple_of(2) { value } else { -value }
    };
    first.iter().enumerate().map(term).sum()
}

/// det(xI − M).
fn shifted(matrix: &Matrix, x: &Rational) -> Rational {
    let entry = |i: usize, j: usize| {
        if i == j { x - &matrix[i][j] } else { -&matrix[i][j] }
    };
    let row = |i| (0..matrix.len()).map(|j| entry(i, j)).collect();
    determinant(&(0..matrix.len()).map(row).collect::<Matrix>())
}

/// x_a x_b becomes Σ m_{a,p} m_{b,q} x_p x_q.
fn symmetric_square(matrix: &Matrix) -> Matrix {
    let n = matrix.len();
    let pairs: Vec<(usize, usize)> = (0..n).flat_map(|a| (a..n).map(move |b| (a, b))).collect();
    let entry = |(a, b): (usize, usize), (p, q): (usize, usize)| {
        let once = &matrix[a][p] * &matrix[b][q];
        if p == q { once } else { once + &matrix[a][q] * &matrix[b][p] }
    };
    pairs.iter().map(|&row| pairs.iter().map(|&column| entry(row, column)).collect()).collect()
}

fn over_leading(polynomial: &IntegerPolynomial, x: &Rational) -> Rational {
    polynomial.value_at(x) / Rational::from(polynomial.leading())
}

proptest! {
    #[test]
    fn the_characteristic_polynomial_is_the_determinant(matrix in matrix(4), x in -9_i64..9) {
        let x = Rational::new(x, 2);
        let polynomial = characteristic_polynomial(&matrix);
        prop_assert_eq!(over_leading(&polynomial, &x), shifted(&matrix, &x));
    }

    #[test]
    fn that_of_the_symmetric_square_too(matrix in matrix(3), x in -9_i64..9) {
        let x = Rational::new(x, 2);
        let polynomial = symmetric_square_polynomial(&matrix);
        prop_assert_eq!(over_leading(&polynomial, &x), shifted(&symmetric_square(&matrix), &x));
    }

    #[test]
    fn a_field_has_inverses_and_an_order(a in -9_i64..9, b in -9_i64..9, c in 1_i64..9) {
        // The root 1.3247… of x³ − x − 1.
        let root = &RealAlgebraic::roots_of(&IntegerPolynomial::from([-1, -1, 0, 1]))[0];
        let x = FieldElement::generator(root).expect("a short polynomial");
        let number = |p: i64| FieldElement::from_rational(&Rational::from(p));
        let value = number(a).plus(&x.times(&number(b))).plus(&x.times(&x).times(&number(c)));
        let one = number(1);
        prop_assert_eq!(value.times(&one.over(&value)), one);
        let decimal = 1.324_717_957_244_746_f64;
        let [a, b, c] = [a, b, c].map(|p| f64::from(i32::try_from(p).expect("small")));
        let near = a + b * decimal + c * decimal * decimal;
        let sign = i8::from(near > 0.0) - i8::from(near < 0.0);
        prop_assert!(near.abs() < 1e-9 || sign == value.sign());
        let enclosure = value.enclosure(0);
        let size = subcert::float::nearest(enclosure.lower());
        prop_assert!((size - near).abs() < 1e-9);
    }

    #[test]
    fn logarithms_are_those_of_the_machine(p in 1_i64..1_000_000_000, q in 1_i64..1_000_000_000) {
        let x = Rational::new(p, q);
        let enclosure = natural_logarithm(&x, 64);
        let machine = subcert::float::nearest(&x).ln();
        for end in [enclosure.lower(), enclosure.upper()] {
            prop_assert!((subcert::float::nearest(end) - machine).abs() < 1e-13 * (1.0 + machine.abs()));
        }
        prop_assert!(enclosure.width() < Rational::new(1, 1_i64 << 60));
    }

    #[test]
    fn logarithms_of_products_are_sums(p in 1_i64..1000, q in 1_i64..1000, r in 1_i64..1000) {
        let log = |x: &Rational| natural_logarithm(x, 64);
        let (x, y) = (Rational::new(p, r), Rational::new(q, r));
        let apart = &log(&(&x * &y)) - &(&log(&x) + &log(&y));
        prop_assert!(apart.contains(&Rational::zero()));
    }
}
