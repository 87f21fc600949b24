//! Gauges of hulls and spectral radii in f64, against norms that are known.

use proptest::prelude::*;
use subcert::float::extremal::{AbsoluteHull, candidates, spectral_radius};

fn unit_rows(size: usize) -> Vec<Vec<f64>> {
    let row = |i| (0..size).map(|j| if i == j { 1.0 } else { 0.0 }).collect();
    (0..size).map(row).collect()
}

/// All rows of signs: their hull is a cube.
fn cube(size: u32) -> Vec<Vec<f64>> {
    let sign = |bits: u32, j: u32| if bits >> j & 1 == 1 { 1.0 } else { -1.0 };
    (0..1_u32 << size).map(|bits| (0..size).map(|j| sign(bits, j)).collect()).collect()
}

proptest! {
    #[test]
    fn gauges_of_unit_rows_and_of_cubes_are_norms(x in prop::collection::vec(-9.0..9.0_f64, 4)) {
        let sum: f64 = x.iter().map(|x| x.abs()).sum();
        let greatest = x.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let mut cross = AbsoluteHull::new(unit_rows(4)).expect("they span");
        prop_assert!((cross.gauge(&x, 0.0).value - sum).abs() < 1e-9);
        let mut cube = AbsoluteHull::new(cube(4)).expect("they span");
        let gauge = cube.gauge(&x, 0.0);
        prop_assert!((gauge.value - greatest).abs() < 1e-9, "{} {}", gauge.value, greatest);
        for (k, x) in x.iter().enumerate() {
            let sum: f64 = gauge.combination.iter().map(|(j, c)| c * cube.rows()[*j][k]).sum();
            prop_assert!((sum - x).abs() < 1e-9);
        }
    }

    #[test]
    fn the_radius_of_a_triangular_matrix_is_on_its_diagonal(
        d in prop::collection::vec(-3.0..3.0_f64, 3), above in prop::collection::vec(-9.0..9.0_f64, 3)
    ) {
        let rows = vec![vec![d[0], above[0], above[1]], vec![0.0, d[1], above[2]], vec![0.0, 0.0, d[2]]];
        let greatest = d.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        prop_assert!((spectral_radius(&rows, 0.0) - greatest).abs() < 1e-9 * (1.0 + greatest));
    }
}

#[test]
fn a_shear_and_its_transpose_are_best_in_turn() {
    let pair = [vec![vec![1.0, 1.0], vec![0.0, 1.0]], vec![vec![1.0, 0.0], vec![1.0, 1.0]]];
    let found = candidates(&pair, 9, 100);
    assert_eq!(found.words, [vec![0, 1]]);
    assert!((found.rate - 1.618_033_988_749_895).abs() < 1e-12);
    assert!(AbsoluteHull::new(vec![vec![1.0, 1.0], vec![2.0, 2.0]]).is_none());
}
