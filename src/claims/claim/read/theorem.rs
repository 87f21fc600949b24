//! Reading theorems.

use super::fields::claim_table;
use super::kind::{ClaimTable, Named, Role, named};
use super::reader::{Head, Reader};
use super::trial::{RewritingTable, SupposesTable, TrialFields};
use crate::claim::{ByHand, Paper, Quantity, Statement, THEOREM_NAMES, Theorem};
use crate::diagnostic::Diagnostic;
use crate::scheme::{Spanned, formula};
use crate::suggestion::did_you_mean;
use std::collections::{BTreeMap, BTreeSet};

claim_table!(TheoremTable {
    /// `distance`, `step`, `difference` or `depth`.
    bounds: Option<Spanned<String>>,
    /// The bound, a formula in k and beta; of a depth, the level, in epsilon and beta.
    pub(super) by: Option<Spanned<String>>,
    /// The first level that it is stated for.
    from: Option<Spanned<String>>,
    /// In place of `bounds` and `by`: a statement of another kind, in words.
    says: Option<String>,
    /// Schemes that a theorem about every scheme is tried on.
    #[serde(default)]
    schemes: Vec<Spanned<String>>,
    /// Values of open names; all combinations are tried.
    #[serde(default)]
    pub(super) values: BTreeMap<Spanned<String>, Vec<Spanned<String>>>,
    /// Where polygon and limit are compared.
    offset: Option<Spanned<String>>,
    /// Where the points of a level are: `natural`, or `indexed` at i/n^k.
    parameters: Option<Spanned<String>>,
    /// Of rings: what the points of the next level are compared with.
    interpolant: Option<Spanned<String>>,
    /// A constant in `by` belongs to so many levels.
    block: Option<Spanned<String>>,
    /// A hypothesis; other cases are out of question.
    supposes: Option<SupposesTable>,
    /// Corrections to try beside those that the program knows.
    #[serde(default)]
    corrections: Vec<RewritingTable>,
    /// Where a proof by hand stands.
    proved_by: Option<Spanned<String>>,
    /// Where a refutation by hand stands.
    refuted_by: Option<Spanned<String>>,
    /// Ids of claims of the file that the proof by hand uses.
    #[serde(default)]
    proof_uses: Vec<Spanned<String>>,
    /// Ids of claims of the file that the theorem rests on.
    #[serde(default)]
    rests: Vec<Spanned<String>>,
});

impl ClaimTable for TheoremTable {
    fn names(&self) -> Vec<(&str, Named)> {
        let of_theorems = self.by.iter().flat_map(|by| {
            THEOREM_NAMES.map(|name| (name, Named { role: Role::OfTheorem, span: by.span() }))
        });
        named(self.values.keys(), Role::Open).chain(of_theorems).collect()
    }

    fn read(&self, reader: &Reader<'_>, paper: &mut Paper) -> Result<(), Diagnostic> {
        paper.theorems.push(reader.theorem(self)?);
        Ok(())
    }
}

impl TheoremTable {
    fn trial(&self) -> TrialFields<'_> {
        TrialFields {
            scheme: self.scheme.as_ref(),
            schemes: &self.schemes,
            values: &self.values,
            offset: self.offset.as_ref(),
            parameters: self.parameters.as_ref(),
            interpolant: self.interpolant.as_ref(),
            block: self.block.as_ref(),
            supposes: self.supposes.as_ref(),
            corrections: &self.corrections,
        }
    }
}

/// The word of `bounds` in a theorem that bounds a depth.
const DEPTH: &str = "depth";

impl Reader<'_> {
    fn theorem(&self, table: &TheoremTable) -> Result<Theorem, Diagnostic> {
        let Head { id, locus, title, scheme, note } = self.head(table.common())?;
        let statement = self.statement(table)?;
        self.known(&id, &table.rests, "rests", &self.ids[0])?;
        self.known(&id, &table.proof_uses, "proof_uses", &self.ids[0])?;
        self.decided(&table.proof_uses, &self.ids[1])?;
        let rests = table.rests.iter().map(|premise| premise.get_ref().clone()).collect();
        let (mut tried, by_hand) = (self.trial(table.trial())?, self.by_hand(table)?);
        // Differences are the same wherever the points are.
        tried.natural &=
            !matches!(statement, Statement::Bound { quantity: Quantity::Difference, .. });
        Ok(Theorem { id, locus, title, scheme, statement, tried, by_hand, rests, note })
    }

    /// Checks that none of these is a theorem: a proof by hand may use only what is computed.
    fn decided(
        &self,
        used: &[Spanned<String>],
        theorems: &BTreeSet<&str>,
    ) -> Result<(), Diagnostic> {
        let theorem = used.iter().find(|name| theorems.contains(name.get_ref().as_str()));
        let Some(name) = theorem else { return Ok(()) };
        let message = format!("the proof uses `{}`, which is a theorem itself", name.get_ref());
        let help = "`proof_uses` lists equations, functions and ranges; a theorem that it needs \
                    belongs in `rests`";
        Err(self.error(name.span(), message).with_help(help))
    }

    /// Checks that these are ids of other claims.
    fn known(
        &self,
        id: &str,
        named: &[Spanned<String>],
        field: &str,
        ids: &BTreeSet<&str>,
    ) -> Result<(), Diagnostic> {
        let unknown = |name: &&Spanned<String>| {
            let name = name.get_ref().as_str();
            name == id || !ids.contains(name)
        };
        let Some(name) = named.iter().find(unknown) else { return Ok(()) };
        let others = ids.iter().copied().filter(|other| *other != id);
        let meant = did_you_mean(name.get_ref(), others);
        let message = format!("`{}` is no other claim of this file{meant}", name.get_ref());
        let help = format!("`{field}` lists ids of this file, such as 'eq-18'");
        Err(self.error(name.span(), message).with_help(help))
    }

    fn by_hand(&self, table: &TheoremTable) -> Result<Option<ByHand>, Diagnostic> {
        let uses = table.proof_uses.iter().map(|name| name.get_ref().clone()).collect();
        let (text, refutes) = match (&table.proved_by, &table.refuted_by) {
            (None, None) => match table.proof_uses.first() {
                None => return Ok(None),
                Some(first) => {
                    let message = "these belong to a proof, and there is none";
                    return Err(self
                        .error(first.span(), message)
                        .with_help("say where it stands: proved_by = 'THEOREMS 42'"));
                }
            },
            (Some(text), None) => (text.get_ref().clone(), false),
            (None, Some(text)) => (text.get_ref().clone(), true),
            (Some(_), Some(second)) => {
                let message = "a theorem is proved or refuted, not both";
                return Err(self.error(second.span(), message));
            }
        };
        Ok(Some(ByHand { text, refutes, uses }))
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
            self.error(text.span(), format!("`{}` is not a level", text.get_ref()))
                .with_help("a level is an integer, 0 or more")
        })
    }
}
