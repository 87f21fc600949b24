//! Certificates of joint spectral radii, and of the smoothness that follows. `proofs/format/radius.md`.

use super::block::Block;
use crate::audit::Limits;
use crate::exact::Rational;
use crate::joint::{Entry, Hull, JointRadius, LeadingEigenvalue, MatrixSet, Reduction};
use crate::scheme::Mask;
use crate::smoothness::{Coefficient, Smoothness};
use std::fmt::Write as _;

/// The certificate of what is proven of the limits of a mask; `None` where no hull is found.
///
/// Where the shifts of the basic limit function are linearly dependent, the certificate says nothing of what
/// fails, but for convergence.
///
/// # Panics
/// Never.
#[must_use]
pub fn smoothness_certificate<F: Coefficient>(
    mask: &Mask<F>,
    smoothness: &Smoothness<F>,
) -> Option<String> {
    let limits = limits(smoothness)?;
    let mut text = String::from("subcert-radius 1\n");
    let rows = mask.rules().rows();
    if let Some((root, minimal)) = rows.iter().flatten().find_map(Coefficient::generator) {
        let coefficients: Vec<String> =
            minimal.coefficients().iter().map(ToString::to_string).collect();
        line(&mut text, "field", &coefficients.join(" "));
        let (low, high) = root.bounds();
        line(&mut text, "between", &format!("{low} {high}"));
    }
    for row in rows {
        let entries = row.iter().map(|entry| {
            let coordinates = entry.coordinates();
            coordinates.iter().map(ToString::to_string).collect::<Vec<String>>().join(",")
        });
        line(&mut text, "rule", &entries.collect::<Vec<String>>().join(" "));
    }
    text.push_str(&limits.text);
    Some(text)
}

/// The lines about the limits of a mask, and what they show.
pub(super) struct LimitLines {
    /// The lines from `order` to `end`.
    pub(super) text: String,
    /// The order K of the sum rules.
    pub(super) order: usize,
    /// A number that is not below the joint spectral radius.
    pub(super) at_most: Rational,
    /// A number that is not above a power of it, and the exponent, if the shifts are independent.
    pub(super) at_least: Option<(Rational, usize)>,
    /// The limits are C^m for this m.
    pub(super) continuous: Option<usize>,
    /// Not all limits are C^m for this m.
    pub(super) not_continuous: Option<usize>,
}

/// Writes the lines about the limits of a mask into the block of a claim.
pub(super) fn radius(block: &mut Block, known: &Limits) -> Option<LimitLines> {
    let found = limits(&known.smoothness);
    match &found {
        Some(lines) => lines.text.lines().for_each(|line| block.line(line)),
        None => block.give_up("no invariant hull is found"),
    }
    found
}

/// The lines about the limits of a mask; `None` where no hull is found.
pub(super) fn limits<F: Coefficient>(smoothness: &Smoothness<F>) -> Option<LimitLines> {
    let differences = &smoothness.differences;
    let hull = differences.radius.hull.as_ref()?;
    let mut text = String::new();
    line(&mut text, "order", &differences.order.to_string());
    let shown = write_radius(&mut text, &differences.matrices, &differences.radius, hull);
    let proven = |m: &usize| hull.bound < differences.limit(*m);
    let continuous = (0..differences.order).take_while(proven).last();
    if let Some(m) = continuous {
        line(&mut text, "continuous", &m.to_string());
    }
    let independent = smoothness.reduced.is_none();
    let fails = smoothness.continuity_fails.filter(|m| {
        let decided = *m == 0 || independent && continuous.is_some();
        let power = i32::try_from(differences.radius.degree).expect("a short product");
        let reached = |bound: &Rational| *bound >= differences.limit(*m).pow(power);
        decided && shown.as_ref().is_some_and(reached)
    });
    if let Some(m) = fails {
        line(&mut text, "not-continuous", &m.to_string());
    }
    text.push_str("end\n");
    let lower = shown.filter(|_| independent && continuous.is_some());
    Some(LimitLines {
        text,
        order: differences.order,
        at_most: hull.bound.clone(),
        at_least: lower.map(|bound| (bound, differences.radius.degree)),
        continuous,
        not_continuous: fails,
    })
}

/// The certificate of the bounds of a joint spectral radius; `None` where the radius is 0.
#[must_use]
pub fn radius_certificate(set: &MatrixSet, radius: &JointRadius) -> Option<String> {
    let hull = radius.hull.as_ref()?;
    let mut text = String::from("subcert-radius 1\n");
    for rows in set.matrices() {
        line(&mut text, "matrix", &matrix(rows));
    }
    write_radius(&mut text, set, radius, hull);
    text.push_str("end\n");
    Some(text)
}

/// Writes both bounds, and gives the lower one.
pub(super) fn write_radius<F: Entry>(
    text: &mut String,
    set: &MatrixSet<F>,
    radius: &JointRadius,
    hull: &Hull,
) -> Option<Rational> {
    if let Some(reduction) = &radius.reduction {
        write_reduction(text, reduction);
    }
    let eigenvalue = radius.eigenvalue(set);
    if let Some(eigenvalue) = &eigenvalue {
        let factors: Vec<String> = eigenvalue.product.iter().map(ToString::to_string).collect();
        line(text, "product", &factors.join(" "));
        let kind = match eigenvalue.kind {
            LeadingEigenvalue::Positive => "positive",
            LeadingEigenvalue::Negative => "negative",
            LeadingEigenvalue::Modulus => "modulus",
        };
        line(text, "eigenvalue", &format!("{kind} {}", eigenvalue.at_least));
    }
    write_hull(text, hull);
    eigenvalue.map(|eigenvalue| eigenvalue.at_least)
}

/// Writes a basis in which matrices are block triangular.
pub(super) fn write_reduction(text: &mut String, reduction: &Reduction) {
    let sizes: Vec<usize> = reduction.blocks.iter().map(MatrixSet::size).collect();
    write_basis(text, [&reduction.basis, &reduction.inverse], &sizes);
}

/// Writes a basis with its inverse, and the sizes of blocks.
pub(super) fn write_basis(
    text: &mut String,
    [basis, inverse]: [&[Vec<Rational>]; 2],
    sizes: &[usize],
) {
    line(text, "basis", &matrix(basis));
    line(text, "inverse", &matrix(inverse));
    let sizes: Vec<String> = sizes.iter().map(ToString::to_string).collect();
    line(text, "blocks", &sizes.join(" "));
}

/// Writes an upper bound.
pub(super) fn write_hull(text: &mut String, hull: &Hull) {
    line(text, "at-most", &hull.bound.to_string());
    line(text, "unit", &hull.unit.to_string());
    for row in &hull.rows {
        line(text, "row", &numbers(row));
    }
    for combination in hull.images.iter().flatten() {
        let terms: Vec<String> = combination.iter().map(|(j, c)| format!("{j}:{c}")).collect();
        line(text, "image", &terms.join(" "));
    }
}

pub(super) fn line(text: &mut String, word: &str, rest: &str) {
    let blank = if rest.is_empty() { "" } else { " " };
    writeln!(text, "{word}{blank}{rest}").expect("a text in memory");
}

/// A matrix, row by row.
fn matrix(rows: &[Vec<Rational>]) -> String {
    rows.iter().map(|row| numbers(row)).collect::<Vec<String>>().join(" | ")
}

pub(super) fn numbers(row: &[Rational]) -> String {
    row.iter().map(ToString::to_string).collect::<Vec<String>>().join(" ")
}
