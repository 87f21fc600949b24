//! The findings of an audit, in a few sentences for each paper.

use crate::audit::{CellFinding, Finding, Kept, PaperAudit, Tally, UnstatedOffset, Verdict, Word};
use crate::bound::BetterOffset;
use crate::exact::format::short;
use crate::report::tables::reading::capital;
use crate::report::told::{Counted, counts, told};
use std::collections::{BTreeMap, BTreeSet};

/// The most places that the first sentence names.
const MAX_PLACES: usize = 3;

/// The most words of the places that it names.
const MAX_PLACE_WORDS: usize = 12;

/// The verdicts of cells that are not what the paper's own definition gives.
const WRONG_CELLS: [Word; 3] = [Word::Refuted, Word::Misprint, Word::OtherReading];

/// What does most harm: every refuted theorem and every table whose promises are broken, or, without any, what else is
/// wrong, in up to 25 words. Then the counts: of the cells of a paper, of their promises, and of the other claims.
pub(crate) fn headline(audit: &PaperAudit<'_>) -> String {
    let groups = groups(audit);
    let is_refuted = |(kind, wrong, _): &Group| kind.wrong == Word::Refuted && *wrong > 0;
    let (refuted, others): (Vec<Group>, Vec<Group>) = groups.into_iter().partition(is_refuted);
    let mut harm: Vec<String> =
        refuted.into_iter().map(|group| wrong(audit, group, true)).collect();
    harm.extend(broken(audit));
    let (others, promises) = if harm.is_empty() {
        let (first, others) = first(audit, others);
        harm.push(first);
        (others, promises(audit))
    } else if audit.promise_counts().broken > 0 {
        (others, open_promises(audit))
    } else {
        (others, promises(audit))
    };
    let mut sentences: Vec<String> = unstated_offsets(audit).collect();
    let start = sentences.len();
    sentences.extend(harm.into_iter().chain(cells(audit)).chain(promises));
    sentences.extend(counts_of_wrong(&others).into_iter().chain(beyond(audit)));
    for sentence in sentences.iter_mut().skip(start.max(1)) {
        *sentence = capital(sentence);
    }
    format!("{}: {}", audit.paper.key, sentences.join(" "))
}

/// For each scheme whose offset the claim file does not state, that another one is better.
pub(crate) fn unstated_offsets(audit: &PaperAudit<'_>) -> impl Iterator<Item = String> {
    audit.unstated_offsets.iter().map(|UnstatedOffset { scheme, better }| {
        let BetterOffset { offset, least, at_zero } = better;
        format!(
            "the claim file states no offset for the mask of `{scheme}`, and offset 0 is taken: there the displacement σ is \
             {}, and at offset {offset} it is {}. If the paper numbers its points so, write beside the mask: offset = \
             '{offset}'. Until then bounds and promises are judged at offset 0.",
            short(at_zero, 9),
            short(least, 9)
        )
    })
}

