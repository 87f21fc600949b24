//! Masks on Z^d as lists of lists: `[[1, 2, 1], [2, 4, 2], [1, 2, 1]]/4`.

use super::text::{factor_before, factor_behind, inner, list, pieces};
use crate::diagnostic::{Diagnostic, SourceText};
use crate::formula::LocatedFormula;
use crate::scheme::lattice::dilation::MAX_DIMENSION;
use std::ops::Range;
use std::sync::Arc;

/// How lists of lists are written.
const LISTS: &str = "write [[1, 1], [1, 1]]: lists of equal lengths in a list, the coefficient of x^i*y^j at place j of list i; `origin` is the place of \
                     that of 1";

/// The indices of a coefficient, and its formula.
type Coefficient = (Vec<i64>, LocatedFormula);

/// Whether a text is a list whose first entry is a list.
pub(in crate::scheme) fn is_nested(text: &str) -> bool {
    list(text).is_ok_and(|list| text[inner(&list)].trim_start().starts_with('['))
}

/// The coefficients of the lists of lists in this range, each with its indices and the factors.
///
/// # Errors
/// When the lists are not of one depth, 2 or 3, and of equal lengths, or a coefficient is no formula.
pub(in crate::scheme) fn nested(
    source: &Arc<SourceText>,
    range: Range<usize>,
) -> Result<Vec<Coefficient>, Diagnostic> {
    let text = &source.text[range.clone()];
    let place = |span: Range<usize>| range.start + span.start..range.start + span.end;
    let wrong = |span: Range<usize>, message: &str| {
        Diagnostic::new(source, place(span), message).with_help(LISTS)
    };
    let list = list(text).map_err(|(span, message)| wrong(span, message))?;
    let before = factor_before(source, place(0..list.span.start))?;
    factor_behind(source, place(list.span.end..text.len()))?;
    let behind = text[list.span.end..].trim();
    let mut leaves = vec![(Vec::new(), list.span.clone())];
    for depth in 0..=MAX_DIMENSION {
        let is_list =
            |(_, span): &(Vec<i64>, Range<usize>)| text[span.clone()].trim().starts_with('[');
        if !leaves.iter().any(is_list) {
            if depth < 2 {
                break;
            }
            let coefficient = |(at, span): (Vec<i64>, Range<usize>)| {
                let piece = text[span.clone()].trim();
                if piece.is_empty() {
                    return Err(wrong(span, "a coefficient is missing"));
                }
                LocatedFormula::read(source, place(span.clone()), piece)?;
                let whole = format!("{before}({piece}){behind}");
                Ok((at, LocatedFormula::read(source, place(span), &whole)?))
            };
            return leaves.into_iter().map(coefficient).collect();
        }
        let mut length = None;
        let mut next = Vec::new();
        for (at, span) in leaves {
            let piece = &text[span.clone()];
            let start = span.start + (piece.len() - piece.trim_start().len());
            let inside = piece.trim().strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
            let Some(inside) = inside else {
                return Err(wrong(
                    span,
                    "a list stands beside a number, or it has something behind it",
                ));
            };
            if inside.trim_end().ends_with(',') {
                return Err(wrong(span, "a list that ends with a comma"));
            }
            let inside = start + 1..start + 1 + inside.len();
            let parts = pieces(text, inside).map_err(|message| wrong(span.clone(), message))?;
            if length.replace(parts.len()).is_some_and(|length| length != parts.len()) {
                return Err(wrong(span, "this list has another length than the one before"));
            }
            let place = |(i, part): (i64, Range<usize>)| {
                (at.iter().copied().chain([i]).collect::<Vec<i64>>(), part)
            };
            next.extend((0..).zip(parts).map(place));
        }
        leaves = next;
    }
    Err(wrong(0..text.len(), "lists in lists are 2 deep, or 3"))
}
