//! Ranges of smoothness in two parameters.
//!
//! The norm of `line` is the greater one of |1/2 + w| and |1/2 − w|: its limits are continuous for |w| < 1/2 alone. That of `three` is
//! |x| + |y| + |1/2 − x − y|, or 1/2.

use crate::zeros::Numbers;
use subcert_check::{Outcome, check};

const SCHEMES: &str = "
[given]
g = '1/2'
x = '77'
[define]
spread = 'abs(x) + abs(y)'
half = 'spread/2'
[[scheme]]
name = 'line'
symbol = '(1 + z)*((1/2 + w) + (1/2 - w)*z)/z'
parameters.w = {}
[[scheme]]
name = 'three'
symbol = '(1 + z)*(a + z/2 + b*z^2 + (1/2 - a - b)*z^4)'
parameters.a = {}
parameters.b = {}
[[scheme]]
name = 'four'
symbol = '(1+z)^2/(2*z)*(1 - 2*w*(1-z)^2*(1+z^2)/z^2)'
parameters.w = {}
[[scheme]]
name = 'dependent'
symbol = '(1 + z)*(1 + z^2)*((1/4 + w) + (1/4 - w)*z)'
parameters.w = {}
[[scheme]]
name = 'filter'
filter = true
symbol = '1 + z + w*z^2'
parameters.w = {}
[[scheme]]
name = 'ring'
orbits = { e = '3' }
edges = [['e[i]', 'e[i + 1]']]
weights.e.e = '1/3'
";

/// The fields of a claim and the lines that restate them.
pub fn about(scheme: &str, smoothness: &str, bounds: &[&str]) -> (String, String) {
    let listed: Vec<String> = bounds.iter().map(|text| format!("'{text}'")).collect();
    let fields = format!(
        "variables = ['x', 'y']\nscheme = '{scheme}'\nsmoothness = '{smoothness}'\nwhere = [{}]\n",
        listed.join(", ")
    );
    let mut lines = format!("variables x y\n scheme {scheme}\n smoothness {smoothness}\n");
    for text in bounds {
        lines = format!("{lines} where {text}\n");
    }
    (fields, lines)
}

/// The outcome of a claim about one of these schemes, if the file is one.
pub fn judged(schemes: &str, fields: &str, lines: &str) -> Option<Outcome> {
    let claims = format!("key = 'k'\n{schemes}\n[[range]]\nid = 'r'\n{fields}\n");
    let certificate = format!("subcert-certificate 4\npaper k\nrange r\n {lines}\nend 1\n");
    let report = check(&claims, &[&certificate]).ok()?;
    assert!(report.broken.is_empty(), "{:?}", report.broken);
    Some(report.claims.into_iter().next().expect("a claim").2)
}

pub fn outcome(fields: &str, lines: &str) -> Outcome {
    // A name with two meanings makes the file wrong.
    judged(SCHEMES, fields, lines).unwrap_or(Outcome::Incomplete(None))
}

/// The outcome of a claim with these lines after those that restate it.
pub fn of(scheme: &str, bounds: &[&str], lines: &str) -> Outcome {
    let (fields, head) = about(scheme, "0", bounds);
    outcome(&fields, &format!("{head} {lines}"))
}

pub const ONE: &str = "contraction 1\n confirmed";

