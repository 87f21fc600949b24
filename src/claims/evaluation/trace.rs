//! What an evaluation used: the constants, and the numbers of levels.

use crate::bound::{Constants, Operator, Order, Rounded};
use crate::exact::RealCyclotomic;
use crate::scheme::Instance;
use std::rc::Rc;

/// A constant that a formula used.
#[derive(Clone)]
pub(crate) struct NotedConstant {
    pub(crate) instance: Instance,
    pub(crate) constants: Rc<Constants>,
    pub(crate) operator: Operator,
    pub(crate) levels: u32,
    pub(crate) order: Order,
    /// The word of the option `scheme`, if the call has one.
    pub(crate) named: Option<String>,
}

/// The constants that an evaluation used.
#[derive(Default)]
pub(crate) struct Noted {
    /// The constants of masks.
    pub(crate) constants: Vec<NotedConstant>,
    /// The norms of single sequences, but for those within sums.
    pub(crate) norms: Vec<NotedNorm<RealCyclotomic>>,
}

/// A number of levels: the logarithm of `x` to the base `ratio`, rounded.
pub(crate) struct LevelCall {
    pub(crate) ratio: RealCyclotomic,
    pub(crate) x: RealCyclotomic,
    pub(crate) rounded: Rounded,
    /// The number of levels; `None` where it is undefined.
    pub(crate) level: Option<u32>,
}

/// A norm of one sequence, and where it is attained.
pub(crate) struct NotedNorm<V> {
    /// The call whose value is the norm.
    pub(crate) formula: String,
    /// The least f whose sum Σ_l |E^c_{l,f}| is the norm.
    pub(crate) index: usize,
    pub(crate) value: V,
}
