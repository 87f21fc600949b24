//! Relations: verdicts, what the checker says of them, and functions against their definitions.

use crate::common::claims::{HEAD, judged, paper};
use proptest::prelude::*;
use subcert::audit::Word;
use subcert::certificate::certificate;
use subcert::claim::read_paper;
use subcert::diagnostic::SourceText;
use subcert::exact::{Integer, Rational};
use subcert_check::{Outcome, check};

pub(super) const SCHEMES: &str = "[[scheme]]\nname = 'fp'\nuse = 'four-point:w=1/16'\n\
    [[scheme]]\nname = 'cubic'\nsymbol = '(1+z)^4/8'\n\
    [[scheme]]\nname = 'd4'\nsymbol = '((1+2*cos(pi/6)) + (3+2*cos(pi/6))*z + (3-2*cos(pi/6))*z^2 + (1-2*cos(pi/6))*z^3)/4'\n\
    [[scheme]]\nname = 'ternary'\nmask = '[1, 2, 3, 2, 1]/3'\n";

/// The verdict on a relation, on which the checker has to agree; a relation that is open is incomplete there.
pub(super) fn verdict(schemes: &str, fields: &str) -> Word {
    let paper = paper(&format!("{schemes}[[relation]]\nid = 'r'\nlocus = 'l'\n{fields}"));
    let audit = judged(&paper);
    let word = audit.equations[0].verdict.word();
    let text = certificate(&audit).text;
    let report = check(&paper.source.text, &[&text]).expect("a claim file");
    let (_, _, outcome) = &report.claims[0];
    let agrees = match word {
        Word::Holds | Word::Fails => matches!(outcome, Outcome::Valid),
        _ => matches!(outcome, Outcome::Incomplete(_)),
    };
    assert!(agrees, "{fields}: {word}, {outcome:?}\n{text}");
    word
}

