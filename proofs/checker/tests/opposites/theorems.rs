//! Bounds of Chaikin's scheme next to the suprema, which are known: the differences after k levels are 1/2^k of the
//! first ones. A step and a distance are 1/4 and 1/2 of them where points are at i/2^k, and 1/8 and 1/4 where they
//! are at (i + s)/2^k for the best s.

use super::suite::{Claim, Pair, Suite};
use std::fmt::Write as _;

/// A quantity, a bound that holds, one that does not, and one that only holds for the best shift.
const BOUNDS: [(&str, [&str; 4]); 3] = [
    ("difference", ["beta/2^k", "beta*(51/100)^k", "beta*49/100/2^(k - 1)", "beta*(49/100)^k"]),
    ("step", ["beta/4/2^k", "beta*26/100/2^k", "beta*24/100/2^k", "beta*6/25*(51/100)^k"]),
    ("distance", ["beta/2/2^k", "beta*51/100/2^k", "beta*49/100/2^k", "beta*3/10*(51/100)^k"]),
];

fn lines(text: &str) -> Vec<String> {
    text.split("; ").map(str::to_owned).collect()
}

/// The pairs: a bound that holds, and a smaller one.
pub fn suite() -> Suite {
    let mut claims = "key = 'bounds'\n".to_owned();
    let mut pairs = Vec::new();
    for (quantity, bounds) in BOUNDS {
        for (place, sides) in [[0, 2], [1, 3]].into_iter().enumerate() {
            let mut claim = |side: usize| {
                let (id, by) = (format!("{quantity}-{place}-{side}"), bounds[sides[side]]);
                let _ = writeln!(
                    claims,
                    "[[theorem]]\nid = '{id}'\nscheme = 'chaikin'\nbounds = '{quantity}'\nby = '{by}'\nfrom = '1'\noffset = '0'"
                );
                let (holds, everywhere) = (side == 0, quantity == "difference");
                let falsehood = move |block: &[String]| {
                    let word = block.last()?.clone();
                    let shifted =
                        |line: &String| ["naturally", "in-every-shift"].contains(&line.trim());
                    match &word[..] {
                        "proved" if !holds => Some("data violate this bound".to_owned()),
                        "refuted" if holds => Some("the bound holds".to_owned()),
                        "refuted" if !everywhere && block.iter().any(shifted) => {
                            Some("the bound holds in one shift".to_owned())
                        }
                        _ => None,
                    }
                };
                Claim {
                    head: format!("theorem {id}"),
                    restated: vec![format!("bounds {quantity}"), format!("by {by}")],
                    seeds: seeds(quantity),
                    lies: vec!["proved".to_owned(), "refuted".to_owned()],
                    replaced: Default::default(),
                    falsehood: Box::new(falsehood),
                }
            };
            let claims = [claim(0), claim(1)];
            pairs.push(Pair { claims, exclusive: false, complementary: true });
        }
    }
    Suite { about: "paper bounds", claims, pairs }
}

/// Certificates of bounds of this quantity.
fn seeds(quantity: &str) -> Vec<Vec<String>> {
    let mut seeds = Vec::new();
    let level =
        if quantity == "distance" { "level 1 12 1 1; level 2 12 1 1" } else { "level 1; level 2" };
    for ratio in ["1/2", "51/100", "49/100"] {
        seeds.push(lines(&format!("scheme chaikin; grows 1 {ratio}; times 2; {level}; proved")));
        seeds.push(lines(&format!(
            "scheme chaikin; grows 1 {ratio}; times 1; {}; proved",
            level.split(';').next().unwrap_or_default()
        )));
    }
    // Of data whose first sides are the suprema, and the second sides for each bound.
    let (data, left) = match quantity {
        "difference" => ("polygon 0 0 1; at 0", "1/2"),
        "step" => ("polygon 0 0 1; at 1", "1/8"),
        _ => ("polygon 0 0 1; at 0", "1/4"),
    };
    let shifts = [
        "naturally; scheme chaikin; level 1; polygon 0 0 1 2 1 0; at 1/2",
        "in-every-shift; scheme chaikin; level 1; polygon 0 0 1 2 1 0",
        "in-every-shift; scheme chaikin; level 1; polygon 0 0 1 2 1 0; limit at-most 7/4 1",
    ];
    for right in [
        "1/2", "51/100", "49/100", "1/8", "13/100", "3/25", "153/1250", "1/4", "51/200", "49/200",
        "153/1000",
    ] {
        let first = format!("scheme chaikin; level 1; {data}; sides {left} {right}");
        seeds.push(lines(&format!("{first}; refuted")));
        for shift in shifts {
            seeds.push(lines(&format!("{first}; {shift}; sides 1/8 {right}; refuted")));
        }
    }
    seeds
}
