//! What goes from a vertex between two sharp edges into the sector.

use super::rules::{Rules, block, cosine, number};
use crate::exact::{Rational, RealCyclotomic, RealExpression, Scalar};
use crate::spectrum::eigenvalues::block_roots;
use crate::spectrum::error::SpectrumError;
use crate::spectrum::extension::Extension;
use crate::spectrum::stencil::Stencil;
use std::cmp::Ordering;

/// The greatest eigenvalue λ of block 1; for one face on a crease, the 1/4 of the crease.
#[derive(Clone, Debug, PartialEq)]
pub struct Across {
    /// λ.
    pub eigenvalue: RealExpression,
    /// λ compared with 1/2, the eigenvalue along the sharp edges.
    pub side: Ordering,
    /// Whether block 2 has an eigenvalue above 1/2, too: on a crease, normals of generic data then have no limit at v.
    pub second_above: bool,
    /// A left eigenvector for λ, which has Σ_i sin(πi/F)/sin(π/F) e_i times a positive number; for one face it is e_0 + e_1 − 2v. `None`
    /// where there is none, as λ has a Jordan block with block 0: at corners with λ = 1/2.
    pub stencil: Option<Stencil<RealExpression>>,
}

impl Across {
    /// λ compared with 1/2: `below`, `equal` or `above`.
    #[must_use]
    pub fn comparison(&self) -> &'static str {
        match self.side {
            Ordering::Less => "below",
            Ordering::Equal => "equal",
            Ordering::Greater => "above",
        }
    }
}

/// That of a sector of this many points.
pub(super) fn across(
    rules: Rules,
    faces: usize,
    corner: bool,
    points: usize,
) -> Result<Option<Across>, SpectrumError> {
    let half = RealExpression::from(Rational::new(1, 2));
    if faces == 1 {
        let mut stencil = vec![RealExpression::zero(); points];
        for (point, weight) in [(0, -2), (1, 1), (2, 1)] {
            stencil[point] = RealExpression::from(Rational::from(weight));
        }
        let eigenvalue = RealExpression::from(Rational::new(1, 4));
        let side = Ordering::Less;
        let across = Across { eigenvalue, side, second_above: false, stencil: Some(stencil) };
        return Ok((!corner).then_some(across));
    }
    let [first, second] = [1, 2].map(|j| block(rules, j, faces));
    let extensions = block_roots(1, first)?.into_iter().filter_map(|root| root.extension);
    let greatest = extensions.max_by(|a, b| a.root().cmp(&b.root())).expect("real roots");
    let second_above =
        second.len() > 1 && block_roots(2, second)?.iter().any(|root| root.real > half);
    let eigenvalue = greatest.root();
    let side = eigenvalue.cmp(&half);
    let stencil = stencil(rules, faces, corner, &greatest);
    Ok(Some(Across { eigenvalue, side, second_above, stencil }))
}

/// The left eigenvector for the eigenvalue λ of block 1: with s_i = sin(πi/F)/sin(π/F) and S = Σ s_i,
///
/// a v + b(e_0 + e_F) + Σ (16λ − 4)s_i e_i + Σ (s_i + s_{i+1}) f_i for Catmull–Clark, and
/// a v + b(e_0 + e_F) + Σ s_i e_i for Loop.
///
/// With the weight h of e_0 and e_F in the new v, 1/8 or 0, the columns of v and e_0 are
/// (λ − 1 + 2h)a − b = R and (λ − 1/2)b − ha = T, where R = (6λ − 1)S and T = λ for Catmull–Clark, R = 3S/8 and T = 1/8 for
/// Loop. Their determinant is (λ − 1)(λ − 1/2 + 2h).
fn stencil(
    rules: Rules,
    faces: usize,
    corner: bool,
    extension: &Extension,
) -> Option<Stencil<RealExpression>> {
    let h = if corner { number(0, 1) } else { number(1, 8) };
    let sines = sines(faces);
    let total = RealCyclotomic::total(&sines);
    let of = |coefficients: &[RealCyclotomic]| extension.reduced(coefficients);
    let product = |a: &[RealCyclotomic], b: &[RealCyclotomic]| extension.product(a, b);
    let sum = |a: &[RealCyclotomic], b: &[RealCyclotomic]| -> Vec<RealCyclotomic> {
        a.iter().zip(b).map(|(x, y)| x.plus(y)).collect()
    };
    let (into_vertex, into_edge, edge) = match rules {
        Rules::CatmullClark => {
            let into_vertex = [-&total, total.times(&number(6, 1))];
            (
                of(&into_vertex),
                of(&[number(0, 1), number(1, 1)]),
                of(&[number(-4, 1), number(16, 1)]),
            )
        }
        Rules::Loop => {
            (of(&[total.times(&number(3, 8))]), of(&[number(1, 8)]), of(&[number(1, 1)]))
        }
    };
    let less = |value: &RealCyclotomic| of(&[-value, number(1, 1)]);
    let twice = h.plus(&h);
    let of_vertex = less(&number(1, 1).minus(&twice));
    let of_edge = less(&number(1, 2));
    let determinant = product(&less(&number(1, 1)), &less(&number(1, 2).minus(&twice)));
    let scale = extension.inverse(&determinant)?;
    let vertex = product(&scale, &sum(&product(&into_vertex, &of_edge), &into_edge));
    let shared = product(&into_vertex, &of(&[h]));
    let end = product(&scale, &sum(&product(&into_edge, &of_vertex), &shared));
    let inner = sines[1..faces].iter().map(|s| product(&edge, &of(std::slice::from_ref(s))));
    let mut weights = vec![vertex, end.clone()];
    weights.extend(inner);
    weights.push(end);
    if rules == Rules::CatmullClark {
        weights.extend(sines.windows(2).map(|pair| of(&[pair[0].plus(&pair[1])])));
    }
    Some(weights.iter().map(|weight| extension.express(weight)).collect())
}

/// s_i = sin(πi/F)/sin(π/F) for i = 0, …, F: s_{i+1} = 2 cos(π/F) s_i − s_{i−1}.
fn sines(faces: usize) -> Vec<RealCyclotomic> {
    let c = cosine(1, faces);
    let mut sines = vec![number(0, 1), number(1, 1)];
    for i in 2..=faces {
        let next = c.times(&sines[i - 1]).times(&number(2, 1)).minus(&sines[i - 2]);
        sines.push(next);
    }
    sines
}
