//! Reading theorems.

use super::fields::claim_table;
use super::{Head, Reader};
use crate::claim::{Quantity, Statement, Theorem};
use crate::diagnostic::Diagnostic;
use crate::scheme::formula;
use std::collections::BTreeSet;
use toml::Spanned;

claim_table!(TheoremTable {
    bounds: Option<Spanned<String>>,
    by: Option<Spanned<String>>,
    from: Option<Spanned<String>>,
    says: Option<String>,
    #[serde(default)]
    rests: Vec<Spanned<String>>,
});

/// What `bounds` says where a theorem bounds a depth, not a quantity at level k.
const DEPTH: &str = "depth";

impl Reader<'_> {
    /// Reads a theorem; `ids` are those of all claims of the file.
    pub(super) fn theorem(
        &self,
        table: &TheoremTable,
        ids: &BTreeSet<&str>,
    ) -> Result<Theorem, Diagnostic> {
        let Head { id, locus, title, scheme, note } = self.head(table.common())?;
        let statement = self.statement(table)?;
        for premise in &table.rests {
            let known = premise.get_ref().as_str();
            if known == id || !ids.contains(known) {
                let message = format!("`{known}` is no other claim of this file");
                return Err(self
                    .error(premise.span(), message)
                    .with_help("`rests` lists ids of this file, such as 'eq-18'"));
            }
        }
        let rests = table.rests.iter().map(|premise| premise.get_ref().clone()).collect();
        Ok(Theorem { id, locus, title, scheme, statement, rests, note })
    }

    fn statement(&self, table: &TheoremTable) -> Result<Statement, Diagnostic> {
        let (bounds, by) = match (&table.bounds, &table.by, &table.says) {
            (Some(bounds), Some(by), None) => (bounds, formula(self.source, by)?),
            (None, None, Some(says)) => return Ok(Statement::Other(says.clone())),
            _ => {
                return Err(self
                    .error(table.id.span(), "a theorem needs `bounds` and `by`, or `says`")
                    .with_help(
                        "bounds = \"distance\", by = 'gamma*beta*delta^k/(1 - delta)', or \
                         says = \"…\" in a few words for a statement of another kind",
                    ));
            }
        };
        let quantity =
            Quantity::ALL.into_iter().find(|quantity| quantity.name() == bounds.get_ref());
        match (quantity, &table.from) {
            (Some(quantity), Some(from)) => {
                Ok(Statement::Bound { quantity, by, from: self.first_level(from)? })
            }
            (Some(_), None) => Err(self
                .error(bounds.span(), "a bound needs the first level it is stated for")
                .with_help("from = '0' for k >= 0, from = '1' for k >= 1")),
            (None, None) if bounds.get_ref() == DEPTH => Ok(Statement::Depth(by)),
            (None, Some(from)) if bounds.get_ref() == DEPTH => Err(self
                .error(from.span(), "a depth has no first level")
                .with_help("`by` is the level from which the distance is at most epsilon")),
            (None, _) => Err(self
                .error(bounds.span(), format!("`{}` is nothing to bound", bounds.get_ref()))
                .with_help("`distance`, `step`, `difference` or `depth`")),
        }
    }

    fn first_level(&self, text: &Spanned<String>) -> Result<u32, Diagnostic> {
        text.get_ref().parse().map_err(|_| {
            self.error(text.span(), format!("`{}` is no level", text.get_ref()))
                .with_help("a level is an integer, 0 or more")
        })
    }
}