/// What is true and shown by one level.
const TRUE: &[(&str, &[&str])] = &[
    ("line:w=x+y", &["abs(x) + abs(y) < 1/2"]),
    ("line:w=x+y", &["abs(x) + abs(y) < g"]),
    ("line:w=x+y", &["spread < g"]),
    ("line:w=x+y", &["half < 1/4"]),
    ("line:w=x+y", &["0.25 - half > 0"]),
    ("line:w=x+y", &["abs(x)/2 + 2*abs(y/4) < 1/4"]),
    ("line:w=x+y", &["-abs(x) > abs(y) - 1/2"]),
    ("line:w=x+y", &["abs(x) + abs(y) <= 0.49999999999999999999"]),
    ("line:w=x+y", &["-1/4 < x < 1/4", "1/4 > y > -1/4"]),
    ("line:w=x+y", &["-1/4 <= x <= 1/4", "1/4 > y > -1/4"]),
    ("line:w=x+y", &["x > -1/4", "y > -1/4", "x + y < 1/2"]),
    ("line:w=x+y", &["max(abs(x), abs(y)) <= 0.2"]),
    ("line:w=x+y", &["min(x, y, -x-y) > -1/10"]),
    ("line:w=x+y", &["sum(i = 1..2, abs(x*i)) + abs(y) < 1/2"]),
    ("line:w=x+y", &["max(i = 1..3, i*abs(x)) < 1/4", "4*abs(y) ≤ 1 - 10^-30"]),
    ("line:w=x+y", &["abs(x) + abs(y) < 1/2", "0 < 1", "x < 10^300", "y ≥ -3^200"]),
    ("line:w=x+y", &["abs(x + y) < 1/2", "abs(x - y) ≤ 10^6"]),
    ("line:w=x-10^40+y", &["abs(x - 10^40) < 1/4", "abs(y) < 1/4"]),
    ("line:w=(x+y)/10^60", &["abs(x) < 10^59", "abs(y) < 4*10^59"]),
    ("line:w=x*y", &["max(abs(x), abs(y)) <= 0.7"]),
    ("line:w=x*y", &["abs(x) <= 1", "abs(y) < 1/2"]),
    ("line:w=x*y", &["abs(x) < 1", "abs(y) <= 1/2"]),
    ("line:w=x^2+y^2", &["abs(x) < 1/2", "abs(y) < 1/2"]),
    ("line:w=x^2+y^2", &["abs(x) + abs(y) <= 7/10"]),
    ("line:w=x^3", &["0 <= x <= 3/4", "0 <= y <= 1"]),
    ("line:w=0", &["abs(x) + abs(y) < 100"]),
    ("three:a=x,b=y", &["abs(x) + abs(y) + abs(1/2 - x - y) < 99/100"]),
    ("three:a=x,b=y", &["max(-x, -y, x + y - 1/2) < 1/9"]),
    ("three:a=x,b=y", &["x ≥ 0", "y ≥ 0", "x + y ≤ 1/2"]),
    ("four:w=x*y", &["0 <= x < 1/2", "0 <= y <= 1/2"]),
];

/// What is false somewhere in the region, with the contraction of any level.
const FALSE: &[(&str, &[&str])] = &[
    ("line:w=x+y", &["abs(x) + abs(y) <= 1/2"]),
    ("line:w=x+y", &["abs(x) + abs(y) < 0.51"]),
    ("line:w=x+y", &["abs(x) + abs(y) < 1/2 + 10^-40"]),
    ("line:w=x+y", &["-1/4 <= x <= 1/4", "1/4 >= y >= -1/4"]),
    ("line:w=x+y", &["-1/4 < x < 1/4", "0 < y < 0.26"]),
    ("line:w=x+y", &["x > -1/4", "y >= -1/4", "x + y <= 1/2"]),
    ("line:w=x+y", &["abs(x + y) <= 1/2", "abs(x - y) < 1"]),
    ("line:w=x+y", &["max(abs(x), abs(y)) <= 0.26"]),
    ("line:w=x-10^40+y", &["abs(x - 10^40) < 1/4", "abs(y) <= 0.26"]),
    ("line:w=x*y", &["max(abs(x), abs(y)) <= 0.8"]),
    ("line:w=x*y", &["abs(x) <= 1", "abs(y) <= 1/2"]),
    ("line:w=x^2+y^2", &["abs(x) <= 1/2", "abs(y) <= 1/2"]),
    ("line:w=x^2+y^2", &["abs(x) + abs(y) <= 0.71"]),
    ("line:w=1/2", &["abs(x) + abs(y) < 1"]),
    ("line:w=x+10*y", &["abs(x) + abs(y) < 1/2"]),
    ("three:a=x,b=y", &["abs(x) + abs(y) + abs(1/2 - x - y) <= 2"]),
    ("three:a=x,b=y", &["max(-x, -y, x + y - 1/2) < 3/4"]),
];

