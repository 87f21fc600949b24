//! The rules between two sharp edges at a vertex on a crease, at a corner or at the boundary.

use super::MAX_SECTOR_FACES;
use super::eigenvalues::{Eigenvalue, block_roots, merged};
use super::error::SpectrumError;
use super::extension::Extension;
use super::polynomial::Polynomial;
use super::stencil::Stencil;
use crate::exact::{Rational, RealCyclotomic, RealExpression, Scalar};
use crate::scheme::{Orbit, point_name};
use std::cmp::Ordering;

/// The schemes whose rules at sharp edges are known.
const SCHEMES: [(&str, Rules); 3] =
    [("catmull-clark", Rules::CatmullClark), ("loop", Rules::Loop), ("loop-warren", Rules::Loop)];

/// The rules inside of a sector. Loop and Warren differ at smooth vertices only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Rules {
    CatmullClark,
    Loop,
}

/// The part of a mesh at a vertex v between two infinitely sharp edges, F faces wide, or the faces at a boundary vertex:
/// the edges e_0, …, e_F, of which e_0 and e_F are sharp, and for Catmull–Clark the opposite points f_0, …, f_{F−1}
/// of the faces, all counter-clockwise.
///
/// The sharp edges become midpoints. On a crease v becomes (e_0 + 6v + e_F)/8, at a corner it stays. All else has the rules
/// of smooth edges and faces. v, e_0 and e_F depend on themselves alone: this is block 0, with the eigenvalues 1, 1/2 and
/// 1/4 on a crease, 1/2 at a corner. With v = e_0 = e_F = 0, the rest splits by sines into the blocks j = 1, …, F − 1 with
/// c = cos(πj/F), and for Catmull–Clark the block F of the faces alone:
///
/// | scheme | block j | block F |
/// |---|---|---|
/// | Catmull–Clark | x² − (5 + c)x/8 + 1/16 | x − 1/4 |
/// | Loop | x − 3/8 − c/4 | none |
///
/// Source of the rules: DeRose, Kass and Truong 1998; Hoppe and others 1994, without their modified rules for edges that
/// end at a crease. See theorem 168 of `proofs/THEOREMS.md`.
#[derive(Clone, Debug, PartialEq)]
pub struct Sector {
    /// F.
    pub faces: usize,
    /// Whether the vertex is a corner.
    pub corner: bool,
    /// The points: vertex, edge and, for Catmull–Clark, face.
    pub orbits: Vec<Orbit>,
    /// All eigenvalues of these points, in descending order.
    pub eigenvalues: Vec<Eigenvalue>,
    /// The weights of the points in the limit of v.
    pub limit: Stencil<RealCyclotomic>,
    /// Left eigenvectors for 1/2: e_0 − e_F along a crease; at a corner e_0 − v and e_F − v, along both edges.
    pub along: Vec<Stencil<RealCyclotomic>>,
    /// What goes into the sector. `None` for one face at a corner, where all eigenvalues but 1 and these 1/2 are below 1/2.
    pub across: Option<Across>,
}

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

