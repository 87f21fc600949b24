//! The fields and lines of ranges of smoothness in two parameters, and points that refute them.

use crate::regions::{ONE, about, of, outcome};
use crate::zeros::{Numbers, float};
use subcert_check::Outcome;

/// One level is too few, and more are enough; and what a factor takes away.
#[test]
fn levels_and_shifts() {
    let four = "four:w=x+y";
    let bounds = ["x > 0", "y > 0", "x + y < 3/20"];
    let (fields, head) = about(four, "1", &bounds);
    for (lines, right) in
        [("contraction 2", true), ("contraction 4", true), ("contraction 1", false)]
    {
        let found = outcome(&fields, &format!("{head} {lines}\n confirmed"));
        assert_eq!(found == Outcome::Valid, right, "{lines}: {found:?}");
    }
    for bounds in [["x > 0", "y > 0", "x + y < 1/5"], ["x >= 0", "y >= 0", "x + y < 3/20"]] {
        let (fields, head) = about(four, "1", &bounds);
        for c in 1..5 {
            let found = outcome(&fields, &format!("{head} contraction {c}\n confirmed"));
            assert!(matches!(found, Outcome::Invalid(..)), "{bounds:?}: {found:?}");
        }
    }
    // Of A(z)(1 + z)/(1 + z²) the class sums are |1/4 + w| + |1/4 − w| and 1/2.
    let bounds = ["abs(x) + abs(y) < 1/2"];
    for (lines, right) in [
        ("contraction 1\n shifts 1 1\n confirmed", true),
        ("contraction 1\n shifts -3 -3\n confirmed", true),
        ("contraction 1\n confirmed", false),
        ("contraction 1\n shifts 1 2\n confirmed", false),
        ("contraction 1\n shifts 1 1\n shifts 1 1\n confirmed", false),
        ("contraction 1\n shifts 1\n confirmed", false),
        ("contraction 1\n shifts 1 0\n confirmed", false),
        ("contraction 1\n shifts 1 x\n confirmed", false),
        ("shifts 1 1\n contraction 1\n confirmed", false),
    ] {
        let found = of("dependent:w=x+y", &bounds, lines);
        assert_eq!(found == Outcome::Valid, right, "{lines}: {found:?}");
    }
}

/// The radius of `line` at a point: the numbers 1 + 2w and 1 − 2w.
fn at(point: &str, product: usize, value: &str, shown: &str) -> String {
    format!(
        "at {point}\n order 1\n product {product}\n eigenvalue positive {value}\n at-most {value}\n unit 1\n image\n image\n {shown}\n end\n refuted"
    )
}

#[test]
fn at_points() {
    let rough = |point: &str, value: &str| at(point, 0, value, "not-continuous 0");
    let smooth = |point: &str, value: &str| at(point, 0, value, "continuous 0");
    let small: &[&str] = &["abs(x) + abs(y) < 1/4"];
    let large: &[&str] = &["abs(x) + abs(y) < 1"];
    let closed: &[&str] = &["x >= 0", "y >= 0", "x + y <= 3/4"];
    for (bounds, only, lines, right) in [
        (large, false, rough("1/2 1/4", "5/2"), true),
        (large, true, rough("1/2 1/4", "5/2"), true),
        (large, false, rough("0.5 0.25", "5/2"), true),
        (large, false, rough("1/2 1/2", "3"), false),
        (large, false, rough("3 4", "15"), false),
        (large, false, rough("1/2 1/4", "2"), false),
        (large, false, smooth("1/8 1/8", "3/2"), false),
        (large, true, smooth("1/8 1/8", "3/2"), false),
        (closed, false, rough("1/2 1/4", "5/2"), true),
        (closed, false, rough("0 3/4", "5/2"), true),
        (closed, false, rough("0 4/5", "13/5"), false),
        (small, true, smooth("1/8 1/4", "7/4"), true),
        (small, true, smooth("0 1/4", "3/2"), true),
        (small, false, smooth("1/8 1/4", "7/4"), false),
        (small, true, smooth("1/8 1/9", "53/36"), false),
        (small, true, rough("1/2 1/4", "5/2"), false),
        (small, false, rough("1/2 1/4", "5/2"), false),
        (large, false, rough("1/2", "5/2"), false),
        (large, false, rough("1/2 1/4 0", "5/2"), false),
        (large, false, rough("1/2 y", "5/2"), false),
        (large, false, rough("root:-1,2:0:1 1/4", "5/2"), false),
        (large, false, rough("1/2 1/4", "5/2").replace(" end\n", ""), false),
        (large, false, rough("1/2 1/4", "5/2").replace(" refuted", " confirmed"), false),
        (large, false, rough("1/2 1/4", "5/2").replace("refuted", "refuted 1"), false),
        (large, false, rough("1/2 1/4", "5/2").replace("at 1/2 1/4\n ", ""), false),
        (large, false, format!("contraction 1\n {}", rough("1/2 1/4", "5/2")), false),
        (large, false, "contraction 1\n refuted".into(), false),
        (small, false, "contraction 1\n refuted".into(), false),
    ] {
        let (fields, head) = about("line:w=x+y", "0", bounds);
        let only = if only { "only = true\n" } else { "" };
        let found = outcome(&format!("{fields}{only}"), &format!("{head} {lines}"));
        assert_eq!(found == Outcome::Valid, right, "{bounds:?}: {lines}: {found:?}");
    }
}

