//! Reading claim files.

mod embedded;
mod names;
