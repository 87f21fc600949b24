//! Rings with other rules from the valence 16 on, which is the first one that the rules of functions have to decide.

use super::{is_incomplete, outcome, outcome_of};
use subcert_check::Outcome;

/// Loop's ring with more weights, which `on` switches on.
fn file(changes: &[(&str, &str)]) -> String {
    let mut formulas = vec![
        ("vertex.vertex", "1 - N*beta".to_owned()),
        ("vertex.edge", "beta".to_owned()),
        ("edge.vertex", "3/8".to_owned()),
        (
            "edge.edge",
            "(3*kronecker(turn, 0) + kronecker(turn, 1) + kronecker(turn, N - 1))/8".to_owned(),
        ),
        ("beta", "3/(8*N)".to_owned()),
    ];
    for (name, more) in changes {
        for (known, formula) in &mut formulas {
            if known == name {
                *formula = format!("{formula} + ({more})");
            }
        }
    }
    let mut text =
        "[[scheme]]\nname = 's'\nparameters.N = {}\norbits = { vertex = '1', edge = 'N' }\n\
        edges = [['vertex', 'edge[i]'], ['edge[i]', 'edge[i + 1]']]\n"
            .to_owned();
    for (name, formula) in &formulas[..4] {
        text.push_str(&["weights.", name, " = '", formula, "'\n"].concat());
    }
    let beta = &formulas[4].1;
    text + &format!(
        "[scheme.let]\nturn = 'mod(j - i, N)'\non = '1 - kronecker(max(N - 15, 0), 0)'\nbeta = '{beta}'\n"
    )
}

/// The outcome of `holds all` of so many statements, each of which is true of the first valences.
fn found(changes: &[(&str, &str)], count: usize) -> Vec<Outcome> {
    let file = file(changes);
    let states = &[
        "limit_weight(s, n) = 1/2",
        "subdominant(s, n) = 3/8 + cos(2*pi/n)/4",
        "eigenvalue(s, n, 2, 1) <= 5/8",
        "tangent_weight(s, n, 1, orbit = edge) = cos(2*pi/n)",
        "curvature(s, n, part = hyperbolic) > 0",
    ][..count];
    for states in states {
        let first = outcome_of(&file, "'n = 4..15'", states, "holds 12");
        assert_eq!(first, Outcome::Valid, "{changes:?}: {states}");
    }
    states.iter().map(|states| outcome(&file, 4, states)).collect()
}

/// Changes that are none, and such that only later valences would have.
#[test]
fn same_rules() {
    for changes in [
        &[][..],
        &[("beta", "on*0")],
        &[("edge.edge", "on*(i - i)")],
        &[("edge.edge", "on*(kronecker(turn, 2) - kronecker(j - i, 2) - kronecker(j - i + N, 2))")],
        &[("edge.edge", "on*(kronecker(2*j, 2*i + 2) - kronecker(j - 1, i))")],
        &[("edge.edge", "on*(cos(2*pi*turn/N) - cos(2*pi*(j - i)/N))")],
        &[("edge.edge", "sum(k = 1..2, kronecker(turn, k) - kronecker(k, turn))")],
    ] {
        for found in found(changes, 5) {
            assert_eq!(found, Outcome::Valid, "{changes:?}");
        }
    }
}