#[test]
fn what_holds_holds_and_its_contrary_fails() {
    // Each with a sign that makes it false.
    for (text, contrary) in [
        ("reproduction(fp) = 3", "reproduction(fp) != 3"),
        ("reproduction(chaikin) = 1", "reproduction(chaikin) > 1"),
        (
            "reproduction(chaikin, parameters = indexed) = 0",
            "reproduction(chaikin, parameters = indexed) = 1",
        ),
        ("generation(cubic) = 3", "generation(cubic) = 4"),
        ("approximation_order(cubic) = 2", "approximation_order(cubic) = 4"),
        (
            "approximation_order(cubic, data = adapted) = 4",
            "approximation_order(cubic, data = adapted) < 4",
        ),
        ("sum_rules(d4) = 2", "sum_rules(d4) in {0, 1, 3, 4}"),
        ("support(fp) = 6", "support(fp) in [0, 6)"),
        ("support_start(cubic) = 0", "support_start(cubic) = -2"),
        ("support_end(cubic) = 4", "support_end(cubic) < 4"),
        ("support(ternary) = 2", "support(ternary) = 4"),
        ("symmetric(fp)", "not symmetric(fp)"),
        ("not symmetric(d4)", "symmetric(d4)"),
        ("interpolating(fp)", "not interpolating(fp)"),
        ("not interpolating(cubic)", "interpolating(cubic)"),
        ("coefficient(cubic, 2) = 3/4", "coefficient(cubic, 2) = 1/8"),
        ("symbol_at(cubic, -1) = 0", "symbol_at(cubic, -1) > 0"),
        ("symbol_at(fp, 1) = 2", "symbol_at(fp, 1) ≠ 2"),
        ("moment(cubic, 1) = 2", "moment(cubic, 1) = 0"),
        ("limit_value(cubic, 2) = 2/3", "limit_value(cubic, 2) = 1"),
        ("limit_value(cubic, 3/2) = 23/48", "limit_value(cubic, 3/2) = 1/2"),
        ("limit_value(fp, 1/2) = 9/16", "limit_value(fp, 1/2) ≥ 3/5"),
        ("inner_product(cubic, 0) = 151/315", "inner_product(cubic, 0) ≈ 0.46"),
        ("inner_product(cubic, 1) ≈ 0.236", "inner_product(cubic, 1) ≈ 0.238"),
        // ∫ φψ of the hat function and the cubic B-spline at their centres is the B-spline of degree 5 at 0.
        (
            "inner_product(cubic, 2, with = hat) = 11/20",
            "inner_product(cubic, 0, with = hat) = 11/20",
        ),
        ("orthogonal(d4)", "not orthogonal(d4)"),
        ("not orthogonal(cubic)", "orthogonal(cubic)"),
        ("biorthogonal(hat, with = dual)", "biorthogonal(hat, with = cubic)"),
        ("contraction(fp, 2) ≤ 3/8", "contraction(fp) < 5/8"),
        ("contraction(d4) in (0, 1)", "contraction(d4) in (0, 1/2)"),
        ("norm(cubic) = 1", "norm(fp) <= 1"),
        ("displacement(fp) = 1/8", "displacement(chaikin) = 0"),
        ("levels(1/2, 1/100) = 7", "levels(1/2, 1/100) = 6"),
        ("positive(cubic)", "not positive(cubic)"),
        ("not monotone(fp)", "monotone(fp)"),
        ("convex(chaikin)", "not convex(chaikin)"),
        ("not convex(corner)", "convex(corner)"),
        ("1/1000 ~ 0.00", "857/1000 ~ 0"),
        ("limit_value(cubic, 10^30) = 0", "limit_value(cubic, 4) > 0"),
        ("0 < 1/3 < 1/2 <= 1/2", "0 < 1/3 < 1/2 < 1/2"),
        ("2*cos(pi/5)^2 = cos(2*pi/5) + 1", "cos(pi/5) = 0.809016994"),
        ("cos(pi/5) ~ 0.809016994", "cos(pi/5) ~ 0.809016996"),
    ] {
        let more = "[[scheme]]\nname = 'hat'\nsymbol = 'z^-1*(1+z)^2/2'\n\
            [[scheme]]\nname = 'dual'\nsymbol = '(-z^-2 + 2*z^-1 + 6 + 2*z - z^2)/4'\n\
            [[scheme]]\nname = 'corner'\nmask = [['1/4', '3/4'], ['1/2', '1/2']]\n";
        for (text, word) in [(text, Word::Holds), (contrary, Word::Fails)] {
            let found = verdict(&format!("{SCHEMES}{more}"), &format!("states = '{text}'\n"));
            assert_eq!(found, word, "{text}");
        }
    }
}

/// The limits are the polylines through the averages of neighbours: convex, though no scheme of second differences shows it.
#[test]
fn what_no_product_decides_is_open() {
    let scheme = "[[scheme]]\nname = 'averages'\nsymbol = '(1+z)*(1+z^2)/2'\n";
    for text in ["convex(averages)", "not convex(averages)"] {
        assert_eq!(verdict(scheme, &format!("states = '{text}'\n")), Word::NotCheckable);
    }
}

