//! The verdicts on cells that are not as printed, by readings of the table and by neighbouring
//! cells.

use crate::claim::Cell;
use crate::evaluation::table::Evaluator;
use crate::exact::Decimal;
use crate::finding::{AsRead, CellFinding, Explanation, Slip, Values, Verdict};
use crate::judge::compare;

/// The part of a table that a reading is about.
#[derive(Clone, Copy)]
pub(crate) enum Part {
    /// The whole table, and whether the reading gives half of its cells or more. Otherwise roundings and slips from its
    /// values are no more than luck.
    Table(bool),
    /// A row or column whose values stand so many rows down and columns to the right. The cells
    /// around it have other readings.
    Line((i32, i32)),
}

impl Evaluator<'_> {
    /// Judges the cells that are not as printed by a reading: whether it explains them, or they are
    /// a slip away from its value.
    pub(crate) fn read_as(
        &self,
        reading: &Explanation,
        part: Part,
        cells: &mut [Vec<CellFinding>],
    ) {
        let shift = if let Part::Line(shift) = part { shift } else { (0, 0) };
        for (row, findings) in cells.iter_mut().enumerate() {
            for (column, finding) in findings.iter_mut().enumerate() {
                let Cell::Printed(printed) = &self.table.cells[row][column] else { continue };
                let Some(value) = reading.values[row][column].clone() else { continue };
                let verdict = finding.verdict_if_assumed.as_mut().unwrap_or(&mut finding.verdict);
                let explained = reading.explained[row][column];
                let read = match verdict {
                    Verdict::Refuted if explained && shift != (0, 0) => {
                        Verdict::Misprint(Slip::Neighbour(shift.0, shift.1))
                    }
                    Verdict::Refuted | Verdict::Rounding(_) | Verdict::Misprint(_)
                        if explained && shift == (0, 0) =>
                    {
                        Verdict::OtherReading
                    }
                    Verdict::Refuted if !self.is_depth() && shift == (0, 0) => match part {
                        Part::Table(true) => {
                            self.slip(&printed.decimal, &reading.values, row, column)
                        }
                        Part::Table(false) => continue,
                        Part::Line(_) => compare::judge(&printed.decimal, &value, &[]),
                    },
                    _ => continue,
                };
                let mut rounded = None;
                *verdict = match read {
                    Verdict::OtherReading | Verdict::Misprint(_) => read,
                    Verdict::Rounding(direction) if compare::says_enough(&printed.decimal) => {
                        rounded = Some(direction);
                        Verdict::OtherReading
                    }
                    _ => continue,
                };
                let (differences, solved) = (reading.differences.clone(), reading.solved.clone());
                finding.as_read = Some(AsRead { differences, solved, rounded, value });
            }
        }
    }

    /// The verdict on a cell for these values of the table, including slips that involve its
    /// neighbours.
    fn slip(&self, printed: &Decimal, values: &Values, row: usize, column: usize) -> Verdict {
        let Some(value) = &values[row][column] else { return Verdict::Refuted };
        match self.exchanged(values, row, column) {
            Some(slip) => Verdict::Misprint(slip),
            None => compare::judge(printed, value, &compare::around(values, row, column)),
        }
    }

    /// Numbers that are no depths may have been copied from a neighbouring cell, or
    /// exchanged with one.
    pub(crate) fn compare_with_neighbours(&self, cells: &mut [Vec<CellFinding>]) {
        if self.is_depth() {
            return;
        }
        let values = |counts: fn(&CellFinding) -> bool| -> Values {
            let value = |cell: &CellFinding| cell.exact.clone().filter(|_| counts(cell));
            cells.iter().map(|row| row.iter().map(value).collect()).collect()
        };
        // A cell without assumptions is compared only with neighbours that need none.
        let plain = values(CellFinding::is_plain);
        let all = values(|_| true);
        for (row, findings) in cells.iter_mut().enumerate() {
            for (column, finding) in findings.iter_mut().enumerate() {
                let Cell::Printed(printed) = &self.table.cells[row][column] else { continue };
                let exact = if finding.is_plain() { &plain } else { &all };
                let verdict = finding.verdict_if_assumed.as_mut().unwrap_or(&mut finding.verdict);
                if *verdict == Verdict::Refuted {
                    *verdict = self.slip(&printed.decimal, exact, row, column);
                }
            }
        }
    }

    /// The neighbour that this cell is exchanged with: each prints the other's value.
    fn exchanged(&self, values: &Values, row: usize, column: usize) -> Option<Slip> {
        let printed = |row: usize, column: usize| {
            Some(&self.table.cells.get(row)?.get(column)?.printed()?.decimal)
        };
        let (here, own) = (printed(row, column)?, values.get(row)?.get(column)?.as_ref()?);
        compare::around(values, row, column).into_iter().find_map(|((rows, columns), other)| {
            let (row, column) = compare::moved(row, column, (rows, columns))?;
            compare::exchanged(here, own, printed(row, column)?, other)
                .then_some(Slip::Exchanged(rows, columns))
        })
    }
}