/// Weights that the rules do not take.
#[test]
fn other_rules() {
    for change in [
        // Not by the text, although the sums of rows are the same.
        "on*(kronecker(i, 0) - kronecker(j, 0))",
        "on*(kronecker(i, 0) - kronecker(i, 0))",
        "on*(kronecker(mod(i, N), mod(j, N)) - kronecker(i, j))",
        "on*(kronecker(i + j, 7) - kronecker(turn, 7))",
        "on*sum(j = 1..2, kronecker(j, 3))",
        "on*(kronecker(i, 30) - kronecker(i, 31))",
        "kronecker(i, 30)",
        // Another weight a full turn later.
        "on*(kronecker(j - i, 1) - kronecker(j - i, 2))",
        "on*(kronecker(j - i, 1) - kronecker(turn, 1))",
        "on*(kronecker(j - i, -1) - kronecker(turn, N - 1))",
        "on*(kronecker(j - i, 0) - 1/N)*(j - i)",
        "on*cos(pi*(j - i)/N)/10",
        // Rows that do not sum to 1.
        "on/10",
        "on*kronecker(turn, 1)/10",
        "on*cos(0*turn)/N^2",
        "on*(turn - turn + 1/N^3)",
        // Places far away, and cosines of too many turns.
        "on*(kronecker(turn, 7) - kronecker(turn, 8))",
        "kronecker(turn, 28) - kronecker(turn, 29)",
        "kronecker(j - i, 28)",
        "on*cos(14*pi*turn/N)/N",
        "on*turn*(N - turn)",
        "on*(cos(2*pi*turn/N)^7 - 35/64*cos(2*pi*turn/N))/N",
        "on*sqrt(turn)*0",
        "on*max(0, 9 - turn)*0",
        // What becomes something else later.
        "kronecker(N, 60)*(kronecker(turn, 1) - kronecker(turn, 2))",
        "max(N - 60, 0)*(kronecker(turn, 1) - kronecker(turn, 2))",
        "floor(N/28)*(kronecker(turn, 1) - kronecker(turn, 2))*max(60 - N, 0)",
        "0/(N - 60)",
        "sum_rules(chaikin)*0",
    ] {
        for found in found(&[("edge.edge", change)], 2) {
            assert_ne!(found, Outcome::Valid, "{change}");
            assert!(is_incomplete(&found), "{change}: {found:?}");
        }
    }
    for (name, change) in [
        ("edge.vertex", "on/10"),
        ("edge.vertex", "i - i"),
        ("edge.vertex", "on*kronecker(j, 0)*0"),
        ("vertex.edge", "on*(1/N - kronecker(j, 0))"),
        ("vertex.vertex", "on/10"),
        ("vertex.vertex", "i*0"),
        ("beta", "1/(N - 100) - 1/(N - 100)"),
    ] {
        for found in found(&[(name, change)], 1) {
            assert!(is_incomplete(&found), "{name}: {change}: {found:?}");
        }
    }
}

/// Other values, which the rules show, or do not decide.
#[test]
fn other_values() {
    // Which of the five statements still hold.
    for (changes, hold) in [
        // The other root of block 0 is 5/8, and greater than λ.
        (&[("beta", "-on*3/(8*N)")][..], [false, false, true, false, false]),
        // Here it is negative.
        (&[("beta", "on/N")], [false, false, true, false, false]),
        (&[("beta", "on/(100*N)")], [false, true, true, true, true]),
        // λ is less, or greater.
        (
            &[(
                "edge.edge",
                "on*(kronecker(turn, 0) - kronecker(turn, 1)/2 - kronecker(turn, N - 1)/2)/9",
            )],
            [true, false, true, true, true],
        ),
        // Blocks that are not real.
        (
            &[("edge.edge", "on*(kronecker(turn, 1) - kronecker(turn, N - 1))/8")],
            [false, false, false, false, false],
        ),
        // A root −λ of later blocks.
        (
            &[(
                "edge.edge",
                "on*(kronecker(turn, 1) + kronecker(turn, N - 1) - 2*kronecker(turn, 0))/4",
            )],
            [true, false, true, false, false],
        ),
        // One of block 3, which is greater than 1 from some valence on.
        (&[("edge.edge", "on*2*cos(6*pi*turn/N)/N/2")], [false, false, true, false, false]),
        // No weights of edges but those of cosines: λ = 1.
        (
            &[(
                "edge.edge",
                "on*(2*cos(2*pi*turn/N)/N - (3*kronecker(turn, 0) + kronecker(turn, 1) + kronecker(turn, N - 1))/8 + 5/(8*N))",
            )],
            [false, false, true, false, false],
        ),
    ] {
        let found = found(changes, 5);
        for (place, (found, hold)) in found.iter().zip(hold).enumerate() {
            assert_eq!(*found == Outcome::Valid, hold, "{changes:?}: {place}: {found:?}");
        }
    }
}
