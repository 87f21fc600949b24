//! A mask that is typed in place of a name: `[1, 3, 3, 1]/4`, or `(1 + z)^3/4`.

use super::definition::{CatalogueFacts, Coefficients, ParameterSpec, ROUNDED, SchemeDefinition};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::{AlgebraicNumber, Polynomial, Rational, Scalar as _};
use crate::formula::{
    Expr, FreeNames, LATTICE_VARIABLES, LocatedFormula, Scope, Value, evaluate, parse,
};
use crate::scheme::composed::composed_of;
use crate::scheme::error::SchemeError;
use crate::scheme::lattice::formulas::LatticeFormulas;
use crate::scheme::lattice::integers::Vectors;
use crate::scheme::lattice::read::{DILATION, EDGES, ORIGIN, Stated, has_lattice_variable};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;
use sum::{EVERYWHERE, Sum};
use symbol::SymbolFormula;
use text::MASK;

pub(super) mod nested;
mod sum;
pub(super) mod symbol;
mod text;

pub(super) use text::is_typed;

/// What the error messages call the text.
const SOURCE: &str = "SCHEME";

/// Where parameters may have any values, the first has this one, the second 8 times this, the third 27 times this.
const ANY: (i64, i64) = (355, 113);

/// The scheme with the mask of the text; names in its formulas are parameters, of which some are `given`.
///
/// # Errors
/// As [`mask`], and as [`SymbolFormula::read`] for a symbol.
pub(super) fn typed(
    text: &str,
    given: &BTreeMap<String, Expr>,
    vectors: &BTreeMap<String, String>,
    others: &dyn Fn(&str) -> Option<Arc<SchemeDefinition>>,
) -> Result<SchemeDefinition, Diagnostic> {
    let source = SourceText::new(SOURCE, text);
    let definitions = BTreeMap::new();
    let mut composed = BTreeMap::new();
    let mut compose = |expr: &Expr| {
        for name in composed_of(expr) {
            let missing = || SchemeError::NoOther { name: name.clone() }.to_string();
            let other =
                others(&name).ok_or_else(|| Diagnostic::new(&source, 0..text.len(), missing()))?;
            composed.insert(name, other);
        }
        Ok::<(), Diagnostic>(())
    };
    let (offset, coefficients, names) =
        if let Some(lattice) = lattice(&source, text, given, vectors)? {
            let mut names = BTreeSet::new();
            for formula in lattice.formulas() {
                compose(&formula.expr)?;
                names.extend(symbol::parameters(formula, &definitions, &LATTICE_VARIABLES));
            }
            (None, Coefficients::Lattice(Box::new(lattice)), names)
        } else if text::is_symbol(text) {
            let symbol = SymbolFormula::read(&source, 0..text.len(), text)?;
            compose(&symbol.formula.expr)?;
            let names = symbol.names(&definitions);
            (None, Coefficients::Symbol(Box::new(symbol)), names)
        } else {
            let Typed { offset, rows, names } = mask(&source, 0..text.len(), &definitions, given)?;
            (Some(offset), Coefficients::Listed(rows), names)
        };
    let open = ParameterSpec { default: None, least: None, about: String::new() };
    Ok(SchemeDefinition {
        name: text.to_owned(),
        title: String::new(),
        citation: String::new(),
        samples: Vec::new(),
        parameters: names.into_iter().map(|name| (name, open.clone())).collect(),
        facts: CatalogueFacts::default(),
        definitions,
        offset,
        is_filter: false,
        coefficients,
        others: composed,
    })
}

