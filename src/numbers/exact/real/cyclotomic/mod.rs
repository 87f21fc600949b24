//! Real numbers of Q(2cos(2π/n)).
//!
//! | file | subject |
//! |---|---|
//! | `symmetric` | sums of x^k + x^(−k); the polynomials Φ_n and Ψ_n |
//! | `fixed` | enclosures of cosines |
//! | `error` | the errors of cosines |
//! | `field` | the fields, each built once; products and reduction |
//! | `number` | the number type: constructors and accessors |
//! | `arithmetic` | the operators of the number type |
//! | `order` | sign, order, enclosures |
//! | `row_product` | rows times matrices |
//! | `sparse` | numbers as sums of few cosines |
//! | `norm` | inverses, by norms modulo primes |
//! | `minimal` | the minimal polynomial of a number |
//! | `size` | bounds of conjugates, and the content |
//! | `square_root` | square roots of rational numbers |

mod arithmetic;
mod error;
mod field;
mod fixed;
mod minimal;
mod norm;
mod number;
mod order;
mod row_product;
mod size;
mod sparse;
mod square_root;
mod symmetric;

pub use error::{CosineError, MAX_CONDUCTOR, common_conductor};
pub use fixed::{cosines, pi};
pub use norm::{is_prime, primes};
pub use number::{RealCyclotomic, StoredForm};
pub use symmetric::cosine_polynomial;
