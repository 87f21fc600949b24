//! Displacement of tensor products, on grids that close in both directions.

use crate::common::{affine, at, int, polygon, r};
use proptest::prelude::*;
use subcert::bound::{Terms, displacement, surface_coefficients, surface_factor};
use subcert::exact::Rational;
use subcert::scheme::{Mask, Rules};

/// A closed grid x_{i,j}: rows i, columns j.
pub type Grid = Vec<Vec<Rational>>;

pub fn grid() -> impl Strategy<Value = Grid> {
    (1_usize..5, 1_usize..5)
        .prop_flat_map(|(rows, columns)| prop::collection::vec(polygon(columns..columns + 1), rows))
}

pub fn point(grid: &Grid, i: i64, j: i64) -> &Rational {
    let rows = int(grid.len());
    at(&grid[usize::try_from(i.rem_euclid(rows)).unwrap()], j)
}

/// x'_{ni+α, mj+β} = Σ_r Σ_s a_{α,r} b_{β,s} x_{i+o+r, j+p+s}, as it stands.
pub fn refine(first: &Rules, second: &Rules, grid: &Grid) -> Grid {
    let (n, m) = (first.arity(), second.arity());
    let value = |row: usize, column: usize| -> Rational {
        let (i, j) = (int(row / n) + first.offset(), int(column / m) + second.offset());
        let (a, b) = (&first.rows()[row % n], &second.rows()[column % m]);
        (i..)
            .zip(a)
            .map(|(i, x)| x * (j..).zip(b).map(|(j, y)| y * point(grid, i, j)).sum::<Rational>())
            .sum()
    };
    let (rows, columns) = (grid.len() * n, grid[0].len() * m);
    (0..rows).map(|row| (0..columns).map(|column| value(row, column)).collect()).collect()
}

/// The bilinear interpolant of the grid at the indices of the refined one.
pub fn bilinear(grid: &Grid, n: usize, m: usize) -> Grid {
    let value = |row: usize, column: usize| {
        let (i, j) = (int(row / n), int(column / m));
        let (s, t) = (r(int(row % n), int(n)), r(int(column % m), int(m)));
        let along =
            |i: i64| point(grid, i, j) * (Rational::one() - &t) + point(grid, i, j + 1) * &t;
        along(i) * (Rational::one() - &s) + along(i + 1) * s
    };
    let (rows, columns) = (grid.len() * n, grid[0].len() * m);
    (0..rows).map(|row| (0..columns).map(|column| value(row, column)).collect()).collect()
}

/// max|x − y|.
pub fn distance(x: &Grid, y: &Grid) -> Rational {
    x.iter().flatten().zip(y.iter().flatten()).map(|(x, y)| (x - y).abs()).max().unwrap()
}

/// The largest difference along the rows' index, and along the columns'.
pub fn spreads(grid: &Grid) -> [Rational; 2] {
    let indices =
        || (0..int(grid.len())).flat_map(|i| (0..int(grid[0].len())).map(move |j| (i, j)));
    let along = |di, dj| {
        indices().map(|(i, j)| (point(grid, i + di, j + dj) - point(grid, i, j)).abs()).max()
    };
    [along(1, 0).unwrap(), along(0, 1).unwrap()]
}

pub fn spread(grid: &Grid) -> Rational {
    let [first, second] = spreads(grid);
    first.max(second)
}

/// A_α, and ã_{α,m} for m = 1, …, N − 2, at offset 0.
fn parts(mask: &Mask, alpha: usize) -> (Rational, Vec<Rational>) {
    let tail = |m: usize| mask.rules().rows()[alpha].iter().skip(m + 1).sum::<Rational>();
    (tail(0), (1..mask.width().max(1) - 1 + usize::from(mask.width() < 2)).map(tail).collect())
}

fn magnitudes(terms: &[Rational]) -> Rational {
    terms.iter().map(Rational::abs).sum()
}

proptest! {
    #![proptest_config(crate::common::cases(64))]

    #[test]
    fn no_grid_is_displaced_more(first in affine(3, 4), second in affine(3, 4), grid in grid()) {
        let moved = distance(
            &refine(first.rules(), second.rules(), &grid),
            &bilinear(&grid, first.arity(), second.arity()),
        );
        prop_assert!(moved <= surface_factor(&first, &second) * spread(&grid));
    }

    // A grid that changes along one direction is a curve: at least its σ.
    #[test]
    fn curves_are_surfaces(first in affine(4, 5), second in affine(4, 5)) {
        let factor = surface_factor(&first, &second);
        prop_assert!(factor >= displacement(&first, Terms::Each));
        prop_assert!(factor >= displacement(&second, Terms::Each));
    }

    // The identity behind Theorem 7 of Mustafa et al. 2020, on data, with its
    // three kinds of differences; and η as the sums of its coefficients.
    #[test]
    fn theorem_7(mask in affine(3, 5), grid in grid()) {
        let mask = mask.with_offset(0);
        let n = int(mask.arity());
        let refined = refine(mask.rules(), mask.rules(), &grid);
        let linear = bilinear(&grid, mask.arity(), mask.arity());
        let d1 = |i, j| point(&grid, i + 1, j) - point(&grid, i, j);
        let d2 = |i, j| point(&grid, i, j + 1) - point(&grid, i, j);
        for alpha in 0..mask.arity() {
            for beta in 0..mask.arity() {
                let ((a, more_a), (b, more_b)) = (parts(&mask, alpha), parts(&mask, beta));
                let (row, first) = (&mask.rules().rows()[alpha], &mask.rules().rows()[beta][0]);
                let (s, t) = (r(int(alpha), n), r(int(beta), n));
                let near = [
                    first * &a - &s * (Rational::one() - &t),
                    &b - &t,
                    &a * &b - &s * &t,
                ];
                for i in 0..int(grid.len()) {
                    for j in 0..int(grid[0].len()) {
                        let mut sum = &near[0] * d1(i, j) + &near[1] * d2(i, j) + &near[2] * d1(i, j + 1);
                        for (m, coefficient) in (1..).zip(&more_a) {
                            sum += &(coefficient * (first * d1(i + m, j) + &b * d1(i + m, j + 1)));
                        }
                        for (m, coefficient) in (1..).zip(&more_b) {
                            let along = (0..).zip(row).map(|(k, x)| x * d2(i + k, j + m));
                            sum += &(coefficient * along.sum::<Rational>());
                        }
                        let at = |grid: &Grid| point(grid, n * i + int(alpha), n * j + int(beta)).clone();
                        prop_assert_eq!(at(&refined) - at(&linear), sum);
                    }
                }
                let (tail_a, tail_b) = (magnitudes(&more_a), magnitudes(&more_b));
                let each = [
                    near[0].abs() + first.abs() * &tail_a,
                    near[1].abs() + magnitudes(row) * tail_b,
                    near[2].abs() + b.abs() * tail_a,
                ];
                prop_assert_eq!(surface_coefficients(&mask.with_offset(3), alpha, beta, Terms::Each), each);
                let (sum_a, sum_b) = (more_a.iter().sum::<Rational>(), more_b.iter().sum::<Rational>());
                let total = [
                    near[0].abs() + (first * &sum_a).abs(),
                    near[1].abs() + sum_b.abs(),
                    near[2].abs() + (&b * &sum_a).abs(),
                ];
                prop_assert_eq!(surface_coefficients(&mask, alpha, beta, Terms::Total), total);
            }
        }
    }
}
