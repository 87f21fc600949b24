//! Relations between real numbers of any kind: verdicts, on which the checker agrees, and naive twins.

use super::relations::{SCHEMES, verdict};
use crate::common::claims::{HEAD, judged, paper};
use num_traits::ToPrimitive as _;
use proptest::prelude::*;
use subcert::audit::Word;
use subcert::exact::{Enclosed as _, Rational};
use subcert::formula::{Parameters, RealValue, evaluate, parse};
use subcert::scheme::{Mask, parse_scheme};
use subcert::smoothness::{Symbol, is_independent, sobolev_exponent};

const MORE: &str = "[[scheme]]\nname = 'hat'\nsymbol = 'z^-1*(1+z)^2/2'\n\
    [[scheme]]\nname = 'third'\nsymbol = '1 + z^3'\n\
    [[scheme]]\nname = 'kept'\nsymbol = '(1+z)^2*(-1+4*z+10*z^2+4*z^3-z^4)/32'\n\
    [[scheme]]\nname = 'high'\nfilter = true\nsymbol = '(1-z)^2/4'\n\
    [[scheme]]\nname = 'both'\nfilter = true\nsymbol = '1 + z/2 + z^2'\n\
    [[scheme]]\nname = 'smoothed'\nsymbol = 'symbol(fp-mask)*(1 + z)/2'\n\
    [[scheme]]\nname = 'with-w'\nsymbol = 'symbol(four-point, w = 1/16)*z'\n";

/// The schemes of these tests; `fp-mask` stands first, as others use its symbol.
fn schemes() -> String {
    let fp = "[[scheme]]\nname = 'fp-mask'\nmask = '[-1, 0, 9, 16, 9, 0, -1]/16'\n";
    format!("{fp}{SCHEMES}{MORE}")
}

