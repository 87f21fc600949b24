//! Whether surfaces are C¹ at an extraordinary vertex or on an extraordinary face: the characteristic map.
//!
//! | file | subject |
//! |---|---|
//! | `ball` | real numbers with proven errors |
//! | `laurent` | polynomials in t and 1/t, and their signs on an interval |
//! | `net` | control points by sectors, and the rules of the regular part |
//! | `family` | the regular parts, and eigenvectors |
//! | `bernstein` | polynomials on squares and triangles |
//! | `pieces` | the ring between two levels in Bézier form |
//! | `sign` | signs on a piece, by bisection |
//! | `ring` | the Jacobian, and the half-plane of the outer curve |
//! | `rules` | which regular part rules have |
//! | `vertex` | the verdict at one valence |
//! | `all_valences` | all valences at once |
//! | `exponent` | the Hölder exponent of the first derivatives |

mod all_valences;
mod ball;
mod bernstein;
mod exponent;
mod family;
mod laurent;
mod net;
mod pieces;
mod ring;
mod rules;
mod sign;
mod vertex;

pub use all_valences::regular_for_all_valences;
pub use ball::Ball;
pub use exponent::Exponent;
pub use family::Family;
pub use ring::RingPoint;
pub use rules::Reason;
pub use sign::{MAX_BISECTIONS, Place};
pub use vertex::{Hypothesis, Refutation, Verdict, Vertex};
