//! Functions of rings, against facts that are known from elsewhere.

use crate::masks::{outcome, relation_of, values};
use subcert_check::{Outcome, Reason};

/// A ring whose rules are not the same in all sectors, one with a block that is not real, and one with rotated rules.
const RINGS: &str = r"
[[scheme]]
name = 'uneven'
parameters.N = {}
orbits = { edge = 'N' }
edges = [['edge[i]', 'edge[i + 1]']]
weights.edge.edge = 'kronecker(i, j)/2 + kronecker(0, j)/2'
[[scheme]]
name = 'turned'
parameters.n = {}
orbits = { face = 'n' }
edges = [['face[i]', 'face[i + 1]']]
weights.face.face = '(kronecker(i, j) + kronecker(mod(j - i, n), 1))/2'
[[scheme]]
name = 'still'
parameters.n = {}
orbits = { face = 'n' }
edges = [['face[i]', 'face[i + 1]']]
weights.face.face = 'kronecker(i, j)'
[[scheme]]
name = 'spiral'
parameters.N = {}
parameters.a = {}
parameters.b = {}
parameters.c = {}
parameters.d = {}
orbits = { face = 'N', edge = 'N', ray = 'N' }
edges = [['face[i]', 'face[i + 1]'], ['face[i]', 'edge[i]'], ['edge[i]', 'ray[i]']]
weights.face.face = '(3 + 2*cos(2*pi*(j - i)/N))/(4*N) + kronecker(i, j)/4'
weights.edge.edge = 'a*kronecker(i, j)'
weights.edge.ray = 'b*kronecker(i, j)'
weights.edge.face = '(1 - a - b)*kronecker(i, j)'
weights.ray.edge = 'c*kronecker(i, j)'
weights.ray.ray = 'd*kronecker(i, j)'
weights.ray.face = '(1 - c - d)*kronecker(i, j)'
[[scheme]]
name = 'mean'
parameters.N = {}
parameters.w = {}
orbits = { vertex = '1', edge = 'N' }
edges = [['vertex', 'edge[i]']]
weights.vertex.vertex = '1 - w'
weights.vertex.edge = 'w/N'
weights.edge.vertex = '1/2'
weights.edge.edge = 'kronecker(i, j)/2'
";

/// The outcome of a relation about one scheme, with these fields.
fn about(scheme: &str, fields: &str, states: &str, verdict: &str) -> Outcome {
    let fields = format!("scheme = '{scheme}'\nstates = '{states}'\n{fields}");
    relation_of(RINGS, &fields, &format!("states {states}\n {verdict}"))
}

#[test]
fn eigenvalues_of_rings() {
    let mut list = Vec::new();
    for n in 3..=12 {
        list.push((format!("subdominant(loop, {n})"), format!("3/8 + cos(2*pi/{n})/4")));
        list.push((format!("eigenvalue(loop, {n}, 1, 1)"), format!("3/8 + cos(2*pi/{n})/4")));
        let turned = format!("eigenvalue(loop, {n}, {}, 1)", n - 1);
        list.push((turned, format!("3/8 + cos(2*pi/{n})/4")));
        let second = format!("(3/8 + cos(2*pi/{n})/4)^2");
        list.push((format!("eigenvalue(loop, {n}, 0, 2)"), second));
        list.push((format!("curvature(loop, {n}, part = elliptic)"), "1".into()));
        list.push((format!("subdominant({n}, scheme = doo-sabin)"), "1/2".into()));
        list.push((
            format!("curvature({n}, part = hyperbolic, scheme = doo-sabin)"),
            String::new(),
        ));
    }
    // For n = 3 block 2 has no other root.
    list.retain(|(formula, _)| !formula.contains("(3, part = hyperbolic"));
    for (_, value) in list.iter_mut().filter(|(_, value)| value.is_empty()) {
        *value = "1".into();
    }
    let list: Vec<(&str, &str)> = list.iter().map(|(a, b)| (&a[..], &b[..])).collect();
    values(&list);
    values(&[
        ("eigenvalue(loop, 6, 0, 1)", "1"),
        ("eigenvalue(loop, 6, 0, 2)", "1/4"),
        ("eigenvalue(loop, 6, 3, 1)", "1/8"),
        ("curvature(loop, 6)", "1"),
        ("eigenvalue(4, 2, 1, scheme = doo-sabin)", "1/4"),
        ("subdominant(4, scheme = catmull-clark)", "1/2"),
        ("curvature(4, scheme = catmull-clark)", "1"),
        ("curvature(4, part = elliptic, scheme = catmull-clark)", "1"),
        ("curvature(4, part = hyperbolic, scheme = catmull-clark)", "1"),
        ("eigenvalue(4, 0, 2, scheme = catmull-clark)", "1/4"),
        ("eigenvalue(4, 1, 2, scheme = catmull-clark)", "1/8"),
    ]);
}