#[test]
fn what_holds_holds_and_its_contrary_fails() {
    for (text, contrary) in [
        // Numbers.
        ("sqrt(2)*sqrt(3) = sqrt(6)", "sqrt(2)*sqrt(3) > sqrt(6)"),
        ("sqrt(5 + 2*sqrt(6)) = √2 + √3", "sqrt(5 + 2*sqrt(6)) != √2 + √3"),
        ("root([-1, 4, 0, 32], 1) ~ 0.19273", "root([-1, 4, 0, 32], 1) >= 1/5"),
        ("sqrt(1 + sqrt(2)) in {1, sqrt(1 + sqrt(2))}", "sqrt(1 + sqrt(2)) in {1, 2}"),
        ("floor(100*sqrt(1 + sqrt(2))) = 155", "ceil(100*sqrt(1 + sqrt(2))) = 155"),
        ("1/(sqrt(1 + sqrt(2)) - 1) > 1", "abs(1 - sqrt(1 + sqrt(2))) > 1"),
        ("max(sqrt(1 + sqrt(2)), 3/2) > 3/2", "min(sqrt(1 + sqrt(2)), 3/2) != 3/2"),
        // Exponents.
        ("hoelder(four-point) = 2", "hoelder(four-point) < 2"),
        ("hoelder(four-point, w = 1/16) = 2", "hoelder(four-point, w = 0.0625) < 2"),
        ("hoelder(b-spline, degree = 4) = 4", "hoelder(b-spline, degree = 4) = 3"),
        ("smoothness(fp) = 1", "smoothness(fp) = 2"),
        ("coefficient(with-w, 4) = -1/16", "coefficient(with-w, 4) = 0"),
        ("smoothness(smoothed) = 2", "smoothness(smoothed) = 1"),
        ("hoelder(fp) < hoelder(smoothed)", "hoelder(fp) >= hoelder(smoothed)"),
        ("sobolev(haar) = 1/2", "sobolev(haar) = 1"),
        ("sobolev(cubic) = 7/2", "sobolev(cubic) ~ 3.4"),
        ("sobolev(fp) ~ 2.4408", "sobolev(fp) ~ 2.4400"),
        ("sobolev(d4) = 1", "sobolev(d4) != 1"),
        // Integrals, bounds and greatest values.
        ("limit_value(cubic, 2, derivative = 2) = -2", "limit_value(cubic, 2, derivative = 1) = 1"),
        ("limit_value(fp, 1, derivative = 1) = -2/3", "limit_value(fp, 1, derivative = 1) = 2/3"),
        ("integral(cubic, 0, 2) = 1/2", "integral(cubic, 0, 1) = 1/2"),
        ("integral(fp, -3, 3) = 1", "integral(fp, 0, 1/2) > 1/2"),
        ("riesz_lower(hat) = 1/3", "riesz_lower(hat) = 1/2"),
        ("riesz_upper(cubic) = 1", "riesz_upper(cubic) < 1"),
        ("riesz_lower(haar) = 1", "riesz_upper(haar) > 1"),
        ("inner_product(haar, 0) = 1", "inner_product(haar, 1) = 1"),
        ("overshoot(fp) ~ 1.1256", "overshoot(fp) <= 9/8"),
        ("overshoot(cubic) = 1", "overshoot(cubic) > 1"),
        ("gibbs(fp) > 1", "gibbs(fp) <= 1"),
        ("independent(fp)", "not independent(fp)"),
        ("not independent(third)", "independent(third)"),
        ("same(cubic, with = b-spline-3)", "same(cubic, with = fp)"),
        ("eigenvalue(fp, 1) = 1", "eigenvalue(fp, 2) = 1"),
        // Zeros and absolute values of symbols.
        ("modulus(fp, 1/2) = 0", "modulus(fp, 0) = 1"),
        ("modulus(chaikin, 1/4) = sqrt(2)/2", "modulus(chaikin, 3/4) > sqrt(2)/2"),
        ("modulus(chaikin, 1/6) ~ 1.299", "modulus(chaikin, 1/6) = 13/10"),
        ("modulus_upper(d4) = 2", "modulus_upper(d4) < 2"),
        ("modulus_lower(high) = 0", "modulus_lower(third) != 0"),
        ("modulus_upper(high) = 1", "modulus_upper(fp) = 3"),
        ("modulus_lower(both) = 0", "modulus_upper(both) = 2"),
        ("hurwitz(cubic)", "hurwitz(fp)"),
        ("not hurwitz(third)", "hurwitz(high)"),
        ("vanishing_moments(high) = 2", "vanishing_moments(cubic) > 0"),
        ("biorthogonal(high, with = fp) = 0", "orthogonal(high)"),
        ("keeps_ratios(cubic, 2, 5)", "keeps_ratios(fp, 2, 3/2)"),
        ("keeps_ratios(kept, 2, 2)", "keeps_ratios(kept, 2, 2001/1000)"),
        ("keeps_ratios(kept, 2, sqrt(3))", "keeps_ratios(kept, 2, sqrt(5))"),
        ("eigenvalue(fp, 5) = 1/8", "eigenvalue(fp, 4) = 1/2"),
        // Around a vertex or on a face.
        ("subdominant(loop, 5) = 3/8 + cos(2*pi/5)/4", "subdominant(loop, 5) > 1/2"),
        ("subdominant(catmull-clark, 4) = 1/2", "subdominant(catmull-clark, 5) = 1/2"),
        ("eigenvalue(doo-sabin, 4, 2, 1) = 1/4", "eigenvalue(doo-sabin, 4, 1, 1) = 1/4"),
        ("curvature(loop, 6) = 1", "curvature(loop, 7) <= 1"),
        ("curvature(loop, 7, part = elliptic) = 1", "curvature(loop, 7, part = hyperbolic) <= 1"),
        (
            "tangent_weight(loop, 5, 1, orbit = edge) = cos(2*pi/5)",
            "tangent_weight(loop, 5, 1) = 1",
        ),
        (
            "tangent_weight(loop, 4, 1, orbit = edge, tangent = second) = 1",
            "tangent_weight(loop, 4, 2, orbit = edge, tangent = second) > 0",
        ),
        (
            "tangent_weight(catmull-clark, 4, 0, orbit = face) = 1/4",
            "tangent_weight(catmull-clark, 4, 1, orbit = face) > 0",
        ),
        ("limit_weight(catmull-clark, 4) = 4/9", "limit_weight(catmull-clark, 4) = 16/37"),
        (
            "limit_weight(catmull-clark, 3, orbit = face) = 1/24",
            "limit_weight(catmull-clark, 3, orbit = edge) = 1/24",
        ),
    ] {
        let spline = "[[scheme]]\nname = 'b-spline-3'\nsymbol = '(1+z)^4/8'\n";
        for (text, word) in [(text, Word::Holds), (contrary, Word::Fails)] {
            let found = verdict(&format!("{}{spline}", schemes()), &format!("states = '{text}'\n"));
            assert_eq!(found, word, "{text}");
        }
    }
}

