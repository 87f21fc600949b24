//! Which findings are theorems of Coq that the project compiles.

use crate::common::papers::{AUDITS, PAPERS, audit_of};
use std::collections::BTreeSet;
use std::fs::{read_dir, read_to_string};
use std::path::PathBuf;
use subcert::audit::{KernelCounts, KernelProof, PaperAudit, Share, audit, audit_claim};
use subcert::claim::{Cell, Paper, embedded, read_paper};
use subcert::diagnostic::SourceText;
use subcert::report::{audit_sheet, coverage_sheet, json::AuditReport};

fn noted(audit: &PaperAudit<'_>) -> usize {
    let cells = audit.tables.iter().flat_map(|table| table.cells.iter().flatten());
    let cells: usize = cells.map(|cell| cell.by_kernel.len()).sum();
    cells + audit.theorems.iter().map(|theorem| theorem.by_kernel.len()).sum::<usize>()
}

/// The comments of the theorems in the files that Coq compiles: the claim, the place, and what is said there, but for
/// numbers. A cell may rest on several constants.
fn said(key: &str) -> BTreeSet<String> {
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/proofs/coq/papers"));
    let Ok(files) = read_dir(folder.join(key.replace('-', "_"))) else { return BTreeSet::new() };
    let mut said = BTreeSet::new();
    for file in files.map(|file| file.expect("a file").path()) {
        if file.extension().is_none_or(|extension| extension != "v") {
            continue;
        }
        let text = read_to_string(&file).expect("a text");
        let lines: Vec<&str> = text.lines().collect();
        for at in (0..lines.len()).filter(|at| lines[*at].starts_with("Theorem ")) {
            let about = lines[at - 1].split(" level ").next().unwrap_or_default();
            said.insert(format!("{} {} {about}", lines[0], lines[at - 2]));
        }
    }
    said
}

/// Each theorem of the files is noted at a finding, and nothing else is.
#[test]
fn what_is_noted_is_what_is_compiled() {
    for audit in AUDITS.iter() {
        let key = &audit.paper.key;
        assert_eq!(noted(audit), said(key).len(), "{key}");
    }
    let KernelCounts { broken, broken_naturally, refuted, .. } =
        audit_of("mustafa2020-nary").kernel_counts();
    let shares = [broken, broken_naturally, refuted].map(|Share { proved, all }| (proved, all));
    assert_eq!(shares, [(164, 164), (64, 80), (6, 8)]);
    let theorem = |id: &str| {
        let mut theorems = audit_of("mustafa2020-nary").theorems.iter();
        let finding = theorems.find(|finding| finding.theorem.id == id);
        finding.expect("a theorem").by_kernel.clone()
    };
    assert_eq!(theorem("theorem-5"), [KernelProof::Refuted, KernelProof::RefutedNaturally]);
    // It is refuted by hand for infinitely many values.
    assert_eq!(theorem("eq-27"), []);
}

fn embedded_text(key: &str) -> &'static str {
    embedded().iter().find(|paper| paper.key == key).expect("an embedded paper").text
}

/// A claim file of one's own has nothing that was compiled, be it the same to the letter; nor has a paper of the
/// program in which one digit is another.
#[test]
fn files_of_ones_own_and_changed_papers_are_not_checked() {
    let key = "mustafa2007-bajaj";
    assert!(noted(audit_of(key)) > 0);
    let own = read_paper(&SourceText::new("own.toml", embedded_text(key))).expect("a claim file");
    let found = audit(&own).expect("an audit");
    assert_eq!(noted(&found), 0);
    let said = audit_sheet(std::slice::from_ref(&found), true).to_text(None);
    assert!(!said.contains("checked by Coq"), "{said}");
    assert!(!coverage_sheet(&[found]).to_text(None).contains("Coq"));

    let of = |paper: &Paper| noted(&audit_claim(paper, "table-1", &|| {}).expect("an audit"));
    let newton = PAPERS.iter().find(|paper| paper.key == "khan2019-newton").expect("a paper");
    assert!(of(newton) > 0);
    let mut changed = newton.clone();
    let Cell::Printed(printed) = &mut changed.tables[0].cells[0][0] else { panic!("it is lost") };
    printed.text = printed.text.replacen('5', "6", 1);
    assert_ne!(changed, *newton);
    assert_eq!(of(&changed), 0);
}

/// Text, Markdown and JSON say so, and a page does.
#[test]
fn reports_say_what_is_checked() {
    let audit = audit_of("mustafa2020-nary");
    let sheet = audit_sheet(std::slice::from_ref(audit), true);
    let said = "Checked by Coq: 28 sound values, 21 broken promises, 4 promises broken at natural parameters.";
    for text in [sheet.to_text(None), sheet.to_markdown()] {
        assert!(text.contains(said), "{text}");
        assert!(text.contains("0.9375 > 0.8681 · checked by Coq"), "{text}");
    }
    let json = serde_json::to_value(AuditReport::of(std::slice::from_ref(audit))).expect("JSON");
    let claims = json["papers"][0]["claims"].as_array().expect("claims");
    let of = |id: &str| {
        let claim = claims.iter().find(|claim| claim["id"] == id).expect("a claim");
        claim["checked_by_coq"].clone()
    };
    assert_eq!(
        of("mustafa2020-nary:theorem-5"),
        serde_json::json!(["refuted", "refuted-naturally"])
    );
    assert_eq!(of("mustafa2020-nary:eq-27"), serde_json::Value::Null);
    let page = &crate::common::papers::PAGES
        [AUDITS.iter().position(|it| it.paper.key == audit.paper.key).expect("a page")];
    assert!(page.contains(said));
    assert!(page.contains("checked by Coq"));
}
