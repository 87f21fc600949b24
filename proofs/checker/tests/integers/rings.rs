//! Functions of rings at all valences from one on.

use super::{are_shown, is_incomplete, outcome, outcome_of};
use crate::masks::relation_of;
use subcert_check::Outcome;

const FILE: &str = r"
[define]
b = '3/(8*n)'
edges = '3/(2*n)'
faces = '1/(4*n)'
c = 'cos(2*pi/n)'
[[scheme]]
name = 'alias'
use = 'loop-weight:beta=a/n'
[[scheme]]
name = 'constant'
parameters.n = {}
parameters.w = { default = '1/(2*n)' }
orbits = { face = 'n' }
edges = [['face[i]', 'face[i + 1]']]
weights.face.face = 'kronecker(mod(j - i, n), 0)/2 + w'
";

/// Those of catalogued schemes.
#[test]
fn catalogued() {
    are_shown(
        FILE,
        &[
            (3, "subdominant(loop, n) = 3/8 + cos(2*pi/n)/4"),
            (3, "subdominant(doo-sabin, n) = 1/2"),
            (3, "subdominant(mid-edge, n) = (1 + c)/2"),
            (3, "subdominant(catmull-clark-biquadratic, n) = 1/2 + c/4"),
            (3, "subdominant(sqrt3, n) = 2*(1 + c)/9"),
            (5, "subdominant(modified-butterfly, n) = 1/2"),
            (4, "eigenvalue(loop, n, 2, 1) < subdominant(loop, n)"),
            (3, "eigenvalue(loop, n, 0, 2) = (3/8 + c/4)^2"),
            (14, "eigenvalue(loop, n, 7, 1) = 3/8 + cos(14*pi/n)/4"),
            (3, "eigenvalue(catmull-clark, n, 0, 1) = 1"),
            (5, "eigenvalue(modified-butterfly, n, 0, 2) = 1/4"),
            (7, "eigenvalue(modified-butterfly, n, 3, 1) = 0"),
            (3, "eigenvalue(catmull-clark, n, 1, 1)*eigenvalue(catmull-clark, n, 1, 2) = 1/16"),
            (3, "limit_weight(catmull-clark, n) = n/(n + 5)"),
            (3, "limit_weight(catmull-clark, n, orbit = edge) = 4/(n*(n + 5))"),
            (3, "limit_weight(catmull-clark, n, orbit = face) = 1/(n*(n + 5))"),
            (3, "limit_weight(loop, n) = 1/(1 + (8/3)*(5/8 - (3/8 + cos(2*pi/n)/4)^2))"),
            (3, "limit_weight(doo-sabin, n) = 1/n"),
            (5, "limit_weight(modified-butterfly, n) = 1"),
            (3, "tangent_weight(loop, n, 1, orbit = edge) = cos(2*pi/n)"),
            (3, "tangent_weight(loop, n, 1) = 0"),
            (3, "tangent_weight(doo-sabin, n, 2) = cos(4*pi/n)"),
            (3, "tangent_weight(loop, n, 2, orbit = edge, tangent = second)^2 = 1 - cos(4*pi/n)^2"),
            (5, "tangent_weight(loop, n, 1, orbit = edge, tangent = second) > 0"),
            (7, "curvature(loop, n, part = hyperbolic) > 1"),
            (3, "curvature(loop, n, part = elliptic) = 1"),
            (4, "curvature(doo-sabin, n) = 1"),
            (5, "curvature(modified-butterfly, n) = 1"),
            (5, "curvature(modified-butterfly, n, part = elliptic) = 1"),
            (4, "curvature(loop-warren, n) >= 4/9"),
        ],
    );
}

/// Square roots in eigenvalues.
#[test]
fn roots() {
    let lambda = "(5 + c + sqrt((9 + c)*(1 + c)))/16";
    for (least, states) in [
        (3, format!("subdominant(catmull-clark, n) = {lambda}")),
        (5, "curvature(catmull-clark, n) > 1".to_owned()),
    ] {
        let found = outcome(FILE, least, &states);
        assert_eq!(found, Outcome::Valid, "{states}: {found:?}");
    }
    for (least, states) in [
        (3, format!("subdominant(catmull-clark, n) = {lambda} + 1/10^6")),
        (5, "curvature(catmull-clark, n) > 1529/1000".to_owned()),
        (5, "curvature(catmull-clark, n) < 1".to_owned()),
    ] {
        let found = outcome(FILE, least, &states);
        assert!(matches!(found, Outcome::Invalid(..)), "{states}: {found:?}");
    }
}

