//! The hypotheses of an equation: linear equations between symbols, solved together.

use crate::claim::Hypothesis;
use crate::diagnostic::Diagnostic;
use crate::exact::{Polynomial, Rational};
use crate::formula::{Context, Expr, LocatedFormula, Node, evaluate};
use std::collections::BTreeMap;

/// Symbols with their values in terms of the other symbols.
pub(crate) type Solved = BTreeMap<String, Polynomial>;

/// Solves the hypotheses for symbols, in a context in which every member of a family that they name
/// is a symbol. The symbols that are solved for occur in none of their values.
///
/// Each equation is solved for the member that it names first, or, where the others give this one
/// already, for the first symbol that is left.
///
/// # Errors
/// When a hypothesis is not linear, or contradicts the others.
pub(crate) fn solve(
    hypotheses: &[Hypothesis],
    context: &dyn Context<Polynomial>,
) -> Result<Solved, Diagnostic> {
    let mut solved = Solved::new();
    for Hypothesis { member, value } in hypotheses {
        let first = name(member, context)?;
        let right = evaluate(&value.expr, context).map_err(|error| value.diagnostic(&error))?;
        let equation = &Polynomial::variable(&first) - &right;
        let rest =
            solved.iter().fold(equation, |rest, (symbol, value)| replaced(&rest, symbol, value));
        let refuse = |message: &str| Diagnostic::new(&value.source, value.span.clone(), message);
        let Some(symbols) = rest.linear() else {
            return Err(refuse("this hypothesis is not linear in the symbols").with_help(
                "hypotheses are linear equations, 'a[0, m] = 1 - a[0, 0]'; they hold together",
            ));
        };
        if rest.is_zero() {
            continue;
        }
        let symbol =
            if symbols.contains(&&*first) { Some(&*first) } else { symbols.first().copied() };
        let Some(symbol) = symbol else {
            return Err(refuse("this hypothesis contradicts the ones before it")
                .with_help("what follows from a contradiction says nothing"));
        };
        let inverse = Polynomial::constant(rest.coefficient(symbol).recip());
        let value = &Polynomial::variable(symbol) - &(&rest * &inverse);
        for known in solved.values_mut() {
            *known = replaced(known, symbol, &value);
        }
        solved.insert(symbol.to_owned(), value);
    }
    Ok(solved)
}

/// The full name of a member, `a[0,3]`.
fn name(member: &LocatedFormula, context: &dyn Context<Polynomial>) -> Result<String, Diagnostic> {
    let Node::Indexed { name, indices } = &member.expr.node else {
        unreachable!("a hypothesis is about a member of a family");
    };
    let position = |index: &Expr| {
        let value = evaluate(index, context).map_err(|error| member.diagnostic(&error))?;
        Ok(value.to_string())
    };
    let key = indices.iter().map(position).collect::<Result<Vec<String>, Diagnostic>>()?;
    Ok(format!("{name}[{}]", key.join(",")))
}

/// A linear polynomial with a polynomial in place of a symbol.
fn replaced(polynomial: &Polynomial, symbol: &str, by: &Polynomial) -> Polynomial {
    let coefficient = polynomial.coefficient(symbol);
    if coefficient.as_rational().is_some_and(Rational::is_zero) {
        return polynomial.clone();
    }
    let change = by - &Polynomial::variable(symbol);
    polynomial + &(&Polynomial::constant(coefficient) * &change)
}
