//! What pages of depths of curves and surfaces show: the control polygon, bounds and distances against the level, and
//! data that are too far from their limit.

use super::bound::Bounds;
use super::compared::Compared;
use super::exact::Exactly;
use super::points::Points;
use subcert::audit::Refiner;
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::report::html::{LevelLine, Levels, Picture};
use subcert::scheme::{Mask, Scheme};

/// What is drawn of a depth, with the points at their natural parameters.
pub(super) struct Drawn<'d> {
    pub(super) tolerance: &'d Rational,
    pub(super) spread: &'d Rational,
    pub(super) bounds: &'d Bounds,
    pub(super) natural: &'d Compared,
    pub(super) points: Option<&'d Points>,
}

impl Drawn<'_> {
    pub(super) fn pictures(&self, scheme: &Scheme) -> Vec<Picture> {
        let masks: Vec<Mask> = scheme.masks().into_iter().cloned().collect();
        let exact = self.natural.exact.found();
        let polygon = self.polygon(&masks, exact);
        let data = exact.and_then(|exact| self.data(&Refiner::Masks(masks), exact));
        polygon.into_iter().chain(self.levels(exact)).chain(data).collect()
    }

    fn polygon(&self, masks: &[Mask], exact: Option<&Exactly>) -> Vec<Picture> {
        let own = self.natural.polygon.as_ref().and_then(|own| own.found());
        let (Some(points), Some(own), Some(exact), [mask]) = (self.points, own, exact, masks)
        else {
            return Vec::new();
        };
        let shift = exact.place.shifts.first();
        let far = shift.and_then(|shift| own.far(mask, points, &shift.0));
        far.map(|far| Picture::of_polygon(&far)).unwrap_or_default()
    }

    fn levels(&self, exact: Option<&Exactly>) -> Option<Picture> {
        let depth = exact.map(|exact| exact.depth.level);
        let (mut lines, promised) = self.bounds.lines(self.spread, depth.unwrap_or(0));
        if let Some(exact) = exact {
            let mut values = exact.levels.clone();
            if values.is_empty() {
                let few = exact.witness.as_ref().zip(exact.attained.as_ref());
                let few = few.map(|(few, attained)| {
                    (few.level(), nearest(&attained.value) * nearest(self.spread))
                });
                let at = (exact.depth.level, nearest(exact.distance.interval.0.upper()));
                values = few.into_iter().chain([at]).collect();
            }
            let (name, met) = ("distance".to_owned(), depth);
            lines.push(LevelLine { name, values, met, is_constant: false });
        }
        Picture::of_levels(&Levels { tolerance: self.tolerance, lines, promised })
    }

    /// The data of spread 1 that one level less leaves too far from their limit.
    fn data(&self, refiner: &Refiner, exact: &Exactly) -> Option<Picture> {
        let (witness, attained) = exact.witness.as_ref().zip(exact.attained.as_ref())?;
        let mut shift = [0.0; 2];
        shift.iter_mut().zip(&exact.place.shifts).for_each(|(to, s)| *to = nearest(&s.0));
        let most = self.tolerance / self.spread;
        Picture::of_data(refiner, attained, witness.level(), &most, shift)
    }
}
