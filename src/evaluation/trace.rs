//! What an evaluation rests on: the constants and the numbers of levels that formulas ask for.

use crate::bound::{Constants, Operator, Order, Rounded};
use crate::exact::RealCyclotomic;
use crate::scheme::Instance;
use std::rc::Rc;

/// A constant that was asked for.
#[derive(Clone)]
pub(crate) struct NotedConstant {
    pub(crate) instance: Instance,
    pub(crate) constants: Rc<Constants>,
    pub(crate) operator: Operator,
    pub(crate) levels: u32,
    pub(crate) order: Order,
    /// The option that names its scheme.
    pub(crate) named: Option<String>,
}

/// The constants that an evaluation rests on.
#[derive(Default)]
pub(crate) struct Noted {
    /// Those of masks.
    pub(crate) constants: Vec<NotedConstant>,
    /// The norms of single sequences that are outside of all sums.
    pub(crate) norms: Vec<NotedNorm<RealCyclotomic>>,
}

/// A number of levels: the logarithm of `x` to the base `ratio`, rounded.
pub(crate) struct LevelCall {
    pub(crate) ratio: RealCyclotomic,
    pub(crate) x: RealCyclotomic,
    pub(crate) rounded: Rounded,
    /// How many; `None` where there is no such number.
    pub(crate) level: Option<u32>,
}

/// A norm of one sequence, and where it is attained.
pub(crate) struct NotedNorm<V> {
    /// The call that gives it.
    pub(crate) formula: String,
    /// The least f with the greatest sum.
    pub(crate) index: usize,
    pub(crate) value: V,
}
