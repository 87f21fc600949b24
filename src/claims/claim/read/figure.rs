//! Reading the figures that plot numbers of a table.

use super::fields::TableOf;
use super::reader::Reader;
use crate::claim::{Axis, Figure};
use crate::diagnostic::Diagnostic;
use crate::scheme::Spanned;
use crate::suggestion::did_you_mean;
use serde::Deserialize;

/// The most figures of a table.
const MAX_FIGURES: usize = 16;

#[derive(Debug, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(super) struct FigureTable {
    /// Which figure: `Figure 1(a)`.
    locus: String,
    /// The headers of the rows, or else of the columns, that are plotted; without them all are.
    #[serde(default)]
    lines: Vec<Spanned<String>>,
}

impl Reader<'_> {
    /// The figures of a table with these rows, if it has some, and columns.
    pub(super) fn figures(
        &self,
        tables: &[Spanned<TableOf<FigureTable>>],
        axes: [Option<&Axis>; 2],
    ) -> Result<Vec<Figure>, Diagnostic> {
        if let Some(one) = tables.get(MAX_FIGURES) {
            let message = format!("a table has {MAX_FIGURES} figures at most");
            return Err(self.error(one.span(), message).with_help("leave the others out"));
        }
        tables.iter().map(|table| self.figure(&table.get_ref().0, axes)).collect()
    }

    fn figure(&self, table: &FigureTable, axes: [Option<&Axis>; 2]) -> Result<Figure, Diagnostic> {
        let headers = |axis: &Axis| {
            axis.entries.iter().map(|entry| entry.printed.clone()).collect::<Vec<String>>()
        };
        let axes: Vec<Vec<String>> = axes.into_iter().flatten().map(headers).collect();
        let missing =
            |axis: &Vec<String>| table.lines.iter().find(|line| !axis.contains(line.get_ref()));
        let wrong: Option<Vec<&Spanned<String>>> = axes.iter().map(missing).collect();
        if let Some(line) = wrong.and_then(|wrong| wrong.into_iter().next()) {
            let known = axes.iter().flatten().map(String::as_str);
            let message = format!(
                "`{}` is not a header of a row{}",
                line.get_ref(),
                did_you_mean(line.get_ref(), known)
            );
            return Err(self.error(line.span(), message).with_help(
                "name rows, or else columns, by their headers as printed; without `lines`, the figure plots the \
                 whole table",
            ));
        }
        let lines = table.lines.iter().map(|line| line.get_ref().clone()).collect();
        Ok(Figure { locus: table.locus.clone(), lines })
    }
}
