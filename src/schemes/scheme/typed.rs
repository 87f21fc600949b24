//! A mask that is typed in place of a name: `[1, 3, 3, 1]/4`.

use super::definition::{CatalogueFacts, Coefficients, ParameterSpec, SchemeDefinition};
use super::reference::split_top_level;
use super::rules::MAX_ARITY;
use crate::diagnostic::{Diagnostic, SourceText};
use crate::exact::{AlgebraicNumber, Rational, Scalar as _};
use crate::formula::{FreeNames, LocatedFormula, Parameters, Value as _, evaluate};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// What the error messages call the text.
const SOURCE: &str = "SCHEME";

/// Where a parameter may have any value, it has this one.
const ANY: (i64, i64) = (355, 113);

/// Whether this is a mask, and no name.
pub(super) fn is_typed(name: &str) -> bool {
    name.starts_with('[')
}

/// The scheme with the mask a_0, …, a_L of the text `[a_0, …, a_L]`, each times what follows the bracket, such as
/// `/4`.
///
/// It is x'_m = Σ_j a_{m − nj + h} x_j with h = ⌊L/2⌋, so that a_h is where a point stays. The coefficients of a mask of
/// arity n add up to n, which gives n. Names in the formulas are parameters.
///
/// # Errors
/// When the text has another form, a coefficient is no formula, or the sum is no arity.
pub(super) fn typed(text: &str) -> Result<SchemeDefinition, Diagnostic> {
    let source = SourceText::new(SOURCE, text);
    let wrong = |span: Range<usize>, message: String| {
        Diagnostic::new(&source, span, message)
            .with_help("write the coefficients a_0, …, a_L of a mask as [1, 3, 3, 1]/4")
    };
    let Some(end) = text.find(']') else {
        return Err(wrong(0..text.len(), "the list has no end".to_owned()));
    };
    let (list, factor) = (&text[1..end], &text[end + 1..]);
    let is_factor = factor.is_empty() || factor.starts_with(['/', '*']);
    if list.contains('[') || list.contains(';') || !is_factor {
        let message = "this is not a list of coefficients with a factor behind it".to_owned();
        return Err(wrong(0..text.len(), message));
    }
    let mut coefficients = Vec::new();
    for piece in split_top_level(list) {
        let start = piece.as_ptr() as usize - text.as_ptr() as usize;
        let span = start..start + piece.len();
        if piece.trim().is_empty() {
            return Err(wrong(span, "a coefficient is missing".to_owned()));
        }
        // A mistake in the coefficient itself is said of the coefficient alone.
        LocatedFormula::read(&source, span.clone(), piece.trim())?;
        coefficients.push(LocatedFormula::read(
            &source,
            span,
            &format!("({}){factor}", piece.trim()),
        )?);
    }
    let none = BTreeMap::new();
    let mut free = FreeNames::new(&none);
    let names: BTreeSet<String> =
        coefficients.iter().flat_map(|formula| free.of(&formula.expr)).collect();
    let Some(arity) = arity(&coefficients, &names)? else {
        let message = "the coefficients of a mask of arity n add up to n, and these do not add up \
                       to a whole number from 2 on";
        return Err(wrong(0..end + 1, message.to_owned()));
    };
    let number = |value: isize| LocatedFormula::read(&source, 0..end + 1, &value.to_string());
    let (first, rows) = rules(&coefficients, arity, &number(0)?);
    let open = ParameterSpec { default: None, least: None, about: String::new() };
    Ok(SchemeDefinition {
        name: text.to_owned(),
        title: String::new(),
        citation: String::new(),
        samples: Vec::new(),
        parameters: names.into_iter().map(|name| (name, open.clone())).collect(),
        facts: CatalogueFacts::default(),
        definitions: BTreeMap::new(),
        offset: Some(number(first)?),
        coefficients: Coefficients::Listed(rows),
    })
}

/// The sum of the coefficients, which is the arity of a mask, at any values of the parameters; `None` where it is
/// no arity.
fn arity(
    coefficients: &[LocatedFormula],
    names: &BTreeSet<String>,
) -> Result<Option<usize>, Diagnostic> {
    let any = AlgebraicNumber::from_rational(&Rational::new(ANY.0, ANY.1));
    let values = Parameters(names.iter().map(|name| (name.clone(), any.clone())).collect());
    let mut sum = AlgebraicNumber::zero();
    for formula in coefficients {
        let value = evaluate(&formula.expr, &values).map_err(|error| formula.diagnostic(&error))?;
        sum = sum.plus(&value);
    }
    let sum = sum.as_rational().filter(Rational::is_integer);
    let arity = sum.and_then(|sum| usize::try_from(sum.numerator().to_i64()?).ok());
    Ok(arity.filter(|arity| (2..=MAX_ARITY).contains(arity)))
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
