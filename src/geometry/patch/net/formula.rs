//! What a paper's formula promises for a net.

use super::apriori::longest_edges;
use crate::bound::{Constants, Order, Suprema, Terms, least_level, surface_displacement};
use crate::exact::Rational;
use crate::net::{Net, NetScheme};

/// The paper that has a formula for the depth of tensor products of a curve scheme with itself.
pub const NET_FORMULA_PAPER: &str = "mustafa2020-nary";

/// The depth by Theorem 9, (33), of that paper with one convolution: the least k with
/// (YZ)^k ≤ ε(1 − YZ)/ν, where YZ = T_1Λ_1 and ν is the greatest η¹β_1 + η²β_2 + η³β_1 for the longest edges
/// β_1 and β_2 from row to row and along the rows. The level is `None` where YZ ≥ 1, so that nothing is promised.
///
/// The result is `None` for two different schemes: the formula is for one in both directions. It compares the points
/// at i/n^k, and has the mask at the offset 0; the audit of the paper (`proofs/claims/mustafa2020-nary.toml`)
/// refutes it. This is what it says.
#[must_use]
pub fn net_formula_level(
    net: &Net,
    scheme: &NetScheme,
    tolerance: &Rational,
) -> Option<Option<u32>> {
    let [mask, other] = scheme.masks();
    if mask != other {
        return None;
    }
    let constants = Constants::new(mask.clone());
    let level = || {
        let ratio = constants.tensor(1, Order::Adjoint, Suprema::Independent).ok()?;
        let [u, v] = longest_edges(net).ok()?;
        let factor = surface_displacement(mask, [&u, &v, &u], Terms::Total);
        let rest = Rational::one() - &ratio;
        if rest.sign() <= 0 {
            return None;
        }
        least_level(&(factor / rest), &ratio, tolerance).ok()
    };
    Some(level())
}
