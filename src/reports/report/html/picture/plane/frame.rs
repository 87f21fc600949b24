//! The frame of a diagram: its axes with ticks.

use super::scale::Scale;
use crate::report::words::notation::unicode;
use maud::{Markup, html};

/// The width of a picture; it shrinks with the page.
pub(crate) const WIDTH: f64 = 640.0;

/// Where a diagram stands in its picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    /// The left and the right side.
    pub(crate) x: (f64, f64),
    /// The lower and the upper side: places run downwards.
    pub(crate) y: (f64, f64),
}

/// A picture of this height, with a title and a description for those who do not see it.
pub(crate) fn picture(title: &str, description: &str, height: f64, contents: &Markup) -> Markup {
    html! {
        svg viewBox={ "0 0 " (WIDTH) " " (height) } width=(WIDTH) height=(height) role="img" {
            title { (unicode(title)) }
            desc { (unicode(description)) }
            (contents)
        }
    }
}

impl Frame {
    /// The frame with ticks on both sides.
    pub(crate) fn drawn(&self, x: &[(f64, String)], y: &Scale) -> Markup {
        let (left, right) = self.x;
        let (bottom, top) = self.y;
        html! {
            @for (value, label) in y.ticks() {
                @let place = y.at(value);
                line.axis x1=(left) x2=(right) y1=(place) y2=(place) {}
                text.soft x=(left - 6.0) y=(place + 4.0) text-anchor="end" { (label) }
            }
            @for (place, label) in x {
                line.axis x1=(place) x2=(place) y1=(bottom) y2=(bottom + 4.0) {}
                text.soft x=(place) y=(bottom + 18.0) text-anchor="middle" { (label) }
            }
            rect.frame x=(left) y=(top) width=(right - left) height=(bottom - top) {}
        }
    }
}

/// `x,y x,y`: the points of a line.
pub(crate) fn points(places: &[(f64, f64)]) -> String {
    let pair = |(x, y): &(f64, f64)| format!("{x},{y}");
    places.iter().map(pair).collect::<Vec<String>>().join(" ")
}
