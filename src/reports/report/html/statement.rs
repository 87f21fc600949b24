//! What claims state, with their formulas.

use super::math::{bracketed, inner};
use super::names::name;
use crate::audit::PaperAudit;
use crate::claim::{Identity, Index, Left, Quantity};
use crate::formula::LocatedFormula;
use maud::{Markup, html};

/// A formula in a line of its own.
fn block(contents: &Markup) -> Markup {
    html! { div.equation { math displaystyle="true" { (contents) } } }
}

/// What a theorem bounds.
pub(crate) fn quantity(quantity: Quantity) -> Markup {
    let level = |k: &Markup| html! { msup { mi { "P" } (k) } };
    let (k, next, limit) = (
        html! { mi { "k" } },
        html! { mrow { mi { "k" } mo { "+" } mn { "1" } } },
        html! { mi { "∞" } },
    );
    let norm = |first: &Markup| {
        let difference = html! { (level(first)) mo { "−" } (level(&k)) };
        bracketed("‖", &difference, "‖", false)
    };
    let inner = match quantity {
        Quantity::Distance => norm(&limit),
        Quantity::Step => norm(&next),
        Quantity::Difference => {
            let norm = bracketed("‖", &html! { msup { mi { "Δ" } (k) } }, "‖", false);
            html! { mrow { mo { "max" } (norm) } }
        }
    };
    html! { math alttext=(quantity.notation()) { (inner) } }
}

/// The definitions that a formula uses, as entries of a list.
pub(crate) fn definitions(audit: &PaperAudit<'_>, located: &LocatedFormula) -> Markup {
    html! {
        @for (defined, definition) in audit.paper.definitions_in(located) {
            div.wide[is_long(definition)] {
                dt { "where" }
                dd { math { (name(defined)) mo { "=" } (inner(&definition.expr)) } }
            }
        }
    }
}

/// The characters of a formula that stand beside another column.
const HALF: usize = 60;

/// The same of an equation, whose sums are shorter in print.
const SUMS: usize = 90;

/// Whether a formula needs the whole page.
pub(crate) fn is_long(located: &LocatedFormula) -> bool {
    located.text.chars().count() > HALF
}

/// left = right, for the values of the indices.
pub(crate) fn identity(identity: &Identity) -> Markup {
    let right = || inner(&identity.right.expr);
    let long = match &identity.left {
        Left::One(left) => left.text.len() + identity.right.text.len() > SUMS,
        Left::Each(all) => all.iter().chain([&identity.right]).any(is_long),
    };
    html! {
        div.scroll.wide[long] tabindex="0" role="group" aria-label="equation" {
            @match &identity.left {
                Left::One(left) => { (block(&html! { (inner(&left.expr)) mo { "=" } (right()) })) }
                Left::Each(all) => {
                    @for left in all { (block(&inner(&left.expr))) }
                    p { "each equal to" }
                    (block(&right()))
                }
            }
        }
        @if !identity.indices.is_empty() {
            p.indices { "for " (identity.indices.iter().map(index).collect::<Vec<String>>().join(", ")) }
        }
    }
}

/// `i = 2…N-1`.
fn index(index: &Index) -> String {
    match index {
        Index::Range { label, from, to, .. } => format!("{label} = {}…{}", from.text, to.text),
        Index::Listed { label, values, .. } => {
            let values: Vec<&str> = values.iter().map(|(_, printed)| printed.as_str()).collect();
            format!("{label} = {}", values.join(", "))
        }
    }
}
