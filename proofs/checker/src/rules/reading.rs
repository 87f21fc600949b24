//! Rule `read`: the reading of a table, a member of the declared family.

use crate::certificate::{Block, Line};
use crate::reading::choice;
use crate::reject::{Checked, Reason};
use crate::scheme::formula;
use crate::table::{Read, Table};
use crate::toml::Toml;
use std::rc::Rc;

/// The most choices and definitions that are other than printed.
pub const MAX_DIFFERENCES: usize = 4;

/// The lines `read …` of a table; `None` when there are none.
fn read(table: &Table<'_>, block: &mut Block<'_>) -> Checked<Option<Read>> {
    let (mut read, mut found, mut differences) = (Read::default(), false, 0);
    while let Some((line, said)) = block.optional("read") {
        found = true;
        match said.split_whitespace().collect::<Vec<&str>>()[..] {
            ["choice", name, way] => {
                differences += 1;
                choose(&mut read, line, name, way)?;
            }
            ["definition", name, number] => {
                differences += 1;
                define(table, &mut read, line, name, number)?;
            }
            ["parameter", name, value] => {
                let known = table.given.contains_key(name) || table.unstated.contains_key(name);
                let value = table.paper.closed(line, value)?;
                if !known || read.parameters.insert(name.to_owned(), value).is_some() {
                    return Err(line.reject(Reason::NotInFamily(name.to_owned())));
                }
            }
            _ => return Err(line.reject(Reason::Malformed("choice, definition or parameter"))),
        }
        if differences > MAX_DIFFERENCES {
            return Err(line.reject(Reason::Differences));
        }
    }
    Ok(found.then_some(read))
}

/// How a table is read, and how some rows and columns are.
pub struct Reads {
    /// The whole table, if it is not as printed.
    pub table: Option<Read>,
    /// `row N` or `column N`, and the reading.
    lines: Vec<(String, Read)>,
}

impl Reads {
    /// Reads the lines `read …` of a table, and those under `row N` and `column N`.
    pub fn new(table: &Table<'_>, block: &mut Block<'_>) -> Checked<Reads> {
        let mut reads = Reads { table: read(table, block)?, lines: Vec::new() };
        while let Some(line) =
            block.peek().filter(|line| ["row", "column"].contains(&line.word().0))
        {
            block.optional(line.word().0);
            let (rows, columns) = table.size();
            let most = if line.word().0 == "row" { rows } else { columns };
            let number = line.word().1.parse().ok().filter(|number| (1..=most).contains(number));
            let name = number.map(|number: usize| format!("{} {number}", line.word().0));
            let name = name.ok_or(line.reject(Reason::Malformed("a row or column")))?;
            let read = read(table, block)?.ok_or(line.reject(Reason::NoReading))?;
            if self::of(&reads.lines, &name).is_some() {
                return Err(line.reject(Reason::Malformed("another row or column")));
            }
            reads.lines.push((name, read));
        }
        Ok(reads)
    }

    /// The reading of a row or column of a cell.
    pub fn by(&self, place: (usize, usize), name: &str) -> Option<&Read> {
        let own = [format!("row {}", place.0 + 1), format!("column {}", place.1 + 1)];
        of(&self.lines, name).filter(|_| own.iter().any(|own| own == name))
    }

    /// Every reading that is given for a cell.
    pub fn of(&self, place: (usize, usize)) -> impl Iterator<Item = &Read> {
        let lines = self.lines.iter().filter_map(move |(name, _)| self.by(place, name));
        self.table.iter().chain(lines)
    }
}

fn of<'r>(lines: &'r [(String, Read)], name: &str) -> Option<&'r Read> {
    lines.iter().find(|(known, _)| known == name).map(|(_, read)| read)
}

/// Chooses a way.
pub fn choose(read: &mut Read, line: Line<'_>, name: &str, way: &str) -> Checked<()> {
    let known = choice(name).is_some_and(|choice| choice.ways.contains(&way));
    if !known || read.reading.words.insert(name.to_owned(), way.to_owned()).is_some() {
        return Err(line.reject(Reason::NotInFamily(format!("{name} {way}"))));
    }
    Ok(())
}

/// Puts the alternative of this number, counted from 1 among those of the definition, in
/// place of the definition.
pub fn define(
    table: &Table<'_>,
    read: &mut Read,
    line: Line<'_>,
    name: &str,
    number: &str,
) -> Checked<()> {
    let unknown = || line.reject(Reason::NotInFamily(format!("{name} {number}")));
    let of = |other: &&Toml| other.text("of") == Some(name);
    let mut others = table.paper.file.list("alternative").iter().filter(of);
    let place = number.parse::<usize>().ok().and_then(|number| number.checked_sub(1));
    let other = place.and_then(|place| others.nth(place)).ok_or_else(unknown)?;
    let value = formula(other.text("value").unwrap_or(""));
    let value = value.map_err(|stop| line.reject(Reason::Stopped(stop)))?;
    let definitions = read.definitions.get_or_insert_with(|| table.paper.definitions.clone());
    let defined = definitions.insert(name.to_owned(), Rc::new(value)).is_some();
    if defined { Ok(()) } else { Err(unknown()) }
}
