//! What a kind of claim is to the reader of claim files.

use super::reader::Reader;
use crate::claim::{LocatedReference, Paper};
use crate::diagnostic::Diagnostic;
use crate::formula::{Expr, LocatedFormula};
use crate::scheme::Spanned;
use std::fmt;
use std::ops::Range;

/// A table of a claim file that states a claim.
pub(super) trait ClaimTable {
    /// The names that it gives a meaning.
    fn names(&self) -> Vec<(&str, Named)>;

    /// Whether the values of `[given]` have a meaning in it.
    fn takes_given(&self) -> bool {
        true
    }

    /// Adds the claim to its paper.
    fn read(&self, reader: &Reader<'_>, paper: &mut Paper) -> Result<(), Diagnostic>;
}

/// A formula, and its byte range in the file.
pub(super) type Placed<'p> = (&'p Expr, Range<usize>);

/// A claim with formulas.
pub(super) trait Formulas {
    /// All of them, also those of its schemes.
    fn formulas(&self) -> Vec<Placed<'_>>;
}

pub(super) fn placed(formula: &LocatedFormula) -> Placed<'_> {
    (&formula.expr, formula.span.clone())
}

pub(super) fn of_reference(located: &LocatedReference) -> impl Iterator<Item = Placed<'_>> {
    located.reference.formulas().map(|expr| (expr, located.span.clone()))
}

/// The role of a name in a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// A key of `[define]`.
    Definition,
    /// A key of `[given]`.
    Stated,
    /// A key of the claim's own `given`.
    Given,
    /// A key of the table's `unstated`.
    Unstated,
    /// The name of `rows`, or of `columns`, where the headers are numbers.
    Header,
    /// One of an equation's `symbols`.
    Symbol,
    /// The name of one of an equation's `indices`.
    Index,
    /// The `variable` of a function or a range.
    Variable,
    /// A key of a theorem's `values`.
    Open,
    /// One of [`THEOREM_NAMES`], in a theorem with a bound or a depth.
    OfTheorem,
}

impl fmt::Display for Role {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Role::Definition => "a definition",
            Role::Stated => "a value that the paper states",
            Role::Given => "a value that the claim states",
            Role::Unstated => "a parameter that is not stated",
            Role::Header => "the parameter of the headers",
            Role::Symbol => "a symbol",
            Role::Index => "an index of the equation",
            Role::Variable => "the free parameter",
            Role::Open => "a parameter of the theorem",
            Role::OfTheorem => "the spread, the level or the tolerance of this theorem",
        })
    }
}

/// The role of a name, and the place in the file that gives it this role.
#[derive(Clone, Debug)]
pub(super) struct Named {
    pub(super) role: Role,
    pub(super) span: Range<usize>,
}

/// These names, which have this role.
pub(super) fn named<'f>(
    names: impl IntoIterator<Item = &'f Spanned<String>>,
    role: Role,
) -> impl Iterator<Item = (&'f str, Named)> {
    let named = move |name: &'f Spanned<String>| {
        (name.get_ref().as_str(), Named { role, span: name.span() })
    };
    names.into_iter().map(named)
}
