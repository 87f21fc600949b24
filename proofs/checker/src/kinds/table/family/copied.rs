//! The members of a family that take a quantity from another place of the paper.

use super::degree::{OF_NUMBERS, depends};
use super::members::{Members, most_members, values as values_of};
use crate::claims::{Headers, printed};
use crate::formulas::{Expr, Head, formula, names};
use crate::kinds::table::claim::{Cells, Read, Table};
use crate::kinds::table::elsewhere::{behind_names, references};
use crate::numbers::{Q, Value};
use crate::text::{Stop, Toml};
use std::collections::BTreeSet;

/// The most differences of such a member.
const MAX_WITH_COPIED: usize = 3;

/// The constants of masks, which have an order.
const OF_MASKS: [&str; 3] = ["contraction", "norm", "tensor"];

/// The members that take a quantity from another place; `others` are the members that take none.
/// Empty if all together are too many.
pub fn copied(table: &Table<'_>, cells: &Cells, others: &Members) -> Result<Members, Stop> {
    let most = most_members(table);
    let mut members = Members::new();
    let order = order(table, cells)?;
    let last = if order.is_some() { greatest_arity(table, cells)? } else { 0 };
    let numbers = (2..=last).map(|number| format!("scheme@row#{number}"));
    for source in sources(table)?.into_iter().chain(numbers) {
        let computed = source.starts_with("tolerance@line#");
        let numbered = source.starts_with("scheme@row#");
        let fits = |other: &&BTreeSet<String>| {
            let rounded = other.iter().any(|difference| difference.starts_with("tolerance="));
            let way = other.iter().find_map(|difference| difference.strip_prefix("order="));
            let forward = way.or(order.as_deref()) == Some("forward");
            other.len() < MAX_WITH_COPIED && !(computed && rounded) && (forward || !numbered)
        };
        for other in others.iter().filter(fits) {
            members.insert(other.iter().cloned().chain([source.clone()]).collect());
        }
    }
    Ok(if others.len() + members.len() > most { Members::new() } else { members })
}

/// The printed order of masks, if the value of some cell depends on one, and the value of the table
/// leads to a constant of masks.
fn order(table: &Table<'_>, cells: &Cells) -> Result<Option<String>, Stop> {
    let printed = Read::default();
    values_of(table, cells, &printed)?;
    let order = printed.reading.consulted.borrow().get("order").cloned();
    Ok(order.filter(|_| leads_to(table, &table.value, |name| OF_MASKS.contains(&name))))
}

/// The greatest arity of the schemes of these cells.
fn greatest_arity(table: &Table<'_>, cells: &Cells) -> Result<usize, Stop> {
    let (read, mut greatest) = (Read::default(), 0);
    for (place, _) in cells {
        let (assumed, _) = table.needed(*place);
        match table.scope(*place, &read, &assumed) {
            Ok((_, schemes)) => {
                greatest = schemes.iter().map(|scheme| scheme.arity()).fold(greatest, usize::max);
            }
            Err(stop @ (Stop::Capped(_) | Stop::Wrong(_) | Stop::OtherRoot)) => return Err(stop),
            Err(_) => {}
        }
    }
    Ok(greatest)
}

