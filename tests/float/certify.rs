//! Whole schemes: errors within bounds, decisions against exact ones.

use crate::float::strategy::{largest_row_sum, scheme, two};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use std::cell::Cell;
use subcert::bound::{Constants, DepthError, Operator, Order, Suprema, Terms, displacement};
use subcert::exact::{Rational, parse_rational};
use subcert::float::{
    Certification, CertifyError, CertifyOptions, MAX_CERTIFIED_LEVEL, certify, float_depth, nearest,
};
use subcert::scheme::{Mask, Scheme, parse_scheme};

fn two_blocks() -> CertifyOptions {
    CertifyOptions { max_block: 2, ..CertifyOptions::default() }
}

fn curve(rows: &[&[&str]]) -> Scheme {
    let read = |text: &&str| parse_rational(text).expect("a number");
    let rows = rows.iter().map(|row| row.iter().map(read).collect()).collect();
    Scheme::Curve(Mask::new(rows, 0).expect("a mask"))
}

fn catalogue(text: &str) -> Certification {
    certify(&parse_scheme(text).expect("in the catalogue"), &CertifyOptions::default()).unwrap()
}

/// The size of the intermediate numbers: every constant up to c is at most L^{2c},
/// for L the larger of the norms of the scheme and of the differences, or 1.
fn natural_scale(scheme: &Scheme, blocks: i32) -> f64 {
    let masks = scheme.masks();
    let norms = masks
        .iter()
        .flat_map(|mask| [largest_row_sum(mask.rules()), largest_row_sum(&mask.difference())]);
    nearest(&norms.fold(Rational::one(), Ord::max)).powi(2 * blocks)
}

/// The proof holds on every random scheme, for every quantity; and the bounds are
/// of the size of rounding errors, not merely true.
#[test]
fn every_error_is_within_its_bound() {
    let worst_tightness = Cell::new(0.0_f64);
    let worst_size = Cell::new(0.0_f64);
    let mut runner = TestRunner::new(crate::common::cases(48));
    let outcome = runner.run(&scheme(), |scheme| {
        let found = certify(&scheme, &two_blocks()).unwrap();
        prop_assert_eq!(found.tracked_block, 2);
        let scale = natural_scale(&scheme, 2);
        for quantity in &found.quantities {
            prop_assert_eq!(quantity.encloses(), Some(true), "{:?}", quantity);
            worst_tightness.set(worst_tightness.get().max(quantity.tightness.unwrap_or(0.0)));
            if !quantity.name.starts_with("error") {
                let size = quantity.bound.expect("tracked") / scale;
                worst_size.set(worst_size.get().max(size));
                prop_assert!(size < SIZE, "{:?} at scale {}", quantity, scale);
            }
        }
        Ok(())
    });
    eprintln!("worst error/bound {}, bound/scale {}", worst_tightness.get(), worst_size.get());
    outcome.unwrap();
    assert!(worst_tightness.get() <= 1.0);
}

/// Measured: 1.2e-14 at most over 1,500 random schemes.
const SIZE: f64 = 1e-13;

#[test]
fn bounds_are_not_vacuous() {
    let names = ["quinary-three-point", "newton:j=1,n=3", "four-point:w=1/17 x chaikin"];
    for name in names {
        let found = catalogue(name);
        let tightest = found.quantities.iter().filter_map(|q| q.tightness).fold(0.0, f64::max);
        assert!((0.1..=1.0).contains(&tightest), "{name}: {tightest}");
        for quantity in &found.quantities {
            assert_eq!(quantity.encloses(), Some(true), "{quantity:?}");
            assert!(quantity.bound.unwrap() < 1e-12, "{quantity:?}");
        }
    }
}

#[test]
fn dyadic_schemes_are_exact_in_f64() {
    let found = catalogue("chaikin");
    for name in ["b[0][0]", "T_1", "T_4", "Lambda_3", "T_2*Lambda_2", "sigma", "error(c=1, k=10)"] {
        let quantity = found.quantity(name).unwrap_or_else(|| panic!("no {name}"));
        assert_eq!(quantity.bound, Some(0.0), "{name}");
        assert_eq!(quantity.error, Some(Rational::zero()), "{name}");
    }
    assert_eq!(found.quantity("T_4").unwrap().exact, Rational::new(1, 16));
}

