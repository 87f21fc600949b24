//! σ: how far one step moves a net, at most.

use super::norm::{Edges, NormError};
use super::powers::Functional;
use crate::exact::Rational;
use crate::scheme::{LatticeMask, Point, sum};
use std::collections::{BTreeMap, BTreeSet};

/// What a net is between its points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Between {
    /// Linear on triangles, whose third sides have the direction (1, 1).
    Triangles,
    /// Linear on triangles, whose third sides have the direction (1, −1).
    OtherTriangles,
    /// Linear in each coordinate, on boxes.
    Boxes,
}

impl Between {
    /// What nets of a mask are: linear on triangles, if (1, 1) or (1, −1) is an edge or M is not diagonal, and otherwise linear in each coordinate. `None`
    /// in three dimensions with an M that is not diagonal.
    #[must_use]
    pub fn of(mask: &LatticeMask) -> Option<Between> {
        let edges = Edges::new(mask.edges(), mask.dimension());
        let has = |edge: Point| edges.all().contains(&edge);
        match mask.dimension() {
            2 if has([1, 1, 0]) => Some(Between::Triangles),
            2 if has([1, -1, 0]) => Some(Between::OtherTriangles),
            _ if mask.dilation().diagonal().is_some() => Some(Between::Boxes),
            2 => Some(Between::Triangles),
            _ => None,
        }
    }
}

/// The greatest |P^1(x) − P^0(x)| of data that differ by at most 1 along edges, where P^k is between the points of level k, which stand at
/// M^{−k}(α + τ): linear on triangles, if (1, 1) or (1, −1) is an edge or M is not diagonal, and otherwise linear in each coordinate. `None` in three
/// dimensions with an M that is not diagonal.
///
/// P^1 − P^0 is linear, or linear in each coordinate, on the parts of the common refinement of both divisions of the plane; so it is greatest at
/// their corners. There are finitely many up to translations by integers.
///
/// # Errors
/// When a functional has too many places.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::lattice::displacement;
/// use subcert::scheme::parse_lattice;
///
/// let product = parse_lattice("four-point:w=1/16 x four-point:w=1/16")?;
/// let zero = [Rational::zero(), Rational::zero()];
/// assert_eq!(displacement(&product, &zero), Ok(Some(Rational::new(9, 32))));
/// # Ok::<(), subcert::scheme::SchemeError>(())
/// ```
pub fn displacement(mask: &LatticeMask, shift: &[Rational]) -> Result<Option<Rational>, NormError> {
    let Some((_, functionals)) = displacements(mask, shift) else { return Ok(None) };
    let edges = Edges::new(mask.edges(), mask.dimension());
    let mut greatest = Rational::zero();
    for functional in functionals {
        greatest = greatest.max(edges.norm(&functional)?.value);
    }
    Ok(Some(greatest))
}

/// What a net is between its points, and P^1 − P^0 at the corners, as functionals of the data.
pub(super) fn displacements(
    mask: &LatticeMask,
    shift: &[Rational],
) -> Option<(Between, Vec<Functional<Rational>>)> {
    let between = Between::of(mask)?;
    let corners = match between {
        Between::Boxes => of_boxes(mask, shift),
        _ => of_triangles(mask, shift, between),
    };
    let at = |corner: Vec<Rational>| {
        let mut functional: Functional<Rational> = BTreeMap::new();
        let mut add = |place: Point, c: Rational| {
            *functional.entry(place).or_insert_with(Rational::zero) += &c;
        };
        for (place, weight) in weights(&less(&corner, shift), between) {
            add(place, -weight);
        }
        for (place, weight) in weights(&less(&image(mask, &corner), shift), between) {
            mask.rule(place).for_each(|(at, c)| add(at, c * &weight));
        }
        functional.retain(|_, c| !c.is_zero());
        functional
    };
    Some((between, corners.into_iter().map(at).collect()))
}

/// x − τ.
pub(super) fn less(x: &[Rational], shift: &[Rational]) -> Vec<Rational> {
    x.iter().zip(shift).map(|(x, s)| x - s).collect()
}

/// Mx.
fn image(mask: &LatticeMask, x: &[Rational]) -> Vec<Rational> {
    let row = |row: &[i64]| row.iter().zip(x).map(|(m, x)| Rational::from(*m) * x).sum();
    mask.dilation().rows().map(row).collect()
}

