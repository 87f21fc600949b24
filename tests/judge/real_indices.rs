//! Relations for all real values of an index, and masks over fields of cosines.

use super::relations::verdict;
use crate::common::claims::{HEAD, judged, paper};
use proptest::prelude::*;
use subcert::audit::{EquationVerdict, Word};
use subcert::certificate::certificate;
use subcert::exact::Rational;
use subcert_check::{Outcome, check};

/// A family with a tension, and one whose mask gets shorter at 0 and at √2.
const SCHEMES: &str = "[[scheme]]\nname = 'fp'\nparameters.w = { about = 'tension' }\n\
    symbol = '(1+z)^2/(2*z)*(1 - 2*w*(1-z)^2*(1+z^2)/z^2)'\n\
    [[scheme]]\nname = 'short'\nparameters.w = { about = 'weight' }\nsymbol = '(1+z)*(1 + (w^2-2)*(1-z) + w*z*(1-z))'\n\
    [[scheme]]\nname = 'kept'\nsymbol = '(1+z)^2*(-1+4*z+10*z^2+4*z^3-z^4)/32'\n\
    [[scheme]]\nname = 'high'\nparameters.w = { about = 'weight' }\nfilter = true\nsymbol = '(1-z)*(1-w*z)'\n\
    [[scheme]]\nname = 'dual'\nparameters.w = { about = 'weight' }\nsymbol = '(1+z)^2*(w + (1-2*w)*z + w*z^2)/2'\n";

#[test]
fn what_holds_holds_and_its_contrary_fails() {
    for (index, text, contrary) in [
        ("real v", "(1 + v)/2 <= 1/2 + abs(v)/2", "1/2 < (1 + v)/2"),
        ("real v", "v*(1 - v) <= 1/4", "v*(1 - v) < 1/4"),
        ("real v", "v^2 - 2*v + 1 >= 0", "v^2 - 2*v + 1 > 0"),
        ("v != 1", "v^2 - 2*v + 1 > 0", "v^2 - 2*v + 1 = 0"),
        ("0 <= v <= sqrt(2)/8", "32*v^2 <= 1", "32*v^2 < 1"),
        ("-sqrt(2) < v < sqrt(2)", "abs(v) < 3/2 - (v^2 - 2)^2/100", "abs(v) < 7/5"),
        ("real v", "max(v, 2*v) >= v", "max(v, 2*v) > v"),
        ("real v", "sum_rules(fp, w = v) >= 2", "sum_rules(fp, w = v) = 2"),
        ("v != 1/16", "sum_rules(fp, w = v) = 2", "sum_rules(fp, w = v) != 2"),
        ("v < 1/16", "reproduction(fp, w = v) = 1", "reproduction(fp, w = v) = 3"),
        ("real v", "interpolating(fp, w = v)", "not interpolating(fp, w = v)"),
        ("real v", "symmetric(fp, w = v)", "not symmetric(fp, w = v)"),
        ("v != 0", "support(fp, w = v) = 6", "support(fp, w = v) in {2, 4}"),
        ("real v", "support(fp, w = v) in {2, 6}", "support(fp, w = v) = 6"),
        ("v > 1", "support(short, w = v) = support_end(short, w = v)", "support(short, w = v) = 2"),
        ("real v", "moment(fp, 1, w = v) = 0", "moment(fp, 2, w = v) = 0"),
        ("real v", "coefficient(fp, 3, w = v) = -v", "coefficient(fp, 3, w = v) = v"),
        ("-1/4 < v < 1/4", "contraction(fp, w = v) < 1", "contraction(fp, w = v) < 3/4"),
        (
            "real v",
            "contraction(fp, 2, w = v) <= contraction(fp, w = v)^2",
            "contraction(fp, 2, w = v) > contraction(fp, w = v)",
        ),
        ("-1/8 < v < 1/8", "tensor(fp, w = v) < 9/8", "tensor(fp, w = v) > 1"),
        ("1 <= v <= 2", "keeps_ratios(kept, 2, v)", "not keeps_ratios(kept, 2, v)"),
        ("v > 2", "not keeps_ratios(kept, 2, v)", "keeps_ratios(kept, 2, v)"),
        ("1/6 <= v <= 3/10", "keeps_ratios(dual, 2, 3, w = v)", "keeps_ratios(dual, 2, 2, w = v)"),
        ("0 < v < 1/2", "hurwitz(dual, w = v)", "not hurwitz(dual, w = v)"),
        ("v < 0", "not hurwitz(dual, w = v)", "hurwitz(dual, w = v)"),
        ("real v", "vanishing_moments(high, w = v) >= 1", "vanishing_moments(high, w = v) = 1"),
        ("real v", "orthogonal(haar)", "same(fp, w = v, with = haar)"),
    ] {
        for (text, word) in [(text, Word::Holds), (contrary, Word::Fails)] {
            let found = verdict(SCHEMES, &format!("states = '{text}'\nfor = '{index}'\n"));
            assert_eq!(found, word, "{text} for {index}");
        }
    }
}

