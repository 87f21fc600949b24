//! Norms of powers by extreme rows: all norms ‖R^1‖, …, ‖R^c‖ in one pass, exactly.
//!
//! A row of R^{m+1} is the image of a row of R^m by one of n matrices. The norm of what follows is a convex
//! and even function of the row. So of all rows of R^m only the extreme points of their absolutely convex
//! hull are continued. f64 finds them: a row is dropped only if it is proven that all rows that come from it
//! are shorter than the norm. The rows that may be the longest are then computed and compared exactly.
//!
//! Source: `proofs/THEOREMS.md`, 113 to 115.
//!
//! | file | subject |
//! |---|---|
//! | `simplex` | gauges of absolutely convex hulls in f64 |
//! | `step` | the operator in f64: images of rows, and how far they are rounded |
//! | `inside` | the proof that a row is inside a hull |
//! | `select` | the extreme points of a set of rows |
//! | `levels` | the rows of each level that are continued |
//! | `exact_rows` | the longest rows, in integers |
//! | `search` | the exact norms |

mod exact_rows;
mod inside;
mod levels;
mod search;
mod select;
mod simplex;
mod step;

pub(super) use search::ExtremeSearch;
