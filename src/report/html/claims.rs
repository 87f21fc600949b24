//! Equations, functions, ranges, smoothness and theorems.

use super::command;
use super::math::formula;
use super::picture::{self, Exceeding};
use super::sheet::{facts, lines};
use super::statement::{definitions, identity, quantity};
use super::verdict::{Look, badge};
use crate::audit::{
    EquationFinding, FunctionFinding, PaperAudit, RangeFinding, SmoothnessFinding, TheoremFinding,
    by_hand,
};
use crate::claim::{EquationBody, Quantity, SmoothnessBody, Statement};
use crate::diagnostic::Diagnostic;
use crate::formula::LocatedFormula;
use crate::report::{equation, function, smoothness, theorem};
use maud::{Markup, html};

/// What claims of all kinds have.
struct Claim<'c> {
    id: &'c str,
    locus: &'c str,
    title: &'c str,
    verdict: &'static str,
    note: Option<&'c str>,
}

fn section(
    audit: &PaperAudit<'_>,
    claim: &Claim<'_>,
    file: Option<&str>,
    contents: &Markup,
) -> Markup {
    let Claim { id, locus, title, verdict, note } = claim;
    html! {
        section.claim.(Look::of(verdict).class) id=(id) aria-labelledby={ "page:title-" (id) } {
            h3 id={ "page:title-" (id) } {
                (badge(verdict)) " " a href={ "#" (id) } { (locus) } " " span.title { (title) }
            }
            (contents)
            @if let Some(note) = note { p.note { (lines(note)) } }
            (command::explain(audit, id, file))
        }
    }
}

/// An equation.
pub(super) fn equation(
    audit: &PaperAudit<'_>,
    finding: &EquationFinding<'_>,
    file: Option<&str>,
) -> Markup {
    let equation = finding.equation;
    // What fails or is not checkable says its note itself.
    let verdict = finding.verdict.name();
    let note = if verdict == "fails" { None } else { equation.note.as_deref() };
    let claim =
        Claim { id: &equation.id, locus: &equation.locus, title: &equation.title, verdict, note };
    section(
        audit,
        &claim,
        file,
        &html! {
            @if let EquationBody::Identity(body) = &equation.body { (identity(body)) }
            p.outcome { (lines(&equation::outcome(finding))) }
        },
    )
}

/// A closed form in a free parameter.
pub(super) fn function(
    audit: &PaperAudit<'_>,
    finding: &FunctionFinding<'_>,
    file: Option<&str>,
) -> Markup {
    let own = finding.claim;
    let verdict = finding.verdict.name();
    let claim = Claim {
        id: &own.id,
        locus: &own.locus,
        title: &own.title,
        verdict,
        note: own.note.as_deref(),
    };
    section(
        audit,
        &claim,
        file,
        &html! {
            dl.formulas {
                div { dt { "printed" } dd { (formula(&own.left.expr)) " = " (formula(&own.right.expr)) } }
                (definitions(audit, &own.left))
            }
            p.outcome { (lines(&function::function_outcome(finding).join("\n"))) }
        },
    )
}

/// A range of a free parameter.
pub(super) fn range(
    audit: &PaperAudit<'_>,
    finding: &RangeFinding<'_>,
    file: Option<&str>,
) -> Markup {
    let own = finding.claim;
    let verdict = finding.verdict.name();
    let claim = Claim {
        id: &own.id,
        locus: &own.locus,
        title: &own.title,
        verdict,
        note: own.note.as_deref(),
    };
    let relation = match own.limit.relation() {
        "<" => "<",
        _ => "≤",
    };
    section(
        audit,
        &claim,
        file,
        &html! {
            dl.formulas {
                div {
                    dt { "condition" }
                    dd { (formula(&own.value.expr)) " " (relation) " " (formula(&own.limit.formula().expr)) }
                }
                (definitions(audit, &own.value))
            }
            @if let Some(picture) = picture::range(finding) { (picture) }
        p.outcome { (lines(&function::range_outcome(finding).join("\n"))) }
        },
    )
}

/// A claim about the smoothness of limits.
pub(super) fn smoothness(
    audit: &PaperAudit<'_>,
    finding: &SmoothnessFinding<'_>,
    file: Option<&str>,
) -> Markup {
    let own = finding.claim;
    let verdict = finding.verdict.name();
    let claim = Claim {
        id: &own.id,
        locus: &own.locus,
        title: &own.title,
        verdict,
        note: own.note.as_deref(),
    };
    let details = smoothness::details(finding);
    section(
        audit,
        &claim,
        file,
        &html! {
            dl.formulas {
                @if let SmoothnessBody::Statement(scheme, _) = &own.body {
                    div { dt { "scheme" } dd { (scheme.reference.to_string()) } }
                }
                @if let Some(states) = smoothness::statement(own) {
                    div { dt { "states" } dd { (states) } }
                }
            }
            @if let Some(picture) = picture::smooth_range(finding) { (picture) }
            p.outcome { (lines(&smoothness::outcome(finding).join("\n"))) }
            @if !details.is_empty() {
                details { summary { "Spectral radius" } (facts(&details)) }
            }
        },
    )
}

/// A theorem, a lemma or a corollary.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub(super) fn theorem(
    audit: &PaperAudit<'_>,
    finding: &TheoremFinding<'_>,
    file: Option<&str>,
) -> Result<Markup, Diagnostic> {
    let own = finding.theorem;
    let hand = by_hand(audit, finding)?;
    let violation = finding.refutation.as_ref().map(|refutation| &refutation.violation);
    let drawing = violation.zip(hand.as_ref());
    let drawing = drawing.and_then(|(violation, hand)| {
        picture::witness(&hand.masks, &Exceeding::of_theorem(violation))
    });
    let verdict = finding.verdict.name();
    let claim = Claim {
        id: &own.id,
        locus: &own.locus,
        title: &own.title,
        verdict,
        note: own.note.as_deref(),
    };
    Ok(section(
        audit,
        &claim,
        file,
        &html! {
            dl.formulas {
                div { dt { "states" } dd { (statement(&own.statement)) } }
                @if let Statement::Bound { by, .. } | Statement::Depth(by) = &own.statement {
                    (definitions(audit, by))
                }
            }
            p.outcome { (lines(&theorem::outcome(finding))) }
            @if let Some(drawing) = &drawing { (drawing) }
            @let details = theorem::details(finding, hand.as_ref());
            @if !details.is_empty() {
                details { summary { "Data and cases" } (facts(&details)) }
            }
        },
    ))
}

/// What is stated.
fn statement(statement: &Statement) -> Markup {
    let shown = |by: &LocatedFormula| formula(&by.expr);
    match statement {
        Statement::Bound { quantity: bounded, by, from } => html! {
            (quantity(*bounded)) " ≤ " (shown(by)) " for k ≥ " (from)
        },
        Statement::Depth(by) => {
            html! { (quantity(Quantity::Distance)) " ≤ ε for k ≥ " (shown(by)) }
        }
        Statement::Other(says) => html! { (lines(says)) },
    }
}
