//! What the colours of a picture mean.

use crate::report::words::notation::unicode;
use maud::{Markup, html};

/// How far apart the entries of a legend stand.
const ENTRY: f64 = 150.0;

/// The names of classes in a row, with a sample of each, below a picture of this height; and the height with
/// the row.
pub(crate) fn legend(entries: &[(&'static str, String)], height: f64) -> (Markup, f64) {
    let lefts = (0..8_u8).map(|place| 16.0 + ENTRY * f64::from(place));
    let row = html! {
        @for ((class, name), left) in entries.iter().zip(lefts) {
            g class=(class) {
                line.line x1=(left) x2=(left + 22.0) y1=(height + 10.0) y2=(height + 10.0) {}
                text.name x=(left + 28.0) y=(height + 14.0) { (unicode(name)) }
            }
        }
    };
    (row, height + 24.0)
}
