//! Corrections: how a reader would try to save a bound that is false.

use crate::claim::{Paper, Quantity, Statement, Theorem};
use crate::diagnostic::Diagnostic;
use crate::evaluation::choices::{FAMILY, FORWARD, ORDER};
use crate::evaluation::settings::Settings;
use crate::exact::Rational;
use crate::finding::Correction;
use crate::judge::theorem::case::Case;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The words of choices under which constants are those that bounds need.
const SOUND: [(&str, &str); 5] = [
    ("order", "adjoint"),
    ("suprema", "independent"),
    ("contraction-terms", "each"),
    ("displacement-terms", "each"),
    ("recursion", "derived"),
];

/// The most corrections that are combined.
const MAX_CORRECTIONS: usize = 6;

/// The corrections that may change the bound of a theorem, at most [`MAX_CORRECTIONS`].
pub(crate) fn corrections(
    paper: &Paper,
    theorem: &Theorem,
    cases: &[Case<'_>],
) -> Result<Vec<Correction>, Diagnostic> {
    let (Statement::Bound { by, .. } | Statement::Depth(by)) = &theorem.statement else {
        return Ok(Vec::new());
    };
    let mut consulted: BTreeMap<&'static str, String> = BTreeMap::new();
    for case in cases.iter().filter(|case| case.beyond.is_none()) {
        let settings = Settings::default();
        let names = [("k", Rational::one()), ("epsilon", Rational::new(1, 100))];
        case.evaluate(by, &names, &settings)?.ok();
        consulted.extend(settings.consulted());
    }
    let mut found = Vec::new();
    for (key, word) in SOUND {
        let Some(printed) = consulted.get(key) else { continue };
        let choice = FAMILY.iter().find(|choice| choice.key == key);
        let way = choice.and_then(|choice| choice.ways.iter().find(|way| way.word == word));
        if let Some((choice, way)) = choice.zip(way).filter(|(_, way)| way.word != printed) {
            found.push(Correction::Way(choice, way));
        }
    }
    let used = paper.definitions_in(by);
    for (place, alternative) in paper.alternatives.iter().enumerate() {
        if used.contains_key(alternative.of.as_str()) {
            let label = alternative.label.clone();
            found.push(Correction::Alternative { place, label });
        }
    }
    for (place, rewriting) in theorem.tried.rewritings.iter().enumerate() {
        found.push(Correction::Rewriting { place, label: rewriting.says.clone() });
    }
    if theorem.tried.block.is_some() {
        found.push(Correction::Block);
        found.push(match &theorem.statement {
            Statement::Bound { quantity: Quantity::Distance, .. } | Statement::Depth(_) => {
                Correction::AllSteps
            }
            _ => Correction::Greatest,
        });
    }
    let mut settings = cases.iter().filter_map(|case| case.setting.as_ref());
    let moves = settings.any(|setting| setting.centred().is_some());
    if moves
        && !theorem.tried.natural
        && !matches!(&theorem.statement, Statement::Bound { quantity, .. } if *quantity == Quantity::Difference)
    {
        found.push(Correction::Centred);
    }
    found.truncate(MAX_CORRECTIONS);
    if consulted.get(ORDER.key).is_some_and(|word| word == FORWARD) {
        let masks = cases.iter().filter_map(|case| case.resolved.as_ref());
        let masks = masks.flat_map(|scheme| scheme.constants.iter());
        let arity = masks.map(|axis| axis.mask().arity()).max().unwrap_or(0);
        found.extend((1..arity).map(|first| Correction::Numbers { first }));
    }
    Ok(found)
}

/// The reading with these corrections.
pub(crate) fn settings(paper: &Paper, theorem: &Theorem, corrections: &[&Correction]) -> Settings {
    let words = corrections.iter().filter_map(|correction| match correction {
        Correction::Way(choice, way) => Some((choice.key, way.word)),
        _ => None,
    });
    let mut settings = Settings::new(words.collect());
    for correction in corrections {
        let (of, value) = match correction {
            Correction::Numbers { first } => {
                settings.first = *first;
                continue;
            }
            Correction::Alternative { place, .. } => {
                let alternative = &paper.alternatives[*place];
                (&alternative.of, &alternative.value)
            }
            Correction::Rewriting { place, .. } => {
                let rewriting = &theorem.tried.rewritings[*place];
                (&rewriting.of, &rewriting.value)
            }
            _ => continue,
        };
        let definitions =
            settings.definitions.get_or_insert_with(|| Rc::new(paper.definitions.clone()));
        Rc::make_mut(definitions).insert(of.clone(), value.clone());
    }
    settings
}

/// Every set of corrections, smaller ones first. A set has at most one numbering of the points, and
/// none beside masks in adjoint order, whose constants do not depend on it.
pub(crate) fn subsets(corrections: &[Correction]) -> Vec<Vec<&Correction>> {
    let (numbers, others): (Vec<&Correction>, Vec<_>) =
        corrections.iter().partition(|one| matches!(one, Correction::Numbers { .. }));
    let mut sets: Vec<Vec<&Correction>> = (0_u32..1 << others.len())
        .map(|bits| (0..others.len()).filter(|i| bits >> i & 1 == 1).map(|i| others[i]).collect())
        .collect();
    let ordered =
        |one: &&Correction| matches!(one, Correction::Way(choice, _) if choice.key == ORDER.key);
    let forward = sets.iter().filter(|set| !set.iter().any(ordered));
    let numbered = forward.flat_map(|set| numbers.iter().map(|one| [&set[..], &[*one]].concat()));
    sets.extend(numbered.collect::<Vec<_>>());
    sets.sort_by_key(Vec::len);
    sets
}
