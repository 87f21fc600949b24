//! Reference values of masks on Z^d.

use std::collections::BTreeMap;
use subcert::exact::Rational;
use subcert::lattice::limit_values;
use subcert::oracle::{
    Control, LatticeRequest, OracleError, OracleValues, lattice_reference_values, to_source,
};
use subcert::scheme::{Point, parse_lattice};
use subcert::spectrum::table::Language;

fn request(control: Option<Control>, level: u32) -> LatticeRequest {
    LatticeRequest { scheme: "mine".to_owned(), max_block: 2, control, level }
}

/// The values of a group at their places, without zeros.
fn placed(values: &OracleValues, name: &str) -> BTreeMap<Point, Rational> {
    let first: Vec<i64> = values
        .group(&format!("{name}-first"))
        .expect("a place")
        .values
        .iter()
        .map(|x| x.exact.parse().expect("an integer"))
        .collect();
    let mut found = BTreeMap::new();
    for value in &values.group(name).expect("a group").values {
        let exact: Rational = value.exact.parse().expect("a fraction");
        let mut place = [0; 3];
        for ((at, i), first) in place.iter_mut().zip(&value.index).zip(&first) {
            *at = i64::try_from(*i).expect("few") + first;
        }
        if !exact.is_zero() {
            found.insert(place, exact);
        }
    }
    found
}

/// A single 1 is refined to the values of two steps, and its limit is φ.
#[test]
fn a_single_one() {
    let mask = parse_lattice("1+(x+1/x+y+1/y)/4:dilation=[[1,1],[1,-1]]").expect("a mask");
    let values = lattice_reference_values(&mask, &request(None, 3)).expect("few values");
    assert_eq!(placed(&values, "mask"), *mask.coefficients());
    let limit = limit_values(&mask, 3).expect("few").expect("it converges");
    assert_eq!(placed(&values, "limit"), limit);
    assert_eq!(values.group("contraction-constant").expect("T_c").values[1].exact, "3/4");
    let text = to_source(&values, Language::C).expect("C");
    assert!(text.contains("refined") && text.contains("limit"));
}

/// A plane is kept where lines are: constant data inside give constants.
#[test]
fn a_grid() {
    let mask = parse_lattice("(1+x)^2*(1+y)^2/(4*x*y)").expect("a mask");
    let ones = Control::grid(vec![1; 25], 5).expect("a grid");
    let values = lattice_reference_values(&mask, &request(Some(ones), 2)).expect("few values");
    let (refined, limit) = (placed(&values, "refined"), placed(&values, "limit"));
    for i in 0..17 {
        for j in 0..17 {
            assert_eq!(
                (&refined[&[i, j, 0]], &limit[&[i, j, 0]]),
                (&Rational::one(), &Rational::one())
            );
        }
    }
}

#[test]
fn what_is_refused() {
    let mask = parse_lattice("(1+x)*(1+y)*(1+x*y)/2").expect("a mask");
    let refused = |control, level| lattice_reference_values(&mask, &request(control, level));
    assert!(matches!(refused(None, 1_000), Err(OracleError::Level(1_000))));
    assert!(matches!(refused(None, 16), Err(OracleError::TooMany)));
    let polygon = Control::seeded_polygon(1, 4);
    assert!(matches!(refused(Some(polygon), 1), Err(OracleError::Shape { .. })));
    // Without limits there is no limit.
    let apart = parse_lattice("(1+x)*(1+y)*(1+x*y)/2*(1+3*(x-1)*(y-1))").expect("a mask");
    let values = lattice_reference_values(&apart, &request(None, 1)).expect("few values");
    assert!(values.group("limit").is_none() && values.group("refined").is_some());
}
