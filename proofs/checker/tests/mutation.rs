//! Changed certificates: what is changed in a certificate is refused, or says the same.

use crate::rules::claims;
use num_bigint::BigInt;
use subcert_check::{Outcome, check};

const CLAIMS: &str = include_str!("rules/claims.toml");

const CERTIFICATES: [&str; 18] = [
    include_str!("rules/accepted/table-constants.cert"),
    include_str!("rules/accepted/table-slips.cert"),
    include_str!("rules/accepted/equation-identity.cert"),
    include_str!("rules/accepted/relation-chain.cert"),
    include_str!("rules/accepted/relation-cubic.cert"),
    include_str!("rules/accepted/function-unequal.cert"),
    include_str!("rules/accepted/range-below.cert"),
    include_str!("rules/accepted/theorem-sum.cert"),
    include_str!("rules/accepted/theorem-net.cert"),
    include_str!("rules/accepted/theorem-depth.cert"),
    include_str!("rules/accepted/theorem-face.cert"),
    include_str!("rules/accepted/theorem-vertex-step.cert"),
    include_str!("rules/accepted/theorem-edge.cert"),
    include_str!("rules/accepted/theorem-cited.cert"),
    include_str!("rules/accepted/promises.cert"),
    include_str!("rules/accepted/levels-times.cert"),
    include_str!("rules/accepted/levels-net-distance.cert"),
    include_str!("rules/accepted/levels-face-distance.cert"),
];

/// The certificates, but for the lines that state more than the verdicts: without one of
/// them, or with another one, a certificate may well be right.
fn certificates() -> Vec<String> {
    let needed = |line: &&str| {
        !["attained", "sound", "#!"].contains(&line.split_whitespace().next().unwrap_or("#!"))
    };
    let text = |text: &&str| {
        text.lines().filter(needed).collect::<Vec<_>>().join(
            "
",
        )
    };
    CERTIFICATES.iter().map(text).collect()
}

fn all_valid(text: &str) -> bool {
    let report = check(&claims("accepted", text), &[text]).expect("a claim file");
    let proper = |outcome: &Outcome| {
        matches!(outcome, Outcome::Valid | Outcome::Cited(_) | Outcome::Incomplete(None))
    };
    report.broken.is_empty() && report.claims.iter().all(|(_, _, outcome)| proper(outcome))
}

/// Numbers without their zeros behind the point, and single blanks: what may differ.
fn meaning(text: &str) -> Vec<String> {
    let word = |word: &str| {
        let plain = word.contains('.') && !word.contains('"');
        let word = if plain { word.trim_end_matches('0').trim_end_matches('.') } else { word };
        word.to_owned()
    };
    text.split_whitespace().map(word).collect()
}

#[test]
fn a_missing_or_repeated_line_is_noticed() {
    for text in certificates() {
        assert!(all_valid(&text));
        let lines: Vec<&str> = text.lines().collect();
        for at in 0..lines.len() {
            let less = [&lines[..at], &lines[at + 1..]].concat().join("\n");
            assert!(!all_valid(&less), "without line {}:\n{text}", at + 1);
            // The last row of a net goes on.
            let more = [&lines[..=at], &lines[at..]].concat().join("\n");
            let goes_on = lines[at].trim().starts_with("row ");
            assert!(goes_on || !all_valid(&more), "with line {} twice:\n{text}", at + 1);
        }
    }
}

#[test]
fn a_changed_character_is_noticed() {
    let (mut tried, mut accepted) = (0, 0);
    for text in certificates() {
        let characters: Vec<char> = text.trim_end().chars().collect();
        for at in 0..characters.len() {
            // A digit for a digit, a sign for a sign, a letter for a letter.
            let other = match characters[at] {
                '0'..='8' => char::from(characters[at] as u8 + 1),
                '9' => '0',
                '-' => '+',
                '+' => '-',
                c if c.is_ascii_lowercase() => {
                    if c == 'z' {
                        'a'
                    } else {
                        'z'
                    }
                }
                _ => continue,
            };
            let mut changed = characters.clone();
            changed[at] = other;
            let changed: String = changed.into_iter().collect();
            // Without a reading, `family` is a bound, and a larger one may do.
            let bound = !text.contains("  read ")
                && changed
                    .lines()
                    .zip(text.lines())
                    .any(|(line, was)| line != was && was.contains("family "));
            // Other data may have the same difference, and other constants keep a promise too.
            let free = ["polygon ", "net ", "row ", "ring ", "at ", "kept "];
            let other = changed.lines().zip(text.lines()).find(|(line, was)| line != was);
            let free = other.is_some_and(|(_, was)| {
                let later = was.trim().starts_with("level ") && was.split_whitespace().count() > 2;
                later || free.iter().any(|f| was.trim().starts_with(f))
            });
            tried += usize::from(free);
            if all_valid(&changed) {
                assert!(bound || free, "character {at} of:\n{text}\nis\n{changed}");
                accepted += usize::from(free);
            }
        }
    }
    assert!(4 * accepted < tried, "{accepted} of {tried}");
}

