//! Functions of masks and limits, against facts that are known from elsewhere.

use std::fmt::Write as _;
use std::time::Instant;
use subcert_check::{Outcome, Reason, check};

/// Schemes with their masks. D4 has √3 = 2cos(π/6), and the ternary four-point scheme is that of Hassan and others.
const SCHEMES: &str = r#"
[[scheme]]
name = "four"
mask = '[-1, 0, 9, 16, 9, 0, -1]/16'
[[scheme]]
name = "two"
mask = '[1, 3, 3, 1]/4'
[[scheme]]
name = "cubic"
mask = '[1, 4, 6, 4, 1]/8'
[[scheme]]
name = "hat"
mask = '[1, 2, 1]/2'
[[scheme]]
name = "haar"
symbol = '1 + z'
[[scheme]]
name = "dual"
symbol = '(z^-2 + z^-1)*(1 + z)^2*(-z^-1 + 4 - z)/8*z'
[[scheme]]
name = "daubechies"
let = { root = '2*cos(pi/6)' }
symbol = '((1 + root) + (3 + root)*z + (3 - root)*z^2 + (1 - root)*z^3)/4'
[[scheme]]
name = "ternary"
symbol = 'z^-2*(1 + z + z^2)^2/3'
[[scheme]]
name = "third"
use = "ternary-four-point:mu=1/11"
[[scheme]]
name = "tension"
symbol = '-w*z^-3 + (1/2 + w)*z^-1 + 1 + (1/2 + w)*z - w*z^3'
parameters.w = {}
[[scheme]]
name = "bell"
symbol = '((1 + z)/2)^9*2'
[[scheme]]
name = "cutting"
use = "corner-cutting:w=1/3"
[[scheme]]
name = "late"
symbol = '(1 + z)^2*(2 + z - z^2 + z^3 + 2*z^4)/10'
[[scheme]]
name = "later"
symbol = '(1 + z)^2*(1 + z - z^2 + z^3 + z^4)/6'
[[scheme]]
name = "mirrored"
symbol = 'z^-9*(1 + z)^2*(3 - z - z^2 + 3*z^3)/8'
[[scheme]]
name = "rough"
symbol = '(1 + z)*(2 - z)'
[[scheme]]
name = "rougher"
symbol = '(1 + z)*(3 - z - z^2)'
[[scheme]]
name = "averaged"
symbol = '(1 + z)*(1 + z^2)/2'
[[scheme]]
name = "endless"
symbol = '(1 + z)^2*(4 - z + 4*z^2)/14'
[[scheme]]
name = "golden"
use = "corner-cutting:w=2*cos(pi/5) - 3/2"
[[scheme]]
name = "stretched"
symbol = '1 + z^3'
[[scheme]]
name = "wild"
mask = '[-1, 0, 2, 1, 0]'
[[scheme]]
name = "far"
mask = [['1', '0'], ['1/2', '1/2']]
offset = '9000'
[[scheme]]
name = "long"
arity = '64'
width = '256'
entry = '1/256'
[[scheme]]
name = "fine"
mask = [['1/3^9000', '1 - 1/3^9000'], ['1/5^9000', '1 - 1/5^9000']]
[[scheme]]
name = "round"
mask = [['cos(2*pi/499)', '1 - cos(2*pi/499)', '0'], ['cos(2*pi/499)/2', '1/2 - cos(2*pi/499)', '1/2 + cos(2*pi/499)/2']]
"#;

/// The outcome of a relation without indices.
pub fn outcome(states: &str, verdict: &str) -> Outcome {
    relation(&format!("states = '{states}'"), &format!("states {states}\n {verdict}"))
}

/// The outcome of a relation with these fields and lines.
pub fn relation(fields: &str, lines: &str) -> Outcome {
    relation_of(SCHEMES, fields, lines)
}

