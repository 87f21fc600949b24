//! The limit of a vertex at which one sharp edge ends.

use super::super::scheme::MeshScheme;
use crate::exact::{Rational, Real as _, RealCyclotomic, Scalar as _};

/// The weights c_1, …, c_{n−1} with d·c_i − c_{i−1} − c_{i+1} = 1 and c_0 = c_n = 0, by elimination.
///
/// They are what the left eigenvector for 1 has at the smooth edges of a vertex of valence n, edge 0 of
/// which is sharp: the new point of that edge, (v + e_0)/2, has no part in the neighbours'.
fn between(n: usize, d: i64) -> Vec<Rational> {
    let d = Rational::from(d);
    // c_i = p_i + q_i·c_{i+1}.
    let mut steps = vec![(Rational::zero(), Rational::zero())];
    for i in 1..n {
        let (p, q) = &steps[i - 1];
        let share = (&d - q).recip();
        steps.push((&(&Rational::one() + p) * &share, share));
    }
    let mut weights = vec![Rational::zero(); n];
    let mut next = Rational::zero();
    for i in (1..n).rev() {
        let (p, q) = &steps[i];
        next = p + &(q * &next);
        weights[i] = next.clone();
    }
    weights
}

/// The weights of a vertex of valence n, of its edges and of its faces in its limit, where the edge `first` is sharp and
/// all others are smooth. `stencil` has the weights of the new vertex.
pub(super) fn weights(
    scheme: MeshScheme,
    n: usize,
    first: usize,
    stencil: &[RealCyclotomic],
) -> (RealCyclotomic, Vec<RealCyclotomic>, Vec<RealCyclotomic>) {
    let number = |all: Vec<Rational>| -> Vec<RealCyclotomic> {
        let mut all: Vec<_> = all.into_iter().map(RealCyclotomic::from).collect();
        all.rotate_right(first);
        all
    };
    if !scheme.is_triangular() {
        let (vertex, edges, faces) = catmull_clark(n);
        return (vertex.into(), number(edges), number(faces));
    }
    let beta = &stencil[1];
    let edges: Vec<RealCyclotomic> = number(loops(n)).iter().map(|x| x.times(beta)).collect();
    let one = RealCyclotomic::from(1);
    let total = edges.iter().fold(one.clone(), |sum, x| sum.plus(x));
    (one.over(&total), edges.iter().map(|x| x.over(&total)).collect(), Vec::new())
}

/// The weights of the edges 0, …, n−1 of a dart of Loop's scheme, in units of βa, a that of the vertex:
///
/// 5 b_i − b_{i−1} − b_{i+1} = 8βa without b_0, and b_0 = 2βa + (b_1 + b_{n−1})/4.
///
/// The equations are the columns of w = wM: e_i has 3/8 of itself and 1/8 of its two neighbours,
/// β of it goes into the vertex, and e_0 has 1/2 of itself alone.
fn loops(n: usize) -> Vec<Rational> {
    let eight = Rational::from(8);
    let mut edges: Vec<Rational> = between(n, 5).iter().map(|c| &eight * c).collect();
    let sides = &edges[1] + &edges[n - 1];
    edges[0] = &Rational::from(2) + &(&sides * &Rational::new(1, 4));
    edges
}

/// The weights of the vertex, of the edges 0, …, n−1 and of the faces of a dart of Catmull–Clark, with sum 1.
///
/// With the faces g_i = a/(3n²) + (b_i + b_{i+1})/12, b_0 left out, the columns of w = wM are
/// 7 b_i − b_{i−1} − b_{i+1} = 20a/n² without b_0, and b_0 = 10a/(3n²) + (b_1 + b_{n−1})/6.
fn catmull_clark(n: usize) -> (Rational, Vec<Rational>, Vec<Rational>) {
    let square = Rational::from(n * n);
    let unit = &Rational::from(20) / &square;
    let mut edges: Vec<Rational> = between(n, 7).iter().map(|c| c * &unit).collect();
    let twelfth = Rational::new(1, 12);
    let third = (&Rational::from(3) * &square).recip();
    let faces: Vec<Rational> =
        (0..n).map(|i| &third + &(&(&edges[i] + &edges[(i + 1) % n]) * &twelfth)).collect();
    let sides = &edges[1] + &edges[n - 1];
    edges[0] = &(&Rational::from(10) * &third) + &(&sides * &Rational::new(1, 6));
    let total = edges.iter().chain(&faces).fold(Rational::one(), |sum, x| &sum + x);
    let scaled = |all: Vec<Rational>| all.iter().map(|x| x / &total).collect();
    (total.recip(), scaled(edges), scaled(faces))
}
