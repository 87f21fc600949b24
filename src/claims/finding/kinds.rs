//! Findings of any kind.

use super::judgement::{Harm, Judgement};
use crate::cap::Cap;
use crate::claim::{Claim, with_kinds};
use crate::verdict::{Tally, Word};

macro_rules! findings {
    ($($(#[$doc:meta])* $kind:ident $name:literal $field:ident $c:ident $finding:ident $claim:ident,)*) => {
        /// A finding of any kind.
        #[derive(Clone, Copy, Debug)]
        pub enum Finding<'f, 'a> { $($(#[$doc])* $kind(&'f super::$finding<'a>),)* }

        impl<'f, 'a> Finding<'f, 'a> {
            /// The claim.
            #[must_use]
            pub fn claim(self) -> Claim<'a> {
                match self { $(Finding::$kind(finding) => Claim::$kind(finding.$claim),)* }
            }

            fn judgement(self) -> Judgement<'f> {
                match self { $(Finding::$kind(finding) => finding.judgement(),)* }
            }
        }
    };
}

with_kinds!(findings);

impl<'f> Finding<'f, '_> {
    /// The word for its verdict; a table has one for each cell.
    #[must_use]
    pub fn word(self) -> Option<Word> {
        self.judgement().word
    }

    /// Its verdict; of a table, the verdicts of its cells.
    #[must_use]
    pub fn verdicts(self) -> Tally {
        match self {
            Finding::Table(finding) => finding.claiming().map(|cell| cell.verdict.word()).collect(),
            other => other.word().into_iter().collect(),
        }
    }

    /// The cap that a value of it is beyond; tables and theorems name caps cell by cell and case by case.
    #[must_use]
    pub fn cap(self) -> Option<&'f Cap> {
        self.judgement().cap
    }

    /// What may happen to those who rely on the claim, if it is wrong.
    #[must_use]
    pub fn harm(self) -> Harm {
        self.judgement().harm
    }
}
