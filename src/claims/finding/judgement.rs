//! What findings of all kinds have in common.

use crate::cap::Cap;
use crate::verdict::Word;

/// A finding about a claim, whatever its kind.
pub(crate) struct Judgement<'f> {
    /// The word for its verdict; a table has one for each cell.
    pub(crate) word: Option<Word>,
    /// The cap that a value of it is beyond; tables and theorems name caps cell by cell and case by case.
    pub(crate) cap: Option<&'f Cap>,
    /// What may happen to those who rely on the claim, if it is wrong.
    pub(crate) harm: Harm,
}

/// What may happen to those who rely on a claim that is not what it should be, the worst first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Harm {
    /// It is refuted: a theorem, or what is said of the smoothness of limits.
    Refuted,
    /// It breaks its promise: some control data are farther away than a printed bound or depth says, or a range has
    /// values for which the condition fails.
    Broken,
    /// It is not shown to keep its promise, nor to break it.
    Unshown,
    /// A formula is not what it should be.
    Formula,
    /// Numbers are not what their definition gives.
    Number,
    /// It is true, but more is: a range is larger, limits are smoother.
    NotSharp,
}

impl Harm {
    /// All of them, the worst first.
    pub const ALL: [Harm; 6] =
        [Harm::Refuted, Harm::Broken, Harm::Unshown, Harm::Formula, Harm::Number, Harm::NotSharp];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Harm::Refuted => Word::Refuted.name(),
            Harm::Broken => Word::Broken.name(),
            Harm::Unshown => "unshown",
            Harm::Formula => "formula",
            Harm::Number => "number",
            Harm::NotSharp => "not-sharp",
        }
    }
}
