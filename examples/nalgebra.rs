//! Your own exact refinement with nalgebra over `BigRational`, and an f64 one, both against subcert.
//!
//! Run it with `cargo run --example nalgebra`. Numbers of num-rational and num-bigint go into subcert as they
//! are, and what comes out converts back: nothing is printed and read.

use nalgebra::{DMatrix, DVector};
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};
use subcert::assert_slice_within_ulps;
use subcert::bound::{Constants, Operator, Order};
use subcert::exact::Rational;
use subcert::oracle::{Boundary, refine_polygon};
use subcert::scheme::Mask;

fn ratio(p: i64, q: i64) -> BigRational {
    BigRational::new(p.into(), q.into())
}

/// The rules of the 4-point scheme with tension w, for the points p_{i−1}, …, p_{i+2}.
fn four_point(w: &BigRational) -> [[BigRational; 4]; 2] {
    let (zero, one) = (BigRational::zero(), BigRational::one());
    let inner = ratio(1, 2) + w;
    [[zero.clone(), one, zero.clone(), zero], [-w, inner.clone(), inner, -w]]
}

/// The 2m × m matrix that refines a closed polygon of m points.
fn refinement(rules: &[[BigRational; 4]; 2], m: usize) -> DMatrix<BigRational> {
    let mut matrix = DMatrix::zeros(2 * m, m);
    for (row, (i, rule)) in (0..m).flat_map(|i| rules.iter().map(move |rule| (i, rule))).enumerate()
    {
        for (j, weight) in rule.iter().enumerate() {
            matrix[(row, (i + j + m - 1) % m)] += weight;
        }
    }
    matrix
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rules = four_point(&ratio(1, 17));
    let points = DVector::from_vec(vec![
        ratio(10, 3),
        ratio(41, 10),
        ratio(17, 3),
        ratio(50, 7),
        ratio(33, 10),
        ratio(5, 2),
    ]);

    // subcert's own copy of the scheme: rule i of its mask begins at p_{i−1}.
    let rows = rules.clone().map(|rule| rule.map(Rational::from).to_vec());
    let mask = Mask::new(rows.to_vec(), -1)?;

    println!("1. Two levels with exact matrices.");
    let once = refinement(&rules, points.len());
    let twice = refinement(&rules, once.nrows()) * once;
    let mine = &twice * &points;
    let oracle = refine_polygon(mask.rules(), points.as_slice(), 2, Boundary::Closed)?;
    let oracle: Vec<BigRational> = oracle.into_iter().map(BigRational::from).collect();
    assert_eq!(mine.as_slice(), oracle);
    println!("   All {} points are equal; point 1 is {}.", mine.len(), mine[1]);

    println!("2. The same matrices in f64.");
    let float =
        |value: &BigRational| Rational::from(value).to_f64().expect("every rational has one");
    let rounded = twice.map(|value| float(&value)) * points.map(|value| float(&value));
    assert_slice_within_ulps!(rounded.as_slice(), mine.as_slice(), 4.0, "nalgebra in f64");
    println!("   All of them are within 4 ulps of the exact ones.");

    println!("3. The contraction constant, back in num-rational.");
    let constant = Constants::new(mask).norm(Operator::Difference, 1, Order::Adjoint)?;
    println!("   T_1 = {}", BigRational::from(constant));
    Ok(())
}