/// λ of Catmull–Clark's rules, in closed form, at all valences that are asked for.
#[test]
fn closed_forms_hold_at_each_valence() {
    let fields = "states = 'subdominant(catmull-clark, n) = (5 + cos(2*pi/n) + sqrt((9 + cos(2*pi/n))*(1 + cos(2*pi/n))))/16'\n\
        for = 'n = 3..12'\n";
    assert_eq!(verdict("", fields), Word::Holds);
    let fields =
        "scheme = 'loop'\nstates = 'limit_weight(n) = 1/(1 + 8*n/3*b)'\nfor = 'n = 3..9'\n";
    let definition = "[define]\nb = '(5/8 - (3/8 + cos(2*pi/n)/4)^2)/n'\n";
    assert_eq!(verdict(definition, fields), Word::Holds);
}

#[test]
fn what_bounds_do_not_decide_is_open() {
    // Exponents of one value that is no rational number, by bounds.
    let paper = paper(
        "[[relation]]\nid = 'r'\nlocus = 'l'\nstates = 'sobolev(four-point) <= sobolev(four-point)'\n",
    );
    let audit = judged(&paper);
    assert_eq!(audit.equations[0].verdict.word(), Word::Open);
}

#[test]
fn nothing_is_compared_that_has_no_value() {
    for (fields, part) in [
        ("states = 'sqrt(-1) = 1'", "square root of the negative number"),
        ("states = 'subdominant(chaikin, 5) = 1'", "about rules around a vertex"),
        ("states = 'hoelder(loop) = 1'", "about a mask"),
        ("states = 'subdominant(loop, 2) = 1'", "from 3 to 100"),
        ("states = 'eigenvalue(loop, 5, 0, 0) = 1'", "from 1 to"),
        ("states = 'eigenvalue(loop, 5, 0, 9) = 1'", "no number 9"),
        ("states = 'limit_weight(loop, 5, orbit = face) = 1'", "its orbits are vertex, edge"),
        ("states = 'hoelder(chaikin, 2) = 1'", "no arguments but a scheme"),
        ("states = 'limit_value(chaikin, 1, derivative = -1) = 1'", "from 0 to 16"),
        ("states = 'same(chaikin) = 1'", "name the other scheme"),
        ("states = 'eigenvalue(haar, 1) = 1'", "no integer inside"),
        ("states = 'hoelder(four-point, v = 1) = 1'", "v"),
        ("symbols = ['w']\nstates = 'sqrt(w) = 1'", "w"),
        ("states = 'hoelder(four-point, w = 1-1) > 0'", "is a number or a name"),
        ("states = 'coefficient(daubechies-6, 1/2) = 1'", "integer"),
        ("states = 'eigenvalue(daubechies-6, 1) = 1'", "other roots"),
    ] {
        let text = format!("{HEAD}[[relation]]\nid = 'r'\nlocus = 'l'\n{fields}\n");
        let source = subcert::diagnostic::SourceText::new("a.toml", text);
        let paper = subcert::claim::read_paper(&source).expect("a claim file");
        let error = subcert::audit::audit(&paper).expect_err(fields).to_string();
        assert!(error.contains(part), "{fields}: {error}");
    }
}

