//! The findings of a paper.

use super::kinds::Finding;
use crate::bound::BetterOffset;
use crate::claim::{Claim, Kind, Paper, Target, with_kinds};
use crate::finding::consistency::Contradiction;
use crate::scheme::Instance;
use crate::verdict::Tally;
use std::collections::BTreeMap;

macro_rules! audit {
    ($($(#[$doc:meta])* $kind:ident $name:literal $field:ident $c:ident $finding:ident $claim:ident,)*) => {
        /// The verdicts of a paper's claims.
        #[derive(Clone, Debug)]
        pub struct PaperAudit<'a> {
            /// The paper.
            pub paper: &'a Paper,
            $(#[doc = concat!("The findings about its claims of the kind `", $name, "`.")]
            pub $field: Vec<super::$finding<'a>>,)*
            /// Where its tables need different readings or values of a parameter.
            pub contradictions: Vec<Contradiction>,
            /// The schemes of its tables whose offset the claim file does not state, where another one than 0 is better.
            pub unstated_offsets: Vec<UnstatedOffset>,
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

with_kinds!(audit);

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

/// A scheme whose offset the claim file does not state, with a better one than 0.
#[derive(Clone, Debug, PartialEq)]
pub struct UnstatedOffset {
    /// The scheme, with the parameters of the first cell whose scheme it is.
    pub scheme: Instance,
    /// The better offset of its mask.
    pub better: BetterOffset,
}
