//! Reading claim files.

#![allow(missing_docs)]

mod embedded;
mod names;