/// Families whose smoothness is known by sum rules from above, and by contraction from below.
const SMOOTH: &str = "[[scheme]]\nname = 'cut'\nparameters.w = {}\nmask = '[w, 1-w, 1-w, w]'\n\
    [[scheme]]\nname = 'three'\nparameters.w = {}\n\
    symbol = '(1+z+z^2)/3*(w + (1-w)*z + z^2 + (1-w)*z^3 + w*z^4)'\n\
    [[scheme]]\nname = 'twice'\nparameters.w = {}\nsymbol = '(1+z)*(1+z^2)*(w + (1-w)*z)/2'\n\
    [[scheme]]\nname = 'root'\nparameters.w = {}\n\
    symbol = '(1+z)/2*(1 + (w^2-2)*(1-z)^2 + z*(1 - (w^2-2)*(1-z)))'\n";

#[test]
fn bounds_of_smoothness_decide_on_intervals() {
    for (index, text, contrary) in [
        ("real v", "smoothness(fp, w = v) < 2", "smoothness(fp, w = v) >= 1"),
        ("0 < v < 1/8", "smoothness(fp, w = v) >= 1", "smoothness(fp, w = v) != 1"),
        ("0 < v < 1/8", "1 = smoothness(fp, w = v)", "2 <= smoothness(fp, w = v)"),
        ("-1/4 < v < 1/4", "hoelder(fp, w = v) <= 2", "hoelder(fp, w = v) < 2"),
        (
            "-1/4 < v < 1/4",
            "hoelder(fp, w = v) <= hoelder(four-point, w = 1/16)",
            "hoelder(fp, w = v) < hoelder(four-point, w = 1/16)",
        ),
        ("0 < v < 1/2", "smoothness(cut, w = v) >= 0", "smoothness(cut, w = v) = 0"),
        ("1/3 < v < 1/2", "smoothness(cut, w = v) = 0", "smoothness(cut, w = v) > 0"),
        ("1/4 < v < 1/2", "smoothness(three, w = v) <= 1", "smoothness(three, w = v) <= 0"),
        ("0 < v < 1", "independent(fp, w = v)", "not independent(fp, w = v)"),
        // At √2 there is one sum rule more, and only there.
        ("1 < v < 7/5", "smoothness(root, w = v) <= 0", "smoothness(root, w = v) >= 1"),
    ] {
        let schemes = format!("{SCHEMES}{SMOOTH}");
        for (text, word) in [(text, Word::Holds), (contrary, Word::Fails)] {
            let found = verdict(&schemes, &format!("states = '{text}'\nfor = '{index}'\n"));
            assert_eq!(found, word, "{text} for {index}");
        }
    }
}

