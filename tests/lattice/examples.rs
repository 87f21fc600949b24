//! Masks with known facts: box splines, and interpolatory and quincunx schemes of the literature.

use crate::common::r;
use subcert::exact::Rational;
use subcert::lattice::{
    Edges, LatticeConstants, displacement, natural_shift, proves, reproduction, sum_rules,
    symmetries,
};
use subcert::scheme::parse_lattice;

pub(super) const TRIANGLES: &str = ":edges=[[1,0],[0,1],[1,1]]";
pub(super) const OTHER_TRIANGLES: &str = ":dilation=[[1,2],[-2,-1]],edges=[[1,0],[0,1],[1,-1]]";
pub(super) const QUINCUNX: &str = ":dilation=[[1,1],[1,-1]]";

/// The mask of the butterfly scheme in its weight w.
pub(super) const BUTTERFLY: &str = "(1+x)*(1+y)*(1+x*y)/(2*x*y)*(1-w*(2*x^-2*y^-1+2*x^-1*y^-2-4*x^-1*y^-1-4*x^-1-4*y^-1+2*x^-1*y+2*x*y^-1+12-4*x-4*y-4*x*y+2*x^2*y+2*x*y^2))";

/// Kobbelt's √3 scheme in the regular region.
pub(super) const KOBBELT: &str =
    "2/3+(x+1/x+y+1/y+x/y+y/x)/3+(x*y+1/(x*y)+x^2/y+y/x^2+x/y^2+y^2/x)/18";

