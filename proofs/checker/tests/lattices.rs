//! Masks on Z^d, against facts that are known from elsewhere.

mod false_limits;
mod false_tiles;
mod limits;
mod ranges;
mod refused;

use crate::masks::relation_of;
use subcert_check::Outcome;

/// Schemes with their masks. The first ones are box splines, and `butterfly` interpolates.
pub const SCHEMES: &str = "
[[scheme]]
name = 'three'
symbol = '(1+x)*(1+y)*(1+x*y)/2'
edges = [[1, 0], [0, 1], [1, 1]]
[[scheme]]
name = 'box'
box = [[1, 0], [1, 0], [0, 1], [0, 1], [1, 1], [1, 1]]
[[scheme]]
name = 'six'
symbol = '(1+x)^2*(1+y)^2*(1+x*y)^2/16'
[[scheme]]
name = 'four'
symbol = '(1+x)*(1+y)*(1+x*y)*(1+x/y)/4'
[[scheme]]
name = 'tensor'
symbol = '(1+x)^4*(1+y)^4/64'
[[scheme]]
name = 'smooth'
symbol = '(3-(x+1/x+y+1/y)/2)*(1+x)^2*(1+y)^2*(1+x*y)*(1+x/y)/16'
[[scheme]]
name = 'quincunx'
symbol = '(1+x)*(1+y)/2'
dilation = [[1, 1], [1, -1]]
[[scheme]]
name = 'pyramid'
symbol = '1+(x+1/x+y+1/y)/4'
dilation = [['1', '1'], ['1', '-1']]
[[scheme]]
name = 'root-three'
symbol = '1+(x+1/x+y+1/y+x/y+y/x)/3'
dilation = [[1, 2], [-2, -1]]
edges = [[1, 0], [0, 1], [1, -1]]
[[scheme]]
name = 'mixed'
symbol = '(1+x)^2*(1+y+y^2)^2/6'
dilation = [[2, 0], [0, 3]]
[[scheme]]
name = 'cube'
symbol = '(1+x)*(1+y)*(1+z)*(1+x*y*z)/2'
edges = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]
[[scheme]]
name = 'wide'
symbol = '(1+x^3)^2*(1+y)^2/4'
[[scheme]]
name = 'hat'
symbol = '(1 + z)^2/(2*z)'
[[scheme]]
name = 'product'
let = { u = 'symbol(hat, x)', half = '1/2' }
symbol = 'half*2*u*symbol(hat, y)'
[[scheme]]
name = 'listed'
mask = '[[1, 2, 1], [2, 4, 2], [1, 2, 1]]/4'
[[scheme]]
name = 'rows'
mask = [['1/4', '1/2', '1/4'], ['1/2', '1', '1/2'], ['1/4', '1/2', '1/4']]
origin = [1, 1]
[[scheme]]
name = 'moved'
mask = '1/4*[[1, 2, 1], [2, 4, 2], [1, 2, 1]]'
origin = ['-2', '0']
[[scheme]]
name = 'deep'
mask = '[[[1, 1], [1, 1]], [[1, 1], [1, 1]]]'
[[scheme]]
name = 'twice'
symbol = 'symbol(three)*symbol(three)/4'
dilation = [[2, 0], [0, 2]]
[[scheme]]
name = 'alias'
use = 'six'
[[scheme]]
name = 'tension'
symbol = 'symbol(three) + w*(1 - x^2)*(1 - y^2)'
parameters.w = {}
[[scheme]]
name = 'stretched'
symbol = '(1+x)*(1+y)*(1+x*y)/2'
edges = [[1, 0], [0, 1], [1, 2]]
[[scheme]]
name = 'crooked'
symbol = '(1+x)^2*(1+y)^2*(1+x*y)^2/16'
edges = [[3, 1], [2, 1]]
[[scheme]]
name = 'skew'
symbol = 'symbol(six) + (1 - 2*x^2 + x^2*y^2)/8 + (x*y^2 - x^3*y^4)/3 + 2/5*(y^3 - x^4*y)'
[[scheme]]
name = 'skew-steep'
symbol = 'symbol(skew)'
edges = [[1, 0], [0, 1], [1, 2]]
dilation = [[2, 0], [0, 2]]
[[scheme]]
name = 'skew-steeper'
symbol = 'symbol(skew)'
edges = [[1, 0], [1, 1], [-2, -3], [2, 3]]
[[scheme]]
name = 'tall'
box = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]
dilation = [[2, 0, 0], [0, 2, 0], [0, 0, 2]]
[[scheme]]
name = 'turned'
box = [[1, 0], [1, 1], [0, 1], [-1, 1]]
dilation = [[1, -1], [1, 1]]
[[scheme]]
name = 'lines'
box = [[1, 0], [3, 0], [0, 1]]
";

