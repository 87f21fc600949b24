//! The rule `range` of smoothness in two parameters: a region of the plane for which the limits of a scheme are C^m.

#![warn(clippy::arithmetic_side_effects)]

use super::convex::{Linear, Shapes};
use super::polygon::Region;
use super::smooth::{Symbol, contraction};
use super::triangles::Sums;
use crate::claims::Paper;
use crate::formulas::Scope;
use crate::kinds::relation::states::{Comparison, Rest, Sign, comparisons, place_of};
use crate::kinds::smoothness::order;
use crate::lines::curve::{CurveProof, mask};
use crate::numbers::{Q, Value, read_rational};
use crate::text::{Block, Checked, Reason, Stop, Text, Toml, Verdict, require, words};

/// The most levels of a contraction: polynomials in two variables soon have many terms.
const MAX_LEVELS: u32 = 6;

/// The fields of other ranges.
const OTHERS: [&str; 8] =
    ["variable", "value", "below", "at_most", "valences", "from", "to", "closed"];

/// Checks a range of two parameters.
pub fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    let other = OTHERS.iter().any(|key| claim.get(key).is_some());
    require(!other, Reason::Malformed("`variables` without fields of one variable"))?;
    let names: Vec<&str> = claim.texts("variables").collect();
    let names: [&str; 2] = names.try_into().map_err(|_| Reason::Malformed("two variables"))?;
    require(names[0] != names[1], Reason::Malformed("two variables"))?;
    block.restates("variables", Some(&names.join(" ")))?;
    block.restates("scheme", claim.text("scheme"))?;
    block.restates("smoothness", claim.text("smoothness"))?;
    let m = order(claim.text("smoothness").unwrap_or_default())?;
    let (mut planes, scope) =
        (Vec::new(), scope(paper, names.map(|name| (name, Value::symbol(name)))));
    for text in claim.one_or_more("where") {
        block.restates("where", Some(text))?;
        planes.extend(inequalities(text, &Shapes { scope: &scope, names })?);
    }
    require(!planes.is_empty(), Reason::Malformed("what bounds the region"))?;
    let meter = paper.library.meter;
    let region = Region::new(planes, meter)?;
    let corners = region.corners()?;
    let only = claim.is_set("only");
    let reference = claim.text("scheme").unwrap_or_default();
    if let Some(said) = block.maybe("contraction") {
        // For other values nothing is shown.
        require(!only, Reason::NotShown)?;
        let (levels, reduction) = contraction((said, MAX_LEVELS), block)?;
        let symbol = Symbol::new(paper, (&scope, reference), m, &reduction)?;
        let lines = symbol.coefficients.iter().filter_map(|c| Linear::of(c, names));
        let cells = region.cells(lines, corners)?;
        let product = symbol.product(paper, levels)?;
        let sums = Sums {
            polynomials: product.coefficients(),
            classes: product.number_of_classes(),
            names,
            meter,
        };
        require(sums.are_below_one(&region, &cells)?, Reason::Uncovered)?;
        return block.verdict(Verdict::Confirmed);
    }
    let said = block.after("at")?;
    let at: Option<Vec<Q>> =
        words::<2>(said, "two numbers")?.iter().map(|word| read_rational(word)).collect();
    let at: Option<[Q; 2]> = at.and_then(|at| at.try_into().ok());
    let at = at.ok_or(Reason::Malformed("two numbers"))?;
    let [x, y] = at.clone().map(Value::from);
    let scope = self::scope(paper, [(names[0], x), (names[1], y)]);
    let shown = CurveProof::read(paper, mask(paper, claim, &scope)?, block)?;
    let inside = region.has(&at)?;
    let refutes = inside && shown.not_continuous(m) || !inside && only && shown.continuous(m);
    require(refutes, Reason::NoRefutation(Text(said.to_string())))?;
    block.verdict(Verdict::Refuted)
}

/// The values of the paper, in which two names have others.
fn scope<'a>(paper: &'a Paper<'a>, values: [(&str, Value); 2]) -> Scope<'a> {
    let mut scope = paper.stated();
    for (name, value) in values {
        scope.beyond.remove(name);
        scope.values.insert(name.to_owned(), value);
    }
    scope
}

/// The linear functions that are not positive, or with `true` negative, where a text is true.
fn inequalities(text: &str, shapes: &Shapes<'_>) -> Checked<Vec<(Linear, bool)>> {
    let wrong = || Stop::Wrong("what bounds a region has other signs than those of order".into());
    if place_of(text, &["in"]).is_some() {
        return Err(wrong().into());
    }
    let mut planes = Vec::new();
    for Comparison { left, rest } in comparisons(text)? {
        let Rest::Sign(sign, right) = rest else { return Err(wrong().into()) };
        let (lesser, greater) = match sign {
            Sign::Less | Sign::AtMost => (&left.expr, &right.expr),
            Sign::Greater | Sign::AtLeast => (&right.expr, &left.expr),
            Sign::Equal | Sign::Unequal | Sign::Near => return Err(wrong().into()),
        };
        let strict = matches!(sign, Sign::Less | Sign::Greater);
        let functions = shapes.difference(lesser, greater)?.convex()?;
        planes.extend(functions.into_iter().map(|linear| (linear, strict)));
    }
    Ok(planes)
}
