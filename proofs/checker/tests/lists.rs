//! Relations that state several texts: their comparisons are numbered through all of them.

use crate::masks::relation;
use subcert_check::Outcome;

/// The outcome for these texts, for these values of indices, with these lines behind the texts.
fn outcome(texts: &[&str], of: &str, lines: &str) -> Outcome {
    let listed: Vec<String> = texts.iter().map(|text| format!("'{text}'")).collect();
    let indices = if of.is_empty() { String::new() } else { format!("for = {of}\n") };
    let fields = format!("states = [{}]\n{indices}", listed.join(", "));
    let said = texts.iter().map(|text| format!("states {text}\n "));
    relation(&fields, &said.chain([lines.to_owned()]).collect::<Vec<String>>().concat())
}

fn valid(texts: &[&str], of: &str, lines: &str) -> bool {
    outcome(texts, of, lines) == Outcome::Valid
}

/// The texts, the entries of `for`, and the lines that are right.
type Claim = (&'static [&'static str], &'static str, &'static str);

const CLAIMS: &[Claim] = &[
    (&["1 < 2"], "", "holds 1"),
    (&["1 < 2", "2 < 3"], "", "holds 2"),
    (&["1 < 2 < 3", "3 in {3, 4}", "kronecker(1, 1)", "not 0"], "", "holds 5"),
    (&["1 < 2", "2 < 1"], "", "fails 2\n case 2 = 1"),
    (&["2 < 1 < 0", "1 = 1", "5 = 3"], "", "fails 4\n case 1 = 1\n case 2 = 1\n case 4 = 2"),
    (&["n > 0", "n < 3"], "'n = 1..3'", "fails 6\n case 3 2 = 0"),
    (&["n in [0, 2]", "n = 1"], "'n = 1, 2'", "fails 6\n case 2 3 = 1"),
    (&["n > 0", "n^2 ≥ n"], "'all n'", "holds all"),
    (&["n > 0", "n^2 > n"], "'all n'", "fails all\n case 1 2 = 0"),
    (&["v^2 ≥ 0", "v < 3"], "'0 < v < 3'", "holds reals"),
    (&["v^2 ≥ 0", "v < 2"], "'0 < v < 3'", "fails reals\n false 2 2"),
    (&["sqrt(2) < 3/2", "sqrt(2)*sqrt(2) = 2"], "", "holds 2"),
    (&["sqrt(2) < 3/2", "root([-2, 0, 0, 1], 1) > 2"], "", "fails 2\n case 2 in -1 -0.7"),
    (&["sum_rules(four) = 4", "1/3 ≈ 0.33"], "", "holds 2"),
    // Two comparisons of one text have the numbers of two texts.
    (&["1 < 2 < 1"], "", "fails 2\n case 2 = 1"),
];

#[test]
fn several_texts() {
    for (texts, of, lines) in CLAIMS {
        assert_eq!(outcome(texts, of, lines), Outcome::Valid, "{texts:?} {of}");
    }
}

/// Every line dropped, twice or exchanged with the next one, and every digit changed.
#[test]
fn changed_certificates() {
    let mut count = 0;
    for (texts, of, lines) in CLAIMS {
        let said: Vec<String> = texts.iter().map(|text| format!("states {text}")).collect();
        let all: Vec<String> =
            said.into_iter().chain(lines.lines().map(|line| line.trim().to_owned())).collect();
        let listed: Vec<String> = texts.iter().map(|text| format!("'{text}'")).collect();
        let indices = if of.is_empty() { String::new() } else { format!("for = {of}\n") };
        let fields = format!("states = [{}]\n{indices}", listed.join(", "));
        let mut altered = Vec::new();
        for i in 0..all.len() {
            altered.push([&all[..i], &all[i + 1..]].concat());
            altered.push([&all[..=i], &all[i..]].concat());
            if i + 1 < all.len() {
                let mut other = all.clone();
                other.swap(i, i + 1);
                altered.push(other);
            }
            for (at, digit) in all[i].char_indices().filter(|(_, c)| c.is_ascii_digit()) {
                let mut other = all.clone();
                let next = if digit == '9' { '0' } else { char::from(digit as u8 + 1) };
                other[i].replace_range(at..=at, &next.to_string());
                altered.push(other);
            }
        }
        for other in altered.into_iter().filter(|other| *other != all) {
            let found = relation(&fields, &other.join("\n "));
            // Bounds may be other ones.
            let bounds = other.iter().any(|line| line.contains(" in -"));
            assert!(bounds || found != Outcome::Valid, "{texts:?}: {other:?}");
            count += 1;
        }
    }
    assert!(count > 100, "{count}");
}

/// A list states all its comparisons, in its order, under no other numbers.
#[test]
fn what_is_no_list() {
    for (texts, of, lines) in [
        (&["1 < 2", "2 < 1"][..], "", "holds 2"),
        (&["1 < 2", "2 < 1"], "", "holds 1"),
        (&["1 < 2", "2 < 1"], "", "fails 2\n case = 1"),
        (&["1 < 2", "2 < 1"], "", "fails 2\n case 1 = 1"),
        (&["1 < 2", "2 < 1"], "", "fails 1\n case 2 = 1"),
        (&["2 < 1"], "", "fails 1\n case 1 = 1"),
        (&["1 < 2", ""], "", "holds 1"),
        (&["1 < 2", ""], "", "holds 2"),
        (&["1 < 2", "1 == 1"], "", "holds 2"),
        (&["1 < 2", "w = w"], "", "holds 2"),
        (&["1 < 2", "1/0 = 1"], "", "fails 2\n case 2 = 1"),
        (&["n > 0", "n > 1"], "'all n'", "holds all"),
        (&["n > 0", "n > 1"], "'all n'", "fails all\n case 1 1 = 1"),
        (&["n > 0", "n > 1"], "'all n'", "fails all\n case 1 = 0"),
        (&["v > 0", "v > 1"], "'v > 0'", "holds reals"),
        (&["v > 0", "v > 1"], "'v > 0'", "fails reals\n false 1"),
        (&["v > 0", "v > 1"], "'v > 0'", "fails reals\n false 1 1"),
        (&["v > 0", "v ≈ 1"], "'v > 0'", "holds reals"),
        (&[], "", "holds 0"),
        (&[], "", "holds 1"),
        (&[], "'n = 1..3'", "holds 3"),
        (&[], "'all n'", "holds all"),
        (&[], "'real v'", "holds reals"),
    ] {
        assert!(!valid(texts, of, lines), "{texts:?}: {lines}");
    }
    for (fields, lines) in [
        ("states = [['1 < 2']]", "states 1 < 2\n holds 1"),
        ("states = ['1 < 2', '2 < 3']", "states 1 < 2, 2 < 3\n holds 2"),
        ("states = ['1 < 2', '2 < 3']", "states 1 < 2 states 2 < 3\n holds 2"),
        ("states = ['1 < 2', '2 < 3']\nabsent = 'x'", "absent x"),
        ("states = []\nabsent = 'x'", "absent x"),
        ("states = { a = '1 < 2' }", "states 1 < 2\n holds 1"),
        ("states = [{ printed = '1 < 2' }]", "states 1 < 2\n holds 1"),
    ] {
        assert_ne!(relation(fields, lines), Outcome::Valid, "{fields}");
    }
    let listed = "states 1 < 2\n holds 1";
    assert_eq!(relation("states = ['1 < 2']", listed), relation("states = '1 < 2'", listed));
}
