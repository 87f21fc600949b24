//! The hypotheses of an equation: linear equations between symbols, solved together.

use crate::formulas::{Expr, Head, Scope, formula, member};
use crate::numbers::Value;
use crate::text::{Stop, Toml};

/// A symbol and its value in terms of the others.
type Solved = (String, Value);

/// Gives symbols the values that the hypotheses of a claim determine. None of these symbols occurs
/// in a value.
pub fn suppose(claim: &Toml, scope: &mut Scope<'_>) -> Result<(), Stop> {
    let (mut solved, mut members) = (Vec::<Solved>::new(), Vec::new());
    for text in claim.texts("hypotheses") {
        let (name, value) = text.split_once('=').unwrap_or((text, ""));
        let Expr::Of(Head::Member(family), positions) = formula(name.trim())? else {
            return Err(Stop::Wrong("a hypothesis does not have the form `q[i] = …`".into()));
        };
        members.push((family, positions, formula(value.trim())?));
    }
    // The families of hypotheses are symbols only while the hypotheses are solved.
    let symbols = scope.families.clone();
    scope.families.extend(members.iter().map(|(family, ..)| family.clone()));
    for (family, positions, value) in &members {
        let positions = positions.iter().map(|position| scope.value(position));
        let name = member(family, &positions.collect::<Result<Vec<Value>, Stop>>()?)?;
        let equation = Value::symbol(&name).minus(&scope.value(value)?)?;
        add(&mut solved, name, equation)?;
    }
    scope.families = symbols;
    for name in solved.iter().filter_map(|(_, value)| value.linear()).flatten() {
        let known = name.split_once('[').is_none_or(|(family, _)| scope.families.contains(family));
        if !known {
            return Err(Stop::Wrong(format!("`{name}` is unknown")));
        }
    }
    scope.values.extend(solved);
    Ok(())
}

/// Adds the equation `equation` = 0. It is solved for the symbol `first` if that occurs.
fn add(solved: &mut Vec<Solved>, first: String, equation: Value) -> Result<(), Stop> {
    let mut rest = equation;
    for (symbol, value) in &*solved {
        rest = replaced(&rest, symbol, value)?;
    }
    let symbols = rest.linear();
    let symbols = symbols.ok_or(Stop::Wrong("a hypothesis is not linear".into()))?;
    if rest.is_zero() {
        return Ok(());
    }
    let symbol = if symbols.contains(&first) { Some(first) } else { symbols.into_iter().next() };
    let symbol = symbol.ok_or(Stop::Wrong("the hypotheses contradict each other".into()))?;
    let unknown = Value::symbol(&symbol);
    let value = unknown.minus(&rest.over(&rest.coefficient(&symbol))?)?;
    for (_, known) in &mut *solved {
        *known = replaced(known, &symbol, &value)?;
    }
    solved.push((symbol, value));
    Ok(())
}

/// Replaces a symbol of a linear value by another value.
fn replaced(value: &Value, symbol: &str, by: &Value) -> Result<Value, Stop> {
    let change = by.minus(&Value::symbol(symbol))?;
    value.plus(1, &value.coefficient(symbol).times(&change)?)
}
