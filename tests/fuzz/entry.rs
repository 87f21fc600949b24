//! What the fuzz targets of `fuzz/` and the bounded run of `main.rs` call: each takes any
//! bytes, and fails when a program panics or breaks a promise.

use std::str::from_utf8;
use subcert::audit::audit;
use subcert::certificate::{certificate as written, project_certificate};
use subcert::claim::read_paper;
use subcert::diagnostic::SourceText;
use subcert::formula::{MAX_FORMULA_LENGTH, parse};
use subcert::literal::{Language, read_literals};
use subcert::report::issue_sheet;
use subcert::shipped::{audit_project, read_project};
use subcert_check::{Outcome, check, is_formula};

/// The code block of FORMAT.md in this language.
pub fn example(language: &str) -> &'static str {
    let text = include_str!("../../proofs/FORMAT.md");
    let begins = format!("```{language}\n");
    let (_, after) = text.split_once(&begins).expect("a code block");
    after.split_once("```").expect("its end").0
}

/// A certificate about the example of FORMAT.md: what is accepted says what is true.
pub fn certificate(data: &[u8]) {
    let Ok(text) = from_utf8(data) else { return };
    let report = check(example("toml"), &[text]).expect("the claim file is right");
    let says = |begin: &str, end: &str| {
        let words = |line: &str| line.split_whitespace().collect::<Vec<&str>>().join(" ");
        text.lines().map(words).any(|line| line.starts_with(begin) && line.ends_with(end))
    };
    for (_, id, outcome) in report.claims {
        if outcome != Outcome::Valid {
            continue;
        }
        if id == "table-1" {
            assert!(says("cell 1 1 ", " confirmed") && says("cell 1 2 ", " confirmed"), "{text}");
            assert!(says("cell 1 3 ", "cut"), "{text}");
        } else {
            assert!(says("fails", "2") && says("case 2 ", ""), "{text}");
        }
    }
}

/// A claim file for the checker, with the example's certificate.
pub fn checked_claims(data: &[u8]) {
    let Ok(text) = from_utf8(data) else { return };
    // An error is an answer.
    let _ = check(text, &[example("text")]);
}

/// A claim file for the program.
pub fn claim_file(data: &[u8]) {
    let Ok(text) = from_utf8(data) else { return };
    let _ = read_paper(&SourceText::new("fuzz", text));
}

/// A formula, for the parsers of both: what is written back reads the same, and one
/// accepts what the other does.
pub fn formula(data: &[u8]) {
    let Ok(text) = from_utf8(data) else { return };
    let parsed = parse(text);
    if let Ok(expr) = &parsed {
        let back = expr.to_string();
        if back.len() <= MAX_FORMULA_LENGTH {
            let again = parse(&back).unwrap_or_else(|error| panic!("{text}: {back}: {error}"));
            assert_eq!(again.to_string(), back, "{text}");
        }
    }
    if text.len() <= MAX_FORMULA_LENGTH {
        assert_eq!(parsed.is_ok(), is_formula(text), "{text}: {parsed:?}");
    }
}

/// A formula as the value of a table with one cell: what the program finds, the checker
/// does not reject.
pub fn value(data: &[u8]) {
    let Ok(text) = from_utf8(data) else { return };
    if text.len() > 200 || text.contains(['\'', '\n', '\r']) {
        return;
    }
    let claims = format!(
        "key = \"fuzz\"\n[paper]\nauthors = []\ntitle = \"\"\nvenue = \"\"\nyear = \"\"\n\
         [define]\nhalf = 'x/2'\n[[table]]\nid = \"t\"\nlocus = \"\"\ntitle = \"\"\n\
         scheme = \"chaikin\"\nvalue = '{text}'\n\
         columns = {{ name = \"x\", values = ['1', '-2/3'] }}\ncells = [['0.5', '-0.667']]\n"
    );
    let Ok(paper) = read_paper(&SourceText::new("fuzz", claims.clone())) else { return };
    let Ok(audit) = audit(&paper) else { return };
    let certificate = written(&audit);
    let report = check(&claims, &[&certificate.text]).expect("a claim file");
    for (_, _, outcome) in report.claims {
        let Outcome::Invalid(_, rejection) = outcome else { continue };
        panic!("{text}: {:?}: {}", rejection.reason, certificate.text);
    }
}

/// A claim file of a project for the program: reading and judging it end, and what is said of its numbers has words.
pub fn project_file(data: &[u8]) {
    let Ok(text) = from_utf8(data) else { return };
    let Ok(project) = read_project(&SourceText::new("fuzz", text)) else { return };
    let Ok(audit) = audit_project(&project) else { return };
    let _ = project_certificate(&audit);
    let _ = issue_sheet(&[audit]).to_markdown();
}

/// A source file with a table, in each language: it is read, or refused with its place.
pub fn source_file(data: &[u8]) {
    let Ok(text) = from_utf8(data) else { return };
    let source = SourceText::new("fuzz", text);
    for language in
        [Language::C, Language::Shader, Language::JavaScript, Language::Python, Language::Rust]
    {
        if let Ok(table) = read_literals(&source, language, "table", &[2, 2]) {
            assert_eq!(table.entries.len(), 4, "{text}");
        }
    }
}
