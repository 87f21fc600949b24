//! The rule `read`: the readings of a table and of its rows and columns.

use super::claim::{Place, Read, Table};
use super::copied::Copied;
use crate::formulas::{CHOICES, formula};
use crate::numbers::Value;
use crate::text::{Block, Checked, Reason, Stop, Toml, require};
use std::collections::BTreeSet;
use std::rc::Rc;

/// The most choices and definitions in which a reading differs from the printed text.
pub const MAX_DIFFERENCES: usize = 4;

/// Reads the lines `read …`; gives `None` if there are none.
fn read(table: &Table<'_>, block: &mut Block<'_>) -> Checked<Option<Read>> {
    let (mut read, mut found, mut differences) = (Read::default(), false, 0);
    let mut defined = BTreeSet::new();
    while let Some(said) = block.maybe("read") {
        found = true;
        match said.split_whitespace().collect::<Vec<&str>>()[..] {
            ["choice", name, way] => choose(&mut read, name, way)?,
            ["definition", name, number] => {
                require(defined.insert(name), Reason::NotInFamily(name.to_owned()))?;
                define(table, &mut read, name, number)?;
            }
            ["copied", what] => {
                let known = Copied::read(what).is_some() && read.copied().is_none();
                require(known, Reason::NotInFamily(what.to_owned()))?;
                read.differences.insert(what.to_owned());
            }
            ["parameter", name, value] => {
                let known = table.given.contains_key(name);
                let value = table.paper.number(value)?;
                let twice = read.parameters.insert(name.to_owned(), value).is_some();
                require(known && !twice, Reason::NotInFamily(name.to_owned()))?;
                continue;
            }
            _ => return Err(Reason::Malformed("choice, definition, copied or parameter").into()),
        }
        differences += 1;
        require(differences <= MAX_DIFFERENCES, Reason::Differences)?;
    }
    Ok(found.then_some(read))
}

/// The reading of a table, or of a row or a column.
pub struct PartRead {
    /// The name, such as `row 2` or `column 1 from 0 1`. That of the table is empty.
    name: String,
    /// 0 for a row or 1 for a column, and the number, counted from 0.
    line: Option<(usize, usize)>,
    /// How many rows down and columns to the right the values stand.
    shift: (isize, isize),
    /// Whether it is about cells that need no assumptions, or about those that do.
    pub plain: bool,
    /// The reading.
    pub read: Read,
}

impl PartRead {
    /// Whether the reading applies to a cell.
    pub fn holds(&self, table: &Table<'_>, place: Place) -> bool {
        self.line.is_none_or(|(axis, number)| [place.0, place.1][axis] == number)
            && table.is_plain(place) == self.plain
    }

    /// The value that should be in a cell. If the reading is shifted, it is that of another cell.
    pub fn value(&self, table: &Table<'_>, place: Place) -> Result<Option<Value>, Stop> {
        let moved = table.moved(place, self.shift);
        let moved = moved.filter(|place| table.is_plain(*place) == self.plain);
        moved.map_or(Ok(None), |place| table.read(place, &self.read))
    }

    /// Whether the reading applies to the whole table.
    pub fn is_whole(&self) -> bool {
        self.line.is_none()
    }

    /// The slip that a shifted reading means.
    pub fn slip(&self) -> Option<String> {
        let (down, right) = self.shift;
        (self.shift != (0, 0)).then(|| format!("neighbour {down} {right}"))
    }
}

/// The readings of a table and of some of its rows and columns.
pub struct Reads(Vec<PartRead>);

impl Reads {
    /// Reads the lines `read …` of a table, and the lines under `row N` and `column N`. After a
    /// line `assumed` they are about the cells that need assumptions.
    pub fn new(table: &Table<'_>, block: &mut Block<'_>) -> Checked<Reads> {
        let [plain, assumed] = [true, false].map(|plain| !table.cells(plain).is_empty());
        let mut reads = Reads::of_cells(table, block, plain)?;
        if plain && block.maybe("assumed").is_some() {
            require(assumed, Reason::Malformed("cells that need assumptions"))?;
            reads.0.extend(Reads::of_cells(table, block, false)?.0);
        }
        Ok(reads)
    }

