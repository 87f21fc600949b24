//! A table of a claim file, and the values of its cells.

use super::copied::Copied;
use crate::claims::{Headers, Paper, printed};
use crate::formulas::{Definitions, Expr, Memory, Reading, Scope, formula_of};
use crate::numbers::{Decimal, Q, Value, interval, is_blank};
use crate::schemes::{Scheme, names};
use crate::text::{Checked, Reason, Stop, Toml};
use num_traits::Signed;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// A table.
pub struct Table<'a> {
    /// The paper.
    pub paper: &'a Paper<'a>,
    /// The claim.
    pub claim: &'a Toml,
    /// The formula that every cell should equal.
    pub value: Expr,
    /// The headers of the rows, if there are any, and of the columns.
    pub axes: [Option<Headers<'a>>; 2],
    /// The parameters that are stated.
    pub given: BTreeMap<String, Value>,
    /// The parameters that are not stated.
    pub unstated: BTreeSet<String>,
    /// The values of unstated parameters that may be assumed, or that were recovered.
    pub assumed: BTreeMap<String, Value>,
    /// For each recovered parameter, the number of candidates for its value, and whether the
    /// numbers of this table give it.
    pub recovered: BTreeMap<String, (Q, bool)>,
    /// The name of the tolerance, if the cells are depths.
    pub tolerance: Option<&'a str>,
    /// The reading of the table as printed.
    pub as_printed: Read,
    known: RefCell<BTreeMap<Place, Needed>>,
    /// The upper bounds of constants that are known.
    pub bounds: RefCell<Bounds>,
}

/// Upper bounds of the constants of all levels, by schemes and the number of computed levels.
pub type Bounds = BTreeMap<(Vec<usize>, i64), Vec<Value>>;

/// The row and the column of a cell, counted from 0.
pub type Place = (usize, usize);

/// Printed cells, with their places.
pub type Cells = Vec<(Place, Decimal)>;

/// The scope of a cell, and the factors of its scheme.
pub type Scoped<'s> = (Scope<'s>, Vec<Rc<Scheme>>);

/// A cell under a reading, with the unstated parameters that are assumed.
#[derive(Clone, Copy)]
pub struct Asked<'s, 'b> {
    /// The cell.
    pub at: Place,
    /// The reading.
    pub read: &'s Read,
    /// The parameters.
    pub assumed: &'b BTreeSet<String>,
}

/// Quantities that replace those of a cell.
#[derive(Default)]
pub struct Instead<'i> {
    /// The values of parameters.
    pub values: BTreeMap<String, Value>,
    /// The scheme.
    pub scheme: Option<&'i str>,
}

/// The parameters that a cell needs, and its value.
type Needed = (BTreeSet<String>, Result<Value, Stop>);

/// A way to read a table.
#[derive(Default)]
pub struct Read {
    /// The choices.
    pub reading: Reading,
    /// The definitions, when some are replaced.
    pub definitions: Option<Definitions>,
    /// Parameters with other values.
    pub parameters: BTreeMap<String, Value>,
    /// The choices `NAME=WAY`, except for decimals, the definitions `NAME#NUMBER`, and what is taken
    /// from another place, such as `NAME@TABLE`.
    pub differences: BTreeSet<String>,
    /// The values of cells that are known.
    known: RefCell<BTreeMap<Place, Option<Value>>>,
    /// The values of definitions that are known.
    memory: Rc<Memory>,
}

impl Read {
    /// The quantity that is taken from another place of the paper.
    pub fn copied(&self) -> Option<&str> {
        self.differences.iter().map(String::as_str).find(|difference| difference.contains('@'))
    }

    /// The way in which decimals are rounded.
    pub fn decimals(&self) -> &str {
        self.reading.words.get("decimals").map_or("nearest", String::as_str)
    }
}

