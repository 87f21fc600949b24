//! Random tables, equations, functions and ranges, of which a few values show what is true.

use super::masks::{Q, float, int};
use super::mutator::Random;
use super::suite::{Claim, Pair, Suite};
use num_bigint::BigInt;
use num_traits::Signed;
use std::fmt::Write as _;

fn lines(texts: &[&str]) -> Vec<String> {
    texts.iter().map(|&text| text.to_owned()).collect()
}

/// A claim that is true or false.
fn claim(
    head: String,
    restated: Vec<String>,
    seeds: Vec<Vec<String>>,
    lies: &[&str],
    is_true: bool,
) -> Claim {
    let falsehood = move |block: &[String]| {
        let word = block.iter().rev().find_map(|line| {
            let word = line.split(' ').next().unwrap_or_default();
            ["holds", "exact", "rounding", "fails", "inexact"]
                .contains(&word)
                .then(|| word.to_owned())
        });
        let says = !["fails", "inexact"].contains(&word.as_deref().unwrap_or_default());
        (says != is_true).then(|| format!("it is {is_true}"))
    };
    Claim {
        head,
        restated,
        seeds,
        lies: lines(lies),
        replaced: Default::default(),
        falsehood: Box::new(falsehood),
    }
}

/// The pairs.
pub fn suite(random: &mut Random) -> Suite {
    let mut claims = "key = 'formulas'\n".to_owned();
    let mut pairs = Vec::new();
    for place in 0..15 {
        pairs.push(table(random, &mut claims, place));
        pairs.push(equation(random, &mut claims, place));
        pairs.push(function(random, &mut claims, place));
        pairs.push(range(random, &mut claims, place));
    }
    Suite { about: "paper formulas", claims, pairs }
}

/// A decimal of so many places.
fn decimal(digits: &BigInt, places: usize) -> String {
    let sign = if digits.is_negative() { "-" } else { "" };
    let text = format!("{:0>width$}", digits.abs().to_string(), width = places + 1);
    let (whole, part) = text.split_at(text.len() - places);
    if places == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{part}") }
}

/// A cell that prints a fraction, nearest or a few units away.
fn table(random: &mut Random, claims: &mut String, place: usize) -> Pair {
    let x = Q::new(random.within(-500, 500).into(), random.within(1, 300).into());
    let places = random.below(5);
    let unit = (0..places).fold(int(1), |unit, _| unit / int(10));
    let nearest = (&x / &unit).round().to_integer();
    let mut one = |kind: &str, off: i64| {
        let id = format!("{kind}-table-{place}");
        let digits = &nearest + off;
        let printed = decimal(&digits, places);
        let _ = writeln!(
            claims,
            "[[table]]\nid = '{id}'\nvalue = 'x'\ncolumns = {{ name = 'x', values = ['{x}'] }}\ncells = [['{printed}']]"
        );
        let distance = (Q::from_integer(digits) * &unit - &x).abs();
        let cell = |verdict: &str| vec![format!("cell 1 1 \"{printed}\" {x} {verdict}")];
        let refuted =
            || [cell("refuted"), vec!["family 0".to_owned(), "member : 0 0 0".to_owned()]].concat();
        let (is_nearest, is_next) = (&distance * int(2) <= unit, distance < unit);
        let falsehood = move |block: &[String]| {
            let cell = block.iter().find(|line| line.starts_with("cell "))?;
            let word = cell.rsplit_once('"')?.1.split_whitespace().nth(1)?.to_owned();
            let fits = match &word[..] {
                "confirmed" | "reproduced" => is_nearest,
                "rounding" => !is_nearest && is_next,
                _ => !is_next,
            };
            (!fits).then(|| format!("the cell is not {word}"))
        };
        Claim {
            head: format!("table {id}"),
            restated: lines(&["value x"]),
            seeds: vec![cell("confirmed"), cell("rounding cut"), cell("rounding away"), refuted()],
            lies: Vec::new(),
            replaced: Default::default(),
            falsehood: Box::new(falsehood),
        }
    };
    let first = one("near", 0);
    let off = if random.once_in(2) { 1 } else { random.within(2, 4) };
    Pair { claims: [first, one("off", off)], exclusive: false, complementary: false }
}

