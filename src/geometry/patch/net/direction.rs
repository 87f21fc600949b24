//! One direction of a net.

use super::constants::Constants;
use super::rules::Rules;
use crate::exact::Rational;
use crate::float::nearest;
use crate::limit::{Limit, Window, natural_shift};
use crate::net::NetError;
use crate::scheme::Mask;

/// What is known of one direction.
#[derive(Clone, Debug)]
pub(crate) struct Direction {
    pub(super) arity: usize,
    /// s: point i of level k belongs to the parameter (i + s)/n^k.
    pub(super) shift: Rational,
    pub(super) window: Window,
    pub(super) closed: bool,
    /// How many points level 0 has.
    pub(super) count: usize,
    pub(super) constants: Constants,
    pub(super) exact: Rules<Rational>,
    pub(super) rounded: Rules<f64>,
}

impl Direction {
    /// Direction 0 or 1, with so many points.
    pub(super) fn new(
        mask: &Mask,
        direction: usize,
        count: usize,
        closed: bool,
    ) -> Result<Direction, NetError> {
        let shift = natural_shift(mask).shift;
        let window = Window::of(mask, &shift)?;
        if window.cells(count, closed) == 0 {
            return Err(NetError::TooFew { direction, found: count, needed: window.size() });
        }
        let limit = Limit::new(mask)?;
        let constants = Constants::of(&limit, &shift)?;
        let exact = Rules::of(&limit, &shift, window, constants.order)?;
        let rounded = exact.map(nearest);
        let arity = mask.arity();
        Ok(Direction { arity, shift, window, closed, count, constants, exact, rounded })
    }

    /// How many cells level 0 has.
    pub(super) fn cells(&self) -> usize {
        self.window.cells(self.count, self.closed)
    }
}

/// The weights in one of the two arithmetics.
pub(crate) trait Weights: crate::exact::Scalar + Sync {
    fn rules(direction: &Direction) -> &Rules<Self>;
}

impl Weights for f64 {
    fn rules(direction: &Direction) -> &Rules<f64> {
        &direction.rounded
    }
}

impl Weights for Rational {
    fn rules(direction: &Direction) -> &Rules<Rational> {
        &direction.exact
    }
}
