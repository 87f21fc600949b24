//! Rows and columns that have a reading of their own, where none explains the whole
//! table.

use crate::exact::Integer;
use crate::finding::{Explanation, Line, LineReading, Values};
use crate::judge::compare;
use crate::judge::reading::chance::{BothEvidence, is_small};
use crate::judge::reading::space::ReadingSpace;
use crate::judge::reading::tried::{self, Evaluated, Part, best};

/// Where the values of a cell may stand by mistake: in the cell, or how many rows
/// down and columns to the right of it.
const SHIFTS: [(i32, i32); 5] = [(0, 0), (0, 1), (0, -1), (1, 0), (-1, 0)];

/// The most cells of a table whose rows and columns are compared one by one.
const MAX_CELLS: usize = 400;

/// The most rows and columns that have readings of their own.
const MAX_LINES: usize = 8;

/// The cells of a table, by row.
type Cells = Vec<Vec<bool>>;

/// Readings for the cells that are `left`, each for one row or column: first the reading that
/// explains most of them, then others for what it leaves. Luck is counted over all rows, columns,
/// shifts and readings, and over `values`, the number of candidates for recovered parameters.
pub(crate) fn search(
    space: &ReadingSpace<'_>,
    parts: &[Part<'_>],
    mut left: Cells,
    values: &Integer,
) -> Vec<LineReading> {
    let rows = left.len();
    let columns = left.iter().map(Vec::len).max().unwrap_or(0);
    // A table of one row or one column was searched as a whole.
    let lines = |count: usize, line: fn(usize) -> Line| {
        let several = rows > 1 && columns > 1 && rows * columns <= MAX_CELLS;
        (0..if several { count } else { 0 }).map(line)
    };
    let lines: Vec<Line> = lines(rows, Line::Row).chain(lines(columns, Line::Column)).collect();
    let mut found = Vec::new();
    while found.len() < MAX_LINES {
        let sizes = (lines.len(), values);
        let readings = lines.iter().filter_map(|&line| one(space, parts, &left, line, sizes));
        // Of equally good ones the first: rows before columns.
        let best = readings.fold(None, |best: Option<LineReading>, next| match best {
            Some(best) if best.best.count() >= next.best.count() => Some(best),
            _ => Some(next),
        });
        let Some(reading) = best else { break };
        for (row, cells) in left.iter_mut().enumerate() {
            for (column, cell) in cells.iter_mut().enumerate() {
                *cell &= !reading.best.explained[row][column];
            }
        }
        found.push(reading);
    }
    found
}

/// The best reading of the cells that are left in a line, unless it may be luck.
fn one(
    space: &ReadingSpace<'_>,
    parts: &[Part<'_>],
    left: &Cells,
    line: Line,
    (lines, recovered): (usize, &Integer),
) -> Option<LineReading> {
    let inside = |row: usize, column: usize| left[row][column] && line.holds(row, column);
    let both = BothEvidence::new(space, inside);
    let of_line = both.of(None);
    let cells = of_line.cells();
    let factor = Integer::from(tried::parts(space.judge.paper) * SHIFTS.len() * lines) * recovered;
    let least = Integer::from(parts.first()?.all.len()) * &factor;
    // If explaining all of these cells would still be luck, no reading is searched.
    if !of_line.are_several(cells) || !is_small(&of_line.chance(cells, &least)) {
        return None;
    }
    let mut found = None::<LineReading>;
    for Part { all, tried } in parts {
        for shift in SHIFTS {
            let values = |one: &Evaluated| shifted(&one.values, shift, &inside);
            let explanations: Vec<Explanation> = space.explanations(all, values).collect();
            // A reading that brings no constant needs less to be no luck.
            for candidates in [&explanations, &tried::by_choices(&explanations)] {
                let Some(best) = best(candidates).into_iter().next() else { continue };
                let (of_line, known) = (both.of(Some(&best)), found.as_ref());
                let known = known.map_or(0, |found| found.best.count());
                if best.count() <= known || !of_line.are_several(best.count()) {
                    continue;
                }
                let chance = of_line.chance(best.count(), &(Integer::from(*tried) * &factor));
                if is_small(&chance) {
                    let tried = tried * SHIFTS.len() * lines;
                    let needs = space.needs(&explanations);
                    found = Some(LineReading { line, cells, shift, tried, best, chance, needs });
                }
            }
        }
    }
    found
}

/// The values of the cells `inside`, taken from the cells that are so many rows down
/// and columns to the right.
fn shifted(values: &Values, shift: (i32, i32), inside: &impl Fn(usize, usize) -> bool) -> Values {
    let from = |row: usize, column: usize| {
        let (row, column) = compare::moved(row, column, shift)?;
        values.get(row)?.get(column)?.clone()
    };
    let row = |(row, cells): (usize, &Vec<_>)| {
        let cell = |column| inside(row, column).then(|| from(row, column)).flatten();
        (0..cells.len()).map(cell).collect()
    };
    values.iter().enumerate().map(row).collect()
}
