//! Altered certificates: none is accepted that says something else.

use crate::altered::{Block, Paper, accepted, alterations, blocks, certificate, papers};
use proptest::prelude::*;
use std::collections::BTreeSet;
use subcert_check::{Outcome, check};

/// Whether an alteration leaves the meaning as it is, or says something else that is true,
/// and how. Everything that is accepted although it is altered has to be one of these.
fn harmless(original: &Block, altered: &Block) -> Option<&'static str> {
    let unordered_lines: fn(&str) -> bool =
        |line| ["read ", "member ", "let "].iter().any(|word| line.starts_with(word));
    if same_but(original, altered, unordered_lines) {
        return Some("readings, members of the family, or values, in another order");
    }
    let words = |block: &Block| block.lines.iter().map(|line| unordered(line)).collect::<Vec<_>>();
    if words(original) == words(altered) {
        return Some("names in another order, or twice, where their order says nothing");
    }
    if unsigned(original) == unsigned(altered) {
        return Some("minus zero");
    }
    let is_sound = |line: &str| line.starts_with("sound ");
    if without(original, is_sound) == without(altered, is_sound) {
        let known = sound(original);
        let depths = known.iter().all(|(_, value)| value.parse::<u32>().is_ok());
        let holds = |(place, value): &(String, String)| {
            let known = known.iter().find(|(other, _)| other == place);
            known.is_some_and(|(_, known)| {
                let larger = || value.parse::<u32>().ok() >= known.parse::<u32>().ok();
                known == value || depths && value.parse::<u32>().is_ok() && larger()
            })
        };
        if sound(altered).iter().all(holds) {
            return Some("fewer sound bounds, repeated ones, a larger depth, or another block");
        }
    }
    let is_attained = |line: &str| line.starts_with("attained ");
    if without(original, is_attained) == without(altered, is_attained) {
        let values = |block: &Block| -> BTreeSet<String> {
            let lines = block.lines.iter().filter(|line| is_attained(line.trim()));
            lines.filter_map(|line| line.split_whitespace().nth(4).map(str::to_owned)).collect()
        };
        if values(altered).is_subset(&values(original)) {
            return Some("fewer constants, repeated ones, or the same in another class or cell");
        }
    }
    let is_parameter: fn(&str) -> bool = |line| line.starts_with("read parameter ");
    if without(original, is_parameter) == without(altered, is_parameter)
        && altered.lines.iter().all(|line| original.lines.contains(line))
    {
        return Some("a parameter that is read as it is assumed anyway");
    }
    if without(original, is_kept) == without(altered, is_kept) && kept(original) == kept(altered) {
        return Some("other constants, or another level, which show the same");
    }
    let unnamed = |block: &Block| -> Vec<String> {
        let line = |line: &String| match line.split_whitespace().collect::<Vec<&str>>()[..] {
            [word @ ("broken" | "naturally"), row, column, _, distance, most] => {
                format!("{word} {row} {column} {distance} {most}")
            }
            _ => line.clone(),
        };
        block.lines.iter().map(line).collect()
    };
    if unnamed(original) == unnamed(altered) {
        return Some("another of the witnesses, with the same distance");
    }
    if silent_of_natural_parameters(original, altered) {
        return Some("nothing about the natural parameters of a cell");
    }
    let promises: fn(&str) -> bool =
        |line| ["kept ", "broken ", "undecided "].iter().any(|word| line.starts_with(word));
    let only_undecided = |(one, other): (&String, &String)| {
        let words: Vec<&str> = one.split_whitespace().collect();
        let undecided = || other.trim() == format!("undecided {} {}", words[1], words[2]);
        one == other || words.len() > 2 && undecided()
    };
    if without(original, promises) == without(altered, promises)
        && original.lines.len() == altered.lines.len()
        && original.lines.iter().zip(&altered.lines).all(only_undecided)
    {
        return Some("a promise that is left undecided");
    }
    let is_data: fn(&str) -> bool = |line| {
        ["polygon ", "net ", "row ", "ring ", "at "].iter().any(|word| line.starts_with(word))
    };
    if without(original, is_data) == without(altered, is_data) {
        return Some("other data that have the same difference, step or distance");
    }
    let is_let: fn(&str) -> bool = |line| line.starts_with("let ");
    let depth = original.lines.iter().any(|line| line.trim() == "bounds depth");
    if depth && without(original, is_let) == without(altered, is_let) {
        return Some("other values for which the same level is called deep enough");
    }
    let is_family = |line: &str| line.starts_with("family ");
    let best = |block: &Block| {
        let line = block.lines.iter().find_map(|line| line.trim().strip_prefix("family "));
        line.and_then(|best| best.parse::<usize>().ok())
    };
    let read = original.lines.iter().any(|line| line.trim().starts_with("read "));
    if without(original, is_family) == without(altered, is_family)
        && !read
        && best(altered) > best(original)
    {
        return Some("a larger number that no member exceeds, which luck would reach too");
    }
    None
}

