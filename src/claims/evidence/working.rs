//! The values from which a cell is computed.

use crate::diagnostic::Diagnostic;
use crate::evaluation::context::{CellReading, Outcome};
use crate::evaluation::library::Library;
use crate::evaluation::settings::Settings;
use crate::evaluation::table::Evaluator;
use crate::exact::Rational;
use crate::finding::{PaperAudit, TableFinding, Working};
use std::collections::{BTreeMap, BTreeSet};

/// The values from which the cell at a row and a column, counted from 0, is computed by the printed
/// definition. Parameters that the paper does not state have their assumed or recovered values.
///
/// # Errors
/// When a formula of the claim file is wrong.
///
/// # Panics
/// When there is no such cell.
pub fn working(
    audit: &PaperAudit<'_>,
    finding: &TableFinding<'_>,
    (row, column): (usize, usize),
) -> Result<Working, Diagnostic> {
    let (paper, table) = (audit.paper, finding.table);
    let library = Library::new(paper);
    let judge = Evaluator::new(paper, table, &library, &finding.values())?;
    let (assume, _) = judge.needed(row, column)?;
    let settings = Settings::default();
    let at = CellReading { row, column, assume: &assume, settings: &settings };
    let Ok(quantities) = judge.quantities(at)? else { return Ok(Working::default()) };
    let scheme = quantities.scheme.as_ref().map(|scheme| scheme.instances.clone());
    let definitions = paper.definitions_in(&table.value);
    let mut used: BTreeSet<&str> = table.value.expr.names().into_iter().collect();
    used.extend(definitions.values().flat_map(|formula| formula.expr.names()));
    let of_scheme = table.scheme_at(row, column).map(|located| located.reference.parameters());
    let of_scheme = of_scheme.unwrap_or_default();
    used.extend(of_scheme.iter().map(String::as_str));
    let assumed = judge.assumed.iter().filter(|(name, _)| assume.contains(*name));
    let mut known: BTreeMap<&str, Rational> = BTreeMap::new();
    for (name, value) in judge.given.iter().chain(assumed) {
        known.insert(name, value.clone());
    }
    known.extend(judge.header_values(at));
    known.retain(|name, _| used.contains(name));
    // Where a definition depends on the index of a sum, it has no value by itself.
    let value = |name: &str| match judge.evaluate(definitions[name], at) {
        Ok(Outcome::Value(value)) => Some((name.to_owned(), value)),
        _ => None,
    };
    Ok(Working {
        scheme: scheme.unwrap_or_default(),
        parameters: known.into_iter().map(|(name, value)| (name.to_owned(), value)).collect(),
        definitions: definitions.keys().filter_map(|name| value(name)).collect(),
    })
}