/// The weights of the points around t in the value of a net at t; those that are 0 are left out.
#[must_use]
pub fn weights(t: &[Rational], between: Between) -> Vec<(Point, Rational)> {
    let mut base = [0; 3];
    let mut parts = Vec::new();
    for (at, x) in base.iter_mut().zip(t) {
        let floor = x.floor();
        *at = floor.to_i64().unwrap_or(0);
        parts.push(x - &Rational::from(floor));
    }
    let one = Rational::one();
    let all: Vec<(Point, Rational)> = match (between, &parts[..]) {
        (Between::Triangles, [u, v]) => {
            let (corner, low, high) = if u >= v { ([1, 0, 0], v, u) } else { ([0, 1, 0], u, v) };
            vec![([0, 0, 0], &one - high), (corner, high - low), ([1, 1, 0], low.clone())]
        }
        (Between::OtherTriangles, [u, v]) => {
            let rest = &one - &(u + v);
            if rest.sign() >= 0 {
                vec![([0, 0, 0], rest), ([1, 0, 0], u.clone()), ([0, 1, 0], v.clone())]
            } else {
                vec![([1, 1, 0], -rest), ([1, 0, 0], &one - v), ([0, 1, 0], &one - u)]
            }
        }
        _ => (0..1 << parts.len())
            .map(|set: usize| {
                let bit = |axis: usize| set >> axis & 1 == 1;
                let place = std::array::from_fn(|axis| i64::from(bit(axis)));
                let factors = parts.iter().enumerate();
                let factors = factors.map(|(axis, x)| if bit(axis) { x.clone() } else { &one - x });
                (place, factors.fold(one.clone(), |product, x| product * x))
            })
            .collect(),
    };
    let moved = all.into_iter().map(|(place, weight)| (sum(base, place), weight));
    moved.filter(|(_, weight)| !weight.is_zero()).collect()
}

/// The part of a number behind the point.
fn fraction(x: &Rational) -> Rational {
    x - &Rational::from(x.floor())
}

/// The corners for a diagonal M: products of the places along the axes.
fn of_boxes(mask: &LatticeMask, shift: &[Rational]) -> Vec<Vec<Rational>> {
    let places = |(axis, row): (usize, &[i64])| {
        let n = row[axis];
        let scale = Rational::from(n).recip();
        let fine = (0..n.abs()).map(|k| fraction(&((&shift[axis] + &Rational::from(k)) * &scale)));
        fine.chain([fraction(&shift[axis])]).collect::<BTreeSet<Rational>>()
    };
    let mut corners = vec![Vec::new()];
    for axis in mask.dilation().rows().enumerate().map(places) {
        corners = corners
            .iter()
            .flat_map(|corner: &Vec<Rational>| {
                axis.iter().map(move |x| corner.iter().cloned().chain([x.clone()]).collect())
            })
            .collect();
    }
    corners
}

/// The corners of two divisions into triangles: where lines of different directions meet.
fn of_triangles(mask: &LatticeMask, shift: &[Rational], between: Between) -> Vec<Vec<Rational>> {
    // The sides are the lines n·x in n·τ + Z of the coarse triangles, and n·Mx in n·τ + Z of the fine ones.
    let third = if between == Between::Triangles { [1, -1] } else { [1, 1] };
    let normals = [[1, 0], [0, 1], third];
    let rows: Vec<&[i64]> = mask.dilation().rows().collect();
    let turned = |n: &[i64; 2]| [0, 1].map(|j| n[0] * rows[0][j] + n[1] * rows[1][j]);
    let place = |n: &[i64; 2]| Rational::from(n[0]) * &shift[0] + Rational::from(n[1]) * &shift[1];
    let families: Vec<([i64; 2], Rational)> = normals
        .iter()
        .map(|n| (*n, place(n)))
        .chain(normals.iter().map(|n| (turned(n), place(n))))
        .collect();
    let mut corners = BTreeSet::new();
    for (i, (a, at_a)) in families.iter().enumerate() {
        for (b, at_b) in &families[..i] {
            let determinant = a[0] * b[1] - a[1] * b[0];
            if determinant == 0 {
                continue;
            }
            // Up to translations by integers, all of them are met for so many lines of each family.
            let count = determinant.abs();
            for (k, l) in (0..count).flat_map(|k| (0..count).map(move |l| (k, l))) {
                let (p, q) = (at_a + &Rational::from(k), at_b + &Rational::from(l));
                let scale = Rational::from(determinant).recip();
                let x = (&p * &Rational::from(b[1]) - &q * &Rational::from(a[1])) * &scale;
                let y = (&q * &Rational::from(a[0]) - &p * &Rational::from(b[0])) * &scale;
                corners.insert(vec![fraction(&x), fraction(&y)]);
            }
        }
    }
    corners.into_iter().collect()
}