/// The mask on Z^d of the text, if it is one: a symbol in x and y, which are not `given`, a list of lists, or `box` with directions.
///
/// # Errors
/// When what is stated has another form, or states nothing of a mask on Z^d.
fn lattice(
    source: &Arc<SourceText>,
    text: &str,
    given: &BTreeMap<String, Expr>,
    vectors: &BTreeMap<String, String>,
) -> Result<Option<LatticeFormulas>, Diagnostic> {
    let whole = || 0..text.len();
    let stated = |name: &str| {
        let list =
            |value: &String| Vectors::of_text(&SourceText::new(name, value), 0..value.len(), value);
        vectors.get(name).map(list).transpose()
    };
    let stated =
        Stated { dilation: stated(DILATION)?, edges: stated(EDGES)?, origin: stated(ORIGIN)? };
    if let Some(directions) = text.trim().strip_prefix(BOX) {
        let directions = Vectors::of_text(source, whole(), directions)?;
        return stated.box_spline(source, &directions).map(Some);
    }
    if nested::is_nested(text) {
        return stated.listed(source, whole(), nested::nested(source, whole())?).map(Some);
    }
    let names = parse(text).map(|expr| FreeNames::new(&BTreeMap::new()).of(&expr));
    let variables = names.is_ok_and(|names| {
        has_lattice_variable(&names, |name| given.contains_key(name)) && text::is_symbol(text)
    });
    if variables || !stated.is_empty() {
        return stated.symbol(source, whole(), text, &BTreeMap::new()).map(Some);
    }
    Ok(None)
}

/// What stands before the directions of a box spline.
const BOX: &str = "box";

/// A mask that is one text.
pub(super) struct Typed {
    pub(super) offset: LocatedFormula,
    pub(super) rows: Vec<Vec<LocatedFormula>>,
    /// The free names in its formulas.
    names: BTreeSet<String>,
}

/// The mask a_0, …, a_L of the text `[a_0, …, a_L]` in this range, each times what stands before the bracket, such as `1/4*`,
/// and behind it, such as `/4`. Braces do too, and round brackets.
///
/// It is x'_m = Σ_j a_{m − nj + h} x_j with h = ⌊L/2⌋, so that a_h is where a point stays. The coefficients of a mask of
/// arity n add up to n, which gives n: where the values of parameters that are given are put in, for all of the others.
///
/// # Errors
/// When the text has another form, a coefficient is no formula, or the sum is no arity.
pub(super) fn mask(
    source: &Arc<SourceText>,
    range: Range<usize>,
    definitions: &BTreeMap<String, LocatedFormula>,
    given: &BTreeMap<String, Expr>,
) -> Result<Typed, Diagnostic> {
    let coefficients = text::coefficients(source, range.clone())?;
    let mut free = FreeNames::new(definitions);
    let names: BTreeSet<String> =
        coefficients.iter().flat_map(|formula| free.of(&formula.expr)).collect();
    let value = |(name, expr): (&String, &Expr)| {
        let span = range.clone();
        let (expr, source, text) = (expr.clone(), Arc::clone(source), String::new());
        (name.clone(), LocatedFormula { expr, text, source, span })
    };
    let values = given.iter().filter(|(name, _)| names.contains(*name)).map(value);
    let valued: BTreeMap<String, LocatedFormula> = values.chain(definitions.clone()).collect();
    let at_all = arity((source, &range), &coefficients, definitions, &names);
    let arity = at_all.or_else(|error| {
        let mut free = FreeNames::new(&valued);
        let names = coefficients.iter().flat_map(|formula| free.of(&formula.expr)).collect();
        arity((source, &range), &coefficients, &valued, &names).map_err(|_| error)
    })?;
    let number = |value: isize| LocatedFormula::read(source, range.clone(), &value.to_string());
    let (first, rows) = rules(&coefficients, arity, &number(0)?);
    Ok(Typed { offset: number(first)?, rows, names })
}

