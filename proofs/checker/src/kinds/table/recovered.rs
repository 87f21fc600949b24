//! The rule `recovered`: the values of parameters that the paper does not state.

use super::claim::Table;
use crate::numbers::{Q, count, int, read_rational};
use crate::text::{Block, Checked, Reason, Toml, require};
use num_bigint::BigInt;
use num_traits::{One, Pow, Signed};

/// The most decimal places that count.
const MAX_PLACES: u32 = 40;

/// The least range from which a parameter is thought to be chosen.
const LEAST_RANGE: i64 = 10;

/// A value of a parameter.
pub type Given = (String, Q);

/// The recovered values of a table's parameters.
#[derive(Default)]
pub struct Recovered {
    /// The values that the table's own numbers give.
    pub own: Vec<Given>,
    /// The values that it takes from other tables, each with the id of the other table.
    pub from: Vec<(Given, String)>,
}

/// Reads the lines `recovered NAME VALUE` and `recovered NAME VALUE from ID`.
pub fn read(table: &mut Table<'_>, block: &mut Block<'_>) -> Checked<Recovered> {
    let mut recovered = Recovered::default();
    while let Some(said) = block.maybe("recovered") {
        let words: Vec<&str> = said.split_whitespace().collect();
        let (name, value, other) = match words[..] {
            [name, value] => (name, value, None),
            [name, value, "from", other] => (name, value, Some(other)),
            _ => return Err(Reason::Malformed("NAME VALUE [from ID]").into()),
        };
        let open = table.unstated.contains(name) && !table.assumed.contains_key(name);
        require(open, Reason::Recovered(name.to_owned()))?;
        let value = read_rational(value).ok_or(Reason::Malformed("a fraction"))?;
        let count = if other.is_some() { tables(table, name) } else { as_plain(&value) };
        table.recovered.insert(name.to_owned(), (count, other.is_none()));
        table.assumed.insert(name.to_owned(), value.clone().into());
        let given = (name.to_owned(), value);
        match other {
            None => recovered.own.push(given),
            Some(other) => recovered.from.push((given, other.to_owned())),
        }
    }
    Ok(recovered)
}

/// The number of tables of the paper that leave a parameter open.
fn tables(table: &Table<'_>, name: &str) -> Q {
    let open = |claim: &&Toml| claim.texts("unstated").any(|open| open == name);
    count(table.paper.file.list("table").iter().filter(open).count())
}

/// The upper bound (4R + 2)K of how many numbers are as plain as this one.
fn as_plain(value: &Q) -> Q {
    let square = value.denom().pow(2_u32);
    let decimal = |places: &u32| (BigInt::from(10).pow(*places) % value.denom()) == BigInt::ZERO;
    let places = (0..=MAX_PLACES).find(decimal);
    let power = places.map(|places| BigInt::from(10).pow(places));
    let cost = power.map_or(square.clone(), |power| power.min(square));
    let range = value.abs().ceil().max(int(LEAST_RANGE));
    (range * int(4) + int(2)) * Q::new(cost, BigInt::one())
}
