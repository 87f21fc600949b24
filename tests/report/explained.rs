//! Pages of single findings, and the lines of certificates.

use super::document::{read, text, within};
use super::html::check;
use crate::common::papers::{AUDITS, CERTIFICATES, PAGES, audit_of};
use subcert::audit::PaperAudit;
use subcert::certificate::certificate_lines;
use subcert::report::html::explain_page;
use subcert::report::{Background, Block, explain_sheet};

fn page(audit: &PaperAudit<'_>, id: &str) -> Option<String> {
    explain_page(audit, id, Background::default(), false, None).expect("no wrong formula")
}

/// A text without what is typed for scripts and signs, which pages have in another form.
fn bare(text: &str) -> String {
    let letters = [
        ("alpha", "α"),
        ("beta", "β"),
        ("epsilon", "ε"),
        ("lambda", "λ"),
        ("mu", "μ"),
        ("omega", "ω"),
        ("sigma", "σ"),
        ("tau", "τ"),
        ("xi", "ξ"),
    ];
    let signs = [("_", ""), ("^", ""), ("`", ""), ("{", ""), ("}", ""), ("−", "-")];
    let pairs = letters.into_iter().chain(signs).chain([("<=", "≤"), (">=", "≥")]);
    pairs.fold(text.to_owned(), |text, (typed, shown)| text.replace(typed, shown))
}

/// A claim of each kind, a table and a cell have pages, which say what the report says.
#[test]
fn a_page_says_what_the_report_says() {
    let mut seen = 0;
    for audit in AUDITS.iter() {
        let key = &audit.paper.key;
        let first = |ids: Vec<&String>| ids.first().map(|id| format!("{key}:{id}"));
        let ids = [
            first(audit.tables.iter().map(|finding| &finding.table.id).collect()),
            audit.tables.first().map(|finding| finding.cells[0][0].id.clone()),
            first(audit.equations.iter().map(|finding| &finding.equation.id).collect()),
            first(audit.functions.iter().map(|finding| &finding.claim.id).collect()),
            first(audit.ranges.iter().map(|finding| &finding.claim.id).collect()),
            first(audit.theorems.iter().map(|finding| &finding.theorem.id).collect()),
        ];
        for id in ids.into_iter().flatten() {
            let pieces = check(&page(audit, &id).unwrap_or_else(|| panic!("no page of {id}")));
            let shown = bare(&text(&pieces));
            let sheet =
                explain_sheet(std::slice::from_ref(audit), &id, Background::default(), false);
            let mut grids = 0;
            for block in sheet.expect("a report").blocks {
                match block {
                    Block::Heading(_, text) => {
                        assert!(shown.contains(&bare(&text)), "{id}: {text}");
                    }
                    Block::Facts(facts) => {
                        for (name, _) in facts {
                            assert!(shown.contains(&bare(&name)), "{id}: {name}");
                        }
                    }
                    Block::Grid(_) => grids += 1,
                    Block::Text(_) => {}
                }
            }
            let tables = pieces.iter().filter(|piece| matches!(piece, super::document::Piece::Start(name, _) if name == "table")).count();
            assert!(tables >= grids, "{id}: {tables} of {grids} tables");
            assert!(shown.contains(&bare(&format!("subcert explain {id}"))), "{id}");
            seen += 1;
        }
        assert!(page(audit, &format!("{key}:nothing")).is_none());
        assert!(page(audit, "other:table-1").is_none());
    }
    assert!(seen > 15, "{seen}");
}

/// The lines of all claims are the certificate, and each claim of a page shows its own.
#[test]
fn each_claim_shows_its_lines() {
    for ((audit, page), whole) in AUDITS.iter().zip(&*PAGES).zip(&*CERTIFICATES) {
        let claims = certificate_lines(audit);
        let whole = &whole.text;
        let together: String = claims.iter().filter_map(|claim| claim.lines.clone().ok()).collect();
        // The certificate has them after two lines, between comments.
        let is_own = |line: &&str| !line.starts_with('#') && !line.starts_with("end ");
        let kept: Vec<&str> = whole.lines().skip(2).filter(is_own).collect();
        assert_eq!(kept, together.lines().collect::<Vec<&str>>());
        let pieces = read(page);
        assert_eq!(claims.len(), audit.claims().len());
        for claim in &claims {
            let section = within(&pieces, |piece| piece.attribute("id") == Some(&claim.id));
            let shown = text(&section);
            match &claim.lines {
                Ok(lines) => {
                    let beginning: String = lines.chars().take(20_000).collect();
                    assert!(shown.contains(beginning.trim_end()), "{}", claim.id);
                }
                Err(why) => assert!(shown.contains(why), "{}", claim.id),
            }
        }
    }
}

/// The page of a cell has the lines about that cell only.
#[test]
fn a_cell_shows_its_own_lines() {
    let page = page(audit_of("khan2019-newton"), "khan2019-newton:table-1:2:1").expect("a page");
    let pieces = read(&page);
    let lines = text(&within(
        &pieces,
        |piece| matches!(piece, super::document::Piece::Start(name, _) if name == "pre"),
    ));
    assert!(lines.lines().count() >= 2, "{lines}");
    for line in lines.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        assert_eq!(&words[1..3], ["2", "1"], "{line}");
    }
}