impl<'a> Table<'a> {
    /// Reads a table.
    pub fn new(paper: &'a Paper<'a>, claim: &'a Toml) -> Result<Table<'a>, Stop> {
        let columns = claim.get("columns").ok_or(Stop::Wrong("`columns` is missing".into()))?;
        let rows = claim.get("rows").map(Headers::read).transpose()?;
        let assumed = paper.constants(claim.entries("unstated"))?;
        let open = claim.texts("unstated").map(str::to_owned);
        let unstated: BTreeSet<String> = assumed.keys().cloned().chain(open).collect();
        let mut given = paper.given.clone();
        given.extend(paper.constants(claim.entries("given"))?);
        let axes = [rows, Some(Headers::read(columns)?)];
        let named = axes.iter().flatten().filter_map(Headers::axis).map(|axis| axis.name);
        let header = |name: &str| named.clone().any(|known| known == name);
        given.retain(|name, _| !unstated.contains(name) && !header(name));
        let promise = claim.get("promise");
        let table = Table {
            paper,
            claim,
            value: formula_of(claim, "value")?,
            axes,
            given,
            unstated,
            assumed,
            recovered: BTreeMap::new(),
            tolerance: promise.and_then(|promise| promise.text("tolerance")).map(str::trim),
            as_printed: Read::default(),
            known: RefCell::default(),
            bounds: RefCell::default(),
        };
        let of_axes = table.axes.iter().flatten().filter(|axis| !axis.schemes().is_empty());
        if of_axes.count() + usize::from(claim.get("scheme").is_some()) > 1 {
            return Err(Stop::Wrong("its cells have two schemes".into()));
        }
        let (rows, columns) = table.size();
        let cells = claim.list("cells");
        let even = cells.len() == rows && cells.iter().all(|row| row.as_list().len() == columns);
        if claim.text("cells") == Some("lost") {
            return Ok(table);
        }
        let printed = |place: Place| {
            let text = table.text(place).map_or("", |(text, _)| text);
            table.is_blank(place) || table.printed(place).is_some() && !is_blank(text)
        };
        let printed = even && table.places().all(printed);
        let why = "the numbers of cells and headers differ, or a cell is no number";
        printed.then_some(table).ok_or_else(|| Stop::Wrong(why.into()))
    }

    /// The number of rows and columns.
    pub fn size(&self) -> (usize, usize) {
        let count = |axis: &Option<Headers>| axis.as_ref().map_or(1, Headers::count);
        (count(&self.axes[0]), count(&self.axes[1]))
    }

    /// Every cell, row by row.
    pub fn places(&self) -> impl Iterator<Item = Place> + use<> {
        let (rows, columns) = self.size();
        (0..rows).flat_map(move |row| (0..columns).map(move |column| (row, column)))
    }

    /// The place that is so many rows down and columns to the right, if there is one.
    pub fn moved(&self, (row, column): Place, (down, right): (isize, isize)) -> Option<Place> {
        let (rows, columns) = self.size();
        let row = row.checked_add_signed(down).filter(|row| *row < rows)?;
        Some((row, column.checked_add_signed(right).filter(|column| *column < columns)?))
    }

    /// The place of a cell that a line begins with, and what follows.
    pub fn place<'l>(&self, said: &'l str) -> Checked<(Place, &'l str)> {
        let mut words = said.splitn(3, ' ');
        let mut next = |count: usize| {
            let place: usize = words.next()?.parse().ok()?;
            place.checked_sub(1).filter(|place| *place < count)
        };
        let (rows, columns) = self.size();
        let place = next(rows).and_then(|row| Some((row, next(columns)?)));
        Ok((place.ok_or(Reason::Cell)?, words.next().unwrap_or_default()))
    }

    /// A cell as printed and as a number; `None` if it is lost, blank or no number.
    pub fn printed(&self, place: Place) -> Option<(&'a str, Decimal)> {
        let (text, read) = self.text(place)?;
        let decimal = Decimal::printed(read)?;
        Some((text, if self.tolerance.is_some() { decimal.whole() } else { decimal }))
    }

    /// Whether nothing is printed in a cell.
    pub fn is_blank(&self, place: Place) -> bool {
        self.text(place).is_some_and(|(_, read)| is_blank(read))
    }

    fn text(&self, (row, column): Place) -> Option<(&'a str, &'a str)> {
        printed(self.claim.list("cells").get(row)?.as_list().get(column)?)
    }

