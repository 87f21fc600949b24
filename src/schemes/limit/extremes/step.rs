//! The greatest step, change and difference after k levels.

use crate::exact::{Integer, Rational};
use crate::limit::error::LimitError;
use crate::limit::functional::{ExtremalPolygon, Functional};
use crate::limit::row::{Refinement, Row};
use crate::scheme::{Mask, Rules};

/// The greatest number of residue classes over which the maximum is taken.
const MAX_CLASSES: u64 = 1 << 14;

/// A supremum over all control polygons with max|Δ| ≤ 1, and a polygon of integers that
/// attains it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attained {
    /// The supremum.
    pub value: Rational,
    /// The index of the point, or of the difference, where it is attained.
    pub index: i64,
    /// The polygon, of integers whose neighbours differ by 1.
    pub polygon: ExtremalPolygon,
}

/// sup ‖P^{k+1} − P^k‖_∞ = max_α ‖E_α D^k‖ over the control polygons with max|Δ| ≤ 1.
/// It is attained at the point x^{k+1}_i with the `index` i.
///
/// Source: `proofs/THEOREMS.md`, 2 and 44.
///
/// # Errors
/// When there are more than 2^14 points i mod n^{k+1}.
///
/// # Panics
/// Never: the rules of a mask sum to 1.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::limit::greatest_step;
/// use subcert::scheme::parse_scheme;
///
/// // x^1_0 − x^0_0 = (Δ_0 − Δ_{−1})/8 of the cubic B-spline, and a quarter of it later.
/// let scheme = parse_scheme("b-spline:degree=3")?;
/// let step = greatest_step(scheme.masks()[0], 0)?;
/// assert_eq!((step.value, step.index), (Rational::new(1, 4), 0));
/// assert_eq!(step.polygon.points, [0, -1, 0]);
/// assert_eq!(greatest_step(scheme.masks()[0], 2)?.value, Rational::new(1, 64));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn greatest_step(mask: &Mask, level: u32) -> Result<Attained, LimitError> {
    greatest_step_from(mask, level, &Rational::zero())
}

/// As [`greatest_step`], for the polygons with x^k_i at (i + shift)/n^k: the greatest |P^{k+1}
/// − P^k| at the points of level k + 1. If (n − 1)·shift is not an integer, the supremum may
/// be greater, and is then attained at the points of level k.
///
/// # Errors
/// As [`greatest_step`].
///
/// # Panics
/// Never: the rules of a mask sum to 1.
pub fn greatest_step_from(
    mask: &Mask,
    level: u32,
    shift: &Rational,
) -> Result<Attained, LimitError> {
    let arity = i64::try_from(mask.arity()).expect("the arity is capped");
    let step = |alpha: i64| {
        let point = Functional::point(alpha).after(mask.rules());
        let u = (Rational::from(alpha) + shift) / Rational::from(arity) - shift;
        let before = Functional::on_line(&u);
        let off = point.plus(&Rational::from(-1), &before);
        (alpha, off.on_differences().expect("both are affine combinations"))
    };
    greatest(&(0..arity).map(step).collect::<Vec<_>>(), arity, &mask.difference(), level)
}

/// sup ‖P^{k+1} − P^k‖_∞ of the polygons with x^k_i at (i + shift)/n^k, over the control
/// polygons with max|Δ| ≤ 1.
///
/// Source: `proofs/THEOREMS.md`, 90.
///
/// # Errors
/// As [`greatest_step`].
///
/// # Panics
/// Never: the rules of a mask sum to 1.
pub fn step_supremum(mask: &Mask, level: u32, shift: &Rational) -> Result<Rational, LimitError> {
    let at_points = greatest_step_from(mask, level, shift)?.value;
    let arity = Rational::from(mask.arity());
    let node = Functional::on_line(&((arity - Rational::one()) * shift)).after(mask.rules());
    let off = node.plus(&Rational::from(-1), &Functional::point(0));
    let off = off.on_differences().expect("both are affine combinations");
    Ok(at_points.max(greatest(&[(0, off)], 1, &mask.difference(), level)?.value))
}