/// Claims that are counted together, how many of them are wrong, and how many there are.
type Group = (&'static Counted, usize, usize);

/// `promises in Table 3 and Table 4 are broken: 70 of 70.`
fn broken(audit: &PaperAudit<'_>) -> Option<String> {
    let counts = audit.promise_counts();
    let tables = audit.tables.iter().filter(|table| table.promise_counts().broken > 0);
    let tables = all_places(tables.map(|table| table.table.locus.as_str()));
    let broken = |cell: &&CellFinding| cell.keeps_promise() == Some(false);
    let cells = audit.tables.iter().flat_map(|table| table.cells.iter().flatten());
    let otherwise =
        cells.filter(broken).filter(|cell| cell.kept_naturally == Some(Kept::Yes)).count();
    let naturally = naturally(otherwise, counts.broken, "kept");
    match counts.broken {
        0 => None,
        1 => Some(format!("a promise in {tables} is broken{naturally}: 1 of {}.", counts.all())),
        broken => Some(format!(
            "promises in {tables} are broken{naturally}: {broken} of {}.",
            counts.all()
        )),
    }
}

/// That some or all of what is wrong with the points at i/n^k is right at their natural parameters.
fn naturally(some: usize, all: usize, right: &str) -> String {
    match some {
        0 => String::new(),
        some if some == all => format!(" with points at i/n^k, and {right} at natural parameters"),
        some => format!(" with points at i/n^k, and {some} of these {right} at natural parameters"),
    }
}

/// What is wrong where no theorem is refuted and no promise is broken, and the groups that are not yet counted.
fn first(audit: &PaperAudit<'_>, mut groups: Vec<Group>) -> (String, Vec<Group>) {
    let is_wrong = |cell: &&CellFinding| WRONG_CELLS.contains(&cell.verdict.word());
    let cells = || audit.tables.iter().flat_map(|table| table.cells.iter().flatten());
    let count = cells().filter(is_wrong).count();
    if count > 0 {
        let has = |table: &&crate::audit::TableFinding<'_>| {
            table.cells.iter().flatten().any(|cell| is_wrong(&cell))
        };
        let tables = audit.tables.iter().filter(has);
        let places = places(tables.map(|table| table.table.locus.as_str()), "table");
        let said = if count == 1 {
            format!("a number in {places} is not what its definition gives")
        } else {
            format!("numbers in {places} are not what their definitions give")
        };
        let all = cells().filter(|cell| cell.printed.is_some()).count();
        return (format!("{said}: {count} of {all}."), groups);
    }
    if let Some(place) = groups.iter().position(|(_, wrong, _)| *wrong > 0) {
        let group = groups.remove(place);
        return (wrong(audit, group, false), groups);
    }
    let judged = cells().any(|cell| cell.printed.is_some()) || !audit.claims().is_empty();
    let sentence =
        if judged { "nothing was found to be wrong." } else { "there is nothing to check." };
    (sentence.to_owned(), groups)
}

/// `(32) and (37) are refuted: 2 of 7 theorems.`
fn wrong(audit: &PaperAudit<'_>, (kind, count, all): Group, every: bool) -> String {
    let wrong: Vec<Finding<'_, '_>> = audit
        .findings()
        .filter(|finding| {
            told(*finding).counted() == Some(kind) && finding.verdicts().of(kind.wrong) > 0
        })
        .collect();
    let otherwise = wrong.iter().filter(|one| told(**one).is_right_naturally()).count();
    let loci = wrong.iter().map(|finding| finding.claim().locus());
    // Several claims of one place are one thing in words.
    let named = loci.clone().collect::<BTreeSet<&str>>().len();
    let places = if every { all_places(loci) } else { places(loci, kind.one) };
    let naturally = naturally(otherwise, count, "not");
    format!("{places} {}{naturally}: {count} of {all} {}.", is_wrong(kind, named), kind.several)
}

/// All of them: `Theorem 4; Theorem 5; (27), (28)`. Of a place with more than one name the first, where that is enough.
fn all_places<'l>(loci: impl Iterator<Item = &'l str>) -> String {
    let mut seen = BTreeSet::new();
    let loci: Vec<&str> = loci.filter(|locus| seen.insert(*locus)).collect();
    let first = |locus: &'l str| locus.split(',').next().unwrap_or(locus);
    let is_enough = |locus: &str| loci.iter().filter(|other| first(other) == locus).count() == 1;
    let short = loci.iter().map(|locus| if is_enough(first(locus)) { first(locus) } else { locus });
    listed(&short.map(str::to_owned).collect::<Vec<String>>())
}

