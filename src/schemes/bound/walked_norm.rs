//! ‖Dᶜ‖_∞ by visiting every residue class.

use super::power::{ClassCap, Order, PowerNorm, oriented};
use super::walk::{Any, Magnitude, walk};
use crate::exact::{CommonDenominator, Integer, Rational, Real};
use crate::scheme::Rules;

/// The value and the row of [`power_norm`](super::power_norm), by visiting every residue class.
///
/// The classes are walked depth first, from the finest level to the coarsest, so only
/// O(c·N) numbers are stored. The numbers are integers over one common denominator, and
/// have 128 bits if a proven bound on them allows it.
///
/// # Errors
/// When there are more than 2^24 residue classes.
pub fn walked_norm(rules: &Rules, levels: u32, order: Order) -> Result<PowerNorm, ClassCap> {
    ClassCap::check(rules.arity(), levels)?;
    let common = CommonDenominator::of(oriented(rules, order).rows());
    let (offset, rows) = (rules.offset(), [common.numerators]);
    let (value, class) = match narrow(&rows[0], levels) {
        Some(narrow) => {
            let (value, class) = greatest(&[narrow], offset, levels);
            (Integer::from(value), class)
        }
        None => greatest(&rows, offset, levels),
    };
    let value = Rational::new(value, common.denominator.pow(levels));
    Ok(PowerNorm { value, class: Integer::from(class) })
}

/// The value and the row of [`joint_norm`](super::joint_norm), by visiting every residue class.
///
/// # Errors
/// When there are more than 2^24 residue classes.
///
/// # Panics
/// When arity or width differ.
pub fn walked_joint_norm(
    first: &Rules,
    second: &Rules,
    levels: u32,
    order: Order,
) -> Result<PowerNorm, ClassCap> {
    assert_eq!(first.arity(), second.arity(), "joint suprema need equal arities");
    assert_eq!(first.width(), second.width(), "joint suprema need equal widths");
    ClassCap::check(first.arity(), levels)?;
    let common = [first, second].map(|rules| CommonDenominator::of(oriented(rules, order).rows()));
    let rows = common.each_ref().map(|common| common.numerators.clone());
    let mut best = (Integer::from(-1), 0);
    walk(&rows, 0, levels, &mut |norms: &[Integer; 2], class| {
        let product = &norms[0] * &norms[1];
        if product > best.0 || product == best.0 && class < best.1 {
            best = (product, class);
        }
    });
    let scale = (&common[0].denominator * &common[1].denominator).pow(levels);
    Ok(PowerNorm { value: Rational::new(best.0, scale), class: Integer::from(best.1) })
}

/// The value of [`power_norm`](super::power_norm) over any [`Real`] numbers, by the walk of
/// [`walked_norm`]. It returns no row that attains the value, since rounded numbers may not
/// determine it.
///
/// # Errors
/// When there are more than 2^24 residue classes.
pub fn power_norm_generic<S: Real>(
    rules: &Rules<S>,
    levels: u32,
    order: Order,
) -> Result<S, ClassCap> {
    ClassCap::check(rules.arity(), levels)?;
    let oriented = oriented(rules, order);
    let mut best = S::zero();
    let rows = oriented.rows().iter().map(|row| row.iter().cloned().map(Any).collect()).collect();
    walk(&[rows], rules.offset(), levels, &mut |[Any(norm)]: &[Any<S>; 1], _| {
        best = best.greater(norm);
    });
    Ok(best)
}

/// The rows as 128-bit integers, if every number of the walk fits. All numbers are at
/// most M^c in absolute value, where M is the largest absolute row sum.
fn narrow(rows: &[Vec<Integer>], levels: u32) -> Option<Vec<Vec<i128>>> {
    let row_sum = |row: &Vec<Integer>| row.iter().map(Integer::abs).sum::<Integer>();
    let largest = rows.iter().map(row_sum).max()?;
    if largest.bits() * u64::from(levels) > 126 && largest.pow(levels).bits() > 126 {
        return None;
    }
    let to_narrow = |row: &Vec<Integer>| row.iter().map(Integer::to_i128).collect();
    rows.iter().map(to_narrow).collect()
}

/// The greatest absolute row sum, and the least class that attains it.
fn greatest<T: Magnitude + Ord>(rows: &[Vec<Vec<T>>; 1], offset: i64, levels: u32) -> (T, u64) {
    let mut best: Option<(T, u64)> = None;
    walk(rows, offset, levels, &mut |[norm]: &[T; 1], class| {
        let better = |(value, least): &(T, u64)| norm > value || norm == value && class < *least;
        if best.as_ref().is_none_or(better) {
            best = Some((norm.clone(), class));
        }
    });
    best.expect("there is at least one residue class")
}
