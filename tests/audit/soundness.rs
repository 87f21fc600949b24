//! Claim files of which a false verdict was said once, and what is said of them now.

use subcert::audit::{EquationVerdict, TheoremVerdict, Verdict, audit};
use subcert::cap::Cap;
use subcert::certificate::certificate;
use subcert::claim::{Paper, read_paper};
use subcert::diagnostic::{Diagnostic, SourceText};
use subcert_check::{Outcome, check};

const PAPER: &str = "key = 'sound'\npaper = { authors = [], title = '', venue = '', year = '' }\n";

fn read(claims: &str) -> (String, Paper) {
    let text = format!("{PAPER}{claims}");
    let paper = read_paper(&SourceText::new("sound.toml", text.clone()));
    (text, paper.unwrap_or_else(|error| panic!("{error}")))
}

/// Why a file is refused when its claims are judged.
fn refused(claims: &str) -> Diagnostic {
    audit(&read(claims).1).map(|_| ()).expect_err(claims)
}

/// The verdicts of theorems.
fn theorems(claims: &str) -> Vec<TheoremVerdict> {
    let (_, paper) = read(claims);
    let audit = audit(&paper).unwrap_or_else(|error| panic!("{error}"));
    audit.theorems.iter().map(|theorem| theorem.verdict).collect()
}

/// Whether the checker accepts what is said of every claim.
fn accepted(claims: &str) -> bool {
    let (text, paper) = read(claims);
    let audit = audit(&paper).unwrap_or_else(|error| panic!("{error}"));
    let report = check(&text, &[&certificate(&audit).text]).expect("a claim file");
    report.claims.iter().all(|(.., outcome)| *outcome == Outcome::Valid)
}

/// Two points, each of which is moved towards the other; `keep` and `mean` are interpolants.
const RINGS: &str = "
[[scheme]]
name = 'pair'
orbits = { a = '1', b = '1' }
edges = [['a', 'b']]
weights.a = { a = '3/4', b = '1/4' }
weights.b = { a = '1/4', b = '3/4' }
[[scheme]]
name = 'keep'
orbits = { a = '1', b = '1' }
edges = [['a', 'b']]
weights.a = { a = '1' }
weights.b = { b = '1' }
[[scheme]]
name = 'same'
orbits = { a = '1', b = '1' }
edges = [['a', 'b']]
weights.a = { a = '3/4', b = '1/4' }
weights.b = { a = '1/4', b = '3/4' }
[[scheme]]
name = 'turned'
orbits = { b = '1', a = '1' }
edges = [['a', 'b']]
weights.a = { a = '3/4', b = '1/4' }
weights.b = { a = '1/4', b = '3/4' }
[[scheme]]
name = 'three'
orbits = { a = '1', b = '1', c = '1' }
edges = [['a', 'b'], ['b', 'c']]
weights.a = { a = '1/2', b = '1/2' }
weights.b = { b = '1' }
weights.c = { c = '1' }
[[scheme]]
name = 'more'
orbits = { a = '1', b = '1', c = '1' }
edges = [['a', 'b'], ['b', 'c']]
weights.a = { a = '1', b = '1', c = '-1' }
weights.b = { b = '1', a = '1', c = '-1' }
weights.c = { c = '1', a = '1', b = '-1' }
";

fn step(id: &str, interpolant: &str) -> String {
    format!(
        "[[theorem]]\nid = '{id}'\nlocus = ''\nscheme = 'pair'\nbounds = 'step'\nfrom = '0'\n\
         by = 'beta*(1/2)^k/1000'\ninterpolant = '{interpolant}'\n"
    )
}

#[test]
fn interpolants_are_told_apart() {
    use TheoremVerdict::{Proved, Refuted};
    let [same, keep] = [step("one", "same"), step("two", "keep")];
    assert_eq!(theorems(&format!("{RINGS}{same}")), [Proved]);
    assert_eq!(theorems(&format!("{RINGS}{keep}")), [Refuted]);
    assert_eq!(theorems(&format!("{RINGS}{same}{keep}")), [Proved, Refuted]);
    let [same, keep] = [step("two", "same"), step("one", "keep")];
    assert_eq!(theorems(&format!("{RINGS}{keep}{same}")), [Refuted, Proved]);
    assert!(accepted(&format!("{RINGS}{keep}{same}")));
}

#[test]
fn an_interpolant_has_the_same_points_in_the_same_order() {
    for other in ["turned", "three"] {
        let error = refused(&format!("{RINGS}{}", step("one", other)));
        assert!(error.message.contains("the same points"), "{error}");
    }
}

#[test]
fn what_means_nothing_for_a_scheme_is_refused() {
    let theorem = |scheme: &str, field: &str| {
        format!(
            "{RINGS}[[theorem]]\nid = 't'\nlocus = ''\nscheme = '{scheme}'\nbounds = 'step'\n\
             from = '0'\nby = 'beta'\n{field}\n"
        )
    };
    for (scheme, field, why) in [
        ("chaikin", "interpolant = 'pair'", "no interpolant"),
        ("pair", "offset = '1'", "a ring has none"),
    ] {
        let error = refused(&theorem(scheme, field));
        assert!(error.message.contains(why), "{error}");
    }
}