/// Whether two blocks differ in the order of some lines alone.
fn same_but(original: &Block, altered: &Block, some: fn(&str) -> bool) -> bool {
    let sorted = |block: &Block| {
        let mut lines = block.lines.clone();
        lines.sort();
        lines
    };
    sorted(original) == sorted(altered) && without(original, some) == without(altered, some)
}

/// The lines that are not of some kind.
fn without(block: &Block, some: fn(&str) -> bool) -> Vec<&String> {
    block.lines.iter().filter(|line| !some(line.trim())).collect()
}

/// A line with its assumed parameters, or the differences of a member, in one order.
fn unordered(line: &str) -> String {
    let sorted = |names: &str| {
        let mut names: Vec<&str> = names.split_whitespace().collect();
        names.sort_unstable();
        names.dedup();
        names.join(" ")
    };
    if let Some((line, names)) = line.split_once(" assuming ") {
        return format!("{line} assuming {}", sorted(names));
    }
    match line.trim().strip_prefix("member ").and_then(|said| said.split_once(':')) {
        Some((names, counts)) => format!("member {}:{counts}", sorted(names)),
        None => line.to_owned(),
    }
}

/// The words of all lines, without the sign of a zero.
fn unsigned(block: &Block) -> Vec<Vec<&str>> {
    let word = |word| if word == "-0" { "0" } else { word };
    block.lines.iter().map(|line| line.split_whitespace().map(word).collect()).collect()
}

/// Whether only lines about the natural parameters of cells are left out, or repeated.
fn silent_of_natural_parameters(original: &Block, altered: &Block) -> bool {
    let is_natural: fn(&str) -> bool = |line| line.starts_with("naturally ");
    without(original, is_natural) == without(altered, is_natural)
        && altered.lines.iter().all(|line| original.lines.contains(line))
}

/// Whether a line shows by some constants, and a later level, that a bound is kept.
fn is_kept(line: &str) -> bool {
    line.starts_with("kept ") || line.starts_with("level ")
}

/// The cells and levels of these lines.
fn kept(block: &Block) -> Vec<String> {
    let lines = block.lines.iter().filter(|line| is_kept(line.trim()));
    let place = |line: &String| {
        let named = if line.trim().starts_with("kept ") { 3 } else { 2 };
        line.split_whitespace().take(named).collect::<Vec<&str>>().join(" ")
    };
    lines.map(place).collect()
}

/// The sound bounds: of which cell, and the value.
fn sound(block: &Block) -> Vec<(String, String)> {
    let bound = |line: &String| match line.split_whitespace().collect::<Vec<&str>>()[..] {
        ["sound", row, column, _, _, value] => Some((format!("{row} {column}"), value.to_owned())),
        _ => None,
    };
    block.lines.iter().filter_map(bound).collect()
}

/// What an altered block says otherwise, if it is accepted and does not mean the same.
fn wrongly_accepted(paper: &Paper, original: &Block, altered: &Block) -> Option<String> {
    if !accepted(paper, altered) || harmless(original, altered).is_some() {
        return None;
    }
    let same = |(one, other): &(&String, &String)| one == other;
    let place = original.lines.iter().zip(&altered.lines).take_while(same).count();
    let line = |block: &Block| block.lines.get(place).cloned().unwrap_or_default();
    Some(format!("{}:{}\n{}\n{}", paper.key, original.id(), line(original), line(altered)))
}

/// One claim for each kind and form, all of whose alterations are tried.
const CLAIMS: [(&str, &str); 18] = [
    ("mustafa2020-nary", "table-1"),
    ("mustafa2020-nary", "table-5"),
    ("mustafa2020-nary", "table-15"),
    ("khan2019-newton", "eq-3.8"),
    ("mustafa2007-ternary", "eq-3.8"),
    ("khan2019-newton", "remark-3.1-ko-6"),
    ("mustafa2007-ternary", "corollary-2.1-gamma"),
    ("mustafa2007-ternary", "corollary-2.1-delta"),
    ("mustafa2007-ternary", "remark-2.2-alpha"),
    ("mustafa2007-ternary", "remark-2.2-mu-printed"),
    ("mustafa2007-ternary", "theorem-2.1"),
    ("mustafa2007-ternary", "corollary-2.2"),
    ("khan2019-newton", "eq-2.2"),
    ("khan2019-newton", "lemma-6.1"),
    ("mustafa2020-nary", "theorem-6"),
    ("mustafa2020-nary", "theorem-8"),
    ("mustafa2007-bajaj", "eq-32-differences"),
    ("khan2022-doo-sabin", "theorem-5"),
];

