//! Claim files of papers, their fields and names, and the blocks of certificates about them.

mod headers;
mod names;
mod paper;
mod said;
mod shape;
mod tasks;

pub use headers::{Axis, Headers};
pub use names::{OF_THEOREMS, misuse};
pub use paper::{Paper, printed, value};
pub use said::{Counts, said};
pub use shape::misfit;
pub use tasks::{Task, tasks};
