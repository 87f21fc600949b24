//! The rotational symmetry of a ring, and representatives of its points and edges.

use super::rules::LocalRules;
use std::collections::BTreeSet;

/// Representatives of the points and edges of a ring: one from each orbit under its
/// rotation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Representatives {
    /// The points, in increasing order.
    pub points: Vec<usize>,
    /// The edges, in the order of the ring, each with its lower end first.
    pub edges: Vec<(usize, usize)>,
}

impl<S> LocalRules<S> {
    /// The rotation ρ as the list of images of all points. In an orbit of c points, ρ
    /// takes point i to point i + c/g mod c, where g is the greatest common divisor of
    /// all counts above 1; a single point is fixed. ρ is a symmetry if m_{ρa,ρb} =
    /// m_{a,b} for all weights, and edges go to edges. `None` if ρ is the identity or not
    /// a symmetry.
    #[must_use]
    pub fn rotation(&self) -> Option<Vec<usize>> {
        let counts = self.orbits().iter().map(|orbit| orbit.count);
        let order = counts.clone().filter(|&count| count > 1).fold(0, num_integer::gcd);
        if order < 2 {
            return None;
        }
        let mut image = Vec::with_capacity(self.point_count());
        for count in counts {
            let first = image.len();
            let step = if count > 1 { count / order } else { 0 };
            image.extend((0..count).map(|i| first + (i + step) % count));
        }
        let names = self.weights().names();
        let turned = |(row, &a): (&Vec<u32>, &usize)| {
            row.iter().zip(&image).all(|(name, &b)| *name == names[a][b])
        };
        let same_weights = names.iter().zip(&image).all(turned);
        let edges: BTreeSet<_> = self.edges().iter().map(|&(a, b)| unordered(a, b)).collect();
        let same_edges = edges.iter().all(|&(a, b)| edges.contains(&unordered(image[a], image[b])));
        (same_weights && same_edges).then_some(image)
    }

    /// One point and one edge from each orbit under the [rotation](Self::rotation), or
    /// all of them if there is no rotation. A quantity of points or edges that is
    /// invariant under the rotation has the same maximum over these as over all.
    #[must_use]
    pub fn representatives(&self) -> Representatives {
        let image = self.rotation().unwrap_or_else(|| (0..self.point_count()).collect());
        let turn = |&a: &usize| image[a];
        let turn_edge = |&(a, b): &(usize, usize)| unordered(image[a], image[b]);
        let edges = self.edges().iter().map(|&(a, b)| unordered(a, b));
        Representatives {
            points: first_of_each_class(0..self.point_count(), turn),
            edges: first_of_each_class(edges, turn_edge),
        }
    }
}

/// The items that are not an image of an earlier item under repeated application of
/// `turn`.
fn first_of_each_class<T: Ord + Clone>(
    items: impl Iterator<Item = T>,
    turn: impl Fn(&T) -> T,
) -> Vec<T> {
    let mut seen = BTreeSet::new();
    let is_first = |item: &T| {
        let first = seen.insert(item.clone());
        let mut image = turn(item);
        while seen.insert(image.clone()) {
            image = turn(&image);
        }
        first
    };
    items.filter(is_first).collect()
}

fn unordered(a: usize, b: usize) -> (usize, usize) {
    (a.min(b), a.max(b))
}
