//! The greatest distance of many pieces, for meshes, solids and nets.

use super::descent::STEPS;
use crate::patch::progress::MeshWork;
use crate::patch::threads::{in_rounds, in_threads};

/// What is known of the greatest distance.
pub(super) struct Maximum<P> {
    pub(super) lower: f64,
    pub(super) upper: f64,
    /// Where the lower bound is attained; `None` where it is 0.
    pub(super) place: Option<P>,
}

/// Measures pieces, which come with upper bounds, the greatest first. `measure` gets a piece and the
/// greatest lower bound so far, which it raises, together with the place, where the piece has a
/// greater distance. It returns an upper bound for the piece, and its steps. A piece with a bound of at most `width`
/// above the lower bound, relative to that, is not measured.
pub(super) fn maximum<R: Copy + Sync, P: Send>(
    pieces: &[(f64, R)],
    width: f64,
    work: &MeshWork,
    measure: impl Fn(R, &mut f64, &mut Option<P>) -> (f64, u64) + Sync,
) -> Maximum<P> {
    let mut greatest = Maximum { lower: 0.0, upper: 0.0_f64, place: None };
    let mut left = STEPS / 4;
    in_rounds(pieces, |round| {
        // Within a round no piece knows of the others, so that threads do not matter.
        let best = greatest.lower;
        let results = in_threads(round, |&(bound, piece)| {
            work.step();
            let (mut own, mut place) = (best, None);
            if bound <= best * (1.0 + width) || left == 0 || work.is_stopped() {
                return (bound, own, None, 0);
            }
            let (upper, steps) = measure(piece, &mut own, &mut place);
            (upper, own, place, steps)
        });
        for (upper, lower, place, steps) in results {
            left = left.saturating_sub(steps);
            greatest.upper = greatest.upper.max(upper);
            if lower > greatest.lower {
                (greatest.lower, greatest.place) = (lower, place);
            }
        }
        true
    });
    greatest.upper = greatest.upper.max(greatest.lower);
    greatest
}