/// The names of all quantities that a reading of this table may take from another place.
fn sources(table: &Table<'_>) -> Result<Vec<String>, Stop> {
    let paper = table.paper;
    let mut sources = Vec::new();
    for of in constants(table) {
        let definition = &paper.definitions[&of];
        // If the table's value is the definition alone, its values elsewhere are those of other
        // cells.
        let whole = matches!(&table.value, Expr::Name(name) if *name == of);
        for claim in paper.file.list("table").iter().filter(|_| !whole) {
            let id = claim.text("id").filter(|id| table.claim.text("id") != Some(*id));
            if let Some(id) = id
                && prints(claim, &of)?
            {
                sources.push(format!("{of}@{id}"));
            }
        }
        let headers = table.axes.iter().flatten().filter_map(Headers::axis);
        let headers = headers.map(|axis| axis.name.to_owned()).filter(|_| !whole);
        let parameters: BTreeSet<String> = headers.chain(table.given.keys().cloned()).collect();
        for name in parameters.iter().filter(|name| depends(table, definition, name)) {
            let own = table.given.get(name).and_then(Value::rational);
            for value in
                values(table, name)?.into_iter().filter(|value| Some(value) != own.as_ref())
            {
                sources.push(format!("{of}@{name}={value}"));
            }
        }
        if !table.schemes().is_empty() && needs_scheme(table, definition) {
            let count = references(paper)?.len();
            sources.extend((1..=count).map(|number| format!("{of}@scheme#{number}")));
        }
    }
    let is_tolerance =
        |axis: &&Headers<'_>| axis.axis().is_some_and(|axis| table.tolerance == Some(axis.name));
    let mut axes = table.axes.iter().flatten();
    if axes.clone().any(|axis| is_tolerance(&axis)) && is_level(table) {
        let lines = axes.find(|axis| !is_tolerance(axis)).map_or(1, Headers::count);
        sources.extend((1..=lines).map(|line| format!("tolerance@line#{line}")));
    }
    Ok(sources)
}

/// Whether the value of a table is a call of `levels`.
fn is_level(table: &Table<'_>) -> bool {
    let formula = behind_names(table, &table.value);
    matches!(formula, Expr::Of(Head::Call(function, _), _) if function == "levels")
}

/// The definitions that the value of a table names. If the table promises something and its value
/// is only a name, that name is replaced by its formula.
fn constants(table: &Table<'_>) -> BTreeSet<String> {
    let promises = table.claim.get("promise").is_some();
    let start = if promises { behind_names(table, &table.value) } else { &table.value };
    let of = |expr: &Expr| match expr {
        Expr::Name(name) if table.paper.definitions.contains_key(name) => Some(name.clone()),
        _ => None,
    };
    start.nodes().into_iter().filter_map(of).collect()
}

/// Whether the value of a table is this definition alone, and the table prints a cell.
fn prints(claim: &Toml, definition: &str) -> Result<bool, Stop> {
    let value = claim.text("value").map(formula).transpose()?;
    let cells = claim.list("cells").iter().flat_map(Toml::as_list);
    Ok(matches!(value, Some(Expr::Name(name)) if name == definition)
        && cells.into_iter().any(|cell| printed(cell).is_some()))
}

/// The values that a parameter has in the paper: as a header, or stated.
fn values(table: &Table<'_>, name: &str) -> Result<BTreeSet<Q>, Stop> {
    let paper = table.paper;
    let stated = paper.given.get(name).and_then(Value::rational);
    let mut found: BTreeSet<Q> = stated.into_iter().collect();
    for claim in paper.file.list("table") {
        let given = paper.constants(claim.entries("given"))?;
        found.extend(given.get(name).and_then(Value::rational));
        for headers in Headers::of(claim)? {
            let axis = headers.axis().filter(|axis| axis.name == name);
            found.extend(axis.into_iter().flat_map(|axis| &axis.entries).map(|(_, v)| v.clone()));
        }
    }
    Ok(found)
}

/// Whether a definition leads to a function of schemes.
fn needs_scheme(table: &Table<'_>, definition: &Expr) -> bool {
    leads_to(table, definition, |function| !OF_NUMBERS.contains(&function))
}

/// Whether a formula leads to such a function.
fn leads_to(table: &Table<'_>, definition: &Expr, such: impl Fn(&str) -> bool) -> bool {
    let definitions = &table.paper.definitions;
    let led = names(definition, definitions);
    let led = led.iter().filter_map(|name| definitions.get(name)).map(|led| &**led);
    let mut nodes = led.chain([definition]).flat_map(Expr::nodes);
    nodes.any(|expr| matches!(expr, Expr::Of(Head::Call(function, _), _) if such(function)))
}