/// The exact column is that of the exact path.
#[test]
fn exact_values_are_those_of_the_library() {
    let scheme = parse_scheme("quinary-three-point").unwrap();
    let mask = scheme.masks()[0].clone();
    let found = certify(&scheme, &CertifyOptions::default()).unwrap();
    let value = |name: &str| found.quantity(name).unwrap().exact.clone();
    let constants = Constants::new(mask.clone());
    for c in 1..=4 {
        let norm = |operator| constants.norm(operator, c, Order::Adjoint).unwrap();
        assert_eq!(value(&format!("T_{c}")), norm(Operator::Difference));
        assert_eq!(value(&format!("Lambda_{c}")), norm(Operator::Scheme));
        let tensor = constants.tensor(c, Order::Adjoint, Suprema::Independent).unwrap();
        assert_eq!(value(&format!("T_{c}*Lambda_{c}")), tensor);
    }
    assert_eq!(value("sigma(o=0)"), Rational::new(21, 25));
    let sigma = displacement(&mask, Terms::Each);
    assert_eq!(value("sigma"), sigma);
    let t = Rational::new(17, 25);
    assert_eq!(value("error(c=1, k=5)"), sigma * t.pow(5) / (Rational::one() - t));
}

#[test]
fn a_tensor_product_names_both_directions() {
    let found = catalogue("chaikin x quinary-three-point");
    let value = |name: &str| found.quantity(name).unwrap().exact.clone();
    assert_eq!(value("first T_1"), Rational::new(1, 2));
    assert_eq!(value("second T_1"), Rational::new(17, 25));
    assert_eq!(value("first T_1*second Lambda_1"), Rational::new(31, 50));
    assert_eq!(value("second T_1*first Lambda_1"), Rational::new(17, 25));
    assert!(found.quantity("surface factor").is_some());
    assert_eq!(found.depths.len(), 12);
    assert!(found.depths.iter().all(|depth| depth.agree == Some(true)));
}

/// Chaikin: σ = 1/4 and T_1 = 1/2, so bound(k) = 2^{−k−1}.
#[test]
fn depths_and_margins() {
    let scheme = parse_scheme("chaikin").unwrap();
    let tolerances = vec![two(-10), Rational::new(1, 1_000), Rational::one()];
    let options = CertifyOptions { max_block: 1, tolerances, ..CertifyOptions::default() };
    let found = certify(&scheme, &options).unwrap();
    let exact: Vec<_> = found.depths.iter().map(|depth| depth.exact.clone().unwrap()).collect();
    assert_eq!(exact, [9, 9, 0]);
    let margins: Vec<_> = found.depths.iter().map(|depth| depth.margin.clone().unwrap()).collect();
    assert_eq!(margins[0].at, Rational::one());
    assert_eq!(margins[0].before, Some(Rational::from(2)));
    assert_eq!(margins[1].at, Rational::new(1_000, 1_024));
    assert_eq!((&margins[2].at, &margins[2].before), (&Rational::new(1, 2), &None));
}

/// Two tolerances that are one f64, but an exact tie and just not: whatever the
/// logarithm returns, one of the two f64 decisions is wrong.
#[test]
fn logarithms_cannot_decide_ties() {
    let scheme = parse_scheme("quinary-three-point").unwrap();
    let t = Rational::new(17, 25);
    let sigma = displacement(scheme.masks()[0], Terms::Each);
    let tie = sigma * t.pow(6) / (Rational::one() - t);
    let less = &tie * (Rational::one() - Rational::power_of_ten(-40));
    assert_eq!(nearest(&tie).to_bits(), nearest(&less).to_bits());
    let tolerances = vec![tie, less];
    let options = CertifyOptions { max_block: 1, tolerances, ..CertifyOptions::default() };
    let depths = certify(&scheme, &options).unwrap().depths;
    assert_eq!((depths[0].exact.clone(), depths[1].exact.clone()), (Ok(6), Ok(7)));
    assert_eq!(depths[0].float, depths[1].float);
    assert!(depths.iter().any(|depth| depth.agree == Some(false)));
}

/// 0.7 + 0.2 + 0.1 is below 1 in f64, so that a scheme which does not contract
/// seems to.
#[test]
fn a_ratio_on_the_wrong_side_of_one() {
    let rule: &[&str] = &["7/10", "2/10", "1/10"];
    let tolerances = vec![Rational::power_of_ten(17), Rational::new(1, 100)];
    let options = CertifyOptions { max_block: 1, tolerances, ..CertifyOptions::default() };
    let found = certify(&curve(&[rule, rule]), &options).unwrap();
    let t = found.quantity("T_1").unwrap();
    assert_eq!(t.exact, Rational::one());
    assert!(t.value < 1.0, "{}", t.value);
    assert!(found.quantity("error(c=1, k=1)").is_none());
    let depth = &found.depths[0];
    assert!(depth.exact.is_err() && depth.margin.is_none());
    assert_eq!((depth.float, depth.agree), (Some(0), Some(false)));
    // Here the f64 depth would be about 10^17 levels, which is no depth either.
    let depth = &found.depths[1];
    assert!(depth.logarithm > 1e17 && depth.float.is_none(), "{depth:?}");
}