/// The sum of the coefficients, which is the arity of a mask, at any values of the parameters.
///
/// # Errors
/// When it is no arity. Where some factor makes it one, the error says which.
fn arity(
    (source, range): (&Arc<SourceText>, &Range<usize>),
    coefficients: &[LocatedFormula],
    definitions: &BTreeMap<String, LocatedFormula>,
    names: &BTreeSet<String>,
) -> Result<usize, Diagnostic> {
    let any = |at: usize| {
        let cube = Rational::from((at + 1).pow(3));
        AlgebraicNumber::from_rational(&(Rational::new(ANY.0, ANY.1) * cube))
    };
    let any = names.iter().enumerate().map(|(at, name)| (name.clone(), any(at))).collect();
    let values = values_at(coefficients, definitions, &any)?;
    let wrong = |message: String| Diagnostic::new(source, range.clone(), message);
    let sum = Sum::of(values).map_err(|error| wrong(error.to_string()).with_cap(error.cap()))?;
    let variables = names.iter().map(|name| (name.clone(), Polynomial::variable(name))).collect();
    let general = values_at(coefficients, definitions, &variables).ok();
    let general = general.map(|values| Polynomial::total(&values));
    // A sum that is no polynomial, as one with square roots, is known where there are no parameters.
    let constant = general.as_ref().map(|sum| sum.as_constant().is_some());
    let is_known = names.is_empty() || constant == Some(true);
    let list = &source.text[range.clone()];
    if let (Some(general), Some(false)) = (&general, constant) {
        let (words, found) = sum::in_parameters(general, names, &sum.arities(), list);
        return Err(
            wrong(format!("the coefficients add up to {words}{found}")).with_help(EVERYWHERE)
        );
    }
    let arity = sum.arity();
    let fits = arity.is_some_and(|arity| !names.is_empty() || sum.is_uniform(arity));
    let factors = if fits || !is_known { Vec::new() } else { sum.factors() };
    let words = sum.words().filter(|_| is_known);
    match (arity, &factors[..], words) {
        (_, [_, ..], Some(words)) => {
            let error = wrong(sum::lacks_factor(&words, &factors, list));
            let decimal = coefficients.iter().any(|one| one.text.contains('.'));
            Err(if decimal { error.with_help(ROUNDED) } else { error })
        }
        (Some(arity), ..) => Ok(arity),
        (None, _, words) => {
            let found =
                words.map_or_else(|| "do not".to_owned(), |words| format!("add up to {words}"));
            Err(wrong(sum::no_arity(&found)).with_help(MASK))
        }
    }
}

/// The values of coefficients at values of their names.
fn values_at<V: Value>(
    coefficients: &[LocatedFormula],
    definitions: &BTreeMap<String, LocatedFormula>,
    values: &BTreeMap<String, V>,
) -> Result<Vec<V>, Diagnostic> {
    let scope = Scope::new(definitions, &()).with_all(values);
    let value = |formula: &LocatedFormula| {
        evaluate(&formula.expr, &scope).map_err(|error| formula.diagnostic(&error))
    };
    coefficients.iter().map(value).collect()
}

/// The least d, and for each α = 0, …, n−1 the coefficients a_{α + h − nd} for all d from it on for which some rule has
/// one, `zero` where there is none.
fn rules(
    coefficients: &[LocatedFormula],
    arity: usize,
    zero: &LocatedFormula,
) -> (isize, Vec<Vec<LocatedFormula>>) {
    let half = (coefficients.len() - 1) / 2;
    // ⌊(n−1+h)/n⌋ is the greatest d with α + h − nd ≥ 0, and the least one has α + h − nd ≤ L for α = 0.
    let greatest = half.div_ceil(arity);
    let below = (coefficients.len() - 1 - half) / arity;
    let first = -isize::try_from(below).expect("a short mask");
    let row = |alpha: usize| {
        let at = |place: usize| (alpha + half + below * arity).checked_sub(place * arity);
        let coefficient = |place| at(place).and_then(|k| coefficients.get(k)).unwrap_or(zero);
        (0..=below + greatest).map(|place| coefficient(place).clone()).collect()
    };
    (first, (0..arity).map(row).collect())
}
