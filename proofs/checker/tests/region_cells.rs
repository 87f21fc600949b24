//! Regions that are cut along the lines where coefficients vanish.
//!
//! The norm of `cross` is |x| + |y|, or (1 − x − y)/2 or (1 + x + y)/2; that of `turned` is |x + y| + |x − y|, or |1 − 2x|/2. The norm of
//! `fan` is 1/2 and sums of some |y − ix|/100000.

use crate::regions::{about, judged};
use subcert_check::Outcome;

const SCHEMES: &str = "
[[scheme]]
name = 'cross'
arity = '3'
symbol = '(1 + z + z^2)*(a + (1 - a - b)/2*z + (1 - a - b)/2*z^2 + b*z^3)'
parameters.a = {}
parameters.b = {}
[[scheme]]
name = 'turned'
arity = '3'
symbol = '(1 + z + z^2)*(a + b + (1 - 2*a)/2*z + (1 - 2*a)/2*z^2 + (a - b)*z^3)'
parameters.a = {}
parameters.b = {}
[[scheme]]
name = 'fan'
symbol = '(1 + z)*((z^-40 + z^-39)/2 + sum(i = 1..n, (b - i*a)/100000*(z^(i - 35) - z^(i + n - 35))))'
parameters.a = {}
parameters.b = {}
parameters.n = {}
";

fn of(scheme: &str, bounds: &[&str], levels: usize) -> Outcome {
    let (fields, head) = about(scheme, "0", bounds);
    let lines = format!("{head} contraction {levels}\n confirmed");
    judged(SCHEMES, &fields, &lines).expect("a claim file")
}

/// The region where a norm is below 1, to its very border.
#[test]
fn regions_that_are_sharp() {
    let (cross, turned) = ("cross:a=x,b=y", "turned:a=x,b=y");
    for (scheme, bounds, right) in [
        (cross, &["abs(x) + abs(y) < 1"][..], true),
        (cross, &["abs(x) + abs(y) <= 1"], false),
        (cross, &["abs(x) + abs(y) < 1 + 10^-30"], false),
        (cross, &["abs(x + y) <= 1", "abs(x - y) < 1"], false),
        (cross, &["x > 0", "y > 0", "x + y < 1"], true),
        (cross, &["x >= 0", "y >= 0", "x + y < 1"], true),
        (cross, &["x >= 0", "y >= 0", "x + y <= 1"], false),
        ("cross:a=2*x,b=y/3", &["2*abs(x) + abs(y)/3 < 1"], true),
        ("cross:a=x-1/7,b=y+2/9", &["abs(x - 1/7) + abs(y + 2/9) < 1"], true),
        ("cross:a=x-1/7,b=y+2/9", &["abs(x - 1/7) + abs(y + 2/9) < 100001/100000"], false),
        (turned, &["max(abs(x), abs(y)) < 1/2"], true),
        (turned, &["abs(x) < 1/2", "abs(y) <= 1/2"], false),
        (turned, &["abs(x) <= 1/2", "abs(y) < 1/2"], false),
        (turned, &["max(abs(x), abs(y)) < 0.501"], false),
        // Without lines the triangles are cut themselves.
        ("cross:a=x*abs(2),b=y^2", &["2*abs(x) < 1/2", "y^1 < 1/2", "y > -1/2"], true),
        ("cross:a=0,b=0", &["abs(x) + abs(y) < 1"], true),
        ("cross:a=1,b=0", &["abs(x) + abs(y) < 1"], false),
    ] {
        let found = of(scheme, bounds, 1);
        assert_eq!(found == Outcome::Valid, right, "{scheme} {bounds:?}: {found:?}");
        assert!(matches!(found, Outcome::Valid | Outcome::Invalid(..)), "{found:?}");
    }
}

/// Lines that only touch the region, run along its border or are equal to others.
#[test]
fn lines_at_the_border() {
    for bounds in [
        &["0 <= x", "0 <= y", "x + y < 1"][..],
        &["x > 0", "y < 0", "x - y < 1"],
        &["0 < x < 1/4", "x < y < 1 - x"],
        &["0 < x < 1/2", "-1/2 < y < 1/2"],
        &["-1/2 < x < 1/2", "0 <= y < 1/2"],
    ] {
        assert_eq!(of("cross:a=x,b=y", bounds, 1), Outcome::Valid, "{bounds:?}");
        assert_eq!(of("cross:a=x,b=-x", &["abs(x) < 1/2", "abs(y) < 7"], 1), Outcome::Valid);
    }
}

/// At most 32 different lines.
#[test]
fn many_lines() {
    for n in [1, 5, 32] {
        assert_eq!(of(&format!("fan:a=x,b=y,n={n}"), &["abs(x) + abs(y) < 1"], 1), Outcome::Valid);
    }
    let found = of("fan:a=x,b=y,n=33", &["abs(x) + abs(y) < 1"], 1);
    assert!(matches!(found, Outcome::Incomplete(Some(_))), "{found:?}");
}
