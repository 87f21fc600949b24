//! Pages of audits.

use super::document::{Piece, read, text, within};
use crate::common::claims::{judged, paper};
use crate::common::papers::{AUDITS, PAGES};
use std::collections::BTreeSet;
use subcert::audit::PaperAudit;
use subcert::claim::read_paper;
use subcert::diagnostic::SourceText;
use subcert::report::Sheet;
use subcert::report::html::{audit_page, index_page};

/// The most bytes of a page.
const MAX_BYTES: usize = 2_000_000;

fn page(audit: &PaperAudit<'_>) -> String {
    audit_page(audit, None, None).unwrap_or_else(|error| panic!("{error}"))
}

/// Checks what every page keeps: well-formed, one element for each anchor, links that lead somewhere, and
/// nothing that is loaded or run.
pub(super) fn check(page: &str) -> Vec<Piece> {
    assert!(page.len() < MAX_BYTES, "{} bytes", page.len());
    let pieces = read(page);
    let mut ids = BTreeSet::new();
    for id in pieces.iter().filter_map(|piece| piece.attribute("id")) {
        assert!(ids.insert(id), "two elements have the id {id}");
    }
    for piece in &pieces {
        let Piece::Start(name, attributes) = piece else { continue };
        assert!(
            !["script", "iframe", "object", "embed", "base"].contains(&name.as_str()),
            "{name}"
        );
        for (attribute, value) in attributes {
            assert!(!attribute.starts_with("on"), "{attribute} = {value}");
            match (attribute.as_str(), value.strip_prefix('#')) {
                ("href", Some(anchor)) => assert!(ids.contains(anchor), "no anchor {anchor}"),
                // A link is followed by hand only; what else names an address would load it.
                ("href", None) if name == "a" => {
                    assert!(
                        value.starts_with("https://doi.org/") || !value.contains(':'),
                        "{value}"
                    );
                }
                ("href" | "src" | "srcset" | "data" | "xlink:href", _) => {
                    assert_eq!(value, "data:,", "{attribute} of {name}");
                }
                _ => {}
            }
            assert!(!value.contains("url("), "{value}");
        }
    }
    let style = within(&pieces, |piece| matches!(piece, Piece::Start(name, _) if name == "style"));
    assert!(!text(&style).contains("url(") && !text(&style).contains("@import"));
    pieces
}

#[test]
fn every_claim_and_every_cell_has_its_anchor() {
    for (audit, page) in AUDITS.iter().zip(&*PAGES) {
        let pieces = check(page);
        let with_id = |id: &str| {
            let found = pieces.iter().find(|piece| piece.attribute("id") == Some(id));
            found.unwrap_or_else(|| panic!("no {id} in {}", audit.paper.key))
        };
        let shown = text(&pieces);
        for claim in audit.claims() {
            assert!(with_id(claim.id).is("section", "claim"));
            let command = format!("subcert explain {}:{}", audit.paper.key, claim.id);
            assert!(shown.contains(&command), "no {command}");
        }
        for cell in audit.tables.iter().flat_map(|table| table.cells.iter().flatten()) {
            let anchor = &cell.id[audit.paper.key.len() + 1..];
            with_id(anchor);
            let element = within(&pieces, |piece| piece.attribute("id") == Some(anchor));
            let own = text(&element);
            assert!(own.contains(cell.printed.as_deref().unwrap_or("lost")), "{own}");
            assert!(own.contains(cell.verdict.word().name()) && own.contains(&cell.id), "{own}");
        }
    }
    let index = check(&index_page(&AUDITS, &Sheet::default()));
    for audit in AUDITS.iter() {
        let link = format!("{}.html", audit.paper.key);
        assert!(index.iter().any(|piece| piece.attribute("href") == Some(&link)), "no {link}");
    }
}

