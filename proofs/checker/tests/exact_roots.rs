//! Roots that are numbers of fields where their polynomials do not show it, and roots whose enclosures would never be fine enough.

use crate::masks::{outcome, relation_of};
use subcert_check::{Outcome, Reason};

/// Rings whose blocks 1 have the eigenvalues x = 1/2 + cos(2π/5)/2 and 0, x and (1 + 2y)/3, x and 1/2, for the valence 5, y = cos(2π/5).
const RINGS: &str = r"
[[scheme]]
name = 'singular'
parameters.N = {}
orbits = { e = 'N', f = 'N' }
edges = [['e[i]', 'e[i + 1]'], ['e[i]', 'f[i]']]
weights.e.e = 'kronecker(i, j)/2 + (kronecker(mod(j - i, N), 1) + kronecker(mod(i - j, N), 1))/4'
weights.f.e = 'kronecker(i, j)'
[[scheme]]
name = 'apart'
parameters.N = {}
orbits = { e = 'N', f = 'N' }
edges = [['e[i]', 'e[i + 1]'], ['e[i]', 'f[i]']]
weights.e.e = 'kronecker(i, j)/2 + (kronecker(mod(j - i, N), 1) + kronecker(mod(i - j, N), 1))/4'
weights.f.f = '(kronecker(i, j) + kronecker(mod(j - i, N), 1) + kronecker(mod(i - j, N), 1))/3'
[[scheme]]
name = 'half'
parameters.N = {}
orbits = { e = 'N', f = 'N' }
edges = [['e[i]', 'e[i + 1]'], ['e[i]', 'f[i]']]
weights.e.e = 'kronecker(i, j)/2 + (kronecker(mod(j - i, N), 1) + kronecker(mod(i - j, N), 1))/4'
weights.f.e = 'kronecker(i, j)/2'
weights.f.f = 'kronecker(i, j)/2'
";

fn about(states: &str, verdict: &str) -> Outcome {
    relation_of(RINGS, &format!("states = '{states}'"), &format!("states {states}\n {verdict}"))
}

#[test]
fn eigenvalues_of_fields() {
    let first = "1/2 + cos(2*pi/5)/2";
    for (ring, first, second) in [
        ("singular", first, "0"),
        ("apart", first, "1/3 + 2*cos(2*pi/5)/3"),
        ("half", first, "1/2"),
    ] {
        for (j, value) in [(1, first), (2, second)] {
            let eigenvalue = format!("eigenvalue({ring}, 5, 1, {j})");
            for (states, verdict) in [
                (format!("{eigenvalue} = {value}"), "holds 1".to_owned()),
                (format!("{eigenvalue} = 2"), format!("fails 1\n case = {value} - 2")),
                (format!("{eigenvalue} = 2"), "fails 1\n case in -3 0".to_owned()),
                (format!("{eigenvalue} in {{2, 3}}"), format!("fails 1\n case = {value} - 2")),
                (format!("{eigenvalue} > 2"), format!("fails 1\n case = {value} - 2")),
            ] {
                assert_eq!(about(&states, &verdict), Outcome::Valid, "{states} {verdict}");
            }
            for verdict in ["holds 1", "fails 1", "fails 1\n case = 1", "fails 1\n case = 0"] {
                let found = about(&format!("{eigenvalue} = 2"), verdict);
                assert!(matches!(found, Outcome::Invalid(..)), "{eigenvalue} {verdict}: {found:?}");
            }
            let found = about(
                &format!("{eigenvalue} = {value}"),
                &format!("fails 1\n case = {value} - ({value})"),
            );
            assert!(matches!(found, Outcome::Invalid(..)), "{eigenvalue}: {found:?}");
        }
    }
}

#[test]
fn roots_that_are_0() {
    let root = "root([-2, 0, 0, 1], 1)";
    for states in [
        "root([0, -cos(2*pi/5), 1], 1) = 0".to_owned(),
        format!("root([0, -{root}, 1], 1) = 0"),
        format!("root([0, -{root}, 0, 1], 2) = 0"),
        // A coefficient of which only bounds are known is 0.
        format!("root([{root}^2 - root([-4, 0, 0, 1], 1), -{root}, 1], 1) = 0"),
    ] {
        assert_eq!(outcome(&states, "holds 1"), Outcome::Valid, "{states}");
    }
}

/// Enclosures as fine as their own size would take numbers of hundreds of thousands of digits.
#[test]
fn long_roots_are_beyond_a_cap() {
    let root = "root([-2, 0, 0, 1], 1)";
    for states in [
        format!("root([1/10^30000, -{root}, 1], 1) < {root} - 2"),
        format!("root([-1/7^5000, 0, 1/3^5000, 1], 1) < {root} - 2"),
    ] {
        let found = outcome(&states, "holds 1");
        let Outcome::Incomplete(Some(rejection)) = &found else { panic!("{states}: {found:?}") };
        assert!(matches!(rejection.reason, Reason::Valueless(_) | Reason::Stopped(_)), "{found:?}");
    }
}
