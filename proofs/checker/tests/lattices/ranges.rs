//! Ranges of a parameter in which the limits of masks on Z^d are smooth.
//!
//! The lines of `courant-range` are those of the program. What they say is checked against the range in which this scheme converges.

use super::limits::lines;
use subcert_check::{Outcome, check};

/// A box spline of three directions where w = 0. Far from there the scheme diverges.
const SCHEME: &str = "
[[scheme]]
name = 'own'
parameters.w = { about = 'weight' }
symbol = '(1+x)*(1+y)*(1+x*y)/2*(1+w*(3-x-y-1/(x*y)))'
";

/// The outcome of a claim of C^m for these ends, with these lines and this verdict.
fn outcome((m, ends): (&str, &str), lines: &str, verdict: &str) -> Outcome {
    let claims = format!(
        "key = 'k'\n{SCHEME}\n[[range]]\nid = 'c'\nscheme = 'own:w=w'\nvariable = 'w'\nsmoothness = '{m}'\n{ends}\n"
    );
    let lines = lines.trim_end().replace('\n', "\n ");
    let certificate = format!(
        "subcert-certificate 4\npaper k\nrange c\n variable w\n scheme own:w=w\n smoothness {m}\n {lines}\n {verdict}\nend 1\n"
    );
    let report = check(&claims, &[&certificate]).expect("a claim file");
    report.claims.into_iter().next().expect("a claim").2
}

/// The claim that the lines prove, and one that is false: at w = 1/2 the scheme diverges.
const TRUE: (&str, &str) = ("0", "from = '-1/10'\nto = '1/10'");
const FALSE: (&str, &str) = ("0", "from = '-1'\nto = '1'");

#[test]
fn pieces() {
    let lines = lines("courant-range");
    let valid = |claim, verdict| outcome(claim, &lines, verdict) == Outcome::Valid;
    for (ends, expected) in [
        ("from = '-1/10'\nto = '1/10'", true),
        ("from = '-1/10'\nto = '1/10'\nclosed = true", true),
        ("from = '-1/11'\nto = '0.05'", true),
        ("from = 'sqrt(2)/1000'\nto = 'sqrt(2)/20'", true),
        ("from = 'sqrt(2)/1000'\nto = 'sqrt(2)/10'", false),
        ("from = '-1/10'\nto = '1/10'\nonly = true", false),
        ("from = '-1/10'", false),
        ("to = '1/10'", false),
        ("from = '-0.11'\nto = '1/10'", false),
        ("from = '-1/10'\nto = '101/1000'", false),
    ] {
        assert_eq!(valid(("0", ends), "confirmed"), expected, "{ends}");
        assert!(!valid(("0", ends), "refuted"), "{ends}");
    }
    assert!(!valid(("1", TRUE.1), "confirmed"));
    assert!(!valid(("2", TRUE.1), "confirmed"));
}

/// Reasons for which lines are refused.
#[test]
fn reasons() {
    let lines = lines("courant-range");
    for (from, to, why) in [
        ("piece -1/10 1/10", "piece 1/10 -1/10", "of which the first is less"),
        ("piece -1/10 1/10", "piece -1/10", "the ends of a piece"),
        ("piece -1/10 1/10\n", "", "a piece"),
        ("piece -1/10 1/10", "piece -1/10 1/20", "whole printed range"),
        ("tile digits", "tile hexagon +", "the group of the tile keeps the mask"),
        ("part 1 0 0 1 0 1", "part 1 0 0 1 0 2", "one digit of each class"),
        ("block\n", "", "block"),
    ] {
        assert!(lines.contains(from), "{from}");
        let found = outcome(TRUE, &lines.replacen(from, to, 1), "confirmed");
        let (Outcome::Invalid(_, rejection) | Outcome::Incomplete(Some(rejection))) = found else {
            panic!("{from} → {to}: {found:?}");
        };
        let reason = rejection.reason.to_string();
        assert!(reason.contains(why), "{from} → {to}: {reason}");
    }
}

/// A piece may overlap the one before it, and begins at its end at the latest.
#[test]
fn several_pieces() {
    let lines = lines("courant-range");
    let (before, rest) = lines.split_once("block\n").expect("a block");
    let (first, behind) = rest.split_once("block\n").expect("another one");
    let two = |next: &str| {
        let next = first.replace("piece -1/10 1/10", next);
        outcome(TRUE, &format!("{before}block\n{first}{next}block\n{behind}"), "confirmed")
    };
    assert_eq!(two("piece -1/10 1/10"), Outcome::Valid);
    let Outcome::Invalid(_, rejection) = two("piece 1/9 1/8") else { panic!("a gap") };
    assert!(rejection.reason.to_string().contains("whole printed range"), "{rejection:?}");
}

/// Lines that are left out, doubled or exchanged, and other numbers, prove no false claim.
#[test]
fn altered_lines() {
    let own = lines("courant-range");
    let wide = own.replace("piece -1/10 1/10", "piece -1 1");
    let mut count = 0;
    for (claim, text, verdict) in [(FALSE, &wide, "confirmed"), (TRUE, &own, "refuted")] {
        let lines: Vec<&str> = text.lines().collect();
        for at in (1..lines.len()).filter(|at| *at < 20 || at % 5 == 0) {
            let mut all = vec![lines.clone(); 3];
            all[0].remove(at);
            all[1].insert(at, lines[at]);
            all[2].swap(at, at - 1);
            let mut all: Vec<String> = all.into_iter().map(|lines| lines.join("\n")).collect();
            for (old, new) in [("1", "0"), ("2", "1"), ("0", "1"), (" ", " -"), ("1", "1/2")] {
                if let Some(place) = lines[at].rfind(old) {
                    let mut line = lines[at].to_owned();
                    line.replace_range(place..=place, new);
                    let mut changed = lines.clone();
                    changed[at] = &line;
                    all.push(changed.join("\n"));
                }
            }
            for text in all {
                count += 1;
                assert_ne!(outcome(claim, &text, verdict), Outcome::Valid, "{}", lines[at]);
            }
        }
    }
    assert!(count > 800, "{count}");
}
