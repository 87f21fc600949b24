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
//! | `winding` | the winding number of the outer curve |
//! | `rules` | which regular part rules have |
//! | `inner` | eigenvectors on the points with rules of their own |
//! | `interpolating` | eigenfunctions of the butterfly scheme, which are no polynomials |
//! | `lines` | lines on the ring, for pictures |
//! | `jacobian` | values of the Jacobian |
//! | `verdict` | what is said |
//! | `vertex` | the verdict at one valence |
//! | `all_valences` | all valences at once |
//! | `positive` | where polynomials in a parameter are positive |
//! | `range` | the values of a parameter for which surfaces are C¹ |
//! | `exponent` | the Hölder exponent of the first derivatives |

mod all_valences;
mod ball;
mod bernstein;
mod exponent;
mod family;
mod inner;
mod interpolating;
mod jacobian;
mod laurent;
mod lines;
mod net;
mod pieces;
mod positive;
mod range;
mod ring;
mod rules;
mod sign;
mod verdict;
mod vertex;
mod winding;

pub use all_valences::{ordered, regular_for_all_valences, smooth_for_all_valences};
pub use ball::Ball;
pub use exponent::Exponent;
pub use family::Family;
pub use lines::RingLine;
pub use pieces::{BOX_SPLINE_BEZIER, BOX_SPLINE_POINTS, CUBIC_BEZIER, QUADRATIC_BEZIER};
pub use range::{VertexRange, VertexRangeError, vertex_range};
pub use ring::{RingBox, RingPoint};
pub use rules::Reason;
pub use sign::{MAX_BISECTIONS, Place};
pub use verdict::{Hypothesis, Refutation, Verdict};
pub use vertex::{Second, Vertex};
