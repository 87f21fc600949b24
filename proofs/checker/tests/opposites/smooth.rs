//! Claims about smoothness, exponents and ranges of smoothness, and their opposites.

use super::masks::{Mask, int, random_mask, spline_times};
use super::mutator::Random;
use super::suite::{Claim, Falsehood, Pair, Suite};
use std::fmt::Write as _;

/// How far a number is from a bound that floating-point numbers show.
pub const MARGIN: f64 = 1e-6;

/// What is claimed of an exponent.
#[derive(Clone)]
enum Stated {
    AtLeast(f64),
    AtMost(f64),
    Equal(f64),
    /// A decimal, and half of the unit of its last place.
    Printed(f64, f64),
}

impl Stated {
    /// Whether it holds, if the bounds of the exponent say so.
    fn holds(&self, [low, high]: [f64; 2]) -> Option<bool> {
        if low <= MARGIN || high < MARGIN {
            // Of a scheme that diverges, nothing is true.
            return (high < -MARGIN).then_some(false);
        }
        let (from, to) = match *self {
            Stated::AtLeast(x) => (x, f64::INFINITY),
            Stated::AtMost(x) => (f64::NEG_INFINITY, x),
            Stated::Equal(x) => (x - MARGIN, x + MARGIN),
            Stated::Printed(x, half) => (x - half, x + half),
        };
        if low > to + MARGIN || high < from - MARGIN {
            return Some(false);
        }
        (low > from + MARGIN && high < to - MARGIN).then_some(true)
    }
}

