//! Ten schemes of the catalogue, drawn at random, against slow computations by definition.

use super::brute::Plain;
use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::facts::{CurveFacts, atlas_references};
use subcert::scheme::{Mask, Scheme, parse_scheme};
use subcert::smoothness::Hoelder;

/// All rational masks of the atlas. The longest are left out: their coefficients fill f64.
fn masks() -> Vec<(String, Mask)> {
    let references = atlas_references().into_iter().flat_map(|(_, references)| references);
    let mask = |reference: String| match parse_scheme(&reference) {
        Ok(Scheme::Curve(mask)) if mask.width() <= 9 => Some((reference, mask)),
        _ => None,
    };
    references.filter_map(mask).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1, failure_persistence: None, ..Default::default() })]
    #[test]
    fn ten_entries_are_as_by_definition(some in prop::sample::subsequence(masks(), 10)) {
        for (name, mask) in some {
            agrees(&name, &mask);
        }
    }
}

fn agrees(name: &str, mask: &Mask) {
    let (facts, plain) = (CurveFacts::of_rational(mask), Plain::of(mask));
    assert_eq!(facts.sum_rules, plain.sum_rules(), "{name}: sum rules");
    support(name, &facts, &plain);
    for c in 1..=2 {
        let at = usize::try_from(c).expect("small") - 1;
        assert_eq!(facts.columns.norm[at], plain.norm(c), "{name}: Λ_{c}");
        assert_eq!(facts.columns.contraction[at], plain.contraction(c), "{name}: T_{c}");
    }
    let smoothness = facts.smoothness.as_ref().expect("smoothness");
    let Some(hoelder) = &smoothness.hoelder else { return };
    let [low, high] = plain.radius(facts.sum_rules, if plain.n == 2 { 7 } else { 4 });
    // ϱ = n^{K − α}, in f64 up to rounding.
    let [least, most] = exponents(hoelder);
    let order = f64::from(u32::try_from(facts.sum_rules).expect("small"));
    let n = f64::from(u32::try_from(plain.n).expect("small"));
    assert!(n.powf(order - most) <= high * (1.0 + 1e-9), "{name}: {high} is below ϱ");
    if smoothness.reduced.is_none() {
        assert!(low * (1.0 - 1e-9) <= n.powf(order - least), "{name}: {low} is above ϱ");
        // The numbers are near enough to tell a wrong exponent.
        assert!(high <= 3.0 * low, "{name}: {low} to {high}");
    }
}

fn exponents(hoelder: &Hoelder) -> [f64; 2] {
    [&hoelder.lower, &hoelder.upper].map(subcert::float::nearest)
}

/// After k levels one point has reached the indices from low·(n^k − 1) to high·(n^k − 1).
fn support(name: &str, facts: &CurveFacts, plain: &Plain) {
    let (low, high) = facts.symbol.support();
    let (first, values) = plain.of_one_point(3);
    let places = (first..).zip(&values).filter(|(_, value)| !value.is_zero()).map(|(i, _)| i);
    let (least, most) = (places.clone().min(), places.max());
    let scale = Rational::from(plain.n.pow(3) - 1);
    let reached = [low, high].map(|end| end * &scale);
    let found = [least, most].map(|end| Rational::from(end.expect("a point")));
    assert_eq!(reached, found, "{name}: support");
}
