//! What is wrong with the constants of a project, as a text for its issue tracker.

use super::facts;
use super::table::{equals, headline, numbers, rows};
use super::words::{self, after_at};
use crate::report::words::sheet::Sheet;
use crate::shipped::{
    ExactValues, Outcome, Project, ProjectAudit, ShippedFinding, Verdict, decimal,
};

/// The most numbers that are listed of a table.
const MAX_LISTED: usize = 40;

/// The digits of the value by which one may check a formula.
const CHECK_DIGITS: u32 = 30;

/// The texts of projects: of each table that is not right to the last bit, what is shipped, what is right, how to check it, and how
/// much it matters.
#[must_use]
pub fn issue_sheet(audits: &[ProjectAudit<'_>]) -> Sheet {
    let mut sheet = Sheet::default();
    for audit in audits {
        project(&mut sheet, audit);
    }
    sheet
}

fn project(sheet: &mut Sheet, audit: &ProjectAudit<'_>) {
    let Project { name, repository, commit, .. } = audit.project;
    sheet.heading(1, format!("Constants in {name}, compared with their exact values"));
    let repository = repository.as_ref().map(|repository| format!(" in {repository}"));
    let commit = commit.as_ref().map(|commit| format!(" at commit {commit}"));
    let place = repository.unwrap_or_default() + &commit.unwrap_or_default();
    if !place.is_empty() {
        sheet.text(format!("Read{place}."));
    }
    let (right, rest): (Vec<_>, Vec<_>) =
        audit.findings.iter().partition(|finding| finding.is_right());
    if rest.is_empty() {
        sheet.text("Every number is the nearest of its type. Nothing has to change.");
        return;
    }
    let mut rest = rest;
    rest.sort_by_key(|finding| std::cmp::Reverse(finding.outcome));
    for finding in rest {
        table(sheet, audit.project, finding);
    }
    if !right.is_empty() {
        sheet.heading(2, "Right to the last bit");
        let names: Vec<String> = right.iter().map(|finding| finding.claim.locus.clone()).collect();
        sheet.text(format!("{}.", names.join("; ")));
    }
}

fn table(sheet: &mut Sheet, project: &Project, finding: &ShippedFinding<'_>) {
    let claim = finding.claim;
    sheet.heading(2, claim.locus.clone());
    sheet.text(format!("{}. {}", claim.title, headline(finding)));
    let mut facts = vec![
        ("numbers".to_owned(), numbers(finding)),
        ("should equal".to_owned(), equals(&claim.exact)),
    ];
    facts.extend(words::definitions(project, claim));
    facts.push(("how much it matters".to_owned(), weight(finding)));
    facts.push(("how to check".to_owned(), check(project, finding)));
    sheet.facts(facts);
    if let Some(note) = &claim.note {
        sheet.text(note.clone());
    }
    let away = |place: &usize| finding.cells[*place].verdict != Verdict::Nearest;
    let mut places: Vec<usize> = (0..finding.cells.len()).filter(away).collect();
    let count = places.len();
    if count > MAX_LISTED {
        places.sort_by_key(|&place| std::cmp::Reverse(finding.cells[place].verdict.outcome()));
        places.truncate(MAX_LISTED);
    }
    sheet.grid(rows(finding, &places));
    if places.len() < count {
        sheet.text(format!(
            "{} of {count} numbers that are not the nearest of their type; the program's JSON has all.",
            places.len()
        ));
    }
}

/// How much it matters.
fn weight(finding: &ShippedFinding<'_>) -> String {
    let mut lines = Vec::new();
    match finding.outcome {
        Outcome::Cut => lines.push(
            "A note: more digits would make the numbers exact to the last bit of their type."
                .to_owned(),
        ),
        Outcome::Ulps => {
            lines.push(
                "A note: the numbers differ from the nearest ones in the last places only."
                    .to_owned(),
            );
        }
        Outcome::Otherwise => lines.push(
            "The numbers are consistent, but not those that the formula gives: the formula may be \
             meant differently, or a value may have been rounded too early."
                .to_owned(),
        ),
        _ => {}
    }
    lines.extend(
        facts::greatest_error(finding).map(|text| format!("The greatest error is {text}.")),
    );
    lines.extend(facts::tolerance(finding));
    lines.extend(facts::sums(finding));
    lines.extend(facts::equals(finding));
    lines.join("\n")
}

/// A value of the formula to many digits, and the command.
fn check(project: &Project, finding: &ShippedFinding<'_>) -> String {
    let claim = finding.claim;
    let place = finding.farthest.unwrap_or(0);
    let value = match &finding.cells[place].exact {
        Ok(exact) => decimal(exact, CHECK_DIGITS),
        Err(cap) => return format!("It was not computed: {cap}."),
    };
    let formula = match &claim.exact {
        ExactValues::Formula(_) => "the formula".to_owned(),
        ExactValues::Each(formulas) => formulas[place].text.clone(),
    };
    format!(
        "In decimal arithmetic of more digits than the type has, {formula} is {value}{}. `subcert explain \
         {}:{} {}` computes all of them with exact numbers.",
        after_at(claim, place),
        project.key,
        claim.id,
        project.source.name,
    )
}