#[test]
fn limit_weights() {
    let mut list = Vec::new();
    for n in [3, 4, 5, 7, 12] {
        let weight = |orbit: &str| format!("limit_weight({n}{orbit}, scheme = catmull-clark)");
        list.push((weight(""), format!("{n}/({n} + 5)")));
        list.push((weight(", orbit = edge"), format!("4/({n}*({n} + 5))")));
        list.push((weight(", orbit = face"), format!("1/({n}*({n} + 5))")));
        list.push((format!("limit_weight({n}, scheme = doo-sabin)"), format!("1/{n}")));
    }
    list.push(("limit_weight(loop, 6)".into(), "1/2".into()));
    list.push(("limit_weight(loop, 6, orbit = edge)".into(), "1/12".into()));
    let list: Vec<(&str, &str)> = list.iter().map(|(a, b)| (&a[..], &b[..])).collect();
    values(&list);
}

#[test]
fn eigenvalues_of_masks() {
    values(&[
        ("eigenvalue(cubic, 1)", "1"),
        ("eigenvalue(cubic, 2)", "1/2"),
        ("eigenvalue(cubic, 3)", "1/4"),
        ("eigenvalue(four, 3)", "1/4"),
        ("eigenvalue(four, 4)", "1/4"),
        ("eigenvalue(four, 5)", "1/8"),
        ("eigenvalue(daubechies, 1)", "1"),
        ("eigenvalue(daubechies, 2)", "1/2"),
        ("eigenvalue(ternary, 1)", "1"),
    ]);
    for states in
        ["eigenvalue(cubic, 4) = 0", "eigenvalue(cubic, 0) = 0", "eigenvalue(haar, 1) = 1"]
    {
        let found = outcome(states, "holds 1");
        assert!(matches!(found, Outcome::Invalid(..)), "{states}: {found:?}");
    }
}

#[test]
fn the_ring_of_a_claim() {
    let loops = "for = 'n = 3..9'";
    assert_eq!(
        about("loop", loops, "subdominant(n) = 3/8 + cos(2*pi/n)/4", "holds 7"),
        Outcome::Valid
    );
    // The ring depends on the case, and so does the value of a definition.
    let fields = "for = 'q = 1..3'\n[define]\nx = 'eigenvalue(5, 0, 2)'";
    assert_eq!(about("mean:w=q/4", fields, "x = 1/2 - q/4", "holds 3"), Outcome::Valid);
    assert_eq!(
        about("mean:w=1/4", "", "limit_weight(7, orbit = edge) = 1/21", "holds 1"),
        Outcome::Valid
    );
    for (scheme, states) in [
        ("loop", "arity() = 2"),
        ("loop", "eigenvalue(1) = 1"),
        ("four-point:w=1/16", "subdominant(5) = 1"),
        ("uneven", "eigenvalue(5, 0, 1) = 1"),
        ("turned", "eigenvalue(5, 1, 1) = 1"),
        ("loop:N=3", "subdominant(3) = 1/4"),
        ("loop", "limit_weight(3, orbit = face) = 0"),
        ("loop", "curvature(3, part = square) = 0"),
    ] {
        let found = about(scheme, "", states, "holds 1");
        assert!(matches!(found, Outcome::Invalid(..)), "{scheme} {states}: {found:?}");
    }
    // Block 2 of 4 is real.
    assert_eq!(about("turned", "", "eigenvalue(4, 2, 1) = 0", "holds 1"), Outcome::Valid);
    // The roots of its block 1 are not real, so that they are not compared with 1.
    let found = about("turned", "", "limit_weight(4) = 1/4", "holds 1");
    assert!(matches!(found, Outcome::Invalid(..)), "{found:?}");
    let found = about("still", "", "limit_weight(4) = 1/4", "holds 1");
    assert!(matches!(found, Outcome::Invalid(..)), "{found:?}");
}

