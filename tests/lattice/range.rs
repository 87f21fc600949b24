//! Ranges of a parameter of masks on Z^d.

use super::examples::{BUTTERFLY, QUINCUNX};
use crate::common::r;
use subcert::exact::{IntervalSet, Rational};
use subcert::lattice::{LatticeRange, LatticeSmoothness, lattice_range};
use subcert::scheme::{parse_lattice, parse_lattice_in_parameter};
use subcert::stop::Stop;

fn range(text: &str, m: u32) -> LatticeRange {
    let mask =
        parse_lattice_in_parameter(text, "w").unwrap_or_else(|error| panic!("{text}: {error}"));
    lattice_range(&mask, m).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// The values are in the set, or are not.
fn contains(set: &IntervalSet, values: &[Rational], holds: bool) {
    for value in values {
        assert_eq!(set.contains(value), holds, "{value} in {set}");
    }
}

/// C^0 for weights between −1/12 and 1/4, C^1 for those between 0 and 1/8, as far as it is proven, and nowhere else.
#[test]
fn butterfly() {
    let continuous = range(BUTTERFLY, 0);
    assert_eq!(continuous.outside.to_string(), "(-inf, -1/12] u [1/4, inf)");
    contains(&continuous.inside, &[r(-1, 13), r(0, 1), r(1, 16), r(6, 25)], true);
    let smooth = range(BUTTERFLY, 1);
    assert_eq!(smooth.outside.to_string(), "(-inf, 0] u [1/8, inf)");
    contains(&smooth.inside, &[r(1, 10_000), r(1, 32), r(1, 16), r(1, 10), r(31, 250)], true);
    assert!(!smooth.but_finitely_many && smooth.gap.is_some_and(|gap| gap < r(1, 2_000)));
}

/// The line from the bilinear mask to its square: where shifts may be dependent, finitely many values outside may be exceptions.
#[test]
fn masks_that_keep_no_data() {
    let found = range("(1+x)*(1+y)*(1+x*y)/2*(1+w*((1+x)*(1+y)*(1+x*y)/8-1))", 1);
    assert!(found.but_finitely_many || found.outside.is_empty());
    assert!(found.sum_rules >= 2);
}

/// At single values the exponent says the same.
#[test]
fn single_values_agree() {
    let five = format!("1+(1/2-w)*(x+1/x)+w*(y+1/y){QUINCUNX}");
    let courant = "(1+x)*(1+y)*(1+x*y)/2+w*(x-1)*(y-1)*(x-1/y)".to_owned();
    for (text, m) in [(five, 0), (courant, 0)] {
        let found = range(&text, m);
        let mut decided = 0;
        for value in [r(-3, 4), r(-1, 4), r(-1, 20), r(0, 1), r(1, 20), r(1, 4), r(2, 5), r(3, 2)] {
            let separator = if text.contains(':') { "," } else { ":" };
            let mask = parse_lattice(&format!("{text}{separator}w={value}")).expect("a mask");
            let single = LatticeSmoothness::general(&mask, &Stop::default());
            if found.inside.contains(&value) {
                assert_ne!(single.converges, Some(false), "{text} at {value}");
            }
            if found.outside.contains(&value) {
                assert_ne!(single.converges, Some(true), "{text} at {value}");
            }
            let known = found.inside.contains(&value) || found.outside.contains(&value);
            decided += usize::from(known && single.converges.is_some());
        }
        assert!(decided >= 4, "{text}: {} and {}", found.inside, found.outside);
    }
}

#[test]
fn what_is_refused() {
    let courant = parse_lattice_in_parameter("(1+x)*(1+y)*(1+x*y)/2+w*(x-1)*(y-1)*(x-1/y)", "w");
    let courant = courant.expect("a mask");
    let error = lattice_range(&courant, 2).expect_err("sum rules");
    assert!(error.to_string().contains("sum rules of an order above 2"), "{error}");
    let apart = "(1+x)^2/(2*x)*(1+y+y^2)^2/(3*y^2)*(1+w*(x-1)^2*(y-1)^3):dilation=[[2,0],[0,3]]";
    let apart = parse_lattice_in_parameter(apart, "w").expect("a mask");
    assert!(lattice_range(&apart, 1).expect_err("two moduli").to_string().contains("C^0"));
    let solid = parse_lattice_in_parameter("four-point-tensor-3d", "w").expect("a mask");
    assert!(lattice_range(&solid, 0).expect_err("a cap").to_string().contains("at most 96"));
    for text in ["chaikin", "(1+x)*(1+y)/1", "(1+x)*(1+y)*(1+x*y)/2"] {
        assert!(parse_lattice_in_parameter(text, "w").is_err(), "{text}");
    }
}