/// What is false of a claim that all of these hold, if its block is accepted.
pub fn falsehood(parts: &[Option<bool>], rounded: Vec<(&'static str, Option<bool>)>) -> Falsehood {
    let known = |truth: bool| move |part: &Option<bool>| *part == Some(truth);
    let (refutable, sure) = (parts.iter().any(known(false)), parts.iter().all(known(true)));
    Box::new(move |block| {
        let last = block.last().map_or("", String::as_str);
        match last.trim() {
            "confirmed" if refutable => Some("the claim is false".to_owned()),
            "refuted" if sure => Some("the claim is true".to_owned()),
            last => {
                let wrong =
                    rounded.iter().any(|(word, holds)| *word == last && *holds == Some(false));
                wrong.then(|| "the decimal is not rounded so".to_owned())
            }
        }
    })
}

pub fn lines(texts: &[&str]) -> Vec<String> {
    texts.iter().map(|&text| text.to_owned()).collect()
}

/// The masks of a run: splines, some with factors, and random ones.
fn masks(random: &mut Random) -> Vec<Mask> {
    let one = [int(1)];
    let dependent = [int(1), int(-1), int(1)];
    let four_point = [int(-1), int(4), int(-1)];
    let mut masks: Vec<Mask> = [
        (2, 6, &one[..]),
        (2, 4, &one),
        (2, 2, &one),
        (3, 3, &one),
        (2, 4, &dependent),
        (2, 4, &four_point),
    ]
    .into_iter()
    .map(|(n, order, b)| Mask::new(n, spline_times(n, order, b)))
    .collect();
    // The factor z² − z + 1 combines shifts of the spline of the same order, and takes nothing away from its smoothness.
    masks[4].exponent = [3.0; 2];
    masks.extend((0..8).map(|_| random_mask(random, 5)));
    masks
}

/// Claims about the smoothness and the exponent of random masks.
pub fn suite(random: &mut Random) -> Suite {
    let mut claims = "key = 'smooth'\n".to_owned();
    let mut pairs = Vec::new();
    for (place, mask) in masks(random).into_iter().enumerate() {
        let name = format!("m{place}");
        let _ = writeln!(claims, "[[scheme]]\nname = '{name}'\n{}", mask.toml());
        let mut radius = |word: &str| {
            let of = |order| {
                let mut lines = mask.radius(random, order);
                lines.push(word.to_owned());
                lines
            };
            (0..=mask.order).chain([mask.order; 3]).map(of).collect::<Vec<_>>()
        };
        for m in 0..=4 {
            let [low, high] = mask.exponent;
            let is = |m: f64| {
                if low > m + MARGIN { Some(true) } else { (high < m - MARGIN).then_some(false) }
            };
            let smooth = is(f64::from(m));
            let mut claim = |kind: &str, word: &str, stated: Option<bool>| {
                let id = format!("{kind}-{name}-{m}");
                let field = word.replace('-', "_");
                let _ = writeln!(
                    claims,
                    "[[smoothness]]\nid = '{id}'\nscheme = '{name}'\n{field} = '{m}'"
                );
                Claim {
                    head: format!("smoothness {id}"),
                    restated: vec![format!("scheme {name}"), format!("states-{word} {m}")],
                    seeds: radius(if stated == Some(false) { "refuted" } else { "confirmed" }),
                    lies: lines(&["confirmed", "refuted"]),
                    replaced: Default::default(),
                    falsehood: falsehood(&[stated], Vec::new()),
                }
            };
            let one = claim("c", "continuous", smooth);
            let other = claim("n", "not-continuous", smooth.map(|smooth| !smooth));
            pairs.push(Pair { claims: [one, other], exclusive: true, complementary: true });
        }
        pairs.extend(exponents(&mut claims, &name, &mask, &mut radius));
    }
    Suite { about: "paper smooth", claims, pairs }
}

/// Claims about the exponent.
fn exponents(
    claims: &mut String,
    name: &str,
    mask: &Mask,
    radius: &mut dyn FnMut(&str) -> Vec<Vec<String>>,
) -> Vec<Pair> {
    let mut pairs = Vec::new();
    let mut claim = |id: String, stated: &[(&str, &str, Stated)]| {
        let _ = writeln!(claims, "[[exponent]]\nid = '{id}'\nscheme = '{name}'");
        let mut restated = vec![format!("scheme {name}")];
        // In the order of the rule.
        for word in ["value", "at-least", "at-most", "printed"] {
            for (_, text, _) in stated.iter().filter(|(known, ..)| *known == word) {
                let _ = writeln!(claims, "{} = '{text}'", word.replace('-', "_"));
                restated.push(format!("{word} {text}"));
            }
        }
        let parts = stated.iter().map(|(_, _, part)| part.holds(mask.exponent));
        let mut rounded = Vec::new();
        for (_, _, part) in stated {
            // The other parts hold whatever the rounding of the decimal is.
            let Stated::Printed(x, half) = *part else {
                let holds = part.holds(mask.exponent);
                rounded.extend([("rounding cut", holds), ("rounding away", holds)]);
                continue;
            };
            let [low, high] = mask.exponent;
            let apart =
                |from: f64, to: f64| (low > to + MARGIN || high < from - MARGIN).then_some(false);
            rounded.push(("rounding cut", apart(x + half, x + 2.0 * half)));
            rounded.push(("rounding away", apart(x - 2.0 * half, x - half)));
        }
        let mut parts: Vec<Option<bool>> = parts.collect();
        if let [(_, _, Stated::Printed(x, half))] = stated {
            // A decimal that is cut or rounded away is not refuted.
            let [low, high] = mask.exponent;
            let near = low > x - 2.0 * half + MARGIN && high < x + 2.0 * half - MARGIN;
            parts = vec![if near && parts[0] != Some(false) { Some(true) } else { parts[0] }];
        }
        Claim {
            head: format!("exponent {id}"),
            restated,
            seeds: radius("confirmed"),
            lies: lines(&["confirmed", "refuted", "rounding cut", "rounding away"]),
            replaced: Default::default(),
            falsehood: falsehood(&parts, rounded),
        }
    };
    for (place, x) in ["1", "3/2", "2", "5/2"].into_iter().enumerate() {
        let number = [1.0, 1.5, 2.0, 2.5][place];
        let one =
            claim(format!("least-{name}-{place}"), &[("at-least", x, Stated::AtLeast(number))]);
        let below = format!("{x} - 1/10");
        let other = claim(
            format!("most-{name}-{place}"),
            &[("at-most", &below, Stated::AtMost(number - 0.1))],
        );
        pairs.push(Pair { claims: [one, other], exclusive: true, complementary: false });
    }
    // The decimal next to the exponent, another one, and both with a bound that contradicts it.
    let middle = mask.exponent[0].clamp(0.1, 9.0);
    let [near, far] = [0.0, 1.07].map(|more| format!("{:.2}", middle + more));
    let stated = |text: &str| Stated::Printed(text.parse().unwrap_or(0.0), 0.005);
    let one = claim(format!("near-{name}"), &[("printed", &near, stated(&near))]);
    let other = claim(format!("far-{name}"), &[("printed", &far, stated(&far))]);
    pairs.push(Pair { claims: [one, other], exclusive: true, complementary: false });
    let beyond = format!("{near} + 1");
    let value: f64 = near.parse::<f64>().unwrap_or(0.0) + 1.0;
    let both = |word, part| [("printed", &near[..], stated(&near)), (word, &beyond[..], part)];
    let one = claim(format!("equal-{name}"), &both("value", Stated::Equal(value)));
    let other = claim(format!("more-{name}"), &both("at-least", Stated::AtLeast(value)));
    pairs.push(Pair { claims: [one, other], exclusive: false, complementary: false });
    pairs
}
