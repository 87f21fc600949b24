//! Reading a whole claim file of a project.

use super::exact::ExactFields;
use super::file::{ProjectFile, ProjectTable, ShippedTable};
use super::nested::flattened;
use super::reader::{MAX_DESCRIBED, Reader};
use crate::claim::is_id;
use crate::diagnostic::{Collected, Diagnostic, Errors, SourceText};
use crate::exact::{Rational, parse_rational};
use crate::literal::Language;
use crate::scheme::{Spanned, definitions, from_toml};
use crate::shipped::claim::{NumberType, Origin, Project, ShippedClaim, TableIndex};
use std::collections::BTreeSet;
use std::sync::Arc;

/// The most tables of a claim file.
pub const MAX_SHIPPED: usize = 64;

/// Whether a claim file is about a project: it has a table `[project]`. Of a text that is not TOML, whether a line
/// begins so.
///
/// ```
/// assert!(subcert::shipped::is_project("key = 'k'\n[project]\nname = 'n'\n"));
/// assert!(!subcert::shipped::is_project("key = 'k'\n[paper]\n"));
/// ```
#[must_use]
pub fn is_project(text: &str) -> bool {
    match text.parse::<toml::Table>() {
        Ok(table) => table.contains_key("project"),
        Err(_) => text.lines().any(|line| line.trim_start().starts_with("[project]")),
    }
}

/// Reads a claim file about constants of a program, and the source files that it names, which stand relative to it.
///
/// # Errors
/// All that is wrong in it: no TOML, an unknown or missing field, an id used twice, a formula or a number that is none, a
/// count that does not fit the indices, a source file that cannot be read. Each with its place and a remedy.
pub fn read_project(source: &Arc<SourceText>) -> Result<Project, Errors> {
    let file: ProjectFile = from_toml(source).map_err(Errors::from)?;
    let reader = Reader { source };
    let mut errors = Collected::default();
    errors.take(reader.id(&file.key, "key of a project"));
    errors.take(reader.commit(&file.project));
    let definitions = errors.take(definitions(source, &file.define)).unwrap_or_default();
    if file.shipped.len() > MAX_SHIPPED {
        let message = format!("more than {MAX_SHIPPED} tables");
        errors.add(reader.error(file.key.span(), message).with_help("write several files"));
    } else if file.shipped.is_empty() {
        errors.add(
            reader
                .error(file.key.span(), "the file describes no table")
                .with_help("a table of constants is described by [[shipped]]"),
        );
    }
    let mut ids = BTreeSet::new();
    for table in &file.shipped {
        errors.take(reader.id(&table.id, "id of a table"));
        if !ids.insert(table.id.get_ref()) {
            let message = format!("the id `{}` is used twice", table.id.get_ref());
            errors.add(
                reader
                    .error(table.id.span(), message)
                    .with_help("every table of the file needs an id of its own"),
            );
        }
    }
    let shipped = errors.all(file.shipped.iter().take(MAX_SHIPPED), |table| reader.shipped(table));
    for claim in &shipped {
        errors.take(reader.index_names(claim, &definitions));
    }
    errors.none()?;
    let ProjectTable { name, repository, commit, licence, note } = file.project;
    Ok(Project {
        key: file.key.into_inner(),
        name,
        repository,
        commit: commit.map(Spanned::into_inner),
        licence,
        note,
        definitions,
        shipped,
        source: Arc::clone(source),
    })
}

impl Reader<'_> {
    fn id(&self, text: &Spanned<String>, what: &str) -> Result<(), Diagnostic> {
        if is_id(text.get_ref()) {
            return Ok(());
        }
        Err(self
            .error(text.span(), format!("`{}` cannot be the {what}", text.get_ref()))
            .with_help("use letters, digits, `-`, `_` and `.`"))
    }

    fn commit(&self, project: &ProjectTable) -> Result<(), Diagnostic> {
        let Some(located) = &project.commit else { return Ok(()) };
        let commit = located.get_ref();
        let fits = |c: char| c.is_ascii_digit() || ('a'..='f').contains(&c);
        if commit.len() == 40 && commit.chars().all(fits) {
            return Ok(());
        }
        Err(self
            .error(located.span(), format!("`{commit}` is not a commit"))
            .with_help("write its 40 hexadecimal digits, in lower case: `git rev-parse HEAD`"))
    }

    fn shipped(&self, table: &ShippedTable) -> Result<ShippedClaim, Diagnostic> {
        let kind = NumberType::parse(table.kind.get_ref()).ok_or_else(|| {
            self.error(table.kind.span(), format!("`{}` is not a type", table.kind.get_ref()))
                .with_help("write f32, f64, or decimal:6 for six digits after the point")
        })?;
        let indices = self.indices(&table.indices)?;
        let sizes: Vec<usize> = indices.iter().map(TableIndex::count).collect();
        let count = sizes.iter().try_fold(1_usize, |product, &size| product.checked_mul(size));
        let count = count.filter(|count| *count <= MAX_DESCRIBED).ok_or_else(|| {
            let message = format!("a table of more than {MAX_DESCRIBED} numbers");
            self.error(table.id.span(), message).with_help("describe it in parts")
        })?;
        let language = table.language.as_ref().map(|text| self.language(text)).transpose()?;
        let (numbers, origin) = match (&table.cells, &table.cells_from) {
            (Some(cells), None) => {
                let language = language.unwrap_or(Language::C);
                (self.typed(cells, language, kind, count)?, Origin::Typed(language))
            }
            (None, Some(from)) => {
                let file = from.get_ref().file.get_ref().clone();
                let after = flattened(std::slice::from_ref(&from.get_ref().after));
                let after: Vec<&str> = after.into_iter().map(Spanned::into_inner).collect();
                let after = after.join(", ");
                let numbers = self.sourced(from, language, kind, &sizes)?;
                (numbers, Origin::Source { file, after })
            }
            _ => {
                return Err(self
                    .error(table.id.span(), "needed is one of `cells` and `cells_from`")
                    .with_help(
                        "cells = [\"0.5f\", \"0.25f\"] types the numbers in, cells_from = { file = \
                         \"weights.h\", after = \"weights\" } reads them from a source file",
                    ));
            }
        };
        let fields = ExactFields {
            equals: table.equals.as_ref(),
            each: table.equals_cells.as_ref(),
            place: table.id.span(),
        };
        Ok(ShippedClaim {
            id: table.id.get_ref().clone(),
            span: table.id.span(),
            locus: table.locus.clone(),
            title: table.title.clone(),
            kind,
            indices,
            exact: self.exact(&fields, count)?,
            conventions: self.conventions(&table.convention, count)?,
            numbers,
            origin,
            tolerance: table.tolerance.as_ref().map(|text| self.tolerance(text)).transpose()?,
            note: table.note.clone(),
        })
    }

    fn language(&self, text: &Spanned<String>) -> Result<Language, Diagnostic> {
        Language::parse(text.get_ref()).ok_or_else(|| {
            self.error(text.span(), format!("`{}` is not a language", text.get_ref()))
                .with_help("c, which is also C++ and CUDA, shader, hlsl, wgsl, javascript, python, rust or matlab")
        })
    }

    fn tolerance(&self, text: &Spanned<String>) -> Result<(String, Rational), Diagnostic> {
        let value = parse_rational(text.get_ref())
            .map_err(|error| self.error(text.span(), error.to_string()))?;
        if value.sign() <= 0 {
            return Err(self.error(text.span(), "a tolerance is greater than 0"));
        }
        Ok((text.get_ref().clone(), value))
    }
}