/// `Table 2, Table 3 and 10 other tables`, or `12 tables` where the names are long.
fn places<'l>(loci: impl Iterator<Item = &'l str>, one: &str) -> String {
    let mut seen = BTreeSet::new();
    let loci: Vec<&str> = loci.filter(|locus| seen.insert(*locus)).collect();
    let several = |count: usize| format!("{count} {one}{}", if count == 1 { "" } else { "s" });
    let named = if loci.len() <= MAX_PLACES { loci.len() } else { MAX_PLACES - 1 };
    let words = |named: usize| {
        loci[..named].iter().map(|locus| locus.split_whitespace().count()).sum::<usize>()
    };
    let named = (0..=named).rev().find(|named| words(*named) <= MAX_PLACE_WORDS).unwrap_or(0);
    let others = loci.len() - named;
    let mut parts: Vec<String> = loci[..named].iter().map(|locus| (*locus).to_owned()).collect();
    if others > 0 {
        parts.push(match named {
            0 => several(others),
            _ => format!("{others} other {one}{}", if others == 1 { "" } else { "s" }),
        });
    }
    listed(&parts)
}

/// `a`, `a and b`, `a, b and c`.
fn listed(parts: &[String]) -> String {
    match parts.split_last() {
        None => String::new(),
        Some((last, [])) => last.clone(),
        Some((last, others)) => format!("{} and {last}", others.join(", ")),
    }
}

/// `Of 240 cells, 230 are reproduced with w = 39/2000, which the paper does not state, and 5 are confirmed.`
fn cells(audit: &PaperAudit<'_>) -> Vec<String> {
    let all = || audit.tables.iter().flat_map(|table| table.cells.iter().flatten());
    let printed: Vec<&CellFinding> = all().filter(|cell| cell.printed.is_some()).collect();
    let blank = all().filter(|cell| cell.is_blank()).count();
    let lost = all().count() - printed.len() - blank;
    let mut sentences = Vec::new();
    if !printed.is_empty() {
        let counts: Tally = printed.iter().map(|cell| cell.verdict.word()).collect();
        let mut parts = Vec::new();
        for word in Word::OF_CELLS {
            let said = match word {
                Word::Rounding => "rounded differently",
                Word::OtherReading => "given by another reading",
                Word::Misprint => "a slip away",
                Word::NotCheckable => "not checkable",
                other => other.name(),
            };
            parts.extend(Some((counts.of(word), said)).filter(|(count, _)| *count > 0));
        }
        // The largest part comes first.
        parts.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
        let words: Vec<String> =
            parts.into_iter().map(|(count, said)| format!("{} {said}", are(count))).collect();
        let of = match printed.len() {
            1 => "The only cell is".to_owned(),
            count => format!("Of {count} cells, {}", listed(&words)),
        };
        let one = words.first().map(|words| words.trim_start_matches("1 is").to_owned());
        sentences.push(if printed.len() == 1 {
            format!("{of}{}.", one.unwrap_or_default())
        } else {
            format!("{of}.")
        });
        sentences.extend(recovered(audit));
        let read = printed
            .iter()
            .filter(|cell| cell.verdict == Verdict::Reproduced && cell.as_read.is_some());
        match (read.count(), counts.of(Word::Reproduced)) {
            (0, _) => {}
            (read, all) if read == all => sentences.push(match all {
                1 => "This one takes another reading too.".to_owned(),
                _ => format!("All {all} take another reading too."),
            }),
            (1, all) => sentences.push(format!("1 of these {all} takes another reading too.")),
            (read, all) => {
                sentences.push(format!("{read} of these {all} take another reading too."));
            }
        }
        sentences.extend(if_assumed(&printed));
    }
    match lost {
        0 => {}
        1 => sentences.push("1 cell is lost.".to_owned()),
        lost => sentences.push(format!("{lost} cells are lost.")),
    }
    match blank {
        0 => {}
        1 => sentences.push("Nothing is printed in 1 cell.".to_owned()),
        blank => sentences.push(format!("Nothing is printed in {blank} cells.")),
    }
    sentences
}

/// `Of the cells that are not checkable, 7 differ and 1 is a slip away at the values shown.`: the verdicts that these
/// have at the values that were put in.
fn if_assumed(printed: &[&CellFinding]) -> Option<String> {
    let judged = || printed.iter().filter_map(|cell| cell.verdict_if_assumed.as_ref());
    let differ = judged().filter(|verdict| **verdict == Verdict::Refuted).count();
    let slips = judged().filter(|verdict| matches!(verdict, Verdict::Misprint(_))).count();
    let differ = (differ > 0)
        .then(|| format!("{differ} {}", if differ == 1 { "differs" } else { "differ" }));
    let slips = (slips > 0).then(|| format!("{} a slip away", are(slips)));
    let parts: Vec<String> = differ.into_iter().chain(slips).collect();
    let said = listed(&parts);
    (!parts.is_empty())
        .then(|| format!("Of the cells that are not checkable, {said} at the values shown."))
}