/// (ax + b)(cx + dy), expanded and otherwise.
fn equation(random: &mut Random, claims: &mut String, place: usize) -> Pair {
    let [a, b, c, d] = [0; 4].map(|_| random.within(-3, 3));
    let off = random.within(1, 3);
    let left = format!("({a}*x + ({b}))*({c}*x + ({d})*y)");
    let mut one = |kind: &str, off: i64| {
        let id = format!("{kind}-equation-{place}");
        let right =
            format!("{}*x^2 + ({})*x*y + ({})*x + ({})*y + {off}", a * c, a * d, b * c, b * d);
        let _ = writeln!(
            claims,
            "[[equation]]\nid = '{id}'\nsymbols = ['x', 'y']\nleft = '{left}'\nright = '{right}'"
        );
        // Both are polynomials of degrees at most 2 in x and y.
        let differ = |x: i64, y: i64| {
            (a * x + b) * (c * x + d * y)
                != a * c * x * x + a * d * x * y + b * c * x + b * d * y + off
        };
        let is_true = !(-1..=1).any(|x| (-1..=1).any(|y| differ(x, y)));
        let seeds = vec![
            lines(&["holds 1"]),
            vec!["fails 1".to_owned(), format!("case = -{off}")],
            lines(&["fails 1", "case = 0"]),
            lines(&["fails 1"]),
        ];
        claim(
            format!("equation {id}"),
            vec![format!("left {left}"), format!("right {right}")],
            seeds,
            &["holds 1", "holds 0"],
            is_true,
        )
    };
    let claims = [one("same", 0), one("other", off)];
    Pair { claims, exclusive: true, complementary: false }
}

/// |w − a| + |w − b| and the greatest of three lines, or with another constant.
fn function(random: &mut Random, claims: &mut String, place: usize) -> Pair {
    let a = random.within(-3, 3);
    let b = a + random.within(1, 4);
    let off = random.within(1, 2);
    let left = format!("abs(w - ({a})) + abs(w - ({b}))");
    let mut one = |kind: &str, off: i64| {
        let id = format!("{kind}-function-{place}");
        let middle = b - a + off;
        let right = format!("max({a} + ({b}) - 2*w, {middle}, 2*w - ({a}) - ({b}))");
        let _ = writeln!(
            claims,
            "[[function]]\nid = '{id}'\nvariable = 'w'\nleft = '{left}'\nright = '{right}'"
        );
        let differs = |w: i64| {
            (w - a).abs() + (w - b).abs() != (a + b - 2 * w).max(middle).max(2 * w - a - b)
        };
        let is_true = !(-20..=20).any(differs);
        let (low, high) =
            (Q::new((2 * a - off).into(), 2.into()), Q::new((2 * b + off).into(), 2.into()));
        let seeds = vec![
            lines(&["breaks", "signs 0", "holds"]),
            vec![
                format!("breaks {low} {high}"),
                "signs 0 0 - 0 0".to_owned(),
                format!("fails {a} {} {middle}", b - a),
            ],
        ];
        let restated =
            vec!["variable w".to_owned(), format!("left {left}"), format!("right {right}")];
        claim(format!("function {id}"), restated, seeds, &["holds"], is_true)
    };
    Pair { claims: [one("same", 0), one("other", off)], exclusive: true, complementary: false }
}

/// (w − a)(w − b) is negative between the two, and not elsewhere.
fn range(random: &mut Random, claims: &mut String, place: usize) -> Pair {
    let a = random.within(-9, 9);
    let b = a + random.within(1, 9);
    let off = random.within(1, 9);
    let mut one = |kind: &str, off: i64| {
        let id = format!("{kind}-range-{place}");
        let value = format!("(w - ({a}/10))*(w - ({b}/10))");
        let [from, to] = [a, b + off].map(|end| decimal(&BigInt::from(end * 10), 2));
        let _ = writeln!(
            claims,
            "[[range]]\nid = '{id}'\nvariable = 'w'\nvalue = '{value}'\nbelow = '0'\nfrom = '{from}'\nto = '{to}'"
        );
        let at = |end: i64| Q::new(end.into(), 10.into());
        let is_end = |printed: &str, end: i64| {
            (printed.parse::<f64>().unwrap_or(9.0) - float(&at(end))).abs() < 1e-9
        };
        let is_true = is_end(&from, a) && is_end(&to, b);
        let ends = |relation: &str, verdict: &str| {
            vec![
                format!("breaks {} {}", at(a), at(b)),
                "signs + 0 - 0 +".to_owned(),
                format!("end from \"{from}\" {} equal", at(a)),
                format!("end to \"{to}\" {} {relation}", at(b)),
                verdict.to_owned(),
            ]
        };
        let seeds =
            vec![ends("equal", "exact"), ends("apart", "inexact"), ends("nearest", "rounding")];
        let restated =
            vec!["variable w".to_owned(), format!("value {value}"), "below 0".to_owned()];
        claim(format!("range {id}"), restated, seeds, &["exact", "rounding", "inexact"], is_true)
    };
    let claims = [one("same", 0), one("other", off)];
    Pair { claims, exclusive: true, complementary: false }
}
