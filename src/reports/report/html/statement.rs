//! What claims state, with their formulas.

use super::math::{bracketed, inner};
use super::names::name;
use crate::audit::PaperAudit;
use crate::claim::{Comparison, Identity, Index, Left, Quantity, Sign};
use crate::exact::Rational;
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

/// left = right, or another relation, for the values of the indices.
pub(crate) fn identity(identity: &Identity) -> Markup {
    let length =
        |comparison: &Comparison| comparison.formulas().map(|side| side.text.len()).sum::<usize>();
    let long = match &identity.first().left {
        Left::One(_) => identity.comparisons.iter().map(length).sum::<usize>() > SUMS,
        Left::Each(_) => identity.first().formulas().any(is_long),
    };
    html! {
        div.scroll.wide[long] tabindex="0" role="group" aria-label="equation" {
            @for comparison in &identity.comparisons { (compared(comparison)) }
        }
        @if !identity.indices.is_empty() {
            p.indices { "for " (identity.indices.iter().map(index).collect::<Vec<String>>().join(", ")) }
        }
    }
}

fn compared(comparison: &Comparison) -> Markup {
    let right = inner(&comparison.right().expr);
    match (&comparison.left, comparison.sign) {
        (Left::One(left), Sign::OneOf) => block(&html! {
            (inner(&left.expr)) mo { "∈" } mo { "{" }
            @for (i, member) in comparison.rights.iter().enumerate() {
                @if i > 0 { mo { "," } }
                (inner(&member.expr))
            }
            mo { "}" }
        }),
        (Left::One(left), Sign::True) => block(&inner(&left.expr)),
        (Left::One(left), Sign::False) => block(&html! { mo { "¬" } (inner(&left.expr)) }),
        (Left::One(left), sign) => {
            block(&html! { (inner(&left.expr)) mo { (sign.mark()) } (right) })
        }
        (Left::Each(all), _) => html! {
            @for left in all { (block(&inner(&left.expr))) }
            p { "each equal to" }
            (block(&right))
        },
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
        Index::Together { names, rows } => {
            let row = |row: &Vec<(Rational, String)>| {
                let printed: Vec<&str> = row.iter().map(|(_, printed)| printed.as_str()).collect();
                format!("({})", printed.join(", "))
            };
            let rows: Vec<String> = rows.iter().map(row).collect();
            format!("({}) = {}", names.join(", "), rows.join(", "))
        }
        Index::All { name, from } => format!("all {name} ≥ {from}"),
        Index::Real { text, .. } => text.clone(),
    }
}
