//! Findings of any kind.

use super::{
    EquationFinding, EquationVerdict, FunctionFinding, FunctionVerdict, KnownLimits, PaperAudit,
    RangeFinding, SmoothnessFinding, TableFinding, TheoremFinding,
};
use crate::cap::Cap;
use crate::claim::{Claim, Kind, Paper, Target, with_kinds};
use crate::verdict::{Tally, Word};
use std::collections::BTreeMap;

macro_rules! findings {
    ($($(#[$doc:meta])* $kind:ident $name:literal $field:ident $c:ident $finding:ident $claim:ident,)*) => {
        /// A finding of any kind.
        #[derive(Clone, Copy, Debug)]
        pub enum Finding<'f, 'a> { $($(#[$doc])* $kind(&'f $finding<'a>),)* }

        impl<'a> Finding<'_, 'a> {
            /// The claim.
            #[must_use]
            pub fn claim(self) -> Claim<'a> {
                match self { $(Finding::$kind(finding) => Claim::$kind(finding.$claim),)* }
            }
        }

        impl<'a> PaperAudit<'a> {
            /// An audit without findings.
            pub(crate) fn new(paper: &'a Paper) -> PaperAudit<'a> {
                let (contradictions, unstated_offsets) = (Vec::new(), Vec::new());
                PaperAudit { paper, $($field: Vec::new(),)* contradictions, unstated_offsets }
            }

            /// All findings, kind by kind.
            pub fn findings(&self) -> impl Iterator<Item = Finding<'_, 'a>> {
                let none = std::iter::empty();
                none$(.chain(self.$field.iter().map(Finding::$kind)))*
            }

            /// Adds the findings of another audit of the paper.
            pub(crate) fn append(&mut self, mut other: PaperAudit<'a>) {
                $(self.$field.append(&mut other.$field);)*
            }

            /// Brings the findings of each kind into the order of the paper.
            pub(crate) fn sort(&mut self) {
                let ids = self.paper.claims().map(Claim::id);
                let places: BTreeMap<&str, usize> = ids.zip(0..).collect();
                $(self.$field.sort_by_key(|finding| places.get(&finding.$claim.id[..]));)*
            }
        }
    };
}

with_kinds!(findings);

impl Finding<'_, '_> {
    /// The word for its verdict; a table has one for each cell.
    #[must_use]
    pub fn word(self) -> Option<Word> {
        match self {
            Finding::Table(_) => None,
            Finding::Equation(finding) => Some(finding.verdict.word()),
            Finding::Function(finding) => Some(finding.verdict.word()),
            Finding::Range(finding) => Some(finding.verdict()),
            Finding::Smoothness(finding) => Some(finding.verdict.word()),
            Finding::Theorem(finding) => Some(finding.verdict.word()),
        }
    }

    /// Its verdict; of a table, the verdicts of its cells.
    #[must_use]
    pub fn verdicts(self) -> Tally {
        match self {
            Finding::Table(finding) => {
                finding.cells.iter().flatten().map(|cell| cell.verdict.word()).collect()
            }
            other => other.word().into_iter().collect(),
        }
    }

    /// The cap that a value of it is beyond; tables and theorems name caps cell by cell and case by case.
    #[must_use]
    pub fn cap(&self) -> Option<&Cap> {
        match self {
            Finding::Equation(finding) => match &finding.verdict {
                EquationVerdict::BeyondCap(cap) => Some(cap),
                _ => None,
            },
            Finding::Function(finding) => match &finding.verdict {
                FunctionVerdict::BeyondCap(cap) => Some(cap),
                _ => None,
            },
            Finding::Range(finding) => finding.found.as_ref().err(),
            Finding::Smoothness(finding) => match &finding.known {
                KnownLimits::BeyondCap(cap) => Some(cap),
                _ => None,
            },
            Finding::Table(_) | Finding::Theorem(_) => None,
        }
    }
}

impl<'a> PaperAudit<'a> {
    /// The finding about the claim that a text names, or of which it names a cell.
    #[must_use]
    pub fn find(&self, target: Target<'_>) -> Option<Finding<'_, 'a>> {
        let own = self.paper.key == target.key;
        self.findings().find(|finding| own && finding.claim().id() == target.claim)
    }

    /// The verdicts of the claims of these kinds.
    #[must_use]
    pub fn tally(&self, kinds: &[Kind]) -> Tally {
        let mut tally = Tally::default();
        let findings = self.findings().filter(|finding| kinds.contains(&finding.claim().kind()));
        findings.for_each(|finding| tally += &finding.verdicts());
        tally
    }
}