    /// Reads the readings of the plain cells, or of those that need assumptions.
    fn of_cells(table: &Table<'_>, block: &mut Block<'_>, plain: bool) -> Checked<Reads> {
        let whole = |read| PartRead { name: String::new(), line: None, shift: (0, 0), plain, read };
        let mut reads: Vec<PartRead> = read(table, block)?.map(whole).into_iter().collect();
        let (rows, columns) = table.size();
        while let Some((word @ ("row" | "column"), said)) = block.peek().map(|line| line.word()) {
            block.any()?;
            let axis = usize::from(word == "column");
            let (number, shift) = said.split_once(" from ").unwrap_or((said, "0 0"));
            let number = number.parse().ok().filter(|i| (1..=[rows, columns][axis]).contains(i));
            let number: usize = number.ok_or(Reason::Malformed("a row or column"))?;
            let shifts = [(0, 0), (0, 1), (0, -1), (1, 0), (-1, 0)].into_iter();
            let shift = shifts.into_iter().find(|(down, right)| format!("{down} {right}") == shift);
            let shift = shift.ok_or(Reason::Malformed("a cell next to it"))?;
            let name = format!("{word} {said}");
            let twice = reads.iter().any(|known| known.name == name);
            require(!twice, Reason::Malformed("another row or column"))?;
            let read = read(table, block)?;
            require(read.is_some() || shift != (0, 0), Reason::NoReading)?;
            let (line, read) = (Some((axis, number - 1)), read.unwrap_or_default());
            reads.push(PartRead { name, line, shift, plain, read });
        }
        Ok(Reads(reads))
    }

    /// Every reading of the plain cells, or of those that need assumptions. That of the table is
    /// the first.
    pub fn all(&self, plain: bool) -> impl Iterator<Item = &PartRead> {
        self.0.iter().filter(move |part| part.plain == plain)
    }

    /// Every reading that applies to a cell.
    pub fn of(&self, table: &Table<'_>, place: Place) -> impl Iterator<Item = &PartRead> {
        self.0.iter().filter(move |part| part.holds(table, place))
    }

    /// The reading with a name that applies to a cell.
    pub fn by(&self, table: &Table<'_>, place: Place, name: &str) -> Option<&PartRead> {
        self.of(table, place).find(|part| part.name == name)
    }
}

/// Chooses a way in a reading.
pub fn choose(read: &mut Read, name: &str, way: &str) -> Checked<()> {
    let known = CHOICES.iter().any(|choice| choice.name == name && choice.ways.contains(&way));
    let twice = read.reading.words.insert(name.to_owned(), way.to_owned()).is_some();
    if name != "decimals" {
        read.differences.insert(format!("{name}={way}"));
    }
    require(known && !twice, Reason::NotInFamily(format!("{name} {way}")))
}

/// Replaces a definition by its alternative of this number, counted from 1.
pub fn define(table: &Table<'_>, read: &mut Read, name: &str, number: &str) -> Checked<()> {
    let unknown = || Reason::NotInFamily(format!("{name} {number}"));
    let of = |other: &&Toml| other.text("of") == Some(name);
    let mut others = table.paper.file.list("alternative").iter().filter(of);
    let place = number.parse::<usize>().ok().and_then(|number| number.checked_sub(1));
    let other = place.and_then(|place| others.nth(place)).ok_or_else(unknown)?;
    let value = Rc::new(formula(other.text("value").unwrap_or(""))?);
    read.differences.insert(format!("{name}#{number}"));
    let definitions = read.definitions.get_or_insert_with(|| table.paper.definitions.clone());
    require(definitions.insert(name.to_owned(), value).is_some(), unknown())
}