/// What is no bounded convex polygon with inner points.
const NO_REGIONS: &[&[&str]] = &[
    &["x < 1/4"],
    &["0 < x < 1/4"],
    &["0 < x < 1/4", "y < 0"],
    &["abs(x + y) < 1/2"],
    &["abs(x + y) < 1/2", "abs(x + y) < 1/3", "2*x > -2*y - 1/7"],
    &["x > 0", "y > 0"],
    &["0 < 1"],
    &["0 < 0", "abs(x) + abs(y) < 1/4"],
    &["1 <= 0", "abs(x) + abs(y) < 1/4"],
    &["0 <= x <= 0", "abs(y) < 1/4"],
    &["0 < x < 0", "abs(y) < 1/4"],
    &["abs(x) + abs(y) <= 0"],
    &["abs(x) + abs(y) < 0"],
    &["abs(x) + abs(y) < -1"],
    &["x < 0 < y", "x > 0", "y < 1"],
    &["abs(x) > 1/8", "abs(x) + abs(y) < 1/4"],
    &["max(x, y) > 0", "abs(x) + abs(y) < 1/4"],
    &["min(abs(x), abs(y)) < 1/8", "abs(x) + abs(y) < 1/4"],
    &["abs(abs(x) + 1) < 5/4", "abs(y) < 1/4"],
    &["abs(x) - abs(y) < 1/4", "abs(x) + abs(y) < 1/4"],
    &["-1*abs(x) < 1/4", "abs(x) + abs(y) < 1/4"],
    &["abs(x)*abs(y) < 1/4", "abs(x) + abs(y) < 1/4"],
    &["x*y < 1/4", "abs(x) + abs(y) < 1/4"],
    &["x^2 + y^2 < 1/4"],
    &["abs(x)^2 + abs(y) < 1/4"],
    &["1/(x + 1) < 2", "abs(x) + abs(y) < 1/4"],
    &["abs(x)/x < 2", "abs(x) + abs(y) < 1/4"],
    &["sqrt(2)*x < 1/4", "abs(x) + abs(y) < 1/4"],
    &["x < sqrt(2)", "abs(x) + abs(y) < 1/4"],
    &["floor(x) < 1", "abs(x) + abs(y) < 1/4"],
    &["2^x < 2", "abs(x) + abs(y) < 1/4"],
    &["abs(x, order = forward) + abs(y) < 1/4"],
    &["product(i = 1..2, abs(x)) < 1", "abs(x) + abs(y) < 1/4"],
];

/// What is no text of `where` at all.
const WRONG: &[&[&str]] = &[
    &[],
    &[""],
    &["x"],
    &["x = 0", "abs(x) + abs(y) < 1/4"],
    &["x != 5", "abs(x) + abs(y) < 1/4"],
    &["x ≈ 0.1", "abs(x) + abs(y) < 1/4"],
    &["abs(x) + abs(y) < 1/4", "y in (-1/4, 1/4)"],
    &["abs(x) + abs(y) < 1/4", "not x"],
    &["abs(x) + abs(y) < u"],
    &["abs(x) + abs(y) < 1/0"],
    &["abs(x) + abs(y) <"],
    &["abs(x) + abs(y) =< 1/4"],
    &["abs(x) + abs(y) < sum_rules()"],
    &["max(x = 1..2, x) + abs(y) < 1/4"],
];

#[test]
fn what_is_true() {
    for (scheme, bounds) in TRUE {
        let found = of(scheme, bounds, ONE);
        // The four-point scheme contracts too; what is stated is continuity.
        assert_eq!(found, Outcome::Valid, "{scheme} {bounds:?}");
        let only = about(scheme, "0", bounds);
        let found = outcome(&format!("{}only = true", only.0), &format!("{} {ONE}", only.1));
        assert!(matches!(found, Outcome::Invalid(..)), "only {bounds:?}: {found:?}");
    }
}

#[test]
fn what_is_false() {
    for (scheme, bounds) in FALSE {
        for level in [1, 2, 3] {
            let found = of(scheme, bounds, &format!("contraction {level}\n confirmed"));
            assert!(matches!(found, Outcome::Invalid(..)), "{scheme} {bounds:?}: {found:?}");
        }
    }
}

#[test]
fn what_is_no_region() {
    let refuted = "at 0 1/2\n order 1\n product 1\n eigenvalue positive 2\n at-most 2\n unit 1\n image\n image\n not-continuous 0\n end\n refuted";
    for bounds in NO_REGIONS {
        for lines in [ONE, refuted] {
            let found = of("line:w=x+y", bounds, lines);
            assert!(matches!(found, Outcome::Incomplete(Some(_))), "{bounds:?}: {found:?}");
        }
    }
    for bounds in WRONG {
        for lines in [ONE, refuted] {
            let found = of("line:w=x+y", bounds, lines);
            assert!(matches!(found, Outcome::Invalid(..)), "{bounds:?}: {found:?}");
        }
    }
}

/// Lines of signs that go through corners of the region: it is cut along them.
#[test]
fn lines_of_signs_through_corners() {
    for c in 1..4 {
        let lines = format!("contraction {c}\n confirmed");
        let found = of("three:a=x,b=y", &["abs(x) + abs(y) + abs(1/2 - x - y) < 1"], &lines);
        assert_eq!(found, Outcome::Valid, "{c}");
    }
    let found = of("three:a=x,b=y", &["abs(x) + abs(y) + abs(1/2 - x - y) <= 1"], ONE);
    assert!(matches!(found, Outcome::Invalid(..)), "{found:?}");
}

