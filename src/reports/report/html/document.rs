//! What every page has around its contents.

use maud::{DOCTYPE, Markup, PreEscaped, html};

/// The colours of pages and pictures, and the looks of pictures.
pub(super) const PICTURE_STYLE: &str = include_str!("picture.css");

const STYLE: &str = include_str!("style.css");

/// What a browser may load for a page: nothing but the styles in it.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'";

/// The same of a page with a script of its own.
const SCRIPT_POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'";

/// A document with this title and main part.
pub(super) fn document(title: &str, main: &Markup) -> String {
    whole(title, main, None)
}

/// A document that a script in it makes easier to use. It has to work without.
pub(super) fn document_with_script(title: &str, main: &Markup, script: &str) -> String {
    whole(title, main, Some(script))
}

fn whole(title: &str, main: &Markup, script: Option<&str>) -> String {
    let policy = if script.is_some() { SCRIPT_POLICY } else { POLICY };
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(policy);
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="generator" content={ "subcert " (env!("CARGO_PKG_VERSION")) };
                meta name="color-scheme" content="light dark";
                link rel="icon" href="data:,";
                title { (title) }
                style { (PreEscaped(PICTURE_STYLE)) (PreEscaped(STYLE)) }
            }
            body {
                a.skip href="#page:main" { "Skip to the findings" }
                (main)
                footer {
                    p { "Written by subcert " (env!("CARGO_PKG_VERSION")) ", which computes with exact numbers." }
                }
                @if let Some(script) = script { script { (PreEscaped(script)) } }
            }
        }
    };
    page.into_string()
}