#[test]
fn text_of_claim_files_is_no_markup() {
    let evil = "<script>alert('&amp;')</script>";
    let file = format!(
        "key = 'k'\n[paper]\nauthors = [\"{evil}\"]\ntitle = \"{evil}\"\nvenue = \"{evil}\"\nyear = '1'\n\
         doi = \"{evil}\\\"'\"\nnote = \"{evil}\"\n\
         [[table]]\nid = 't'\nlocus = \"{evil}\"\ntitle = \"{evil}\"\nvalue = 'w'\nnote = \"{evil}\"\n\
         columns = {{ name = 'w', label = \"{evil}\", values = ['1', '2'] }}\ncells = [['1', '3']]\n\
         [[equation]]\nid = 'e'\nlocus = \"{evil}\"\ntitle = \"{evil}\"\nleft = '1'\nright = '2'\n\
         note = \"{evil}\"\n"
    );
    let paper =
        read_paper(&SourceText::new("k.toml", file)).unwrap_or_else(|error| panic!("{error}"));
    let audit = judged(&paper);
    let page = audit_page(&audit, Some("/tmp/<b>'.toml"), None).expect("a page");
    let pieces = check(&page);
    let shown = text(&pieces);
    assert!(shown.matches(evil).count() >= 10, "{shown}");
    assert!(shown.contains("subcert explain k:t '/tmp/<b>'\\''.toml'"), "{shown}");
    let index = check(&index_page(&[audit], &Sheet::default()));
    assert!(text(&index).contains(evil));
}

/// The elements of the first formula of a page, as text.
fn formula(value: &str) -> String {
    let claims = format!(
        "[[table]]\nid = 't'\nlocus = 'T'\ntitle = 't'\nvalue = '{value}'\n\
         given = {{ a = '2', beta_1 = '3', k = '1' }}\n\
         columns = {{ name = 'w', values = ['1'] }}\ncells = [['1']]\n"
    );
    let paper = paper(&claims);
    let page = page(&judged(&paper));
    let from = page.find("<math").expect("a formula");
    let to = page.find("</math>").expect("its end");
    let inner = page[from..to].split_once('>').expect("a tag").1.to_owned();
    ["mrow", "mi", "mn"].iter().fold(inner, |text, name| {
        text.replace(&format!("<{name}>"), "{").replace(&format!("</{name}>"), "}")
    })
}

#[test]
fn formulas_are_typeset() {
    for (text, typeset) in [
        ("w", "{w}"),
        ("3/4", "<mfrac>{3}{4}</mfrac>"),
        ("beta_1", "<msub>{β}{1}</msub>"),
        // A bar takes the place of parentheses, a product does not.
        ("(a + w)/k", "<mfrac>{{a}<mo>+</mo>{w}}{k}</mfrac>"),
        (
            "(a + w)*k",
            "{{<mo stretchy=\"false\">(</mo>{{a}<mo>+</mo>{w}}<mo stretchy=\"false\">)</mo>}<mo>\u{2062}</mo>{k}}",
        ),
        // −(a + w) is not −a + w, and a − (w − k) not a − w − k.
        (
            "-(a + w)",
            "{<mo>−</mo>{<mo stretchy=\"false\">(</mo>{{a}<mo>+</mo>{w}}<mo stretchy=\"false\">)</mo>}}",
        ),
        (
            "a - (w - k)",
            "{{a}<mo>−</mo>{<mo stretchy=\"false\">(</mo>{{w}<mo>−</mo>{k}}<mo stretchy=\"false\">)</mo>}}",
        ),
        ("a*w/k", "<mfrac>{{a}<mo>\u{2062}</mo>{w}}{k}</mfrac>"),
        ("a/w*k", "{<mfrac>{a}{w}</mfrac><mo>\u{2062}</mo>{k}}"),
        (
            "(1/2)^k",
            "<msup>{<mo stretchy=\"true\">(</mo><mfrac>{1}{2}</mfrac><mo stretchy=\"true\">)</mo>}{k}</msup>",
        ),
        ("abs(w)", "{<mo stretchy=\"false\">|</mo>{w}<mo stretchy=\"false\">|</mo>}"),
        // A sign or a factor after a maximum does not belong to it.
        (
            "max(j = 1..k, j)*w",
            "{{<mo stretchy=\"true\">(</mo>{<munder><mo>max</mo>{{j}<mo>=</mo>{1}<mo>…</mo>{k}}</munder>{j}}\
             <mo stretchy=\"true\">)</mo>}<mo>\u{2062}</mo>{w}}",
        ),
        (
            "sum(j = 1..3, j*w)",
            "{<munderover><mo>∑</mo>{{j}<mo>=</mo>{1}}{{3}}</munderover>{{j}<mo>\u{2062}</mo>{w}}}",
        ),
    ] {
        assert_eq!(formula(text), typeset, "{text}");
    }
}