#[test]
fn overflow_is_a_finding() {
    let huge = Rational::power_of_ten(200);
    let rest = Rational::one() - &huge;
    let rows = vec![vec![huge.clone(), rest.clone()], vec![rest, huge]];
    let scheme = Scheme::Curve(Mask::new(rows, 0).unwrap());
    let found = certify(&scheme, &two_blocks()).unwrap();
    let t = found.quantity("T_2").unwrap();
    assert!(!t.value.is_finite());
    assert_eq!((&t.error, &t.ulps, t.bound), (&None, &None, Some(f64::INFINITY)));
    assert!(found.quantities.iter().all(|quantity| quantity.encloses() == Some(true)));
    assert!(found.depths.iter().all(|depth| depth.float.is_none() && depth.agree == Some(true)));
}

#[test]
fn depths_by_logarithm() {
    assert_eq!(float_depth(1.0, 1.0, 0.5, 0.125).1, Some(4));
    assert_eq!(float_depth(1.0, 1.0, 0.5, 100.0).1, Some(0));
    assert_eq!(float_depth(0.0, 1.0, 0.5, 0.1).1, Some(0));
    for ratio in [1.0, 2.0, f64::NAN, f64::INFINITY] {
        assert_eq!(float_depth(1.0, 1.0, ratio, 0.1).1, None, "{ratio}");
    }
    assert_eq!(float_depth(f64::NAN, 1.0, 0.5, 0.1).1, None);
    assert_eq!(float_depth(1.0, 1.0, 0.5, 0.0).1, None);
}

#[test]
fn what_is_refused() {
    let scheme = parse_scheme("chaikin").unwrap();
    let refusal = |options: CertifyOptions| certify(&scheme, &options).unwrap_err();
    let default = CertifyOptions::default;
    let zero = Rational::zero();
    assert!(matches!(
        refusal(CertifyOptions { tolerances: vec![zero.clone()], ..default() }),
        CertifyError::NotPositive { what: "a tolerance", .. }
    ));
    assert!(matches!(
        refusal(CertifyOptions { spread: zero, ..default() }),
        CertifyError::NotPositive { what: "the spread", .. }
    ));
    let level = MAX_CERTIFIED_LEVEL + 1;
    let refused = refusal(CertifyOptions { levels: vec![level], ..default() });
    assert_eq!(refused, CertifyError::Level(level));
    let refused = refusal(CertifyOptions { max_block: 25, ..default() });
    assert!(matches!(refused, CertifyError::Classes(_)));
}

/// Beyond the cap of the tracked walk there is an exact value, but no bound.
#[test]
fn a_cap_on_what_is_tracked() {
    let options = CertifyOptions { max_block: 5, ..CertifyOptions::default() };
    let found = certify(&parse_scheme("quinary-three-point").unwrap(), &options).unwrap();
    assert_eq!(found.tracked_block, 4);
    let quantity = found.quantity("T_5").unwrap();
    assert_eq!((quantity.bound, quantity.encloses()), (None, None));
    assert!(nearest(quantity.error.as_ref().unwrap()) < 1e-15);
    assert!(found.quantity("T_4").unwrap().bound.is_some());
}

/// σ = 1/2 − w and T_1 = 1 − 2w of the corner cutting [1−w, w], [w, 1−w] give depths of
/// about ln(4w·ε)/(−2w).
#[test]
fn deep_levels() {
    let rules: &[&[&str]] = &[&["9999/10000", "1/10000"], &["1/10000", "9999/10000"]];
    let tolerances = vec![Rational::new(1, 64), Rational::power_of_ten(-40)];
    let options = CertifyOptions { max_block: 1, tolerances, ..CertifyOptions::default() };
    let found = certify(&curve(rules), &options).unwrap();
    let deep = &found.depths[0];
    let level = *deep.exact.as_ref().unwrap();
    assert!((50_000..65_000).contains(&level), "{level}");
    assert_eq!((deep.float, deep.agree, &deep.margin), (Some(level), Some(true), &None));
    // Beyond the caps nothing is decided, and nothing said.
    let beyond = &found.depths[1];
    assert_eq!(beyond.exact, Err(DepthError::TooDeep));
    assert_eq!((beyond.agree, beyond.float, &beyond.margin), (None, None, &None));
}
