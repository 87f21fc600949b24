//! Text and tables no wider than the terminal.

use crate::audit::Word;
use crate::diagnostic::wrap::fill;
pub use crate::diagnostic::wrap::{width_of, wrapped};
use crate::report::words::parts::is_mark;
use crate::report::words::sheet::Grid;

/// The width of a column beyond its text, with the separator from the next column.
const AROUND: usize = 3;

/// The most lines by which wrapping may lengthen a row of a table of texts; beyond it, records are
/// easier to read.
const MAX_WRAPPED: usize = 2;

/// A table in a form that fits the width.
pub(crate) enum Fitted {
    /// As tables, one below the other, each with the first column.
    Tables(Vec<Grid>),
    /// As records: for each row its first text, and the other texts with their headers.
    Records(Vec<(String, Vec<(String, String)>)>),
}

/// The words of a line of a cell. A mark is no word of its own: it stays with the next word or, at
/// the end of the line, with the last one.
fn words(line: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let pieces: Vec<&str> = line.split(' ').collect();
    let mut open = false;
    for (i, piece) in pieces.iter().enumerate() {
        let last = i + 1 == pieces.len() && i > 0;
        match words.last_mut() {
            Some(word) if open || (last && is_mark(piece)) => {
                word.push(' ');
                word.push_str(piece);
            }
            _ => words.push((*piece).to_owned()),
        }
        // Within a line `=` is the sign of an equation.
        open = is_mark(piece) && (i == 0 || *piece != Word::Reproduced.mark());
    }
    words
}

impl Grid {
    /// The table in lines of at most `width` characters.
    pub(crate) fn fitted(&self, width: usize) -> Fitted {
        let columns = self.header.len();
        let natural: Vec<usize> = (0..columns).map(|j| self.widest(j, |line| vec![line])).collect();
        let least: Vec<usize> = (0..columns).map(|j| self.widest(j, |line| words(&line))).collect();
        let Some((key, rest)) = least.split_first() else {
            return Fitted::Tables(vec![self.clone()]);
        };
        // The last column needs no separator behind it.
        let room = width + 1;
        if rest.iter().any(|column| key + column + 2 * AROUND > room) || key + AROUND > room {
            return Fitted::Records(self.records());
        }
        // The first column stands in every table, and as many of the others as fit.
        let mut tables = Vec::new();
        let mut chosen = vec![0];
        let mut taken = key + AROUND;
        for (j, column) in least.iter().enumerate().skip(1) {
            // Tables of text are not split: they are read row by row.
            if taken + column + AROUND > room {
                if self.left_columns > 1 {
                    return Fitted::Records(self.records());
                }
                tables.push(std::mem::replace(&mut chosen, vec![0]));
                taken = key + AROUND;
            }
            chosen.push(j);
            taken += column + AROUND;
        }
        tables.push(chosen);
        let of = |chosen: &Vec<usize>| self.narrowed(chosen, &natural, &least, room);
        let tables: Vec<Grid> = tables.iter().map(of).collect();
        let squeezed = tables.iter().any(|table| table.height() > self.height() + MAX_WRAPPED);
        if squeezed && self.left_columns > 1 {
            return Fitted::Records(self.records());
        }
        Fitted::Tables(tables)
    }

    /// The most lines of a row.
    fn height(&self) -> usize {
        let cells = self.rows.iter().flatten();
        cells.map(|cell| cell.split('\n').count()).max().unwrap_or(0)
    }

    /// The widest piece of a column.
    fn widest(&self, column: usize, pieces: impl Fn(String) -> Vec<String>) -> usize {
        let cells = self.rows.iter().filter_map(|row| row.get(column));
        let lines = cells.chain([&self.header[column]]).flat_map(|cell| cell.split('\n'));
        let pieces = lines.flat_map(|line| pieces(line.to_owned()));
        pieces.map(|piece| width_of(&piece)).max().unwrap_or(0)
    }

    /// Some of the columns, the widest of them narrowed until they fit.
    fn narrowed(&self, chosen: &[usize], natural: &[usize], least: &[usize], room: usize) -> Grid {
        let mut widths: Vec<usize> = chosen.iter().map(|&j| natural[j]).collect();
        while widths.iter().sum::<usize>() + AROUND * widths.len() > room {
            let shrinks = |&i: &usize| widths[i] > least[chosen[i]];
            let Some(i) = (0..widths.len()).filter(shrinks).max_by_key(|&i| widths[i]) else {
                break;
            };
            widths[i] -= 1;
        }
        let cell = |text: &String, width: usize| {
            let lines = text.split('\n').flat_map(|line| {
                let words = words(line);
                fill(words.iter().map(String::as_str), width, false)
            });
            lines.collect::<Vec<String>>().join("\n")
        };
        let row = |row: &Vec<String>| {
            let cells = chosen
                .iter()
                .zip(&widths)
                .filter_map(|(&j, width)| Some(cell(row.get(j)?, *width)));
            cells.collect::<Vec<String>>()
        };
        Grid::of(row(&self.header), self.rows.iter().map(row), self.left_columns.min(chosen.len()))
    }

    fn records(&self) -> Vec<(String, Vec<(String, String)>)> {
        let one_line = |text: &String| text.replace('\n', " ");
        let record = |row: &Vec<String>| {
            let fields = self.header.iter().zip(row).skip(1);
            let fields = fields.map(|(name, value)| (one_line(name), value.clone())).collect();
            (row.first().map(one_line).unwrap_or_default(), fields)
        };
        self.rows.iter().map(record).collect()
    }
}
