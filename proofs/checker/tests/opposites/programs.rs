//! Constants that programs ship, and the same numbers said to be others.

use super::mutator::Random;
use super::suite::{Claim, Pair, Suite};
use std::fmt::Write as _;

/// Numbers, what they equal, and the outcome. `g` is the root of two.
const TABLES: [(&str, &[&str], &str, &str); 10] = [
    ("f64", &["1.4142135623730951"], "g", "nearest"),
    ("f64", &["1.4142135623730955"], "g", "ulps"),
    ("f64", &["1.41421"], "g", "cut"),
    ("f64", &["1.4142153623730951"], "g", "misprint"),
    ("f64", &["1.7320508075688772"], "g", "refuted"),
    ("f32", &["0.33333334f", "0.6666667f"], "k/3", "nearest"),
    ("f32", &["0.33333334f", "0.667f"], "k/3", "cut"),
    ("f32", &["0.33333334f", "2.5f"], "k/3", "refuted"),
    ("decimal:3", &["1.414"], "g", "nearest"),
    ("decimal:3", &["1.432"], "g", "ulps"),
];

/// The pairs: each table, and the table with 1 more.
pub fn suite(_: &mut Random) -> Suite {
    let mut claims = "key = 'numbers'\n[project]\nname = 'numbers'\n[define]\ng = 'sqrt(2)'\nunused = 'sqrt(3)'\n".to_owned();
    let mut pairs = Vec::new();
    for (place, (of, cells, equals, outcome)) in TABLES.into_iter().enumerate() {
        let literals: Vec<String> = cells.iter().map(|cell| format!("'{cell}'")).collect();
        let (index, count) = (equals.contains('k'), cells.len());
        let indices = if index { format!("indices = ['k = 1..{count}']\n") } else { String::new() };
        let mut one = |kind: &str, equals: &str, known: Option<&'static str>| {
            let id = format!("{kind}-{place}");
            let _ = write!(
                claims,
                "[[shipped]]\nid = '{id}'\nlocus = 'f.c'\ntitle = 'numbers'\ntype = '{of}'\n{indices}equals = '{equals}'\ncells = [{}]\n[[shipped.convention]]\nlabel = 'the same'\nequals = '{equals}'\n",
                literals.join(", ")
            );
            let lines = |verdict: &str, reading: &str, outcome: &str| {
                let mut lines = vec!["bits 128".to_owned()];
                lines.extend((!reading.is_empty()).then(|| reading.to_owned()));
                for (k, cell) in (1..).zip(cells) {
                    let at = if index { format!("{k} ") } else { String::new() };
                    let verdict = if k < count { "nearest" } else { verdict };
                    lines.push(format!("cell {at}\"{cell}\" {verdict}"));
                }
                lines.push(format!("outcome {outcome}"));
                lines
            };
            let verdicts = [
                ("nearest", "nearest"),
                ("ulps 1", "ulps"),
                ("ulps 2", "ulps"),
                ("ulps 18", "ulps"),
                ("rounded 6", "cut"),
                ("rounded 3", "cut"),
                ("cut 6", "cut"),
                ("misprint exchanged", "misprint"),
                ("misprint digit", "misprint"),
                ("refuted 0", "refuted"),
                ("refuted 1", "refuted"),
                ("open", "open"),
            ];
            let mut seeds: Vec<_> =
                verdicts.iter().map(|(verdict, outcome)| lines(verdict, "", outcome)).collect();
            for reading in ["convention 1", "early unused 17", "early g 17", "early g single"] {
                seeds.extend(
                    verdicts.iter().map(|(verdict, _)| lines(verdict, reading, "otherwise")),
                );
            }
            // What is wrong may be far off in one number, and a digit or more in another.
            let falsehood = move |block: &[String]| {
                let word = block.last()?.strip_prefix("outcome ")?;
                let fits = match known {
                    Some(known) => word == known,
                    None => ["refuted", "misprint"].contains(&word),
                };
                (!fits).then(|| format!("the outcome is not {word}"))
            };
            Claim {
                head: format!("shipped {id}"),
                restated: Vec::new(),
                seeds,
                lies: Vec::new(),
                replaced: Default::default(),
                falsehood: Box::new(falsehood),
            }
        };
        let first = one("own", equals, Some(outcome));
        let other = one("more", &format!("{equals} + 1"), None);
        pairs.push(Pair { claims: [first, other], exclusive: false, complementary: false });
    }
    Suite { about: "project numbers", claims, pairs }
}
