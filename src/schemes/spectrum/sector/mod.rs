//! The rules between two sharp edges at a vertex on a crease, at a corner or at the boundary.
//!
//! | file | subject |
//! |---|---|
//! | `rules` | the rules inside of a sector, and its blocks |
//! | `across` | what goes into the sector |

mod across;
mod rules;

pub use across::Across;

use super::MAX_SECTOR_FACES;
use super::eigenvalues::{Eigenvalue, block_roots, merged};
use super::error::SpectrumError;
use super::stencil::Stencil;
use crate::exact::{Rational, RealCyclotomic, Scalar};
use crate::scheme::{Orbit, find, point_name};
use across::across;
use rules::{Rules, block, number};

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
        let rules = match find(scheme).and_then(|found| found.facts.sector.as_deref()) {
            Some("catmull-clark") => Rules::CatmullClark,
            Some("loop") => Rules::Loop,
            _ => return Err(SpectrumError::NoSectors { scheme: scheme.to_owned() }),
        };
        if !(1..=MAX_SECTOR_FACES).contains(&faces) {
            return Err(SpectrumError::Faces { faces });
        }
        let orbit = |name: &str, count| Orbit { name: name.to_owned(), count };
        let mut orbits = vec![orbit("vertex", 1), orbit("edge", faces + 1)];
        if rules == Rules::CatmullClark {
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
            eigenvalues: eigenvalues(rules, faces, corner)?,
            limit,
            along,
            across: across(rules, faces, corner, points)?,
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
