//! The checker of subcert's certificates: small, slow, and independent of the program that
//! writes them.
//!
//! It reads a claim file and certificates about it, recomputes by definition whatever they
//! state, and says of each claim whether the certificate proves its verdict. FORMAT.md in the
//! folder above specifies what certificates say and when they are valid.
//!
//! No files import each other in a circle.

mod claims;
mod data;
mod enclosures;
mod formulas;
mod functions;
mod numbers;
mod schemes;
mod text;
mod vertex;

// Certificates of joint spectral radii, and of depths of control data.
mod radius;
mod reals;
mod sets;

// Functions of an integer, for all integers from one on.
mod integers;

mod kinds;
mod lines;

// Constants that programs ship, and theorems of Coq.
mod kernel;
mod shipped;

mod check;

pub use check::{Outcome, Report};
use claims::Paper;
pub use kernel::Agreement;
use kinds::regularity::expanded;
use numbers::Meter;
pub use radius::{Radius, check_radius};
use schemes::{Library, catalogue};
pub use sets::{Depth, check_depth};
use std::collections::BTreeSet;
use std::panic::resume_unwind;
use std::thread::Builder;
use text::{At, Toml, require};
pub use text::{
    DepthReason, DepthRejection, RadiusReason, RadiusRejection, Reason, Rejection, Stop, Text,
};

/// Whether a text is a formula of a claim file.
#[must_use]
pub fn is_formula(text: &str) -> bool {
    formulas::parse(text, formulas::MAX_LENGTH).is_ok()
}

/// Checks certificates against their claim file, on all cores.
///
/// # Errors
/// The claim file is wrong; the message says why.
pub fn check(claims: &str, certificates: &[&str]) -> Result<Report, String> {
    let file = expanded(Toml::read(claims)?)?;
    if file.get("project").is_some() {
        return check::project::check(&file, certificates);
    }
    check::paper::check(&file, certificates).map(|(report, _)| report)
}

/// Compares files of theorems of Coq with their claim file: masks, numbers, levels and places
/// (proofs/format/coq.md). Certificates recover the values of parameters that the paper does not
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
    let (known, key) = (catalogue()?, check::paper::key(&file)?);
    let (_, recovered) = check::paper::check(&file, certificates)?;
    let compare = || {
        let meter = Meter::default();
        let library = Library::new(file.list("scheme"), &known, &meter);
        let paper = Paper::new(&file, &library).map_err(|stop| stop.to_string())?;
        let mut known = BTreeSet::new();
        let of_file = |text: &&str| {
            let agreement = kernel::agree(&paper, key, &recovered, text)?;
            let first = known.insert((agreement.kind.clone(), agreement.id.clone()));
            require(first, Reason::OtherFile).at(1)?;
            Ok(agreement)
        };
        Ok(files.iter().map(of_file).collect())
    };
    std::thread::scope(|scope| {
        let worker = Builder::new().stack_size(check::paper::STACK).spawn_scoped(scope, compare);
        match worker {
            Ok(worker) => worker.join().unwrap_or_else(|panic| resume_unwind(panic)),
            // Where there are no threads, this one does it.
            Err(_) => compare(),
        }
    })
}
