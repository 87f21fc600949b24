//! Real numbers given by expressions over the fields Q(2cos 2π/n), with square roots and roots of
//! polynomials.
//!
//! | file | subject |
//! |---|---|
//! | `size` | bounds of conjugates, which separate a number from 0 |
//! | `isolated` | a real root of a polynomial with cyclotomic coefficients |
//! | `error` | the errors of roots |
//! | `node` | the number type, and the field that a number is known to be in |
//! | `arithmetic` | the four operations |
//! | `roots` | square roots, and roots of polynomials |
//! | `enclose` | enclosures |
//! | `order` | sign, equality, order, and whether a number is rational |
//! | `bounded` | signs with a bounded number of digits |
//! | `display` | numbers as formulas |
//! | `algebra` | numbers as elements of an algebra over one cyclotomic field |
//! | `minimal` | minimal polynomials |

mod algebra;
mod arithmetic;
mod bounded;
mod display;
mod enclose;
mod error;
mod isolated;
mod minimal;
mod node;
mod order;
mod roots;
mod rounded;
mod size;

pub use error::{MAX_ROOT_DEGREE, RootError};
pub use node::RealExpression;
