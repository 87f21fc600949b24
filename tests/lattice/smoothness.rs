//! Exponents and orders of limits of masks on Z^d.

use super::examples::{BUTTERFLY, KOBBELT, OTHER_TRIANGLES, QUINCUNX, TRIANGLES};
use subcert::exact::Rational;
use subcert::lattice::{LatticeRadius, LatticeSmoothness, Tiling, directions, least_cut};
use subcert::scheme::{LatticeMask, parse_lattice};
use subcert::stop::Stop;

fn general(text: &str) -> LatticeSmoothness {
    let mask = parse_lattice(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    LatticeSmoothness::general(&mask, &Stop::default())
}

/// The accuracy, the exponent, and the orders m for which the limits are C^m and not.
fn check(text: &str, accuracy: u32, exponent: &str, orders: (u32, u32)) {
    let found = general(text);
    assert_eq!(found.converges, Some(true), "{text}");
    assert_eq!(found.accuracy, Some(accuracy), "{text}");
    let formula = found.hoelder.expect("it converges").formula;
    assert_eq!(formula.expect("exact").to_string(), exponent, "{text}");
    assert_eq!(
        (found.continuity, found.continuity_fails),
        (Some(orders.0), Some(orders.1)),
        "{text}"
    );
}

#[test]
fn box_splines() {
    check("(1+x)*(1+y)*(1+x*y)/2", 2, "1", (0, 1));
    check("(1+x)^2*(1+y)^2*(1+x*y)/8", 3, "2", (1, 2));
    check("(1+x)^2*(1+y)^2*(1+x*y)^2/16", 4, "3", (2, 3));
    check("(1+x)^3*(1+y)^3/16", 3, "2", (1, 2));
    check("(1+x)^2*(1+y)^2*(1+z)^2/8", 2, "1", (0, 1));
}

/// With dependent shifts the accuracy decides, and not the sum rules: with these, 4 in place of 5.
#[test]
fn dependent_shifts() {
    check("(1+x)*(1+y)*(1+x*y)*(1+x/y)/4", 3, "2", (1, 2));
    check(&format!("(1+x)*(1+y)/2{QUINCUNX}"), 3, "2", (1, 2));
    check("(1+x)*(1+y)/2:dilation=[[1,-1],[1,1]]", 3, "2", (1, 2));
    check(&format!("(1+x)^2*(1+y)^2/8{QUINCUNX}"), 6, "5", (4, 5));
}

#[test]
fn interpolatory_schemes() {
    let five = "2 - log_2(x), x = 2.61803398875 the root of x^2 - 3x + 1 from 2 to 3";
    check(&format!("1+(x+1/x+y+1/y)/4{QUINCUNX}"), 2, five, (0, 1));
    check(&format!("1+(x+1/x+y+1/y+x/y+y/x)/3{OTHER_TRIANGLES}"), 2, "2 - log_3(4)", (0, 1));
    check(&format!("{BUTTERFLY}:w=1/16,{}", &TRIANGLES[1..]), 4, "2", (1, 2));
    let half = "2 - log_2(x), x = 1.70710678119 the root of 2x^2 - 4x + 1 from 1 to 2";
    check(&format!("{BUTTERFLY}:w=1/32"), 2, half, (1, 2));
}

/// The exponent is log_3 18 if the radius is 1/18; it is enclosed.
#[test]
fn kobbelt() {
    let found = general(&format!("{KOBBELT}{OTHER_TRIANGLES}"));
    assert_eq!((found.continuity, found.continuity_fails), (Some(2), Some(3)));
    let exponent = found.hoelder.expect("it converges");
    assert!(
        exponent.lower > Rational::new(263, 100) && exponent.upper < Rational::new(26_310, 10_000)
    );
}

/// Differences do not contract, though φ is continuous; and the exponents of an anisotropic matrix are those of its factors.
#[test]
fn what_is_not_said() {
    let found = general("(1+x^3)^2*(1+y)^2/4");
    assert_eq!((found.converges, found.continuity_fails), (Some(false), Some(0)));
    let unequal = "(1+x)^2*(1+y+y^2)^2/6:dilation=[[2,0],[0,3]]";
    let found = general(unequal);
    assert_eq!(
        (found.continuity, found.continuity_fails, found.hoelder.is_none()),
        (Some(0), None, true)
    );
    let mask = parse_lattice(unequal).unwrap();
    let found = LatticeSmoothness::until(&mask, &Stop::default());
    assert_eq!(
        found.hoelder.and_then(|found| found.formula).map(|it| it.to_string()),
        Some("1".to_owned())
    );
}

/// A product as a mask on Z^2 is as smooth as the least smooth of its factors.
#[test]
fn products() {
    for text in [
        "b-spline:degree=1 x b-spline:degree=2",
        "b-spline:degree=2 x b-spline:degree=3",
        "four-point:w=1/32 x b-spline:degree=1",
        "ternary-three-point:a=2/9 x ternary-three-point:a=2/9",
    ] {
        let mask = parse_lattice(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let stop = Stop::default();
        let (general, factors) =
            (LatticeSmoothness::general(&mask, &stop), LatticeSmoothness::until(&mask, &stop));
        assert_eq!(general.continuity, factors.continuity, "{text}");
        assert_eq!(general.accuracy, factors.accuracy, "{text}");
        let [general, factors] =
            [general, factors].map(|found| found.hoelder.expect("it converges"));
        assert!(general.lower <= factors.upper && factors.lower <= general.upper, "{text}");
    }
}

/// Both tilings have one radius.
#[test]
fn alcoves_and_digits() {
    let radius = |mask: &LatticeMask, tiling: &Tiling| {
        LatticeRadius::near_tile(mask, tiling, &Stop::default())
            .expect("within the caps")
            .expect("it converges")
            .1
    };
    for text in [
        "(1+x)^2*(1+y)^2*(1+x*y)^2/(16*x^2*y^2)".to_owned(),
        format!("1+(x+1/x+y+1/y)/4{QUINCUNX}"),
        format!("1+(x+1/x+y+1/y+x/y+y/x)/3{OTHER_TRIANGLES}"),
        format!("{BUTTERFLY}:w=1/20"),
    ] {
        let mask = parse_lattice(&text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let alcove = Tiling::of_alcove(&mask).expect("it has the symmetries");
        assert_eq!(alcove.parts.len(), mask.dilation().class_count());
        let alcove = radius(&mask, &alcove);
        let digits = radius(&mask, &Tiling::of_digits(mask.dilation()).expect("a small tile"));
        assert!(alcove.matrices.size() < digits.matrices.size(), "{text}");
        let enclosed = [&alcove, &digits]
            .map(|found| (found.radius.root_enclosure().lower().clone(), found.radius.upper()));
        assert!(enclosed[0].0 <= enclosed[1].1 && enclosed[1].0 <= enclosed[0].1, "{text}");
    }
}

/// Of M with two moduli C^1 is shown by 3ϱ_2 = 3/4; C^2 holds too, and is open in the general way.
#[test]
fn two_moduli() {
    let text = "(1+x)^4/8*(1+y+y^2)^4/27:dilation=[[2,0],[0,3]]";
    let found = general(text);
    assert_eq!((found.converges, found.continuity), (Some(true), Some(1)));
    assert!(found.hoelder.is_none() && found.open.is_some());
    let factors = LatticeSmoothness::until(&parse_lattice(text).expect("a mask"), &Stop::default());
    assert_eq!(factors.continuity, Some(2));
}

/// The directions of box splines, and what follows: the same as by radii.
#[test]
fn directions_of_box_splines() {
    for (text, count, cut) in [
        ("(1+x)*(1+y)*(1+x*y)/2", 3, 2),
        ("(1+x)^2*(1+y)^2*(1+x*y)/8", 5, 3),
        ("(1+x)*(1+y)*(1+x*y)*(1+x/y)/4", 4, 3),
        ("(1+x)^2*(1+y)^2/8:dilation=[[1,1],[1,-1]]", 8, 6),
        ("(1+x)*(1+y)/2:dilation=[[1,-1],[1,1]]", 4, 3),
        ("(1+x+x^2)*(1+y+y^2)*(1+x*y+x^2*y^2)/3:dilation=[[3,0],[0,3]]", 3, 2),
        ("(1+x)*(1+y)*(1+x*y)/(2*x):dilation=[[-2,0],[0,-2]]", 3, 2),
    ] {
        let mask = parse_lattice(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let Some(found) = directions(&mask) else { panic!("{text}") };
        assert_eq!((found.len(), least_cut(&found, 2)), (count, cut), "{text}");
        let (own, by_radii) = (
            LatticeSmoothness::until(&mask, &Stop::default()),
            LatticeSmoothness::by_radii(&mask, &Stop::default()),
        );
        let known = |found: &LatticeSmoothness| {
            let exponent = found.hoelder.as_ref().and_then(|one| one.formula.as_ref());
            (
                found.continuity,
                found.continuity_fails,
                found.accuracy,
                exponent.map(ToString::to_string),
            )
        };
        assert_eq!(known(&own), known(&by_radii), "{text}");
    }
    for text in [
        "1+(x+1/x+y+1/y)/4:dilation=[[1,1],[1,-1]]",
        "(1+x)*(1+y)*(1+x*y)/2*(3+x)/4",
        "(1+x+x^2)*(1+y+y^2)/9*4",
    ] {
        if let Ok(mask) = parse_lattice(text) {
            assert!(directions(&mask).is_none(), "{text}");
        }
    }
}