#[test]
fn claims_about_all_integers_are_proved_refuted_or_open() {
    for (text, of, word) in [
        ("n^2 - n + 1 > 0", "all n >= -5", Word::Holds),
        ("n^3 + 1 = (n + 1)*(n^2 - n + 1)", "all n", Word::Holds),
        ("0 < n*(n+1)/2 <= n^2", "all n", Word::Holds),
        ("n^2 < 100*n + 5", "all n", Word::Fails),
        // It is true for the first 24 values, and false only for t = 30.
        ("(n - 30)^2 > 0", "all n", Word::Fails),
        ("(n - 30)^2 >= 0", "all n", Word::Holds),
        ("n*(n-1)*(n-2) in {0, 6}", "all n >= 0", Word::Fails),
        ("2^n > n", "all n", Word::Open),
        ("2^n > n^2", "all n", Word::Fails),
        ("sum(i = 1..n, i) = n*(n+1)/2", "all n", Word::Open),
        ("coefficient(fp, 0) = n", "all n >= 1", Word::Fails),
        ("contraction(fp) < n", "all n >= 1", Word::Holds),
        ("n < n + 1", "all n", Word::Holds),
        ("n <= n", "all n", Word::Holds),
        ("n + 1/3 = n", "all n", Word::Fails),
        ("((n^64)^64) > 0", "all n", Word::Open),
    ] {
        let found = verdict(SCHEMES, &format!("states = '{text}'\nfor = '{of}'\n"));
        assert_eq!(found, word, "{text} for {of}");
    }
    // The range begins behind its first value, whatever stands in that.
    let from = "'n = sum(i = 1..2, i)..5'";
    assert_eq!(verdict(SCHEMES, &format!("states = 'n in [3, 6)'\nfor = {from}\n")), Word::Holds);
    // Two of them, and one whose values depend on another.
    let found =
        |text: &str, of: &str| verdict(SCHEMES, &format!("states = '{text}'\nfor = {of}\n"));
    assert_eq!(found("(m + n)^2 = m^2 + 2*m*n + n^2", "['all m', 'all n >= 0']"), Word::Holds);
    assert_eq!(found("m*n >= m", "['all m', 'all n']"), Word::Open);
    assert_eq!(found("i <= n", "['all n', 'i = 1..n']"), Word::Open);
}

#[test]
fn a_mask_that_depends_on_an_index_is_tried() {
    // The coefficient of z³ is a(a − 1), which is 0 for a = 1 only.
    let scheme = "[[scheme]]\nname = 's'\nparameters.a = { about = 'a' }\narity = '2'\n\
                  symbol = '1 + z + a*(a-1)*z^2*(1-z^2)'\n";
    let fields = |text: &str| format!("scheme = 's:a=n'\nstates = '{text}'\nfor = 'all n'\n");
    assert_eq!(verdict(scheme, &fields("support() = 4")), Word::Fails);
    assert_eq!(verdict(scheme, &fields("support() in {1, 4}")), Word::Open);
    assert_eq!(verdict(scheme, &fields("coefficient(2) = n^2 - n")), Word::Open);
}

#[test]
fn the_example() {
    let text = std::fs::read_to_string("examples/relations.toml").expect("an example");
    let paper = read_paper(&SourceText::new("relations.toml", text)).expect("a claim file");
    let audit = judged(&paper);
    let words: Vec<Word> = audit.equations.iter().map(|finding| finding.verdict.word()).collect();
    assert_eq!(words.len(), 8);
    assert!(words[..7].iter().all(|word| *word == Word::Holds), "{words:?}");
    assert_eq!(words[7], Word::Fails);
}

#[test]
fn errors_have_a_place_and_a_remedy() {
    for (fields, message, help) in [
        ("states = '1 <'", "a formula is missing beside a sign", "write formulas"),
        ("states = '1 in 2'", "no set stands behind `in`", "write `x in {1, 2}`"),
        ("states = '1 < 2 in {1}'", "there is a sign beside `in`", "state other things"),
        ("states = '(1 < 2'", "a bracket has no partner", "close"),
        ("states = '1 + 1'", "this states nothing by itself", "compare it"),
        ("states = 'w < 1'\nsymbols = ['w']", "is stated of numbers", "only `=`"),
        ("states = '(1)/3 ~ 1/3 + 0'", "one side of `~` is a printed number", "write `=`"),
        ("states = '1 = 1'\nfor = 'n'", "no index with values", "for = 'n = 2..8'"),
        ("states = '1 = 1'\nfor = 'n = 1, 1'", "stands here twice", "for = 'n = 2..8'"),
        ("states = '1 = 1'\nfor = 'all n >= x'", "no integer", "for = 'n = 2..8'"),
        ("states = '1 in {}'", "no set stands behind `in`", "write `x in {1, 2}`"),
        ("states = 'not-0'\nfor = 'n = 1'", "unknown name", ""),
        ("states = 'symetric(chaikin)'", "unknown function `symetric`", ""),
        ("states = 'x*n in {n, n*x}'\nsymbols = ['x']\nfor = 'all n'", "is stated of numbers", ""),
        ("title = 'x'", "a relation needs either `states` or `absent`", "states ="),
        (
            "states = 'contraction(1, 2, 3) < 1'\nscheme = 'chaikin'",
            "its form is contraction(c",
            "",
        ),
    ] {
        let text = format!("{HEAD}[[relation]]\nid = 'r'\nlocus = 'l'\n{fields}\n");
        let source = SourceText::new("k.toml", text);
        let error = match read_paper(&source) {
            Err(error) => error,
            Ok(paper) => subcert::audit::audit(&paper).expect_err(fields),
        };
        let all = error.to_string();
        assert!(all.contains(message) && all.contains(help) && all.contains("k.toml:"), "{all}");
    }
}