#[test]
fn what_bounds_of_smoothness_leave_is_open() {
    let schemes = format!("{SCHEMES}{SMOOTH}");
    for (index, text) in [
        // Of a scheme that is not shown to converge there is no exponent.
        ("real v", "hoelder(fp, w = v) <= 2"),
        // The shifts are dependent for all v.
        ("real v", "smoothness(twice, w = v) < 5"),
    ] {
        let found = verdict(&schemes, &format!("states = '{text}'\nfor = '{index}'\n"));
        assert!(matches!(found, Word::Open | Word::NotCheckable), "{text} for {index}: {found}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// What is proved of the smoothness for all values of a parameter is so for single ones.
    #[test]
    fn smoothness_on_intervals_is_that_of_single_values(
        (p, q, r) in (-4_i64..5, -4_i64..5, -2_i64..3),
        (m, order) in (0_i64..3, 1_i64..3),
        sign in prop_oneof![Just("<"), Just("<="), Just(">=")],
        at in proptest::collection::vec((1_i64..8, 1_i64..17), 3),
    ) {
        let family = format!(
            "[[scheme]]\nname = 'drawn'\nparameters.w = {{}}\n\
             symbol = '(1+z)^{order}/2^{}*({p}*w/8 + {q}*w*z/8 + {r}*z^2/8 + (1 - ({p}*w + {q}*w + {r})/8)*z^3)'\n",
            order - 1
        );
        let text = format!("smoothness(drawn, w = v) {sign} {m}");
        let verdict = |of: String| {
            let paper = paper(&format!("{family}[[relation]]\nid = 'r'\nlocus = 'l'\nstates = '{text}'\n{of}"));
            let audit = judged(&paper);
            let report = check(&paper.source.text, &[&certificate(&audit).text]).expect("a claim file");
            // The rational bounds of a certificate may show less than the program knows.
            assert!(!matches!(report.claims[0].2, Outcome::Invalid(..)), "{family}{text}");
            audit.equations[0].verdict.word()
        };
        let whole = verdict("for = '0 < v < 8'\n".to_owned());
        for value in at.into_iter().map(|(p, q)| Rational::new(p, q)).filter(|_| whole == Word::Holds) {
            let single = verdict(format!("for = 'v = {value}'\n"));
            prop_assert!(single != Word::Fails, "{} at {}: {}", text, value, family);
        }
    }
}

/// What the checker may leave incomplete, since it divides by numbers only.
#[test]
fn limits_and_quotients() {
    for (index, text, word) in [
        ("v > 0", "0 < 1/(1 + v) < 1", Word::Holds),
        ("v > 0", "0 < 1/(1 + v) < 1/2", Word::Fails),
        ("-1/4 < v < 1/4", "limit_value(fp, 1/2, w = v) = 1/2 + v", Word::Holds),
        ("-1/4 < v < 1/4", "limit_value(fp, 1/2, w = v) = 1/2", Word::Fails),
        // Dyn, Levin, Gregory 1987: the weight of x_{i+1} in the derivative.
        (
            "0 < v < 1/8",
            "limit_value(fp, -1, derivative = 1, w = v) = 1/(2*(1 - 4*v))",
            Word::Holds,
        ),
        ("0 < v < 1/2", "positive(corner-cutting, w = v)", Word::Holds),
        ("1/8 <= v <= 3/8", "convex(dual, w = v)", Word::Holds),
        ("1/100 < v < 1/8", "not positive(fp, w = v)", Word::Holds),
        ("real v", "sum_rules(fp, w = v) = 2 + 2*kronecker(v, 1/16)", Word::Holds),
        ("-1/8 < v < 1/8", "integral(fp, -3, 3, w = v) = 1", Word::Holds),
        ("-1/8 < v < 1/8", "inner_product(fp, 0, w = v) > 0", Word::Holds),
    ] {
        let fields = format!("states = '{text}'\nfor = '{index}'\n");
        let paper = paper(&format!("{SCHEMES}[[relation]]\nid = 'r'\nlocus = 'l'\n{fields}"));
        assert_eq!(judged(&paper).equations[0].verdict.word(), word, "{text} for {index}");
    }
}

#[test]
fn no_other_number_is_one_of_them() {
    for (index, text, word) in [
        ("v = 1/16", "reproduction(fp, w = v) = 3", Word::Holds),
        ("v = 1/15", "reproduction(fp, w = v) = 3", Word::Fails),
        ("v = 1/16, 1/15", "sum_rules(fp, w = v) > 2", Word::Fails),
        ("-1/4 < v < 1/4", "contraction(fp, w = v) < 1", Word::Holds),
        ("-1/4 <= v < 1/4", "contraction(fp, w = v) < 1", Word::Fails),
        ("-1/4 < v < 1/5", "contraction(fp, w = v) < 1", Word::Fails),
        ("-sqrt(2) <= v <= sqrt(2)", "v^2 <= 2", Word::Holds),
        ("v != 0", "support(fp, w = v) = 6", Word::Holds),
        ("real v", "support(fp, w = v) = 6", Word::Fails),
    ] {
        let found = verdict(SCHEMES, &format!("states = '{text}'\nfor = '{index}'\nonly = true\n"));
        assert_eq!(found, word, "{text} for {index}");
    }
}

#[test]
fn what_makes_no_sense_is_refused() {
    for (fields, part) in [
        ("states = 'v > 0'\nfor = '1 < v > 0'", "one direction"),
        ("states = 'v > 0'\nfor = '1 < v < 0'", "no number is between"),
        ("states = 'v > 0'\nfor = '1 < v < 1'", "no number is between"),
        ("states = 'v > 0'\nfor = ['real v', 'real w']", "two indices of real numbers"),
        ("states = 'v > n'\nfor = ['real v', 'all n']", "no index that is `all`"),
        ("states = 'v > n'\nsymbols = ['n']\nfor = 'real v'", "no symbols"),
        ("states = 'v ~ 0.1'\nfor = 'real v'", "one value"),
        ("states = 'v > 0'\nfor = 'v = 1..3'\nonly = true", "real or listed values"),
        ("states = 'v > 0'\nonly = true", "real or listed values"),
        ("states = 'v > n'\nfor = ['real v', 'n = 1, 2']\nonly = true", "real or listed values"),
        ("states = 'v > 0'\nfor = 'v > n'", "n"),
        ("states = 'v/v = 1'\nfor = 'real v'", "for v = 0"),
        ("states = 'v'\nfor = 'real v'", "states nothing by itself"),
        ("states = 'sqrt(v) > 1'\nfor = 'v > 1'", "v"),
        ("states = 'sobolev(fp, w = v) > 1'\nfor = 'v > 1'", "v"),
        ("states = 'smoothness(fp, w = v) + 1 >= 2'\nfor = '0 < v < 1/8'", "symbols in it"),
        ("states = '-smoothness(fp, w = v) <= 1'\nfor = '0 < v < 1/8'", "symbols in it"),
        ("states = 'smoothness(fp, w = v) in {1, 2}'\nfor = '0 < v < 1/8'", "symbols in it"),
    ] {
        let text = format!("{HEAD}{SCHEMES}[[relation]]\nid = 'r'\nlocus = 'l'\n{fields}\n");
        let source = subcert::diagnostic::SourceText::new("a.toml", text);
        let error = match subcert::claim::read_paper(&source) {
            Ok(paper) => subcert::audit::audit(&paper).expect_err(fields).to_string(),
            Err(error) => error.to_string(),
        };
        assert!(error.contains(part), "{fields}: {error}");
    }
}

/// Masks over fields of cosines of a degree above 2, where the basis of a field is not that of powers.
#[test]
fn masks_over_fields_of_cosines() {
    let seven = "[[scheme]]\nname = 's'\nsymbol = '(1+z)*(1+r*z)/(1+r)'\nlet.r = 'sqrt(7)'\n\
        [[scheme]]\nname = 'd'\nsymbol = '(1+z+z^2+z^3+z^4+z^5)*(z^12 - r*z^6 + 1)/(z^2 - r*z + 1)'\nlet.r = '2*cos(2*pi/7)'\n";
    for (text, word) in [
        // ρ = 2·8/(1 + √7)²
        ("sobolev(s) ~ 0.866216", Word::Holds),
        ("sobolev(s) < 0", Word::Fails),
        ("not independent(d)", Word::Holds),
        // Daubechies 1988: φ(1) = (1 + √3)/2, φ(2) = (1 − √3)/2, and the translates are orthonormal.
        ("limit_value(daubechies-4, 1) = (1 + sqrt(3))/2", Word::Holds),
        ("limit_value(daubechies-4, 2) = (1 + sqrt(3))/2", Word::Fails),
        ("limit_value(daubechies-4, 1/2) = (2 + sqrt(3))/4", Word::Holds),
        ("inner_product(daubechies-4, 0) = 1", Word::Holds),
        ("inner_product(daubechies-4, 1) = 0", Word::Holds),
        ("inner_product(daubechies-4, 1) > 0", Word::Fails),
        ("integral(daubechies-4, 0, 3) = 1", Word::Holds),
    ] {
        assert_eq!(verdict(seven, &format!("states = '{text}'\n")), word, "{text}");
    }
}

/// A relation, with v for the parameter of a family.
fn statement() -> impl Strategy<Value = String> {
    let value = prop_oneof![
        Just("v".to_owned()),
        (-3_i64..4, -3_i64..4, 1_i64..4).prop_map(|(a, b, c)| format!("({a} + {b}*v + {c}*v^2)/4")),
        Just("sum_rules(dual, w = v)".to_owned()),
        Just("reproduction(fp, w = v)".to_owned()),
        Just("support(short, w = v)".to_owned()),
        Just("contraction(dual, w = v)".to_owned()),
        Just("abs(v - 1/8)".to_owned()),
        Just("moment(dual, 2, w = v)".to_owned()),
    ];
    let signs = prop_oneof![Just("<"), Just("<="), Just("="), Just("!="), Just(">"), Just(">=")];
    (value.clone(), signs, prop_oneof![value, (0_i64..5).prop_map(|n| n.to_string())])
        .prop_map(|(left, sign, right)| format!("{left} {sign} {right}"))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// The set where a relation is true is that of single values, and the counterexample is one; the checker agrees.
    #[test]
    fn sets_are_those_of_single_values(text in statement(), at in proptest::collection::vec((-8_i64..9, 1_i64..9), 4)) {
        let fields = format!("states = '{text}'\nfor = 'real v'\n");
        let whole = verdict(SCHEMES, &fields);
        let claims = format!("{SCHEMES}[[relation]]\nid = 'r'\nlocus = 'l'\n{fields}");
        let paper = paper(&claims);
        let audit = judged(&paper);
        let EquationVerdict::Reals(found) = &audit.equations[0].verdict else { panic!("{text}") };
        let case = &found.cases[0];
        let truth = case.truth.as_ref().expect("polynomials decide everything");
        let known = at.into_iter().map(|(p, q)| Rational::new(p, q));
        let ends = truth.ends().filter_map(|(end, _)| end.as_rational().cloned());
        let witness = case.counterexample.iter().filter_map(|found| found.value.as_rational().cloned());
        for (value, shown) in known.chain(ends).map(|x| (x, false)).chain(witness.map(|x| (x, true))) {
            let single = verdict(SCHEMES, &format!("states = '{text}'\nfor = 'v = {value}'\n"));
            prop_assert_eq!(single == Word::Holds, truth.contains(&value), "{} at {}", text, value);
            prop_assert!(!(shown && single == Word::Holds), "{} at {}", text, value);
        }
        prop_assert_eq!(whole == Word::Holds, case.counterexample.is_none());
    }
}
