//! Findings about the smoothness of limits.

use super::limits::{not_smooth, of_lattice, of_limits, smooth};
use super::range::{of_range, of_region};
use super::regularity;
use super::vertex::{SCOPE, verdict_name, verdict_reason, vertex_facts, vertices_outcome};
use crate::audit::{
    KnownLimits, PaperAudit, Proven, RangeAtValence, SmoothnessFinding, SmoothnessVerdict,
    VertexWitness, Witness,
};
use crate::claim::{
    ExponentStatement, PrintedValences, SmoothRangeStatement, SmoothnessBody, SmoothnessClaim,
    SmoothnessStatement, Target,
};
use crate::exact::IntervalSet;
use crate::report::formulas::function::{beyond, domain};
use crate::report::words::set::{proved_text, set_text};
use crate::report::words::sheet::Sheet;

/// A table of smoothness in full, with each cell.
pub(crate) fn explain_table(audit: &PaperAudit<'_>, id: Target<'_>) -> Option<Sheet> {
    let found = regularity::table_of(audit, id)?;
    let mut sheet = Sheet::titled(format!("{id} · {}", found.table.locus));
    sheet.text(found.table.title.clone());
    regularity::grid(&mut sheet, &found);
    for finding in found.cells.iter().flatten().flatten() {
        sheet.heading(2, format!("{} · {}", finding.id, finding.claim.locus));
        sheet.facts(in_full(finding));
    }
    Some(sheet)
}

/// What is stated, what is known and how, and the verdict.
pub(crate) fn in_full(finding: &SmoothnessFinding<'_>) -> Vec<(String, String)> {
    let claim = finding.claim;
    let fact = |name: &str, text: String| (name.to_owned(), text);
    let mut facts = Vec::new();
    facts.extend(scheme(claim).map(|scheme| fact("scheme", scheme)));
    facts.extend(statement(claim).map(|statement| fact("states", statement)));
    let word = finding.verdict.word();
    facts.push((format!("{} {word}", word.mark()), outcome(finding).join("\n")));
    facts.extend(details(finding));
    facts.extend(claim.note.clone().map(|note| fact("note", note)));
    facts
}

/// The scheme, and the values that the claim itself states: `four-point:w=w, w = 1/16`.
pub(crate) fn scheme(claim: &SmoothnessClaim) -> Option<String> {
    let SmoothnessBody::Statement(scheme, _) = &claim.body else { return None };
    let values = claim.given.iter().map(|(name, value)| format!(", {name} = {}", value.text));
    Some(format!("{}{}", scheme.reference, values.collect::<Vec<String>>().concat()))
}

/// What the paper states.
pub(crate) fn statement(claim: &SmoothnessClaim) -> Option<String> {
    let SmoothnessBody::Statement(_, statement) = &claim.body else { return None };
    Some(match &**statement {
        SmoothnessStatement::Continuity { continuous, not_continuous, valences } => {
            let parts = [continuous.map(smooth), not_continuous.map(not_smooth)];
            let parts = parts.into_iter().flatten().collect::<Vec<String>>().join(", and ");
            format!("{}{parts}", valences.as_ref().map(at_valences).unwrap_or_default())
        }
        SmoothnessStatement::Exponent { exponent, attained } => {
            let said = match exponent {
                ExponentStatement::Value(printed) => printed.text.clone(),
                ExponentStatement::Decimal { text, .. } => text.clone(),
                ExponentStatement::Bounds { at_least, at_most } => {
                    let lower = at_least.as_ref().map(|bound| format!("at least {}", bound.text));
                    let upper = at_most.as_ref().map(|bound| format!("at most {}", bound.text));
                    lower.into_iter().chain(upper).collect::<Vec<String>>().join(", ")
                }
            };
            let attained = match attained {
                None => "",
                Some(true) => ", attained",
                Some(false) => ", not attained",
            };
            format!("the Hölder exponent is {said}{attained}")
        }
        SmoothnessStatement::Region(region) => {
            let [x, y] = &region.variables;
            let only =
                if region.only { format!(", and for no other {x}, {y}") } else { String::new() };
            format!("{} for {}{only}", smooth(region.m), region.texts.join(", "))
        }
        SmoothnessStatement::Range(range) => {
            let only = if range.only {
                format!(", and for no other {}", range.variable)
            } else {
                String::new()
            };
            let at = range.valences.as_ref().map(at_valences).unwrap_or_default();
            format!("{at}{} for {}{only}", smooth(range.m), printed(range))
        }
    })
}

/// `at each valence from 3 to 50 `.
fn at_valences(valences: &PrintedValences) -> String {
    let PrintedValences { first, last, .. } = valences;
    match last {
        None => format!("at every valence N >= {first} "),
        Some(last) if first == last => format!("at valence {first} "),
        Some(last) => format!("at each valence from {first} to {last} "),
    }
}

