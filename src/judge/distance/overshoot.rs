//! Control data that are far from their limit in every shift of the parameter.

use crate::exact::Rational;
use crate::limit::{Later, Limit, Overshoot, Overshoots};
use crate::scheme::Mask;
use std::cell::{OnceCell, RefCell};

/// The data of one mask, or of the tensor product of two, whose levels and limit have different
/// greatest values.
#[derive(Default)]
pub(crate) struct KnownOvershoots(OnceCell<Option<RefCell<Vec<Overshoots>>>>);

impl KnownOvershoots {
    /// The data with the greatest difference that is found. `None` where there is none, or
    /// no exact limit.
    pub(crate) fn greatest(&self, masks: &[&Mask], level: u32, later: Later) -> Option<Overshoot> {
        let new = || {
            let of = |mask: &&Mask| Overshoots::new(&Limit::new(mask).ok()?).ok();
            let all: Option<Vec<Overshoots>> = masks.iter().map(of).collect();
            all.map(RefCell::new)
        };
        let mut axes = self.0.get_or_init(new).as_ref()?.borrow_mut();
        let found = axes.iter_mut().map(|axis| axis.greatest(level, later));
        // A net a_i + b_j is above what is later if a and b are.
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
