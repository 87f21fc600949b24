//! Reading a whole claim file.

use super::fields::{CommonFields, Formulas};
use super::file::{AlternativeTable, PaperFile};
use super::reader::Reader;
use crate::claim::{Alternative, Paper, SchemeSource};
use crate::diagnostic::{Diagnostic, SourceText, read_text};
use crate::scheme::{SchemeTable, definitions, formula, from_toml};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;

/// The largest claim file that is read, in bytes.
pub const MAX_CLAIM_FILE_BYTES: u64 = 4 << 20;

/// Reads a claim file.
///
/// # Errors
/// When it is not TOML, a key is unknown or missing, a table is ragged, an id is
/// used twice, a name has two meanings, or a formula or number is not one: with the place and
/// a remedy.
pub fn read_paper(source: &Arc<SourceText>) -> Result<Paper, Diagnostic> {
    let file: PaperFile = from_toml(source)?;
    let reader = Reader { source };
    reader.id(&file.key)?;
    let ids = reader.ids(&file)?;
    let roles = reader.roles(&file)?;
    let paper = Paper {
        key: file.key.get_ref().clone(),
        bibliography: file.paper.bibliography(),
        contents: reader.contents(&file.paper.numbered, file.claims(), &file.unclaimed)?,
        schemes: reader.schemes(&file.scheme)?,
        definitions: definitions(source, &file.define)?,
        alternatives: reader.alternatives(&file.alternative, &file.define)?,
        given: definitions(source, &file.given)?,
        tables: all(&file.table, |table| reader.table(table))?,
        equations: all(&file.equation, |equation| reader.equation(equation))?,
        functions: all(&file.function, |function| reader.function(function))?,
        ranges: all(&file.range, |range| reader.range(range))?,
        theorems: all(&file.theorem, |theorem| reader.theorem(theorem, &ids))?,
        source: Arc::clone(source),
    };
    reader.formulas(&paper, &roles)?;
    Ok(paper)
}

fn all<T, C>(
    tables: &[T],
    read: impl Fn(&T) -> Result<C, Diagnostic>,
) -> Result<Vec<C>, Diagnostic> {
    tables.iter().map(read).collect()
}

/// Reads the claim file at `path`.
///
/// # Errors
/// When the file cannot be read (the inner text says why), or is not a claim file.
pub fn read_paper_file(path: &Path) -> Result<Result<Paper, Diagnostic>, String> {
    let text = read_text(path, MAX_CLAIM_FILE_BYTES)
        .map_err(|reason| format!("cannot read `{}`: {reason}", path.display()))?;
    Ok(read_paper(&SourceText::new(path.display().to_string(), text)))
}

impl Reader<'_> {
    /// The ids of the claims; every claim has one of its own.
    fn ids<'f>(&self, file: &'f PaperFile) -> Result<BTreeSet<&'f str>, Diagnostic> {
        let mut ids = BTreeSet::new();
        for CommonFields { id, .. } in file.claims() {
            self.id(id)?;
            if !ids.insert(id.get_ref().as_str()) {
                return Err(self
                    .error(id.span(), format!("the id `{}` is used twice", id.get_ref()))
                    .with_help("every claim of the file needs an id of its own"));
            }
        }
        Ok(ids)
    }

    /// Those of one definition have different labels: reports tell them apart by these.
    fn alternatives(
        &self,
        tables: &[AlternativeTable],
        define: &Formulas,
    ) -> Result<Vec<Alternative>, Diagnostic> {
        let mut labels = BTreeMap::new();
        for table in tables {
            let (name, label) = (table.of.get_ref(), table.label.get_ref());
            if let Some(first) = labels.insert((name, label), table.label.span()) {
                let message = format!("two alternatives of `{name}` have the label `{label}`");
                return Err(self
                    .error(table.label.span(), message)
                    .with_place(first, "the other one is here")
                    .with_help("give each a label of its own: reports name them by it"));
            }
        }
        all(tables, |table| self.alternative(table, define))
    }

    fn alternative(
        &self,
        table: &AlternativeTable,
        define: &Formulas,
    ) -> Result<Alternative, Diagnostic> {
        let name = table.of.get_ref();
        if !define.keys().any(|known| known.get_ref() == name) {
            let message =
                format!("there is no definition `{name}` that this could be an alternative of");
            return Err(self.error(table.of.span(), message));
        }
        let value = formula(self.source, &table.value)?;
        Ok(Alternative { of: name.clone(), label: table.label.get_ref().clone(), value })
    }

    fn schemes(
        &self,
        tables: &[SchemeTable],
    ) -> Result<BTreeMap<String, SchemeSource>, Diagnostic> {
        let mut schemes = BTreeMap::new();
        for table in tables {
            let name = table.name.get_ref();
            let scheme = match table.alias() {
                Some(other) => SchemeSource::Alias(self.reference(other)?),
                None => SchemeSource::Own(Box::new(table.define(self.source)?)),
            };
            if schemes.insert(name.clone(), scheme).is_some() {
                let message = format!("the scheme `{name}` is defined twice");
                return Err(self.error(table.name.span(), message));
            }
        }
        Ok(schemes)
    }
}
