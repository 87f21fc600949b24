//! Gauges of absolutely convex hulls against all bases.

use proptest::prelude::*;
use subcert::float::extremal::AbsoluteHull;

type Row = [f64; 3];

fn determinant([a, b, c]: [&Row; 3]) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// The least Σ|c_j| with x = Σ c_j v_j. A basis attains it; Cramer's rule gives its coefficients.
fn by_all_bases(rows: &[Row], x: &Row) -> f64 {
    let mut least = f64::INFINITY;
    for (i, a) in rows.iter().enumerate() {
        for (j, b) in rows.iter().enumerate().skip(i + 1) {
            for c in &rows[j + 1..] {
                let whole = determinant([a, b, c]);
                if whole != 0.0 {
                    let parts = [[x, b, c], [a, x, c], [a, b, x]].map(determinant);
                    least = least.min(parts.iter().map(|part| (part / whole).abs()).sum());
                }
            }
        }
    }
    least
}

/// A row of small integers. Many are 0, so that bases have coefficients of 0.
fn row() -> impl Strategy<Value = Row> {
    let entry = prop_oneof![Just(0_i8), -3_i8..=3];
    [entry.clone(), entry.clone(), entry].prop_map(|row| row.map(f64::from))
}

proptest! {
    #[test]
    fn a_gauge_is_the_least_of_all_bases(
        more in proptest::collection::vec(row(), 0..12),
        points in proptest::collection::vec(row(), 1..12),
    ) {
        let units = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let rows: Vec<Row> = units.into_iter().chain(more).collect();
        let lists = rows.iter().map(|row| row.to_vec()).collect();
        // One hull for all points: each search begins where the one before ended.
        let mut hull = AbsoluteHull::new(lists).expect("the unit rows span the space");
        for x in points {
            let found = hull.gauge(&x, 0.0);
            let least = by_all_bases(&rows, &x);
            prop_assert!((found.value - least).abs() < 1e-9, "{} and {least}", found.value);
            for k in 0..3 {
                let sum: f64 = found.combination.iter().map(|(j, c)| c * rows[*j][k]).sum();
                prop_assert!((sum - x[k]).abs() < 1e-12);
            }
        }
    }
}
