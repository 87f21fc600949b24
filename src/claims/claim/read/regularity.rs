//! Reading tables of orders of smoothness and of Hölder exponents: each cell becomes a claim.

use super::axis::AxisTable;
use super::fields::{Formulas, NumberField, claim_table};
use super::reader::Reader;
use super::smoothness::{ExponentTable, SmoothnessTable};
use crate::claim::{Headers, RegularityCell, RegularityTable};
use crate::diagnostic::Diagnostic;
use crate::scheme::Spanned;
use std::collections::BTreeMap;
use std::sync::Arc;

claim_table!(RegularityFile {
    /// Schemes, or values of a parameter.
    rows: Spanned<AxisTable>,
    /// What each column states: `order`, `continuous`, `not_continuous`, `exponent`, `value`, `at_least` or `at_most`.
    columns: Spanned<Vec<Spanned<String>>>,
    /// Rows of what is printed. Nothing is printed in a cell that is empty or a dash.
    cells: Spanned<Vec<Spanned<Vec<Spanned<NumberField>>>>>,
});

/// What a column may state.
const COLUMNS: [&str; 7] =
    ["order", "continuous", "not_continuous", "exponent", "value", "at_least", "at_most"];

const EXAMPLE: &str = "rows = { schemes = [\"chaikin\", \"four-point:w=1/16\"] }, columns = [\"order\", \"exponent\"], \
                       cells = [['1', '2.000'], ['1', '2.000']]";

/// A table, and the claims of its cells.
pub(super) struct Cells {
    pub(super) table: Arc<RegularityTable>,
    pub(super) smoothness: Vec<SmoothnessTable>,
    pub(super) exponents: Vec<ExponentTable>,
}

/// A row: its header as printed and with its name, its scheme, and the value of the parameter.
struct Row {
    printed: String,
    header: String,
    scheme: Spanned<String>,
    given: Formulas,
}

impl Reader<'_> {
    /// Reads a table.
    pub(super) fn regularity(&self, file: &RegularityFile) -> Result<Cells, Diagnostic> {
        self.id(&file.id)?;
        let (label, rows) = self.regularity_rows(file)?;
        let columns = self.regularity_columns(&file.columns)?;
        let lines = file.cells.get_ref();
        if lines.len() != rows.len() {
            let message = format!("{} rows of cells, and {} row headers", lines.len(), rows.len());
            return Err(self
                .error(file.cells.span(), message)
                .with_help("give one row of cells for each header in `rows`"));
        }
        let table = Arc::new(RegularityTable {
            id: file.id.get_ref().clone(),
            locus: file.locus.get_ref().clone(),
            title: file.title.clone(),
            label,
            rows: rows.iter().map(|row| row.printed.clone()).collect(),
            columns,
            note: file.note.clone(),
        });
        let (smoothness, exponents) = Default::default();
        let mut cells = Cells { table: Arc::clone(&table), smoothness, exponents };
        for (line, (row, header)) in lines.iter().zip(rows.iter().enumerate()) {
            let found = line.get_ref().len();
            if found != table.columns.len() {
                let message = format!("{found} cells, and {} columns", table.columns.len());
                return Err(self.error(line.span(), message).with_help(
                    "give one cell for each of `columns`; '-' where nothing is printed",
                ));
            }
            for (column, field) in line.get_ref().iter().enumerate() {
                if !self.is_blank(field)? {
                    let place = RegularityCell {
                        table: Arc::clone(&table),
                        row,
                        column,
                        printed: field.get_ref().printed.clone(),
                        header: header.header.clone(),
                    };
                    cells.add(file, header, field, place);
                }
            }
        }
        if cells.smoothness.is_empty() && cells.exponents.is_empty() {
            return Err(self.error(file.cells.span(), "no cell states anything").with_help(
                "'-' is a cell where nothing is printed; write what is printed in the others",
            ));
        }
        Ok(cells)
    }

    /// What the rows are, and the rows.
    fn regularity_rows(&self, file: &RegularityFile) -> Result<(String, Vec<Row>), Diagnostic> {
        let axis = self.axis(&file.rows)?;
        let fields = file.rows.get_ref();
        let mut rows = Vec::new();
        let mut known = BTreeMap::new();
        let twice = |printed: &str, span, first| {
            let message = format!("the row `{printed}` stands here twice");
            self.error(span, message)
                .with_place(first, "the other one is here")
                .with_help("each scheme, or value of the parameter, has one row")
        };
        match (&axis.headers, &fields.schemes, &fields.values, &file.scheme) {
            (Headers::Schemes(_), Some(schemes), _, None) => {
                for field in schemes.get_ref() {
                    let printed = field.get_ref().printed.clone();
                    let written = field.get_ref().scheme.clone();
                    let scheme =
                        written.unwrap_or_else(|| Spanned::new(field.span(), printed.clone()));
                    if let Some(first) = known.insert(scheme.get_ref().clone(), field.span()) {
                        return Err(twice(&printed, field.span(), first));
                    }
                    let (header, given) = (printed.clone(), Formulas::new());
                    rows.push(Row { printed, header, scheme, given });
                }
            }
            (Headers::Values { name, values }, _, Some(fields), Some(scheme)) => {
                for (field, value) in fields.get_ref().iter().zip(values) {
                    let NumberField { printed, read, .. } = field.get_ref();
                    if let Some(first) = known.insert(value.to_string(), field.span()) {
                        return Err(twice(printed, field.span(), first));
                    }
                    let text = read.as_ref().unwrap_or(printed).clone();
                    let (name, header) = (name.clone(), format!("{name} = {printed}"));
                    let given = Formulas::from([(
                        Spanned::new(file.rows.span(), name),
                        Spanned::new(field.span(), text),
                    )]);
                    let (printed, scheme) = (printed.clone(), scheme.clone());
                    rows.push(Row { printed, header, scheme, given });
                }
            }
            (Headers::Schemes(_), _, _, _) => {
                let span = file.scheme.as_ref().map_or(file.rows.span(), Spanned::span);
                return Err(self
                    .error(span, "each row of this table has two schemes")
                    .with_help("leave out `scheme`: the rows name theirs"));
            }
            (Headers::Values { name, .. }, _, _, _) => {
                return Err(self
                    .error(file.id.span(), "smoothness is that of a scheme, and `scheme` is missing")
                    .with_help(format!(
                        "scheme = \"four-point:w={name}\", where `{name}` has the values of `rows`; or \
                         rows = {{ schemes = [\"chaikin\"] }}"
                    )));
            }
        }
        Ok((axis.label, rows))
    }

    fn regularity_columns(
        &self,
        columns: &Spanned<Vec<Spanned<String>>>,
    ) -> Result<Vec<String>, Diagnostic> {
        let mut names: Vec<String> = Vec::new();
        if columns.get_ref().is_empty() {
            return Err(self
                .error(columns.span(), "at least one column is needed")
                .with_help(EXAMPLE));
        }
        for column in columns.get_ref() {
            let name = column.get_ref();
            if !COLUMNS.contains(&name.as_str()) {
                return Err(self
                    .error(column.span(), format!("`{name}` is nothing that a column states"))
                    .with_help(format!("a column is one of {}; {EXAMPLE}", COLUMNS.join(", "))));
            }
            if names.contains(name) {
                return Err(self
                    .error(column.span(), format!("the column `{name}` stands here twice"))
                    .with_help("a second table of the same locus may have it"));
            }
            names.push(name.clone());
        }
        Ok(names)
    }
}

