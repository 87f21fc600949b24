//! Constants of so many residue classes that the checker takes bounds of all rows.

use proptest::prelude::*;
use subcert::audit::audit;
use subcert::certificate::certificate;
use subcert::claim::{Paper, read_paper};
use subcert::diagnostic::SourceText;
use subcert::exact::Rational;
use subcert::scheme::{Mask, Rules, parse_scheme};
use subcert_check::{Outcome, Reason, check};

/// A paper with a table of `value` at these levels for a scheme, which may be its own; what it
/// prints is lost.
fn paper(scheme: &str, own: &str, value: &str, levels: &[u32]) -> Paper {
    let list = |words: Vec<String>| format!("['{}']", words.join("', '"));
    let headers = list(levels.iter().map(ToString::to_string).collect());
    let text = format!(
        "key = \"test\"
         [paper]
         authors = [\"N\"]
         title = \"T\"
         venue = \"V\"
         year = \"2026\"
         numbered = [\"Table 1\"]
         {own}
         [[table]]
         id = \"table-1\"
         title = \"T\"
         locus = \"Table 1\"
         scheme = \"{scheme}\"
         value = '{value}'
         columns = {{ name = \"c\", values = {headers} }}
         cells = \"lost\""
    );
    read_paper(&SourceText::new("test", text)).expect("a claim file")
}

/// What the checker says of the only claim.
fn outcome(paper: &Paper, certificate: &str) -> Outcome {
    let mut report = check(&paper.source.text, &[certificate]).expect("a claim file");
    assert!(report.broken.is_empty(), "{:?}", report.broken);
    report.claims.pop().expect("a claim").2
}

fn written(paper: &Paper) -> String {
    certificate(&audit(paper).expect("an audit")).text
}

#[test]
fn constants_of_many_levels_are_certified() {
    for (scheme, value, levels) in [
        ("four-point", "contraction(c)*2^c", vec![20, 64, 256]),
        ("six-point:w=3/256", "tensor(c)*2^c", vec![24, 64]),
        ("ternary-four-point:mu=1/11", "contraction(c)*3^c", vec![20, 256]),
        ("quaternary-four-point:mu=0", "norm(c)", vec![9, 256]),
        // Of this one the powers have no common bound.
        ("quinary-three-point", "contraction(c)*(25/7)^c", vec![12, 40]),
        ("b-spline:degree=3", "contraction(c, order = forward)*2^c", vec![32]),
    ] {
        let paper = paper(scheme, "", value, &levels);
        let text = written(&paper);
        let constants = text.lines().filter(|line| line.starts_with("  constant ")).count();
        assert!(constants >= levels.len(), "{text}");
        assert_eq!(outcome(&paper, &text), Outcome::Valid, "{scheme}: {text}");
    }
}

/// Σ|·| over every class of the places mod n^c of t(z)·t(z^n)⋯, t_{nu+β} = r_{β,N−1−u}, for
/// rules over the denominator d.
fn class_sums(rules: &Rules, d: i128, c: u32) -> Vec<Rational> {
    let (n, width) = (rules.arity(), rules.width());
    let entry = |place: usize| {
        let entry = &rules.rows()[place % n][width - 1 - place / n] * Rational::from(d);
        i128::from(entry.numerator().to_i64().expect("small"))
    };
    let sequence: Vec<i128> = (0..n * width).map(entry).collect();
    let mut product = vec![1_i128];
    for level in 0..c {
        let step = n.pow(level);
        let mut next = vec![0; product.len() + step * (sequence.len() - 1)];
        for (i, x) in sequence.iter().enumerate() {
            for (sum, y) in next[i * step..].iter_mut().zip(&product) {
                *sum += x * y;
            }
        }
        product = next;
    }
    let mut sums = vec![0; n.pow(c)];
    for (place, x) in product.iter().enumerate() {
        sums[place % n.pow(c)] += x.abs();
    }
    let scale = Rational::from(d).pow(-c.cast_signed());
    sums.into_iter().map(|sum| Rational::from(sum) * &scale).collect()
}

/// The certificate names a class that has the greatest sum; one that has the next greatest sum is
/// refused, with its own value. Whether it was accepted, and the other refused for that.
fn next_is_refused([scheme, own, function]: [&str; 3], rules: &Rules, (d, c): (i128, u32)) -> bool {
    let paper = paper(scheme, own, &format!("{function}(c)"), &[c]);
    let text = written(&paper);
    let Some(line) = text.lines().find(|line| line.starts_with("  constant ")) else {
        return false;
    };
    let words: Vec<&str> = line.split_whitespace().collect();
    let sums = class_sums(rules, d, c);
    let best = sums.iter().max().expect("classes");
    assert_eq!(words[6], best.to_string());
    assert_eq!(sums[words[5].parse::<usize>().expect("a class")], *best);
    let class = |value: &Rational| sums.iter().position(|sum| sum == value).expect("a class");
    let Some(next) = sums.iter().filter(|sum| *sum < best).max() else { return false };
    let other = [&words[..5], &[&class(next).to_string(), &next.to_string()]].concat().join(" ");
    match outcome(&paper, &text.replace(line, &format!("  {other}"))) {
        Outcome::Invalid(_, rejection) => assert_eq!(rejection.reason, Reason::NotLargest),
        Outcome::Incomplete(_) => return false,
        outcome => panic!("{outcome:?}: {}", paper.source.text),
    }
    outcome(&paper, &text) == Outcome::Valid
}

#[test]
fn the_next_greatest_class_is_refused() {
    for (scheme, d, c) in [("four-point", 16, 14), ("ternary-four-point:mu=1/9", 162, 9)] {
        let parsed = parse_scheme(scheme).expect("a scheme");
        let mask = parsed.masks()[0];
        for (function, rules) in [("contraction", &mask.difference()), ("norm", mask.rules())] {
            assert!(next_is_refused([scheme, "", function], rules, (d, c)), "{scheme}");
        }
    }
}

/// A binary mask that keeps lines: any even rule, and an odd one with another first entry.
fn keeping_lines(even: [i64; 3], first: i64) -> [[i64; 4]; 2] {
    let [a, b, c] = even;
    let (d, second) = (16 - a - b - c, b);
    // Σ = 16, and Σ j·odd is 8 more than Σ j·even.
    let moment = b + 2 * c + 3 * d + 8 - second;
    let rest = 16 - first - second;
    [[a, b, c, d], [first, second, 3 * rest - moment, moment - 2 * rest]]
}

proptest! {
    #![proptest_config(crate::common::cases(12))]

    // Whatever the mask, what is written is accepted, or beyond a cap.
    #[test]
    fn no_constant_is_refused(
        entries in prop::collection::vec(-4_i64..=8, 4),
        c in 15_u32..19,
        forward in any::<bool>(),
    ) {
        let rest = |a: i64, b: i64| format!("['{a}/8', '{b}/8', '{}/8']", 8 - a - b);
        let (even, odd) = (rest(entries[0], entries[1]), rest(entries[2], entries[3]));
        let own = format!("[[scheme]]\nname = \"own\"\nmask = [{even}, {odd}]");
        let order = if forward { "forward" } else { "adjoint" };
        let paper = paper("own", &own, &format!("contraction(c, order = {order})"), &[c]);
        let text = written(&paper);
        let found = outcome(&paper, &text);
        prop_assert!(matches!(found, Outcome::Valid | Outcome::Incomplete(_)), "{:?}\n{}", found, text);
    }

    // Also where the greatest sum is anywhere, and the mask of no symmetry.
    #[test]
    fn the_next_greatest_class_is_refused_for_any_mask(
        even in [-3_i64..6, 2_i64..12, -2_i64..10],
        first in -4_i64..4,
    ) {
        let mask = keeping_lines(even, first);
        let row = |row: &[i64; 4]| format!("[{}]", row.map(|x| format!("'{x}/16'")).join(", "));
        let own = format!("[[scheme]]\nname = \"own\"\nmask = [{}, {}]", row(&mask[0]), row(&mask[1]));
        let sixteenth = |x: &i64| Rational::new(*x, 16);
        let rows = mask.iter().map(|row| row.iter().map(sixteenth).collect()).collect();
        let mask = Mask::new(rows, 0).expect("a mask");
        for (function, rules) in [("contraction", &mask.difference()), ("norm", mask.rules())] {
            next_is_refused(["own", &own, function], rules, (16, 14));
        }
    }
}
