//! One unit after the other, in all cores.

use super::super::number::Vector as _;
use super::super::progress::MeshWork;
use super::super::threads::{in_threads, in_threads_until, threads};
use super::cover::{Cover, FarPoint};
use super::patch::length;
use super::pieces::{Sets, Units};
use super::place::Nearness;
use super::scene::Scene;
use super::whole::Whole;
use crate::exact::Rational;
use crate::float::nearest;

/// How many points are tried at the units that are farthest by parameter.
const TRIED: usize = 400;

/// What is known of some units; where `all` is false, those after the first that is far are open.
pub(crate) fn sweep<P: Units, S: Sets>(
    scene: &Scene<P>,
    own: &[usize],
    whole: &Whole<S>,
    tolerance: f64,
    work: &MeshWork,
    all: bool,
) -> Vec<Nearness<FarPoint>> {
    let is_far = |point: &_, from| whole.is_beyond(point, from, tolerance.next_up());
    let nearness = |(): &mut (), unit: &usize| {
        if work.is_stopped() { Nearness::Open } else { Cover::unit(scene, *unit, &is_far) }
    };
    let ends = |nearness: &_| !all && matches!(nearness, Nearness::Far(_));
    let mut known = in_threads_until(&mut vec![(); threads(own.len(), 8)], own, nearness, ends);
    known.resize_with(own.len(), || Nearness::Open);
    known
}

/// The first of some points of units that is far from the other set: for a level that is far from sufficient.
pub(crate) fn first_far<P: Units, S: Sets>(
    scene: &Scene<P>,
    own: &[usize],
    whole: &Whole<S>,
) -> Option<FarPoint> {
    let tolerance = scene.pieces.tolerance() * 1.000_001;
    let step = own.len().div_ceil(TRIED).max(1);
    let tried: Vec<usize> = own.iter().copied().step_by(step).collect();
    let far = in_threads(&tried, |&unit| {
        let points = scene.unit_points(unit);
        points.into_iter().find(|(point, from)| whole.is_beyond(point, *from, tolerance))
    });
    tried.iter().zip(far).find_map(|(&unit, far)| {
        let (point, from) = far?;
        Some(FarPoint { unit, from, point, other: scene.near(unit, &point, from) })
    })
}

/// The greatest of a few lower bounds of the distance of a far point that holds, above `tolerance`, which is in the
/// scale of the sets.
pub(crate) fn far_distance<S: Sets>(whole: &Whole<S>, far: &FarPoint, tolerance: &Rational) -> f64 {
    // So far it is from all of the other set already.
    let least = nearest(tolerance).next_up();
    let greatest = length(&far.other.minus(&far.point));
    let share = |i: u32| least + (greatest - least) * f64::from(i) / 16.0;
    (0..16)
        .rev()
        .map(share)
        .find(|&distance| distance > least && whole.is_beyond(&far.point, far.from, distance))
        .unwrap_or(least)
}