/// The outcome of a relation with these statements, and lines of its certificate.
pub fn outcome(fields: &str, states: &[&str], lines: &str) -> Outcome {
    let texts: Vec<String> = states.iter().map(|text| format!("'{text}'")).collect();
    let restated: Vec<String> = states.iter().map(|text| format!("states {text}\n ")).collect();
    let fields = format!("{fields}\nstates = [{}]", texts.join(", "));
    relation_of(SCHEMES, &fields, &format!("{}{lines}", restated.concat()))
}

/// Checks that formulas of a scheme, between semicolons, have these values, and no others.
fn all(scheme: &str, formulas: &str) {
    let formulas: Vec<&str> = formulas.split(';').map(str::trim).collect();
    let holds = format!("holds {}", formulas.len());
    let fields = format!("scheme = '{scheme}'");
    assert_eq!(outcome(&fields, &formulas, &holds), Outcome::Valid, "{scheme}");
    for formula in formulas {
        let other = format!("{formula} + 1");
        assert_eq!(
            outcome(&fields, &[&other], "fails 1\n case = -1"),
            Outcome::Valid,
            "{scheme}: {formula}"
        );
    }
}

#[test]
fn examples() {
    let thrice = "contraction() = 1/2; contraction(2) = 1/4; contraction(3) = 1/8";
    all("three", &format!("sum_rules() = 2; interpolating() = 1; arity() = 4; {thrice}"));
    all("box", "sum_rules() = 4; same(with = six) = 1; generation() = 3");
    all("four", "sum_rules() = 2");
    all("tensor", "sum_rules() = 4; approximation_order(data = adapted) = 4");
    all(
        "smooth",
        "sum_rules() = 4; reproduction() = 3; approximation_order() = 4; contraction(1) = 7/8; \
         contraction(2) = 29/64; contraction(3) = 1861/8192",
    );
    all(
        "quincunx",
        "sum_rules() = 2; contraction() = 1; contraction(2) = 1/2; contraction(3) = 1/2; \
         contraction(4) = 1/4; arity() = 2",
    );
    all(
        "pyramid",
        "sum_rules() = 2; contraction() = 1; contraction(2) = 3/4; contraction(3) = 5/8; \
         contraction(4) = 1/2; interpolating() = 1",
    );
    all(
        "root-three",
        "sum_rules() = 2; contraction() = 2/3; contraction(2) = 4/9; contraction(3) = 8/27",
    );
    all("mixed", &format!("sum_rules() = 2; arity() = 6; {thrice}"));
    all("cube", &format!("sum_rules() = 2; arity() = 8; {thrice}"));
    all("wide", "contraction() = 3/2; contraction(0) = 1; norm(0) = 1; norm(2) = 1");
}

