//! ‖Dᶜ‖_∞: the norm of a power of a subdivision operator.

use super::branch::{JointSearch, MAX_LEVELS, PowerSearch};
use super::walk::{Magnitude, walk};
use crate::exact::{CommonDenominator, Integer, Rational, Real, Scalar};
use crate::scheme::Rules;

/// The most residue classes that are visited one by one: n^c ≤ 2^24.
pub const MAX_CLASSES: u64 = 1 << 24;

/// The order in which a difference mask is read as a sequence.
///
/// For c = 1 the two give the same norms; for c ≥ 2 in general they do not, and
/// only the adjoint order bounds the differences of a subdivided polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Order {
    /// t_{nu+β} = b_{β,N−1−u}: the rows of the operator, the sound order.
    Adjoint,
    /// t_{nu+β} = b_{β,u}, as some papers print.
    Forward,
}

/// A norm, and where it is attained.
#[derive(Clone, Debug, PartialEq)]
pub struct PowerNorm {
    /// max over r of Σ_s |(Rᶜ)_{r,s}|.
    pub value: Rational,
    /// The least row r of 0, …, n^c − 1 that attains it.
    pub class: Integer,
}

/// n^c is beyond [`MAX_CLASSES`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the largest of {arity}^{levels} row sums is out of reach: every row is visited up to \
     {MAX_CLASSES}, and branch and bound goes up to {MAX_LEVELS} levels and to a cap on its \
     work; take a smaller number of levels"
)]
pub struct ClassCap {
    /// n.
    pub arity: usize,
    /// c.
    pub levels: u32,
}

impl ClassCap {
    /// Whether the residue classes mod `arity`^`levels` are few enough to walk.
    ///
    /// # Errors
    /// When they are more than 2^24.
    pub fn check(arity: usize, levels: u32) -> Result<(), ClassCap> {
        let classes = (arity as u64).checked_pow(levels);
        match classes.filter(|&count| count <= MAX_CLASSES) {
            Some(_) => Ok(()),
            None => Err(ClassCap { arity, levels }),
        }
    }
}

/// ‖Rᶜ‖_∞ = max_r Σ_s |(Rᶜ)_{r,s}| for the operator (Rx)_{ni+β} = Σ_j r_{β,j} x_{i+o+j},
/// over the n^c residue classes r mod n^c. It does not depend on the offset o.
///
/// With the difference mask this is the contraction constant T_c, with the mask
/// itself the scheme norm Λ_c. In the forward order the same of the rules read
/// backwards, which is what the sequence t_{nu+β} = b_{β,u} gives. c = 0 gives 1.
///
/// A few classes are visited one by one, as by [`walked_norm`]; of many, branch and
/// bound visits some hundreds or thousands, as [`PowerSearch`] does. Either way the value
/// is exact.
///
/// # Errors
/// When c is above 256, or when neither branch and bound ends within its cap on work nor
/// the classes are at most 2^24.
///
/// ```
/// use subcert::bound::{Order, power_norm};
/// use subcert::exact::Rational;
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("quinary-three-point")?;
/// let difference = scheme.masks()[0].difference();
/// assert_eq!(power_norm(&difference, 2, Order::Adjoint)?.value, Rational::new(169, 625));
/// assert_eq!(power_norm(&difference, 2, Order::Forward)?.value, Rational::new(193, 625));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn power_norm(rules: &Rules, levels: u32, order: Order) -> Result<PowerNorm, ClassCap> {
    PowerSearch::new(rules, order).norm(levels)
}

/// The value and the row of [`power_norm`] by visiting every residue class.
///
/// The classes are walked depth first from the fine level to the coarse one, so
/// that O(c·N) numbers are kept; the numbers are integers over one common
/// denominator, of 128 bits where a proven bound on them allows it.
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

/// max_r Σ_s |(Rᶜ)_{r,s}| · Σ_s |(Sᶜ)_{r,s}|: the two norms with one supremum over
/// the same row, as some papers compute the constants of a tensor product. It is
/// at most the product of the norms, and does not bound the differences.
///
/// The rules are taken at offset 0, and must agree in arity and width.
///
/// # Errors
/// As [`power_norm`].
///
/// # Panics
/// When arity or width differ.
pub fn joint_norm(
    first: &Rules,
    second: &Rules,
    levels: u32,
    order: Order,
) -> Result<PowerNorm, ClassCap> {
    JointSearch::new(first, second, order).norm(levels)
}

/// The value and the row of [`joint_norm`] by visiting every residue class.
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

/// The value of [`power_norm`] over any [`Real`] numbers: the same walk, operation
/// by operation, that [`power_norm`] makes on integers. It names no row that
/// attains the value, since rounded numbers need not tell which one does.
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
    walk(&[oriented.rows().to_vec()], rules.offset(), levels, &mut |[norm]: &[S; 1], _| {
        best = best.greater(norm);
    });
    Ok(best)
}

pub(super) fn oriented<S: Scalar>(rules: &Rules<S>, order: Order) -> Rules<S> {
    match order {
        Order::Adjoint => rules.clone(),
        Order::Forward => rules.reversed(),
    }
}

/// The rows as 128-bit integers, if every number of the walk then fits: all are
/// at most M^c in absolute value, where M is the largest absolute row sum.
fn narrow(rows: &[Vec<Integer>], levels: u32) -> Option<Vec<Vec<i128>>> {
    let row_sum = |row: &Vec<Integer>| row.iter().map(Integer::abs).sum::<Integer>();
    let largest = rows.iter().map(row_sum).max()?;
    if largest.bits() * u64::from(levels) > 126 && largest.pow(levels).bits() > 126 {
        return None;
    }
    let to_narrow = |row: &Vec<Integer>| row.iter().map(Integer::to_i128).collect();
    rows.iter().map(to_narrow).collect()
}

/// The greatest row sum, and the least class that has it.
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