impl Sector {
    /// The sector of F faces of a scheme: `catmull-clark`, `loop` or `loop-warren`.
    ///
    /// # Errors
    /// When the scheme is another one, or F is 0 or more than [`MAX_SECTOR_FACES`].
    ///
    /// # Panics
    /// Never.
    ///
    /// ```
    /// use subcert::spectrum::Sector;
    ///
    /// // A regular crease of triangles: 2(e_1 + e_2) − 2v − e_0 − e_3 goes across, times a factor.
    /// let sector = Sector::of("loop", 3, false)?;
    /// let across = sector.across.unwrap();
    /// assert_eq!((across.eigenvalue.to_string(), across.side.is_eq()), ("1/2".to_owned(), true));
    /// let weights: Vec<String> = across.stencil.unwrap().iter().map(ToString::to_string).collect();
    /// assert_eq!(weights, ["-1", "-1/2", "1", "1", "-1/2"]);
    /// # Ok::<(), subcert::spectrum::SpectrumError>(())
    /// ```
    pub fn of(scheme: &str, faces: usize, corner: bool) -> Result<Sector, SpectrumError> {
        let found = SCHEMES.iter().find(|(name, _)| *name == scheme);
        let (_, rules) =
            found.ok_or_else(|| SpectrumError::NoSectors { scheme: scheme.to_owned() })?;
        if !(1..=MAX_SECTOR_FACES).contains(&faces) {
            return Err(SpectrumError::Faces { faces });
        }
        let orbit = |name: &str, count| Orbit { name: name.to_owned(), count };
        let mut orbits = vec![orbit("vertex", 1), orbit("edge", faces + 1)];
        if *rules == Rules::CatmullClark {
            orbits.push(orbit("face", faces));
        }
        let points: usize = orbits.iter().map(|orbit| orbit.count).sum();
        let stencil = |weights: &[(usize, Rational)]| {
            let mut stencil = vec![RealCyclotomic::zero(); points];
            for (point, weight) in weights {
                stencil[*point] = weight.clone().into();
            }
            stencil
        };
        let [two_thirds, sixth] = [Rational::new(2, 3), Rational::new(1, 6)];
        let [plus, minus] = [1, -1].map(Rational::from);
        let (first, last) = (1, 1 + faces);
        let (limit, along) = if corner {
            let side = |edge| stencil(&[(edge, plus.clone()), (0, minus.clone())]);
            (stencil(&[(0, plus.clone())]), vec![side(first), side(last)])
        } else {
            let limit = [(0, two_thirds), (first, sixth.clone()), (last, sixth)];
            (stencil(&limit), vec![stencil(&[(first, plus), (last, minus)])])
        };
        Ok(Sector {
            faces,
            corner,
            orbits,
            eigenvalues: eigenvalues(*rules, faces, corner)?,
            limit,
            along,
            across: across(*rules, faces, corner, points)?,
        })
    }

    /// The name of a point, such as `edge[2]`.
    ///
    /// # Panics
    /// When there is no such point.
    #[must_use]
    pub fn name(&self, point: usize) -> String {
        point_name(&self.orbits, point)
    }
}

fn number(numerator: i64, denominator: i64) -> RealCyclotomic {
    Rational::new(numerator, denominator).into()
}

/// cos(πj/F).
fn cosine(j: usize, faces: usize) -> RealCyclotomic {
    RealCyclotomic::cosine(&Rational::new(j, 2 * faces)).expect("few faces")
}

/// The characteristic polynomial of block j, 1 ≤ j ≤ F; 1 where there is none.
fn block(rules: Rules, j: usize, faces: usize) -> Polynomial {
    let c = cosine(j, faces);
    match rules {
        Rules::CatmullClark if j == faces => vec![number(-1, 4), number(1, 1)],
        Rules::CatmullClark => {
            vec![number(1, 16), c.plus(&number(5, 1)).times(&number(-1, 8)), number(1, 1)]
        }
        Rules::Loop if j == faces => vec![number(1, 1)],
        Rules::Loop => vec![c.times(&number(-1, 4)).minus(&number(3, 8)), number(1, 1)],
    }
}

fn eigenvalues(rules: Rules, faces: usize, corner: bool) -> Result<Vec<Eigenvalue>, SpectrumError> {
    let last = if corner { number(1, 2) } else { number(1, 4) };
    let of_crease = [number(1, 1), number(1, 2), last].map(|value| vec![-&value, number(1, 1)]);
    let blocks = of_crease.into_iter().map(|one| (0, one));
    let blocks = blocks.chain((1..=faces).map(|j| (j, block(rules, j, faces))));
    let mut found = Vec::new();
    for (j, polynomial) in blocks.filter(|(_, polynomial)| polynomial.len() > 1) {
        let roots = block_roots(j, polynomial)?;
        found.extend(roots.iter().map(|root| Eigenvalue::of(root, &[j])));
    }
    Ok(merged(found))
}

fn across(
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
