//! What findings of all kinds have in common.

use super::harm::Harm;
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
