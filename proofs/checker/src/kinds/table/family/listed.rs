//! The lines `values`: the values of a family's members in the refuted cells.

use crate::kinds::table::claim::{Cells, Place, Table};
use crate::numbers::{Value, shown};
use crate::text::{Block, Checked, Reason, Stop, Text, compare, require};
use std::collections::{BTreeMap, BTreeSet};

/// A value, and whether a member has it.
type Met = (Option<Value>, bool);

/// The values of the members in the refuted cells.
pub struct Listed {
    /// The values of each cell.
    cells: Vec<(Place, Vec<Met>)>,
}

impl Listed {
    /// Reads the lines `values ROW COLUMN VALUE…`, one for each refuted cell.
    pub fn new(table: &Table<'_>, refuted: &[Place], block: &mut Block<'_>) -> Checked<Listed> {
        let mut cells = Vec::new();
        for place in refuted {
            let said = block.after("values")?;
            let said = said.strip_prefix(&format!("{} {} ", place.0 + 1, place.1 + 1));
            let (mut values, mut rational) = (Vec::<Met>::new(), BTreeSet::new());
            for value in said.ok_or(Reason::Cell)?.split_whitespace() {
                let value = Some(value).filter(|value| *value != "undefined");
                let value = value.map(|value| table.paper.number(value)).transpose()?;
                if let Some(fraction) = value.as_ref().and_then(Value::rational) {
                    require(rational.insert(fraction), Reason::Member)?;
                } else {
                    table.paper.library.meter.spend(values.len() as u64)?;
                    for (known, _) in &values {
                        require(!same(known.as_ref(), value.as_ref())?, Reason::Member)?;
                    }
                }
                values.push((value, false));
            }
            cells.push((*place, values));
        }
        Ok(Listed { cells })
    }

    /// Compares the values of a member with the listed values of these numbers.
    pub fn compare(&mut self, said: &str, cells: &Cells, values: &[Option<Value>]) -> Checked<()> {
        let mut numbers = said.split_whitespace();
        let values: BTreeMap<Place, Option<&Value>> =
            cells.iter().zip(values).map(|((at, _), value)| (*at, value.as_ref())).collect();
        for (place, listed) in &mut self.cells {
            let number = numbers.next().and_then(|number| number.parse().ok());
            let number: usize = number.ok_or(Reason::Malformed("the number of a value"))?;
            let value = values.get(place).copied().flatten();
            let known = number.checked_sub(1).and_then(|i| listed.get_mut(i));
            let none = || Reason::Value(Text(format!("value {number}")), Text(shown(value)));
            let (known, met) = known.ok_or_else(none)?;
            let equal = same(known.as_ref(), value)?;
            compare(equal, &shown(known.as_ref()), &shown(value), Reason::Value)?;
            *met = true;
        }
        require(numbers.next().is_none(), Reason::Malformed("the end of the line"))
    }

    pub fn all_met(&self) -> bool {
        self.cells.iter().flat_map(|(_, values)| values).all(|(_, met)| *met)
    }
}

/// Whether two values are equal or both are undefined.
pub fn same(one: Option<&Value>, other: Option<&Value>) -> Result<bool, Stop> {
    one.zip(other).map_or(Ok(one.is_none() && other.is_none()), |(one, other)| one.equals(other))
}
