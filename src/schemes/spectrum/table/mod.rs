//! Tables of spectra and stencils by valence or number of faces, as source code.
//!
//! | file | subject |
//! |---|---|
//! | `real` | numbers as literals of a type |
//! | `rows` | the numbers of each valence |
//! | `sectors` | sectors between sharp edges, by number of faces |
//! | `arrays` | the numbers of all valences as arrays |
//! | `language` | the languages |
//! | `mask` | the coefficients of a mask |
//! | `write` | tables and test vectors as source code |
//! | `writer` | arrays as source code |

mod arrays;
mod language;
mod mask;
mod real;
mod rows;
mod sectors;
mod write;
mod writer;

pub use arrays::{Array, Entries};
pub use language::Language;
pub use mask::write_mask;
pub use real::{Real, RealType};
pub use rows::{MAX_TABLE_WEIGHTS, Row, TableError};
pub use sectors::write_sectors;
pub use write::{Origin, write, write_vectors, write_without};
