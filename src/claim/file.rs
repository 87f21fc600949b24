//! Reading claim files.

use super::equation::{Equation, EquationBody, Hypothesis, Identity, Index, Left};
use super::fields::{
    AxisTable, CellsField, EquationTable, LeftField, NumberField, PaperFile, PromiseTable,
    TableTable,
};
use super::paper::{Bibliography, Paper, SchemeSource};
use super::table::{Axis, AxisEntry, Cell, LocatedReference, Printed, Promise, Table};
use crate::diagnostic::{Diagnostic, SourceText, read_text};
use crate::exact::{parse_decimal, parse_rational};
use crate::formula::{LocatedFormula, Node};
use crate::scheme::Reference;
use crate::scheme::{SchemeTable, definitions, formula, from_toml, identifier};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;
use toml::Spanned;

/// The largest claim file that is read, in bytes.
pub const MAX_CLAIM_FILE_BYTES: u64 = 4 << 20;

/// Reads a claim file.
///
/// # Errors
/// When it is not TOML, a key is unknown or missing, a table is ragged, an id is
/// used twice, or a formula or number is not one: with the place and a remedy.
pub fn read_paper(source: &Arc<SourceText>) -> Result<Paper, Diagnostic> {
    let file: PaperFile = from_toml(source)?;
    let reader = Reader { source };
    let mut ids = BTreeSet::new();
    let ids_of_tables = file.table.iter().map(|table| &table.id);
    let ids_of_others = file.equation.iter().map(|equation| &equation.id);
    let ids_of_others = ids_of_others.chain(file.function.iter().map(|function| &function.id));
    let ids_of_others = ids_of_others.chain(file.range.iter().map(|range| &range.id));
    for id in ids_of_tables.chain(ids_of_others) {
        reader.id(id)?;
        if !ids.insert(id.get_ref()) {
            return Err(reader
                .error(id.span(), format!("the id `{}` is used twice", id.get_ref()))
                .with_help("every table, equation, function and range needs an id of its own"));
        }
    }
    let bibliography = Bibliography {
        authors: file.paper.authors,
        title: file.paper.title,
        venue: file.paper.venue,
        year: file.paper.year,
        doi: file.paper.doi,
        note: file.paper.note,
    };
    let mut schemes = BTreeMap::new();
    for table in &file.scheme {
        let name = table.name.get_ref();
        if schemes.insert(name.clone(), reader.scheme(table)?).is_some() {
            let message = format!("the scheme `{name}` is defined twice");
            return Err(reader.error(table.name.span(), message));
        }
    }
    reader.id(&file.key)?;
    Ok(Paper {
        key: file.key.into_inner(),
        bibliography,
        schemes,
        definitions: definitions(source, &file.define)?,
        given: definitions(source, &file.given)?,
        tables: file.table.iter().map(|table| reader.table(table)).collect::<Result<_, _>>()?,
        equations: file
            .equation
            .iter()
            .map(|equation| reader.equation(equation))
            .collect::<Result<_, _>>()?,
        functions: file
            .function
            .iter()
            .map(|function| reader.function(function))
            .collect::<Result<_, _>>()?,
        ranges: file.range.iter().map(|range| reader.range(range)).collect::<Result<_, _>>()?,
        source: Arc::clone(source),
    })
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

pub(super) struct Reader<'a> {
    pub(super) source: &'a Arc<SourceText>,
}