/// The places of the whole numbers in a text.
fn numbers(text: &str) -> Vec<std::ops::Range<usize>> {
    let digit = |at: usize| text.as_bytes()[at].is_ascii_digit();
    let starts = (0..text.len()).filter(|&at| digit(at) && (at == 0 || !digit(at - 1)));
    starts.map(|at| at..(at..text.len()).find(|&end| !digit(end)).unwrap_or(text.len())).collect()
}

/// A number that an integer of 32, 64 or 128 bits would take for this one, or that is next to the end of such integers
/// or of what a double holds.
fn extreme(number: &str, which: usize) -> BigInt {
    let own: BigInt = number.parse().expect("digits");
    let power = |bits: u32| BigInt::from(2).pow(bits);
    match which % 10 {
        0 => own + power(32),
        1 => own + power(64),
        2 => power(64) - own,
        3 => own + power(128),
        4 => power(31),
        5 => power(32) - 1,
        6 => power(53) + 1,
        7 => power(63),
        8 => power(63) - 1,
        _ => power(127) + own,
    }
}

/// Lines whose numbers may be others: data, which may break a promise too, and bounds.
const FREE: [&str; 14] = [
    "polygon ",
    "net ",
    "row ",
    "ring ",
    "at ",
    "kept ",
    "breaks ",
    "end ",
    "broken ",
    "attained ",
    "powers ",
    "box ",
    "eigenvalue 1 ",
    // A claim about real values may be false for many of them.
    "false ",
];

#[test]
fn an_extreme_number_is_noticed() {
    let mut which = 0;
    for (name, text) in crate::rules::certificates("accepted") {
        // The numbers of an upper bound of a radius may be others, and take long to check.
        if text.contains("  image ") {
            continue;
        }
        let claims = claims("accepted", &text);
        let is_valid = |text: &str| {
            let report = check(&claims, &[text]).expect("a claim file");
            let proper = |outcome: &Outcome| {
                matches!(outcome, Outcome::Valid | Outcome::Cited(_) | Outcome::Incomplete(None))
            };
            report.broken.is_empty() && report.claims.iter().all(|(_, _, outcome)| proper(outcome))
        };
        assert!(is_valid(&text), "{name}");
        for place in numbers(&text) {
            let line = text[..place.start].rsplit('\n').next().unwrap_or("").trim_start();
            // A residue class has many numbers, and so has an angle.
            if line.contains("cos(") {
                continue;
            }
            let class = line.starts_with("constant ") && line.split_whitespace().count() == 5;
            if class || line.starts_with('#') || FREE.iter().any(|free| line.starts_with(free)) {
                continue;
            }
            which += 1;
            let other = extreme(&text[place.clone()], which).to_string();
            let changed = [&text[..place.start], &other, &text[place.end..]].concat();
            assert!(!is_valid(&changed), "{name}: {line} goes on with {other}");
        }
    }
}

/// Bytes that no one would write: the checker gives an answer, and not a wrong one.
#[test]
fn noise_is_refused_without_a_panic() {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut next = |below: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        usize::try_from(state % below as u64).unwrap_or(0)
    };
    let pieces = [
        "(",
        ")",
        "[",
        "]",
        "\"",
        "'",
        "^",
        "*",
        "/",
        "-",
        "..",
        "=",
        ",",
        "sum(",
        "9",
        "1e9",
        "\n",
        "\n  ",
        "cell",
        "undefined",
        "−",
        "cos(2*pi/7)",
        "{",
        "}",
        "#",
        " x ",
        "max(",
    ];
    for round in 0..150 {
        for text in &certificates() {
            let mut characters: Vec<char> = text.chars().collect();
            for _ in 0..=round % 4 {
                let at = next(characters.len());
                let length = next(4).min(characters.len() - at);
                characters.splice(at..at + length, pieces[next(pieces.len())].chars());
            }
            let changed: String = characters.into_iter().collect();
            let same = meaning(&changed) == meaning(text) || changed.contains('#');
            assert!(!all_valid(&changed) || same, "{changed}");
        }
        // The claim file too.
        let mut characters: Vec<char> = CLAIMS.chars().collect();
        let at = next(characters.len());
        let length = next(4).min(characters.len() - at);
        characters.splice(at..at + length, pieces[next(pieces.len())].chars());
        let _ = check(&characters.into_iter().collect::<String>(), &CERTIFICATES);
    }
}