/// A formula of square roots, and its value in floating point.
fn formula() -> impl Strategy<Value = (String, f64)> {
    let number = (1_u32..9).prop_map(|n| (n.to_string(), f64::from(n)));
    number.prop_recursive(3, 12, 2, |inner| {
        (inner.clone(), inner, 0..4).prop_map(|((a, x), (b, y), operation)| match operation {
            0 => (format!("({a} + {b})"), x + y),
            1 => (format!("({a}*{b})"), x * y),
            2 => (format!("sqrt({a} + {b})"), (x + y).sqrt()),
            _ => (format!("({a}/({b} + 1))"), x / (y + 1.0)),
        })
    })
}

proptest! {
    #[test]
    fn real_numbers_are_what_floating_point_says((text, value) in formula()) {
        let exact = evaluate(&parse(&text).unwrap(), &Parameters::<RealValue>::default()).unwrap();
        let enclosure = exact.interval();
        let near = |bound: &Rational| (bound.to_f64().unwrap() - value).abs() <= 1e-9 * value.abs().max(1.0);
        prop_assert!(near(enclosure.lower()) && near(enclosure.upper()), "{text}: {exact} and {value}");
    }

    /// ρ by the power method, from |b̂|² on a grid: the mean of Π_j |b̂(2^j ξ)|² grows like (ρ/2)^j for arity 2.
    #[test]
    fn sobolev_exponents_are_those_of_powers_of_the_transfer_operator(
        inner in proptest::collection::vec(-3_i64..4, 1..4), order in 1_usize..4,
    ) {
        let sum: i64 = inner.iter().sum();
        prop_assume!(sum != 0);
        let factors = vec!["(1 + z)"; order].join("*");
        let terms: Vec<String> = inner.iter().enumerate().map(|(k, c)| format!("({c})*z^{k}")).collect();
        let text = format!("2*{factors}*({})/(2^{order}*({sum}))", terms.join(" + "));
        let scheme = parse_scheme(&text).unwrap();
        let symbol = Symbol::of(scheme.masks()[0]);
        prop_assume!(is_independent(&symbol));
        let exponent = sobolev_exponent(&symbol).expect("short masks");
        let found = exponent.enclosure(1).lower().to_f64().unwrap();
        prop_assert!((found - by_powers(scheme.masks()[0])).abs() < 0.02, "{text}: {found}");
    }
}

/// K − log₂(ρ)/2 by 60 steps of the power method on coefficients, in floating point; the reduced symbol is not needed, as ρ of the whole one is
/// taken where shifts are independent, and otherwise the smaller of the growth from f = 1.
fn by_powers(mask: &Mask) -> f64 {
    let symbol = Symbol::of(mask);
    let (order, rest) = symbol.sum_rules();
    let b: Vec<f64> = rest.coefficients().iter().map(|c| c.to_f64().unwrap()).collect();
    let scale = 4.0_f64.powi(i32::try_from(order).unwrap() - 1);
    let c = |k: i64| -> f64 {
        let k = usize::try_from(k.abs()).unwrap();
        b.iter().skip(k).zip(&b).map(|(x, y)| x * y).sum::<f64>() * scale
    };
    let reach = i64::try_from(b.len()).unwrap();
    let places: Vec<i64> = (-reach..=reach).collect();
    let mut f: Vec<f64> = places.iter().map(|k| f64::from(u8::from(*k == 0))).collect();
    let (mut total, mut counted) = (0.0_f64, 0.0);
    for step in 0..400 {
        let next: Vec<f64> = places
            .iter()
            .map(|k| 2.0 * places.iter().zip(&f).map(|(j, x)| c(2 * k - j) * x).sum::<f64>())
            .collect();
        // f stays a non-negative cosine polynomial, whose mean is its coefficient at 0.
        let mean = next[usize::try_from(reach).unwrap()];
        let before = f[usize::try_from(reach).unwrap()];
        if step >= 200 {
            total += (mean / before).ln();
            counted += 1.0;
        }
        f = next.iter().map(|x| x / mean).collect();
    }
    let rho = (total / counted).exp();
    f64::from(u32::try_from(order).unwrap()) - rho.log2() / 2.0
}