/// The roots 1/2 and 1/4 of `spiral`, and in all blocks those of ((a, b), (c, d)).
#[test]
fn other_roots() {
    let ring = |parts: &str, states: &str| about(&format!("spiral:{parts}"), "", states, "holds 1");
    for (parts, states) in [
        // 1/8 ± i/16.
        ("a=1/8,b=1/16,c=-1/16,d=1/8", "subdominant(5) = 1/2"),
        ("a=1/8,b=1/16,c=-1/16,d=1/8", "curvature(5) = 1"),
        ("a=1/8,b=1/16,c=-1/16,d=1/8", "eigenvalue(5, 1, 1) = 1/2"),
        // 1/4 ± i/4.
        ("a=1/4,b=1/4,c=-1/4,d=1/4", "subdominant(5) = 1/2"),
        // ±√(1/50) and ±√(2/25).
        ("a=0,b=1/5,c=1/10,d=0", "curvature(5) = 1"),
        ("a=0,b=2/5,c=1/5,d=0", "subdominant(5) = 1/2"),
        // −1/3 and 0.
        ("a=-1/3,b=0,c=0,d=0", "curvature(5) = 4/3"),
        ("a=-1/3,b=0,c=0,d=0", "eigenvalue(5, 1, 3) = -1/3"),
        // −1/3, twice, with one eigenvector.
        ("a=-1/3,b=1,c=0,d=-1/3", "eigenvalue(5, 2, 3) = -1/3"),
        // 1/4 once more.
        ("a=1/4,b=0,c=0,d=0", "eigenvalue(5, 2, 2) = 1/4"),
    ] {
        let found = ring(parts, states);
        assert_eq!(found, Outcome::Valid, "{parts} {states}");
    }
    for (parts, states) in [
        // 1/8 ± i/2: greater than 1/2. 1/4 ± i/4: greater than 1/4.
        ("a=1/8,b=1/2,c=-1/2,d=1/8", "subdominant(5) = 1/2"),
        ("a=1/4,b=1/4,c=-1/4,d=1/4", "curvature(5) = 2"),
        // Exactly 1/2 in absolute value: 3/10 ± 2i/5.
        ("a=3/10,b=2/5,c=-2/5,d=3/10", "subdominant(5) = 1/2"),
    ] {
        let found = ring(parts, states);
        let Outcome::Incomplete(Some(rejection)) = &found else {
            panic!("{parts} {states}: {found:?}")
        };
        assert!(matches!(rejection.reason, Reason::Stopped(_)), "{parts} {states}: {found:?}");
    }
    for (parts, states) in [
        // No limit, or none that is unique.
        ("a=1,b=0,c=0,d=0", "limit_weight(5) = 0"),
        ("a=-1,b=0,c=0,d=0", "limit_weight(5) = 0"),
        ("a=-1/2,b=0,c=0,d=0", "subdominant(5) = 1/2"),
        ("a=1/2,b=0,c=0,d=0", "subdominant(5) = 1/2"),
        ("a=0,b=1/2,c=1/2,d=0", "subdominant(5) = 1/2"),
        ("a=0,b=1,c=1,d=0", "subdominant(5) = 1"),
        ("a=1,b=0,c=0,d=0", "curvature(5) = 4"),
        // √(3/10) > 1/2, and −√(3/10).
        ("a=0,b=1/2,c=3/5,d=0", "subdominant(5) = 1/2"),
        ("a=1/8,b=1/16,c=-1/16,d=1/8", "eigenvalue(5, 1, 2) = 1/8"),
    ] {
        let found = ring(parts, states);
        assert!(matches!(found, Outcome::Invalid(..)), "{parts} {states}: {found:?}");
    }
}

#[test]
fn what_is_no_eigenvalue() {
    for states in [
        "subdominant(loop, 2) = 0",
        "subdominant(loop, 101) = 0",
        "subdominant(loop, 7/2) = 0",
        "eigenvalue(loop, 5, 5, 1) = 0",
        "eigenvalue(loop, 5, -1, 1) = 0",
        "eigenvalue(loop, 5, 1, 0) = 0",
        "eigenvalue(loop, 5, 1, 2) = 0",
        "eigenvalue(loop, 5, 0, 3) = 0",
        "subdominant(cubic, 5) = 0",
        "subdominant(loop) = 0",
        "subdominant(loop, 5, part = both) = 0",
        "curvature(5, part = elliptic, scheme = doo-sabin) = 0",
    ] {
        let found = outcome(states, "holds 1");
        assert!(matches!(found, Outcome::Invalid(..)), "{states}: {found:?}");
    }
}