/// Proofs by finitely many levels, which no claim of the papers has: of curves, nets and rings.
const LEVELS: [&str; 11] = [
    include_str!("rules/accepted/levels-difference.cert"),
    include_str!("rules/accepted/levels-times.cert"),
    include_str!("rules/accepted/levels-step.cert"),
    include_str!("rules/accepted/levels-distance.cert"),
    include_str!("rules/accepted/levels-net-difference.cert"),
    include_str!("rules/accepted/levels-net-step.cert"),
    include_str!("rules/accepted/levels-net-distance.cert"),
    include_str!("rules/accepted/levels-face-difference.cert"),
    include_str!("rules/accepted/levels-face-step.cert"),
    include_str!("rules/accepted/levels-face-distance.cert"),
    include_str!("rules/accepted/levels-vertex-step.cert"),
];

/// Relations, which no claim of the papers is: chains, sets, printed numbers, polynomials and schemes.
const RELATIONS: [&str; 9] = [
    include_str!("rules/accepted/relation-chain.cert"),
    include_str!("rules/accepted/relation-half-open.cert"),
    include_str!("rules/accepted/relation-residues.cert"),
    include_str!("rules/accepted/relation-alone.cert"),
    include_str!("rules/accepted/relation-near.cert"),
    include_str!("rules/accepted/relation-unequal-integers.cert"),
    include_str!("rules/accepted/relation-late-cubic.cert"),
    include_str!("rules/accepted/relation-orders.cert"),
    include_str!("rules/accepted/relation-triangle.cert"),
];

/// Tables with depths, sound bounds, recovered parameters, readings of rows and columns, and
/// refuted cells, of whose alterations some are tried.
const LARGE: [(&str, &str); 7] = [
    ("khan2019-newton", "table-1"),
    ("khan2019-newton", "table-3"),
    ("khan2022-doo-sabin", "table-1"),
    ("khan2022-doo-sabin", "table-2-2"),
    ("mustafa2020-nary", "table-3"),
    ("mustafa2020-nary", "table-8"),
    ("mustafa2020-nary", "table-14"),
];

/// How many.
const SOME: usize = 60;

/// Tries alterations of a claim, `most` at most.
fn try_alterations(key: &str, id: &str, most: usize) {
    let papers = papers();
    let paper = papers.iter().find(|paper| paper.key == key).expect("a key");
    let all = blocks(paper.certificate);
    let block = all.iter().find(|block| block.id() == id).expect("an id");
    assert_eq!(accepted(paper, block), block.lines[1].trim() != "open", "{id}");
    let altered = alterations(block);
    let step = altered.len().div_ceil(most);
    let tried = altered.iter().step_by(step);
    let wrong: Vec<String> =
        tried.filter_map(|altered| wrongly_accepted(paper, block, altered)).collect();
    assert!(wrong.is_empty(), "{} of {}\n{}", wrong.len(), altered.len(), wrong.join("\n"));
}

#[test]
fn every_alteration_of_one_certificate_for_each_kind() {
    for (key, id) in CLAIMS {
        try_alterations(key, id, usize::MAX);
    }
}

#[test]
fn every_alteration_of_proofs_by_levels_and_relations() {
    let claims = include_str!("rules/claims.toml");
    for certificate in LEVELS.into_iter().chain(RELATIONS) {
        let paper = Paper { key: "rules", claims, certificate };
        let block = &blocks(certificate)[0];
        assert!(accepted(&paper, block), "{certificate}");
        let wrong = alterations(block).into_iter();
        let wrong: Vec<String> =
            wrong.filter_map(|altered| wrongly_accepted(&paper, block, &altered)).collect();
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }
}

#[test]
fn some_alterations_of_large_tables() {
    for (key, id) in LARGE {
        try_alterations(key, id, SOME);
    }
}

#[test]
fn the_certificate_of_another_claim() {
    for paper in papers() {
        let all = blocks(paper.certificate);
        for pair in all.windows(2) {
            let mut altered = pair[0].clone();
            altered.lines[0].clone_from(&pair[1].lines[0]);
            if altered.lines[1..] != pair[1].lines[1..] {
                assert!(!accepted(&paper, &altered), "{}", altered.text());
            }
        }
    }
}

#[test]
fn the_claim_file_of_another_paper() {
    let papers = papers();
    for paper in &papers {
        for other in papers.iter().filter(|other| other.key != paper.key) {
            let own = check(paper.claims, &[other.certificate]).expect("a claim file");
            assert!(!own.broken.is_empty());
            let renamed = other.certificate.replacen(other.key, paper.key, 1);
            let renamed = check(paper.claims, &[&renamed]).expect("a claim file");
            for (_, id, outcome) in own.claims.iter().chain(&renamed.claims) {
                assert_ne!(*outcome, Outcome::Valid, "{id} of {} for {}", other.key, paper.key);
            }
        }
    }
}

