//! Masks on Z^d from the tables of a claim file.

#![warn(clippy::arithmetic_side_effects)]

use super::dilation::Dilation;
use super::fields::{VARIABLES, dimension, is_lattice};
use super::mask::Lattice;
use super::vectors::{Vector, plus, vector, vectors, within};
use super::{boxes, lists};
use crate::formulas::{Indices, MAX_INTEGER, Scope, formula, formulas};
use crate::numbers::Value;
use crate::schemes::laurent::{Laurent, sum};
use crate::schemes::library::{Entry, Library, wrong};
use crate::schemes::symbol::{Expansion, Other};
use crate::schemes::typed::with_factors;
use crate::text::{Stop, Toml};
use std::cell::Cell;
use std::rc::Rc;

/// What gives d integers for each of a field.
const INTEGERS: &str =
    "the integers of `dilation`, `edges`, `origin` or `box` are not as many as the dimensions";

impl Library<'_> {
    /// Whether a reference names a mask on Z^d.
    pub fn is_lattice(&self, reference: &str) -> bool {
        self.behind(reference).is_some_and(is_lattice)
    }

    /// The mask on Z^d that a reference names.
    pub fn lattice(&self, reference: &str, scope: &Scope<'_>) -> Result<Rc<Lattice>, Stop> {
        let (name, table, parameters) = self.entry(reference, scope)?;
        if !is_lattice(table) {
            return wrong(name, "it is no mask on Z^d");
        }
        let parameters = self.complete(name, table, parameters)?;
        let key = format!("{name} {parameters:?}");
        if let Some(known) = self.lattices.borrow().get(&key) {
            return Ok(Rc::clone(known));
        }
        let longest = Cell::new(0);
        let lattice = self.of_fields((name, table, parameters), &longest)?;
        let lattice = Rc::new(lattice);
        self.composed.borrow_mut().insert(Rc::as_ptr(&lattice).cast(), longest.get());
        self.lattices.borrow_mut().insert(key, Rc::clone(&lattice));
        Ok(lattice)
    }

    fn of_fields(
        &self,
        (name, table, parameters): Entry<'_>,
        longest: &Cell<usize>,
    ) -> Result<Lattice, Stop> {
        let d = dimension(table)?;
        let read = |key: &str| {
            let found = table.get(key).map(|list| vectors(list.as_list(), d));
            found.map_or(Ok(None), |found| {
                found.map_or_else(|| wrong(name, INTEGERS), |it| Ok(Some(it)))
            })
        };
        let double = || (0..d).map(|i| [0, 1, 2].map(|j| if i == j { 2 } else { 0 })).collect();
        let dilation = Dilation::new(&read("dilation")?.unwrap_or_else(double))?;
        let definitions = formulas(table.entries("let"))?;
        let mut scope = self.scope(&definitions);
        scope.values = parameters;
        let mask = match (table.text("symbol"), read("box")?) {
            (Some(text), _) => self.of_symbol((name, text), &scope, d, longest)?,
            (None, Some(directions)) => boxes::symbol(self.meter, &dilation, &directions)?,
            (None, None) => of_lists((name, table), &scope, d)?,
        };
        Lattice::new(dilation, read("edges")?, mask)
    }

    /// The symbol in d variables that a formula is.
    fn of_symbol(
        &self,
        (name, text): (&str, &str),
        scope: &Scope<'_>,
        d: usize,
        longest: &Cell<usize>,
    ) -> Result<Laurent<Vector>, Stop> {
        let other = |other: &str, with: Indices| {
            self.other((name, other), with, longest, &|reference, scope| {
                if !self.is_lattice(reference) {
                    return self.curve(reference, scope);
                }
                let lattice = self.lattice(reference, scope)?;
                if lattice.dilation.d != d {
                    return wrong(reference, "its dimension is another one");
                }
                Ok((Other::Whole(lattice.mask.clone()), Rc::as_ptr(&lattice).cast()))
            })
        };
        let variables = VARIABLES.get(..d).unwrap_or(&VARIABLES);
        let expansion = Expansion { scope, variables, others: &other };
        expansion.of(&formula(text)?, &mut Vec::new(), 0)
    }
}

/// The mask of lists of lists.
fn of_lists(
    (name, table): (&str, &Toml),
    scope: &Scope<'_>,
    d: usize,
) -> Result<Laurent<Vector>, Stop> {
    let ([before, behind], entries) = match table.text("mask") {
        Some(text) => lists::lists(text, d)?,
        None if d == 2 => ([""; 2], rows(name, table.list("mask"))?),
        None => return wrong(name, "a mask in three dimensions stands in one text"),
    };
    let greatest = |i: usize| entries.iter().map(|(index, _)| index[i]).max().unwrap_or(0);
    let middle = [0, 1, 2].map(|i| greatest(i).checked_div(2).unwrap_or(0));
    let origin = match table.get("origin") {
        Some(origin) => vector(origin.as_list(), d).map_or_else(|| wrong(name, INTEGERS), Ok)?,
        None => middle,
    };
    if !within(&[origin], MAX_INTEGER.unsigned_abs()) {
        return Err(Stop::Capped("the size of an integer"));
    }
    let mut terms: Vec<(Vector, Value)> = Vec::new();
    for (index, piece) in entries {
        let text = with_factors(before, piece, behind);
        scope.spend(text.len() as u64 / 16)?;
        let a = scope.value(&formula(&text)?)?;
        // Where nothing stands, no place is too far away.
        if !a.is_zero() {
            terms.push((plus(index, -1, origin)?, a));
        }
    }
    sum(terms)
}

/// The entries of rows of texts.
fn rows<'t>(name: &str, rows: &'t [Toml]) -> Result<Vec<(Vector, &'t str)>, Stop> {
    let length = rows.first().map_or(0, |row| row.as_list().len());
    if length == 0 || rows.iter().any(|row| row.as_list().len() != length) {
        return wrong(name, "the lengths of its rows are wrong");
    }
    let row = |(i, row): (i64, &'t Toml)| {
        let entry = move |(j, entry): (i64, &'t Toml)| ([i, j, 0], entry.as_text().unwrap_or(""));
        (0..).zip(row.as_list()).map(entry)
    };
    Ok((0..).zip(rows).flat_map(row).collect())
}
