//! Corrections: how a reader would try to save a bound that is false.

use crate::claim::{Paper, Quantity, Statement, Theorem};
use crate::diagnostic::Diagnostic;
use crate::evaluation::choices::FAMILY;
use crate::evaluation::settings::Settings;
use crate::exact::Rational;
use crate::finding::{Change, Correction};
use crate::judge::theorem::case::Case;
use std::collections::BTreeMap;

/// The words of choices with which constants are what bounds need.
const SOUND: [(&str, &str); 5] = [
    ("order", "adjoint"),
    ("suprema", "independent"),
    ("contraction-terms", "each"),
    ("displacement-terms", "each"),
    ("recursion", "derived"),
];

/// The most corrections that are combined.
const MAX_CORRECTIONS: usize = 6;

/// The corrections that make a difference to a theorem.
pub(crate) fn corrections(
    paper: &Paper,
    theorem: &Theorem,
    cases: &[Case<'_>],
) -> Result<Vec<Correction>, Diagnostic> {
    let (Statement::Bound { by, .. } | Statement::Depth(by)) = &theorem.statement else {
        return Ok(Vec::new());
    };
    let mut consulted: BTreeMap<&'static str, String> = BTreeMap::new();
    for case in cases {
        let settings = Settings::default();
        let names = [("k", Rational::one()), ("epsilon", Rational::new(1, 100))];
        case.evaluate(by, &names, &settings)?.ok();
        consulted.extend(settings.consulted());
    }
    let mut found = Vec::new();
    let mut push = |says: String, change| found.push(Correction { says, change });
    for (key, word) in SOUND {
        let Some(printed) = consulted.get(key) else { continue };
        let choice = FAMILY.iter().find(|choice| choice.key == key);
        let way = choice.and_then(|choice| choice.ways.iter().find(|way| way.word == word));
        if let Some(way) = way.filter(|way| way.word != printed) {
            push(way.says.to_owned(), Change::Word(key, way.word));
        }
    }
    let used = paper.definitions_in(by);
    for (place, alternative) in paper.alternatives.iter().enumerate() {
        if used.contains_key(alternative.of.as_str()) {
            push(alternative.label.clone(), Change::Alternative(place));
        }
    }
    for (place, rewriting) in theorem.tried.rewritings.iter().enumerate() {
        push(rewriting.says.clone(), Change::Rewriting(place));
    }
    if theorem.tried.block.is_some() {
        let says = "a power of the constant for each block of levels, not for each level";
        push(says.to_owned(), Change::Block);
        let says = match &theorem.statement {
            Statement::Bound { quantity: Quantity::Distance, .. } | Statement::Depth(_) => {
                "the steps of all levels of a block, not of one"
            }
            _ => "the greatest of the levels of a block",
        };
        push(says.to_owned(), Change::Within);
    }
    let mut settings = cases.iter().filter_map(|case| case.setting.as_ref());
    let moves = settings.any(|setting| setting.centred().is_some());
    if moves
        && !matches!(&theorem.statement, Statement::Bound { quantity, .. } if *quantity == Quantity::Difference)
    {
        push("polygon and limit compared at the best offset".to_owned(), Change::Centred);
    }
    found.truncate(MAX_CORRECTIONS);
    Ok(found)
}

/// The reading with these corrections.
pub(crate) fn settings(paper: &Paper, theorem: &Theorem, corrections: &[&Correction]) -> Settings {
    let words = corrections.iter().filter_map(|correction| match correction.change {
        Change::Word(name, word) => Some((name, word)),
        _ => None,
    });
    let mut settings = Settings::new(words.collect());
    for correction in corrections {
        let (of, value) = match correction.change {
            Change::Alternative(place) => {
                let alternative = &paper.alternatives[place];
                (&alternative.of, &alternative.value)
            }
            Change::Rewriting(place) => {
                let rewriting = &theorem.tried.rewritings[place];
                (&rewriting.of, &rewriting.value)
            }
            _ => continue,
        };
        let definitions = settings.definitions.get_or_insert_with(|| paper.definitions.clone());
        definitions.insert(of.clone(), value.clone());
    }
    settings
}

/// Every set of corrections, smaller ones first.
pub(crate) fn subsets(corrections: &[Correction]) -> Vec<Vec<&Correction>> {
    let mut sets: Vec<Vec<&Correction>> = (0_u32..1 << corrections.len())
        .map(|bits| {
            let chosen = corrections.iter().enumerate().filter(|(i, _)| bits >> i & 1 == 1);
            chosen.map(|(_, correction)| correction).collect()
        })
        .collect();
    sets.sort_by_key(Vec::len);
    sets
}
