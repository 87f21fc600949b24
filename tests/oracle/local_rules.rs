//! Reference values of rings.

use subcert::bound::LocalConstants;
use subcert::exact::{Rational, RealCyclotomic};
use subcert::oracle::{
    Control, LocalRequest, OracleError, check_slice_within_ulps, check_within_ulps, refine_ring,
    ring_reference_values, to_csv, to_json,
};
use subcert::scheme::parse_local_rules;
use subcert::{assert_slice_within_ulps, assert_within_ulps};

fn request(scheme: &str, control: Control, level: u32) -> LocalRequest {
    LocalRequest { scheme: scheme.to_owned(), max_block: 2, control, level }
}

// The face of n vertices on a circle shrinks by 1/2 about its centre.
#[test]
fn a_regular_face_is_halved() {
    for n in [3, 5, 8] {
        let face = parse_local_rules(&format!("doo-sabin:n={n}")).unwrap();
        let x: Vec<RealCyclotomic> =
            (0..n).map(|j| RealCyclotomic::cosine(&Rational::new(j, n)).unwrap()).collect();
        let eighth = RealCyclotomic::from(Rational::new(1, 8));
        let wanted: Vec<RealCyclotomic> = x.iter().map(|x| x * &eighth).collect();
        assert_eq!(refine_ring(&face, &x, 3).unwrap(), wanted);
        let angle =
            |j: i64| f64::from(u32::try_from(j).unwrap()) / f64::from(u32::try_from(n).unwrap());
        let values: Vec<f64> =
            (0..n).map(|j| (std::f64::consts::TAU * angle(j)).cos() / 8.0).collect();
        for (value, wanted) in values.iter().zip(&wanted) {
            subcert::assert_within!(*value, wanted, Rational::power_of_ten(-15));
        }
    }
}

#[test]
fn values_are_those_of_the_library() {
    let ring = parse_local_rules("doo-sabin:n=5").unwrap();
    let control = Control::seeded_polygon(3, 5);
    let values = ring_reference_values(&ring, &request("a face", control.clone(), 2)).unwrap();
    let exact = |quantity: &str| -> Vec<String> {
        values.group(quantity).unwrap().values.iter().map(|value| value.exact.clone()).collect()
    };
    let points: Vec<RealCyclotomic> = control.values().iter().map(Into::into).collect();
    let refined = refine_ring(&ring, &points, 2).unwrap();
    assert_eq!(exact("refined"), refined.iter().map(ToString::to_string).collect::<Vec<_>>());
    let constants = LocalConstants::new(&ring, 2).unwrap();
    let t = |c| constants.contraction(c).unwrap().1.value.to_string();
    assert_eq!(exact("contraction-constant"), [t(1), t(2)]);
    assert_eq!(values.group("weights").unwrap().shape, [5, 5]);
    assert_eq!(values.group("contraction-constant").unwrap().values[1].index, [2]);
    let json: serde_json::Value = serde_json::from_str(&to_json(&values)).unwrap();
    assert_eq!(json["header"]["ring"]["points"][4], "face[4]");
    assert_eq!(json["header"]["ring"]["edges"][4], serde_json::json!([4, 0]));
    assert!(json["header"].get("masks").is_none() && json["header"].get("boundary").is_none());
    let csv = to_csv(&values);
    assert!(csv.contains("# shape: points face[0] face[1] face[2] face[3] face[4], edges 0-1 "));
    assert!(csv.contains("\nweights,0:1,3/20 + 1/10*cos(2*pi/5),1.8090169943749474e-1,"));
    // What the f64 column says is nearest.
    let near: Vec<f64> =
        values.group("refined").unwrap().values.iter().map(|v| v.f64.parse().unwrap()).collect();
    assert_slice_within_ulps!(near, refined, 0.5);
    assert_within_ulps!(near[0], &refined[0], 0.5);
    let off = check_within_ulps(near[0].next_up(), &refined[0], 0.5).unwrap_err().to_string();
    assert!(off.contains("cos(2*pi/5)"), "{off}");
    assert!(check_slice_within_ulps(&near[1..], &refined, 0.5).is_err());
}

#[test]
fn what_is_refused() {
    let ring = parse_local_rules("catmull-clark:N=3").unwrap();
    let refuse = |points, level| {
        let control = Control::seeded_polygon(1, points);
        ring_reference_values(&ring, &request("", control, level)).unwrap_err()
    };
    let error = refuse(8, 1);
    assert_eq!(error.to_string(), "8 control points for a ring of 7: 1 vertex, 3 edge, 3 face");
    assert_eq!(refuse(7, 65), OracleError::Level(65));
}
