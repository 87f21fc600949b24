//! What is known of the limits for values of parameters, in words.

use super::limits::{not_smooth, of_limits, smooth};
use crate::audit::{
    RangeOfLimits, RegionOfLimits, SmoothSets, SmoothnessFinding, SmoothnessVerdict, Witness,
};
use crate::claim::SmoothRangeStatement;
use crate::exact::{IntervalSet, Rational, RationalPolynomial};
use crate::report::words::set::{proved_text, roots, set_text};
use crate::smoothness::SmoothRange;

/// Why, and by what, another symbol decides.
#[must_use]
pub fn reduction(range: &SmoothRange, parameter: &str) -> String {
    let describe = |g: &Vec<Rational>| RationalPolynomial::new(g).describe("z");
    let by: Vec<String> = range.reduction.iter().map(describe).collect();
    let convergence =
        if range.converges.is_some() { ", wherever the scheme converges" } else { "" };
    format!(
        "The shifts of the basic limit function are linearly dependent for every {parameter}; the solution for the \
         symbol A(z)g(z)/g(z^n), g = {}, is as smooth, and decides{convergence}",
        by.join(", then g = ")
    )
}

pub(super) fn of_range(finding: &SmoothnessFinding<'_>, range: &RangeOfLimits) -> Vec<String> {
    let Some(said) = finding.claim.range() else { return Vec::new() };
    let SmoothRangeStatement { variable, m, .. } = said;
    let set = |set: &IntervalSet| set_text(set, variable);
    let mut lines = match &range.sets {
        Some(sets) => {
            let mut lines = vec![
                format!(
                    "{} for {}",
                    smooth(*m),
                    proved_text(sets.inside(), sets.outside(), variable)
                ),
                format!("{} for {}", not_smooth(*m), set(sets.outside())),
            ];
            lines.extend(roots(&[sets.inside(), sets.outside()], variable, &lines));
            if sets.but_finitely_many() && !sets.outside().is_empty() {
                lines.push(format!("with finitely many exceptions of {variable}"));
            }
            if let SmoothSets::Curve(sets) = sets
                && !sets.reduction.is_empty()
            {
                lines.push(format!("{}.", reduction(sets, variable)));
            }
            lines
        }
        None => vec![format!(
            "the sum rules that C^{m} needs hold for single values of {variable} at most"
        )],
    };
    if finding.verdict == SmoothnessVerdict::Open {
        lines.push(format!("It is open for {}.", set(&range.undecided)));
    }
    if let Some(witness) = &range.witness {
        let place =
            if witness.inside { "in the printed range" } else { "beyond the printed range" };
        let limits = of_witness(witness);
        lines.push(format!("At {variable} = {}, {place}, {limits}.", witness.at));
    }
    lines
}

fn of_witness<P>(witness: &Witness<P>) -> String {
    witness.limits.proven().map(|proven| of_limits(&proven)).unwrap_or_default()
}

/// The contraction in a region of two parameters, or the point that refutes it.
pub(super) fn of_region(finding: &SmoothnessFinding<'_>, region: &RegionOfLimits) -> Vec<String> {
    let Some(said) = finding.claim.region() else { return Vec::new() };
    let [x, y] = &said.variables;
    let point = |[a, b]: &[Rational; 2]| format!("({a}, {b})");
    let corners: Vec<String> = region.corners.iter().map(point).collect();
    let mut lines =
        vec![format!("The corners of the region are ({x}, {y}) = {}.", corners.join(", "))];
    if let Some(proof) = &region.proof {
        let levels = proof.levels;
        let within = if levels == 1 { "one level".to_owned() } else { format!("{levels} levels") };
        lines.push(format!(
            "{} in the whole region: the differences contract within {within}.",
            smooth(said.m)
        ));
    }
    match &region.witness {
        Some(witness) => {
            let place = if witness.inside { "in the region" } else { "outside of it" };
            let limits = of_witness(witness);
            lines.push(format!("At ({x}, {y}) = {}, {place}, {limits}.", point(&witness.at)));
        }
        None if finding.verdict == SmoothnessVerdict::Open => {
            let tried = region.tried;
            lines.push(format!("None of {tried} points that were tried refutes it."));
        }
        None => {}
    }
    lines
}
