//! Reading claim files.

mod axis;
mod contents;
mod equation;
mod fields;
mod function;
mod indices;
mod roles;
mod table;
mod theorem;
mod trial;

use super::paper::{Alternative, Bibliography, Paper, SchemeSource};
use super::table::{LocatedReference, Printed};
use crate::diagnostic::{Diagnostic, SourceText, read_text};
use crate::exact::{NumberError, parse_decimal};
use crate::formula::LocatedFormula;
use crate::scheme::{Reference, SchemeTable, definitions, formula, from_toml};
use contents::UnclaimedTable;
use equation::EquationTable;
use fields::{CommonFields, Formulas, NumberField};
use function::{FunctionTable, RangeTable};
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;
use table::TableTable;
use theorem::TheoremTable;
use toml::Spanned;

/// The largest claim file that is read, in bytes.
pub const MAX_CLAIM_FILE_BYTES: u64 = 4 << 20;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct PaperFile {
    key: Spanned<String>,
    paper: BibliographyTable,
    #[serde(default)]
    define: Formulas,
    #[serde(default)]
    alternative: Vec<AlternativeTable>,
    #[serde(default)]
    given: Formulas,
    #[serde(default)]
    scheme: Vec<SchemeTable>,
    #[serde(default)]
    table: Vec<TableTable>,
    #[serde(default)]
    equation: Vec<EquationTable>,
    #[serde(default)]
    function: Vec<FunctionTable>,
    #[serde(default)]
    range: Vec<RangeTable>,
    #[serde(default)]
    theorem: Vec<TheoremTable>,
    #[serde(default)]
    unclaimed: Vec<UnclaimedTable>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct BibliographyTable {
    authors: Vec<String>,
    title: String,
    venue: String,
    year: String,
    doi: Option<String>,
    note: Option<String>,
    #[serde(default)]
    numbered: Vec<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct AlternativeTable {
    of: Spanned<String>,
    label: String,
    value: Spanned<String>,
}

impl BibliographyTable {
    fn bibliography(&self) -> Bibliography {
        Bibliography {
            authors: self.authors.clone(),
            title: self.title.clone(),
            venue: self.venue.clone(),
            year: self.year.clone(),
            doi: self.doi.clone(),
            note: self.note.clone(),
        }
    }
}

impl PaperFile {
    /// The claims of every kind, by what they have in common.
    fn claims(&self) -> impl Iterator<Item = CommonFields<'_>> {
        let tables = self.table.iter().map(TableTable::common);
        let equations = self.equation.iter().map(EquationTable::common);
        let functions = self.function.iter().map(FunctionTable::common);
        let ranges = self.range.iter().map(RangeTable::common);
        let theorems = self.theorem.iter().map(TheoremTable::common);
        tables.chain(equations).chain(functions).chain(ranges).chain(theorems)
    }
}

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
        alternatives: all(&file.alternative, |other| reader.alternative(other, &file.define))?,
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

/// Reads the parts of a claim file: from TOML tables to claims.
struct Reader<'a> {
    source: &'a Arc<SourceText>,
}

/// What every claim begins with.
struct Head {
    id: String,
    locus: String,
    title: String,
    scheme: Option<LocatedReference>,
    note: Option<String>,
}

impl Reader<'_> {
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
        Ok(Alternative { of: name.clone(), label: table.label.clone(), value })
    }

    fn error(&self, span: Range<usize>, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(self.source, span, message)
    }

    fn id(&self, id: &Spanned<String>) -> Result<(), Diagnostic> {
        let fits = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
        if !id.get_ref().is_empty() && id.get_ref().chars().all(fits) {
            return Ok(());
        }
        Err(self
            .error(id.span(), format!("`{}` cannot be an id", id.get_ref()))
            .with_help("use letters, digits, `-`, `_` and `.`"))
    }

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

    fn head(&self, fields: CommonFields<'_>) -> Result<Head, Diagnostic> {
        Ok(Head {
            id: fields.id.get_ref().clone(),
            locus: fields.locus.get_ref().clone(),
            title: fields.title.to_owned(),
            scheme: fields.scheme.map(|text| self.located(text)).transpose()?,
            note: fields.note.map(str::to_owned),
        })
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

    fn reference(&self, text: &Spanned<String>) -> Result<Reference, Diagnostic> {
        Reference::parse(text.get_ref()).map_err(|error| self.error(text.span(), error.to_string()))
    }

    fn located(&self, text: &Spanned<String>) -> Result<LocatedReference, Diagnostic> {
        let (source, span) = (Arc::clone(self.source), text.span());
        Ok(LocatedReference { reference: self.reference(text)?, source, span })
    }

    fn optional(
        &self,
        text: Option<&Spanned<String>>,
    ) -> Result<Option<LocatedFormula>, Diagnostic> {
        text.map(|text| formula(self.source, text)).transpose()
    }

    fn damaged(&self, field: &Spanned<NumberField>, error: &NumberError) -> Diagnostic {
        self.error(field.span(), error.to_string()).with_help(
            "if the paper's text is damaged here, keep it and say what it means: \
             { printed = \"6.02 - 7\", read = \"6.02e-7\", note = \"why\" }",
        )
    }

    /// A printed decimal.
    fn printed(&self, field: &Spanned<NumberField>) -> Result<Printed, Diagnostic> {
        let NumberField { printed, read, note } = field.get_ref();
        let text = read.as_ref().unwrap_or(printed);
        let decimal = parse_decimal(text).map_err(|error| self.damaged(field, &error))?;
        let (text, note) = (printed.clone(), note.clone());
        Ok(Printed { text, decimal, note, span: field.span() })
    }
}
