//! Equations, functions, ranges, smoothness and theorems.

use super::certified::certified;
use super::command;
use super::context::Context;
use super::math::formula;
use super::picture::{self, Exceeding};
use super::sheet::{facts, lines};
use super::statement::{definitions, identity, quantity};
use super::table;
use super::verdict::{Look, badge};
use crate::audit::{
    EquationFinding, Finding, FunctionFinding, RangeFinding, SmoothnessFinding, TheoremFinding,
    Word, by_hand,
};
use crate::claim::{EquationBody, Quantity, Statement};
use crate::diagnostic::Diagnostic;
use crate::formula::LocatedFormula;
use crate::report::formulas::equation;
use crate::report::formulas::function;
use crate::report::smooth::smoothness;
use crate::report::theorems::theorem;
use maud::{Markup, html};

/// The section of a claim.
///
/// # Errors
/// When a formula of the claim file is wrong.
pub(super) fn section(
    context: &Context<'_, '_>,
    finding: Finding<'_, '_>,
) -> Result<Markup, Diagnostic> {
    let contents = match finding {
        Finding::Table(finding) => return table::section(context, finding),
        Finding::Equation(finding) => equation(finding),
        Finding::Function(finding) => function(context, finding),
        Finding::Range(finding) => range(context, finding),
        Finding::Smoothness(finding) => smoothness(finding),
        Finding::Theorem(finding) => theorem(context, finding)?,
    };
    let (claim, verdict) = (finding.claim(), finding.word().unwrap_or(Word::Open));
    // An equation that fails says its note itself.
    let says_note = matches!(finding, Finding::Equation(_)) && verdict == Word::Fails;
    let note = claim.note().filter(|_| !says_note);
    let (id, locus, title) = (claim.id(), claim.locus(), claim.title());
    Ok(html! {
        section.claim.(Look::of(verdict).class) id=(id) aria-labelledby={ "page:title-" (id) } {
            h3 id={ "page:title-" (id) } {
                (badge(verdict)) " " a href={ "#" (id) } { (locus) } " " span.title { (title) }
            }
            (contents)
            @if let Some(note) = note { p.note { (lines(note)) } }
            (certified(context, id))
            (command::explain(context, id))
        }
    })
}

/// An equation.
fn equation(finding: &EquationFinding<'_>) -> Markup {
    html! {
            @if let EquationBody::Identity(body) = &finding.equation.body { (identity(body)) }
            p.outcome { (lines(&equation::outcome(finding))) }
    }
}

/// A closed form in a free parameter.
fn function(context: &Context<'_, '_>, finding: &FunctionFinding<'_>) -> Markup {
    let own = finding.claim;
    html! {
            dl.formulas {
                div { dt { "printed" } dd { (formula(&own.left.expr)) " = " (formula(&own.right.expr)) } }
                (definitions(context.audit, &own.left))
            }
            p.outcome { (lines(&function::function_outcome(finding).join("\n"))) }
    }
}

/// A range of a free parameter.
fn range(context: &Context<'_, '_>, finding: &RangeFinding<'_>) -> Markup {
    let own = finding.claim;
    let relation = match own.limit.relation() {
        "<" => "<",
        _ => "≤",
    };
    html! {
            dl.formulas {
                div {
                    dt { "condition" }
                    dd { (formula(&own.value.expr)) " " (relation) " " (formula(&own.limit.formula().expr)) }
                }
                (definitions(context.audit, &own.value))
            }
            @if let Some(picture) = picture::range(finding) { (picture) }
            p.outcome { (lines(&function::range_outcome(finding).join("\n"))) }
    }
}

/// A claim about the smoothness of limits.
fn smoothness(finding: &SmoothnessFinding<'_>) -> Markup {
    let own = finding.claim;
    let details = smoothness::details(finding);
    html! {
            dl.formulas {
                @if let Some(scheme) = smoothness::scheme(own) {
                    div { dt { "scheme" } dd { (scheme) } }
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
    }
}

/// A theorem, a lemma or a corollary.
///
/// # Errors
/// When a formula of the claim file is wrong.
fn theorem(context: &Context<'_, '_>, finding: &TheoremFinding<'_>) -> Result<Markup, Diagnostic> {
    let own = finding.theorem;
    let hand = by_hand(context.audit, finding)?;
    let violation = finding.refutation.as_ref().map(|refutation| &refutation.violation);
    let drawing = violation.zip(hand.as_ref()).and_then(|(violation, hand)| {
        picture::witness(&hand.refiner, &Exceeding::of_theorem(violation))
    });
    Ok(html! {
            dl.formulas {
                div { dt { "states" } dd { (statement(&own.statement)) } }
                @if let Statement::Bound { by, .. } | Statement::Depth(by) = &own.statement {
                    (definitions(context.audit, by))
                }
            }
            p.outcome { (lines(&theorem::outcome(finding))) }
            @if let Some(drawing) = &drawing { (drawing) }
            @let details = theorem::details(finding, hand.as_ref());
            @if !details.is_empty() && !context.is_whole {
                details { summary { "Data and cases" } (facts(&details)) }
            }
    })
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
