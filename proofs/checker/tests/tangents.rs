//! Weights of the tangents at the vertices of rings.

use crate::masks::{outcome, relation_of, values};
use subcert_check::Outcome;

/// The tangents of Loop's and of Doo and Sabin's surfaces, and the known ones of Catmull and Clark's.
#[test]
fn known_weights() {
    let mut list = Vec::new();
    for n in [3, 4, 5, 6, 7] {
        for j in [0, 1, 2, 5] {
            for (ring, orbit) in
                [("loop", "edge"), ("doo-sabin", "face"), ("catmull-clark", "edge")]
            {
                let call = |tangent: &str| {
                    format!("tangent_weight({n}, {j}, orbit = {orbit}{tangent}, scheme = {ring})")
                };
                list.push((call(""), format!("cos(2*pi*{j}/{n})")));
                list.push((call(", tangent = second"), format!("cos(2*pi*{j}/{n} - pi/2)")));
            }
        }
        list.push((format!("tangent_weight(loop, {n}, 1)"), "0".into()));
        list.push((
            format!(
                "tangent_weight({n}, 2, orbit = vertex, tangent = second, scheme = catmull-clark)"
            ),
            "0".into(),
        ));
    }
    list.push(("tangent_weight(4, 0, orbit = face, scheme = catmull-clark)".into(), "1/4".into()));
    list.push(("tangent_weight(4, 1, orbit = face, scheme = catmull-clark)".into(), "-1/4".into()));
    list.push((
        "tangent_weight(4, 0, orbit = face, tangent = second, scheme = catmull-clark)".into(),
        "1/4".into(),
    ));
    list.push(("tangent_weight(doo-sabin, 5, 1)".into(), "cos(2*pi/5)".into()));
    let list: Vec<(&str, &str)> = list.iter().map(|(a, b)| (&a[..], &b[..])).collect();
    values(&list);
}

/// Those of faces need a square root of a number of the field.
#[test]
fn weights_of_faces() {
    for n in [3, 5] {
        for j in [0, 1] {
            let unit = format!("(1 + cos(2*pi/{n}) + cos(pi/{n})*sqrt(2*(9 + cos(2*pi/{n}))))");
            let sum = format!("cos(2*pi*{j}/{n}) + cos(2*pi*({j} + 1)/{n})");
            let call = format!("tangent_weight({n}, {j}, orbit = face, scheme = catmull-clark)");
            let found = outcome(&format!("{call}*{unit} = {sum}"), "holds 1");
            assert_eq!(found, Outcome::Valid, "{n} {j}");
            for states in [format!("{call}*{unit} = {sum} + 10^-20"), format!("{call} = 1/4")] {
                let found = outcome(&states, "holds 1");
                assert!(matches!(found, Outcome::Invalid(..)), "{states}: {found:?}");
            }
        }
    }
}

#[test]
fn what_is_no_weight() {
    for states in [
        "tangent_weight(loop, 5, 101) = 0",
        "tangent_weight(loop, 5, -1) = 0",
        "tangent_weight(loop, 5, 1/2) = 0",
        "tangent_weight(loop, 2, 0) = 0",
        "tangent_weight(loop, 5) = 0",
        "tangent_weight(5, 0, orbit = face, scheme = loop) = 0",
        "tangent_weight(5, 0, tangent = third, scheme = loop) = 0",
        "tangent_weight(5, 0, part = both, scheme = loop) = 0",
        "tangent_weight(cubic, 5, 0) = 0",
        "limit_weight(5, tangent = first, scheme = loop) = 0",
    ] {
        let found = outcome(states, "holds 1");
        assert!(matches!(found, Outcome::Invalid(..)), "{states}: {found:?}");
    }
}

/// Rules that turn, and an eigenvector that is 0 on the first orbit.
#[test]
fn rules_that_turn() {
    let rings = r"
[[scheme]]
name = 'lower'
parameters.N = {}
orbits = { far = 'N', near = 'N' }
edges = [['near[i]', 'near[i + 1]'], ['near[i]', 'far[i]']]
weights.near.near = '(3 + 2*cos(2*pi*(j - i)/N))/(4*N) + kronecker(i, j)/4'
weights.far.near = '7/8*kronecker(mod(i + 1, N), j)'
weights.far.far = 'kronecker(i, j)/8'
[[scheme]]
name = 'upper'
parameters.N = {}
orbits = { far = 'N', near = 'N' }
edges = [['near[i]', 'near[i + 1]'], ['near[i]', 'far[i]']]
weights.near.near = 'kronecker(i, j)/8'
weights.near.far = '7/8*kronecker(mod(i + 1, N), j)'
weights.far.far = '(3 + 2*cos(2*pi*(j - i)/N))/(4*N) + kronecker(i, j)/4'
";
    let about = |states: &str| {
        relation_of(rings, &format!("states = '{states}'"), &format!("states {states}\n holds 1"))
    };
    for states in [
        // M_1 is ((1/8, 7ω/8), (0, 1/2)): û = (0, 1).
        "tangent_weight(lower, 5, 3) = 0",
        "tangent_weight(5, 3, orbit = near, scheme = lower) = cos(6*pi/5)",
        "tangent_weight(5, 3, orbit = near, tangent = second, scheme = lower) = cos(6*pi/5 - pi/2)",
        // M_1 is ((1/2, 0), (7ω/8, 1/8)): û = (1, 0).
        "tangent_weight(upper, 5, 3) = cos(6*pi/5)",
        "tangent_weight(5, 3, orbit = near, scheme = upper) = 0",
    ] {
        assert_eq!(about(states), Outcome::Valid, "{states}");
    }
    for states in
        ["tangent_weight(lower, 5, 3) = 1", "tangent_weight(upper, 5, 3) = cos(4*pi/5) + 1"]
    {
        assert!(matches!(about(states), Outcome::Invalid(..)), "{states}");
    }
}
