//! What every page has around its contents.

use maud::{DOCTYPE, Markup, PreEscaped, html};

/// The colours of pages and pictures, and the looks of pictures.
pub(super) const PICTURE_STYLE: &str = include_str!("picture.css");

const STYLE: &str = include_str!("style.css");

/// What a browser may load for a page: nothing but the styles in it.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'";

/// A document with this title and main part.
pub(super) fn document(title: &str, main: &Markup) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
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
            }
        }
    };
    page.into_string()
}