/// `5 are`, or `1 is`.
fn are(count: usize) -> String {
    format!("{count} {}", if count == 1 { "is" } else { "are" })
}

/// `This takes w = 39/2000 or 3/400, which the paper does not state.`: the values at which cells are reproduced, those
/// of most cells first.
fn recovered(audit: &PaperAudit<'_>) -> Option<String> {
    let mut values: BTreeMap<&str, BTreeMap<String, usize>> = BTreeMap::new();
    for table in &audit.tables {
        let cells = table.cells.iter().flatten();
        let count = cells.filter(|cell| cell.verdict == Verdict::Reproduced).count();
        for (name, recovered) in table.recovered.iter().filter(|_| count > 0) {
            let value = recovered.value.to_string();
            *values.entry(name).or_default().entry(value).or_default() += count;
        }
    }
    if values.is_empty() {
        return None;
    }
    let named = values.into_iter().map(|(name, values)| {
        let mut values: Vec<(String, usize)> = values.into_iter().collect();
        values.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        let values: Vec<String> = values.into_iter().map(|(value, _)| value).collect();
        format!("{name} = {}", values.join(" or "))
    });
    let named: Vec<String> = named.collect();
    Some(format!("What is reproduced takes {}, which the paper does not state.", listed(&named)))
}

/// `Of 220 promises, none is broken and 1 is open.`
fn promises(audit: &PaperAudit<'_>) -> Option<String> {
    let counts = audit.promise_counts();
    let open =
        if counts.open > 0 { format!(" and {} open", are(counts.open)) } else { String::new() };
    let said = match counts.all() {
        0 => return None,
        1 if counts.open == 1 => "The only promise is open.".to_owned(),
        1 => "The only promise is kept.".to_owned(),
        all => format!("Of {all} promises, none is broken{open}."),
    };
    Some(said)
}

/// `1 promise is open.`
fn open_promises(audit: &PaperAudit<'_>) -> Option<String> {
    match audit.promise_counts().open {
        0 => None,
        1 => Some("1 promise is open.".to_owned()),
        open => Some(format!("{open} promises are open.")),
    }
}

/// The claims of a paper other than cells, those that weigh most first.
fn groups(audit: &PaperAudit<'_>) -> Vec<Group> {
    let counts = counts(std::slice::from_ref(audit)).into_iter();
    let mut groups: Vec<Group> =
        counts.map(|(kind, tally)| (kind, tally.of(kind.wrong), tally.total())).collect();
    groups.sort_by_key(|(kind, ..)| kind.place);
    groups
}

/// `are refuted`.
fn is_wrong(kind: &Counted, wrong: usize) -> &'static str {
    kind.words[usize::from(wrong != 1)]
}

/// `2 claims need a value beyond a cap.`
fn beyond(audit: &PaperAudit<'_>) -> Option<String> {
    match audit.beyond_caps().len() {
        0 => None,
        1 => Some("1 claim needs a value beyond a cap.".to_owned()),
        count => Some(format!("{count} claims need a value beyond a cap.")),
    }
}

/// `15 of 43 equations fail and 2 of 3 ranges are wrong.`
fn counts_of_wrong(groups: &[Group]) -> Option<String> {
    let wrong = groups.iter().filter(|(_, wrong, _)| *wrong > 0);
    let wrong: Vec<String> = wrong
        .map(|(kind, wrong, all)| {
            format!("{wrong} of {all} {} {}", kind.several, is_wrong(kind, *wrong))
        })
        .collect();
    (!wrong.is_empty()).then(|| format!("{}.", listed(&wrong)))
}