/// Work ends, whatever is asked.
#[test]
fn large_regions() {
    let many: Vec<String> =
        (1..100).map(|i| format!("{i}*x + {}*y < {}", 100 - i, i * (100 - i))).collect();
    let mut many: Vec<&str> = many.iter().map(String::as_str).collect();
    many.extend(["x > -1", "y > -1"]);
    let sum: Vec<String> = (0..20).map(|i| format!("abs(x - {i}*y)")).collect();
    let sum = format!("{} < 1", sum.join(" + "));
    for (scheme, bounds) in [
        ("line:w=(x+y)/10^6", &many[..]),
        ("line:w=x+y", &[&sum[..]]),
        ("line:w=x+y", &["abs(x) + abs(y) < 10^-100000"]),
        ("line:w=x+y", &["abs(x) + abs(y)/3^90000 < 1/7^90000"]),
        ("line:w=x^60*y^60", &["abs(x) < 1", "abs(y) < 1/2"]),
        ("line:w=(x+y)^250", &["abs(x) < 1", "abs(y) < 1/2"]),
        ("line:w=(x+y)^16", &["abs(x) < 1", "abs(y) < 1/2"]),
    ] {
        for c in [1, 8] {
            let found = of(scheme, bounds, &format!("contraction {c}\n confirmed"));
            assert!(!matches!(found, Outcome::Incomplete(None)), "{scheme}");
        }
    }
    assert_eq!(of("line:w=(x+y)/10^6", &many, ONE), Outcome::Valid);
}

/// Random triangles with sides that belong to the region or do not, against the greatest |w| of w = ax + by on them.
#[test]
fn random_triangles() {
    let (mut numbers, mut seen) = (Numbers(5), [0; 2]);
    for _ in 0..150 {
        let points: Vec<[i64; 2]> =
            (0..3).map(|_| [numbers.around(8), numbers.around(8)]).collect();
        let [a, b] = [numbers.around(3), numbers.around(3)];
        let side = |p: [i64; 2], q: [i64; 2]| {
            // A linear function in sixteenths that is 0 on a side.
            let [c, d] = [p[1] - q[1], q[0] - p[0]];
            [c, d, -(c * p[0] + d * p[1])]
        };
        let at = |[c, d, e]: [i64; 3], [x, y]: [i64; 2]| c * x + d * y + e;
        if at(side(points[0], points[1]), points[2]) == 0 {
            continue;
        }
        let (mut bounds, mut closed) = (Vec::new(), Vec::new());
        for k in 0..3 {
            let other = points[(k + 2) % 3];
            let line = side(points[k], points[(k + 1) % 3]);
            let sign = at(line, other).signum();
            let [c, d, e] = line.map(|c| -sign * c);
            closed.push(numbers.around(1) != 0);
            let relation = if closed[k] { "<=" } else { "<" };
            bounds.push(match numbers.around(1) {
                0 => format!("16*({c}*x + {d}*y) {relation} {}", -e),
                1 => format!("max({c}*x, {c}*x - 2) + {d}*y {relation} {}/16", -e),
                _ => format!("0 {} ({c}*x + {d}*y + {e}/16)*3", if closed[k] { ">=" } else { ">" }),
            });
        }
        let w: Vec<i64> = points.iter().map(|[x, y]| (a * x + b * y).abs()).collect();
        // A corner belongs to the region if both of its sides do; a side with 1/2 at both ends if it does itself.
        let corner = |k: usize| w[k] == 8 && closed[k] && closed[(k + 2) % 3];
        let values = |k: usize| points[k][0] * a + points[k][1] * b;
        let side = |k: usize| {
            let next = (k + 1) % 3;
            w[k] == 8 && values(k) == values(next) && closed[k]
        };
        let is = w.iter().all(|w| *w <= 8) && (0..3).all(|k| !corner(k) && !side(k));
        let bounds: Vec<&str> = bounds.iter().map(String::as_str).collect();
        let scheme = format!("line:w={a}*x+({b})*y");
        let found = of(&scheme, &bounds, ONE);
        assert_eq!(found == Outcome::Valid, is, "{scheme} {bounds:?}: {found:?}");
        assert!(matches!(found, Outcome::Valid | Outcome::Invalid(..)), "{found:?}");
        seen[usize::from(is)] += 1;
    }
    assert!(seen[0] > 20 && seen[1] > 20, "{seen:?}");
}
