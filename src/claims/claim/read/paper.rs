//! Reading a whole claim file.

use super::fields::{CommonFields, Formulas};
use super::file::{AlternativeTable, PaperFile};
use super::foreign::foreign;
use super::reader::Reader;
use super::regularity::RegularityFile;
use crate::claim::{Alternative, Paper, SchemeSource};
use crate::diagnostic::{Collected, Diagnostic, Errors, SourceText, read_text};
use crate::formula::LocatedFormula;
use crate::scheme::{SchemeTable, find_in_catalogue, formula, from_toml, identifier};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;

/// The largest claim file that is read, in bytes.
pub const MAX_CLAIM_FILE_BYTES: u64 = 4 << 20;

/// The names that formulas have for other things, so that a scheme of such a name could not be named there.
const RESERVED: [&str; 2] = ["pi", "z"];

/// What to do with a file that has no table yet.
const BEGIN: &str = "begin with key = \"doe2026\" and [paper], where title = \"…\" and year = \"2026\"; \
                     `subcert new doe2026` writes a whole file to start from";

/// Reads a claim file.
///
/// # Errors
/// When it is not TOML, a key is unknown or missing, a table is ragged, an id is used twice, a name
/// has two meanings, or a formula or number is not one: with the place and a remedy. Only the first
/// error is given; [`read_whole_paper`] gives all.
pub fn read_paper(source: &Arc<SourceText>) -> Result<Paper, Diagnostic> {
    read_whole_paper(source).map_err(Errors::first)
}

/// Reads a claim file, and goes on after an error: each table, equation, theorem, scheme and
/// definition is read by itself.
///
/// # Errors
/// As [`read_paper`], but with all errors that do not follow from each other. A file that is not
/// TOML, or that has fields of other types, gives only the first one.
///
/// ```
/// use subcert::claim::read_whole_paper;
/// use subcert::diagnostic::SourceText;
///
/// let text = r#"
/// key = "k"
/// define = { a = "1 +", b = "2", c = "*" }
/// paper = { authors = ["A"], title = "t", venue = "v", year = "2026" }
/// "#;
/// let errors = read_whole_paper(&SourceText::new("k.toml", text)).unwrap_err();
/// assert_eq!(errors.all().len(), 2);
/// ```
pub fn read_whole_paper(source: &Arc<SourceText>) -> Result<Paper, Errors> {
    let begun = source.text.lines().any(|line| line.trim_start().starts_with(['[', 'p']));
    let mut file: PaperFile = from_toml(source).map_err(|error| {
        let plain = || if begun { error } else { error.with_help(BEGIN) };
        Errors::from(foreign(source).unwrap_or_else(plain))
    })?;
    let reader = Reader { source, ids: Default::default() };
    let mut errors = Collected::default();
    let mut regularity = Vec::new();
    for cells in errors.all(&file.regularity, |table| reader.regularity(table)) {
        regularity.push(cells.table);
        file.smoothness.extend(cells.smoothness);
        file.exponent.extend(cells.exponents);
    }
    errors.take(reader.id(&file.key));
    errors.take(reader.ids(&file));
    let ids = [
        file.claims().map(|(fields, _)| fields.id.get_ref().as_str()).collect(),
        file.theorem.iter().map(|theorem| theorem.id.get_ref().as_str()).collect(),
    ];
    let reader = Reader { source, ids };
    let roles = errors.take(reader.roles(&file));
    let fields = file.claims().map(|(fields, _)| fields);
    let contents = reader.contents(&file.paper.numbered, fields, &file.unclaimed);
    let bibliography = file.paper.bibliography();
    let mut paper = Paper {
        contents: errors.take(contents).unwrap_or_default(),
        schemes: reader.schemes(&file.scheme, &mut errors),
        definitions: formulas(source, &file.define, &mut errors),
        alternatives: errors
            .take(reader.alternatives(&file.alternative, &file.define))
            .unwrap_or_default(),
        given: formulas(source, &file.given, &mut errors),
        regularity,
        ..Paper::new(file.key.get_ref().clone(), bibliography, source)
    };
    for (_, claim) in file.claims() {
        errors.take(claim.read(&reader, &mut paper));
    }
    paper.smoothness.sort_by_key(|claim| claim.kind);
    // The names in formulas are checked only if the file has no other error.
    match (roles, errors.none()) {
        (Some(roles), Ok(())) => reader.formulas(&paper, &roles).map_err(Errors::from)?,
        (_, none) => none?,
    }
    Ok(paper)
}

