//! The checker of subcert's certificates: small, slow, and independent of the program that
//! writes them.
//!
//! It reads a claim file and certificates about it, recomputes by definition whatever they
//! state, and says of each claim whether the certificate proves its verdict. FORMAT.md in the
//! folder above specifies what certificates say and when they are valid.
//!
//! The folders are listed from below, and no files import each other in a circle.

mod claims;
mod data;
mod formulas;
mod functions;
mod numbers;
mod schemes;
mod text;
mod vertex;

// Certificates of joint spectral radii, and of depths of control data.
mod radius;
mod sets;

mod kinds;
mod lines;

// Constants that programs ship, and theorems of Coq.
mod kernel;
mod shipped;

use claims::paper::Paper;
use claims::tasks::{Task, tasks};
use formulas::definitions::formulas;
pub use kernel::Agreement;
use kinds::Verdict;
use kinds::regularity::expanded;
use kinds::table::recovered::{Given, Recovered};
use numbers::meter::Meter;
pub use radius::{Radius, check_radius};
use schemes::catalogue::catalogue;
use schemes::library::Library;
pub use sets::{Depth, check_depth};
use std::collections::{BTreeMap, BTreeSet};
use std::num::NonZero;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{Builder, available_parallelism};
use text::certificate::About;
use text::reject::{At, Checked};
pub use text::reject::{
    DepthReason, DepthRejection, RadiusReason, RadiusRejection, Reason, Rejection, Stop, Text,
};
use text::toml::Toml;

/// The bytes of a stack. The deepest formula needs fewer.
const STACK: usize = 64 << 20;

/// The outcome of the check of a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The certificate is right.
    Valid,
    /// The certificate is right and cites this statement of THEOREMS.md. The checker does not
    /// check that the statement proves what the claim says.
    Cited(String),
    /// The certificate with this index is wrong, for this reason.
    Invalid(usize, Rejection),
    /// The claim has no certificate, or the certificate leaves it open for this reason.
    Incomplete(Option<Rejection>),
}

