//! Testing your own f64 subdivision against exact reference values.
//!
//! Run it with `cargo run --example test_your_own_refinement`. In your own crate,
//! put the same lines into a `#[test]`, with subcert as a dev-dependency.

use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::oracle::{Boundary, check_slice_within_ulps, refine_polygon};
use subcert::scheme::parse_scheme;
use subcert::{assert_slice_within_ulps, assert_within_ulps};

/// Chaikin's corner cutting of a closed polygon, as one writes it.
fn chaikin(points: &[f64]) -> Vec<f64> {
    let mut refined = Vec::with_capacity(2 * points.len());
    for (i, here) in points.iter().enumerate() {
        let next = points[(i + 1) % points.len()];
        refined.push(0.75 * here + 0.25 * next);
        refined.push(0.25 * here + 0.75 * next);
    }
    refined
}

/// The 4-point scheme with tension w on a closed polygon, as one writes it.
fn four_point(points: &[f64], w: f64) -> Vec<f64> {
    let count = points.len();
    let mut refined = Vec::with_capacity(2 * count);
    for i in 0..count {
        let (before, here) = (points[(i + count - 1) % count], points[i]);
        let (next, after) = (points[(i + 1) % count], points[(i + 2) % count]);
        refined.push(here);
        refined.push((0.5 + w) * (here + next) - w * (before + after));
    }
    refined
}

/// The refinement applied several times.
fn repeated(points: &[f64], levels: u32, refine: impl Fn(&[f64]) -> Vec<f64>) -> Vec<f64> {
    (0..levels).fold(points.to_vec(), |points, _| refine(&points))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Control points with thirds and tenths, so that f64 has something to round.
    let exact: Vec<Rational> = [(10, 3), (41, 10), (17, 3), (50, 7), (33, 10), (5, 2)]
        .map(|(p, q)| Rational::new(p, q))
        .to_vec();
    let points: Vec<f64> = exact.iter().map(nearest).collect();
    let levels = 5;

    println!("1. Chaikin, {levels} levels of a closed polygon of {} points.", points.len());
    let scheme = parse_scheme("chaikin")?;
    let expected = refine_polygon(scheme.masks()[0].rules(), &exact, levels, Boundary::Closed)?;
    let found = repeated(&points, levels, chaikin);
    assert_slice_within_ulps!(found, expected, 4.0, "Chaikin");
    println!("   All {} values are within 4 ulps of the exact ones.", found.len());
    println!("   For one, value 1 is exactly {}, and f64 gave {:?}.\n", expected[1], found[1]);

    println!("2. The 4-point scheme with w = 1/17, {levels} levels.");
    let scheme = parse_scheme("four-point:w=1/17")?;
    let expected = refine_polygon(scheme.masks()[0].rules(), &exact, levels, Boundary::Closed)?;
    let found = repeated(&points, levels, |points| four_point(points, 1.0 / 17.0));
    assert_slice_within_ulps!(found, expected, 8.0, "4-point");
    assert_within_ulps!(found[0], &exact[0], 0.5, "an interpolating scheme keeps its points");
    println!("   All {} values are within 8 ulps of the exact ones.\n", found.len());

    println!("3. The same with a slip: w typed as 0.0588 in place of 1/17.");
    let wrong = repeated(&points, levels, |points| four_point(points, 0.0588));
    let Err(mismatch) = check_slice_within_ulps(&wrong, &expected, 8.0) else {
        return Err("the slip was not caught".into());
    };
    println!("   It is caught. What a failing test would say:\n\n{mismatch}");
    Ok(())
}
