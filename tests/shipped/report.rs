//! The words, and the texts for issue trackers.

use super::{HEAD, project, table};
use subcert::report::html::project_page;
use subcert::report::json::ProjectsReport;
use subcert::report::{issue_sheet, projects_sheet};
use subcert::shipped::audit_project;

#[test]
fn sentences() {
    let cells = ["0.3333f", "0.3333f", "0.3333f", "0.3f", "0.3f", "0.4f"];
    let text = table("f32", "'i = 1..2', 'k = 1..3'", "1/3", &cells);
    let project = project(&format!("{text}tolerance = '1/100'\n"));
    let audits = [audit_project(&project).expect("an audit")];
    let sheet = projects_sheet(&audits, false).to_text(None);
    for part in [
        "Program (k): of 1 table, 1 has wrong numbers.",
        "Of 6 numbers, 3 are wrong, 3 are rounded to the digits that are written.",
        "Over k, the exact values of each line have the sum 1; as shipped, 1 line misses it, by up to 0.0001 at i = 1",
        "One exact value is shipped in two ways, up to its sign: 0.3333f at i = 1, k = 1 and 0.3f at i = 2, k = 1.",
        "The project accepts errors of 1/100; 3 of 6 are greater.",
        "wrong by 0.0667",
    ] {
        let sheet = sheet.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(sheet.contains(part), "no `{part}` in: {sheet}");
    }
}

#[test]
fn an_issue_tells_what_to_write() {
    let text = table("f64", "'k = 1..2'", "k/3", &["0.333333", "0.666667"]);
    let project = project(&format!("{text}tolerance = '1e-6'\n"));
    let audits = [audit_project(&project).expect("an audit")];
    let issue = issue_sheet(&audits).to_markdown();
    for part in [
        "| k = 1 | 0.333333 | 0.33333333333333333333 | 0.3333333333333333 | ≈ rounded to 6 digits |",
        "A note: more digits",
        "none is greater: a note, not a bug",
        "is 0.333333333333333333333333333333 at k = 1",
        "`subcert explain k:t k.toml`",
    ] {
        let plain = issue.replace('\\', "");
        assert!(plain.contains(part), "no `{part}` in: {plain}");
    }
    let right = super::project(&table("f64", "", "1/2", &["0.5"]));
    let issue = issue_sheet(&[audit_project(&right).expect("an audit")]).to_markdown();
    assert!(issue.contains("Nothing has to change."), "{issue}");
}

/// Texts of a claim file are text on a page, and the page has every number.
#[test]
fn pages() {
    let text = table("f32", "'k = 1..20'", "k/2", &["1e3f"; 20]);
    let text = text.replace("a table", "<b>a & b</b>");
    let project = project(&text);
    let page = project_page(&audit_project(&project).expect("an audit"));
    assert!(!page.contains("<b>") && page.contains("&lt;b&gt;a &amp; b&lt;/b&gt;"), "{page}");
    assert_eq!(page.matches("<var>k</var> = 20").count(), 1);
    assert!(
        HEAD.contains("https://example.org/program")
            && page.contains("href=\"https://example.org/program\"")
    );
}

#[test]
fn json() {
    let project = project(&table("f32", "'k = 1..2'", "sqrt(k)", &["1", "1.41f"]));
    let audits = [audit_project(&project).expect("an audit")];
    let json = serde_json::to_value(ProjectsReport::of(&audits)).expect("JSON");
    let table = &json["projects"][0]["tables"][0];
    assert_eq!(table["outcome"], "cut");
    assert_eq!(table["numbers"][1]["verdict"], "rounded");
    assert_eq!(table["numbers"][1]["digits"], 3);
    assert_eq!(table["numbers"][1]["at"]["k"], 2);
    assert_eq!(table["numbers"][1]["exact"], "1.41421356237309504880168872421");
    assert_eq!(table["numbers"][1]["nearest"], "1.4142135");
}