    /// The reference to the scheme of a cell: the header of its row or of its column, or the
    /// table's.
    pub fn scheme(&self, (row, column): Place) -> Option<&'a str> {
        let of = |axis: &Option<Headers<'a>>, place: usize| {
            axis.as_ref().and_then(|axis| axis.schemes().get(place).copied())
        };
        let headers = of(&self.axes[0], row).or_else(|| of(&self.axes[1], column));
        headers.or_else(|| self.claim.text("scheme"))
    }

    /// Every reference to a scheme of a cell.
    pub fn schemes(&self) -> Vec<&'a str> {
        let headers = self.axes.iter().flatten().flat_map(|axis| axis.schemes().iter().copied());
        self.claim.text("scheme").into_iter().chain(headers).collect()
    }

    /// Whether the table, or a `use` of the file, names a scheme whose mask is in the file without an offset.
    pub fn leaves_offset_out(&self) -> bool {
        let schemes = self.paper.file.list("scheme");
        let uses = schemes.iter().filter_map(|scheme| scheme.text("use"));
        let named: BTreeSet<&str> =
            self.schemes().into_iter().chain(uses).flat_map(names).collect();
        schemes.iter().any(|scheme| {
            let has = |key: &str| scheme.get(key).is_some();
            // A mask in one text has its offset.
            let listed = !scheme.list("mask").is_empty();
            let mask = (listed || has("entry")) && !has("offset");
            mask && scheme.text("name").is_some_and(|name| named.contains(name))
        })
    }

    /// The scope of a cell under some assumed parameters, and the factors of its scheme.
    pub fn scope<'s>(
        &'s self,
        at: Place,
        read: &'s Read,
        assumed: &BTreeSet<String>,
    ) -> Result<Scoped<'s>, Stop> {
        let asked = Asked { at, read, assumed };
        let Some(text) = read.copied() else { return self.own_scope(asked, &Instead::default()) };
        match Copied::read(text) {
            Some(copied) => self.scope_with(&copied, asked),
            None => Err(Stop::Wrong(format!("`{text}` is no quantity of another place"))),
        }
    }

    /// As [`Table::scope`], but nothing is taken from another place, and `instead` replaces
    /// quantities of the cell.
    pub fn own_scope<'s>(
        &'s self,
        Asked { at, read, assumed }: Asked<'s, '_>,
        instead: &Instead<'_>,
    ) -> Result<Scoped<'s>, Stop> {
        let definitions = read.definitions.as_ref().unwrap_or(&self.paper.definitions);
        let mut scope = Scope::new(definitions, self.paper.library, &read.reading);
        scope.memory = Rc::clone(&read.memory);
        scope.beyond.clone_from(&self.paper.beyond);
        let known = self.assumed.iter().filter(|(name, _)| assumed.contains(*name));
        for (name, value) in self.given.iter().chain(known) {
            let value = read.parameters.get(name).unwrap_or(value);
            scope.values.insert(name.clone(), value.clone());
        }
        let missing = self.unstated.iter().filter(|name| !scope.values.contains_key(*name));
        scope.unstated = missing.cloned().collect();
        for (axis, place) in self.axes.iter().zip([at.0, at.1]) {
            let Some(axis) = axis.as_ref().and_then(Headers::axis) else { continue };
            let (text, value) = &axis.entries[place];
            let value = match (read.reading.words.get("tolerance"), Decimal::read(text)) {
                (Some(word), Some(decimal)) if self.tolerance == Some(axis.name) => {
                    // The interval extends by half a unit of the last place to either side.
                    let (low, high) = interval(&decimal, "nearest");
                    let (low, high) = if value.is_negative() { (-high, -low) } else { (low, high) };
                    if word == "less" { low } else { high }
                }
                _ => value.clone(),
            };
            scope.values.insert(axis.name.to_owned(), value.into());
        }
        scope.values.extend(instead.values.clone());
        let mut schemes = Vec::new();
        if let Some(reference) = instead.scheme.or_else(|| self.scheme(at)) {
            schemes = self.paper.library.resolve(reference, &scope)?;
        }
        scope.scheme = schemes.first().cloned();
        Ok((scope, schemes))
    }

    /// The parameters that have to be assumed for a cell, and its value as printed. The evaluation
    /// finds the parameters one by one.
    pub fn needed(&self, at: Place) -> Needed {
        if let Some(known) = self.known.borrow().get(&at) {
            return known.clone();
        }
        let mut assumed = BTreeSet::new();
        let value = loop {
            let scope = self.scope(at, &self.as_printed, &assumed);
            match scope.and_then(|(scope, _)| scope.value(&self.value)) {
                Err(Stop::Unstated(name)) if assumed.insert(name.clone()) => {}
                value => break value,
            }
        };
        self.known.borrow_mut().insert(at, (assumed.clone(), value.clone()));
        (assumed, value)
    }

    /// Whether a cell needs no assumption.
    pub fn is_plain(&self, at: Place) -> bool {
        self.needed(at).0.is_empty()
    }

    /// The printed cells that need no assumption, or, if not `plain`, those that do.
    pub fn cells(&self, plain: bool) -> Cells {
        let places = self.places().filter(|at| self.is_plain(*at) == plain);
        places.filter_map(|at| Some((at, self.printed(at)?.1))).collect()
    }

    /// The recovered parameters that the table's own numbers give.
    pub fn own(&self) -> impl Iterator<Item = &String> {
        self.recovered.iter().filter(|(_, (_, own))| *own).map(|(name, _)| name)
    }

    /// Whether a reading is that of this table as printed.
    pub fn is_as_printed(&self, read: &Read) -> bool {
        std::ptr::eq(read, &raw const self.as_printed)
    }

    /// The value of a cell under a reading; `None` if it has none. The parameters that the cell
    /// needs as printed are assumed.
    pub fn read(&self, at: Place, read: &Read) -> Result<Option<Value>, Stop> {
        if let Some(known) = read.known.borrow().get(&at) {
            return Ok(known.clone());
        }
        let (assumed, as_printed) = self.needed(at);
        let value = if self.is_as_printed(read) {
            as_printed
        } else {
            let scope = self.scope(at, read, &assumed);
            scope.and_then(|(scope, _)| scope.value(&self.value))
        };
        let value = match value {
            Err(stop @ (Stop::Capped(_) | Stop::Wrong(_) | Stop::OtherRoot)) => return Err(stop),
            value => value.ok(),
        };
        read.known.borrow_mut().insert(at, value.clone());
        Ok(value)
    }
}
