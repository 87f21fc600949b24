//! Pictures with their words: on a page, or several in one file.

use super::frame::{WIDTH, picture};
use crate::diagnostic::wrapped;
use crate::report::html::document::PICTURE_STYLE;
use crate::report::html::typeset::typeset;
use crate::report::words::notation::unicode;
use maud::{Markup, PreEscaped, html};

/// The most characters of a line of words below a picture: as many fit on a narrow screen, where letters are larger.
const LINE: usize = 66;

/// How far lines of words are apart.
const APART: f64 = 20.0;

/// A picture of [`WIDTH`].
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    pub(crate) title: String,
    /// What it shows, in words, and what it does not show, with the reason.
    pub(crate) says: String,
    /// 0 where there are words alone.
    pub(crate) height: f64,
    pub(crate) drawing: Markup,
}

impl Panel {
    /// Words alone.
    pub(crate) fn of_words(title: String, says: String) -> Panel {
        Panel { title, says, height: 0.0, drawing: html! {} }
    }

    /// With the words below it.
    pub(crate) fn figure(&self) -> Markup {
        let Panel { title, says, height, drawing } = self;
        html! {
            figure {
                @if *height > 0.0 { (picture(title, says, *height, drawing)) }
                figcaption { (typeset(says)) }
            }
        }
    }
}

/// One file with all pictures, from top to bottom, each below its title and above its words.
pub(crate) fn standalone(title: &str, panels: &[Panel]) -> String {
    let mut top = APART + 12.0;
    let mut placed = Vec::new();
    for panel in panels {
        let lines = wrapped(&unicode(&panel.says), LINE, 0, false);
        let words = top + APART;
        let below = words + panel.height + APART;
        let lines: Vec<(f64, String)> =
            std::iter::successors(Some(below), |at| Some(at + APART)).zip(lines).collect();
        let end = lines.last().map_or(below, |(at, _)| *at) + 2.0 * APART;
        placed.push((top, words - 8.0, lines, panel));
        top = end;
    }
    let height = top - APART;
    let all = panels.iter().map(|panel| unicode(&format!("{}. {}", panel.title, panel.says)));
    let description = all.collect::<Vec<String>>().join(" ");
    let file = html! {
        svg xmlns="http://www.w3.org/2000/svg" viewBox={ "0 0 " (WIDTH) " " (height) } width=(WIDTH) height=(height) role="img" aria-labelledby="title description" {
            title id="title" { (title) }
            desc id="description" { (description) }
            style { (PreEscaped(PICTURE_STYLE)) }
            rect.paper width=(WIDTH) height=(height) {}
            @for (top, drawn, lines, panel) in &placed {
                text.title x="12" y=(top) { (unicode(&panel.title)) }
                g transform={ "translate(0 " (drawn) ")" } { (panel.drawing) }
                @for (at, line) in lines { text.soft x="12" y=(at) { (line) } }
            }
        }
    };
    format!("{}\n", file.into_string())
}
