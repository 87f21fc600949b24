//! The values from which a cell is computed.

use crate::exact::{Rational, RealCyclotomic};
use crate::scheme::Instance;

/// The values from which the printed definition of a cell is computed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Working {
    /// The scheme, its parameters with their values; both factors of a tensor product.
    pub scheme: Vec<Instance>,
    /// The headers and the parameters that its formulas use, with their values.
    pub parameters: Vec<(String, Rational)>,
    /// The definitions that its formula uses, with their values; those that depend on the index of
    /// a sum have none, and are left out.
    pub definitions: Vec<(String, RealCyclotomic)>,
}