impl Cells {
    /// Adds the claim of a cell.
    #[expect(clippy::arithmetic_side_effects, reason = "the number of a row that the file has")]
    fn add(
        &mut self,
        file: &RegularityFile,
        row: &Row,
        field: &Spanned<NumberField>,
        cell: RegularityCell,
    ) {
        let NumberField { printed, read, note } = field.get_ref();
        let column = cell.table.columns[cell.column].clone();
        let id = format!("{}.{}.{column}", file.id.get_ref(), cell.row + 1);
        let id = Spanned::new(file.id.span(), id);
        let (locus, title, note) = (file.locus.clone(), file.title.clone(), note.clone());
        let (scheme, given) = (Some(row.scheme.clone()), row.given.clone());
        let text = read.as_ref().unwrap_or(printed).trim().to_owned();
        // The order after this one, where it is an order.
        let next = text.parse::<usize>().ok().and_then(|m| m.checked_add(1));
        let next = next.map(|m| Spanned::new(field.span(), m.to_string()));
        let text = |names: &[&str]| {
            names.contains(&&column[..]).then(|| Spanned::new(field.span(), text.clone()))
        };
        if ["order", "continuous", "not_continuous"].contains(&&column[..]) {
            let continuous = text(&["order", "continuous"]);
            let not_continuous = if column == "order" { next } else { text(&["not_continuous"]) };
            let (valences, absent, cell) = (None, None, Some(cell));
            self.smoothness.push(SmoothnessTable {
                id,
                locus,
                title,
                scheme,
                note,
                continuous,
                not_continuous,
                valences,
                absent,
                given,
                cell,
            });
        } else {
            let (value, at_least, at_most) =
                (text(&["value"]), text(&["at_least"]), text(&["at_most"]));
            let printed = (column == "exponent").then(|| field.clone());
            let (attained, absent, cell) = (None, None, Some(cell));
            self.exponents.push(ExponentTable {
                id,
                locus,
                title,
                scheme,
                note,
                value,
                printed,
                at_least,
                at_most,
                attained,
                absent,
                given,
                cell,
            });
        }
    }
}