/// Parameters that depend on the valence.
#[test]
fn parameters() {
    are_shown(
        FILE,
        &[
            (3, "limit_weight(loop-weight, n, beta = b) = 1/2"),
            (3, "limit_weight(n, scheme = loop-weight, beta = b) = 1/2"),
            (3, "limit_weight(ball-storry, n, beta = edges, gamma = faces) = n/(n + 5)"),
            (3, "limit_weight(constant, n) = 1/n"),
            (3, "limit_weight(sqrt3-weight, n, alpha = 1/3) = 1/2"),
        ],
    );
    for (scheme, states, holds) in [
        ("loop-weight:beta=3/(8*n)", "limit_weight(n) = 1/2", true),
        ("loop-weight:beta=3/(8*n)", "limit_weight(n) = 1/3", false),
        ("loop-weight:beta=b", "limit_weight(n, orbit = edge) = 1/(2*n)", true),
        ("alias:a=3/8", "limit_weight(n) = 1/2", true),
        ("alias:a=3*n/(8*n)", "limit_weight(n) = 1/2", true),
        ("loop", "subdominant(n) = 3/8 + cos(2*pi/n)/4", true),
        ("loop", "subdominant(n) = subdominant(catmull-clark, n)", false),
        ("loop-weight:beta=limit_weight(n)", "limit_weight(n) > 0", false),
        ("loop-weight:beta=limit_weight(doo-sabin, n)*3/8", "limit_weight(n) = 1/2", true),
        ("loop-weight:beta=1/(n - 100)", "1 = 1", false),
        ("loop-weight:beta=cos(1/n)", "1/n > 0", false),
        ("loop:N=n", "limit_weight(n) > 0", false),
        ("loop-weight:beta=3/(8*n),gamma=1/n", "limit_weight(n) = 1/2", false),
        ("loop-weight", "limit_weight(n) = 1/2", false),
        ("chaikin", "limit_weight(n) = 1/2", false),
        ("chaikin", "sum_rules()/n > 1/n", true),
        ("loop x loop", "limit_weight(n) > 0", false),
    ] {
        let fields = format!("scheme = '{scheme}'\nfor = 'all n >= 3'\nstates = '{states}'");
        let found = relation_of(FILE, &fields, &format!("states {states}\n holds all"));
        assert_eq!(found == Outcome::Valid, holds, "{scheme}: {states}: {found:?}");
    }
}

/// Other indices beside the valence.
#[test]
fn indices() {
    for (k, states, holds) in [
        ("k = 1..6", "eigenvalue(loop, n, k, 1) = 3/8 + cos(2*pi*k/n)/4", true),
        ("k = 0..6", "eigenvalue(loop, n, k, 1) = 3/8 + cos(2*pi*k/n)/4", false),
        ("k = 2, 3", "eigenvalue(doo-sabin, n, k, 1) = 1/4", true),
        ("k = 0..2", "tangent_weight(doo-sabin, n, k) = cos(2*pi*k/n)", true),
        ("k = 15..17", "tangent_weight(doo-sabin, n, k) = cos(2*pi*k/n)", true),
        ("k = 0..2", "tangent_weight(doo-sabin, n, k) = cos(2*pi*(k + 1)/n)", false),
    ] {
        let found = outcome_of("", &format!("['{k}', 'all n >= 13']"), states, "holds all");
        assert_eq!(found == Outcome::Valid, holds, "{k}: {states}: {found:?}");
    }
}

/// What the rules give no value of.
#[test]
fn without_values() {
    for states in [
        "subdominant(butterfly, n) > 0",
        "limit_weight(butterfly, n) > 2",
        "subdominant(kobbelt, n) > 0",
        "eigenvalue(loop, n, 40, 1) > 0",
        "eigenvalue(loop, n, n - 1, 1) = 3/8 + c/4",
        "subdominant(loop, n + 1) = 3/8 + cos(2*pi/(n + 1))/4",
        "limit_weight(loop, 2*n) > 0",
        "limit_weight(loop, n, orbit = face) > 0",
        "curvature(loop, n, part = third) > 0",
        "limit_weight(loop, n, part = both) > 0",
        "eigenvalue(loop, n, 1, 2) > 0",
        "eigenvalue(loop, n, 1, 0) > 0",
        "limit_weight(chaikin, n) > 0",
        "tangent_weight(loop, n, n, orbit = edge) > 0",
        "abs(limit_weight(loop, n), orbit = edge) > 0",
    ] {
        let found = outcome(FILE, 5, states);
        assert_ne!(found, Outcome::Valid, "{states}");
    }
    let found = outcome(FILE, 5, "limit_weight(butterfly, n) = 1");
    assert!(is_incomplete(&found), "{found:?}");
}
