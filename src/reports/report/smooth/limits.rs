//! What is known of limits, in words.

use crate::audit::Proven;
use crate::exact::Enclosed as _;
use crate::lattice::{LatticeRadius, LatticeSmoothness};
use crate::report::words::numbers::{down, up};
use crate::smoothness::Hoelder;

/// The longest formula of an exponent that stands beside its decimals.
const LONGEST: usize = 100;

pub(super) fn smooth(m: usize) -> String {
    format!("the limits are C^{m}")
}

pub(super) fn not_smooth(m: usize) -> String {
    if m == 0 {
        "the scheme diverges for some data".to_owned()
    } else {
        format!("not all limits are C^{m}")
    }
}

/// `the limits are C^1, and not all limits are C^2; Hölder exponent 2, not attained`.
pub(super) fn of_limits(proven: &Proven<'_>) -> String {
    let known = [proven.continuity.map(smooth), proven.continuity_fails.map(not_smooth)];
    let known: Vec<String> = known.into_iter().flatten().collect();
    let known = if known.is_empty() {
        "it is open whether the scheme converges".to_owned()
    } else {
        known.join(", and ")
    };
    let exponent = proven.hoelder;
    format!(
        "{known}{}",
        exponent.map(|e| format!("; Hölder exponent {}", of_exponent(e))).unwrap_or_default()
    )
}

/// What else is known of the limits of a mask on Z^d.
pub(super) fn of_lattice(found: &LatticeSmoothness) -> Vec<(String, String)> {
    let mut facts = vec![("sum rules".to_owned(), format!("of order {}", found.sum_rules))];
    let order = found.accuracy.map(|order| format!("of order {order}"));
    facts.extend(order.map(|order| ("accuracy".to_owned(), order)));
    let contraction =
        found.contraction.as_ref().map(|(c, bound)| format!("T_{c} = {bound} is below 1"));
    facts.extend(contraction.map(|shown| ("convergence".to_owned(), shown)));
    let radii = [("differences", &found.differences), ("near a tile", &found.radius)];
    for (name, radius) in radii {
        let Some(LatticeRadius { matrices, order, .. }) = radius else { continue };
        let (count, size) = (matrices.matrices().len(), matrices.size());
        facts.push((
            format!("matrices, {name}"),
            format!("{count}, {size}×{size}, on differences of order {order}"),
        ));
    }
    facts
}

/// `6 - log_2(9), 2.830074998557 to 2.830074998558, attained`.
pub(crate) fn of_exponent(hoelder: &Hoelder) -> String {
    let between = between(hoelder);
    let value = match &hoelder.formula {
        Some(formula) if formula.as_rational().is_some() => formula.to_string(),
        Some(formula) => {
            let formula = formula.to_string();
            let short = formula.chars().count() <= LONGEST;
            if short { format!("{formula}, {between}") } else { between }
        }
        None => between,
    };
    let attained = match hoelder.attained {
        None => "",
        Some(true) => ", attained",
        Some(false) => ", not attained",
    };
    format!("{value}{attained}")
}

/// Decimals around the exponent.
fn between(hoelder: &Hoelder) -> String {
    let [low, high] = decimals(hoelder);
    if low == high { low } else { format!("{low} to {high}") }
}

/// A decimal that is not above the exponent, and one that is not below it.
pub(crate) fn decimals(hoelder: &Hoelder) -> [String; 2] {
    let (low, high) = match &hoelder.formula {
        Some(formula) => {
            let enclosure = formula.enclosure(1);
            (enclosure.lower().clone(), enclosure.upper().clone())
        }
        None => (hoelder.lower.clone(), hoelder.upper.clone()),
    };
    [down(&low), up(&high)]
}
