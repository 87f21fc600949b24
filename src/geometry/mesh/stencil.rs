//! Weights by valence, from the rules of the catalogue.

use super::scheme::MeshScheme;
use crate::exact::{Rational, RealCyclotomic, Scalar};
use crate::scheme::{LocalRules, parse_local_rules};
use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};

/// The weights of a scheme for all valences of a mesh.
#[derive(Clone, Debug)]
pub(crate) struct Stencils<S = RealCyclotomic> {
    rows: BTreeMap<usize, Vec<S>>,
}

impl Stencils {
    /// The weights of these valences, from 3 to [`MAX_VALENCE`](super::MAX_VALENCE).
    ///
    /// | scheme | weights |
    /// |---|---|
    /// | Catmull–Clark | new vertex: of the old vertex, each neighbour, and the new point of each face |
    /// | Doo–Sabin | new vertex i of a face: of its old vertex i + j, j = 0, …, n−1 |
    /// | Loop | new vertex: of the old vertex and each neighbour |
    ///
    /// # Panics
    /// When the catalogue has no rules for a valence.
    pub(crate) fn new(scheme: MeshScheme, valences: impl IntoIterator<Item = usize>) -> Stencils {
        let mut rows = BTreeMap::new();
        for n in valences {
            rows.entry(n).or_insert_with(|| row(scheme, n));
        }
        Stencils { rows }
    }
}

impl<S> Stencils<S> {
    /// The same weights as numbers of another kind.
    pub(crate) fn map<T>(&self, mut map: impl FnMut(&S) -> T) -> Stencils<T> {
        let rows = self.rows.iter();
        Stencils { rows: rows.map(|(n, row)| (*n, row.iter().map(&mut map).collect())).collect() }
    }

    /// The weights of a valence.
    ///
    /// # Panics
    /// When there are no weights of this valence.
    pub(crate) fn of(&self, valence: usize) -> &[S] {
        &self.rows[&valence]
    }
}

thread_local! {
    /// The weights so far: around an edge whose sharpness falls, the same valences come back at every level.
    static ROWS: RefCell<HashMap<(MeshScheme, usize), Vec<RealCyclotomic>>> = RefCell::default();
}

fn row(scheme: MeshScheme, n: usize) -> Vec<RealCyclotomic> {
    ROWS.with_borrow_mut(|rows| {
        rows.entry((scheme, n)).or_insert_with(|| of_catalogue(scheme, n)).clone()
    })
}

fn of_catalogue(scheme: MeshScheme, n: usize) -> Vec<RealCyclotomic> {
    let ring = ring(scheme, n);
    let weights: Vec<RealCyclotomic> = ring.weights().row(0).cloned().collect();
    match scheme {
        MeshScheme::DooSabin => weights,
        MeshScheme::Loop | MeshScheme::LoopWarren => weights[..2].to_vec(),
        MeshScheme::CatmullClark | MeshScheme::Bajaj => {
            of_face_points(n, &weights[0], &weights[1], &weights[1 + n])
        }
    }
}

/// The rules of the catalogue around a vertex of this valence, or on a face of so many vertices.
///
/// # Panics
/// When the catalogue has no rules for it.
pub(crate) fn ring(scheme: MeshScheme, n: usize) -> LocalRules {
    let parameter = if scheme == MeshScheme::DooSabin { "n" } else { "N" };
    parse_local_rules(&format!("{}:{parameter}={n}", scheme.name()))
        .expect("the catalogue has rules for every valence")
}

/// The catalogue has weights of the opposite vertices f_i of quadrilaterals. The new point of such a
/// face is F_i = (v + e_i + e_{i+1} + f_i)/4, so that
///
/// α v + β Σ e_i + γ Σ f_i = (α − Nγ) v + (β − 2γ) Σ e_i + 4γ Σ F_i.
///
/// The right side is the rule for faces of any number of vertices: it is Catmull and Clark's
/// ((N − 2) v + Σ e_i/N + Σ F_i/N)/N.
fn of_face_points(
    n: usize,
    alpha: &RealCyclotomic,
    beta: &RealCyclotomic,
    gamma: &RealCyclotomic,
) -> Vec<RealCyclotomic> {
    let times = |factor: usize| gamma.times(&Rational::from(factor).into());
    vec![alpha.minus(&times(n)), beta.minus(&times(2)), times(4)]
}