/// sup max|Δ^k| = T_k over the control polygons with max|Δ| ≤ 1. It is attained at the
/// difference Δ^k_i with the `index` i.
///
/// # Errors
/// When there are more than 2^14 differences i mod n^k.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::limit::greatest_difference;
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("quinary-three-point")?;
/// let difference = greatest_difference(scheme.masks()[0], 2)?;
/// assert_eq!(difference.value, Rational::new(169, 625));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn greatest_difference(mask: &Mask, level: u32) -> Result<Attained, LimitError> {
    greatest(&[(0, Functional::point(0))], 1, &mask.difference(), level)
}

/// sup ‖P^l − P^k‖_∞, k ≤ l, over the control polygons with max|Δ| ≤ 1.
///
/// It is attained at a point of level l, as P^l and P^k are linear between neighbouring
/// points of level l.
///
/// # Errors
/// When l < k, or there are more than 2^14 points i mod n^l.
///
/// # Panics
/// Never: the rules of a mask sum to 1.
///
/// ```
/// use subcert::limit::{greatest_change, greatest_step};
/// use subcert::scheme::parse_scheme;
///
/// let scheme = parse_scheme("b-spline:degree=3")?;
/// let step = greatest_step(scheme.masks()[0], 2)?.value;
/// assert_eq!(greatest_change(scheme.masks()[0], 2, 3)?, step);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn greatest_change(mask: &Mask, k: u32, l: u32) -> Result<Rational, LimitError> {
    let arity = mask.arity();
    let too_many = || LimitError::Classes { arity, level: l };
    let levels = l.checked_sub(k).ok_or_else(too_many)?;
    let points = (arity as u64).checked_pow(l).filter(|points| *points <= MAX_CLASSES);
    points.ok_or_else(too_many)?;
    let points = i64::try_from(arity).expect("the arity is capped").pow(levels);
    let change = |i: i64| {
        let new = (0..levels).fold(Functional::point(i), |point, _| point.after(mask.rules()));
        let old = Functional::on_line(&Rational::new(i, points));
        let off = new.plus(&Rational::from(-1), &old);
        (i, off.on_differences().expect("both are affine combinations"))
    };
    let changes: Vec<(i64, Functional)> = (0..points).map(change).collect();
    Ok(greatest(&changes, points, &mask.difference(), k)?.value)
}

/// The greatest ‖f ∘ D^k‖ over the given functionals f of Δ^k and their shifts by i = 0,
/// …, n^k − 1. The functional with the label a, shifted by i, has the index per·i + a.
fn greatest(
    fine: &[(i64, Functional)],
    per: i64,
    difference: &Rules,
    level: u32,
) -> Result<Attained, LimitError> {
    let arity = difference.arity();
    let classes =
        (arity as u64).checked_pow(level).and_then(|all| all.checked_mul(fine.len() as u64));
    if classes.is_none_or(|all| all > MAX_CLASSES) {
        return Err(LimitError::Classes { arity, level });
    }
    let walk = Walk { refinement: Refinement::of(difference), level };
    let mut best: Option<Attained> = None;
    for (label, functional) in fine {
        let (row, denominator) = Row::of(functional);
        let scale = denominator * walk.refinement.denominator().pow(level);
        let mut top: Option<(Integer, i64, Row)> = None;
        walk.visit(&row, 0, 0, 1, &mut |row, shift| {
            let norm = row.norm();
            if top.as_ref().is_none_or(|(most, ..)| norm > *most) {
                top = Some((norm, shift, row.clone()));
            }
        });
        let Some((norm, shift, row)) = top else { continue };
        let value = Rational::new(norm, scale);
        if best.as_ref().is_none_or(|best| value > best.value) {
            let polygon = row.functional(&Integer::one()).extremal_polygon();
            best = Some(Attained { value, index: per * shift + label, polygon });
        }
    }
    Ok(best.expect("there is at least one functional and one class"))
}

/// Visits all shifts 0, …, n^k − 1 of a functional of level k, as functionals of level 0.
struct Walk {
    refinement: Refinement,
    level: u32,
}

impl Walk {
    /// The digits of the shift are chosen from the last one, which belongs to the finest
    /// level, to the first.
    fn visit(
        &self,
        row: &Row,
        depth: u32,
        shift: i64,
        place: i64,
        found: &mut impl FnMut(&Row, i64),
    ) {
        if depth == self.level {
            found(row, shift);
            return;
        }
        for digit in 0..self.refinement.arity() {
            let coarser = self.refinement.pull_back(row, digit);
            self.visit(
                &coarser,
                depth + 1,
                shift + digit * place,
                place * self.refinement.arity(),
                found,
            );
        }
    }
}
