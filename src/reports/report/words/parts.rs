//! Texts that several parts of a report share.

use crate::audit::{PaperAudit, TableFinding, Word};
use crate::formula::LocatedFormula;

/// Whether a word is the mark of a verdict.
pub(crate) fn is_mark(word: &str) -> bool {
    Word::ALL.iter().any(|verdict| verdict.mark() == word)
}

/// Joins parts by points and leaves out the empty ones, such as a claim's title and its id, by
/// which `subcert explain` finds it.
pub(crate) fn titled(parts: &[&str]) -> String {
    let parts: Vec<&str> = parts.iter().copied().filter(|part| !part.is_empty()).collect();
    parts.join(" · ")
}

/// The definitions that a formula uses.
pub(crate) fn definitions(
    audit: &PaperAudit<'_>,
    formula: &LocatedFormula,
) -> impl Iterator<Item = (String, String)> {
    let used = audit.paper.definitions_in(formula).into_iter();
    used.map(|(name, formula)| (format!("where {name}"), formula.text.clone()))
}

/// The scheme of a table or a cell, the definition of its value, and the definitions that it uses.
pub(crate) fn definition(
    audit: &PaperAudit<'_>,
    finding: &TableFinding<'_>,
    scheme: Option<(String, String)>,
) -> Vec<(String, String)> {
    let value = &finding.table.value;
    let own = scheme.into_iter().chain([("said to equal".to_owned(), value.text.clone())]);
    own.chain(definitions(audit, value)).collect()
}
