//! Reading claim files.

mod axes;
mod embedded;
mod names;
mod smoothness;
