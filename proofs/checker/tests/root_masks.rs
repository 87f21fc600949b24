//! Masks whose coefficients lie in no field of cosines.

use crate::masks::{outcome, relation, relation_of};
use subcert_check::Outcome;

#[test]
fn orthogonal_masks() {
    for states in [
        "sum_rules(daubechies-6) = 3",
        "generation(daubechies-6) = 2",
        "orthogonal(daubechies-6) = 1",
        "symmetric(daubechies-6) = 0",
        "interpolating(daubechies-6) = 0",
        "support(daubechies-6) = 5",
        "support_start(daubechies-6) = 0",
        "support_end(daubechies-6) = 5",
        "arity(daubechies-6) = 2",
        "vanishing_moments(daubechies-6) = 0",
        "coefficient(daubechies-6, 0) = (1 + sqrt(10) + sqrt(5 + 2*sqrt(10)))/16",
        "coefficient(daubechies-6, 6) = 0",
        "symbol_at(daubechies-6, 1) = 2",
        "symbol_at(daubechies-6, -1) = 0",
        "sum(k = 0..5, coefficient(daubechies-6, k)^2) = 2",
        "same(scheme = daubechies-6, with = daubechies-6) = 1",
        "moment(daubechies-6, 0) = 1",
        "moment(daubechies-6, 1) = sum(k = 0..5, k*coefficient(daubechies-6, k))/2",
        // So it is for three orders of vanishing moments.
        "moment(daubechies-6, 2) = moment(daubechies-6, 1)^2",
    ] {
        assert_eq!(outcome(states, "holds 1"), Outcome::Valid, "{states}");
        let found = outcome(states, "fails 1\n case = 0");
        assert!(matches!(found, Outcome::Invalid(..)), "{states}: {found:?}");
        let other = format!("{states} + 1");
        let found = outcome(&other, "holds 1");
        assert!(matches!(found, Outcome::Invalid(..)), "{other}: {found:?}");
    }
}

/// What is not within reach is left open.
#[test]
fn what_is_open() {
    for states in [
        "positive(daubechies-6) = 1",
        "limit_value(daubechies-6, 1) = 1",
        "contraction(daubechies-6, 1) = 1",
        "hoelder(daubechies-6) > 1",
        "reproduction(daubechies-6) = 0",
        "symmetric(wavelet-9-7) = 1",
        "biorthogonal(scheme = wavelet-9-7, with = wavelet-9-7-synthesis) = 1",
    ] {
        for verdict in ["holds 1", "fails 1\n case = 1"] {
            let found = outcome(states, verdict);
            assert!(matches!(found, Outcome::Incomplete(Some(_))), "{states}: {found:?}");
        }
    }
    let own = "scheme = 'daubechies-6'\nstates = 'sum_rules() = 3'";
    let found = relation(own, "states sum_rules() = 3\n holds 1");
    assert!(matches!(found, Outcome::Incomplete(Some(_)) | Outcome::Valid), "{found:?}");
    let found = relation(own, "states sum_rules() = 3\n fails 1\n case = 1");
    assert!(!matches!(found, Outcome::Valid), "{found:?}");
}

#[test]
fn masks_of_a_claim_file() {
    let scheme = |rows: &str| {
        format!("[[scheme]]\nname = 'own'\nlet = {{ r = 'sqrt(1 + sqrt(2))' }}\nmask = {rows}\n")
    };
    let about = |rows: &str, states: &str| {
        relation_of(
            &scheme(rows),
            &format!("states = '{states}'"),
            &format!("states {states}\n holds 1"),
        )
    };
    let rows = "[['r', '1 - r'], ['1/2', '1/2']]";
    for (states, right) in [
        ("sum_rules(own) = 1", true),
        ("sum_rules(own) = 2", false),
        ("coefficient(own, 0)^4 = 2*coefficient(own, 0)^2 + 1", true),
        ("coefficient(own, 0)^4 = 2*coefficient(own, 0)^2 + 2", false),
        ("coefficient(own, 0) + coefficient(own, -2) = 1", true),
        ("symmetric(own) = 1", false),
        ("interpolating(own) = 0", true),
        ("support(own) = 3", true),
    ] {
        let found = about(rows, states);
        assert_eq!(found == Outcome::Valid, right, "{states}: {found:?}");
        assert!(matches!(found, Outcome::Valid | Outcome::Invalid(..)), "{states}: {found:?}");
    }
    for (rows, states) in [
        ("[['r^4 - 2*r^2', 'r - r'], ['r - 1', '2 - r']]", "interpolating(own) = 1"),
        ("[['1', '0*r', '0'], ['1/2', '1/2', 'r^4 - 2*r^2 - 1']]", "support(own) = 2"),
        ("[['1', '0*r', '0'], ['1/2', '1/2', 'r^4 - 2*r^2 - 1']]", "symmetric(own) = 1"),
        ("[['1', '0*r', '0'], ['1/2', '1/2', 'r^4 - 2*r^2 - 1']]", "sum_rules(own) = 2"),
    ] {
        assert_eq!(about(rows, states), Outcome::Valid, "{rows} {states}");
    }
    for rows in ["[['r', 'r'], ['1/2', '1/2']]", "[['r', '1 - r'], ['1']]", "[['r', '1 - r']]"] {
        let found = about(rows, "support(own) = 3");
        assert!(matches!(found, Outcome::Invalid(..)), "{rows}: {found:?}");
    }
}