/// Lines dropped, twice, exchanged or with other digits.
#[test]
fn changed_lines() {
    let (fields, head) = about("three:a=x,b=y", "0", &["x ≥ 0", "0 <= y", "x + y ≤ 1/2"]);
    let text = format!("{head} {ONE}");
    let all: Vec<&str> = text.lines().map(str::trim).collect();
    assert_eq!(outcome(&fields, &all.join("\n ")), Outcome::Valid);
    let mut altered = Vec::new();
    for i in 0..all.len() {
        altered.push([&all[..i], &all[i + 1..]].concat().join("\n "));
        altered.push([&all[..=i], &all[i..]].concat().join("\n "));
        if i + 1 < all.len() {
            let mut other = all.clone();
            other.swap(i, i + 1);
            altered.push(other.join("\n "));
        }
        // Other levels may show the same.
        for (at, digit) in all[i].char_indices().filter(|(_, c)| c.is_alphanumeric()) {
            if all[i] == "contraction 1" && digit == '1' {
                continue;
            }
            let mut line = all[i].to_owned();
            line.replace_range(at..=at, if digit == '7' { "8" } else { "7" });
            let mut other = all.clone();
            other[i] = &line;
            altered.push(other.join("\n "));
        }
    }
    for contraction in [
        "contraction 0",
        "contraction 17",
        "contraction -1",
        "contraction 1 1",
        "contraction",
        "contraction one",
    ] {
        altered.push(format!("{head} {contraction}\n confirmed"));
    }
    assert!(altered.len() > 80);
    for lines in altered {
        let found = outcome(&fields, &lines);
        assert!(matches!(found, Outcome::Invalid(..)), "{lines}: {found:?}");
    }
}