/// The same of other schemes.
pub fn relation_of(schemes: &str, fields: &str, lines: &str) -> Outcome {
    let claims = format!("key = 'k'\n{schemes}\n[[relation]]\nid = 'r'\n{fields}\n");
    let certificate = format!("subcert-certificate 4\npaper k\nrelation r\n {lines}\nend 1\n");
    let report = check(&claims, &[&certificate]).expect("a claim file");
    assert!(report.broken.is_empty(), "{:?}", report.broken);
    report.claims.into_iter().next().expect("a claim").2
}

/// Checks that these formulas have these values, and no others.
pub fn values(list: &[(&str, &str)]) {
    let mut wrong = String::new();
    for (formula, value) in list {
        let states = format!("{formula} = {value}");
        let holds = outcome(&states, "holds 1");
        let other = outcome(&format!("{formula} = {value} + 1"), "fails 1\n case = -1");
        if holds != Outcome::Valid || other != Outcome::Valid {
            let _ = writeln!(wrong, "{states}: {holds:?}, {other:?}");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn coefficients_and_symbols() {
    values(&[
        ("coefficient(four, 0)", "1"),
        ("coefficient(four, -3)", "-1/16"),
        ("coefficient(four, 2)", "0"),
        ("coefficient(four, 1000000)", "0"),
        ("sum(k = -3..3, coefficient(four, k)*2^k)", "symbol_at(four, 2)"),
        ("symbol_at(four, 1)", "2"),
        ("symbol_at(four, -1)", "0"),
        ("symbol_at(two, 2)", "27/8"),
        ("symbol_at(haar, 0)", "1"),
        ("coefficient(2, scheme = daubechies)", "(3 - 2*cos(pi/6))/4"),
        (
            "sum(k = 0..3, coefficient(daubechies, k)*(2*cos(pi/6))^k)",
            "symbol_at(daubechies, 2*cos(pi/6))",
        ),
        ("arity(ternary) + width(ternary)", "5"),
        ("coefficient(far, -18001)", "1/2"),
        ("coefficient(far, -18002)", "0"),
    ]);
    let symbolic = |states: &str, verdict: &str| {
        let fields = format!("symbols = ['w']\nscheme = 'tension:w=w'\nstates = '{states}'");
        relation(&fields, &format!("states {states}\n {verdict}"))
    };
    for states in
        ["coefficient(3) = -w", "symbol_at(2) = 9/4 + w*(5/2 - 65/8)", "symbol_at(-1) = 0"]
    {
        assert_eq!(symbolic(states, "holds 1"), Outcome::Valid, "{states}");
    }
    for states in [
        "support() = 6",
        "sum_rules() = 2",
        "limit_value(0) = 1",
        "symmetric() = 1",
        "interpolating() = 1",
        "moment(0) = 1",
        "orthogonal() = 0",
        "symbol_at(0) = 1",
    ] {
        let found = symbolic(states, "holds 1");
        assert!(matches!(found, Outcome::Invalid(..)), "{states}: {found:?}");
    }
}

#[test]
fn supports_and_symmetries() {
    values(&[
        ("support(four)", "6"),
        ("support_start(four)", "-3"),
        ("support_end(four)", "3"),
        ("support(two)", "3"),
        ("support(daubechies)", "3"),
        ("support(third)", "5"),
        ("support_start(ternary)", "-1"),
        ("support_end(third) + support_start(third)", "0"),
        ("support_start(far)", "-18001"),
        ("symmetric(four)", "1"),
        ("symmetric(two)", "1"),
        ("symmetric(daubechies)", "0"),
        ("symmetric(third)", "1"),
        ("interpolating(four)", "1"),
        ("interpolating(two)", "0"),
        ("interpolating(third)", "1"),
        ("interpolating(wild)", "1"),
    ]);
}

#[test]
fn orders_and_degrees() {
    values(&[
        ("sum_rules(four)", "4"),
        ("generation(four)", "3"),
        ("reproduction(four)", "3"),
        ("reproduction(four, parameters = indexed)", "3"),
        ("approximation_order(four)", "4"),
        ("approximation_order(four, data = adapted)", "4"),
        ("sum_rules(two)", "3"),
        ("reproduction(two)", "1"),
        ("reproduction(two, parameters = indexed)", "0"),
        ("approximation_order(two)", "2"),
        ("approximation_order(two, data = adapted)", "3"),
        ("sum_rules(cubic)", "4"),
        ("reproduction(cubic)", "1"),
        ("sum_rules(haar)", "1"),
        ("reproduction(haar)", "0"),
        ("reproduction(haar, parameters = indexed)", "0"),
        ("sum_rules(daubechies)", "2"),
        ("reproduction(daubechies)", "1"),
        ("sum_rules(third)", "3"),
        ("reproduction(third)", "2"),
        ("sum_rules(ternary)", "2"),
        ("reproduction(ternary)", "1"),
        ("sum_rules(bell)", "9"),
        ("sum_rules(long)", "1"),
        ("support(long)", "16383/63"),
        ("symmetric(long)", "1"),
    ]);
}

/// B-splines have rational values; the four-point function keeps 1 at 0.
#[test]
fn limits() {
    values(&[
        ("limit_value(cubic, 0)", "2/3"),
        ("limit_value(cubic, 1)", "1/6"),
        ("limit_value(cubic, -1)", "1/6"),
        ("limit_value(cubic, 2)", "0"),
        ("limit_value(cubic, 10^30)", "0"),
        ("limit_value(cubic, 1/2)", "23/48"),
        ("limit_value(cubic, -3/2)", "1/48"),
        ("limit_value(hat, 1/2^64)", "1 - 1/2^64"),
        ("limit_value(hat, -5/8)", "3/8"),
        ("limit_value(four, 0)", "1"),
        ("limit_value(four, 5)", "0"),
        ("limit_value(four, 1/2)", "9/16"),
        ("limit_value(four, 3/2)", "-1/16"),
        ("limit_value(four, 5/2)", "0"),
        ("limit_value(four, 1/4)", "27/32"),
        ("limit_value(ternary, 1/3)", "2/3"),
        ("limit_value(ternary, -8/9)", "1/9"),
        ("limit_value(third, 0)", "1"),
        // Daubechies: φ(1) = (1 + √3)/2.
        ("limit_value(daubechies, 1)", "(1 + 2*cos(pi/6))/2"),
        ("limit_value(daubechies, 2)", "(1 - 2*cos(pi/6))/2"),
        ("limit_value(daubechies, 1/2)", "(2 + 2*cos(pi/6))/4"),
        ("limit_value(daubechies, 3/2)", "0"),
        ("limit_value(daubechies, 0)", "0"),
        // Chaikin's function at the integers is 1/2 twice.
        ("limit_value(two, 0) + limit_value(two, 1)", "1"),
        ("limit_value(two, 1/2)", "3/4"),
        ("limit_value(far, -18000)", "1"),
        ("limit_value(far, -18001 + 1/8)", "1/8"),
        // Their sum at the points x + i is 1.
        ("sum(i = 0..3, limit_value(daubechies, i + 1/4))", "1"),
        ("sum(i = -3..3, limit_value(third, i + 7/27))", "1"),
        ("sum(i = -3..3, (i + 7/27)*limit_value(third, i + 7/27))", "0"),
    ]);
}

#[test]
fn integrals() {
    values(&[
        ("moment(four, 0)", "1"),
        ("moment(four, 1)", "0"),
        ("moment(four, 2)", "0"),
        ("moment(four, 3)", "0"),
        ("moment(hat, 2)", "1/6"),
        ("moment(cubic, 2)", "1/3"),
        ("moment(haar, 64)", "1/65"),
        ("moment(ternary, 2)", "1/6"),
        ("moment(daubechies, 1)", "(3 - 2*cos(pi/6))/2"),
        ("moment(daubechies, 2)", "((3 - 2*cos(pi/6))/2)^2"),
        ("inner_product(cubic, 0)", "151/315"),
        ("inner_product(cubic, 1)", "397/1680"),
        ("inner_product(cubic, -2)", "1/42"),
        ("inner_product(cubic, 3)", "1/5040"),
        ("inner_product(cubic, 4)", "0"),
        ("inner_product(cubic, 1000000)", "0"),
        ("inner_product(hat, 0)", "2/3"),
        ("inner_product(hat, 0, with = cubic)", "11/20"),
        ("inner_product(hat, 2, with = cubic)", "1/120*26/26"),
        ("inner_product(cubic, -2, with = hat)", "1/120"),
        ("inner_product(ternary, 1)", "1/6"),
        ("inner_product(daubechies, 0)", "1"),
        ("inner_product(daubechies, 1)", "0"),
        ("inner_product(daubechies, 2)", "0"),
        ("orthogonal(daubechies)", "1"),
        ("orthogonal(haar)", "1"),
        ("orthogonal(four)", "0"),
        ("orthogonal(far)", "0"),
        ("moment(far, 1)", "-18000"),
        ("inner_product(far, 0)", "2/3"),
        ("inner_product(far, -18001, with = hat)", "1/6"),
        ("sum(k = -4..4, inner_product(third, k))", "1"),
        // The condition is one on the mask: the functions φ(x − k) of this one are not orthogonal.
        ("orthogonal(stretched)", "1"),
        ("biorthogonal(hat, with = hat)", "0"),
        ("biorthogonal(daubechies, with = daubechies)", "1"),
    ]);
}

/// Chaikin's scheme and B-splines keep all shapes, interpolation none. `late` is decided after some levels.
/// The limit of a symbol that is not in L² has no such integrals, whatever has been asked for before.
#[test]
fn no_integrals_without_limits() {
    for one in ["hat", "cubic", "two", "haar", "averaged"] {
        for other in ["rough", "rougher"] {
            let states = format!(
                "inner_product({one}, 0) + inner_product({one}, 1) + 0*inner_product({other}, 0) > 0"
            );
            let found = outcome(&states, "holds 1");
            assert!(matches!(found, Outcome::Incomplete(Some(_))), "{states}: {found:?}");
        }
    }
}

#[test]
fn shapes() {
    values(&[
        ("positive(two) + monotone(two) + convex(two)", "3"),
        ("positive(bell) + monotone(bell) + convex(bell)", "3"),
        ("positive(ternary) + monotone(ternary) + convex(ternary)", "3"),
        ("positive(hat)*monotone(hat)*convex(hat)", "1"),
        ("positive(four) + monotone(four) + convex(four)", "0"),
        ("positive(third) + monotone(third) + convex(third)", "0"),
        ("monotone(cutting)", "1"),
        ("convex(cutting)", "0"),
        ("positive(late)", "1"),
        ("monotone(late)", "1"),
        ("convex(late)", "1"),
        ("positive(later)*monotone(later)", "1"),
        ("convex(later)", "0"),
        ("convex(mirrored)", "0"),
        ("positive(averaged)*monotone(averaged)", "1"),
        ("positive(far) + monotone(far) + convex(far)", "3"),
        ("convex(fine)", "0"),
    ]);
}

#[test]
fn schemes_of_the_catalogue_are_options() {
    values(&[
        ("contraction(chaikin, 2)", "1/4"),
        ("convex(chaikin)", "1"),
        ("inner_product(two, 0, with = chaikin) - inner_product(chaikin, 0)", "-1/3"),
    ]);
    for states in [
        "contraction(b-spline, 2) = 1",
        "contraction(loop) = 1",
        "contraction(corner) = 1",
        "contraction(chaikin, scheme = two) = 1",
        "abs(chaikin) = 1",
    ] {
        assert!(matches!(outcome(states, "holds 1"), Outcome::Invalid(..)), "{states}");
    }
    // As an index, this is a number.
    let fields = "scheme = 'two'\nstates = 'contraction(haar) = 1/2^haar'\nfor = 'haar = 1..3'";
    let lines = "states contraction(haar) = 1/2^haar\n holds 3";
    assert_eq!(relation(fields, lines), Outcome::Valid);
}

#[test]
fn a_name_of_a_scheme_is_an_option() {
    values(&[
        ("contraction(two)", "1/2"),
        ("contraction(two, 2)", "1/4"),
        ("contraction(2, scheme = two)", "1/4"),
        ("norm(four)", "5/4"),
        ("tensor(two) - norm(two)*contraction(two)", "0"),
        ("displacement(two)", "1/4"),
        ("mask(two, 0, 0) + mask(two, 1, 1)", "1"),
    ]);
    for states in [
        "contraction(two, scheme = four) = 1/2",
        "abs(two) = 1",
        "contraction(2, two) = 1",
        "two = 2",
        "cos(two) = 1",
        "max(two, 1) = 1",
    ] {
        assert!(matches!(outcome(states, "holds 1"), Outcome::Invalid(..)), "{states}");
    }
    // An index of this name is a number.
    let fields = "scheme = 'two'\nstates = 'contraction(two) = 1/2^two'\nfor = 'two = 1..3'";
    let lines = "states contraction(two) = 1/2^two\n holds 3";
    assert_eq!(relation(fields, lines), Outcome::Valid);
    assert!(matches!(
        relation(&fields.replace("scheme = 'two'\n", ""), lines),
        Outcome::Invalid(..)
    ));
}

/// What is beyond a cap, or not shown to converge, has no value.
#[test]
fn what_is_beyond_a_cap_is_left_open() {
    for states in [
        "limit_value(wild, 0) = 1",
        "positive(wild) = 1",
        "positive(haar) = 1",
        "monotone(golden) = 1",
        // Here limits are convex: they are averages of those of `hat`. But σ² does not divide the mask.
        "convex(averaged) = 1",
        // The second coefficient of c_j stays negative.
        "convex(endless) = 1",
        "sum(i = 1..100000, convex(later)) = 0",
        "sum(i = 1..100000, monotone(long)) = 0",
        "inner_product(wild, 0) = 1",
        "inner_product(two, 0, with = wild) = 1",
        "limit_value(haar, 0) = 1",
        "limit_value(two, 1/3) = 1",
        "limit_value(two, 1/2^65) = 0",
        "limit_value(two, cos(2*pi/5)) = 0",
        "moment(two, 65) = 0",
        "coefficient(two, 1000001) = 0",
        "symbol_at(long, 1/3) = 0",
        "moment(fine, 64) = 0",
        "symbol_at(long, 10^1000 + 1/7) = 0",
        "symbol_at(far, 7^100000) = 0",
        "limit_value(long, 0) = 0",
        "inner_product(long, 0) = 0",
        "inner_product(round, 0) = 0",
        "sum_rules(round)*0 + sum(i = 1..1000, symbol_at(round, cos(2*pi/997))) = 0",
        "sum(i = 1..100000, sum_rules(long)) = 0",
        "sum(i = 1..100000, orthogonal(long)) = 0",
        "sum(i = 1..100000, interpolating(long) + symmetric(long)) = 0",
        "sum(i = 1..100000, limit_value(four, i/2^64)) = 0",
    ] {
        let begin = Instant::now();
        let found = outcome(states, "holds 1");
        let Outcome::Incomplete(Some(rejection)) = &found else { panic!("{states}: {found:?}") };
        assert!(matches!(rejection.reason, Reason::Stopped(_)), "{states}: {found:?}");
        println!("{:?} {states}: {}", begin.elapsed(), rejection.reason);
        assert!(begin.elapsed().as_secs() < 60, "{states}");
    }
    for states in [
        "moment(two, -1) = 0",
        "positive(two, 1) = 1",
        "convex(two, data = sampled) = 1",
        "moment(two, 1/2) = 0",
        "symbol_at(two, 0) = 1",
        "biorthogonal(two) = 0",
        "biorthogonal(two, with = ternary) = 0",
        "inner_product(two, 0, with = ternary) = 0",
        "inner_product(two, 1/2) = 0",
        "coefficient(two, 1/2) = 0",
        "reproduction(two, parameters = odd) = 1",
        "sum_rules(two, data = adapted) = 3",
        "sum_rules(two, 1) = 3",
    ] {
        let found = outcome(states, "holds 1");
        assert!(matches!(found, Outcome::Invalid(..)), "{states}: {found:?}");
    }
}
