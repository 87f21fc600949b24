#![allow(missing_docs)]
use subcert::exact::{Rational, format::short};
use subcert::joint::*;
use subcert::scheme::parse_scheme;
use subcert::smoothness::*;
#[test]
fn look() {
    let matrix = |rows: [[i64; 2]; 2]| rows.map(|row| row.map(Rational::from).to_vec()).to_vec();
    let pair = MatrixSet::new(vec![matrix([[-1, -1], [-4, 0]]), matrix([[3, 3], [-2, 1]])]).unwrap();
    let t = std::time::Instant::now();
    let r = joint_radius(&pair);
    println!("{:?} {} {} exact {} {} rows {:?}", r.product, r.root, r.degree, r.exact, short(&r.hull.as_ref().unwrap().bound, 14), r.hull.as_ref().map(|h| h.rows.len()));
    println!("{:?}", t.elapsed());
    for name in ["chaikin","four-point:w=1/16","four-point:w=1/15","four-point:w=1/10","four-point:w=1/4","six-point:w=3/256","six-point:w=1/100","b-spline:degree=1","b-spline:degree=2","b-spline:degree=5","ternary-four-point:mu=1/11","ternary-four-point:mu=1/9","ternary-four-point:mu=1/15","ternary-four-point:mu=1/14","ternary-three-point","bajaj","quinary-three-point","ternary-four-point-approximating","quaternary-four-point:mu=1/2"] {
        let t = std::time::Instant::now();
        let scheme = match parse_scheme(name) { Ok(s) => s, Err(e) => { println!("{name}: {e}"); continue } };
        let s = Smoothness::of(scheme.masks()[0]).unwrap();
        let d = s.deciding();
        println!("{name}: K {} rep {} supp {:?} C {:?} fails {:?} reduced {} prod {:?} root {} exact {}", s.sum_rules, s.reproduction, s.symbol.support(), s.continuity, s.continuity_fails, s.reduced.is_some(), d.radius.product, d.radius.root, d.radius.exact);
        if let Some(h) = &s.hoelder { println!("   {} .. {} {} attained {:?}", short(&h.lower, 12), short(&h.upper, 12), h.formula.as_ref().map_or(String::new(), |f| f.to_string()), h.attained); }
        println!("   {:?} {:?}", contractions(&d.symbol, s.continuity.unwrap_or(0)).iter().map(|c| c.as_ref().map(|c| (c.0, c.1.to_string()))).collect::<Vec<_>>(), t.elapsed());
    }
}
