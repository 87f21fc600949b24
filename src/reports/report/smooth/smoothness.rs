//! Findings about the smoothness of limits.

use super::regularity;
use super::vertex::{SCOPE, verdict_name, verdict_reason, vertex_facts, vertices_outcome};
use crate::audit::{
    KnownLimits, Limits, PaperAudit, RangeAtValence, RangeOfLimits, RegionOfLimits,
    SmoothnessFinding, SmoothnessVerdict, VertexWitness,
};
use crate::claim::{
    ExponentStatement, PrintedValences, SmoothRangeStatement, SmoothnessBody, SmoothnessClaim,
    SmoothnessStatement, Target,
};
use crate::exact::{Enclosed as _, IntervalSet, Rational, RationalPolynomial};
use crate::report::formulas::function::{beyond, domain};
use crate::report::words::numbers::{down, up};
use crate::report::words::set::{proved_text, roots, set_text};
use crate::report::words::sheet::Sheet;
use crate::smoothness::{Hoelder, SmoothRange};

/// The longest formula of an exponent that stands beside its decimals.
const LONGEST: usize = 100;

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

fn smooth(m: usize) -> String {
    format!("the limits are C^{m}")
}

fn not_smooth(m: usize) -> String {
    if m == 0 {
        "the scheme diverges for some data".to_owned()
    } else {
        format!("not all limits are C^{m}")
    }
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
        KnownLimits::Limits(limits) => vec![of_limits(limits)],
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

/// `the limits are C^1, and not all limits are C^2; Hölder exponent 2, not attained`.
fn of_limits(limits: &Limits) -> String {
    let smoothness = &limits.smoothness;
    let known = [smoothness.continuity.map(smooth), smoothness.continuity_fails.map(not_smooth)];
    let known: Vec<String> = known.into_iter().flatten().collect();
    let known = if known.is_empty() {
        "it is open whether the scheme converges".to_owned()
    } else {
        known.join(", and ")
    };
    let exponent = smoothness.hoelder.as_ref();
    format!(
        "{known}{}",
        exponent.map(|e| format!("; Hölder exponent {}", of_exponent(e))).unwrap_or_default()
    )
}

/// `6 - log_2(9), 2.830074998557 to 2.830074998558, attained`.
pub(crate) fn of_exponent(hoelder: &Hoelder) -> String {
    let between = between(hoelder);
    let value = match &hoelder.formula {
        Some(formula) if formula.as_rational().is_some() => formula.to_string(),
        Some(formula) => {
            let formula = formula.to_string();
            let short = formula.chars().count() <= LONGEST;
            if short { format!("{formula}, {between}") } else { between }
        }
        None => between,
    };
    let attained = match hoelder.attained {
        None => "",
        Some(true) => ", attained",
        Some(false) => ", not attained",
    };
    format!("{value}{attained}")
}

/// Decimals around the exponent.
fn between(hoelder: &Hoelder) -> String {
    let [low, high] = decimals(hoelder);
    if low == high { low } else { format!("{low} to {high}") }
}

/// A decimal that is not above the exponent, and one that is not below it.
pub(crate) fn decimals(hoelder: &Hoelder) -> [String; 2] {
    let (low, high) = match &hoelder.formula {
        Some(formula) => {
            let enclosure = formula.enclosure(1);
            (enclosure.lower().clone(), enclosure.upper().clone())
        }
        None => (hoelder.lower.clone(), hoelder.upper.clone()),
    };
    [down(&low), up(&high)]
}

/// Why, and by what, another symbol decides.
#[must_use]
pub fn reduction(range: &SmoothRange, parameter: &str) -> String {
    let describe = |g: &Vec<Rational>| RationalPolynomial::new(g).describe("z");
    let by: Vec<String> = range.reduction.iter().map(describe).collect();
    let convergence =
        if range.converges.is_some() { ", wherever the scheme converges" } else { "" };
    format!(
        "The shifts of the basic limit function are linearly dependent for every {parameter}; the solution for the \
         symbol A(z)g(z)/g(z^n), g = {}, is as smooth, and decides{convergence}",
        by.join(", then g = ")
    )
}

fn of_range(finding: &SmoothnessFinding<'_>, range: &RangeOfLimits) -> Vec<String> {
    let Some(said) = finding.claim.range() else { return Vec::new() };
    let SmoothRangeStatement { variable, m, .. } = said;
    let set = |set: &IntervalSet| set_text(set, variable);
    let mut lines = match &range.sets {
        Some(sets) => {
            let mut lines = vec![
                format!(
                    "{} for {}",
                    smooth(*m),
                    proved_text(&sets.inside, &sets.outside, variable)
                ),
                format!("{} for {}", not_smooth(*m), set(&sets.outside)),
            ];
            lines.extend(roots(&[&sets.inside, &sets.outside], variable, &lines));
            if sets.but_finitely_many && !sets.outside.is_empty() {
                lines.push(format!("with finitely many exceptions of {variable}"));
            }
            if !sets.reduction.is_empty() {
                lines.push(format!("{}.", reduction(sets, variable)));
            }
            lines
        }
        None => vec![format!(
            "the sum rules that C^{m} needs hold for single values of {variable} at most"
        )],
    };
    if finding.verdict == SmoothnessVerdict::Open {
        lines.push(format!("It is open for {}.", set(&range.undecided)));
    }
    if let Some(witness) = &range.witness {
        let place =
            if witness.inside { "in the printed range" } else { "beyond the printed range" };
        let limits = of_limits(&witness.limits);
        lines.push(format!("At {variable} = {}, {place}, {limits}.", witness.at));
    }
    lines
}

/// The contraction in a region of two parameters, or the point that refutes it.
fn of_region(finding: &SmoothnessFinding<'_>, region: &RegionOfLimits) -> Vec<String> {
    let Some(said) = finding.claim.region() else { return Vec::new() };
    let [x, y] = &said.variables;
    let point = |[a, b]: &[Rational; 2]| format!("({a}, {b})");
    let corners: Vec<String> = region.corners.iter().map(point).collect();
    let mut lines =
        vec![format!("The corners of the region are ({x}, {y}) = {}.", corners.join(", "))];
    if let Some(proof) = &region.proof {
        let levels = proof.levels;
        let within = if levels == 1 { "one level".to_owned() } else { format!("{levels} levels") };
        lines.push(format!(
            "{} in the whole region: the differences contract within {within}.",
            smooth(said.m)
        ));
    }
    match &region.witness {
        Some(witness) => {
            let place = if witness.inside { "in the region" } else { "outside of it" };
            let limits = of_limits(&witness.limits);
            lines.push(format!("At ({x}, {y}) = {}, {place}, {limits}.", point(&witness.at)));
        }
        None if finding.verdict == SmoothnessVerdict::Open => {
            let tried = region.tried;
            lines.push(format!("None of {tried} points that were tried refutes it."));
        }
        None => {}
    }
    lines
}

/// What else is known of the limits.
pub(crate) fn details(finding: &SmoothnessFinding<'_>) -> Vec<(String, String)> {
    let limits = match &finding.known {
        KnownLimits::Limits(limits) => limits,
        KnownLimits::Range(range) => match &range.witness {
            Some(witness) => &witness.limits,
            None => return Vec::new(),
        },
        KnownLimits::Region(region) => match &region.witness {
            Some(witness) => &witness.limits,
            None => return Vec::new(),
        },
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
