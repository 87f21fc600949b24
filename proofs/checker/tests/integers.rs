//! Functions of an integer: comparisons for all integers from one on.

use crate::masks::relation_of;
use std::time::Instant;
use subcert_check::{Outcome, Reason};

/// The outcome of `holds all` of a statement.
fn outcome(file: &str, of: &str, states: &str) -> Outcome {
    let fields = format!("states = '{states}'\nfor = '{of}'");
    relation_of(file, &fields, &format!("states {states}\n holds all"))
}

#[test]
fn plain() {
    for states in ["sqrt(n^2 + 1) > n", "1/n < 1", "cos(2*pi/n) > 1 - 20/n^2", "max(n, 3) = n"] {
        let start = Instant::now();
        let found = outcome("", "all n >= 3", states);
        println!("{states}: {found:?} {:?}", start.elapsed());
    }
}

#[test]
fn rings() {
    for (m, states) in [
        (3, "subdominant(loop, n) = 3/8 + cos(2*pi/n)/4"),
        (
            3,
            "subdominant(catmull-clark, n) = (5 + cos(2*pi/n) + sqrt((9 + cos(2*pi/n))*(1 + cos(2*pi/n))))/16",
        ),
        (
            3,
            "subdominant(catmull-clark, n) = (5 + cos(2*pi/n) + cos(pi/n)*sqrt(2*(9 + cos(2*pi/n))))/16",
        ),
        (3, "subdominant(doo-sabin, n) = 1/2"),
        (3, "eigenvalue(loop, n, 2, 1) < subdominant(loop, n)"),
        (3, "eigenvalue(catmull-clark, n, 0, 1) = 1"),
        (3, "limit_weight(catmull-clark, n) = n/(n + 5)"),
        (3, "limit_weight(catmull-clark, n, orbit = edge) = 4/(n*(n + 5))"),
        (3, "limit_weight(loop, n) = 1/(1 + (8/3)*(5/8 - (3/8 + cos(2*pi/n)/4)^2))"),
        (3, "limit_weight(doo-sabin, n) = 1/n"),
        (3, "tangent_weight(loop, n, 1) = cos(2*pi/n)"),
        (3, "tangent_weight(catmull-clark, n, 0) = 1"),
        (7, "curvature(loop, n, part = hyperbolic) > 1"),
        (5, "curvature(catmull-clark, n) > 1"),
        (5, "curvature(loop-warren, n) > 0"),
        (3, "curvature(doo-sabin, n) = 1"),
    ] {
        let start = Instant::now();
        let found = outcome("", &format!("all n >= {m}"), states);
        println!("{states}: {found:?} {:?}", start.elapsed());
    }
}
