//! The points of all levels of a net, as far as they are asked for.

use super::levels::{Place, Sides};
use super::quotients::Order;
use crate::exact::Rational;
use crate::float::upper;
use crate::lattice::{Between, Functional, weights};
use crate::mesh::Point;
use crate::net::Net;
use crate::scheme::LatticeMask;
use std::collections::HashMap;
use std::rc::Rc;

/// The indices of a point in the plane.
pub(super) type Index = [i64; 2];

/// Points and differences of a net and its levels; each is computed once.
pub(super) struct Points<'n> {
    net: &'n Net,
    mask: &'n LatticeMask,
    between: Between,
    differences: Vec<Functional<Rational>>,
    levels: Vec<Level>,
}

/// What is known of one level.
#[derive(Default)]
struct Level {
    points: HashMap<Index, Option<Rc<Point<Rational>>>>,
    /// Upper bounds of the lengths of all differences that begin at a point.
    lengths: HashMap<Index, Vec<f64>>,
}

impl<'n> Points<'n> {
    pub(super) fn new(
        net: &'n Net,
        mask: &'n LatticeMask,
        between: Between,
        order: Order,
    ) -> Points<'n> {
        let differences = order.all().iter().map(|powers| Order::functional(*powers)).collect();
        Points { net, mask, between, differences, levels: Vec::new() }
    }

    /// The point of a level; `None` where the net does not determine it.
    fn point(&mut self, level: usize, at: Index) -> Option<Rc<Point<Rational>>> {
        if self.levels.len() <= level {
            self.levels.resize_with(level + 1, Level::default);
        }
        if let Some(known) = self.levels[level].points.get(&at) {
            return known.clone();
        }
        let found = self.computed(level, at).map(Rc::new);
        self.levels[level].points.insert(at, found.clone());
        found
    }

    fn computed(&mut self, level: usize, at: Index) -> Option<Point<Rational>> {
        let Some(before) = level.checked_sub(1) else {
            return self.net.at(at[0], at[1]).cloned();
        };
        let rule = self.mask.rule([at[0], at[1], 0]).map(|(at, c)| ([at[0], at[1]], c));
        self.combined(before, rule)
    }

    /// Σ w·p over points of a level.
    fn combined<'w>(
        &mut self,
        level: usize,
        terms: impl Iterator<Item = (Index, &'w Rational)>,
    ) -> Option<Point<Rational>> {
        let mut sum = [0, 1, 2].map(|_| Rational::zero());
        for (at, weight) in terms {
            let point = self.point(level, at)?;
            for (total, x) in sum.iter_mut().zip(point.iter()) {
                *total += &(weight * x);
            }
        }
        Some(sum)
    }

    /// The net of a level at a place.
    pub(super) fn at(&mut self, level: u32, place: &Place) -> Option<Point<Rational>> {
        let weights = weights(place, self.between);
        self.combined(level as usize, weights.iter().map(|(at, weight)| ([at[0], at[1]], weight)))
    }

    /// A point near that of a level whose place is Mα: one that is new at the next level.
    pub(super) fn new_near(&self, at: Index) -> Index {
        let dilation = self.mask.dilation();
        let (image, digits) = (dilation.times([at[0], at[1], 0]), dilation.digits());
        let last = digits[digits.len() - 1];
        [image[0] + last[0], image[1] + last[1]]
    }

    /// The limit at the place of a point of a level, by the values of φ at integers.
    pub(super) fn limit(
        &mut self,
        level: u32,
        at: Index,
        values: &[(Index, Rational)],
    ) -> Option<Point<Rational>> {
        let terms =
            values.iter().map(|(back, weight)| ([at[0] - back[0], at[1] - back[1]], weight));
        self.combined(level as usize, terms)
    }

    /// Upper bounds of the lengths of the differences of each kind, with all points at the integers in the open box.
    pub(super) fn differences(&mut self, level: u32, sides: &Sides) -> Option<Vec<f64>> {
        let ranges: Vec<[i64; 2]> = sides.iter().map(integers).collect::<Option<_>>()?;
        let mut most = vec![0.0_f64; self.differences.len()];
        for i in ranges[0][0]..=ranges[0][1] {
            for j in ranges[1][0]..=ranges[1][1] {
                let last = [ranges[0][1], ranges[1][1]];
                for (most, length) in most.iter_mut().zip(self.lengths(level, [i, j], last)?) {
                    *most = most.max(length);
                }
            }
        }
        Some(most)
    }

    /// Those that begin at a point and end not beyond another one.
    fn lengths(&mut self, level: u32, at: Index, last: Index) -> Option<Vec<f64>> {
        let fits = |difference: &Functional<Rational>| {
            difference.keys().all(|to| (0..2).all(|i| at[i] + to[i] <= last[i]))
        };
        let wanted: Vec<bool> = self.differences.iter().map(fits).collect();
        let known = self.levels.get(level as usize).and_then(|level| level.lengths.get(&at));
        let mut all = known.cloned().unwrap_or_else(|| vec![f64::NAN; wanted.len()]);
        for number in 0..wanted.len() {
            if !wanted[number] || !all[number].is_nan() {
                continue;
            }
            let difference = self.differences[number].clone();
            let terms = difference.iter().map(|(to, c)| ([at[0] + to[0], at[1] + to[1]], c));
            let sum = self.combined(level as usize, terms)?;
            all[number] = length(&sum);
        }
        if let Some(known) = self.levels.get_mut(level as usize) {
            known.lengths.insert(at, all.clone());
        }
        let only = all.into_iter().zip(wanted).map(|(x, wanted)| if wanted { x } else { 0.0 });
        Some(only.collect())
    }
}

/// The first and the last integer between two numbers.
pub(super) fn integers([low, high]: &[Rational; 2]) -> Option<[i64; 2]> {
    Some([low.floor().to_i64()?.checked_add(1)?, high.ceil().to_i64()?.checked_sub(1)?])
}

/// The square of a length.
pub(super) fn square(vector: &Point<Rational>) -> Rational {
    vector.iter().map(|x| x * x).sum()
}

/// An upper bound of a length.
pub(super) fn length(vector: &Point<Rational>) -> f64 {
    root(upper(&square(vector)))
}

/// An upper bound of a root.
pub(super) fn root(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.sqrt().next_up() }
}