/// What may be written otherwise.
#[test]
fn what_means_the_same_is_accepted() {
    let papers = papers();
    let paper = papers.iter().find(|paper| paper.key == "khan2019-newton").expect("a key");
    let all = blocks(paper.certificate);
    let block = all.iter().find(|block| block.id() == "table-1").expect("an id");
    let plain = certificate(paper, block);
    let changes = [
        ("a blank line", plain.replace("\ntable ", "\n\ntable ")),
        ("a comment", plain.replace("\n  value ", "\n# so far\n  value ")),
        ("other blanks", plain.replace("  cell ", "    cell ").replace('\n', " \r\n")),
        ("a value written otherwise", plain.replace(" 1/400 ", " 2^-4*(1/5)^2 ")),
        ("readings in another order", {
            let mut block = block.clone();
            let is = |line: &String| line.trim().starts_with("read ");
            let first = block.lines.iter().position(is).expect("a reading");
            block.lines.swap(first, first + 1);
            assert_eq!(
                harmless(&all[0], &block),
                Some("readings, members of the family, or values, in another order")
            );
            certificate(paper, &block)
        }),
    ];
    for (what, text) in changes {
        assert_ne!(text, plain, "{what}");
        let report = check(paper.claims, &[&text]).expect("a claim file");
        assert!(report.broken.is_empty(), "{what}: {:?}", report.broken);
        let valid =
            |(_, id, outcome): &(_, String, Outcome)| id == "table-1" && *outcome == Outcome::Valid;
        assert!(report.claims.iter().any(valid), "{what}: {:?}", report.claims[0]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    /// Any alteration of any claim of any paper.
    #[test]
    fn altered_claims_are_refused(
        paper in 0_usize..5,
        block in any::<prop::sample::Index>(),
        alteration in any::<prop::sample::Index>(),
    ) {
        let paper = &papers()[paper];
        let blocks = blocks(paper.certificate);
        let block = block.get(&blocks);
        let wrong = wrongly_accepted(paper, block, alteration.get(&alterations(block)));
        prop_assert_eq!(wrong, None);
    }

    /// A claim in place of any other.
    #[test]
    fn exchanged_claims_are_refused(
        paper in 0_usize..5,
        first in any::<prop::sample::Index>(),
        second in any::<prop::sample::Index>(),
    ) {
        let paper = &papers()[paper];
        let blocks = blocks(paper.certificate);
        let (first, second) = (first.get(&blocks), second.get(&blocks));
        let mut altered = first.clone();
        altered.lines[0].clone_from(&second.lines[0]);
        if altered != *second {
            prop_assert!(!accepted(paper, &altered), "{}", altered.text());
        }
    }

    /// A certificate that is cut off anywhere proves nothing.
    #[test]
    fn shortened_certificates_are_refused(
        paper in 0_usize..5,
        place in any::<prop::sample::Index>(),
    ) {
        let paper = &papers()[paper];
        let lines: Vec<&str> = paper.certificate.lines().collect();
        let text = lines[..place.index(lines.len())].join("\n");
        let report = check(paper.claims, &[&text]).expect("a claim file");
        prop_assert!(!report.broken.is_empty());
        prop_assert!(report.claims.iter().all(|(_, _, outcome)| *outcome != Outcome::Valid));
    }
}

#[test]
fn what_is_certified_twice_is_no_premise() {
    let block = "function equal\n  variable w\n  left abs(w)\n  right max(w, -w)\n  breaks\n  signs 0\n  holds\n";
    let cited = "theorem cited\n  says the step is attained at a point\n  proved-by THEOREMS 44\n  proved\n";
    let claims = include_str!("rules/claims.toml");
    let outcomes = |certificates: &[String]| {
        let texts: Vec<&str> = certificates.iter().map(String::as_str).collect();
        let report = check(claims, &texts).expect("a claim file");
        let of = |id: &str| {
            let found = report.claims.iter().find(|(_, known, _)| known == id);
            found.expect("a claim").2.clone()
        };
        [of("equal"), of("cited")]
    };
    let head = "subcert-certificate 4\npaper rules\n";
    let once = format!("{head}{block}{cited}end 2\n");
    assert!(matches!(outcomes(std::slice::from_ref(&once)), [Outcome::Valid, Outcome::Cited(_)]));
    let again = format!("{head}{block}end 1\n");
    let [equal, cited] = outcomes(&[once, again]);
    assert!(matches!(equal, Outcome::Invalid(..)), "{equal:?}");
    assert!(matches!(cited, Outcome::Incomplete(Some(_))), "{cited:?}");
}
