//! How the claims of a kind are judged.

use crate::claim::Paper;
use crate::diagnostic::Diagnostic;
use crate::evaluation::library::Library;

/// A kind of claim. A finding depends on no claim but those of its group.
pub(crate) trait Judge<'a>: Sized + 'a {
    /// The finding about a claim.
    type Finding;

    /// The claims of a paper that are judged together.
    fn groups(claims: &'a [Self]) -> Vec<Vec<&'a Self>>;

    /// A rough measure of the work, in cells of tables.
    fn work(&self) -> usize;

    /// Judges claims of a group; calls `after_claim` after each.
    ///
    /// # Errors
    /// The first.
    fn judge(
        paper: &'a Paper,
        group: &[&'a Self],
        after_claim: &(dyn Fn() + Sync),
    ) -> Result<Vec<Self::Finding>, Diagnostic>;
}

/// A kind of claim of which each is judged by itself.
pub(crate) trait JudgeAlone<'a>: Sized + 'a {
    /// The finding about a claim.
    type Finding;

    /// A rough measure of the work, in cells of tables.
    const WORK: usize = 1;

    /// Judges a claim.
    ///
    /// # Errors
    /// When a formula of the claim file is wrong.
    fn judge_alone(
        &'a self,
        paper: &'a Paper,
        library: &Library<'_>,
    ) -> Result<Self::Finding, Diagnostic>;
}

impl<'a, C: JudgeAlone<'a>> Judge<'a> for C {
    type Finding = C::Finding;

    fn groups(claims: &'a [C]) -> Vec<Vec<&'a C>> {
        claims.iter().map(|claim| vec![claim]).collect()
    }

    fn work(&self) -> usize {
        C::WORK
    }

    fn judge(
        paper: &'a Paper,
        group: &[&'a C],
        after_claim: &(dyn Fn() + Sync),
    ) -> Result<Vec<C::Finding>, Diagnostic> {
        let alone = |claim: &&'a C| {
            let found = claim.judge_alone(paper, &Library::new(paper));
            after_claim();
            found
        };
        group.iter().map(alone).collect()
    }
}
