// Tests a refinement in Rust against reference values, without any crate:
//   subcert oracle chaikin --level 5 -o oracle_chaikin.rs
//   rustc --test my_chaikin.rs && ./my_chaikin
mod oracle_chaikin;
use oracle_chaikin as oracle;

fn my_chaikin(points: &[f64]) -> Vec<f64> {
    let pairs = points.iter().zip(points.iter().cycle().skip(1));
    pairs.flat_map(|(here, next)| [0.75 * here + 0.25 * next, 0.25 * here + 0.75 * next]).collect()
}

#[test]
fn chaikin() {
    let found = (0..oracle::LEVEL).fold(oracle::CONTROL.to_vec(), |points, _| my_chaikin(&points));
    assert_eq!(found.len(), oracle::REFINED.len());
    for (i, found) in found.iter().enumerate() {
        let (expected, ulp) = (oracle::REFINED[i], oracle::REFINED_ULP[i]);
        assert!((found - expected).abs() <= 4.0 * ulp, "point {i} is {found} in place of {expected}");
    }
}