/// The checker may leave these incomplete.
#[test]
fn masks_over_other_fields() {
    for (text, contrary) in [
        ("sum_rules(daubechies-6) = 3", "orthogonal(daubechies-6) = 0"),
        ("hoelder(daubechies-6) ~ 1.0878", "hoelder(daubechies-4) > 0.5501"),
        ("biorthogonal(wavelet-9-7, with = wavelet-9-7-synthesis)", "symmetric(daubechies-8)"),
        ("limit_value(daubechies-6, 1) ~ 1.2863", "limit_value(daubechies-6, 2) > 0"),
        ("sobolev(daubechies-6) ~ 1.4150", "smoothness(daubechies-6) = 0"),
    ] {
        for (text, word) in [(text, Word::Holds), (contrary, Word::Fails)] {
            let paper = paper(&format!("[[relation]]\nid = 'r'\nlocus = 'l'\nstates = '{text}'\n"));
            let audit = judged(&paper);
            assert_eq!(audit.equations[0].verdict.word(), word, "{text}");
            let certificate = subcert::certificate::certificate(&audit).text;
            let report =
                subcert_check::check(&paper.source.text, &[&certificate]).expect("a claim file");
            let (_, _, outcome) = &report.claims[0];
            assert!(!matches!(outcome, subcert_check::Outcome::Invalid(..)), "{text}: {outcome:?}");
        }
    }
    // No value is computed in a field of degree 17.
    let root = format!("root([-1, -1, {}1], 1)", "0, ".repeat(15));
    let mask = format!("mask = [['v', '1-v'], ['v/3', '1-v/3']]\nlet = {{ v = '{root}/64' }}");
    let claim = "[[relation]]\nid = 'r'\nlocus = 'l'\nstates = 'coefficient(s, 0) != 0'\n";
    let of_degree = paper(&format!("[[scheme]]\nname = 's'\n{mask}\n{claim}"));
    assert_eq!(judged(&of_degree).equations[0].verdict.word(), Word::NotCheckable);
    // The field of all cosines of √57 is too large, and that of √57 is not.
    let mask = "symbol = '(1+z)^2*(r + (1-2*r)*z + r*z^2)/2'\nlet = { r = '(3 - sqrt(57))/64' }";
    let claim = "[[relation]]\nid = 'r'\nlocus = 'l'\nstates = 'smoothness(s) = 0'\n";
    let of_root = paper(&format!("[[scheme]]\nname = 's'\n{mask}\n{claim}"));
    assert_eq!(judged(&of_root).equations[0].verdict.word(), Word::Holds);
    // The scheme of a claim, and masks of its own.
    for (scheme, states) in
        [("daubechies-6", "hoelder() ~ 1.0878"), ("own", "limit_value(1) + limit_value(2) = 1")]
    {
        let own = "[[scheme]]\nname = 'own'\nsymbol = '(1+z)*(r + (1-r)*z)*(1+z)/2'\nlet = { r = 'sqrt(1 + sqrt(2))/2' }\n";
        let claim = format!(
            "[[relation]]\nid = 'r'\nlocus = 'l'\nscheme = '{scheme}'\nstates = '{states}'\n"
        );
        let paper = paper(&format!("{own}{claim}"));
        assert_eq!(judged(&paper).equations[0].verdict.word(), Word::Holds, "{states}");
    }
}
