//! A paper and its claims.

use super::contents::Item;
use super::kinds::{Claim, with_kinds};
use super::regularity::RegularityTable;
use super::table::Table;
use crate::diagnostic::SourceText;
use crate::formula::LocatedFormula;
use crate::scheme::{Reference, SchemeDefinition};
use std::collections::BTreeMap;
use std::sync::Arc;

macro_rules! paper {
    ($($(#[$doc:meta])* $kind:ident $name:literal $field:ident $claim:ident $f:ident $c:ident,)*) => {
        /// A paper's claim file, read. Claims of a kind are in the paper's order; those about smoothness are first of
        /// C^m, then of Hölder exponents, then of ranges of a parameter.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Paper {
            /// The short name that ids begin with, such as `khan2019-newton`.
            pub key: String,
            /// Who wrote what, where and when.
            pub bibliography: Bibliography,
            /// The numbered items of the paper, in the order of the claim file; empty when the claim file
            /// lists none.
            pub contents: Vec<Item>,
            /// The schemes that the claims refer to by name.
            pub schemes: BTreeMap<String, SchemeSource>,
            /// Named formulas: the paper's definitions.
            pub definitions: BTreeMap<String, LocatedFormula>,
            /// Other formulas for some definitions, by which a table may have been computed.
            pub alternatives: Vec<Alternative>,
            /// Values that the paper states for parameters.
            pub given: BTreeMap<String, LocatedFormula>,
            $(#[doc = concat!("Its claims of the kind `", $name, "`.")] pub $field: Vec<super::$claim>,)*
            /// The tables of orders and exponents, of which each cell is a claim about smoothness.
            pub regularity: Vec<Arc<RegularityTable>>,
            /// The claim file.
            pub source: Arc<SourceText>,
        }

        impl Paper {
            /// A paper without claims.
            pub(super) fn new(key: String, bibliography: Bibliography, source: &Arc<SourceText>) -> Paper {
                Paper {
                    key,
                    bibliography,
                    contents: Vec::new(),
                    schemes: BTreeMap::new(),
                    definitions: BTreeMap::new(),
                    alternatives: Vec::new(),
                    given: BTreeMap::new(),
                    $($field: Vec::new(),)*
                    regularity: Vec::new(),
                    source: Arc::clone(source),
                }
            }

            /// All claims, kind by kind.
            pub fn claims(&self) -> impl Iterator<Item = Claim<'_>> {
                let none = std::iter::empty();
                none$(.chain(self.$field.iter().map(Claim::$kind)))*
            }
        }
    };
}

with_kinds!(paper);

impl Paper {
    /// The claim of this id.
    #[must_use]
    pub fn claim(&self, id: &str) -> Option<Claim<'_>> {
        self.claims().find(|claim| claim.id() == id)
    }

    /// The definitions that a formula uses, at once or through other definitions.
    #[must_use]
    pub fn definitions_in(&self, formula: &LocatedFormula) -> BTreeMap<&str, &LocatedFormula> {
        let mut used = BTreeMap::new();
        let mut waiting = vec![formula];
        while let Some(formula) = waiting.pop() {
            for name in formula.expr.names() {
                if let Some((name, definition)) = self.definitions.get_key_value(name)
                    && used.insert(name.as_str(), definition).is_none()
                {
                    waiting.push(definition);
                }
            }
        }
        used
    }

    /// The schemes with a mask in the claim file, and without an offset, that a table or a `use` of the file names.
    pub(crate) fn without_offset<'p>(&'p self, table: &'p Table) -> impl Iterator<Item = &'p str> {
        let uses = self.schemes.values().filter_map(|source| match source {
            SchemeSource::Alias(reference) => Some(reference),
            SchemeSource::Own(_) => None,
        });
        let references = table.schemes().map(|one| &one.reference).chain(uses);
        references.flat_map(Reference::names).filter(|name| match self.schemes.get(*name) {
            Some(SchemeSource::Own(definition)) => definition.leaves_offset_out(),
            Some(SchemeSource::Alias(_)) | None => false,
        })
    }
}

/// Another formula for a definition.
#[derive(Clone, Debug, PartialEq)]
pub struct Alternative {
    /// The definition's name.
    pub of: String,
    /// How it differs from what is printed, in a few words.
    pub label: String,
    /// The formula.
    pub value: LocatedFormula,
}

/// Who wrote what, where and when.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bibliography {
    /// The authors, family names first or last as printed; none where the file names none.
    pub authors: Vec<String>,
    /// The title.
    pub title: String,
    /// The journal, volume and pages; empty where the file says nothing.
    pub venue: String,
    /// The year.
    pub year: String,
    /// The DOI, when there is one.
    pub doi: Option<String>,
    /// A note for the reader about the text from which the claims are taken.
    pub note: Option<String>,
}

impl Bibliography {
    /// The authors' family names and the year: `Khan, Omar, Mustafa 2019`. Without authors, title and year. A family
    /// name is the last word, with the words of small letters before it: `de Boor`.
    #[must_use]
    pub fn short(&self) -> String {
        let family = |author: &String| {
            let words: Vec<&str> = author.split(' ').collect();
            let small = |word: &&&str| word.starts_with(char::is_lowercase);
            let before = words.iter().rev().skip(1).take_while(small).count();
            words[words.len().saturating_sub(1 + before)..].join(" ")
        };
        if self.authors.is_empty() {
            return format!("{} ({})", self.title, self.year);
        }
        let names: Vec<String> = self.authors.iter().map(family).collect();
        format!("{} {}", names.join(", "), self.year)
    }

    /// Title and venue as sentences: `Curves by corner cutting. Journal of Examples 1.`
    #[must_use]
    pub fn title_and_venue(&self) -> String {
        if self.venue.is_empty() {
            return format!("{}.", self.title);
        }
        format!("{}. {}.", self.title, self.venue)
    }

    /// Authors, venue and year as sentences: `Richard Roe. Journal of Examples 1, 2026.`
    #[must_use]
    pub fn imprint(&self) -> String {
        let authors = self.authors.join(", ");
        let parts = [self.venue.as_str(), self.year.as_str()];
        let place = parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<&str>>();
        let parts = [authors, place.join(", ")];
        let parts = parts.into_iter().filter(|part| !part.is_empty());
        parts.map(|part| format!("{part}.")).collect::<Vec<String>>().join(" ")
    }
}

/// What a scheme name of a claim file stands for.
#[derive(Clone, Debug, PartialEq)]
pub enum SchemeSource {
    /// A mask written in the claim file.
    Own(Box<SchemeDefinition>),
    /// Another scheme with parameters: `use = "newton:j=1,n=3"`.
    Alias(Reference),
}
