//! Rings whose weights are those of a lattice.

use subcert_check::{Outcome, check};

/// The rules of Catmull and Clark, with one number more, and those of the lattice around them.
const SCHEMES: &str = "
[[scheme]]
name = 'shifted'
parameters.N = {}
parameters.e = {}
orbits = { vertex = '1', edge = 'N', face = 'N' }
edges = [['vertex', 'edge[i]'], ['edge[i]', 'face[i]']]
weights.vertex.vertex = '1 - 7/(4*N) - 2*e'
weights.vertex.edge = '3/(2*N^2) + 2*e/N'
weights.vertex.face = '1/(4*N^2)'
weights.edge.vertex = '3/8'
weights.edge.edge = '3/8*kronecker(i, j) + 1/16*(kronecker(mod(i + 1, N), j) + kronecker(mod(i - 1, N), j))'
weights.edge.face = '1/16*(kronecker(i, j) + kronecker(mod(i - 1, N), j))'
weights.face.vertex = '1/4'
weights.face.edge = '1/4*(kronecker(i, j) + kronecker(mod(i + 1, N), j))'
weights.face.face = '1/4*kronecker(i, j)'
";

/// The outcome of a claim with these fields and lines.
fn smoothness(scheme: &str, fields: &[(&str, &str)], lines: &str) -> Outcome {
    let mut claims =
        format!("key = 'k'\n{SCHEMES}\n[[smoothness]]\nid = 's'\nscheme = '{scheme}'\n");
    let mut head = format!("scheme {scheme}\n");
    for (name, value) in fields {
        let field = format!("{name} = '{value}'\n");
        claims.push_str(&field);
        let word = match *name {
            "continuous" => "states-continuous",
            "not_continuous" => "states-not-continuous",
            name => name,
        };
        let line = format!(" {word} {value}\n");
        head.push_str(&line);
    }
    let text = format!("subcert-certificate 4\npaper k\nsmoothness s\n {head} {lines}\nend 1\n");
    let report = check(&claims, &[&text]).expect("a claim file");
    assert!(report.broken.is_empty(), "{:?}", report.broken);
    report.claims.into_iter().next().expect("a claim").2
}

fn regular(n: &str, part: &str) -> String {
    format!("vertex {n}\n part {part}\n regular")
}

#[test]
fn what_is_regular() {
    for (scheme, n, part) in [
        ("catmull-clark", "4", "bicubic"),
        ("loop", "6", "box-spline"),
        ("shifted:e=0", "4", "bicubic"),
        ("loop-weight:beta=1/16", "6", "box-spline"),
    ] {
        let lines = regular(n, part);
        for m in ["0", "1", "2", "3"] {
            for (field, true_word, false_word) in
                [("continuous", "confirmed", "refuted"), ("not_continuous", "refuted", "confirmed")]
            {
                let fields = [(field, m), ("valences", n)];
                for (word, right) in [(true_word, m != "3"), (false_word, false)] {
                    let found = smoothness(scheme, &fields, &format!("{lines}\n {word}"));
                    assert_eq!(
                        found == Outcome::Valid,
                        right,
                        "{scheme} {field} {m} {word}: {found:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn what_is_not_regular() {
    for (scheme, n, part) in [
        ("loop-weight:beta=1/15", "6", "box-spline"),
        ("catmull-clark", "5", "bicubic"),
        ("catmull-clark", "3", "bicubic"),
        ("loop", "5", "box-spline"),
        ("loop", "6", "bicubic"),
        ("catmull-clark", "4", "box-spline"),
        ("doo-sabin", "4", "biquadratic"),
        ("shifted:e=1/1000", "4", "bicubic"),
        ("shifted:e=0", "5", "bicubic"),
        ("catmull-clark", "6", "bicubic"),
    ] {
        for m in ["0", "1", "2"] {
            let fields = [("continuous", m), ("valences", n)];
            let found = smoothness(scheme, &fields, &format!("{}\n confirmed", regular(n, part)));
            assert!(matches!(found, Outcome::Invalid(..)), "{scheme} {n}: {found:?}");
        }
    }
}

/// The line stands alone, and shows one valence.
#[test]
fn lines_of_regular_vertices() {
    let fields = [("continuous", "2"), ("valences", "4")];
    let right = regular("4", "bicubic");
    for lines in [
        right.replace("regular", "regular 2"),
        right.replace("regular", "regular\n regular"),
        right.replace("regular", "regular\n eigenvalue 1 0.4 0.6"),
        right.replace("regular", "diverges 1 +"),
        right.replace("vertex 4", "vertex 5"),
        right.replace(" part bicubic\n", ""),
        format!("{right}\n {right}"),
    ] {
        let found = smoothness("catmull-clark", &fields, &format!("{lines}\n confirmed"));
        assert!(matches!(found, Outcome::Invalid(..)), "{lines}: {found:?}");
    }
    for valences in ["3..4", "4..5", "all"] {
        let fields = [("continuous", "2"), ("valences", valences)];
        let found = smoothness("catmull-clark", &fields, &format!("{right}\n confirmed"));
        assert!(matches!(found, Outcome::Invalid(..)), "{valences}: {found:?}");
        // One valence refutes.
        let fields = [("not_continuous", "2"), ("valences", valences)];
        let found = smoothness("catmull-clark", &fields, &format!("{right}\n refuted"));
        assert_eq!(found, Outcome::Valid, "{valences}");
    }
}