#[test]
fn other_values() {
    all(
        "six",
        "coefficient(0, 0) = 1/16; coefficient(2, 2) = 10/16; coefficient(5, 0) = 0; \
         coefficient(-1, 1000000) = 0; symmetric() = 1; interpolating() = 0; reproduction() = 1; \
         approximation_order() = 2; same(with = alias) = 1; same(with = three) = 0; \
         same(with = hat) = 0; same(with = quincunx) = 0; norm(2) = 1; \
         sum(i = 0..4, sum(j = 0..4, coefficient(i, j))) = 4",
    );
    all("twice", "same(with = six) = 1; coefficient(0, 0) = 1/16; same(with = alias) = 1");
    all("product", "same(with = listed) = 1; same(with = rows) = 1; same(with = moved) = 0");
    all("moved", "coefficient(3, 1) = 1; coefficient(2, 0) = 1/4; sum_rules() = 2");
    all("deep", "coefficient(1, 1, 0) = 1; coefficient(2, 0, 0) = 0; sum_rules() = 1; arity() = 8");
    all("tall", "same(with = cube) = 1; symmetric() = 1");
    all(
        "turned",
        "coefficient(-1, 0) = 1/2; coefficient(-2, 1) = 1/2; sum_rules() = 2; norm() = 1",
    );
    all("lines", "coefficient(4, 0) = 1/2; coefficient(1, 1) = 1/2; coefficient(2, 0) = 0");

    all("listed", "contraction() = 1/2; norm() = 1; reproduction() = 1; symmetric() = 1");
}

/// Values by another program, with flows on large parts of Z^d. Shortest ways along these edges leave the boxes around their ends.
#[test]
fn edges() {
    all("stretched", "contraction() = 3/2; contraction(2) = 3/4");
    all("crooked", "contraction() = 3/2");
    all(
        "skew",
        "contraction() = 73/40; contraction(2) = 4241/3200; norm() = 9/5; norm(2) = 141/80",
    );
    all("skew-steep", "contraction() = 73/40; same(with = skew) = 1");
    all("skew-steeper", "contraction() = 27/10");
}

/// Coefficients of any kind stand in `coefficient` alone, also in equations and on pieces.
#[test]
fn parameters() {
    let of = |fields: &str, states: &str, lines: &str| outcome(fields, &[states], lines);
    for (fields, states, lines) in [
        ("symbols = ['u']", "coefficient(tension, 2, 2, w = u) = u + 1/2", "holds 1"),
        ("symbols = ['u']", "coefficient(tension, 2, 0, w = u) = u", "fails 1\n case = -2*u"),
        ("for = 'n = 1..3'", "coefficient(tension, 0, 0, w = n) = 1/2 + n", "holds 3"),
        ("scheme = 'tension:w=1/2'", "contraction() <= 3", "holds 1"),
        ("for = 'real v'", "coefficient(tension, 0, 0, w = v) > v", "holds reals"),
        ("for = 'real v'", "v^2 + contraction(three) > 1/3", "holds reals"),
        ("for = 'all n'", "n/2 >= contraction(three)", "holds all"),
        ("", "coefficient(tension, 0, 0, w = 2) = 5/2", "holds 1"),
        ("scheme = 'alias'", "sum_rules() = 4", "holds 1"),
    ] {
        assert_eq!(of(fields, states, lines), Outcome::Valid, "{fields}: {states}");
    }
    for (fields, states) in [
        ("symbols = ['u']", "norm(tension, w = u) = norm(tension, w = u)"),
        ("symbols = ['u']", "arity(tension, w = u) = 4"),
        ("for = 'real v'", "arity(tension, w = v) = 4"),
        ("for = 'real v'", "symmetric(tension, w = v)"),
        ("for = 'all n'", "coefficient(tension, 0, 0, w = n) = 1/2 + n"),
        ("for = 'all n'", "arity(tension, w = n) = 4"),
        ("scheme = 'tension:w=n'\nfor = 'all n'", "n = n"),
        ("", "sum_rules(tension) = 2"),
        ("", "sum_rules(tension, v = 1) = 2"),
    ] {
        for lines in ["holds 1", "holds reals", "holds all"] {
            assert_ne!(of(fields, states, lines), Outcome::Valid, "{fields}: {states}");
        }
    }
}
