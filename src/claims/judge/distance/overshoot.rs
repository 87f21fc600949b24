//! Control data that are far from their limit in every shift of the parameter.

use crate::exact::Rational;
use crate::limit::{Later, Limit, Overshoot, Overshoots};
use crate::scheme::Mask;
use std::cell::{OnceCell, RefCell};

/// The control data that are tried, for one mask or for the tensor product of two: the greatest
/// value of a level differs from that of the next level, or of the limit.
#[derive(Default)]
pub struct KnownOvershoots(OnceCell<Option<RefCell<Vec<Overshoots>>>>);

impl KnownOvershoots {
    /// The data with the greatest difference of these two values. `None` where none has been found,
    /// or where there is no exact limit.
    pub fn greatest(&self, masks: &[&Mask], level: u32, later: Later) -> Option<Overshoot> {
        let new = || {
            let of = |mask: &&Mask| Overshoots::new(&Limit::new(mask).ok()?).ok();
            let all: Option<Vec<Overshoots>> = masks.iter().map(of).collect();
            all.map(RefCell::new)
        };
        let mut axes = self.0.get_or_init(new).as_ref()?.borrow_mut();
        let found = axes.iter_mut().map(|axis| axis.greatest(level, later));
        // A net a_i + b_j overshoots in a direction if a and b both do.
        let nets = found.reduce(|one, other| {
            let [above, below] = one;
            let [more_above, more_below] = other;
            [both(above, more_above), both(below, more_below)]
        });
        let most = nets.into_iter().flatten().flatten();
        most.fold(None, |best: Option<Overshoot>, next| match best {
            Some(best) if best.gap() >= next.gap() => Some(best),
            _ => Some(next).filter(|next| next.gap() > Rational::zero()),
        })
    }
}

fn both(one: Option<Overshoot>, other: Option<Overshoot>) -> Option<Overshoot> {
    Some(one?.and(other?))
}
