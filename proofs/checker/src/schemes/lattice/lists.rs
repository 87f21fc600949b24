//! Masks in one text of lists in lists: `[[1, 2], [3, 4]]/10`.

#![warn(clippy::arithmetic_side_effects)]

use super::vectors::Vector;
use crate::formulas::{Expr, Head, formula};
use crate::schemes::typed::{parts, split, with_factors};
use crate::text::Stop;

/// The signs of a product.
const TIMES: [char; 3] = ['*', '·', '×'];

fn wrong<T>(what: &str) -> Result<T, Stop> {
    Err(Stop::Wrong(format!("a mask in one text: {what}")))
}

/// How many lists begin one in the other, where the first ones do.
pub(super) fn depth(text: &str) -> usize {
    let starts = text.match_indices('[').map(|(at, _)| &text[at..]);
    let blank = |c: char| c.is_whitespace() || c == '[';
    let depth = |text: &str| text.chars().take_while(|c| blank(*c)).filter(|c| *c == '[').count();
    starts.map(depth).find(|depth| *depth > 1).unwrap_or(0)
}

/// What stands before and behind lists, and their entries with their indices.
pub(super) type Lists<'t> = ([&'t str; 2], Vec<(Vector, &'t str)>);

/// The lists of a text. The outermost one has the first index.
pub(super) fn lists(text: &str, d: usize) -> Result<Lists<'_>, Stop> {
    let Some((before, list, behind)) = parts(text) else { return wrong("there is no list in it") };
    if !text[before.len()..].starts_with('[') || depth(text) != d {
        return wrong("its lists are in square brackets, and as deep as the dimension");
    }
    let before = before.trim();
    if !before.is_empty() {
        let Some(factor) = before.strip_suffix(TIMES) else {
            return wrong("a sign * is missing before the lists");
        };
        if matches!(formula(factor)?, Expr::Of(Head::Chain(signs), _) if !is_product(&signs)) {
            return wrong("what stands before the lists is no factor");
        }
    }
    match formula(&with_factors("", "1", behind))? {
        Expr::Number(_) => {}
        Expr::Of(Head::Chain(signs), _) if is_product(&signs) => {}
        _ => return wrong("what stands behind the lists are no factors"),
    }
    let (mut found, mut lengths) = (Vec::new(), [None; 3]);
    level(list, (0, d), [0; 3], &mut lengths, &mut found)?;
    Ok(([before, behind], found))
}

fn is_product(signs: &[char]) -> bool {
    signs.iter().all(|sign| matches!(sign, '*' | '/'))
}

/// Goes through the entries of lists of one depth, with the index of the list. All of this depth are equally long.
fn level<'t>(
    list: &'t str,
    (depth, d): (usize, usize),
    index: Vector,
    lengths: &mut [Option<usize>; 3],
    found: &mut Vec<(Vector, &'t str)>,
) -> Result<(), Stop> {
    let pieces = split(list, ',');
    if *lengths[depth].get_or_insert(pieces.len()) != pieces.len() {
        return wrong("two lists of one depth are not equally long");
    }
    let next = depth.saturating_add(1);
    for (piece, i) in pieces.into_iter().zip(0..) {
        let mut index = index;
        index[depth] = i;
        if next == d {
            found.push((index, piece.trim()));
            continue;
        }
        let inner = piece.trim().strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
        let Some(inner) = inner else { return wrong("a list is missing in a list of lists") };
        level(inner, (next, d), index, lengths, found)?;
    }
    Ok(())
}
