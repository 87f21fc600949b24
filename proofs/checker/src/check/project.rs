//! The check of the constants of a project.

use super::{Outcome, Report, is_id, refused};
use crate::claims::{misfit, tasks};
use crate::formulas::formulas;
use crate::shipped;
use crate::text::{About, Toml};
use std::collections::{BTreeMap, BTreeSet};

/// The fields of the file.
const FIELDS: &str = "project-file: key=text project=project define=%text shipped=*any
project: name=text repository=text commit=text licence=text note=text";

/// Checks certificates against the claim file of a project.
pub fn check(file: &Toml, certificates: &[&str]) -> Result<Report, String> {
    if let Some(path) = misfit(file, "project-file", FIELDS) {
        return Err(format!("`{path}` is unknown, or not of its type"));
    }
    let key = file.text("key").ok_or("`key` is missing")?;
    let definitions = formulas(file.entries("define")).map_err(|stop| stop.to_string())?;
    let tables = file.list("shipped").iter().map(|table| table.text("id").unwrap_or(""));
    let mut ids = BTreeSet::new();
    for id in tables.clone() {
        if !is_id(id) || !ids.insert(id) {
            return Err(format!("{id:?} cannot be an id, or two tables have it"));
        }
    }
    if !is_id(key) {
        return Err(format!("{key:?} cannot be a key"));
    }
    let (tasks, broken) = tasks(file, About::Project(key), &["shipped"], certificates);
    let (mut outcomes, mut verdicts) = (BTreeMap::new(), BTreeMap::new());
    for task in &tasks {
        let check = |block| shipped::check(task.claim, &definitions, block);
        let outcome = match task.once().and_then(check) {
            Ok(verdict) => {
                verdicts.insert(task.id.to_owned(), verdict);
                Outcome::Valid
            }
            Err(rejection) => refused(task, rejection),
        };
        outcomes.insert(task.id, outcome);
    }
    let mut outcome = |id| outcomes.remove(id).unwrap_or(Outcome::Incomplete(None));
    let claims = tables.map(|id| ("shipped", id.to_owned(), outcome(id))).collect();
    Ok(Report { key: key.to_owned(), claims, verdicts, broken })
}
