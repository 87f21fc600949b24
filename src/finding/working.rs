//! The values that a cell is computed from.

use crate::exact::{Rational, RealCyclotomic};
use crate::scheme::Instance;

/// What the value of a cell of the printed definition is computed from.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Working {
    /// The scheme, its parameters with their values; both factors of a tensor product.
    pub scheme: Vec<Instance>,
    /// The headers and the parameters that its formulas use, with their values.
    pub parameters: Vec<(String, Rational)>,
    /// The definitions that its formula uses and that have a value by themselves; those of
    /// an index have none.
    pub definitions: Vec<(String, RealCyclotomic)>,
}