/// A mask of small rational numbers whose rules sum to 1.
fn masks() -> impl Strategy<Value = Vec<Vec<Rational>>> {
    (2_usize..4, 2_usize..5).prop_flat_map(|(arity, width)| {
        let entry = (-4_i64..5, 1_i64..4).prop_map(|(p, q)| Rational::new(p, q));
        let row = prop::collection::vec(entry, width - 1).prop_map(|mut row| {
            let rest = row.iter().fold(Rational::one(), |rest, entry| rest - entry);
            row.push(rest);
            row
        });
        prop::collection::vec(row, arity)
    })
}

fn integer(count: usize) -> i64 {
    i64::try_from(count).expect("a small number")
}

/// Whether one step takes p(i + s) to q(i) + c for polynomials p of degree `degree`, by the values at many places: the new points
/// with all differences of the order degree + 1 equal to 0.
fn generates(mask: &[Vec<Rational>], degree: u32) -> bool {
    let n = integer(mask.len());
    let old = |i: i64| Rational::from(Integer::from(i).pow(degree));
    let new = |k: i64| {
        let (i, alpha) = (k.div_euclid(n), k.rem_euclid(n));
        let terms = mask[usize::try_from(alpha).expect("a rule")].iter().zip(i..);
        terms.fold(Rational::zero(), |sum, (a, at)| sum + a * &old(at))
    };
    let mut values: Vec<Rational> = (-12..12).map(new).collect();
    for _ in 0..=degree {
        values = values.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
    }
    values.iter().all(Rational::is_zero)
}

proptest! {
    #![proptest_config(crate::common::cases(32))]

    /// The order of the sum rules is one more than the greatest degree d for which data that are polynomials of degree ≤ d
    /// stay such; coefficients are those of the rules; the limit values of a convergent scheme are refined by the mask.
    #[test]
    fn functions_are_what_their_definitions_say(mask in masks(), offset in -3_i64..3) {
        let n = integer(mask.len());
        let rows: Vec<String> = mask.iter().map(|row| {
            let row: Vec<String> = row.iter().map(|entry| format!("'{entry}'")).collect();
            format!("[{}]", row.join(", "))
        }).collect();
        let scheme = format!(
            "[[scheme]]\nname = 's'\noffset = '{offset}'\nmask = [{}]\n", rows.join(", ")
        );
        let degree = (0..6).take_while(|degree| generates(&mask, *degree)).count();
        let holds = |text: String| verdict(&scheme, &format!("states = '{text}'\n"));
        prop_assert_eq!(holds(format!("sum_rules(s) = {degree}")), Word::Holds);
        for (alpha, row) in mask.iter().enumerate() {
            let j = integer(row.len()) - 1;
            let k = integer(alpha) - n * (offset + j);
            prop_assert_eq!(holds(format!("coefficient(s, {k}) = {}", row[row.len() - 1])), Word::Holds);
        }
        let refined = "limit_value(s, 1/2) = sum(k = -20..20, coefficient(s, k)*limit_value(s, arity(s)/2 - k))";
        let found = holds(refined.to_owned());
        if n == 2 {
            prop_assert_ne!(found, Word::Fails);
        }
    }
}