impl Reader<'_> {
    pub(super) fn error(&self, span: Range<usize>, message: impl Into<String>) -> Diagnostic {
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

    fn scheme(&self, table: &SchemeTable) -> Result<SchemeSource, Diagnostic> {
        match table.alias() {
            Some(other) => self.reference(other).map(SchemeSource::Alias),
            None => Ok(SchemeSource::Own(Box::new(table.define(self.source)?))),
        }
    }

    fn reference(&self, text: &Spanned<String>) -> Result<Reference, Diagnostic> {
        Reference::parse(text.get_ref()).map_err(|error| self.error(text.span(), error.to_string()))
    }

    pub(super) fn located(&self, text: &Spanned<String>) -> Result<LocatedReference, Diagnostic> {
        let (source, span) = (Arc::clone(self.source), text.span());
        Ok(LocatedReference { reference: self.reference(text)?, source, span })
    }

    fn optional(
        &self,
        text: Option<&Spanned<String>>,
    ) -> Result<Option<LocatedFormula>, Diagnostic> {
        text.map(|text| formula(self.source, text)).transpose()
    }

    fn axis(&self, table: &AxisTable) -> Result<Axis, Diagnostic> {
        let name = identifier(self.source, &table.name)?;
        let (Some(values), None, None) = (&table.values, &table.from, &table.to) else {
            return Err(self.error(table.name.span(), "headers are given by `values`"));
        };
        if values.get_ref().is_empty() {
            return Err(self.error(values.span(), "at least one header is needed"));
        }
        let entry = |field: &Spanned<NumberField>| {
            let NumberField { printed, read, note } = field.get_ref();
            let text = read.as_ref().unwrap_or(printed);
            let value = parse_rational(text).map_err(|error| self.damaged(field, &error))?;
            Ok(AxisEntry { printed: printed.clone(), value, note: note.clone() })
        };
        Ok(Axis {
            label: table.label.clone().unwrap_or_else(|| name.clone()),
            name,
            entries: values.get_ref().iter().map(entry).collect::<Result<_, Diagnostic>>()?,
        })
    }

    fn damaged(
        &self,
        field: &Spanned<NumberField>,
        error: &crate::exact::NumberError,
    ) -> Diagnostic {
        self.error(field.span(), error.to_string()).with_help(
            "if the paper's text is damaged here, keep it and say what it means: \
             { printed = \"6.02 - 7\", read = \"6.02e-7\", note = \"why\" }",
        )
    }

    /// A printed decimal.
    pub(super) fn printed(&self, field: &Spanned<NumberField>) -> Result<Printed, Diagnostic> {
        let NumberField { printed, read, note } = field.get_ref();
        let text = read.as_ref().unwrap_or(printed);
        let decimal = parse_decimal(text).map_err(|error| self.damaged(field, &error))?;
        let (text, note) = (printed.clone(), note.clone());
        Ok(Printed { text, decimal, note, span: field.span() })
    }

    fn promise(&self, table: &Spanned<PromiseTable>) -> Result<Promise, Diagnostic> {
        let PromiseTable { tolerance, level, spread, offset } = table.get_ref();
        let spread = formula(self.source, spread)?;
        let offset = self.optional(offset.as_ref())?;
        match (tolerance, level) {
            (Some(tolerance), None) => {
                Ok(Promise::Depth { tolerance: formula(self.source, tolerance)?, spread, offset })
            }
            (None, Some(level)) => {
                Ok(Promise::Bound { level: formula(self.source, level)?, spread, offset })
            }
            _ => Err(self
                .error(table.span(), "a promise needs either `tolerance` or `level`")
                .with_help(
                    "{ tolerance = 'epsilon', spread = 'tau' } for a table of depths, \
                     { level = 'k', spread = 'tau' } for a table of error bounds",
                )),
        }
    }

    fn cells(
        &self,
        table: &TableTable,
        shape: (usize, usize),
    ) -> Result<Vec<Vec<Cell>>, Diagnostic> {
        let (row_count, column_count) = shape;
        let CellsField::Rows(rows) = table.cells.get_ref() else {
            return Ok(vec![vec![Cell::Lost; column_count]; row_count]);
        };
        if rows.len() != row_count {
            let found = rows.len();
            let message = format!("{found} rows of cells, and {row_count} row headers");
            return Err(self.error(table.cells.span(), message).with_help(
                "give one row of cells for each header in `rows`, or one row without `rows`",
            ));
        }
        let cell = |field: &Spanned<NumberField>| self.printed(field).map(Cell::Printed);
        let row = |row: &Spanned<Vec<Spanned<NumberField>>>| {
            if row.get_ref().len() != column_count {
                let found = row.get_ref().len();
                let message = format!("{found} cells, and {column_count} column headers");
                return Err(self
                    .error(row.span(), message)
                    .with_help("give one cell for each header in `columns`"));
            }
            row.get_ref().iter().map(cell).collect()
        };
        rows.iter().map(row).collect()
    }

    fn table(&self, table: &TableTable) -> Result<Table, Diagnostic> {
        let rows = table.rows.as_ref().map(|rows| self.axis(rows)).transpose()?;
        let columns = self.axis(&table.columns)?;
        let shape = (rows.as_ref().map_or(1, |rows| rows.entries.len()), columns.entries.len());
        Ok(Table {
            id: table.id.get_ref().clone(),
            locus: table.locus.clone(),
            title: table.title.clone(),
            scheme: table.scheme.as_ref().map(|text| self.located(text)).transpose()?,
            value: formula(self.source, &table.value)?,
            promise: table.promise.as_ref().map(|promise| self.promise(promise)).transpose()?,
            cells: self.cells(table, shape)?,
            rows,
            columns,
            given: definitions(self.source, &table.given)?,
            unstated: definitions(self.source, &table.unstated)?,
            note: table.note.clone(),
        })
    }

    fn equation(&self, table: &EquationTable) -> Result<Equation, Diagnostic> {
        let body = match (&table.left, &table.right, &table.absent) {
            (Some(left), Some(right), None) => {
                EquationBody::Identity(Box::new(self.identity(table, left, right)?))
            }
            (None, None, Some(absent)) => EquationBody::NotCheckable(absent.clone()),
            _ => {
                return Err(self
                    .error(table.id.span(), "an equation needs `left` and `right`, or `absent`")
                    .with_help(
                        "left = ['3/4', '1/4'] lists the left sides, right = 'mask(0, r)' is one \
                         formula in the indices; absent = \"…\" says what the paper lacks",
                    ));
            }
        };
        Ok(Equation {
            id: table.id.get_ref().clone(),
            locus: table.locus.clone(),
            title: table.title.clone(),
            body,
            note: table.note.clone(),
        })
    }

    fn identity(
        &self,
        table: &EquationTable,
        left: &Spanned<LeftField>,
        right: &Spanned<String>,
    ) -> Result<Identity, Diagnostic> {
        let indices = table.indices.iter().map(|axis| self.index(axis));
        let indices = indices.collect::<Result<Vec<Index>, Diagnostic>>()?;
        let symbols = table.symbols.iter().map(|symbol| identifier(self.source, symbol));
        let hypotheses = table.hypotheses.iter().map(|text| self.hypothesis(text));
        Ok(Identity {
            scheme: table.scheme.as_ref().map(|text| self.located(text)).transpose()?,
            symbols: symbols.collect::<Result<_, _>>()?,
            hypotheses: hypotheses.collect::<Result<_, _>>()?,
            left: self.left(left, &indices)?,
            indices,
            right: formula(self.source, right)?,
        })
    }

    fn left(&self, left: &Spanned<LeftField>, indices: &[Index]) -> Result<Left, Diagnostic> {
        let formulas = match left.get_ref() {
            LeftField::One(text) => {
                return LocatedFormula::read(self.source, left.span(), text).map(Left::One);
            }
            LeftField::Each(formulas) => formulas,
        };
        let mut count = 1_usize;
        for index in indices {
            let Index::Listed(axis) = index else {
                return Err(self
                    .error(left.span(), "a list of left sides needs indices with `values`")
                    .with_help("write one formula for all combinations"));
            };
            count = count.saturating_mul(axis.entries.len());
        }
        if formulas.len() != count {
            let found = formulas.len();
            let message = format!("{found} left sides, and {count} combinations of the indices");
            return Err(self
                .error(left.span(), message)
                .with_help("give one left side for each combination, the first index slowest"));
        }
        let formulas = formulas.iter().map(|text| formula(self.source, text));
        formulas.collect::<Result<_, _>>().map(Left::Each)
    }

    fn index(&self, table: &AxisTable) -> Result<Index, Diagnostic> {
        let (Some(from), Some(to), None) = (&table.from, &table.to, &table.values) else {
            if table.from.is_some() || table.to.is_some() {
                return Err(self
                    .error(table.name.span(), "an index needs either `values`, or `from` and `to`")
                    .with_help("{ name = \"i\", from = '2', to = 'N - 1' }"));
            }
            return self.axis(table).map(Index::Listed);
        };
        let name = identifier(self.source, &table.name)?;
        Ok(Index::Range {
            label: table.label.clone().unwrap_or_else(|| name.clone()),
            name,
            from: Box::new(formula(self.source, from)?),
            to: Box::new(formula(self.source, to)?),
        })
    }

    fn hypothesis(&self, text: &Spanned<String>) -> Result<Hypothesis, Diagnostic> {
        let help = "write a member of a family and its value: 'a[0, m] = 1 - a[0, 0]'";
        let refuse = || self.error(text.span(), "this is no hypothesis").with_help(help);
        let (member, value) = text.get_ref().split_once('=').ok_or_else(refuse)?;
        let read = |part: &str| LocatedFormula::read(self.source, text.span(), part.trim());
        let (member, value) = (read(member)?, read(value)?);
        if matches!(member.expr.node, Node::Indexed { .. }) {
            Ok(Hypothesis { member, value })
        } else {
            Err(refuse())
        }
    }
}
