//! The checker of subcert's certificates: small, slow, and independent of the program that
//! writes them.
//!
//! It reads a claim file and certificates about it, recomputes by definition whatever they
//! state, and says of each claim whether the certificate proves its verdict. FORMAT.md in the
//! folder above specifies what certificates say and when they are valid.

mod certificate;
mod convolution;
mod cursor;
mod decimal;
mod displacement;
mod evaluate;
mod formula;
mod functional;
mod functions;
mod linear;
mod number;
mod paper;
mod polynomial;
mod reading;
mod reject;
mod ring;
mod root;
mod rounding;
mod rules;
mod scheme;
mod table;
mod toml;
mod value;
mod witness;

use paper::Paper;
pub use reject::{Reason, Rejection, Stop};
use rules::Verdict;
use scheme::{Library, catalogue};
use std::collections::{BTreeMap, BTreeSet};
use toml::Toml;

/// What is known of a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Its certificate is right.
    Valid,
    /// It is right, on the word of this statement of THEOREMS.md: that the statement proves
    /// what the claim says in words is not checked.
    Cited(String),
    /// The certificate of this place among those given is not: where, and why.
    Invalid(usize, Rejection),
    /// It has no certificate, or one that is beyond a cap of this program.
    Incomplete(Option<Rejection>),
}

/// The claims of a file, and what the certificates prove of them.
#[derive(Debug)]
pub struct Report {
    /// The key of the paper.
    pub key: String,
    /// Kind, id and outcome of every claim, in the order of the file.
    pub claims: Vec<(&'static str, String, Outcome)>,
    /// What is wrong with certificates as a whole: which one, where, and why.
    pub broken: Vec<(usize, Rejection)>,
}

/// Whether a text is a formula of a claim file.
#[must_use]
pub fn is_formula(text: &str) -> bool {
    formula::parse(text, formula::MAX_LENGTH).is_ok()
}

/// Checks certificates against the claim file that they are about.
///
/// # Errors
/// What is wrong with the claim file.
pub fn check(claims: &str, certificates: &[&str]) -> Result<Report, String> {
    let (file, known) = (Toml::read(claims)?, catalogue()?);
    let library = Library::new(file.list("scheme"), &known);
    let paper = Paper::new(&file, &library).map_err(|stop| stop.to_string())?;
    let key = file.text("key").ok_or("`key` is missing")?.to_owned();
    let mut outcomes: BTreeMap<(&str, &str), Outcome> = BTreeMap::new();
    let (mut holding, mut cited, mut broken) = (BTreeSet::new(), Vec::new(), Vec::new());
    for (place, text) in certificates.iter().enumerate() {
        let blocks = match certificate::blocks(text, &key) {
            Ok(blocks) => blocks,
            Err(rejection) => {
                broken.push((place, rejection));
                continue;
            }
        };
        for mut block in blocks {
            let (kind, id) = block.head.word();
            let claim = file.list(kind).iter().find(|claim| claim.text("id") == Some(id));
            let Some(claim) = claim.filter(|_| paper::KINDS.contains(&kind)) else {
                broken.push((place, block.head.reject(Reason::NoSuchClaim)));
                continue;
            };
            let checked = rules::check(&paper, kind, claim, &mut block);
            let outcome = match checked.map_err(|rejection| rejection.at(block.at)) {
                Ok(Verdict::Other) => Outcome::Valid,
                Ok(Verdict::Holds) => {
                    holding.insert(id);
                    Outcome::Valid
                }
                Ok(Verdict::Cited { statement, uses }) => {
                    cited.push((id, block.head, uses));
                    Outcome::Cited(statement)
                }
                Err(rejection) if rejection.given_up() => Outcome::Incomplete(Some(rejection)),
                Err(rejection) => Outcome::Invalid(place, rejection),
            };
            if outcomes.insert((kind, id), outcome).is_some() {
                let twice = block.head.reject(Reason::Twice);
                outcomes.insert((kind, id), Outcome::Invalid(place, twice));
            }
        }
    }
    for (id, head, uses) in cited {
        if let Some(other) = uses.into_iter().find(|other| !holding.contains(other)) {
            let rejection = head.reject(Reason::Premise(other.to_owned()));
            outcomes.insert(("theorem", id), Outcome::Incomplete(Some(rejection)));
        }
    }
    let claims = paper.claims().into_iter().map(|(kind, id)| {
        (kind, id.to_owned(), outcomes.remove(&(kind, id)).unwrap_or(Outcome::Incomplete(None)))
    });
    Ok(Report { key, claims: claims.collect(), broken })
}
