//! Random relations for real values of an index, against the truth at all numbers where a polynomial or a range may change.

// Ends and roots are few numbers, which are equal or far apart.
#![allow(clippy::float_cmp)]

use crate::masks::relation_of;
use std::f64::consts::SQRT_2;
use std::fmt::Write as _;
use subcert_check::Outcome;

const SCHEMES: &str = "
[[scheme]]
name = 'fp'
symbol = '(1+z)^2/(2*z)*(1 - 2*w*(1-z)^2*(1+z^2)/z^2)'
parameters.w = {}
";

/// What is stated of a polynomial p, with the scheme, and the signs of p for which it is true.
const STATED: [(&str, &str, [bool; 3]); 14] = [
    ("", "p < 0", [true, false, false]),
    ("", "0 ≥ p", [true, true, false]),
    ("", "p = 0", [false, true, false]),
    ("", "p != 0", [true, false, true]),
    ("", "max(p, 0) = 0", [true, true, false]),
    ("", "abs(p) = p", [false, true, true]),
    ("", "abs(p) + p > 0", [false, false, true]),
    ("", "p in {1/16 - 1/16, p + 1}", [false, true, false]),
    ("", "p + 1 in (p, 1]", [true, true, false]),
    ("fp:w=1/16 + p", "sum_rules() = 4", [false, true, false]),
    ("fp:w=1/16 + p", "reproduction() in {1}", [true, false, true]),
    ("fp:w=1/16 + p", "moment(2) > 0", [true, false, false]),
    ("fp:w=p", "support() != 2", [true, false, true]),
    ("fp:w=p", "contraction(1) = 1/2 + 2*p", [false, true, true]),
];

/// Numbers that look random.
struct Numbers(u64);

impl Numbers {
    /// One below a count.
    fn below(&mut self, count: usize) -> usize {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap_or(0) % count
    }

    /// A quarter of an integer, or ±√2.
    fn end(&mut self) -> f64 {
        match self.below(6) {
            0 => SQRT_2,
            1 => -SQRT_2,
            _ => [-1.75, -1.25, -1.0, -0.5, 0.0, 0.25, 1.0, 1.25, 1.5, 2.0][self.below(10)],
        }
    }
}

/// A number as a formula, and as a place.
fn written(x: f64) -> [String; 2] {
    match x {
        SQRT_2 => ["sqrt(2)".into(), "root:-2,0,1:1:2".into()],
        _ if -x == SQRT_2 => ["-sqrt(2)".into(), "root:-2,0,1:-2:-1".into()],
        _ => [x.to_string(), format!("{}/128", x * 128.0)],
    }
}

/// The entry of `for`, whether a number belongs to the values, and the ends.
type Range = (String, Box<dyn Fn(f64) -> bool>, Vec<f64>);

fn range(numbers: &mut Numbers) -> Range {
    let (a, b) = (numbers.end(), numbers.end());
    let (a, b) = if a < b { (a, b) } else { (b, a) };
    let [low, high] = [a, b].map(|x| written(x)[0].clone());
    match numbers.below(9) {
        0 => ("real v".into(), Box::new(|_| true), Vec::new()),
        1 => (format!("v > {low}"), Box::new(move |x| x > a), vec![a]),
        2 => (format!("{low} ≥ v"), Box::new(move |x| x <= a), vec![a]),
        3 => (format!("v ≠ {low}"), Box::new(move |x| x != a), vec![a]),
        4 if a < b => {
            (format!("{low} < v <= {high}"), Box::new(move |x| a < x && x <= b), vec![a, b])
        }
        5 if a < b => {
            (format!("{high} > v ≥ {low}"), Box::new(move |x| a <= x && x < b), vec![a, b])
        }
        6 => (format!("{low} <= v ≤ {high}"), Box::new(move |x| a <= x && x <= b), vec![a, b]),
        _ => {
            let listed = [-1.0, 0.5, [a, b][usize::from(a.abs() == SQRT_2)]];
            let listed = listed.map(|x| if x.abs() == SQRT_2 { 2.0 } else { x });
            let text = listed.map(|x| x.to_string()).join(", ");
            (format!("v = {text}"), Box::new(move |x| listed.contains(&x)), listed.to_vec())
        }
    }
}

/// A product of factors, its sign, and its roots.
type Polynomial = (String, Box<dyn Fn(f64) -> usize>, Vec<f64>);

fn polynomial(numbers: &mut Numbers) -> Polynomial {
    let (mut text, mut roots, mut linear) = (String::from("1"), Vec::new(), Vec::new());
    let mut negative = false;
    let mut square = false;
    for _ in 0..=numbers.below(3) {
        match numbers.below(5) {
            0 => text += "*(v^2 + 1)",
            1 => {
                text += "*(-1)";
                negative = !negative;
            }
            2 if !square => {
                text += "*(v^2 - 2)";
                square = true;
                roots.extend([-SQRT_2, SQRT_2]);
            }
            _ => {
                let root = numbers.end();
                let root = if root.abs() == SQRT_2 { 0.5 } else { root };
                let _ = write!(text, "*(v - ({root}))");
                roots.push(root);
                linear.push(root);
            }
        }
    }
    let sign = move |x: f64| {
        let mut product = if negative { -1.0 } else { 1.0 };
        for root in &linear {
            product *= x - root;
        }
        if square {
            product *= if x.abs() == SQRT_2 { 0.0 } else { x * x - 2.0 };
        }
        match product {
            ..0.0 => 0,
            0.0 => 1,
            _ => 2,
        }
    };
    (text, Box::new(sign), roots)
}