/// The JSON schema of claim files about papers, from the types that are read. It says nothing of formulas.
#[cfg(feature = "schema")]
#[must_use]
pub fn paper_schema() -> schemars::Schema {
    schemars::schema_for!(PaperFile)
}

/// Named formulas, each read by itself.
fn formulas(
    source: &Arc<SourceText>,
    table: &Formulas,
    errors: &mut Collected,
) -> BTreeMap<String, LocatedFormula> {
    let read = |name, text| Ok((identifier(source, name)?, formula(source, text)?));
    table.iter().filter_map(|(name, text)| errors.take(read(name, text))).collect()
}

/// Reads the claim file at `path`.
///
/// # Errors
/// The outer error says why the file cannot be read; the inner one lists the errors in it.
pub fn read_paper_file(path: &Path) -> Result<Result<Paper, Errors>, String> {
    let text = read_text(path, MAX_CLAIM_FILE_BYTES)
        .map_err(|reason| format!("cannot read `{}`: {reason}", path.display()))?;
    Ok(read_whole_paper(&SourceText::new(path.display().to_string(), text)))
}

impl Reader<'_> {
    /// The ids of the claims, which have to be different.
    fn ids<'f>(&self, file: &'f PaperFile) -> Result<BTreeSet<&'f str>, Diagnostic> {
        let mut ids = BTreeSet::new();
        let tables = file.regularity.iter().map(RegularityFile::common);
        for CommonFields { id, .. } in tables.chain(file.claims().map(|(fields, _)| fields)) {
            self.id(id)?;
            if !ids.insert(id.get_ref().as_str()) {
                return Err(self
                    .error(id.span(), format!("the id `{}` is used twice", id.get_ref()))
                    .with_help("every claim of the file needs an id of its own"));
            }
        }
        Ok(ids)
    }

    /// The alternatives. Those of one definition need different labels, since reports name them by
    /// these.
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
        tables.iter().map(|table| self.alternative(table, define)).collect()
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

    /// The schemes of the file by name, each read by itself.
    fn schemes(
        &self,
        tables: &[SchemeTable],
        errors: &mut Collected,
    ) -> BTreeMap<String, SchemeSource> {
        let mut schemes = BTreeMap::new();
        for table in tables {
            let name = table.name.get_ref();
            let Some(scheme) = errors.take(self.scheme(table, tables, &schemes)) else { continue };
            if schemes.insert(name.clone(), scheme).is_some() {
                let message = format!("the scheme `{name}` is defined twice");
                errors.add(self.error(table.name.span(), message));
            }
        }
        schemes
    }

    /// One of the schemes of a file; those `before` it may be parts of its symbol, and no other one of a name of the file.
    fn scheme(
        &self,
        table: &SchemeTable,
        all: &[SchemeTable],
        before: &BTreeMap<String, SchemeSource>,
    ) -> Result<SchemeSource, Diagnostic> {
        let other = |name: &str| match before.get(name) {
            Some(SchemeSource::Own(definition)) => Some(Arc::new((**definition).clone())),
            Some(SchemeSource::Alias(_)) => None,
            None if all.iter().any(|one| one.name.get_ref() == name) => None,
            None => find_in_catalogue(name).ok().cloned().map(Arc::new),
        };
        if RESERVED.contains(&table.name.get_ref().as_str()) {
            let message = format!("`{}` means another thing in formulas", table.name.get_ref());
            return Err(self
                .error(table.name.span(), message)
                .with_help("give the scheme another name"));
        }
        Ok(match table.alias() {
            Some(other) => SchemeSource::Alias(self.reference(other)?),
            None => SchemeSource::Own(Box::new(table.define(self.source, &other)?)),
        })
    }
}
