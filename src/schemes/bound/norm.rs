//! ‖Dᶜ‖_∞: the norm of a power of a subdivision operator.

use super::branch::{JointSearch, PowerSearch};
use super::power::{ClassCap, Order, PowerNorm};
use crate::scheme::Rules;

/// `‖Rᶜ‖_∞ = max_r Σ_s |(Rᶜ)_{r,s}|` for the operator `(Rx)_{ni+β} = Σ_j r_{β,j} x_{i+o+j}`,
/// over the n^c residue classes r mod n^c. It does not depend on the offset o.
///
/// With the difference mask this is the contraction constant T_c, with the mask itself
/// the scheme norm Λ_c. In the forward order, each rule is reversed first; this is what
/// the sequence t_{nu+β} = b_{β,u} gives. c = 0 gives 1.
///
/// If there are few classes, all are visited, as by [`walked_norm`](super::walked_norm()).
/// Otherwise [`PowerSearch`] is used: branch and bound visits some hundreds or thousands of
/// nodes. In both cases the value is exact.
///
/// # Errors
/// When c is above 256, or when branch and bound exceeds its cap on work and there are
/// more than 2^24 classes.
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

/// `max_r Σ_s |(Rᶜ)_{r,s}| · Σ_s |(Sᶜ)_{r,s}|`: the product of the two absolute row sums
/// with one supremum over a common row. Some papers compute the constants of a tensor
/// product in this way. The value is at most the product of the two norms, and does not
/// bound the differences.
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