#[test]
fn a_point_with_other_weights_beside_1_is_not_kept() {
    let claims = format!(
        "{RINGS}[[theorem]]\nid = 't'\nlocus = ''\nscheme = 'three'\nbounds = 'distance'\n\
         from = '0'\nby = 'beta/1000'\ninterpolant = 'more'\n"
    );
    assert_eq!(theorems(&claims), [TheoremVerdict::Open]);
}

#[test]
fn a_negative_bound_is_not_refuted_by_equal_points() {
    let theorem = |by: &str| {
        format!(
            "[[theorem]]\nid = 't'\nlocus = ''\nscheme = 'chaikin'\nbounds = 'distance'\n\
             from = '0'\nby = '{by}'\n"
        )
    };
    assert_eq!(theorems(&theorem("-beta")), [TheoremVerdict::Open]);
    assert_eq!(theorems(&theorem("beta/1000")), [TheoremVerdict::Refuted]);
}

#[test]
fn hypotheses_hold_together() {
    let equation = |hypotheses: &str| {
        format!(
            "[[equation]]\nid = 'e'\nlocus = ''\nsymbols = ['a']\nhypotheses = [{hypotheses}]\n\
             left = 'a[1]'\nright = '3'\n"
        )
    };
    for hypotheses in [
        "'a[1] = a[0]', 'a[0] = 3'",
        "'a[0] = 3', 'a[1] = a[0]'",
        "'a[0] = a[1] + a[2]', 'a[2] = a[0] - 3'",
        "'a[1] = 2*a[1] - 3'",
    ] {
        let claims = equation(hypotheses);
        let (_, paper) = read(&claims);
        let found = audit(&paper).unwrap_or_else(|error| panic!("{error}"));
        let verdict = &found.equations[0].verdict;
        assert!(
            matches!(verdict, EquationVerdict::Holds { cases: 1 }),
            "{hypotheses}: {verdict:?}"
        );
        assert!(accepted(&claims), "{hypotheses}");
    }
    for (hypotheses, why) in [
        ("'a[1] = 3', 'a[1] = 4'", "contradicts"),
        ("'a[1] = a[1] + 1'", "contradicts"),
        ("'a[1] = a[0]^2', 'a[0] = 2'", "not linear"),
        ("'b[1] = b[2]', 'a[1] = 3'", "open"),
    ] {
        let error = refused(&equation(hypotheses));
        assert!(error.message.contains(why), "{error}");
    }
}

#[test]
fn indices_without_values_claim_nothing() {
    let error = refused(
        "[[equation]]\nid = 'e'\nlocus = ''\nleft = '1'\nright = '2'\n\
         indices = [{ name = 'i', from = '2', to = '1' }]\n",
    );
    assert!(error.message.contains("no values"), "{error}");
}

#[test]
fn the_cases_of_an_equation_share_a_cap_on_work() {
    let (_, paper) = read(
        "[[equation]]\nid = 'e'\nlocus = ''\nleft = 'sum(j = 1..300, j*i)'\nright = '45150*i'\n\
         indices = [{ name = 'i', from = '1', to = '100000' }]\n",
    );
    let cap = Cap::new("the work of all cases", 20_000_000);
    let audit = audit(&paper).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(audit.equations[0].verdict, EquationVerdict::BeyondCap(cap));
}

#[test]
fn a_spread_is_not_negative() {
    let error = refused(
        "[[table]]\nid = 't'\nlocus = ''\nscheme = 'chaikin'\nvalue = '1/2'\n\
         promise = { level = '0', spread = 'x' }\ncolumns = { name = 'x', values = ['-1'] }\n\
         cells = [['0.5']]\n",
    );
    assert!(error.message.contains("negative"), "{error}");
}

/// A table in which the first row needs no assumption: its cells are read as in any other table,
/// whatever the second row needs.
#[test]
fn cells_without_assumptions_are_read_apart() {
    let table = |second: &str| {
        format!(
            "[define]\nhalf = 'x/2'\n[[alternative]]\nof = 'half'\nlabel = 'a third'\n\
             value = 'x/3'\n[[table]]\nid = 't'\nlocus = ''\n\
             value = 'half + sum(i = 2..y, tau)'\nunstated = {{ tau = '1' }}\n\
             rows = {{ name = 'y', values = ['1', '2'] }}\n\
             columns = {{ name = 'x', values = ['0.61728', '0.37041'] }}\n\
             cells = [['0.20576', '0.12347'], {second}]\n"
        )
    };
    for second in ["['1.3086', '1.1235']", "['0.9', '0.8']", "['1.3086', '1.1852']"] {
        let claims = table(second);
        let (_, paper) = read(&claims);
        let found = audit(&paper).unwrap_or_else(|error| panic!("{error}"));
        let first = &found.tables[0].cells[0];
        assert!(first.iter().all(|cell| cell.verdict == Verdict::OtherReading), "{second}");
        assert!(accepted(&claims), "{second}");
    }
}