/// The sum rules, the degree of reproduction, the natural shift, the number of symmetries, T_1, T_2, T_3 and Λ_1.
fn check(text: &str, orders: [u32; 2], shift: &str, count: usize, constants: &[&str]) {
    let mask = parse_lattice(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    assert_eq!([sum_rules(&mask), reproduction(&mask)], orders, "{text}");
    let found: Vec<String> = natural_shift(&mask).iter().map(ToString::to_string).collect();
    assert_eq!(found.join(","), shift, "{text}");
    assert_eq!(symmetries(&mask).len(), count, "{text}");
    let edges = Edges::new(mask.edges(), mask.dimension());
    let mut all = LatticeConstants::new(&mask);
    for (c, expected) in (1..).zip(constants) {
        all.advance().expect("few classes");
        let found = all.contraction().expect("few places");
        assert_eq!(found.value.to_string(), *expected, "T_{c} of {text}");
        assert!(proves(&found.functional, &edges, &found.norm), "T_{c} of {text}");
    }
}

#[test]
fn box_splines() {
    let courant = format!("(1+x)*(1+y)*(1+x*y)/2{TRIANGLES}");
    check(&courant, [2, 1], "1,1", 12, &["1/2", "1/4", "1/8"]);
    let cubic = format!("(1+x)^2*(1+y)^2*(1+x*y)/8{TRIANGLES}");
    check(&cubic, [3, 1], "3/2,3/2", 4, &["1/2", "1/4", "1/8"]);
    let quartic = format!("(1+x)^2*(1+y)^2*(1+x*y)^2/16{TRIANGLES}");
    check(&quartic, [4, 1], "2,2", 12, &["1/2", "1/4", "1/8"]);
    check("(1+x)*(1+y)*(1+x*y)*(1+x/y)/4", [2, 1], "3/2,1/2", 8, &["1/2", "1/4", "1/8"]);
    check("(1+x)^4*(1+y)^4/64", [4, 1], "2,2", 8, &["1/2", "1/4", "1/8"]);
    let ternary =
        "(1+x+x^2)*(1+y+y^2)*(1+x*y+x^2*y^2)/3:dilation=[[3,0],[0,3]],edges=[[1,0],[0,1],[1,1]]";
    check(ternary, [2, 1], "1,1", 12, &["1/3", "1/9", "1/27"]);
    check("(1+x)^2*(1+y)^2*(1+z)^2/8", [2, 1], "1,1,1", 48, &["1/2", "1/4", "1/8"]);
    let four = "(1+x)*(1+y)*(1+z)*(1+x*y*z)/2:edges=[[1,0,0],[0,1,0],[0,0,1],[1,1,1]]";
    check(four, [2, 1], "1,1,1", 48, &["1/2", "1/4", "1/8"]);
}

#[test]
fn interpolatory_schemes() {
    let at = |w: &str| format!("{BUTTERFLY}:w={w},{}", &TRIANGLES[1..]);
    check(&at("1/16"), [4, 3], "0,0", 12, &["3/4", "7/16", "469/2048", "941/8192"]);
    check(&at("1/32"), [2, 1], "0,0", 12, &["5/8", "21/64", "1369/8192"]);
    let product = "four-point:w=1/16 x four-point:w=1/16";
    check(product, [4, 3], "0,0", 8, &["49/64", "403/1024", "105/512", "1742245/16777216"]);
    let quasi = "(3 - (x+1/x+y+1/y)/2)*(1+x)^2*(1+y)^2*(1+x*y)*(1+x/y)/16";
    check(quasi, [4, 3], "2,1", 8, &["7/8", "29/64", "1861/8192"]);
}

#[test]
fn other_dilation_matrices() {
    let midedge = format!("(1+x)*(1+y)/2{QUINCUNX}");
    check(&midedge, [2, 1], "3/2,1/2", 8, &["1", "1/2", "1/2", "1/4"]);
    let four_eight = format!("(1+x)^2*(1+y)^2/8{QUINCUNX}");
    check(&four_eight, [4, 1], "3,1", 8, &["1", "1/2", "1/2", "1/4"]);
    let five = format!("1+(x+1/x+y+1/y)/4{QUINCUNX}");
    check(&five, [2, 1], "0,0", 8, &["1", "3/4", "5/8", "1/2"]);
    check("(1+x)*(1+y)/2:dilation=[[1,-1],[1,1]]", [2, 1], "1/2,-1/2", 8, &["1", "1/2"]);
    let root_three = format!("1+(x+1/x+y+1/y+x/y+y/x)/3{OTHER_TRIANGLES}");
    check(&root_three, [2, 1], "0,0", 12, &["2/3", "4/9", "8/27"]);
    let kobbelt = format!("{KOBBELT}{OTHER_TRIANGLES}");
    check(&kobbelt, [3, 1], "0,0", 12, &["2/3", "28/81", "649/2916", "503/4374"]);
    let unequal = "(1+x)^2*(1+y+y^2)^2/6:dilation=[[2,0],[0,3]]";
    check(unequal, [2, 1], "1,1", 4, &["1/2", "1/4", "1/8"]);
}

/// σ with the points of level k at M^{−k}α, and at their natural places.
#[test]
fn displacements() {
    let check = |text: &str, expected: [&str; 2]| {
        let mask = parse_lattice(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let origin = vec![Rational::zero(); mask.dimension()];
        let found = [origin, natural_shift(&mask)].map(|shift| {
            displacement(&mask, &shift).expect("few places").expect("in the plane").to_string()
        });
        assert_eq!(found, expected, "{text}");
    };
    // Points that are kept, and the mean of two where one is expected: nothing moves.
    check(&format!("(1+x)*(1+y)*(1+x*y)/(2*x*y){TRIANGLES}"), ["0", "0"]);
    check("(1+x)^2*(1+y)^2/(4*x*y)", ["0", "0"]);
    check(&format!("1+(x+1/x+y+1/y+x/y+y/x)/3{OTHER_TRIANGLES}"), ["1/3", "1/3"]);
    check("four-point:w=1/16 x four-point:w=1/16", ["9/32", "9/32"]);
    check(&format!("{BUTTERFLY}:w=1/16,{}", &TRIANGLES[1..]), ["1/4", "1/4"]);
    // The cubic B-spline moves points by a quarter of the second difference, which is at most 2, along both axes.
    check("(1+x)^4*(1+y)^4/(64*x^2*y^2)", ["1/2", "1/2"]);
}

/// What looks right and is not: a dilation matrix of the other third direction, the wrong edges, digits of a part.
#[test]
fn traps() {
    let error = parse_lattice(&format!("{KOBBELT}:dilation=[[2,-1],[1,-2]]")).unwrap_err();
    assert!(error.to_string().contains("sum to"), "{error}");
    let edges = ":dilation=[[1,2],[-2,-1]],edges=[[1,0],[0,1],[1,1]]";
    let mask = parse_lattice(&format!("1+(x+1/x+y+1/y+x/y+y/x)/3{edges}")).unwrap();
    let mut constants = LatticeConstants::new(&mask);
    constants.advance().expect("few classes");
    assert_eq!(constants.contraction().expect("few places").value, Rational::from(2));
    // φ is continuous, and differences do not contract.
    let mask = parse_lattice("(1+x^3)^2*(1+y)^2/4").unwrap();
    let mut constants = LatticeConstants::new(&mask);
    for expected in [r(3, 2), r(5, 4), r(11, 8)] {
        constants.advance().expect("few classes");
        assert_eq!(constants.contraction().expect("few places").value, expected);
    }
}
