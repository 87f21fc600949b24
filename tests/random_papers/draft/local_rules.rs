//! Rings around a vertex of valence N, and what their points may be compared with.

use crate::random_papers::choices::Choices;
use crate::random_papers::naive::{LocalRules, Q, int};
use num_traits::{One, Zero};

/// A ring with the orbits `v`, one point, and `e`, N points. Every weight is rational.
#[derive(Clone, Debug)]
pub struct LocalFamily {
    pub name: String,
    /// Whether the orbit `e` stands first.
    turned: bool,
    /// Of each e in the new v.
    inward: Q,
    /// Of e[i], e[i+1], e[i−1] in the new e[i]; v has the rest.
    around: [Q; 3],
    /// Whether the edges e[i] – e[i+1] belong to the mesh.
    rim: bool,
}

fn eighths(parts: usize) -> Q {
    Q::new(parts.into(), 8.into())
}

impl LocalFamily {
    pub fn new(name: &str, choices: &mut Choices) -> LocalFamily {
        let inward = Q::new(choices.of(&[1, 0, 2, 3]).into(), 16.into());
        let around = [choices.of(&[3, 4, 2, 6]), choices.below(3), choices.below(3)];
        let around = around.map(|parts: usize| eighths(parts));
        let (turned, rim) = (false, choices.once_in(2));
        LocalFamily { name: name.to_owned(), turned, inward, around, rim }
    }

    /// A ring of the same points that keeps the vertex, and perhaps others.
    pub fn interpolant(&self, name: &str, choices: &mut Choices) -> LocalFamily {
        let around =
            [choices.of(&[4, 8, 0]), choices.below(2), 0].map(|parts: usize| eighths(parts));
        let turned = choices.once_in(4);
        let inward = if choices.once_in(6) { eighths(1) } else { Q::zero() };
        LocalFamily { name: name.to_owned(), turned, inward, around, rim: self.rim }
    }

    pub fn text(&self) -> String {
        let LocalFamily { name, turned, inward, around: [own, next, last], rim } = self;
        let orbits = if *turned { "e = 'N', v = '1'" } else { "v = '1', e = 'N'" };
        let rim = if *rim { ", ['e[i]', 'e[i + 1]']" } else { "" };
        let rest = Q::one() - own - next - last;
        format!(
            "[[scheme]]\nname = '{name}'\nparameters.N = {{ about = '' }}\norbits = {{ {orbits} }}\n\
             edges = [['v', 'e[i]']{rim}]\nweights.v = {{ v = '1 - N*{inward}', e = '{inward}' }}\n\
             weights.e = {{ v = '{rest}', e = '{own}*kronecker(i, j) + \
             {next}*kronecker(mod(j - i, N), 1) + {last}*kronecker(mod(i - j, N), 1)' }}\n"
        )
    }

    pub fn at(&self, valence: usize) -> LocalRules {
        let LocalFamily { turned, inward, around: [own, next, last], rim, .. } = self;
        let edge = |i: usize| 1 + i % valence;
        let mut weights = vec![vec![Q::zero(); valence + 1]; valence + 1];
        weights[0] = vec![inward.clone(); valence + 1];
        weights[0][0] = Q::one() - int(i64::try_from(valence).expect("small")) * inward;
        for i in 0..valence {
            let row = &mut weights[edge(i)];
            row[0] = Q::one() - own - next - last;
            row[edge(i)] += own;
            row[edge(i + 1)] += next;
            row[edge(i + valence - 1)] += last;
        }
        let names = (0..valence).map(|i| format!("e[{i}]"));
        let names = std::iter::once("v".to_owned()).chain(names).collect();
        let spokes = (0..valence).map(|i| (0, edge(i)));
        let around = (0..valence).filter(|_| *rim).map(|i| (edge(i), edge(i + 1)));
        let edges = spokes.chain(around).collect();
        let ring = LocalRules { names, weights, edges };
        assert!(ring.is_affine());
        if !turned {
            return ring;
        }
        let mut other = ring.clone();
        other.names.rotate_left(1);
        let places = |a: usize| (a + valence) % (valence + 1);
        let edges = ring.edges.iter().map(|&(a, b)| (places(a), places(b))).collect();
        LocalRules { edges, ..ring.ordered_as(&other).expect("the same points") }
    }
}
