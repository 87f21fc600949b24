//! What a paper's formula promises for a mesh.

use super::apriori::{above, face_sizes, real};
use crate::bound::{Recursion, convolution_window};
use crate::exact::{Rational, RealCyclotomic, Scalar};
use crate::float::nearest;
use crate::mesh::{MeshScheme, PolygonMesh, Stencils};

/// The paper that has a formula for the depth of Doo and Sabin's surfaces.
pub const FORMULA_PAPER: &str = "khan2022-doo-sabin";

/// The depth by Theorem 6, (74), of that paper with one convolution: the greatest one of the valences of
/// a mesh, of the least k with (GH)^k ≤ ε(1 − GH)/(bβ).
///
/// G and H are the greatest sums of |g_q| and of |h_q| over even or over odd q, by (10) to (13), (16)
/// for i = 0, and (17). b is that of (44) and (45) as printed, and β the longest edge of the mesh. `None`
/// where GH ≥ 1 for one of the valences, so that nothing is promised.
///
/// The audit of the paper (`proofs/claims/khan2022-doo-sabin.toml`) finds that the formula is wrong; this
/// is what it says, to f64.
#[must_use]
pub fn formula_level(
    mesh: &PolygonMesh<Rational>,
    longest: f64,
    tolerance: &Rational,
) -> Option<u32> {
    let sizes = face_sizes(mesh);
    let stencils = Stencils::new(MeshScheme::DooSabin, sizes.iter().copied());
    let allowed = nearest(tolerance) / longest;
    let level = |&n: &usize| {
        let weights = stencils.of(n);
        let product = product(weights);
        if product >= 1.0 {
            return None;
        }
        let factor = displacement(weights) / (1.0 - product);
        (0..1_000_000).find(|k| factor * product.powi(*k) <= allowed)?.try_into().ok()
    };
    sizes.iter().map(level).collect::<Option<Vec<u32>>>()?.into_iter().max()
}

/// GH.
fn product(weights: &[RealCyclotomic]) -> f64 {
    let n = weights.len();
    // ω_{i,l} of the rule of point i.
    let weight = |i: usize, l: usize| &weights[(l + n - i) % n];
    let sums = |left: usize, right: usize| -> Vec<RealCyclotomic> {
        let add = |sum: &mut RealCyclotomic, l: usize| {
            *sum = sum.plus(&Scalar::minus(weight(left, l), weight(right, l)));
            Some(sum.clone())
        };
        (0..n - 1).scan(RealCyclotomic::zero(), add).collect()
    };
    let norm = |terms: &[RealCyclotomic]| {
        let window = convolution_window(terms, 2, 1, 2 * n - 1, Recursion::Printed);
        let sum = |row: &Vec<RealCyclotomic>| row.iter().map(|x| nearest(x).abs()).sum::<f64>();
        window.iter().map(sum).fold(0.0, f64::max)
    };
    norm(&sums(0, 1)) * norm(&sums(n - 1, 0))
}

/// b: the greatest Σ_{i=1}^{n−j−1} |w_i| i + Σ_{i=1}^{j} |n w_i| i, j = 0, …, n − 2.
fn displacement(weights: &[RealCyclotomic]) -> f64 {
    let n = weights.len();
    let weight = |i: usize| above(&weights[i]).abs() * real(i);
    let of = |j: usize| {
        (1..n - j).map(weight).sum::<f64>() + (1..=j).map(|i| real(n) * weight(i)).sum::<f64>()
    };
    (0..n - 1).map(of).fold(0.0, f64::max)
}
