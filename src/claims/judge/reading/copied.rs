//! The quantities that readings of a table may take from another place of the paper.

use crate::claim::{Axis, Paper, Table};
use crate::evaluation::Copied;
use crate::evaluation::copied::{prints, references};
use crate::evaluation::library::values;
use crate::evaluation::table::Evaluator;
use crate::exact::Rational;
use crate::formula::{Expr, Node};
use crate::judge::reading::degree::{Degrees, LANGUAGE};
use std::collections::BTreeSet;

/// Every quantity that a reading of this table may take from elsewhere, in a fixed order: for each
/// constant that the table's formula names, the numbers that other tables print for it, its values
/// at other parameters, and its values for other schemes; then the tolerances before they were
/// rounded.
pub(super) fn sources(judge: &Evaluator<'_>) -> Vec<Copied> {
    let (paper, table) = (judge.paper, judge.table);
    let mut sources = Vec::new();
    for of in constants(judge) {
        // If the table's value is the definition alone, its values elsewhere are those of other
        // cells.
        let whole = matches!(&table.value.expr.node, Node::Name(name) if name == of);
        let others = paper.tables.iter().filter(|other| other.id != table.id && prints(other, of));
        let others = others.filter(|_| !whole);
        sources.extend(others.map(|other| Copied::Printed {
            of: of.to_owned(),
            table: other.id.clone(),
            locus: other.locus.clone(),
        }));
        for name in parameters(judge, !whole) {
            let degrees = Degrees::new(paper, &paper.definitions, table, name);
            if degrees.is_free(&paper.definitions[of].expr) {
                continue;
            }
            let own = judge.given.get(name);
            let others = values_in(paper, name).into_iter().filter(|value| Some(value) != own);
            sources.extend(others.map(|value| Copied::Parameter {
                of: of.to_owned(),
                name: name.to_owned(),
                value,
            }));
        }
        if table.schemes().next().is_some() && needs_scheme(paper, of) {
            let schemes = references(paper).into_iter().enumerate();
            sources.extend(schemes.map(|(number, located)| Copied::Scheme {
                of: of.to_owned(),
                number,
                scheme: located.reference.to_string(),
            }));
        }
    }
    if judge.has_tolerance_headers() && is_level(judge) {
        let other = table.axes().find(|axis| !judge.tolerance(axis));
        let count = other.map_or(1, |axis| axis.entries.len());
        sources.extend((0..count).map(|line| Copied::Tolerance {
            line,
            header: other.map_or_else(String::new, |axis| header(axis, line)),
        }));
    }
    sources
}

/// Whether the value of the table is a call of `levels`.
fn is_level(judge: &Evaluator<'_>) -> bool {
    let formula = behind_names(judge, &judge.table.value.expr);
    matches!(&formula.node, Node::Call { function, .. } if function == "levels")
}

/// Follows a formula that is only the name of a definition to the formula of this definition.
fn behind_names<'a>(judge: &Evaluator<'a>, mut formula: &'a Expr) -> &'a Expr {
    while let Node::Name(name) = &formula.node
        && let Some(definition) = judge.paper.definitions.get(name)
    {
        formula = &definition.expr;
    }
    formula
}

fn header(axis: &Axis, place: usize) -> String {
    format!("{} = {}", axis.label, axis.entries[place].printed)
}

/// The definitions that the table's formula names. If the table promises something and its formula
/// is only a name, that name is replaced by its formula: it is the constants of a bound or of a
/// depth that are copied.
fn constants<'a>(judge: &Evaluator<'a>) -> BTreeSet<&'a str> {
    let definitions = &judge.paper.definitions;
    let value = &judge.table.value.expr;
    let formula = if judge.table.promise.is_some() { behind_names(judge, value) } else { value };
    let (mut names, mut waiting) = (BTreeSet::new(), vec![formula]);
    while let Some(expr) = waiting.pop() {
        if let Node::Name(name) = &expr.node
            && definitions.contains_key(name)
        {
            names.insert(&name[..]);
        }
        waiting.extend(expr.parts());
    }
    names
}

/// The stated parameters of the table's cells, with or without those of headers.
fn parameters<'j>(judge: &'j Evaluator<'_>, headers: bool) -> BTreeSet<&'j str> {
    let headers = judge.table.axes().filter_map(Axis::name).filter(|_| headers);
    headers.chain(judge.given.keys().map(String::as_str)).collect()
}

/// The values that a parameter has in the paper: as a header, or stated.
fn values_in(paper: &Paper, name: &str) -> BTreeSet<Rational> {
    let axes = paper.tables.iter().flat_map(Table::axes);
    let axes = axes.filter(|axis| axis.name() == Some(name));
    let headers = axes.flat_map(|axis| (0..axis.entries.len()).filter_map(|i| axis.value(i)));
    let mut found: BTreeSet<Rational> = headers.map(|(_, value)| value.clone()).collect();
    for given in paper.tables.iter().map(|table| &table.given).chain([&paper.given]) {
        let stated = given.get_key_value(name).into_iter();
        found.extend(values(stated).unwrap_or_default().into_values());
    }
    found
}

/// Whether a definition leads to a function of schemes.
fn needs_scheme(paper: &Paper, name: &str) -> bool {
    let calls = |expr: &Expr| expr.functions().iter().any(|name| !LANGUAGE.contains(name));
    let definition = &paper.definitions[name];
    let led = paper.definitions_in(definition);
    [definition].into_iter().chain(led.into_values()).any(|formula| calls(&formula.expr))
}
