//! What pages of depths of curves and surfaces show: the control polygon, bounds and distances against the level, and
//! data that are too far from their limit.

use super::answer::Answer;
use super::bound::Bounds;
use super::exact::Exact;
use super::polygon::Points;
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
    pub(super) answer: &'d Answer,
    pub(super) points: Option<&'d Points>,
}

impl Drawn<'_> {
    pub(super) fn pictures(&self, scheme: &Scheme) -> Vec<Picture> {
        let masks: Vec<Mask> = scheme.masks().into_iter().cloned().collect();
        let exact = self.answer.exact.as_ref().ok();
        let polygon = self.polygon(&masks, exact);
        let data = exact.and_then(|exact| self.data(&Refiner::Masks(masks), exact));
        polygon.into_iter().chain(self.levels(exact)).chain(data).collect()
    }

    fn polygon(&self, masks: &[Mask], exact: Option<&Exact>) -> Vec<Picture> {
        let own = self.answer.polygon.as_ref().and_then(|own| own.as_ref().ok());
        let (Some(points), Some(own), Some(exact), [mask]) = (self.points, own, exact, masks)
        else {
            return Vec::new();
        };
        let shift = exact.place.shifts.first();
        let far = shift.and_then(|shift| own.far(mask, points, shift));
        far.map(|far| Picture::of_polygon(&far)).unwrap_or_default()
    }

    fn levels(&self, exact: Option<&Exact>) -> Option<Picture> {
        let depth = exact.map(|exact| exact.depth.upper);
        let (mut lines, promised) = self.bounds.lines(self.spread, depth.unwrap_or(0));
        if let Some(exact) = exact {
            let mut values = exact.levels.clone();
            if values.is_empty() {
                let few = exact.too_far.as_ref();
                let few =
                    few.map(|few| (few.level, nearest(&few.attained.value) * nearest(self.spread)));
                let at = (exact.depth.upper, nearest(exact.distance.enclosure.upper()));
                values = few.into_iter().chain([at]).collect();
            }
            let (name, met) = ("distance".to_owned(), depth);
            lines.push(LevelLine { name, values, met, is_constant: false });
        }
        Picture::of_levels(&Levels { tolerance: self.tolerance, lines, promised })
    }

    /// The data of spread 1 that one level less leaves too far from their limit.
    fn data(&self, refiner: &Refiner, exact: &Exact) -> Option<Picture> {
        let far = exact.too_far.as_ref()?;
        let mut shift = [0.0; 2];
        shift.iter_mut().zip(&exact.place.shifts).for_each(|(to, s)| *to = nearest(s));
        let most = self.tolerance / self.spread;
        Picture::of_data(refiner, &far.attained, far.level, &most, shift)
    }
}