/// The claims of a file and the outcomes of their checks.
#[derive(Debug)]
pub struct Report {
    /// The key of the paper or project.
    pub key: String,
    /// The kind, id and outcome of every claim, in the order of the file.
    pub claims: Vec<(&'static str, String, Outcome)>,
    /// The verdict of each valid or cited certificate, by the id of its claim, in a few words such
    /// as `refuted: 15/16 > 125/144`.
    pub verdicts: BTreeMap<String, String>,
    /// The rejections of whole certificates, with the indices of the certificates.
    pub broken: Vec<(usize, Rejection)>,
}

/// Whether a text is a formula of a claim file.
#[must_use]
pub fn is_formula(text: &str) -> bool {
    formulas::formula::parse(text, formulas::formula::MAX_LENGTH).is_ok()
}

/// Checks certificates against their claim file, on all cores.
///
/// # Errors
/// The claim file is wrong; the message says why.
pub fn check(claims: &str, certificates: &[&str]) -> Result<Report, String> {
    let file = expanded(Toml::read(claims)?)?;
    if file.get("project").is_some() {
        return check_project(&file, certificates);
    }
    check_paper(&file, certificates).map(|(report, _)| report)
}

/// Checks certificates against the claim file of a paper. Gives the values of parameters too that valid ones recover.
fn check_paper(file: &Toml, certificates: &[&str]) -> Result<(Report, Vec<kernel::Given>), String> {
    let (known, key) = (catalogue()?, of_paper(file)?.to_owned());
    let meter = Meter::default();
    let library = Library::new(file.list("scheme"), &known, &meter);
    let paper = Paper::new(file, &library).map_err(|stop| stop.to_string())?;
    let mut ids = BTreeSet::new();
    let tables = file.list("regularity").iter().map(|table| table.text("id").unwrap_or(""));
    for id in paper.claims().into_iter().map(|(_, id)| id).chain(tables).chain([&key[..]]) {
        if !is_id(id) {
            return Err(format!("{id:?} cannot be an id"));
        }
        if id != key && !ids.insert(id) {
            return Err(format!("two claims are called `{id}`"));
        }
    }
    let (tasks, broken) = tasks(file, About::Paper(&key), &claims::shape::KINDS, certificates);
    let mut outcomes: BTreeMap<(&str, &str), Outcome> = BTreeMap::new();
    let (mut holding, mut cited) = (BTreeSet::new(), Vec::new());
    let mut given: Vec<(&str, Given)> = Vec::new();
    let mut borrowed: Vec<(&Task<'_>, (Given, String))> = Vec::new();
    let mut verdicts_said = BTreeMap::new();
    for (task, verdict) in tasks.iter().zip(verdicts(file, &known, &tasks)) {
        let outcome = match verdict {
            Ok(Verdict::Other) => Outcome::Valid,
            Ok(Verdict::Recovers(Recovered { own, from })) => {
                given.extend(own.into_iter().map(|given| (task.id, given)));
                borrowed.extend(from.into_iter().map(|from| (task, from)));
                Outcome::Valid
            }
            Ok(Verdict::Holds) => {
                holding.insert(task.id);
                Outcome::Valid
            }
            Ok(Verdict::Cited(citation)) => {
                cited.push((task.id, task.block.head, citation.uses));
                Outcome::Cited(citation.statement)
            }
            Err(rejection) => refused(task, rejection),
        };
        if matches!(outcome, Outcome::Valid | Outcome::Cited(_)) {
            verdicts_said.insert(task.id.to_owned(), claims::said::verdict(task.kind, &task.block));
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
    let claims = paper.claims().into_iter().map(|(kind, id)| {
        (kind, id.to_owned(), outcomes.remove(&(kind, id)).unwrap_or(Outcome::Incomplete(None)))
    });
    let claims = claims.collect();
    Ok((Report { key, claims, verdicts: verdicts_said, broken }, recovered))
}

/// Checks the fields and names of a claim file, and gives its key.
fn of_paper(file: &Toml) -> Result<&str, String> {
    if let Some(path) = claims::shape::misfit(file, "file") {
        return Err(format!("`{path}` is unknown, or not of its type"));
    }
    claims::names::misuse(file)?;
    file.text("key").ok_or("`key` is missing".to_owned())
}

/// Compares files of theorems of Coq with their claim file: masks, numbers, levels and places
/// (FORMAT.md, Theorems of Coq). Certificates recover the values of parameters that the paper does not
/// state; they are checked. Of several files about one claim, the first one that agrees counts. Whether the theorems are true, Coq checks.
///
/// # Errors
/// The claim file is wrong, or is about a project; the message says why.
///
/// # Panics
/// When the machine has no thread left.
pub fn check_theorems(
    claims: &str,
    certificates: &[&str],
    files: &[&str],
) -> Result<Vec<Result<Agreement, Rejection>>, String> {
    let file = expanded(Toml::read(claims)?)?;
    if file.get("project").is_some() {
        return Err("there are no theorems about the constants of a project".to_owned());
    }
    let (known, key) = (catalogue()?, of_paper(&file)?);
    let (_, recovered) = check_paper(&file, certificates)?;
    let compare = || {
        let meter = Meter::default();
        let library = Library::new(file.list("scheme"), &known, &meter);
        let paper = Paper::new(&file, &library).map_err(|stop| stop.to_string())?;
        let mut known = BTreeSet::new();
        let of_file = |text: &&str| {
            let agreement = kernel::agree(&paper, key, &recovered, text)?;
            let first = known.insert((agreement.kind.clone(), agreement.id.clone()));
            text::reject::require(first, Reason::OtherFile).at(1)?;
            Ok(agreement)
        };
        Ok(files.iter().map(of_file).collect())
    };
    std::thread::scope(|scope| {
        let worker = Builder::new().stack_size(STACK).spawn_scoped(scope, compare);
        worker.expect("a thread").join().unwrap_or_else(|panic| resume_unwind(panic))
    })
}

/// Checks certificates against the claim file of a project.
fn check_project(file: &Toml, certificates: &[&str]) -> Result<Report, String> {
    if let Some(path) = claims::shape::misfit(file, "project-file") {
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

/// Whether a text can be the id of a claim or the key of a file. It has to fit in one line.
fn is_id(text: &str) -> bool {
    let fits = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
    !text.is_empty() && text.chars().all(fits)
}

/// The outcome of a claim whose certificate is refused.
fn refused(task: &Task<'_>, rejection: Rejection) -> Outcome {
    if rejection.given_up() {
        Outcome::Incomplete(Some(rejection))
    } else {
        Outcome::Invalid(task.place, rejection)
    }
}

/// Checks every task on its own, on all cores.
fn verdicts(file: &Toml, known: &[Toml], tasks: &[Task<'_>]) -> Vec<Checked<Verdict>> {
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
        let mut checked = Vec::new();
        for worker in workers {
            checked.extend(worker.join().unwrap_or_else(|panic| resume_unwind(panic)));
        }
        checked
    });
    checked.sort_by_key(|(at, _)| *at);
    checked.into_iter().map(|(_, verdict)| verdict).collect()
}
