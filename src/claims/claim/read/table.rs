//! Reading tables.

use super::axis::AxisTable;
use super::fields::{Formulas, NumberField, TableOf, Unstated, claim_table};
use super::figure::FigureTable;
use super::kind::{ClaimTable, Named, Role, named};
use super::reader::{Head, Reader};
use crate::claim::{Cell, Paper, Printed, Promise, Table};
use crate::diagnostic::Diagnostic;
use crate::formula::LocatedFormula;
use crate::scheme::{Spanned, definitions, formula, identifier};
use serde::Deserialize;
use serde::de::{Unexpected, Visitor};
use std::collections::BTreeMap;
use std::fmt;

claim_table!(TableTable {
    /// The formula that each cell is said to equal.
    value: Spanned<String>,
    /// What a cell promises beyond its value.
    promise: Option<Spanned<PromiseTable>>,
    /// The headers of the rows.
    pub(super) rows: Option<Spanned<AxisTable>>,
    /// The headers of the columns.
    pub(super) columns: Spanned<AxisTable>,
    /// Rows of numbers as printed, or `"lost"`. Nothing is printed in a cell that is empty or a dash.
    cells: Spanned<CellsField>,
    /// Values that the paper states for this table.
    #[serde(default)]
    pub(super) given: Formulas,
    /// Parameters that the paper does not state.
    #[serde(default)]
    pub(super) unstated: Unstated,
    /// The figures of the paper that plot numbers of this table.
    #[serde(default)]
    figures: Vec<Spanned<TableOf<FigureTable>>>,
});

#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
struct PromiseTable {
    /// Cells are depths: from this level on the distance is at most the tolerance.
    tolerance: Option<Spanned<String>>,
    /// Cells are upper bounds of the distance at this level.
    level: Option<Spanned<String>>,
    /// max ‖Δ^0‖, a formula.
    spread: Spanned<String>,
    /// The index offset at which the paper compares polygon and limit.
    offset: Option<Spanned<String>>,
    /// The rules of which the points are compared with their limit.
    ring: Option<Spanned<String>>,
}

/// Rows of cells, or `"lost"` when the source has none of them.
#[derive(Debug)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(untagged))]
enum CellsField {
    #[cfg_attr(feature = "schema", schemars(with = "Lost"))]
    Lost,
    Rows(Vec<Spanned<Vec<Spanned<NumberField>>>>),
}

impl ClaimTable for TableTable {
    fn names(&self) -> Vec<(&str, Named)> {
        let axes = self.rows.iter().chain([&self.columns]);
        let headers = axes.filter_map(|axis| axis.get_ref().name.as_ref());
        let own = named(self.given.keys(), Role::Given);
        own.chain(named(self.unstated.names(), Role::Unstated))
            .chain(named(headers, Role::Header))
            .collect()
    }

    fn read(&self, reader: &Reader<'_>, paper: &mut Paper) -> Result<(), Diagnostic> {
        paper.tables.push(reader.table(self)?);
        Ok(())
    }
}

/// The word for cells of which the source has none.
#[cfg(feature = "schema")]
#[derive(schemars::JsonSchema)]
#[schemars(rename_all = "lowercase")]
#[expect(dead_code, reason = "it is a form, and no value")]
enum Lost {
    Lost,
}

impl<'de> Deserialize<'de> for CellsField {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<CellsField, D::Error> {
        struct Either;
        impl<'de> Visitor<'de> for Either {
            type Value = CellsField;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("rows of cells such as [['0.68', '0.31'], …], or \"lost\"")
            }
            fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<CellsField, E> {
                if text == "lost" {
                    return Ok(CellsField::Lost);
                }
                Err(E::invalid_value(
                    Unexpected::Str(text),
                    &"rows of cells such as [['0.68', '0.31'], …], which are written here, as a file is not \
                      read, or \"lost\"",
                ))
            }
            fn visit_seq<S: serde::de::SeqAccess<'de>>(
                self,
                rows: S,
            ) -> Result<CellsField, S::Error> {
                let rows = serde::de::value::SeqAccessDeserializer::new(rows);
                Vec::deserialize(rows).map(CellsField::Rows)
            }
        }
        deserializer.deserialize_any(Either)
    }
}

impl Reader<'_> {
    pub(super) fn table(&self, table: &TableTable) -> Result<Table, Diagnostic> {
        let rows = table.rows.as_ref().map(|rows| self.axis(rows)).transpose()?;
        let columns = self.axis(&table.columns)?;
        self.one_scheme(table)?;
        let shape = (rows.as_ref().map_or(1, |rows| rows.entries.len()), columns.entries.len());
        let Head { id, locus, title, scheme, note } = self.head(table.common())?;
        Ok(Table {
            id,
            locus,
            title,
            scheme,
            value: formula(self.source, &table.value)?,
            promise: table.promise.as_ref().map(|promise| self.promise(promise)).transpose()?,
            cells: self.cells(table, shape)?,
            figures: self.figures(&table.figures, [rows.as_ref(), Some(&columns)])?,
            rows,
            columns,
            given: definitions(self.source, &table.given)?,
            unstated: self.unstated(&table.unstated)?,
            note,
        })
    }

    /// Checks that no cell has two schemes.
    fn one_scheme(&self, table: &TableTable) -> Result<(), Diagnostic> {
        let axes = table.rows.iter().chain([&table.columns]);
        let headers = axes.filter_map(|axis| Some(axis.get_ref().schemes.as_ref()?.span()));
        let mut places = table.scheme.iter().map(Spanned::span).chain(headers);
        let (Some(first), Some(second)) = (places.next(), places.next()) else { return Ok(()) };
        Err(self
            .error(second, "each cell of this table has two schemes")
            .with_place(first, "the other one is here")
            .with_help(
                "name them in `scheme`, in `rows` or in `columns`, and leave out the others",
            ))
    }

    fn unstated(
        &self,
        table: &Unstated,
    ) -> Result<BTreeMap<String, Option<LocatedFormula>>, Diagnostic> {
        match table {
            Unstated::Names(names) => {
                names.iter().map(|name| Ok((identifier(self.source, name)?, None))).collect()
            }
            Unstated::Assumed(values) => {
                let values = definitions(self.source, values)?.into_iter();
                Ok(values.map(|(name, value)| (name, Some(value))).collect())
            }
        }
    }

    fn promise(&self, table: &Spanned<PromiseTable>) -> Result<Promise, Diagnostic> {
        let PromiseTable { tolerance, level, spread, offset, ring } = table.get_ref();
        let spread = formula(self.source, spread)?;
        let offset = self.optional(offset.as_ref())?;
        let ring = ring.as_ref().map(|text| self.located(text)).transpose()?;
        match (tolerance, level) {
            (Some(tolerance), None) => {
                let tolerance = formula(self.source, tolerance)?;
                Ok(Promise::Depth { tolerance, spread, offset, ring })
            }
            (None, Some(level)) => {
                let level = formula(self.source, level)?;
                Ok(Promise::Bound { level, spread, offset, ring })
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
        let depths = table.promise.as_ref().is_some_and(|one| one.get_ref().tolerance.is_some());
        let cell = |field: &Spanned<NumberField>| {
            if self.is_blank(field)? {
                return Ok(Cell::Blank);
            }
            let printed = self.printed(field)?;
            // A level has no unit of its last place: 1e1 is 10.
            let decimal = if depths { printed.decimal.whole() } else { printed.decimal };
            Ok(Cell::Printed(Printed { decimal, ..printed }))
        };
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
}