/// The fields of a claim.
#[test]
fn fields() {
    let (fields, head) = about("line:w=x+y", "0", &["abs(x) + abs(y) < 1/2"]);
    let lines = format!("{head} {ONE}");
    assert_eq!(outcome(&fields, &lines), Outcome::Valid);
    assert_eq!(outcome(&format!("{fields}only = false"), &lines), Outcome::Valid);
    for more in [
        "only = true",
        "variable = 'v'",
        "value = 'x'",
        "below = '1'",
        "at_most = '1'",
        "valences = '3'",
        "from = '0'",
        "to = '1'",
        "closed = true",
        "closed = false",
    ] {
        let found = outcome(&format!("{fields}{more}"), &lines);
        assert!(matches!(found, Outcome::Invalid(..)), "{more}: {found:?}");
    }
    for (field, other) in [
        ("variables = ['x', 'y']", "variables = ['x']"),
        ("variables = ['x', 'y']", "variables = ['x', 'x']"),
        ("variables = ['x', 'y']", "variables = ['x', 'y', 'v']"),
        ("variables = ['x', 'y']", "variables = []"),
        ("variables = ['x', 'y']", "variables = ['x', '2']"),
        ("variables = ['x', 'y']", "variables = ['x', 'half']"),
        ("variables = ['x', 'y']", "variables = 'x y'"),
        ("variables = ['x', 'y']", "variable = 'x'"),
        ("variables = ['x', 'y']", ""),
        ("scheme = 'line:w=x+y'\n", ""),
        ("smoothness = '0'\n", ""),
        ("smoothness = '0'", "smoothness = '-1'"),
        ("smoothness = '0'", "smoothness = '65'"),
        ("smoothness = '0'", "smoothness = '1'"),
        ("where = ['abs(x) + abs(y) < 1/2']", ""),
        ("where = ['abs(x) + abs(y) < 1/2']", "where = []"),
    ] {
        let changed = fields.replace(field, other);
        assert_ne!(changed, fields);
        let head = if other.starts_with("smoothness") {
            lines.replace("smoothness 0", &other.replace(" = '", " ").replace('\'', ""))
        } else {
            lines.clone()
        };
        assert_ne!(outcome(&changed, &head), Outcome::Valid, "{other}");
    }
    // One variable with a region.
    let one = "variable = 'w'\nscheme = 'line:w=w'\nsmoothness = '0'\nfrom = '0'\nto = '1/4'\n";
    let said = "variable w\n scheme line:w=w\n smoothness 0\n contraction 1\n breaks -1/2 1/2\n signs + 0 - 0 +\n confirmed";
    assert_eq!(outcome(one, said), Outcome::Valid);
    assert_ne!(outcome(&format!("{one}where = ['w < 1']"), said), Outcome::Valid);
    for scheme in [
        "line:w=x+y x line:w=x+y",
        "filter:w=x+y",
        "ring",
        "line:w=x+v",
        "line:w=abs(x)",
        "line:w=1/(x+10)",
        "line",
        "none",
        "line:w=sqrt(2)*x/10",
    ] {
        let found = of(scheme, &["abs(x) + abs(y) < 1/2"], ONE);
        assert!(matches!(found, Outcome::Invalid(..)), "{scheme}: {found:?}");
    }
}

/// Random polynomials of degree 3 on a square, against their values at many points.
#[test]
fn random_polynomials() {
    let (mut numbers, mut seen) = (Numbers(9), [0; 2]);
    for round in 0..40 {
        let powers = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (2, 1), (0, 3)];
        let terms: Vec<i64> = powers.iter().map(|_| numbers.around(6)).collect();
        let grid = (0..=40)
            .flat_map(|i| (0..=40).map(move |j| (float(i) / 20.0 - 1.0, float(j) / 20.0 - 1.0)));
        let value = |(x, y): (f64, f64)| -> f64 {
            let each = powers.iter().zip(&terms);
            each.map(|((p, q), c)| float(*c) * x.powi(*p) * y.powi(*q)).sum::<f64>() / 32.0
        };
        let most = grid.map(|at| value(at).abs()).fold(0.0, f64::max);
        let each = powers.iter().zip(&terms);
        let text: Vec<String> = each.map(|((p, q), c)| format!("({c})*x^{p}*y^{q}")).collect();
        let scheme = format!("line:w=({})/32", text.join("+"));
        let level = 1 + round % 2;
        let found = of(
            &scheme,
            &["abs(x) <= 1", "abs(y) < 1"],
            &format!("contraction {level}\n confirmed"),
        );
        if most > 0.5 {
            assert!(matches!(found, Outcome::Invalid(..)), "{scheme}: {found:?}");
        } else if most < 0.48 {
            assert_eq!(found, Outcome::Valid, "{scheme}");
        } else {
            continue;
        }
        seen[usize::from(most < 0.5)] += 1;
    }
    assert!(seen[0] > 5 && seen[1] > 5, "{seen:?}");
}