/// The sets of one valence, what is open there, and the value that refutes the claim.
fn range_at_valence(found: &RangeAtValence, variable: &str) -> Vec<String> {
    let set = |set: &IntervalSet| set_text(set, variable);
    let RangeAtValence { range, undecided, witness } = found;
    let mut line = format!(
        "N = {}: C^1 for {}, not C^1 for {}",
        range.order,
        proved_text(&range.inside, &range.outside, variable),
        set(&range.outside)
    );
    if !undecided.is_empty() {
        line = format!("{line}; open for {}", set(undecided));
    }
    let witness = witness.as_ref().map(|VertexWitness { at, inside, vertex }| {
        let place = if *inside { "in the printed range" } else { "beyond the printed range" };
        let verdict = &vertex.verdict;
        let (name, reason) = (verdict_name(verdict), verdict_reason(verdict));
        format!("At N = {}, {variable} = {at}, {place}, C^1 is {name}: {reason}.", range.order)
    });
    [line].into_iter().chain(witness).collect()
}

/// The range as printed.
pub(crate) fn printed(range: &SmoothRangeStatement) -> String {
    domain(&range.variable, &range.domain)
}

/// What is known, in lines.
pub(crate) fn outcome(finding: &SmoothnessFinding<'_>) -> Vec<String> {
    let mut lines = match &finding.known {
        KnownLimits::Absent => {
            vec![format!("not checkable without {}", finding.claim.absent().unwrap_or_default())]
        }
        KnownLimits::Capped(reason) => vec![beyond(reason)],
        KnownLimits::BeyondCap(cap) => vec![beyond(cap)],
        KnownLimits::Limits(limits) => vec![of_limits(&Proven::of_curve(&limits.smoothness))],
        KnownLimits::Lattice(limits) => {
            let open = limits.smoothness.open.iter().cloned();
            [of_limits(&Proven::of_lattice(&limits.smoothness))].into_iter().chain(open).collect()
        }
        KnownLimits::Range(range) => of_range(finding, range),
        KnownLimits::Region(region) => of_region(finding, region),
        KnownLimits::Vertices(found) => {
            let mut lines = vertices_outcome(found);
            lines.push(format!("{SCOPE}."));
            lines
        }
        KnownLimits::VertexRanges(found) => {
            let variable = finding.claim.range().map_or("", |said| &said.variable);
            let mut lines: Vec<String> =
                found.iter().flat_map(|one| range_at_valence(one, variable)).collect();
            lines.push(format!("{SCOPE}."));
            lines
        }
    };
    match finding.verdict {
        SmoothnessVerdict::Rounding(direction) => {
            lines.push(format!("The decimal is {direction}."));
        }
        SmoothnessVerdict::RoundedEnds => {
            lines.push("The printed range is right up to the rounding of its ends.".to_owned());
        }
        _ => {}
    }
    lines
}

/// What else is known of the limits.
pub(crate) fn details(finding: &SmoothnessFinding<'_>) -> Vec<(String, String)> {
    facts_of(&finding.known)
}

fn facts_of(known: &KnownLimits) -> Vec<(String, String)> {
    let limits = match known {
        KnownLimits::Limits(limits) => limits,
        KnownLimits::Lattice(limits) => return of_lattice(&limits.smoothness),
        KnownLimits::Range(range) => return facts_at(range.witness.as_ref()),
        KnownLimits::Region(region) => return facts_at(region.witness.as_ref()),
        KnownLimits::Vertices(found) => {
            return match &found.vertices[..] {
                [.., vertex] => vertex_facts(vertex),
                [] => Vec::new(),
            };
        }
        KnownLimits::VertexRanges(found) => {
            let witness = found.iter().find_map(|one| one.witness.as_ref());
            return witness.map_or_else(Vec::new, |witness| vertex_facts(&witness.vertex));
        }
        KnownLimits::Absent | KnownLimits::Capped(_) | KnownLimits::BeyondCap(_) => {
            return Vec::new();
        }
    };
    let deciding = limits.smoothness.deciding();
    let (n, size) = (deciding.symbol.arity(), deciding.matrices.size());
    let factors: Vec<String> = deciding.radius.product.iter().map(|i| format!("T_{i}")).collect();
    let above = match &deciding.radius.hull {
        Some(hull) => format!("by an invariant hull of {} rows", size + hull.rows.len()),
        None => "by no hull: the radius is 0".to_owned(),
    };
    let fact = |name: &str, text: String| (name.to_owned(), text);
    let mut facts = vec![
        fact("sum rules", format!("of order {}", limits.smoothness.sum_rules)),
        fact(
            "matrices",
            format!(
                "{n}, {size}×{size}, of {n}^{} times the differences of order {0}",
                deciding.order
            ),
        ),
        fact(
            "spectral radius",
            format!("from below by the product {}\nfrom above {above}", factors.join(" ")),
        ),
    ];
    if limits.smoothness.reduced.is_some() {
        let text = "linearly dependent; another symbol, of which they are not, decides";
        facts.push(fact("shifts", text.to_owned()));
    }
    facts
}

/// What is known at a value that refutes a range.
fn facts_at<P>(witness: Option<&Witness<P>>) -> Vec<(String, String)> {
    witness.map_or_else(Vec::new, |witness| facts_of(&witness.limits))
}
