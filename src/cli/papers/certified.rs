//! Which claims have a valid certificate, by the word of the checker alone.

use crate::cli::console::output::Failure;
use std::collections::BTreeMap;
use subcert::audit::PaperAudit;
use subcert::certificate::{Certificate, certificate};
use subcert::claim::Target;
use subcert::diagnostic::SourceText;
use subcert::report::json::{self, AuditReport};
use subcert::report::{Grid, Sheet};
use subcert_check::{Outcome, check};

/// The results of the checker for the claims of papers, by `key:claim`.
pub(crate) struct Certified {
    papers: Vec<Checked>,
}

/// The results of the checker for one claim file.
pub(super) struct Checked {
    pub(super) key: String,
    /// The claims in the order of the claim file, with the reason when the certificate
    /// is not valid.
    pub(super) claims: Vec<(String, State)>,
}

#[derive(Clone, PartialEq, Eq)]
pub(super) enum State {
    Certified,
    /// Valid if this statement is believed.
    Cited(String),
    Rejected(String),
    Incomplete(String),
}

impl Certified {
    /// Writes certificates of the audits, and has them checked.
    pub(crate) fn of(audits: &[PaperAudit<'_>]) -> Result<Certified, Failure> {
        let papers = audits
            .iter()
            .map(|audit| Checked::of(&audit.paper.source, certificate(audit)))
            .collect::<Result<_, Failure>>()?;
        Ok(Certified { papers })
    }

    /// The section of the report.
    pub(crate) fn section(&self, sheet: &mut Sheet) {
        sheet.heading(1, "Certificates");
        sheet.text(
            "A claim is certified when subcert-check, which shares no code with this program, has \
             found its certificate valid.",
        );
        let header = ["paper", "claims", "certified", "cited", "rejected", "incomplete"];
        let rows = self.papers.iter().map(|paper| {
            let count = |is: &dyn Fn(&State) -> bool| {
                paper.claims.iter().filter(|(_, state)| is(state)).count().to_string()
            };
            vec![
                paper.key.clone(),
                paper.claims.len().to_string(),
                count(&|state| *state == State::Certified),
                count(&|state| matches!(state, State::Cited(_))),
                count(&|state| matches!(state, State::Rejected(_))),
                count(&|state| matches!(state, State::Incomplete(_))),
            ]
        });
        sheet.grid(Grid::of(header, rows, 1));
        for paper in &self.papers {
            let mut states: BTreeMap<String, Vec<&str>> = BTreeMap::new();
            for (id, state) in &paper.claims {
                states.entry(state.words()).or_default().push(id);
            }
            let fact = |(why, ids): (String, Vec<&str>)| {
                (paper.key.clone(), format!("{why}: {}", ids.join(", ")))
            };
            if !states.is_empty() {
                sheet.facts(states.into_iter().map(fact).collect());
            }
        }
    }

    /// Adds to each claim of a report whether it is certified.
    pub(crate) fn mark(&self, report: &mut AuditReport<'_>) {
        for (paper, checked) in report.papers.iter_mut().zip(&self.papers) {
            let states: BTreeMap<&str, &State> =
                checked.claims.iter().map(|(id, state)| (id.as_str(), state)).collect();
            for claim in &mut paper.claims {
                let state = states.get(Target::of(claim.id).claim).copied();
                claim.certificate = Some(form(state));
            }
        }
    }

    /// What is known of the certificate of a claim.
    pub(crate) fn of_claim(&self, audit: &PaperAudit<'_>, id: &str) -> json::Certificate {
        form(self.states(audit).find(|(own, _)| own == id).map(|(_, state)| state))
    }

    /// The same of all claims of a paper, by their ids.
    pub(crate) fn of_paper(&self, audit: &PaperAudit<'_>) -> BTreeMap<String, json::Certificate> {
        self.states(audit).map(|(id, state)| (id.clone(), form(Some(state)))).collect()
    }

    fn states(&self, audit: &PaperAudit<'_>) -> impl Iterator<Item = &(String, State)> {
        let paper = self.papers.iter().find(|paper| paper.key == audit.paper.key);
        paper.into_iter().flat_map(|paper| &paper.claims)
    }
}

fn form(state: Option<&State>) -> json::Certificate {
    json::Certificate {
        certified: state == Some(&State::Certified),
        certificate: match state {
            Some(State::Certified) => "valid".to_owned(),
            Some(State::Cited(statement)) => format!("cited: {statement}"),
            Some(State::Rejected(why)) => format!("invalid: {why}"),
            Some(State::Incomplete(why)) => format!("incomplete: {why}"),
            None => "incomplete: no certificate".to_owned(),
        },
    }
}

impl Checked {
    /// What the checker says of a claim file with this certificate.
    pub(super) fn of(source: &SourceText, written: Certificate) -> Result<Checked, Failure> {
        let report = check(&source.text, &[&written.text]).map_err(|why| {
            let name = &source.name;
            Failure::Input(format!("subcert-check cannot read the claim file `{name}`: {why}"))
        })?;
        let mut omitted: BTreeMap<String, String> =
            written.omitted.into_iter().map(|omission| (omission.id, omission.why)).collect();
        let broken = report.broken.first().map(|(_, rejection)| rejection.reason.to_string());
        let key = report.key;
        let claims = report.claims.into_iter().map(|(_, id, outcome)| {
            let state = match (&broken, outcome) {
                (Some(why), _) => State::Rejected(format!("the certificate is broken: {why}")),
                (None, Outcome::Valid) => State::Certified,
                (None, Outcome::Cited(statement)) => State::Cited(statement),
                (None, Outcome::Invalid(_, rejection)) => {
                    State::Rejected(rejection.reason.to_string())
                }
                (None, Outcome::Incomplete(Some(rejection))) => {
                    State::Incomplete(rejection.reason.to_string())
                }
                (None, Outcome::Incomplete(None)) => {
                    let why = omitted.remove(&format!("{key}:{id}"));
                    State::Incomplete(why.unwrap_or_else(|| "no certificate".to_owned()))
                }
            };
            (id, state)
        });
        let claims = claims.collect();
        Ok(Checked { key, claims })
    }
}

impl State {
    /// It in words.
    pub(super) fn words(&self) -> String {
        match self {
            State::Certified => "certified".to_owned(),
            State::Cited(statement) => format!("on the word of {statement}"),
            State::Rejected(why) => format!("rejected, {why}"),
            State::Incomplete(why) => format!("incomplete, {why}"),
        }
    }
}
