//! A misprint: the digits of both numbers lined up.

use crate::audit::{CellFinding, Verdict};
use crate::exact::format::fixed;
use maud::{Markup, html};

/// The printed number above the exact one, with the places marked where they differ; `None` of a cell that
/// is no misprint.
pub(crate) fn digits(cell: &CellFinding) -> Option<Markup> {
    let (Verdict::Misprint(_), Some(printed)) = (&cell.verdict, &cell.printed) else { return None };
    let exact = cell.as_read.as_ref().map(|read| &read.value).or(cell.exact.as_ref())?;
    // Only plain decimals line up.
    if !printed.chars().all(|c| c.is_ascii_digit() || matches!(c, '.' | '-')) {
        return None;
    }
    let places = printed.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    let exact = fixed(exact, u32::try_from(places).ok()?);
    let (whole, exact_whole) = (whole(printed), whole(&exact));
    let width = whole.max(exact_whole);
    let printed: Vec<char> = format!("{}{printed}", " ".repeat(width - whole)).chars().collect();
    let exact: Vec<char> = format!("{}{exact}", " ".repeat(width - exact_whole)).chars().collect();
    Some(html! {
        div.digits role="group" aria-label="The digits of the printed and the exact number" {
            (line("printed ", &printed, &exact)) "\n"
            (line("exact   ", &exact, &printed))
        }
    })
}

/// How many characters stand before the point.
fn whole(number: &str) -> usize {
    number.find('.').unwrap_or(number.len())
}

fn line(name: &str, own: &[char], other: &[char]) -> Markup {
    html! {
        (name)
        @for (place, c) in own.iter().enumerate() {
            @if other.get(place) == Some(c) { (c) } @else { mark { (c) } }
        }
    }
}
