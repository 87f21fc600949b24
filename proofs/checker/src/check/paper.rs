//! The check of the claims of a paper.

use super::{Outcome, Report, is_id, refused};
use crate::claims::{Paper, Task, misfit, misuse, said, tasks};
use crate::kernel;
use crate::kinds::kind::Proof;
use crate::kinds::table::recovered::{Given, Recovered};
use crate::kinds::{self, KINDS};
use crate::numbers::Meter;
use crate::schemes::{Library, catalogue};
use crate::text::{About, Checked, Reason, Text, Toml};
use std::collections::{BTreeMap, BTreeSet};
use std::num::NonZero;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{Builder, available_parallelism};

/// The bytes of a stack. The deepest formula needs fewer.
pub const STACK: usize = 64 << 20;

/// Checks certificates against the claim file of a paper. Gives the values of parameters too that valid ones recover.
pub fn check(file: &Toml, certificates: &[&str]) -> Result<(Report, Vec<kernel::Given>), String> {
    let (known, key) = (catalogue()?, key(file)?.to_owned());
    let meter = Meter::default();
    let library = Library::new(file.list("scheme"), &known, &meter);
    Paper::new(file, &library).map_err(|stop| stop.to_string())?;
    let mut ids = BTreeSet::new();
    let tables = file.list("regularity").iter().map(|table| table.text("id").unwrap_or(""));
    let claims = kinds::claims(file);
    let claims: Vec<_> =
        claims.map(|(kind, claim)| (kind.name, claim.text("id").unwrap_or(""))).collect();
    for id in claims.iter().map(|(_, id)| *id).chain(tables).chain([&key[..]]) {
        if !is_id(id) {
            return Err(format!("{id:?} cannot be an id"));
        }
        if id != key && !ids.insert(id) {
            return Err(format!("two claims are called `{id}`"));
        }
    }
    let (tasks, broken) =
        tasks(file, About::Paper(&key), &KINDS.each_ref().map(|kind| kind.name), certificates);
    let mut outcomes: BTreeMap<(&str, &str), Outcome> = BTreeMap::new();
    let (mut holding, mut cited) = (BTreeSet::new(), Vec::new());
    let mut given: Vec<(&str, Given)> = Vec::new();
    let mut borrowed: Vec<(&Task<'_>, (Given, String))> = Vec::new();
    let mut verdicts = BTreeMap::new();
    for (task, proof) in tasks.iter().zip(proofs(file, &known, &tasks)) {
        let outcome = match proof {
            Ok(Proof::Other) => {
                holding.extend(Some(task.id).filter(|_| task.block.holds()));
                Outcome::Valid
            }
            Ok(Proof::Recovers(Recovered { own, from })) => {
                given.extend(own.into_iter().map(|given| (task.id, given)));
                borrowed.extend(from.into_iter().map(|from| (task, from)));
                Outcome::Valid
            }
            Ok(Proof::Cited(citation)) => {
                cited.push((task.id, task.block.head, citation.uses));
                Outcome::Cited(citation.statement)
            }
            Err(rejection) => refused(task, rejection),
        };
        if matches!(outcome, Outcome::Valid | Outcome::Cited(_)) {
            verdicts.insert(task.id.to_owned(), said(task.kind, &task.block));
        }
        outcomes.insert((task.kind, task.id), outcome);
    }
    // The value has to be given by another table that is valid, from that table's own numbers.
    let lacks = |given: &[(&str, Given)], (value, other): &(Given, String)| {
        !given.iter().any(|(id, known)| id == other && known == value)
    };
    while let Some(place) = borrowed.iter().position(|(_, from)| lacks(&given, from)) {
        let (task, ((name, value), table)) = borrowed.swap_remove(place);
        let reason = Reason::NotGiven(name, Text(value.to_string()), table);
        let rejection = task.block.head.reject(reason);
        outcomes.insert((task.kind, task.id), Outcome::Invalid(task.place, rejection));
        given.retain(|(id, _)| *id != task.id);
    }
    let from = borrowed.into_iter().map(|(task, (given, _))| (task.id, given));
    let valid = |id| outcomes.get(&("table", id)) == Some(&Outcome::Valid);
    let recovered = given.into_iter().chain(from).filter(|(id, _)| valid(id));
    let recovered =
        recovered.map(|(id, (name, value))| kernel::Given { table: id.to_owned(), name, value });
    let recovered = recovered.collect();
    for (id, head, uses) in cited {
        if let Some(other) = uses.into_iter().find(|other| !holding.contains(&other[..])) {
            let rejection = head.reject(Reason::Premise(other));
            outcomes.insert(("theorem", id), Outcome::Incomplete(Some(rejection)));
        }
    }
    let claims = claims.into_iter().map(|(kind, id)| {
        (kind, id.to_owned(), outcomes.remove(&(kind, id)).unwrap_or(Outcome::Incomplete(None)))
    });
    let claims = claims.collect();
    Ok((Report { key, claims, verdicts, broken }, recovered))
}

/// Checks the fields and names of a claim file, and gives its key.
pub fn key(file: &Toml) -> Result<&str, String> {
    let kinds = KINDS.each_ref().map(|kind| format!(" {}=*any", kind.name));
    if let Some(path) = misfit(file, "file", &format!("claims:{}", kinds.concat())) {
        return Err(format!("`{path}` is unknown, or not of its type"));
    }
    misuse(file, kinds::claims(file).map(|(kind, claim)| (kind.names)(claim)))?;
    file.text("key").ok_or("`key` is missing".to_owned())
}

/// Checks every task on its own, on all cores.
fn proofs(file: &Toml, known: &[Toml], tasks: &[Task<'_>]) -> Vec<Checked<Proof>> {
    let next = AtomicUsize::new(0);
    let worker = || {
        let meter = Meter::default();
        let library = Library::new(file.list("scheme"), known, &meter);
        let Ok(paper) = Paper::new(file, &library) else { return Vec::new() };
        let mut checked = Vec::new();
        while let at = next.fetch_add(1, Ordering::Relaxed)
            && let Some(task) = tasks.get(at)
        {
            let check = |block| kinds::check(&paper, task.kind, task.claim, block);
            checked.push((at, task.once().and_then(check)));
        }
        checked
    };
    let cores = available_parallelism().map_or(1, NonZero::get);
    let mut checked = std::thread::scope(|scope| {
        let spawn = |_| Builder::new().stack_size(STACK).spawn_scoped(scope, worker).ok();
        let workers: Vec<_> = (0..cores).filter_map(spawn).collect();
        // Where there are no threads, this one does all.
        let mut checked = if workers.is_empty() { worker() } else { Vec::new() };
        for worker in workers {
            checked.extend(worker.join().unwrap_or_else(|panic| resume_unwind(panic)));
        }
        checked
    });
    checked.sort_by_key(|(at, _)| *at);
    checked.into_iter().map(|(_, proof)| proof).collect()
}