/// A polynomial and the range of all numbers for which something is true of its sign, if it is a range.
fn fitting(truth: [bool; 3], root: f64) -> Option<(Polynomial, Range)> {
    let quadratic = root.abs() == SQRT_2;
    let sign = move |x: f64| {
        let is = if quadratic { x.abs().total_cmp(&SQRT_2) } else { x.total_cmp(&(root + 0.0)) };
        usize::try_from(is as i8 + 1).unwrap_or(0)
    };
    let of = match (quadratic, truth) {
        (true, [true, false, false]) => "-sqrt(2) < v < sqrt(2)".into(),
        (true, [true, true, false]) => "sqrt(2) ≥ v ≥ -sqrt(2)".into(),
        (true, _) => return None,
        (false, [true, false, false]) => format!("v < {root}"),
        (false, [true, true, false]) => format!("{root} >= v"),
        (false, [true, _, true]) => format!("v != {root}"),
        (false, [false, true, false]) => format!("v = {root}"),
        (false, [_, true, true]) => format!("v ≥ {root}"),
        (false, _) => format!("{root} < v"),
    };
    let p = if quadratic { "v^2 - 2".into() } else { format!("v - ({root})") };
    let roots = if quadratic { vec![-SQRT_2, SQRT_2] } else { vec![root] };
    let has = move |x: f64| truth[sign(x)];
    Some(((p, Box::new(sign), roots.clone()), (of, Box::new(has), roots)))
}

#[test]
fn random_claims_have_the_verdict_that_is_true() {
    let mut numbers = Numbers(11);
    let (mut counts, mut accepted) = ([[0; 2]; 2], 0);
    for round in 0..200 {
        let (scheme, stated, truth) = STATED[numbers.below(STATED.len())];
        let ((p, sign, roots), (of, has, ends)) = match fitting(truth, numbers.end()) {
            Some(fitting) if numbers.below(4) == 0 => fitting,
            _ => (polynomial(&mut numbers), range(&mut numbers)),
        };
        let only = of.starts_with("v =") || numbers.below(2) == 0;
        let mut places: Vec<f64> = roots.into_iter().chain(ends).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        // Numbers between these, and beyond.
        let mut between: Vec<f64> =
            places.windows(2).map(|pair| ((pair[0] + pair[1]) * 32.0).round() / 64.0).collect();
        between.extend([-9.0, 9.0]);
        places.extend(between);
        let is = |x: f64| truth[sign(x)];
        let holds = places.iter().all(|x| if has(*x) { is(*x) } else { !only || !is(*x) });
        let [scheme, stated] = [scheme, stated].map(|text| replaced(text, &p));
        let mut fields = format!("states = '{stated}'\nfor = '{of}'\n");
        if only {
            fields += "only = true\n";
        }
        if !scheme.is_empty() {
            let _ = writeln!(fields, "scheme = '{scheme}'");
        }
        let outcome =
            |lines: &str| relation_of(SCHEMES, &fields, &format!("states {stated}\n {lines}"));
        let found = outcome("holds reals");
        assert_eq!(found == Outcome::Valid, holds, "{round}: {fields}{found:?}");
        counts[usize::from(only)][usize::from(holds)] += 1;
        for x in places {
            let at = &written(x)[1];
            let count = if stated.contains("in (") { 2 } else { 1 };
            let numbers: &[&str] = if count == 2 { &[" 1", " 2"] } else { &[""] };
            let mut valid = |lines: &str| {
                let valid = outcome(&format!("fails reals\n {lines}")) == Outcome::Valid;
                accepted += usize::from(valid);
                valid
            };
            let any = numbers.iter().filter(|number| valid(&format!("false {at}{number}"))).count();
            assert_eq!(any > 0, has(x) && !is(x), "{round}: {fields}false {at}");
            let expected = only && !has(x) && is(x);
            assert_eq!(valid(&format!("true {at}")), expected, "{round}: {fields}true {at}");
        }
    }
    println!("{counts:?}, {accepted} witnesses accepted");
    assert!(counts.as_flattened().iter().all(|count| *count > 10), "{counts:?}");
    assert!(accepted > 100);
}

/// A text with a polynomial in place of the name p.
fn replaced(text: &str, p: &str) -> String {
    let mut found = String::new();
    let letters: Vec<char> = text.chars().collect();
    for (i, c) in letters.iter().enumerate() {
        let beside = |at: Option<usize>| {
            at.and_then(|at| letters.get(at)).is_some_and(|c| c.is_alphanumeric() || *c == '_')
        };
        if *c == 'p' && !beside(i.checked_sub(1)) && !beside(Some(i + 1)) {
            let _ = write!(found, "({p})");
        } else {
            found.push(*c);
        }
    }
    found
}
